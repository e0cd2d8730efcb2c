"""Splines as SVG: `Q` for parabolas, `A` for ellipses, `C` for cubics and hyperbolas, `L` for segments.

What is written, read with exact arithmetic, stays within a budget of the spline's exact pieces. Its parts:

* conversion: half of it, where a conic becomes cubics (`osculant.pieces.beziers` has the bound), for an `A`
  none;
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
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape

from osculant.files.facts import header, header_lines
from osculant.pieces.beziers import Ellipse, cubics, ellipse, parabola_bound
from osculant.pieces.chain import plane_arcs
from osculant.pieces.cubics import Cubic
from osculant.pieces.piece import largest_of
from osculant.tolerances import checked_budget

if TYPE_CHECKING:
    from collections.abc import Sequence

    from osculant.files.facts import Facts
    from osculant.pieces.chain import Chain
    from osculant.pieces.conics import Piece, Point
    from osculant.pieces.piece import Coordinates, PieceLike

LARGEST_RADIUS = 1e4  # of a written ellipse, relative to the piece's size
LARGEST_AMPLIFICATION = 1e3  # of the rounding of end points; every factor of ten costs all numbers a digit
LARGEST_HALF_ANGLE = math.acos(0.4)  # of a written arc, eccentric: 66°
MOST_HALVINGS = 3  # of an elliptic piece: two for the angle, one more near the rounding floor
UNIT = 2.0**-53  # the relative error of rounding
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


def svg(chain: Chain, facts: Facts, budget: float, *, knots: bool = True) -> str:
    """Return a spline as the text of an SVG file.

    Args:
        chain: its pieces, in the plane.
        facts: of the spline, recorded in the description.
        budget: how far the written curve may be from the pieces.
        knots: whether to draw the knots, as a second path with id "knots".

    Returns:
        The file's text.

    Raises:
        ToleranceError: a budget below half of the 8 rounding units.
    """
    (left, bottom), (right, top) = chain.bounding_box()
    path, decimals = path_data(chain.pieces, budget)
    dots = [chain.pieces[0].start, *(piece.end for piece in chain.pieces)]
    if facts.closed and _pair(dots[0], decimals) == _pair(dots[-1], decimals):
        path += "\nZ"
    margin = MARGIN * max(right - left, top - bottom)
    width, height = right - left + 2 * margin, top - bottom + 2 * margin
    digits = 2 - math.floor(math.log10(margin))
    view = " ".join(number(value, digits) for value in (left - margin, -top - margin, width, height))
    pixel = max(width, height) / SIDE
    description = "\n".join(header_lines(header(facts, budget)))
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
    if knots:
        marks = "\n".join(f"M{_pair(dot, decimals)}h0" for dot in dots)
        lines.append(
            f'<path id="knots" stroke="#c0392b" stroke-width="{5 * pixel:.3g}" {stroke} d="{marks}"/>'
        )
    return "\n".join([*lines, "</g>", "</svg>", ""])


def path_data(pieces: Sequence[PieceLike], budget: float) -> tuple[str, int]:
    r"""Return joined pieces as the data of one SVG path, and the number of decimals of its coordinates.

    Args:
        pieces: pieces each of which starts where the one before ends.
        budget: how far the path may be from them.

    Raises:
        ToleranceError: a budget below half of the 8 rounding units of the largest coordinate.

    >>> from osculant.pieces.conics import Piece
    >>> path_data([Piece("parabola", (0, 1), (0.0, 0.0), (2.0, 0.0), (1.0, 1.0), 1.0, 0.0)], 1e-3)[0]
    'M0 0\nQ1 1 2 0'
    >>> path_data([Piece("ellipse", (0, 1), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), 0.0, 0.0)], 1e-3)[0]
    'M1 0\nA1 1 0 0 1 0 1\nA1 1 0 0 1 -1 0'
    """
    checked_budget(budget, largest_of(piece.bounding_box() for piece in pieces))
    commands = [command for arc in plane_arcs(pieces) for command in _commands(arc, budget)]
    amplification = max(command.amplification for command in commands)
    # Rounding to d decimals moves a point by at most 10⁻ᵈ/√2.
    decimals = math.ceil(-math.log10(math.sqrt(2) * budget / (4 * amplification)))
    start = f"M{_pair(pieces[0].start, decimals)}"
    return "\n".join([start, *(_write(command, decimals) for command in commands)]), decimals


def number(value: float, decimals: int) -> str:
    """Return the shortest text that reads back as the value rounded to so many decimals.

    >>> number(0.1 + 0.2, 3), number(-1e-9, 3), number(1e-9, 12), number(2.0, 300)
    ('0.3', '0', '1e-09', '2')
    """
    rounded = round(float(value), decimals) + 0.0  # + 0.0 turns −0 to 0
    return repr(rounded).removesuffix(".0")


def _commands(piece: Piece | Cubic, budget: float) -> list[Command]:
    """Return the path commands of one piece, converted to within half the budget."""
    if isinstance(piece, Cubic):
        return [Command("C", (*piece.controls, piece.end))]
    if piece.kind == "segment":
        return [Command("L", (piece.end,))]
    if parabola_bound(piece) <= budget / 2:
        (x, y), (ax, ay), w = piece.start, piece.legs[0], piece.weight
        return [Command("Q", ((x + ax / w, y + ay / w), piece.end))]
    arcs = _arcs(piece, budget) if piece.weight < 1 else None
    return arcs or [Command("C", cubic) for cubic in cubics(piece, budget / 2)]


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
