"""Splines as SVG: `Q` for parabolas, `A` for ellipses, `C` for cubics and hyperbolas, `L` for segments.

What is written, read with exact arithmetic, stays within a budget of the spline's exact pieces; where a conic
becomes cubics (`osculant.pieces.beziers` has the bound) it has a share of its own. The parts of the budget:

* half of it for cubics, if nothing else is said, for an `A` none;
* rounding of coordinates to the printed digits: a quarter. A Bézier curve moves no more than its control
  points; an elliptic arc, whose radii are given and not its centre, moves up to `amplification` times more
  than its ends;
* rounding of the printed radii and rotation of an `A`: a quarter; and of the arithmetic before: the rest.

An elliptic arc is cut where its eccentric angle would exceed 2·66°: near a half turn the centre that an SVG
reader computes depends on the digits like a square root, and the arc may not exist at all after rounding. So
the large-arc flag is never set, and arcs that turn by π or more are ordinary. Arcs of too large or too slim
an ellipse for stable digits are written as cubics. Coordinates are mathematical, y upwards: the picture's
group mirrors them, and the flags and rotations hold inside it. The path never breaks, not at cusps either;
that of a closed spline ends with `Z`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import escape

from osculant.files.drafts import Draft
from osculant.files.facts import header, header_lines
from osculant.files.svg_reading import strokes_of
from osculant.pieces.beziers import Ellipse, cubics, ellipse, parabola_bound
from osculant.pieces.chain import plane_arcs
from osculant.pieces.cubics import Cubic
from osculant.pieces.piece import largest_of
from osculant.tolerances import checked_budget, writing_share

if TYPE_CHECKING:
    from osculant.files.facts import Facts
    from osculant.pieces.chain import Chain
    from osculant.pieces.conics import Piece, Point
    from osculant.pieces.piece import Coordinates, PieceLike

LARGEST_RADIUS = 1e4  # of a written ellipse, relative to the piece's size
LARGEST_AMPLIFICATION = 1e3  # of the rounding of end points; every factor of ten costs all numbers a digit
LARGEST_HALF_ANGLE = math.acos(0.4)  # of a written arc, eccentric: 66°
MOST_HALVINGS = 3  # of an elliptic piece: two for the angle, one more near the rounding floor
UNIT = 2.0**-53  # the relative error of rounding
#: of the tolerance, what is kept for rounding; with hyperbolas, what is tried for the cubics besides
ROUNDED, CONVERTED = 1e-3, (0.05, 0.3)
#: how many numbers a command has
NUMBERS = {"L": 2, "Q": 4, "C": 6, "A": 7}
SIDE = 800  # of the picture's longer side, pixels
MARGIN = 0.04  # around the curve, relative to its larger extent


@dataclass(frozen=True)
class Command:
    """One path command before its numbers are rounded.

    Attributes:
        letter: "L", "Q", "C" or "A".
        points: the points it names, the end last.
        arc: of an "A": larger and smaller radius, rotation in degrees, each with the error allowed to it.
        sweep: of an "A": whether its angle increases.
        amplification: how many times more than its end points the curve may move.
    """

    letter: str
    points: tuple[Point, ...]
    arc: tuple[tuple[float, float], ...] = ()
    sweep: bool = False
    amplification: float = 1.0


def needs(tolerance: float, kinds: Collection[str], **options: Any) -> tuple[float, ...]:
    """What to keep for writing, as lengths: each is worth a trial, and the first if nothing is converted.

    Args:
        tolerance: of the spline, as a length.
        kinds: of the arcs that the spline may have.
        options: those of `svg`.

    >>> needs(1.0, ["parabola"]), needs(1.0, ["hyperbola"])
    ((0.001,), (0.001, 0.05, 0.3))
    """
    return tuple(share * tolerance for share in (ROUNDED, *(CONVERTED if "hyperbola" in kinds else ())))


def svg(chain: Chain, facts: Facts, room: float, *, knots: bool = True) -> Draft:
    """Return a spline as an SVG file.

    Args:
        chain: its pieces, in the plane.
        facts: of the spline, recorded in the description.
        room: how far the written curve may be from the pieces.
        knots: whether to draw the knots, as a second path with id "knots".

    Returns:
        The file before it is written.

    Raises:
        ToleranceError: a room below half of the 8 rounding units.
    """
    rounding = min(room, ROUNDED * facts.length_tolerance(chain))
    rounding = max(rounding, min(room, writing_share(0.0, math.ulp(chain.largest)) / 2))
    groups, decimals = path_commands(chain.pieces, rounding, room - rounding / 2)
    commands = [command for group in groups for command in group]
    path = joined(chain.pieces[0].start, commands, decimals)
    ends = [float(chain.ends[0])]
    for group, (a, b) in zip(groups, pairwise(chain.ends.tolist())):
        ends += [a + (k + 1) / len(group) * (b - a) for k in range(len(group))]
    dots = [chain.pieces[0].start, *(piece.end for piece in chain.pieces)]
    closed = facts.closed and _pair(dots[0], decimals) == _pair(dots[-1], decimals)
    return Draft(
        text=lambda error: _document(
            chain, facts, path + "\nZ" * closed, dots if knots else [], decimals, error
        ),
        readings=[strokes_of(path)],
        ends=ends,
        moves=len(commands),
        numbers=2 + sum(NUMBERS[command.letter] for command in commands),
        converted=sum(arc.kind == "hyperbola" for arc in chain.arcs),
    )


def _document(
    chain: Chain, facts: Facts, path: str, dots: Sequence[Coordinates], decimals: int, error: str | None
) -> str:
    """The file's text, with points at the knots."""
    (left, bottom), (right, top) = chain.bounding_box()
    margin = MARGIN * max(right - left, top - bottom)
    width, height = right - left + 2 * margin, top - bottom + 2 * margin
    digits = 2 - math.floor(math.log10(margin))
    view = " ".join(number(value, digits) for value in (left - margin, -top - margin, width, height))
    pixel = max(width, height) / SIDE
    description = "\n".join(header_lines(header(facts, written=error)))
    stroke = 'stroke-linecap="round" stroke-linejoin="round"'
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{view}" width="{math.ceil(width / pixel)}" '
        f'height="{math.ceil(height / pixel)}">',
        f"<title>{_text(facts.curve)}</title>",
        f"<desc>{_text(description)}</desc>",
        '<g transform="scale(1,-1)" fill="none">',
        f'<path id="spline" stroke="#1f4e79" stroke-width="{1.5 * pixel:.3g}" {stroke} d="{path}"/>',
    ]
    if dots:
        marks = "\n".join(f"M{_pair(dot, decimals)}h0" for dot in dots)
        lines.append(
            f'<path id="knots" stroke="#c0392b" stroke-width="{5 * pixel:.3g}" {stroke} d="{marks}"/>'
        )
    return "\n".join([*lines, "</g>", "</svg>", ""])


def path_data(pieces: Sequence[PieceLike], budget: float, conversion: float | None = None) -> tuple[str, int]:
    r"""Return joined pieces as the data of one SVG path, and the number of decimals of its coordinates.

    Args:
        pieces: pieces each of which starts where the one before ends.
        budget: how far the path may be from them.
        conversion: how far, rounding aside, where others stand for them; by default half the budget.

    Raises:
        ToleranceError: a budget below half of the 8 rounding units of the largest coordinate.

    >>> from osculant.pieces.conics import Piece
    >>> path_data([Piece("parabola", (0, 1), (0.0, 0.0), (2.0, 0.0), (1.0, 1.0), 1.0, 0.0)], 1e-3)[0]
    'M0 0\nQ1 1 2 0'
    >>> path_data([Piece("ellipse", (0, 1), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), 0.0, 0.0)], 1e-3)[0]
    'M1 0\nA1 1 0 0 1 0 1\nA1 1 0 0 1 -1 0'
    """
    groups, decimals = path_commands(pieces, budget, budget / 2 if conversion is None else conversion)
    return joined(pieces[0].start, [command for group in groups for command in group], decimals), decimals


def path_commands(
    pieces: Sequence[PieceLike], budget: float, conversion: float
) -> tuple[list[list[Command]], int]:
    """The commands of each arc of joined pieces, and the number of decimals: `path_data` writes them."""
    checked_budget(budget, largest_of(piece.bounding_box() for piece in pieces))
    groups = [_commands(arc, budget, conversion) for arc in plane_arcs(pieces)]
    amplification = max(command.amplification for group in groups for command in group)
    # Rounding to d decimals moves a point by at most 10⁻ᵈ/√2.
    return groups, math.ceil(-math.log10(math.sqrt(2) * budget / (4 * amplification)))


def joined(start: Coordinates, commands: Sequence[Command], decimals: int) -> str:
    """Commands as the data of one path."""
    return "\n".join([f"M{_pair(start, decimals)}", *(_write(command, decimals) for command in commands)])


def number(value: float, decimals: int) -> str:
    """Return the shortest text that reads back as the value rounded to so many decimals.

    >>> number(0.1 + 0.2, 3), number(-1e-9, 3), number(1e-9, 12), number(2.0, 300)
    ('0.3', '0', '1e-09', '2')
    """
    rounded = round(float(value), decimals) + 0.0  # + 0.0 turns −0 to 0
    return repr(rounded).removesuffix(".0")


def _commands(piece: Piece | Cubic, budget: float, conversion: float) -> list[Command]:
    """Return the path commands of one piece, others standing for it to within the conversion."""
    if isinstance(piece, Cubic):
        return [Command("C", (*piece.controls, piece.end))]
    if piece.kind == "segment":
        return [Command("L", (piece.end,))]
    if parabola_bound(piece) <= conversion:
        (x, y), (ax, ay), w = piece.start, piece.legs[0], piece.weight
        return [Command("Q", ((x + ax / w, y + ay / w), piece.end))]
    arcs = _arcs(piece, budget) if piece.weight < 1 else None
    return arcs or [Command("C", cubic) for cubic in cubics(piece, conversion)]


def _arcs(piece: Piece, budget: float) -> list[Command] | None:
    """Return an elliptic piece as `A` commands, or None if their digits would be unstable."""
    size = math.hypot(*piece.legs[2]) + math.hypot(*piece.bulge) / (1 + piece.weight)
    for halvings in range(MOST_HALVINGS + 1):
        conic = ellipse(piece, halvings)
        if piece.kind == "arc":
            (ax, ay), _, (cx, cy) = piece.legs
            radius = math.hypot(cx, cy) ** 2 * math.hypot(ax, ay) / (2 * abs(ax * cy - ay * cx))
            conic = replace(conic, radii=(radius, radius), rotation=0.0)
        major, minor = conic.radii
        if not minor * LARGEST_AMPLIFICATION > major or not major < LARGEST_RADIUS * size:
            return None
        if conic.half_angle <= LARGEST_HALF_ANGLE:
            arcs = _printed(piece, conic, budget)
            if arcs is not None:
                return arcs
    return None


def _printed(piece: Piece, conic: Ellipse, budget: float) -> list[Command] | None:
    """Return the arcs of an ellipse as `A` commands, or None if their error may be beyond the budget.

    In the affine frame where the ellipse is the unit circle let the printed one be given by the form I + Δ,
    and let 2θ be the angle of one arc. Between fixed ends it is off by at most |Δ|(2 + 1/cos θ)/(2 cos θ) of
    the arc's height, to first order; relative changes ρ of a radius contribute 2ρ to |Δ|, a rotation by α
    contributes α(a/b − b/a), a and b being the semi-axes. Moving the ends by r moves the arc by at most
    r(2 + (a/b + b/a)·tan θ).
    """
    major, minor = conic.radii
    stretch, skew = major / minor + minor / major, (major - minor) / minor * (1 + minor / major)
    cosine = math.cos(conic.half_angle)
    gain = 1.25 * (2 + 1 / cosine) / (2 * cosine) * conic.height  # a quarter for the second order
    amplification = 2 + stretch * math.tan(conic.half_angle)
    noise = gain * UNIT * (2 + 4 * skew)  # of radii and rotation as floats, and then of inner ends
    if len(conic.ends) > 1:
        noise += amplification * math.ulp(largest_of([piece.bounding_box()])) / math.sqrt(2)
    if amplification > LARGEST_AMPLIFICATION or noise > budget / 2:
        return None
    relative = min(1e-3, budget / (16 * gain))
    if relative > math.pi / 2 * skew:  # as good as a circle: any rotation will do
        rotation, turn = 0.0, 1.0
    else:
        rotation, turn = math.degrees(conic.rotation), math.degrees(relative / skew)
    arc = ((major, relative * major), (minor, relative * minor), (rotation, turn))
    return [Command("A", (end,), arc, conic.positive, amplification) for end in conic.ends]


def _write(command: Command, decimals: int) -> str:
    """Return a command with its numbers rounded."""
    points = " ".join(_pair(point, decimals) for point in command.points)
    if command.letter != "A":
        return command.letter + points
    axes = " ".join(number(value, _decimals(error)) for value, error in command.arc)
    return f"A{axes} 0 {int(command.sweep)} {points}"


def _pair(point: Coordinates, decimals: int) -> str:
    return f"{number(point[0], decimals)} {number(point[1], decimals)}"


def _decimals(error: float) -> int:
    """Return the least number of decimals with which rounding stays within the error."""
    return math.ceil(-math.log10(2 * error))


def _text(text: str) -> str:
    """Escape text for XML; characters that XML cannot hold become U+FFFD."""
    return escape(re.sub(r"[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "\ufffd", text))
