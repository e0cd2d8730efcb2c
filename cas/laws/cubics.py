"""The laws of cubics that are tangent at both ends, with both arms free: the least |D| of one or three.

`osculant.cas.asymptotics.free_cubics` derives the contact conditions (C) and (D) and both constants. Every
real root of (C) belongs to a cubic of least error among its neighbours; the best of them has the least |D|.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache, partial
from typing import TYPE_CHECKING, Any

from osculant.cas.asymptotics.contacts import CONTACTS
from osculant.cas.errors import UndecidedError
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.laws.law import Law

if TYPE_CHECKING:
    from osculant.cas.numbers.algebraic import Algebraic

#: the jet that (D) takes
ORDER = CONTACTS
#: Newton steps from isolated roots, which have some 30 bits; each doubles them
STEPS = 5


def residuals(jet: PlaneJet) -> list[Any]:
    """D for every real root of (C), in the order of the roots, at a jet of balls; their midpoints count.

    >>> from flint import arb
    >>> rows = (2, 0, -2, 0, 2, 0, -2), (0, 2, 0, -2, 0, 2, 0)
    >>> circle = PlaneJet(*([arb(c) for c in row] for row in rows))
    >>> [round(float(value) * 128 * 2**5, 6) for value in residuals(circle)]
    [64.0, 1.0, 64.0]
    """
    from osculant.cas.asymptotics.free_cubics import tangent_graph

    jet.point(ORDER)  # refuses shorter ones
    factorials = [math.factorial(n) for n in range(ORDER + 1)]
    x, y = ([c / f for c, f in zip(row, factorials)] for row in jet.coordinates)
    heights = [c.mid() for c in tangent_graph(x, y, lambda value: jet.root(value, 2))]
    unit = _unit(heights)
    heights = [height / unit ** (n + 1) for n, height in enumerate(heights)]
    condition, thirds, residual = _compiled()
    found = []
    for root in _real_roots(condition(*heights)):
        (above, below), (other_above, other_below) = thirds(root, *heights)
        if abs(other_below).mid() > abs(below).mid():
            above, below = other_above, other_below
        found.append(residual(root, above / below, *heights) * unit ** (ORDER - 1))
    return found


def _unit(heights: list[Any]) -> Any:
    """A power of 2 in which the largest coefficient is about 1, as one of length^{1−n}."""
    from flint import arb

    sizes = [abs(height).log() / (n + 1) for n, height in enumerate(heights) if height != 0]
    largest = max((float(size) for size in sizes), default=0.0)
    return arb(2) ** round(largest / math.log(2))


def _real_roots(coefficients: list[Any]) -> list[Any]:
    """The real roots of a polynomial, the highest coefficient first, in increasing order."""
    from flint import acb, acb_poly, arb_poly

    poly = acb_poly([acb(c) for c in reversed(coefficients)])
    while poly.degree() >= 0 and poly[poly.degree()].contains(0):
        poly = acb_poly(poly.coeffs()[:-1])
    if poly.degree() < 1:
        return []
    try:
        found = [root.real.mid() for root in poly.roots() if root.imag.contains(0)]
    except ValueError:  # two are too close for flint to tell apart
        found = _by_angle([c.real for c in poly.coeffs()])
    real = arb_poly([c.real for c in poly.coeffs()])
    slope = real.derivative()
    for _ in range(STEPS):
        found = [x - (real(x) / slope(x)).mid() for x in found]
        found = [x.mid() for x in found if x.is_finite()]
    return sorted(found, key=float)


def _by_angle(coefficients: list[Any]) -> list[Any]:
    """The real roots of a cubic, from the coefficient of a⁰ on, by Viète's and Cardano's formulas."""
    from flint import arb

    if len(coefficients) != 4:
        raise UndecidedError("Two cubics with six contacts coincide here: take another place.")
    c0, c1, c2 = (c / coefficients[3] for c in coefficients[:3])
    p, q = c1 - c2 * c2 / 3, 2 * c2**3 / 27 - c1 * c2 / 3 + c0
    under = (q * q / 4 + p**3 / 27).mid()
    if under > 0:
        root = under.sqrt()
        larger = -q / 2 - root if q > 0 else -q / 2 + root
        part = abs(larger).root(3) * (-1 if larger < 0 else 1)
        found = [part - p / (3 * part)]
    else:
        size = (-p / 3).mid().max(arb(0)).sqrt()
        cosine = (-q / (2 * size**3)).mid().max(arb(-1)).min(arb(1)) if size > 0 else arb(0)
        third = 2 * arb.pi() / 3
        found = [2 * size * (cosine.acos() / 3 - third * k).cos() for k in range(3)]
    return [(x - c2 / 3).mid() for x in found]


@cache
def _compiled() -> Any:
    """Functions of numbers: coefficients of (C), both quotients that are b, and D."""
    import sympy as sp

    from osculant.cas.asymptotics import free_cubics

    contact, heights = free_cubics.contact(), free_cubics.Y
    options: dict[str, Any] = {"modules": [{}]}
    thirds = [sp.fraction(sp.together(third)) for third in contact.third()]
    return (
        sp.lambdify(heights, sp.Poly(contact.condition, free_cubics.a).all_coeffs(), **options),
        sp.lambdify((free_cubics.a, *heights), thirds, **options),
        sp.lambdify((free_cubics.a, free_cubics.b, *heights), contact.residual, **options),
    )


def least(jet: PlaneJet) -> Any:
    """min |D| over the real roots of (C), at a jet of balls; 0 where (C) says nothing, on straight parts."""
    from flint import arb

    return min((abs(value) for value in residuals(jet)), key=float, default=arb(0))


def branch(jet: PlaneJet) -> tuple[int, int, bool]:
    """How many cubics have six contacts, which of them is the best, and whether its D is positive."""
    found = residuals(jet)
    if not found:
        return 0, 0, False
    best = min(range(len(found)), key=lambda i: abs(float(found[i])))
    return len(found), best, bool(found[best] > 0)


def _constant(name: str) -> Algebraic:
    from osculant.cas.asymptotics import free_cubics

    value: Algebraic = getattr(free_cubics, name)()
    return value


CUBIC = Law(
    "cubic",
    "hausdorff",
    order=ORDER,
    jet=ORDER,
    invariant=least,
    constant=partial(_constant, "distance_constant"),
    source="osculant.cas.asymptotics.free_cubics",
    branch=branch,
)
LAWS = (CUBIC, replace(CUBIC, metric="area", order=ORDER + 1, constant=partial(_constant, "area_constant")))
