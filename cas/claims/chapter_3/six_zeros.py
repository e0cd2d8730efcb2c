"""What Theorem A needs: affine spirals that turn by more than π and meet a hyperbola six times, in balls."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from flint import arb

from osculant.cas.claims.chapter_3.sample_arcs import has_no_zero
from osculant.cas.claims.claim import Evidence
from osculant.cas.claims.examples import SPIRAL
from osculant.cas.errors import DomainError
from osculant.cas.numbers.balls import precision

#: (L − 1/2)(L − 29/50) − y²/2000 with L = x + 2y/25, and where its signs alternate on Archimedes' spiral
PLACES = ("0.53", "0.65", "0.9", "1.15", "3.5", "4.9", "6")
#: the last place for arcs that turn by little more than π
SHORT = "4.95"
#: affine images (L, S(y − x/5)) of this S turn on [0.53, 4.95] by less than π + 8/S
STRETCH = 100


def _hyperbola(t: Any) -> Any:
    x, y = t * t.cos(), t * t.sin()
    line = x + 2 * y / 25
    return (line - arb(1) / 2) * (line - arb(29) / 50) - y * y / 2000


def _changes(places: tuple[str, ...]) -> tuple[int, str]:
    """Changes of sign of the hyperbola's equation along the spiral, and the signs, in balls."""
    with precision(128):
        values = [_hyperbola(arb(t)) for t in places]
        signs = ["+" if v > 0 else "−" if v < 0 else "?" for v in values]
    changes = sum({a, b} == {"+", "−"} for a, b in pairwise(signs))
    return changes, f"signs {' '.join(signs)} at t = {', '.join(places)}"


def slopes() -> list[tuple[Any, Any]]:
    """The directions (dL, d(y − x/5)) of the spiral at 0.53 and 4.95."""
    found = []
    for text in (PLACES[0], SHORT):
        t = arb(text)
        dx, dy = t.cos() - t * t.sin(), t.sin() + t * t.cos()
        found.append((dx + 2 * dy / 25, dy - dx / 5))
    return found


def turning(stretch: Any) -> Any:
    """The turning of the image of the spiral's arc [0.53, 4.95], as a ball: between π and 2π."""
    (u0, v0), (u1, v1) = ((u, stretch * v) for u, v in slopes())
    # the angle from the first direction to the last is π + the angle from minus the first
    return arb.pi() + arb.atan2(-(u0 * v1 - v0 * u1), -(u0 * u1 + v0 * v1))


def six_zeros(hypothesis: str) -> tuple[int, Evidence]:
    """How often a conic meets an affine spiral that satisfies a hypothesis weaker than strict convexity.

    Args:
        hypothesis: "k monotone" (and κ ≠ 0), or "turning < 2*pi" as well.

    Returns the number of zeros that are certain, and the evidence that the arc satisfies the hypothesis.
    Raises DomainError for another hypothesis.

    >>> six_zeros("k monotone")[0]
    6
    """
    if hypothesis not in {"k monotone", "turning < 2*pi"}:
        raise DomainError(
            f"The hypothesis {hypothesis!r} is unknown: use 'strictly convex', 'k monotone' or "
            "'turning < 2*pi'."
        )
    short = hypothesis != "k monotone"
    places = (*PLACES[:-1], SHORT) if short else PLACES
    changes, line = _changes(places)
    spiral = has_no_zero(SPIRAL, places[0], places[-1], "sextactic_form")
    bends = has_no_zero(SPIRAL, places[0], places[-1], "inflection_form")
    certain = Evidence(
        spiral and bends,
        (
            f"{SPIRAL} on [{places[0]}, {places[-1]}]: κ and dk/dr have no zero",
            f"(L − 1/2)(L − 29/50) = y²/2000: {line}",
        ),
    )
    if short:
        with precision(128):
            angle = turning(arb(STRETCH))
            line = f"the image (L, {STRETCH}(y − x/5)) turns by {float(angle):.6g} there"
            certain &= Evidence(bool(angle < 2 * arb.pi()), (line,))
    return changes, certain
