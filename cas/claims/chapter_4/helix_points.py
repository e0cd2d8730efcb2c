"""A circular helix by arc length, in components along its frame at the start."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_2.helix_frames import BETA, KAPPAB, N0, T0, TAUB, V0, W0, s
from osculant.cas.claims.claim import Evidence
from osculant.cas.claims.vectors import same
from osculant.cas.numbers.vectors import Vector3, add, cross, scale

SCALARS = {"kappab": KAPPAB, "taub": TAUB, "beta": BETA, "s": s}
VECTORS = {"N0": N0, "W0": W0, "V0": V0, "T0": T0, "T0xV0": cross(T0, V0)}
TANGENT = add(scale(TAUB, V0), scale(KAPPAB * sp.cos(BETA * s), W0), scale(KAPPAB * sp.sin(BETA * s), N0))
HELIX: Vector3 = tuple(sp.integrate(a, (s, 0, s)) for a in TANGENT)


def _rational(expression: Any) -> Any:
    half = sp.Symbol("h", real=True)
    circle = {sp.cos(BETA * s): (1 - half**2) / (1 + half**2), sp.sin(BETA * s): 2 * half / (1 + half**2)}
    return sp.sympify(expression).subs(circle)


def agree(vector: Sequence[Any], expected: Sequence[Any], what: str) -> Evidence:
    """Proof that two vectors depending on βs agree."""
    a, b = (tuple(map(_rational, v)) for v in (vector, expected))
    return same([a], [b], what)
