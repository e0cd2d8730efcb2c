"""The jet of a formula in pairs of doubles, with the forms that split the curve."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from osculant.cas.jets.plane import PlaneJet
from osculant.cas.jets.space import SpaceJet
from osculant.cas.zeros.programs import WrittenSeries, form_program
from osculant.codegen.c.pairs import pair_function
from osculant.codegen.c.program import Translation
from osculant.compiled.subject import Subject
from osculant.curves.special import FORMS


def precise_jet(translation: Translation, subject: Subject, names: Sequence[str]) -> str:
    """The C function ``precise_jet`` as `osculant.kernels.standalone.precise` takes it.

    Args:
        translation: that the arithmetic of pairs joins.
        subject: with a formula.
        names: of the forms, two at most.
    """
    from osculant.kernels.standalone import pair_functions as functions
    from osculant.kernels.standalone import pairs
    from osculant.kernels.standalone.precise import DERIVATIVES

    assert subject.coordinates is not None
    forms = [FORMS[subject.dimension][name] for name in names]
    order = max([DERIVATIVES - 1, *(order for _, order in forms)])

    def wanted(jet: Any) -> list[WrittenSeries]:
        derivatives = [row[k] for row in jet.coordinates for k in range(DERIVATIVES)]
        first = [WrittenSeries(each.writer, each.coefficients[:1]) for each in derivatives]
        return [*first, *(getattr(jet, attribute) for attribute, _ in forms)]

    jet_type: Any = PlaneJet if subject.dimension == 2 else SpaceJet
    program = form_program(subject.coordinates, jet_type, wanted, order, 2, parameters=subject.parameters)
    table: dict[str, Any] = {
        "add": pairs.add, "sub": pairs.subtract, "mul": pairs.multiply, "div": pairs.divide,
        "neg": pairs.negative, "sqrt": pairs.root, "power": functions.power, "sign": functions.sign,
        "sin": functions.sine, "cos": functions.cosine, "tan": functions.tangent,
        "asin": functions.inverse_sine, "acos": functions.inverse_cosine, "atan": functions.inverse_tangent,
        "sinh": functions.hyperbolic_sine, "cosh": functions.hyperbolic_cosine,
        "tanh": functions.hyperbolic_tangent, "asinh": functions.inverse_hyperbolic_sine,
        "acosh": functions.inverse_hyperbolic_cosine, "atanh": functions.inverse_hyperbolic_tangent,
        "exp": functions.exponential, "log": functions.logarithm, "cbrt": functions.cube_root,
    }  # fmt: skip
    return pair_function(translation, "precise_jet", program, subject.parameters, pairs.Pair, table)
