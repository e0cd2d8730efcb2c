"""Offsets of a curve in its affine frame, expanded where they touch it."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.asymptotics.offset_curves import OffsetCurve, both_ends, bracket
from osculant.cas.claims.claim import Evidence
from osculant.cas.claims.proof import all_of, vanishes
from osculant.cas.numbers.power_series import PowerSeries

#: tangent at both ends; crossing between them as well; all places of the first one at 0
TANGENT, CROSSING, AT_ZERO = both_ends(), both_ends(("sigma",)), OffsetCurve(("0",) * 4)
#: the vectors β_u, β_uu, β_uuu are written in t and n
BASIS = ({"t": 1, "n": 0}, {"t": 0, "n": 1})


def curvature_of_alpha(curve: OffsetCurve, place: Any) -> Any:
    """k at a place, to all orders that are known."""
    s = curve.symbols
    return sum(s[f"k{i}"] * place**i / sp.factorial(i) for i in range(curve.length))


def to_order(curve: OffsetCurve, series: PowerSeries, stated: Any, order: int, what: str) -> Evidence:
    """Whether a series is the expression stated up to O(ρ^order) for all places of size O(ρ)."""
    return all_of(
        vanishes(curve.order(stated, n) - curve.expression(series[n]), f"{what}, order {n}")
        for n in range(order)
    )


def in_class(curve: OffsetCurve, series: PowerSeries, stated: Any, i: int, what: str) -> Evidence:
    """Whether series − stated is in Oᵢ = O(u⁶⁻ⁱ) + O((ρ + σ)u⁵⁻ⁱ) + O(ρ² + σ²), by its monomials.

    Terms of weight 6 − i and more all are; below, the series must be known.
    """
    places = [curve.symbols[p] for p in curve.places]
    outside = []
    for n in range(6 - i):
        rest = sp.Poly(sp.expand(curve.expression(series[n]) - curve.order(stated, n)), *places)
        for (u, *others), coefficient in rest.terms():
            if coefficient != 0 and sum(others) < 2 and u < 6 - i - sum(others):
                outside.append(coefficient * sp.prod(p**e for p, e in zip(places, (u, *others), strict=True)))
    line = f"{what}: what is left of weight below {6 - i} is " + (
        f"not in O{i}: {sp.Add(*outside)}" if outside else f"in O{i}"
    )
    return Evidence(not outside, (line,))


def along_frame(
    curve: OffsetCurve, vector: tuple[PowerSeries, PowerSeries]
) -> tuple[PowerSeries, PowerSeries]:
    """The coordinates of a vector along t(u) and n(u), which have determinant 1."""
    t, n = curve.frame
    return bracket(vector, n), bracket(t, vector)


def contact_derivatives(d: Any, u: Any) -> dict[str, Any]:
    """f, f1, …, f4: a polynomial and its derivatives by u."""
    return {"f": d} | {f"f{i}": sp.diff(d, u, i) for i in range(1, 5)}
