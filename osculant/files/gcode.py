"""Splines as G-code: `G2` and `G3` for circular arcs and helices about a coordinate axis, `G1` for lines.

Coordinates are absolute, I, J and K relative to the start of the arc, all with the same number of decimals.
What is written stays within a `reserve` of the spline's pieces. Its parts:

* rounding of numbers to their last unit u, half of it: 4u, as `osculant.files.motions` shows. The radius of
  an arc differs at its ends, as printed, by less than u/2;
* arcs that are lines to within u are written so. Those with a radius above `straight_radius` are written
  as chords within a quarter of the reserve: controllers lose digits to centres far away;
* a helix whose axis is tilted from the coordinate axis by so little that no point moves by more than an
  eighth of the reserve is written as if it were not.

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
from osculant.files.motions import ROUNDING, Arc, Program, chords_needed
from osculant.pieces.conics import Piece, conic_arcs
from osculant.pieces.helices import HelixArc
from osculant.tolerances import check_reserve, checked_tolerance
from osculant.version import __version__

if TYPE_CHECKING:
    from osculant.spline import Spline

LEAST_DECIMALS = 4
STRAIGHT = 1e5  # the radius of arcs written as chords, relative to the larger extent of the spline
LINE_LENGTH = 100  # of comments
UNITS = {"mm": "G21", "inch": "G20"}


def gcode(
    spline: Spline,
    *,
    decimals: int | None = None,
    reserve: float | None = None,
    straight_radius: float | None = None,
    chord_tolerance: float | None = None,
    units: Literal["mm", "inch"] | None = None,
    feed: float | None = None,
    command: str | None = None,
) -> str:
    """Return a spline of biarcs or bihelices as a G-code program that moves once along it.

    Args:
        spline: the spline.
        decimals: of all coordinates; by default as many as the reserve needs, at least 4.
        reserve: how far the written curve may be from the pieces; by default what the tolerance leaves, so
            that it holds for what is written. Machines with few decimals need a larger one.
        straight_radius: arcs of larger radius are written as chords; by default 100 000 times the larger
            extent of the spline.
        chord_tolerance: for the chords of helical arcs that no `G2` or `G3` can write; by default the
            spline's tolerance, so that such a program is within twice that.
        units: "mm" writes `G21`, "inch" `G20`; by default neither: the machine's setting holds.
        feed: the feed rate, written with the first motion after the start; by default none.
        command: the command line that made the spline, recorded in the header.

    Returns:
        The program's text, ASCII. Comments in its header record version, curve, primitive, tolerance, and
        the errors of the spline, of writing and of chords.

    Raises:
        DomainError: a piece of a conic that is neither circle nor line; impossible decimals, units, feed.
        ToleranceError: decimals too few for the reserve, a reserve below half of the 8 rounding units, or so
            little left of the tolerance.

    >>> import osculant as osc
    >>> spline = osc.approximate(osc.curve("cos(t), sin(t)", 0, "pi"), "biarc")
    >>> print("".join(gcode(spline, reserve=1e-3).splitlines(keepends=True)[-4:]), end="")
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
    extent = max(high - low for low, high in zip(*spline.bounding_box()))
    if straight_radius is None:
        straight_radius = STRAIGHT * extent
    chord_tolerance = checked_tolerance(spline.tolerance if chord_tolerance is None else chord_tolerance)
    largest = spline.chain.largest
    reserve = check_reserve(spline.reserve, largest, False) if reserve is None else reserve
    decimals = _digits(reserve, largest, decimals)

    arcs: list[Piece | HelixArc] = [arc for arc in spline.chain.arcs if isinstance(arc, HelixArc)]
    arcs = arcs or [*conic_arcs(spline.pieces)]
    program = Program(decimals, arcs[0].start)
    chorded = 0
    for arc in arcs:
        if arc.kind == "segment":
            program.line(arc.end)
            continue
        round_arc = _helix(arc, reserve / 8) if isinstance(arc, HelixArc) else _circle(arc)
        if round_arc is None:
            assert isinstance(arc, HelixArc)
            chorded += 1
            program.chords(_fractions(arc), chords_needed(arc.curvature * arc.length**2, chord_tolerance))
            continue
        if round_arc.chord_square / 8 <= 10.0**-decimals:
            program.chords(round_arc.point, 1)
        elif round_arc.radius > straight_radius:
            program.chords(round_arc.point, chords_needed(round_arc.chord_square, reserve / 4))
        else:
            program.turn(round_arc)
    if feed is not None and len(program.lines) > 1:
        first = next(i for i, line in enumerate(program.lines) if line.startswith(("G1 ", "G2 ", "G3 ")))
        program.lines[first] += f" F{Decimal(repr(float(feed))):f}"

    facts = [
        f"osculant {__version__}",
        *([] if command is None else [f"command: {command}"]),
        f"curve: {spline.curve.text}",
        f"primitive: {spline.primitive}, {len(spline)} pieces",
        f"tolerance: {spline.tolerance!r} ({spline.metric})",
        f"error: {spline.error!r} ({spline.error_kind}), of writing at most {reserve!r} more",
        *([] if not chorded else [f"chords: {chorded} helical arcs, at most {chord_tolerance!r} more"]),
        f"decimals: {decimals}; I, J and K relative to the start of an arc",
        f"units: {'those of the curve, as the machine is set' if units is None else units}",
    ]
    modes = " ".join(["G17", "G90", *([] if units is None else [UNITS[units]])])
    return "\n".join([*(line for fact in facts for line in _comment(fact)), modes, *program.lines, "M2", ""])


def _digits(reserve: float, largest: float, decimals: int | None) -> int:
    """Return the number of decimals."""
    check_reserve(reserve, largest)
    needed = max(0, math.ceil(math.log10(2 * ROUNDING / reserve) - 1e-9))
    if decimals is None:
        return max(LEAST_DECIMALS, needed)
    if not needed <= decimals:
        raise ToleranceError(
            f"Rounding to {decimals} decimals moves the path by up to {ROUNDING * 10.0**-decimals:.0e}, more "
            f"than half of the {reserve:.3g} kept for writing: give {needed} decimals, or "
            f"a reserve of {2 * ROUNDING * 10.0**-decimals:.0e}."
        )
    return decimals


def _circle(arc: Piece) -> Arc:
    """Return a circular arc in the plane."""
    if arc.kind != "arc":
        raise DomainError(
            f"G-code has lines and circular arcs, and the piece on {arc.interval} is of kind "
            f"{arc.kind!r}: approximate with biarcs."
        )
    (ax, ay), _, (cx, cy) = arc.legs
    half = math.atan2(ax * cy - ay * cx, ax * cx + ay * cy)
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
    return Arc(_fractions(arc), axis, turning, arc.radius, arc.curvature * arc.length**2)


def _fractions(arc: HelixArc) -> Callable[[float], Sequence[float]]:
    def point(fraction: float) -> Sequence[float]:
        found: list[float] = arc.point(fraction).tolist()
        return found

    return point


def _comment(fact: str) -> list[str]:
    """Return a fact as comments; their text can hold neither parentheses nor what is not ASCII."""
    text = re.sub(r"[^ -~]", "?", fact.replace("(", "[").replace(")", "]"))
    return [f"({line})" for line in textwrap.wrap(text, LINE_LENGTH)]
