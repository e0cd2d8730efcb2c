"""The best cubic of a short arc that is tangent at both ends, both arms being free.

The curve is y = Y₂x² + Y₃x³ + … over its tangent, a short arc around that point is replaced by a cubic. In
the limit the cubic x = t + at² + bt³, y = ct² + dt³ has six-fold contact: orders t² … t⁵ determine c, d, b
and leave

    (C)  2Y₂²a³ + 3Y₂Y₃a² + (9Y₃² − 6Y₂Y₄)a + 3Y₃Y₄ − 2Y₂Y₅ = 0,

with one or three real a, and t⁶ leaves the residual

    (D)  D = Y₂b² + Y₃(a³ + 6ab) + Y₄(6a² + 4b) + 5aY₅ + Y₆.

Nothing is divided by the curvature: (C) and (D) hold at inflections, too. The two arms move the sum and the
product of the two inner contacts; (C) puts their sum in the middle, so that over an arc of length σ

    d = −D x²(σ − x)²((x − σ/2)² − cσ²),

with c free. Its peak is least where all three peaks are equal, and the area between where sign d is
orthogonal to x²(σ − x)²: c is an algebraic number in both cases, and so are the constants of the laws, c/16
for distances.
The end of `hermite_cubics` is D, too: D = Eκ^{7/3}, with three contacts at each end.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp

from osculant.cas.numbers.algebraic import Algebraic, algebraic
from osculant.cas.numbers.power_series import PowerSeries

#: Taylor coefficients of the curve over its tangent, and the free coefficients of the cubic's x
Y = Y2, Y3, Y4, Y5, Y6 = sp.symbols("Y2:7", real=True)
a, b = sp.symbols("a b", real=True)
#: c, or its square root, and the place over the arc, the arc's middle being 0 and its length 1
SPREAD, ROOT, PLACE = sp.symbols("c z y", real=True)


@dataclass(frozen=True)
class Contact:
    """Six-fold contact of x = t + at² + bt³, y = ct² + dt³ with the curve.

    Attributes:
        fourth, fifth: what orders t⁴ and t⁵ demand to be 0, both linear in b.
        condition: (C), which follows from them; the coefficient of a³ is 2Y₂².
        residual: (D), of order t⁶.
    """

    fourth: Any
    fifth: Any
    condition: Any
    residual: Any

    def third(self) -> tuple[Any, Any]:
        """b from order t⁴, and from order t⁵: equal where (C) holds; either may have the divisor 0."""
        (first,), (second,) = (sp.solve(order, b) for order in (self.fourth, self.fifth))
        return first, second


@cache
def contact() -> Contact:
    """The contact, order by order.

    >>> contact().condition.coeff(a, 3), sp.factor(contact().condition.subs(Y2, 0))
    (2*Y2**2, 3*Y3*(3*Y3*a + Y4))
    """
    zero = sp.Integer(0)
    along = PowerSeries([zero, sp.Integer(1), a, b, zero, zero, zero])
    graph = PowerSeries([zero, zero, *Y])
    rest = [sp.expand(c) for c in graph.at(along).coefficients]
    fourth, fifth, residual = rest[4:]
    # both are linear in b
    lead = [sp.Poly(order, b).all_coeffs() for order in (fourth, fifth)]
    condition = sp.expand(lead[0][0] * lead[1][1] - lead[1][0] * lead[0][1])
    unit = sp.Poly(condition, a).coeff_monomial(a**3) / (2 * Y2**2)
    return Contact(fourth, fifth, sp.expand(condition / unit), residual)


@cache
def profile() -> Any:
    """−d/(Dσ⁶) over a short arc of length σ, in the place y = x/σ − 1/2 and the spread c.

    >>> profile()
    (1/4 - y**2)**2*(-c + y**2)
    """
    return (sp.Rational(1, 4) - PLACE**2) ** 2 * (PLACE**2 - SPREAD)


@cache
def outer_place() -> Any:
    """y² of the two outer peaks.

    >>> outer_place()
    2*c/3 + 1/12
    """
    square = sp.Symbol("s")
    height = profile().subs(PLACE**2, square)
    places = sp.solve(sp.diff(height, square), square)
    return sp.expand(next(place for place in places if place.has(SPREAD)))


@cache
def equal_peaks() -> Algebraic:
    """c for which the peak in the middle and those beside it are equal, of opposite sign.

    >>> print(equal_peaks())
    0.026473135756254
    """
    middle, outer = profile().subs(PLACE, 0), profile().subs(PLACE**2, outer_place())
    return algebraic(middle + outer, SPREAD, (0, sp.Rational(1, 4)))


@cache
def least_area() -> Algebraic:
    """√c for which sign d is orthogonal to the change of d with c: the contacts are canonical points.

    >>> print(least_area())
    0.14056383521035
    """
    weight = sp.integrate(sp.diff(-profile(), SPREAD), PLACE)
    inside, half = (weight.subs(PLACE, end) - weight.subs(PLACE, 0) for end in (ROOT, sp.Rational(1, 2)))
    return algebraic(sp.expand(half - 2 * inside), ROOT, (0, sp.Rational(1, 2)))


@cache
def distance_constant() -> Algebraic:
    """The largest |d|/(|D|σ⁶), c/16.

    >>> print(sp.N(1 / distance_constant().number()))
    604.386278501968
    """
    return equal_peaks().image(abs(profile().subs(PLACE, 0)).subs(sp.Abs(SPREAD), SPREAD), SPREAD)


@cache
def area_constant() -> Algebraic:
    """The least area over |D|σ⁷.

    >>> print(sp.N(1 / area_constant().number()))
    1020.02751844106
    """
    whole = sp.integrate(sp.expand(profile().subs(SPREAD, ROOT**2)), PLACE)
    inside, half = (whole.subs(PLACE, end) - whole.subs(PLACE, 0) for end in (ROOT, sp.Rational(1, 2)))
    return least_area().image(sp.expand(2 * (half - 2 * inside)), ROOT)


@cache
def lobes() -> dict[str, Any]:
    """Places of peaks and contacts over a short arc, 0…1, and sharpnesses −d″/d, as exact numbers.

    >>> [round(float(value), 7) for value in lobes().values()]
    [0.1822232, 0.8177768, 91.5482848, 109.1386722, 0.3594362]
    """
    c, half = equal_peaks().number(), sp.Rational(1, 2)
    reach = sp.sqrt(outer_place().subs(SPREAD, c))
    sharpness = -sp.diff(profile(), PLACE, 2) / profile()
    return {
        "first": half - reach,
        "last": half + reach,
        "middle_sharpness": sharpness.subs(PLACE, 0).subs(SPREAD, c),
        "outer_sharpness": sharpness.subs(PLACE, reach).subs(SPREAD, c),
        "crossing": half - least_area().number(),
    }


def tangent_graph(x: Sequence[Any], y: Sequence[Any], root: Any) -> list[Any]:
    """Y₂ … of the curve over its tangent, from Taylor coefficients 0, 1, … of its coordinates.

    Args:
        x: coefficients of any numbers that divide, not multiplied by factorials.
        y: as many of the other coordinate.
        root: the square root of such numbers.

    >>> import math
    >>> tangent_graph([0.0, 2.0, 0.0], [0.0, 0.0, 4.0], math.sqrt)  # (2t, 4t²)
    [1.0]
    """
    speed = root(x[1] * x[1] + y[1] * y[1])
    tx, ty = x[1] / speed, y[1] / speed
    along = [0 * speed, *(tx * p + ty * q for p, q in zip(x[1:], y[1:]))]
    across = [0 * speed, *(tx * q - ty * p for p, q in zip(x[1:], y[1:]))]
    series, power = PowerSeries(along), PowerSeries(along)
    found: list[Any] = []
    left, unit = list(across), speed
    for n in range(2, len(across)):
        power, unit = power * series, unit * speed
        found.append(left[n] / unit)
        left = [value - found[-1] * c for value, c in zip(left, power.coefficients)]
    return found
