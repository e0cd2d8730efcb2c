"""The error of one short arc as a power series in its length, derived from the contact conditions.

An arc of Euclidean length h about the point where the curvature is κ with derivatives κ₁, κ₂, … by arc length
is replaced by its bitangent parabola, or by the bitangent conic that minimises the Hausdorff distance. Then

    E = hᵖ(e₀ + e₂h² + O(h⁴)),   p = 4 for a parabola, p = 5 for a conic,

with only even powers beside hᵖ, since the arc is the same for −h. The displacement d along the normal comes
from `osculant.cas.asymptotics.arc_displacement` as a series in h with polynomials in x ∈ [−1, 1] as
coefficients. Here its extreme values are followed, near x = 0 for a parabola and near x = ±1/√5 for a conic,
where κ = 1; weights restore κ.

The first terms are those of Theorem 3.6.1; e₂ gives the next term of the number of pieces (section 3.8).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp

from osculant.cas.asymptotics.arc_displacement import KAPPA, displacement, peak_spread
from osculant.cas.errors import DomainError
from osculant.cas.numbers.power_series import PowerSeries, solve


@dataclass(frozen=True)
class ArcError:
    """E = hᵖ(e₀ + e₂h²) + O(hᵖ⁺⁴), up to the sign: e₀ has that of k (parabola) or dk/dr (conic).

    ``leading`` is e₀/√root, a polynomial over a power of κ, ``following`` is e₂/√root, a rational function;
    both in `KAPPA`, for κ > 0. ``root`` is 1 for parabolas and 5 for conics.
    """

    order: int
    root: int
    leading: Any
    following: Any

    def at(self, kappa: Sequence[Any], square_root: Callable[[int], Any]) -> tuple[Any, Any]:
        """(e₀, e₂), e₀ > 0, at numbers κ, κ₁, … of any kind that divides; ``square_root`` acts on integers.

        Raises DomainError if fewer derivatives are given than κ₄ (parabola) or κ₅ (conic).

        >>> from mpmath import mpf, sqrt
        >>> circle = [mpf(1)] + [mpf(0)] * 4
        >>> arc_error("parabola").at(circle, sqrt)  # k = 1: 1/128
        (mpf('0.0078125'), mpf('0.00065104166666666663'))
        """
        needed = self.order + 1
        if len(kappa) < needed:
            raise DomainError(
                f"The error series needs the curvature and {needed - 1} derivatives, but {len(kappa)} "
                "values are given."
            )
        values = tuple(kappa[:needed]) if kappa[0] > 0 else tuple(-k for k in kappa[:needed])
        leading, following = (f(values) for f in _compiled(self.order, self.leading, self.following))
        sign = square_root(self.root) if leading > 0 else -square_root(self.root)
        return sign * leading, sign * following


def rational_function(expression: Any, count: int) -> Callable[[Sequence[Any]], Any]:
    """A rational function of the first ``count`` of `KAPPA` as a function of numbers of any kind.

    Only sums and products are formed, and one division: balls around 0 have no other powers.

    >>> rational_function(KAPPA[1] ** 2 / 3 + 1 / KAPPA[0], 2)((2, 3))
    3.5
    """
    numerator, denominator = (
        [(powers, int(c)) for powers, c in sp.Poly(part, *KAPPA[:count]).terms()]
        for part in sp.fraction(sp.together(expression))
    )
    degree = max(exponent for powers, _ in numerator + denominator for exponent in powers)

    def value(kappa: Sequence[Any]) -> Any:
        table: list[list[Any]] = [[1] for _ in range(count)]
        for row, k in zip(table, kappa, strict=False):
            for _ in range(degree):
                row.append(row[-1] * k)

        def total(terms: list[tuple[Any, int]]) -> Any:
            found = 0
            for powers, c in terms:
                term = c
                for row, exponent in zip(table, powers, strict=True):
                    if exponent:
                        term = term * row[exponent]
                found = found + term
            return found

        return total(numerator) / total(denominator)

    return value


@cache
def _compiled(order: int, *expressions: Any) -> tuple[Callable[..., Any], ...]:
    return tuple(rational_function(e, order + 1) for e in expressions)


@cache
def arc_error(primitive: str) -> ArcError:
    """The error series of "parabola" or "conic" arcs; raises DomainError for another name.

    >>> arc_error("parabola").leading
    (9*kappa0**4 + 3*kappa0*kappa2 - 5*kappa1**2)/(1152*kappa0)
    >>> arc_error("conic").root
    5
    """
    order, spread, height = height_series(primitive)
    root, half = (spread, (order + 1) // 2) if order % 2 else (1, order // 2)
    leading = _weighted(-height[0] / spread**half, order - 1)
    following = _weighted(-height[2] / spread ** (half + 1), order + 1)
    return ArcError(order, root, leading, following)


@cache
def height_series(primitive: str) -> tuple[int, int, PowerSeries]:
    """(p, σ, series in H): the signed height is d = Hᵖ·series with h = H√σ; a conic peaks at x² = 1/σ.

    The coefficients are elements of sympy's field ℚ(κ₁, …), for κ = 1. That of H¹ comes out as 0.

    >>> height_series("conic")[2][1]
    0
    """
    parts = displacement(primitive)
    order = next(n for n, part in enumerate(parts) if any(part))
    spread = 1 if primitive == "parabola" else peak_spread()
    # x = z/√spread and h = H·√spread: d has x only to powers of the parity of h's, so no root remains
    scaled = [
        [c * spread ** ((n - m) // 2) for m, c in enumerate(part)]
        for n, part in enumerate(parts[order : order + 3], order)
    ]
    if primitive == "parabola":
        return order, spread, peak_height(scaled, 0)
    return order, spread, (peak_height(scaled, 1) - peak_height(scaled, -1)) / 2


def peak_height(parts: Sequence[Sequence[Any]], near: int) -> PowerSeries:
    """The extreme value of f₀(z) + f₁(z)H + f₂(z)H² + … whose place tends to z = near, as a series in H.

    Args:
        parts: for each power of H the coefficients of a polynomial in z, over a field; f₀′(near) = 0.
        near: the limit of the place for H → 0.

    >>> peak_height([[1, 0, -1], [0, 1], [0, 0]], 0)  # 1 − z² + zH peaks at z = H/2
    PowerSeries([1, 0, 1/4])
    """

    def value(series: PowerSeries, derivative: int) -> PowerSeries:
        total = series * 0
        for n, part in enumerate(parts):
            coefficients = list(part)
            for _ in range(derivative):
                coefficients = [m * c for m, c in enumerate(coefficients)][1:]
            inner = series * 0
            for c in reversed(coefficients):
                inner = inner * series + c
            total = total + inner.shifted(n).cut(len(parts))
        return total

    start = PowerSeries([parts[0][0] * 0] * len(parts)) + near
    curvature = value(start, 2)[0]
    return value(start + solve(lambda moved: value(start + moved, 1), curvature, len(parts)), 0)


def _weighted(value: Any, weight: int) -> Any:
    """Back from κ = 1 to any κ > 0: κⱼ has the weight of length^{−1−j}, and the value the weight given."""
    kappa = KAPPA[0]
    moved = {k: k / kappa ** (j + 2) for j, k in enumerate(KAPPA[1:])}
    return sp.factor(value.as_expr().subs(moved, simultaneous=True) * kappa**weight)
