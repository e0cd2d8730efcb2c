"""Splines as G-code: `G2` and `G3` for circular arcs and helices about a coordinate axis, `G1` for lines.

Coordinates are absolute, I, J and K relative to the start of the arc, all with the same number of decimals.
What is written stays within a budget of the spline's pieces. Its parts:

* rounding of numbers to their last unit u, half of it: 4u, as `osculant.files.motions` shows. The radius of
  an arc differs at its ends, as printed, by less than u/2;
* arcs that are lines to within u are written so. Those with a radius above `straight_radius` are written
  as chords within a quarter of the budget: controllers lose digits to centres far away;
* a helix whose axis is tilted from the coordinate axis by so little that no point moves by more than an
  eighth of the budget is written as if it were not.

Helical arcs about other axes are beyond G-code: chords stand for them, n = ⌈L√(κ/(8τ))⌉ for the length L and
a tolerance τ of their own, which the header tells. A helix whose Darboux vector (`osculant.pieces.helices`)
points along + of the axis is a `G3` there. Source: thesis, Lemma 4.2.1 with its erratum.
"""

from __future__ import annotations

import math
import re
import textwrap
from collections.abc import Callable, Sequence
from decimal import Decimal
from typing import TYPE_CHECKING, Literal

from osculant.cas.errors import DomainError, ToleranceError
from osculant.files.facts import header, header_lines
from osculant.files.motions import ROUNDING, Arc, Program
from osculant.files.round_arcs import chords_needed, circular_arcs, helical_arcs
from osculant.tolerances import checked_budget, checked_tolerance

if TYPE_CHECKING:
    from osculant.files.facts import Facts
    from osculant.pieces.chain import Chain
    from osculant.pieces.conics import Piece
    from osculant.pieces.helices import HelixArc

LEAST_DECIMALS = 4
STRAIGHT = 1e5  # the radius of arcs written as chords, relative to the larger extent of the spline
LINE_LENGTH = 100  # of comments
UNITS = {"mm": "G21", "inch": "G20"}


def gcode(
    chain: Chain,
    facts: Facts,
    budget: float,
    *,
    decimals: int | None = None,
    straight_radius: float | None = None,
    chord_tolerance: float | None = None,
    units: Literal["mm", "inch"] | None = None,
    feed: float | None = None,
) -> str:
    """Return a spline of biarcs or bihelices as a G-code program that moves once along it.

    Args:
        chain: its pieces.
        facts: of the spline, recorded in the header, with the errors of writing and of chords.
        budget: how far the written curve may be from the pieces. Machines with few decimals need a large one.
        decimals: of all coordinates; by default as many as the budget needs, at least 4.
        straight_radius: arcs of larger radius are written as chords; by default 100 000 times the larger
            extent of the spline.
        chord_tolerance: for the chords of helical arcs that no `G2` or `G3` can write; by default the
            spline's tolerance, so that such a program is within twice that.
        units: "mm" writes `G21`, "inch" `G20`; by default neither: the machine's setting holds.
        feed: the feed rate, written with the first motion after the start; by default none.

    Returns:
        The program's text, ASCII.

    Raises:
        DomainError: a piece of a conic that is neither circle nor line; impossible decimals, units, feed.
        ToleranceError: decimals too few for the budget, or a budget below half of the 8 rounding units.

    >>> import osculant as osc
    >>> half = osc.approximate(osc.curve("cos(t), sin(t)", 0, "pi"), "biarc")
    >>> print("".join(gcode(half.chain, half.facts(), 1e-3).splitlines(keepends=True)[-4:]), end="")
    G0 X1.0000 Y0.0000
    G3 X0.0000 Y1.0000 I-1.0000 J0.0000
    G3 X-1.0000 Y0.0000 I0.0000 J-1.0000
    M2
    """
    if units not in (None, *UNITS):
        raise DomainError(f"The units of G-code are 'mm' or 'inch', not {units!r}.")
    if decimals is not None and not isinstance(decimals, int):
        raise DomainError(f"The number of decimals is {decimals!r}: give a whole number such as 4.")
    if feed is not None and not (0 < feed < math.inf):
        raise DomainError(f"The feed rate is {feed!r}: give a positive finite number.")
    if straight_radius is None:
        straight_radius = STRAIGHT * max(high - low for low, high in zip(*chain.bounding_box()))
    chord_tolerance = checked_tolerance(facts.tolerance if chord_tolerance is None else chord_tolerance)
    decimals = _digits(budget, chain.largest, decimals)

    program = Program(decimals, chain.pieces[0].start)
    for circular in circular_arcs(chain, "G-code"):
        if circular.kind == "segment":
            program.line(circular.end)
        else:
            _turn(program, _circle(circular), straight_radius, budget)
    chorded = 0
    for arc in helical_arcs(chain):
        helix = _helix(arc, budget / 8)
        if arc.kind == "segment":
            program.line(arc.end)
        elif helix is not None:
            _turn(program, helix, straight_radius, budget)
        else:
            chorded += 1
            program.chords(_points(arc), chords_needed(arc.curvature * arc.length**2, chord_tolerance))
    if feed is not None and len(program.lines) > 1:
        first = next(i for i, line in enumerate(program.lines) if line.startswith(("G1 ", "G2 ", "G3 ")))
        program.lines[first] += f" F{Decimal(repr(float(feed))):f}"

    head = header(
        facts,
        budget,
        chords=f"{chorded} helical arcs, at most {chord_tolerance!r} more" if chorded else None,
        decimals=f"{decimals}; I, J and K relative to the start of an arc",
        units="those of the curve, as the machine is set" if units is None else units,
    )
    comments = [line for fact in header_lines(head) for line in _comment(fact)]
    modes = " ".join(["G17", "G90", *([] if units is None else [UNITS[units]])])
    return "\n".join([*comments, modes, *program.lines, "M2", ""])


def _digits(budget: float, largest: float, decimals: int | None) -> int:
    """Return the number of decimals."""
    checked_budget(budget, largest)
    needed = max(0, math.ceil(math.log10(2 * ROUNDING / budget) - 1e-9))
    if decimals is None:
        return max(LEAST_DECIMALS, needed)
    if not needed <= decimals:
        raise ToleranceError(
            f"Rounding to {decimals} decimals moves the path by up to {ROUNDING * 10.0**-decimals:.0e}, more "
            f"than half of the {budget:.3g} kept for writing: give {needed} decimals, or "
            f"a reserve of {2 * ROUNDING * 10.0**-decimals:.0e}."
        )
    return decimals


def _turn(program: Program, arc: Arc, straight_radius: float, budget: float) -> None:
    """Move along an arc, by chords if it is too straight for the digits of its centre."""
    if arc.chord_square / 8 <= 10.0**-program.decimals:
        program.chords(arc.point, 1)
    elif arc.radius > straight_radius:
        program.chords(arc.point, chords_needed(arc.chord_square, budget / 4))
    else:
        program.turn(arc)


def _circle(arc: Piece) -> Arc:
    """Return a circular arc in the plane."""
    cx, cy = arc.legs[2]
    half = arc.turning / 2
    chord = math.hypot(cx, cy)
    sine = math.sin(half)
    radius = chord / (2 * abs(sine)) if sine else math.inf

    def point(fraction: float) -> tuple[float, float]:
        if fraction == 1.0 or not sine:
            return (arc.start[0] + fraction * cx, arc.start[1] + fraction * cy) if fraction < 1 else arc.end
        size, angle = math.sin(fraction * half) / sine, (fraction - 1) * half
        u, v = size * math.cos(angle), size * math.sin(angle)
        return arc.start[0] + u * cx - v * cy, arc.start[1] + u * cy + v * cx

    square = chord * 2 * half**2 / abs(sine) if sine else 0.0  # κL² = L·2|half|
    return Arc(point, 2, 2 * half, radius, square)


def _helix(arc: HelixArc, tilt: float) -> Arc | None:
    """Return a helical arc about a coordinate axis, or None if tilting it there moves a point by more."""
    axis = max(range(3), key=lambda k: abs(arc.axis[k]))
    away = math.hypot(*(arc.axis[k] for k in range(3) if k != axis))
    if away * arc.length > tilt:
        return None
    turning = math.copysign(arc.turning, arc.axis[axis])
    return Arc(_points(arc), axis, turning, arc.radius, arc.curvature * arc.length**2)


def _points(arc: HelixArc) -> Callable[[float], Sequence[float]]:
    def point(fraction: float) -> Sequence[float]:
        found: list[float] = arc.point(fraction).tolist()
        return found

    return point


def _comment(fact: str) -> list[str]:
    """Return a fact as comments; their text can hold neither parentheses nor what is not ASCII."""
    text = re.sub(r"[^ -~]", "?", fact.replace("(", "[").replace(")", "]"))
    return [f"({line})" for line in textwrap.wrap(text, LINE_LENGTH)]
