"""Claims beyond section 3.2: arcs that every line meets twice at most, on which conics are counted."""

from __future__ import annotations

from typing import Any

import sympy as sp
from flint import arb

from osculant.cas.claims.chapter_3.six_zeros import six_zeros, slopes, turning
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.numbers.balls import precision


def _number(form: str) -> Any:
    """A real constant; raises DomainError for other forms."""
    value = read(form, {})
    if not value.is_real:
        raise DomainError(f"A real number is expected, not {form!r}.")
    return value


@claim(
    "X3.2-2",
    "An arc with κ > 0 inside is strictly convex, that is every line meets it in at most two points with "
    "multiplicity, exactly if it turns by less than 2π and sin A > 0, sin B > 0 for the angles A, B of its "
    "end tangents with the chord; it then turns by A + B.",
    method=Method.PROOF,
    form="2*pi",
    wrong=("3*pi", "4*pi", "pi"),
)
def strictly_convex(form: str) -> Evidence:
    """The form bounds the turning ψ: it is the largest bound that leaves one way to close the arc.

    Closed by its chord, the arc has corners with the exterior angles π − B and π − A, both in (0, π). So the
    tangent turns by ψ + 2π − A − B in all, a multiple of 2π between 0 and ψ + 2π. If ψ < 2π that is 2π
    itself: the tangent turns once, and in one direction. Each height function then has one maximum and one
    minimum on the closed curve and is strictly monotone between, but for the chord itself: a line meets the
    arc in at most two points, and where it touches the height is extremal, to second order as κ > 0. With two
    turns there are arcs that cross themselves.

    Conversely a strictly convex arc lies to the left of each tangent, touching it only there, those at the
    ends included: so sin A, sin B > 0; a second point with the same direction of the tangent is impossible,
    so it turns by less than 2π. Its points are all corners of their convex hull, and its sub-arcs are
    strictly convex.
    """
    bound = _number(form)
    within = [m for m in range(1, 6) if 2 * sp.pi * m < bound + 2 * sp.pi]
    largest = bound / (2 * sp.pi) == 1
    line = f"turnings below {bound} leave 2π times {', '.join(map(str, within)) or 'nothing'} for the whole"
    return Evidence(within == [1] and bool(largest), (line,)) & vanishes(
        sp.Symbol("A") + sp.Symbol("B") - _closing(within), "ψ against A + B"
    )


def _closing(multiples: list[int]) -> Any:
    """ψ if the whole turning is the last of these multiples of 2π."""
    a, b = sp.symbols("A B")
    return 2 * sp.pi * (multiples[-1] if multiples else 0) - (sp.pi - b) - (sp.pi - a)


@claim(
    "X3.2-3",
    "An arc with κ > 0 inside that turns by at most π is strictly convex.",
    method=Method.PROOF,
    form="pi",
    wrong=("2*pi", "3/2*pi", "pi/2"),
)
def at_most_half_a_turn(form: str) -> Evidence:
    """The form is the largest turning for which the end tangents alone decide it.

    With the chord c = ∫T ds and θ the angle of T from T₀, |c| sin A = [T₀, c] = ∫ sin θ ds, which is positive
    if sin θ > 0 for 0 < θ < ψ; likewise sin B from the other end. Both angles lie in (0, π) then. The sine is
    positive on (0, ψ) up to its first zero.
    """
    bound, angle = _number(form), sp.Symbol("theta", positive=True)
    first = min(sp.solveset(sp.sin(angle), angle, sp.Interval.Lopen(0, 7)))
    line = f"the first zero of the sine is {first}"
    return Evidence(bool(bound > 0), (line,)) & vanishes(bound - first, "largest turning")


@claim(
    "X3.2-12",
    "A turning of at most π is the best hypothesis in terms of the turning alone: for every δ > 0 there is "
    "an affine spiral arc that turns by less than π + δ and meets a hyperbola six times.",
    method=Method.PROOF,
    form="pi",
    wrong=("pi + 1/1000", "3/2*pi", "2*pi", "pi/2"),
)
def sharpturning(form: str) -> Evidence:
    """The form bounds the turning. Up to π the arc is strictly convex (X3.2-3), and R3.2-2 holds.

    Above, the hyperbola (L − 1/2)(L − 29/50) = y²/2000, L = x + 2y/25, changes its sign six times on
    Archimedes' spiral between t = 0.53 and 4.95. Affine maps (L, S(y − x/5)) keep that, and dk/dr ≠ 0. The
    ends have the directions (u, Sv), with the angles arctan(u/(Sv)) from the vertical, so the turning exceeds
    π by at most Σ|u/v|/S < 8/S. For a bound above π an S is chosen and the turning enclosed as well.
    """
    bound = read(form, {})
    if not bound.is_real:
        raise DomainError(f"A real number is expected, not {form!r}.")
    if not bound > sp.pi:
        return at_most_half_a_turn("pi") & vanishes(bound - sp.pi, "the bound against π")
    changes, certain = six_zeros("turning < 2*pi")
    stretch = int(sp.ceiling(8 / (bound - sp.pi)))
    with precision(128):
        angle = turning(arb(stretch))
        over = angle - arb.pi()
        all_stretches = sum(abs(u / v) for u, v in slopes()) < 8
    refuted = (
        changes >= 6
        and bool(certain)
        and bool(all_stretches)
        and bool(angle < arb(stretch) ** -1 * 8 + arb.pi())
    )
    line = f"the image with S = {stretch} turns by π + {float(over):.3g} and has {changes} zeros"
    return certain & Evidence(not refuted, (line,))
