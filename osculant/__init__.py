"""Curves approximated with the fewest pieces, provably, from their formula.

The fewest among splines with knots at the split points whose pieces are tangent to the curve at both ends and
each lie over a strictly convex arc, where `Spline.minimal` says so.

>>> import osculant as osc
>>> osc.__version__
'0.1.0'

The front door is lazy: a name's module is imported when the name is first used, so that importing one room
(``osculant.cas``, ``osculant.codegen``, ``osculant.kernels``) costs nothing of the others.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from osculant.version import __version__ as __version__

if TYPE_CHECKING:
    from osculant.api import approximate, complexity, curve
    from osculant.approximation.prediction import Complexity
    from osculant.cas.errors import DomainError, FormulaError, OsculantError, ToleranceError, UndecidedError
    from osculant.certificates.check_text import RejectedError
    from osculant.certificates.checker import check
    from osculant.compiled.approximator import compile_approximator, compile_evaluator
    from osculant.curves.plane import PlaneCurve
    from osculant.curves.space import SpaceCurve
    from osculant.germs.classification import Classification, classify
    from osculant.germs.families import GermFamily, germ_family
    from osculant.germs.hypersurface import preserving
    from osculant.germs.map_germ import MapGerm, germ
    from osculant.germs.map_jets import JetOfMap, map_jet
    from osculant.germs.multi import MultiMapGerm, multigerm
    from osculant.germs.recognise import recognise
    from osculant.germs.recognition import Recognised
    from osculant.germs.secants import Secant, SecantApart, secant, secant_apart
    from osculant.pieces.conics import Piece
    from osculant.spline import Spline
    from osculant.thesis.verification import Verification, verify

__all__ = [
    "Classification",
    "Complexity",
    "DomainError",
    "FormulaError",
    "GermFamily",
    "JetOfMap",
    "MapGerm",
    "MultiMapGerm",
    "OsculantError",
    "Piece",
    "PlaneCurve",
    "Recognised",
    "RejectedError",
    "Secant",
    "SecantApart",
    "SpaceCurve",
    "Spline",
    "ToleranceError",
    "UndecidedError",
    "Verification",
    "approximate",
    "check",
    "classify",
    "compile_approximator",
    "compile_evaluator",
    "complexity",
    "curve",
    "germ",
    "germ_family",
    "map_jet",
    "multigerm",
    "preserving",
    "recognise",
    "secant",
    "secant_apart",
    "verify",
]

# No module here may bear the name of one of these: importing it would put the module in the name's place.
_HOME = {
    "curve": "osculant.api",
    "approximate": "osculant.api",
    "complexity": "osculant.api",
    "compile_approximator": "osculant.compiled.approximator",
    "compile_evaluator": "osculant.compiled.approximator",
    "PlaneCurve": "osculant.curves.plane",
    "SpaceCurve": "osculant.curves.space",
    "Complexity": "osculant.approximation.prediction",
    "Spline": "osculant.spline",
    "Piece": "osculant.pieces.conics",
    "verify": "osculant.thesis.verification",
    "germ": "osculant.germs.map_germ",
    "classify": "osculant.germs.classification",
    "Classification": "osculant.germs.classification",
    "check": "osculant.certificates.checker",
    "RejectedError": "osculant.certificates.check_algebra",
    "MapGerm": "osculant.germs.map_germ",
    "GermFamily": "osculant.germs.families",
    "germ_family": "osculant.germs.families",
    "preserving": "osculant.germs.hypersurface",
    "MultiMapGerm": "osculant.germs.multi",
    "multigerm": "osculant.germs.multi",
    "map_jet": "osculant.germs.map_jets",
    "recognise": "osculant.germs.recognise",
    "Recognised": "osculant.germs.recognition",
    "JetOfMap": "osculant.germs.map_jets",
    "secant": "osculant.germs.secants",
    "Secant": "osculant.germs.secants",
    "secant_apart": "osculant.germs.secants",
    "SecantApart": "osculant.germs.secants",
    "Verification": "osculant.thesis.verification",
    "OsculantError": "osculant.cas.errors",
    "FormulaError": "osculant.cas.errors",
    "DomainError": "osculant.cas.errors",
    "ToleranceError": "osculant.cas.errors",
    "UndecidedError": "osculant.cas.errors",
}


def __getattr__(name: str) -> object:
    if name not in _HOME:
        raise AttributeError(f"module 'osculant' has no attribute {name!r}")
    value = getattr(import_module(_HOME[name]), name)
    globals()[name] = value  # the next look-up finds it without this function
    return value


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])
