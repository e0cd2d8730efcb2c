"""A controller of our own: what programs do, read from their text alone, and how far that is from curves."""

from __future__ import annotations

import math
import re
from fractions import Fraction

import numpy as np
from mpmath import mp
from scipy.spatial import cKDTree

PLANES = {"G17": "XYZ", "G18": "ZXY", "G19": "YZX"}  # the last one is seen from its + side
COMMENTS = {"(": ")", ";": ""}
ENDS = ("M2", "M400")


def interpret(text):
    """Return the start and the moves: (letter, {start}, {end}, {centre}, plane), numbers as fractions."""
    here, start, plane, moves, feed = {}, None, "G17", [], None
    *lines, end = text.splitlines()
    assert end in ENDS and text.endswith("\n")
    modes = set()
    for line in lines:
        assert line.isascii() and len(line) <= 120
        if line[0] in COMMENTS:
            assert line[0] == ";" or line.count("(") == line.count(")") == 1
            assert line.endswith(COMMENTS[line[0]])
            continue
        words = re.fullmatch(r"(?:[A-Z]-?\d+(?:\.\d+)? ?)+", line + " ")
        assert words, line
        words = line.split()
        if words[0] not in ("G0", "G1", "G2", "G3"):
            modes |= set(words)
        for word in words:
            plane = word if word in PLANES else plane
            feed = float(word[1:]) if word[0] == "F" else feed
        numbers = {word[0]: Fraction(word[1:]) for word in words if word[0] in "XYZIJK"}
        there = {**here, **{axis: numbers[axis] for axis in "XYZ" if axis in numbers}}
        if words[0] == "G0":
            assert start is None and "G90" in modes
            start = there
        elif words[0] in ("G1", "G2", "G3"):
            assert feed is not None and feed > 0, "a motion without a feed rate"
            offsets = dict(zip("XYZ", "IJK"))
            centre = {axis: here[axis] + numbers[o] for axis, o in offsets.items() if o in numbers}
            assert len(centre) == (0 if words[0] == "G1" else 2)
            moves.append((words[0], here, there, centre, PLANES[plane]))
        here = there
    return start, moves


def mismatch(move):
    """The difference of the two radii of an arc as printed, at 50 digits."""
    _, start, end, centre, _ = move
    with mp.workdps(50):
        radii = [
            mp.sqrt(sum(mp.mpf(d.numerator) ** 2 / mp.mpf(d.denominator) ** 2 for d in away))
            for away in ([p[axis] - centre[axis] for axis in centre] for p in (start, end))
        ]
        return abs(radii[0] - radii[1])


def sweep(move):
    """Angle at the start and signed angle turned by, by the sense of the word alone."""
    letter, start, end, centre, (a, b, _) = move
    angles = [math.atan2(float(p[b] - centre[b]), float(p[a] - centre[a])) for p in (start, end)]
    turned = (angles[1] - angles[0]) % math.tau
    return angles[0], turned if letter == "G3" else turned - math.tau


def trace(move, n=9, radius="even"):
    """Points of a move, the third coordinate growing evenly; shape (n, 2 or 3).

    The radius grows evenly, or is that of the start, "first", or of the end, "last".
    """
    letter, start, end, centre, plane = move
    axes = sorted(start)
    f = np.linspace(0, 1, n)
    points = {axis: float(start[axis]) + f * float(end[axis] - start[axis]) for axis in axes}
    if letter != "G1":
        a, b, _ = plane
        first, turned = sweep(move)
        radii = [math.hypot(*(float(p[axis] - centre[axis]) for axis in (a, b))) for p in (start, end)]
        radius = {"first": radii[0], "last": radii[1], "even": radii[0] + f * (radii[1] - radii[0])}[radius]
        angle = first + f * turned
        points[a], points[b] = (
            float(centre[a]) + radius * np.cos(angle),
            float(centre[b]) + radius * np.sin(angle),
        )
    return np.stack([points[axis] for axis in axes], axis=-1)


def path_of(text, radius="even", n=1001):
    """Points along a whole program."""
    return np.concatenate([trace(move, n, radius) for move in interpret(text)[1]])


def two_sided(path, curve):
    """The Hausdorff distance of two polygons with many vertices, from vertices to polygons."""
    return max(one_sided(path, curve), one_sided(curve, path))


def one_sided(points, polygon):
    """The largest distance of points from a polygon whose edges are short."""
    nearest = cKDTree(polygon).query(points, k=min(8, len(polygon)))[1].reshape(len(points), -1)
    best = np.full(len(points), np.inf)
    for column in nearest.T:
        for i in (column - 1, column):
            i = np.clip(i, 0, len(polygon) - 2)
            a, d = polygon[i], polygon[i + 1] - polygon[i]
            square = np.maximum((d * d).sum(axis=1), 1e-300)
            f = np.clip(((points - a) * d).sum(axis=1) / square, 0, 1)
            best = np.minimum(best, np.linalg.norm(points - a - f[:, None] * d, axis=1))
    return float(best.max())


def along(function, a, b, n=40_001):
    """Points of a curve given as a function of arrays."""
    t = np.linspace(a, b, n)
    return np.stack([np.broadcast_to(x, t.shape) for x in function(t)], axis=-1).astype(float)
