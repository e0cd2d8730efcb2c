"""The picture of README.md, by `make picture`: one curve within one tolerance, by every kind of pieces."""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
from matplotlib.figure import Figure

import osculant as osc
from osculant.primitives.table import PRIMITIVES

#: the formula, its interval, and how far pieces may be from it
CURVE, TOLERANCE = ("t*cos(t), t*sin(t)", "pi/6", "2*pi"), 1e-2
#: points on each piece
POINTS = 17
#: what the edges of polygons are called
EDGES = {"polygon": "chords"}


def picture() -> Figure:
    """A panel for each primitive of the plane, those that take the most pieces first."""
    curve = osc.curve(*CURVE)
    splines = [osc.approximate(curve, name, TOLERANCE) for name in PRIMITIVES[2]]
    splines.sort(key=len, reverse=True)
    figure = Figure(figsize=(2.4 * len(splines), 2.7), layout="constrained")
    for spline, axes in zip(splines, figure.subplots(1, len(splines)), strict=True):
        points = spline.sample(POINTS)
        for i in range(len(spline)):
            part = points[i * (POINTS - 1) : (i + 1) * (POINTS - 1) + 1]
            axes.plot(*part.T, color=("tab:blue", "tab:orange")[i % 2], linewidth=2)
        axes.plot(*points[:: POINTS - 1].T, "k.", markersize=5)
        plural = EDGES.get(spline.primitive, PRIMITIVES[2][spline.primitive].plural)
        axes.set_title(f"{len(spline)} {plural}", fontsize=13)
        axes.set_aspect("equal")
        axes.set_axis_off()
    return figure


if __name__ == "__main__":
    mpl.rcParams |= {"svg.hashsalt": "osculant", "svg.fonttype": "none"}  # the same small file every time
    picture().savefig(Path(__file__).with_name("spiral.svg"), metadata={"Date": None})
