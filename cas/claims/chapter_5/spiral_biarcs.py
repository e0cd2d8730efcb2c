"""Claims on the biarcs of a spiral arc, chapter 5 as reconstructed: side by side, one of them the best."""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from typing import Any

import mpmath as mp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integers
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
    "The biarcs of a spiral arc lie side by side: at every point of the arc the displacement is "
    "strictly monotone in μ.",
    method=Method.NUMERICAL,
    reason="the ordering of the first arc of one member against the second of another is measured, not "
    "proved",
    form="same direction at every point",
    wrong=("opposite directions at the ends",),
)
def side_by_side(form: str) -> Evidence:
    """Differences of the displacements of neighbouring members at all samples.

    Differences of the displacements of neighbouring members at all samples: the form says whether all have
    one sign, or those near the start and near the end opposite ones.
    """
    rows = _measured()
    signs = {q > p for row, following in pairwise(rows) for p, q in zip(row, following)}
    holds = _choose(form, {"same direction at every point": True, "opposite directions at the ends": False})
    line = f"{len(rows)} members at {len(rows[0])} points: {len(signs)} sign of the differences"
    return Evidence((len(signs) == 1) == holds, (line,))


@claim(
    "R5.3-8",
    "The spiral arc crosses the junction circle once, and so the displacement of every member "
    "changes sign at most once.",
    method=Method.NUMERICAL,
    reason="sign changes are counted at samples of one spiral",
    form="1",
    wrong=("0", "2"),
)
def crosses_once(form: str) -> Evidence:
    """Count the changes of side along the arc from t = 2 to 3 of Archimedes' spiral.

    Inside or outside of the junction circle, along the arc from t = 2 to 3 of Archimedes' spiral; and the
    signs of the displacement of each member.
    """
    with mp.workdps(DIGITS):
        (p, T), (q, S) = _curve(mp.mpf(2)), _curve(mp.mpf(3))
        centre = junction_circle(p, T, q, S)
        radius = abs(p - centre)
        sides = [abs(_curve(t)[0] - centre) > radius for t in _parameters(SAMPLES)]
    changes = _changes(sides)
    most = max(_changes([d > 0 for d in row]) for row in _measured())
    return Evidence(
        (changes,) == (most,) == integers(form, 1),
        (f"{changes} crossing of the circle; at most {most} change of sign of d",),
    )


def _changes(sides: list[bool]) -> int:
    return sum(a != b for a, b in pairwise(sides))


@claim(
    "R5.3-9",
    "Largest and smallest displacement both move in one direction with μ, so exactly one member has "
    "max d = −min d, "
    "and it has the least error of all.",
    method=Method.NUMERICAL,
    reason="follows from R5.3-7, which is itself measured on one spiral",
    form="equioscillation",
    wrong=("junction half way", "equal curvature steps"),
)
def unique_optimum(form: str) -> Evidence:
    """The error of the member the form names, against all members measured and those nearby."""
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
