"""Splines as G-code: `G2` and `G3` for circular arcs and helices about a coordinate axis, `G1` for lines.

Coordinates are absolute, I, J and K relative to the start of the arc, all with the same number of decimals;
`osculant.files.motions` says how they are rounded. Arcs that are too large for the digits of their centre, or
too small for a machine, are written as chords. A helix whose axis is tilted from the coordinate axis by so
little that no point moves by more than a tenth of the last unit is written as if it were not; for others
stand chords, or arcs whose height grows evenly (`osculant.files.space_moves`), whichever are fewer. A helix
whose Darboux vector (`osculant.pieces.helices`) points along + of the axis is a `G3` there. Source: thesis,
Lemma 4.2.1 with its erratum.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal
from typing import TYPE_CHECKING, Literal

from osculant.files.decimals import EXPECTED, ROUNDING, check, most_decimals, usual_decimals
from osculant.files.dialects import FEEDS, dialect_of, mismatch_in_units, program_text
from osculant.files.drafts import Draft
from osculant.files.facts import header, header_lines
from osculant.files.gcode_reading import readings
from osculant.files.motions import LARGEST_TURNING, Program
from osculant.files.round_arcs import (
    balanced_chords,
    check_room,
    chords_needed,
    circle_turn,
    circular_arcs,
    helical_arcs,
    helix_turn,
    sliding,
)
from osculant.files.space_moves import MOST_MOVES, Move, Run
from osculant.files.strokes import Bezier, Stroke, Turn

if TYPE_CHECKING:
    from osculant.files.facts import Facts
    from osculant.files.motions import Arc
    from osculant.pieces.chain import Chain
    from osculant.pieces.helices import HelixArc

#: of the largest angle, so that rounding does not reach it
BELOW = 0.999
#: of a last unit, how far a tilted helix may be moved
TILT = 0.1
STRAIGHT = 1e5  # the radius of arcs written as chords, relative to the larger extent of the spline
#: arcs of a smaller radius, in units of the last decimal, are chords: their rounded centres are nowhere near
TINY = 1.5


def gcode(
    chain: Chain,
    facts: Facts,
    room: float,
    *,
    decimals: int | None = None,
    units: Literal["mm", "inch"] | None = None,
    feed: float | None = None,
    dialect: Literal["linuxcnc", "grbl", "marlin"] = "linuxcnc",
    largest_angle: float | None = None,
    smallest_radius: float = 0.0,
    largest_radius: float | None = None,
) -> Draft:
    """Return a spline of biarcs, bihelices or segments as a G-code program that moves once along it.

    Args:
        chain: its pieces.
        facts: of the spline, recorded in the header.
        room: how far the written curve may be from the pieces, for the tolerance to be kept.
        decimals: of all coordinates; by default the fewest, at least 3, or 4 of inches, of which the last
            unit is at most a tenth of the tolerance, or the room if that does not suffice.
        units: "mm" writes `G21`, "inch" `G20`; by default neither: the machine's setting holds.
        feed: the feed rate in units a minute, written with the first motion after the start; by default 600
            of millimetres and 24 of inches, or of what units the machine has.
        dialect: of the controller, "linuxcnc", "grbl" or "marlin".
        largest_angle: arcs turn by less than so many degrees; by default half turns are allowed.
        smallest_radius: arcs of smaller radius are written as chords.
        largest_radius: arcs of larger radius are written as chords; by default 100 000 times the larger
            extent of the spline.

    Returns:
        The program, ASCII, before it is written.

    Raises:
        DomainError: a piece of a conic that is neither circle nor line; options that make no sense.
        ToleranceError: no room for the chords of helices.

    >>> import osculant as osc
    >>> half = osc.approximate(osc.curve("cos(t), sin(t)", 0, "pi"), "biarc", 1e-2)
    >>> for line in gcode(half.chain, half.facts(), 1e-2).text(None).splitlines()[-4:]:
    ...     print(line)
    G0 X1.000 Y0.000
    G3 X0.000 Y1.000 I-1.000 J0.000 F24.0
    G3 X-1.000 Y0.000 I0.000 J-1.000
    M2
    """
    check(
        decimals=decimals, units=units, feed=feed, dialect=dialect, largest_angle=largest_angle,
        smallest_radius=smallest_radius, largest_radius=largest_radius,
    )  # fmt: skip
    extent = max(high - low for low, high in zip(*chain.bounding_box()))
    if decimals is None:
        decimals = usual_decimals(facts.length_tolerance(chain), units)
        if EXPECTED * 10.0**-decimals > room * (1 + 1e-6):  # the search left less
            decimals = max(decimals, usual_decimals(room / ROUNDING, units))
        decimals = min(decimals, most_decimals(chain.largest))
    controller = dialect_of(dialect)
    program = Program(
        decimals,
        chain.pieces[0].start,
        float(chain.ends[0]),
        largest_turning=min(LARGEST_TURNING, BELOW * math.radians(largest_angle or 360.0)),
        mismatch=mismatch_in_units(controller, units, decimals),
    )
    radii = smallest_radius, STRAIGHT * extent if largest_radius is None else largest_radius
    if any(_tilted(arc, program) for arc in helical_arcs(chain)):
        check_room(room, facts.length_tolerance(chain))
    converted = _plane(program, chain, radii, room) + _space(program, chain, radii, room)
    lines = program.lines
    strokes: list[list[Stroke]] = readings(lines, chain.dimension)
    numbers = chain.dimension + sum(line.count(" ") for line in lines[1:])
    if len(lines) > 1:
        rate = FEEDS[units] if feed is None else float(feed)
        first = next((i for i, line in enumerate(lines) if line.startswith(("G1 ", "G2 ", "G3 "))), None)
        if first is not None:
            lines[first] += f" F{Decimal(repr(rate)):f}"

    def text(error: str | None) -> str:
        head = header(
            facts,
            written=error,
            chords=f"for {converted} arcs" if converted else None,
            decimals=f"{decimals}, I, J and K relative to the start of an arc",
            units="those of the curve, as the machine is set" if units is None else units,
        )
        planes = any(line in ("G18", "G19") for line in lines)
        return program_text(controller, header_lines(head), units, lines, planes)

    ends = program.ends
    if not strokes[0]:  # all of it is printed as one point
        here = tuple(number * program.unit for number in program.here)
        strokes, ends = [[Bezier((here, here))]], [ends[0], float(chain.ends[-1])]
    return Draft(
        text=text,
        readings=strokes if any(isinstance(stroke, Turn) for stroke in strokes[0]) else strokes[:1],
        ends=ends,
        moves=len(program.ends) - 1,
        numbers=numbers,
        converted=converted,
    )


def _plane(program: Program, chain: Chain, radii: tuple[float, float], room: float) -> int:
    """Move along the arcs of a chain in the plane; returns how many are chords."""
    arcs = circular_arcs(chain, "G-code")
    converted = 0
    spans = zip(chain.ends.tolist(), chain.ends[1:].tolist())
    for arc, tangent, span in zip(arcs, sliding(arcs), spans):
        if arc.kind == "segment":
            program.line(arc.end, span[1], tangent)
        else:
            converted += _turn(program, circle_turn(arc), span, tangent, radii, room)
    return converted


def _space(program: Program, chain: Chain, radii: tuple[float, float], room: float) -> int:
    """Move along the arcs of a chain in space; returns how many are chords."""
    arcs = helical_arcs(chain)
    ends = chain.ends.tolist()
    converted, run = 0, 0
    for i, (arc, tangent) in enumerate(zip(arcs, sliding(arcs))):
        helix = helix_turn(arc, TILT * program.unit)
        if arc.kind == "segment":
            program.line(arc.end, ends[i + 1], tangent)
        elif helix is not None:
            converted += _turn(program, helix, (ends[i], ends[i + 1]), tangent, radii, room)
        else:
            converted, run = converted + 1, run + 1
            after = arcs[i + 1] if i + 1 < len(arcs) else None
            if tangent is None or after is None or not _tilted(after, program):
                first = i + 1 - run
                _along(program, arcs[first : i + 1], ends[first : i + 2], radii, _room(room, program))
                run = 0
    return converted


def _along(
    program: Program,
    arcs: Sequence[HelixArc],
    ends: Sequence[float],
    radii: tuple[float, float],
    room: float,
) -> None:
    """Move along consecutive tilted helices: by chords, or by arcs too if these are fewer moves."""
    vertices, at = balanced_chords(arcs, ends, room)
    moves = None
    if len(vertices) <= MOST_MOVES:
        moves = Run(arcs, ends, room, radii, program.largest_turning).moves()
    if moves is None or len(moves) >= len(vertices):
        moves = [Move(vertex, t, None) for vertex, t in zip(vertices, at)]
    begun = ends[0]
    for move in moves:
        if move.arc is None:
            program.line(move.end, move.at)
        else:
            program.turn(move.arc, (begun, move.at))
        begun = move.at


def _tilted(arc: HelixArc, program: Program) -> bool:
    return arc.kind != "segment" and helix_turn(arc, TILT * program.unit) is None


def _room(room: float, program: Program) -> float:
    """What rounding leaves for chords."""
    return max(room - 3**0.5 / 2 * program.unit, room / 2)


def _turn(
    program: Program,
    arc: Arc,
    span: tuple[float, float],
    tangent: Sequence[float] | None,
    radii: tuple[float, float],
    room: float,
) -> bool:
    """Move along an arc, by chords if it is too straight or too small; returns whether it is so."""
    smallest, largest = radii
    if max(smallest, TINY * 10.0**-program.decimals) <= arc.radius <= largest:
        program.turn(arc, span, tangent)
        return False
    program.chords(arc.point, chords_needed(arc.chord_square, _room(room, program)), span)
    return True
