"""Claims on the biarcs of a spiral arc, chapter 5 as reconstructed: side by side, one of them the best."""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from typing import Any

import mpmath as mp
import sympy as sp

from osculant.cas.claims.chapter_5.biarc_geometry import monotone_curvatures, vogt
from osculant.cas.claims.chapter_5.tangent_circles import circle_velocity, meets_once_more
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integers, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.geometry.biarcs import Biarc, equioscillating, extremes, junction_circle, member

#: digits, samples along the arc and members of the family in the measurements on Archimedes' spiral
DIGITS, SAMPLES, MEMBERS = 30, 40, 13


# Measurements on Archimedes' spiral, from t = 2 to 3: κ decreases, the arc turns by less than π.


def _curve(t: Any) -> tuple[Any, Any]:
    velocity = mp.expj(t) * (1 + 1j * t)
    return t * mp.expj(t), velocity / abs(velocity)


def _turning(low: Any, high: Any) -> Any:
    return high + mp.atan(high) - low - mp.atan(low)


def _family(mu: Any) -> Biarc:
    low, high = mp.mpf(2), mp.mpf(3)
    (p, T), (q, _) = _curve(low), _curve(high)
    return member(p, T, q, _turning(low, high), mu)


def _parameters(count: int) -> list[Any]:
    return [2 + mp.mpf(i) / count for i in range(1, count)]


@cache
def _measured() -> list[list[Any]]:
    """Displacements of the members μ = 1/14 … 13/14 at the samples, one row a member."""
    with mp.workdps(DIGITS):
        members = [_family(mp.mpf(i) / (MEMBERS + 1)) for i in range(1, MEMBERS + 1)]
        return [[b.displacement(*_curve(t)) for t in _parameters(SAMPLES)] for b in members]


@claim(
    "R5.3-7",
    "The biarcs of a strictly convex spiral arc lie side by side: at every point of the arc the "
    "displacement is strictly monotone in μ, in the direction in which both curvatures grow.",
    method=Method.PROOF,
    given=("X3.2-2",),
    form="same direction at every point",
    wrong=("opposite directions at the ends",),
)
def side_by_side(form: str) -> Evidence:
    """With μ an arc tangent at p moves to the left with ½|z − p|² dK/dμ (X5.3-3, the end being fixed).

    By R5.3-4 dK/dμ has one sign for both arcs, that of B − A, and A ≠ B by Vogt (R5.3-6). So both arcs move
    to the same side at all their points but the ends, and at the junction with the same velocity: there the
    squared distances from both ends, (s₁/S)² and (s₂/S)² in units of the chord, are inversely as the rates of
    R5.3-4. So d, the first hit of the normal on the side of the member, is strictly monotone in μ at every
    point. These steps are proved again here; differences of neighbouring members on one spiral then agree.
    """
    holds = _choose(form, {"same direction at every point": True, "opposite directions at the ends": False})
    found = monotone_curvatures("-omega*S*D/s1**2, -omega*S*D/s2**2")
    found &= circle_velocity("K1*rho^2/2 + (kappa - K)*along") & vogt("cos(theta) + kappa*y") & _at_junction()
    rows = _measured()
    signs = {q > p for row, following in pairwise(rows) for p, q in zip(row, following)}
    line = f"{len(rows)} members at {len(rows[0])} points: {len(signs)} sign of the differences"
    return found & Evidence((len(signs) == 1) == holds, (line,))


def _at_junction() -> Evidence:
    """½|z − p|² dK/dμ of both arcs at the junction, with |z − p| from the junction circle through 0 and 1."""
    half, part = sp.symbols("w m")  # e^{iω/2}, e^{iμω/2}

    def sine(exponential: Any) -> Any:
        return (exponential - 1 / exponential) / (2 * sp.I)

    junction = (1 - part**2) / (1 - half**2)
    sines, found, rates = (sine(part), sine(half / part)), Evidence(True), []
    for what, leg, s in zip(("first", "second"), (junction, 1 - junction), sines, strict=True):
        square = leg * leg.subs({half: 1 / half, part: 1 / part}, simultaneous=True)
        found &= vanishes(square - (s / sine(half)) ** 2, f"squared chord of the {what} arc")
        rates.append(square * sine(half) / s**2)  # dK/dμ by R5.3-4, without the common factor
    return found & vanishes(rates[0] - rates[1], "velocities of both arcs at the junction")


@claim(
    "R5.3-8",
    "A strictly convex spiral arc crosses the junction circle once, and the displacement of every member "
    "changes its sign at most once: exactly if its curvatures are between those of the arc at both ends.",
    method=Method.PROOF,
    given=("X3.2-2",),
    form="1",
    wrong=("0", "2"),
)
def crosses_once(form: str) -> Evidence:
    """Let κ increase; else reverse the arc. By inscribed angles γ(u) is on the circle if A_u + B̃_u = ω/2.

    A_u is the angle at the start of the chord to γ(u), B̃_u that at the end of the chord from γ(u). The rate
    of their sum by arc length is half the difference of the curvatures of the circles tangent at γ(u) through
    the start and through the end. By X5.3-2 on both parts of the arc the first is less than κ(u), the second
    greater. So the sum falls strictly, from B to A, and A < ω/2 < B: it is ω/2 once.

    Near the start d has the sign of K₁ − κ(a), near the end that of K₂ − κ(b). By X5.3-2 it is positive on
    the first arc before the one place where the circle tangent at the start through γ(u) has the curvature
    K₁, and negative after; on the second likewise. So if d > 0 at the junction there is no change before it
    and at most one after, if d < 0 at most one before and none after: from + to −, exactly if K₁ > κ(a) and
    K₂ < κ(b). Every inner point is on one member, since d grows with μ (R5.3-7) from the circle tangent at
    the end to the one tangent at the start.

    Counted on one spiral as well: the crossings of the circle, and the signs of the displacement of each
    member.
    """
    found = meets_once_more("1") & _angle_sum()
    with mp.workdps(DIGITS):
        (p, T), (q, S) = _curve(mp.mpf(2)), _curve(mp.mpf(3))
        centre = junction_circle(p, T, q, S)
        radius = abs(p - centre)
        sides = [abs(_curve(t)[0] - centre) > radius for t in _parameters(SAMPLES)]
    changes = _changes(sides)
    most = max(_changes([d > 0 for d in row]) for row in _measured())
    return found & Evidence(
        (changes,) == (most,) == integers(form, 1),
        (f"{changes} crossing of the circle; at most {most} change of sign of d",),
    )


def _angle_sum() -> Evidence:
    """The rate of A_u + B̃_u against half the difference of two curvatures; its ends on both sides of ω/2."""
    A, B, before, after = sp.symbols("A B before after", positive=True)  # lengths of both chords
    angles = sp.symbols("B_u A_u", positive=True)  # at γ(u), with the chords from the start and to the end
    rate = sp.sin(angles[0]) / before - sp.sin(angles[1]) / after  # X5.3-1
    curvatures = [2 * sp.sin(angle) / length for angle, length in zip(angles, (before, after))]
    sides = vanishes((B - (A + B) / 2) + (A - (A + B) / 2), "B and A are on opposite sides of ω/2")
    return sides & vanishes(rate - (curvatures[0] - curvatures[1]) / 2, "rate of the sum of the angles")


def _changes(sides: list[bool]) -> int:
    return sum(a != b for a, b in pairwise(sides))


@claim(
    "R5.3-9",
    "Largest and smallest displacement both move in one direction with μ, so exactly one biarc of a strictly "
    "convex spiral arc has max d = −min d, and it has the least error of all.",
    method=Method.PROOF,
    given=("R5.3-7", "R5.3-8"),
    form="equioscillation",
    wrong=("junction half way", "equal curvature steps"),
)
def unique_optimum(form: str) -> Evidence:
    """By R5.3-7 d is strictly monotone in μ at every point, so max d and −min d move in opposite directions.

    Where both are positive that is strict, so max d = −min d for one member at most; there is one, since the
    members near both ends of the family lie on one side of the arc each (R5.3-8). For any other member max d
    or −min d is greater. On one spiral the error of the member that the form names is compared with all
    members measured and those nearby.
    """
    rows = _measured()
    tops, lows = [max(r) for r in rows], [min(r) for r in rows]
    directions = {q > p for line in (tops, lows) for p, q in pairwise(line)}
    with mp.workdps(DIGITS):
        parameters = _parameters(SAMPLES)
        best, _ = equioscillating(_family, _curve, parameters)
        mu = _choose(form, {"equioscillation": best, "junction half way": mp.mpf(1) / 2,
                            "equal curvature steps": _balanced()})  # fmt: skip

        def error(place: Any) -> Any:
            return max(abs(d) for d in extremes(_family(place), _curve, parameters))

        chosen, step = error(mu), mp.mpf(1) / 1000
        others = [error(best + i * step) for i in (-1, 0, 1)] + [max(t, -b) for t, b in zip(tops, lows)]
        line = (
            f"μ = {mp.nstr(mu, 8)}: error {mp.nstr(chosen, 8)}, least of the others {mp.nstr(min(others), 8)}"
        )
    return Evidence(len(directions) == 1 and chosen <= min(others), (line,))


def _balanced() -> Any:
    """The member whose curvatures have the mean of the curve's at the ends."""
    ends = [(2 + t * t) / mp.sqrt(1 + t * t) ** 3 for t in (mp.mpf(2), mp.mpf(3))]
    return mp.findroot(lambda mu: sum(_family(mu).curvatures) - sum(ends), mp.mpf("0.45"))


def _choose(form: str, choices: dict[str, Any]) -> Any:
    if form not in choices:
        raise DomainError(f"The form {form!r} is unknown: choose one of {', '.join(choices)}.")
    return choices[form]
