"""The paths of G-code programs: what controllers make of the numbers that are printed."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from osculant.files.strokes import Bezier, Stroke, Turn

PLANES = {"G17": 2, "G18": 1, "G19": 0}
WORD = re.compile(r"([A-Z])(-?[0-9.]+)")


def readings(lines: Sequence[str], dimension: int) -> list[list[Stroke]]:
    """The strokes of motions, for controllers that keep an arc's first radius, and its last.

    Args:
        lines: one motion each, the first to the start; or a plane, G17, G18 or G19.
        dimension: 2 or 3.

    >>> first, last = readings(["G0 X0 Y0", "G3 X2.1 Y0 I1 J0"], 2)
    >>> first[0].radii, last[0].radii
    ((1.0, 1.0), (1.1, 1.1))
    """
    first: list[Stroke] = []
    last: list[Stroke] = []
    here, plane = [0.0] * dimension, 2
    for line in lines:
        command, _, rest = line.partition(" ")
        if command in PLANES:
            plane = PLANES[command]
            continue
        words = {letter: float(text) for letter, text in WORD.findall(rest)}
        there = [words.get(letter, x) for letter, x in zip("XYZ", here)]
        if command == "G1":
            first.append(Bezier((tuple(here), tuple(there))))
            last.append(first[-1])
        elif command != "G0":
            begun, ended = _turns(here, there, words, plane, command == "G3")
            first.append(begun)
            last.append(ended)
        here = there
    return [first, last]


def _turns(
    here: Sequence[float], there: Sequence[float], words: dict[str, float], axis: int, positive: bool
) -> tuple[Turn, Turn]:
    """The two readings of an arc."""
    a, b = (axis + 1) % 3, (axis + 2) % 3
    offset = [words.get(letter, 0.0) for letter in "IJK"]
    centre = [x + offset[k] for k, x in enumerate(here)]
    spans = [(p[a] - centre[a], p[b] - centre[b]) for p in (here, there)]
    radii = [math.hypot(*span) for span in spans]
    begun, ended = (math.atan2(v, u) for u, v in spans)
    turned = (ended - begun) % math.tau
    angles = begun, begun + (turned if positive else turned - math.tau)
    heights = (here[axis], there[axis]) if len(here) == 3 else (0.0, 0.0)
    first, last = (Turn(tuple(centre), axis, (radius, radius), angles, heights) for radius in radii)
    return first, last
