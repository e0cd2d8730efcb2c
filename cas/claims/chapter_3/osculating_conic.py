"""Claims of section 3.2.2: the osculating conic, its contact and the side on which the curve leaves it."""

from __future__ import annotations

import random
from fractions import Fraction
from functools import cache
from typing import Any

import sympy as sp
from flint import Ordering, fmpq_mpoly_ctx

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.geometry.five_points import (
    Conic,
    conic_affine_curvature,
    contact_rows,
    orthogonal_conic,
    osculating_conic,
)
from osculant.cas.jets.canonical import affine_arc, affine_graph
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.numbers.power_series import PowerSeries, solve

#: orders of derivatives in the generic jet; the point is the origin
ORDER = 5


@cache
def generic_jet() -> PlaneJet:
    """A curve at the origin with symbols for its derivatives up to order 5, as flint polynomials."""
    names = [f"{axis}{i}" for axis in "xy" for i in range(1, ORDER + 1)]
    context = fmpq_mpoly_ctx.get(names, Ordering.degrevlex)
    symbols, origin = context.gens(), context.constant(0)
    return PlaneJet((origin, *symbols[:ORDER]), (origin, *symbols[ORDER:]))


@cache
def generic_osculating_conic() -> Conic:
    """The conic orthogonal to the divided differences at five coincident points of the generic curve."""
    return orthogonal_conic(contact_rows(lambda _, __: generic_jet(), (0,) * 5))


def along_curve(conic: Conic, jet: PlaneJet) -> PowerSeries:
    """The left side of a conic's equation along a curve, as a series in its parameter."""
    factorial, rows = 1, ([jet.x[0]], [jet.y[0]])
    for i in range(1, len(jet.x)):
        factorial *= i
        for row, derivatives in zip(rows, (jet.x, jet.y)):
            row.append(derivatives[i] / factorial)
    series: PowerSeries = conic(PowerSeries(rows[0]), PowerSeries(rows[1]))
    return series


@claim(
    "R3.2-1",
    "The osculating conic meets the curve in five coincident points and has the curve's affine curvature "
    "k there.",
    method=Method.PROOF,
    form="k",
    wrong=("-k", "2*k", "k/2"),
)
def osculating_conic_has_the_same_curvature(form: str) -> Evidence:
    """A generic curve: symbols for all derivatives up to order 5 of both coordinates at one point.

    The osculating conic is orthogonal to [s, …, s](Ψ∘α) with 1, …, 5 nodes. Its equation along the curve must
    begin with t⁵. With n = 9φ⁸k and φ³ = [12], k³ = n³/(729[12]⁸), so that S³·729[12]⁸ = n³T² says that k³ is
    S³/T², and k is its real cube root. The form, the conic's k, is also tried at three rational jets with
    [12] = 8, where all roots are rational.
    """
    jet, conic = generic_jet(), generic_osculating_conic()
    series = along_curve(conic, jet)
    contact = all(series[i] == 0 for i in range(5)) and series[5] != 0
    left = conic.S**3 * 729 * jet.inflection_form**8
    right = jet.parabolic_form**3 * conic.T**2
    same = Evidence(left == right and left != 0, ("S³·729[12]⁸ − n³T² = 0 in ℚ[x₁, …, y₅]",))
    touches = Evidence(contact, ("along the curve the equation begins with t⁵",))
    evidence, source = touches & same, random.Random(321)
    for _ in range(3):
        y1, *rest = (Fraction(source.randint(-20, 20), 7) for _ in range(6))
        example = PlaneJet((0, Fraction(1), *rest[:3]), (0, y1, 8 + y1 * rest[0], *rest[3:]))
        number = conic_affine_curvature(osculating_conic(example))
        k = sp.sympify(example.parabolic_form) / (9 * 2**8)
        evidence &= vanishes(read(form, {"k": k}) - number, f"the conic's k for k = {k}")
    return evidence


@claim(
    "R3.2-3",
    "In the affine frame the curve lies (dk/dr) x⁵/40 + O(x⁶) above its osculating conic: it meets it in "
    "a sixth "
    "coincident point exactly where dk/dr = 0.",
    method=Method.PROOF,
    form="slope*x**5/40",
    wrong=("slope*x**5/20", "-slope*x**5/40", "k*x**5/40", "slope*x**4/40"),
)
def sixth_contact(form: str) -> Evidence:
    """The curve is given by affine arc length in its frame at 0, the conic by the divided differences.

    The conic's equation is solved for y as a series in x, and subtracted from the canonical form. For a
    generic parameter t, the equation along the curve begins with t⁵, and the coefficient must vanish exactly
    with dk/dr: it is the form 27[12]⁴ dk/dr times a power of [12], where [12] ≠ 0.
    """
    context = fmpq_mpoly_ctx.get(["k0", "k1", "k2"], Ordering.degrevlex)
    k = context.gens()
    along, across, _ = affine_arc(5, k)
    jet = PlaneJet(_derivatives(along), _derivatives(across))
    conic = orthogonal_conic(contact_rows(lambda _, __: jet, (0,) * 5))
    conic = Conic(*(c * (1 / conic.e.coefficient(0)) for c in conic))
    zero = context.constant(0)
    x = PowerSeries([zero, zero + 1, *[zero] * 4])
    height = solve(lambda y: conic(x, y), context.constant(2), 6)
    above = affine_graph(5, k)[0] - height
    symbols = {"k": sp.Symbol("k0"), "slope": sp.Symbol("k1"), "x": sp.Symbol("x")}
    derived = sum(
        sp.sympify(str(c).replace("^", "**")) * symbols["x"] ** i for i, c in enumerate(above.coefficients)
    )
    evidence = vanishes(read(form, symbols) - derived, "curve above its osculating conic, up to x⁵")
    generic = generic_jet()
    fifth = along_curve(generic_osculating_conic(), generic)[5]
    multiple, remainder = divmod(fifth, generic.inflection_form * generic.sextactic_form)
    constant = remainder == 0 and multiple.is_constant()
    return evidence & Evidence(constant, (f"coefficient of t⁵: {multiple}·[12] times 27[12]⁴ dk/dr",))


def _derivatives(series: PowerSeries) -> list[Any]:
    factorial, found = 1, []
    for i, c in enumerate(series.coefficients):
        factorial *= max(i, 1)
        found.append(c * factorial)
    return found


SIDES = {
    "from right to left, turning left": (1, 1),
    "from left to right, turning left": (-1, 1),
    "from right to left, turning right": (1, -1),
}


@claim(
    "corollary 3.2.3",
    "Traversed so that it turns left, a curve crosses its osculating conic from right to left where k "
    "increases, and "
    "from left to right where k decreases.",
    method=Method.PROOF,
    form="from right to left, turning left",
    wrong=("from left to right, turning left", "from right to left, turning right"),
)
def crossing(form: str) -> Evidence:
    """Turning left, t is the direction of travel and n points to its left, since [t, n] = 1.

    So by R3.2-3 the curve is to the left of the conic by k′x⁵/40, which has the sign of k′x. A mirror image
    turns right, has the same k and exchanges left and right. The sign of the coefficient of k′ is read off
    the series; in addition the sides are determined exactly at points of (t, t² + t³) or its mirror image, a
    hundredth before and after.
    """
    if form not in SIDES:
        raise DomainError(f"The corollary has no form {form!r}: choose one of {', '.join(SIDES)}.")
    side, turn = SIDES[form]
    context = fmpq_mpoly_ctx.get(["k0", "k1", "k2"], Ordering.degrevlex)
    slope_part = affine_graph(5, context.gens())[0][5].coefficient(0)  # of k1, the only term at x⁵
    evidence = Evidence(slope_part * turn * side > 0, (f"coefficient of k′x⁵: {slope_part}",))
    agreeing = tried = 0
    for i in range(-9, 9, 2):
        at, step = Fraction(i, 10), Fraction(1, 100)
        jet = _mirrored_cubic(at, turn)
        if jet.inflection_form == 0 or jet.inflection_form * turn < 0 or jet.sextactic_form == 0:
            continue
        conic, leftward = osculating_conic(jet), (-jet.y[1], jet.x[1])
        gradient = (
            2 * (conic.a * jet.x[0] + conic.b * jet.y[0] + conic.d),
            2 * (conic.b * jet.x[0] + conic.c * jet.y[0] + conic.e),
        )
        outward = gradient[0] * leftward[0] + gradient[1] * leftward[1]  # how the equation grows to the left
        sides = [conic(*_mirrored_cubic(at + h, turn).point(0)) * outward for h in (-step, step)]
        # dk/dt has the sign of dk/dr times that of φ = dr/dt, which is the turn's
        increases = jet.sextactic_form * turn > 0
        expected = side if increases else -side
        agreeing += sides[0] * expected < 0 < sides[1] * expected
        tried += 1
    return evidence & Evidence(agreeing == tried > 0, (f"sides as stated at {agreeing} of {tried} points",))


def _mirrored_cubic(at: Fraction, turn: int) -> PlaneJet:
    heights = (at**2 + at**3, 2 * at + 3 * at**2, 2 + 6 * at, Fraction(6), Fraction(0), Fraction(0))
    return PlaneJet((at, Fraction(1), *[Fraction(0)] * 4), [h * turn for h in heights])
