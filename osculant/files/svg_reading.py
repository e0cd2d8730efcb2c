"""What the data of an SVG path draw, by the rules of SVG 2 for readers."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from osculant.files.strokes import Bezier, Stroke, elliptic
from osculant.pieces.piece import Coordinates

#: a command and its numbers
COMMAND = re.compile(r"([MLQCAZ])([^MLQCAZ]*)")


def strokes_of(data: str) -> list[Stroke]:
    """The strokes of a path of absolute commands M, L, Q, C, A and Z, one each but for M and Z.

    >>> strokes_of("M0 0 L2 0 A1 1 0 0 1 3 1")[1].weights[1] ** 2
    0.5000000000000001
    """
    found: list[Stroke] = []
    here: Coordinates = (0.0, 0.0)
    for letter, text in COMMAND.findall(data):
        numbers = [float(word) for word in text.split()]
        if letter == "Z":
            continue
        end = (numbers[-2], numbers[-1])
        if letter == "A":
            found.append(_arc(here, end, numbers))
        elif letter != "M":
            points = list(zip(numbers[::2], numbers[1::2]))
            found.append(Bezier((here, *points)))
        here = end
    return found


def _arc(start: Coordinates, end: Coordinates, numbers: Sequence[float]) -> Bezier:
    """An elliptic arc, from its ends to its centre; radii that are too small grow until the ends fit."""
    a, b, degrees, large, sweep = numbers[:5]
    if start == end or not a or not b:
        return Bezier((start, end))
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    # half the chord, in the frame of the axes where the ellipse is the unit circle
    dx, dy = (start[0] - end[0]) / 2, (start[1] - end[1]) / 2
    x, y = (c * dx + s * dy) / a, (c * dy - s * dx) / b
    square = x * x + y * y
    if square > 1:
        grown = math.sqrt(square)
        a, b, x, y, square = a * grown, b * grown, x / grown, y / grown, 1.0
    away = math.sqrt(max(0.0, 1 / square - 1)) * (1 if (large != 0) != (sweep != 0) else -1)
    u, v = away * y, -away * x
    centre = (
        (start[0] + end[0]) / 2 + c * a * u - s * b * v,
        (start[1] + end[1]) / 2 + s * a * u + c * b * v,
    )
    first, last = math.atan2(y - v, x - u), math.atan2(-y - v, -x - u)
    turned = (last - first) % math.tau - (0.0 if sweep else math.tau)
    return elliptic(centre, (c * a, s * a), (-s * b, c * b), first, first + turned, (start, end))
