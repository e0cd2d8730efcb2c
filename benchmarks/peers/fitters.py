"""Who approximates curves by arcs, parabolas or cubics: osculant twice, and peers.

Peers that cannot take a formula get a spline that is a hundred times as near to the curve; making it is not
timed.  Each is asked for the same tolerance in its own terms.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

import osculant as osc
from benchmarks.kurbo import by_kurbopy
from benchmarks.peers.contest import AbsentError, Job, installed
from benchmarks.peers.splines import arc, bezier, of_pieces
from osculant.approximation.arcs import Arcs
from osculant.approximation.division import divide
from osculant.approximation.fitting import Fitting
from osculant.curves.extent import extent
from osculant.kernels import search
from osculant.primitives.table import choose
from osculant.tolerances import window

#: what peers get is so much nearer than what they are asked for
NEARER = 100
#: points through which OpenCASCADE's curve goes, and the angle between its arcs that it is allowed
THROUGH, ANGLE = 4000, 1e-3
#: (curve, tolerance) → what is timed
Peer = Callable[[Any, float], Job]


def ours(primitive: str, curve: Any, tolerance: float) -> Job:
    """`osculant.approximate` on a curve that it knows."""
    return Job(lambda: osc.approximate(curve, primitive, tolerance), lambda s: of_pieces(s.pieces))


def kernel(primitive: str, curve: Any, tolerance: float) -> Job:
    """The compiled search alone, its arguments made before."""
    fit = choose(primitive, "hausdorff", dimension=2, curve=curve.text)
    fitting = Fitting(curve, fit, divide(curve, primitive), extent(curve), tolerance)
    ends = window(tolerance, fitting.rounding)
    parts = [part for part in fitting.parts if isinstance(part, Arcs)]
    if len(parts) < len(fitting.parts):
        raise AbsentError("parts of the curve are the primitive itself")
    jobs = [(part, part.job(*ends)) for part in parts]  # parts own the curve's machine code
    tables = [np.empty((8192, part.columns)) for part in parts]

    def run() -> list[int]:
        return [search.spline(*job, table)[0] for (_, job), table in zip(jobs, tables)]

    def read(counts: list[int]) -> Any:
        found = zip(parts, tables, counts)
        return of_pieces([p for part, rows, n in found for p in part.pieces(part._run(rows[:n].copy()))])

    return Job(run, read)


def kurbo(curve: Any, tolerance: float) -> Job:
    """kurbopy's `fit_to_bezpath`, which asks a Python function for the curve."""
    installed("kurbopy")
    fit, read = by_kurbopy(curve, tolerance)
    return Job(fit, lambda path: np.array([bezier(*four) for four in read(path)]))


def _cubics(curve: Any, tolerance: float) -> list[list[tuple[float, float]]]:
    """Control points of cubics near a curve, ends shared."""
    pieces = osc.approximate(curve, "cubic", tolerance).pieces
    return [[p.start, *p.controls, p.end] for p in pieces]


def cu2qu(curve: Any, tolerance: float) -> Job:
    """fontTools' parabolas for cubics."""
    installed("fonttools")
    from fontTools.cu2qu import curve_to_quadratic
    from fontTools.cu2qu.errors import ApproxNotFoundError

    cubics = _cubics(curve, tolerance / NEARER)

    def run() -> list[Any]:
        return [curve_to_quadratic(four, tolerance) for four in cubics]

    def read(splines: list[Any]) -> Any:
        made = []
        for points in splines:
            start, *inner, end = points
            for i, control in enumerate(inner):
                after = end
                if i + 1 < len(inner):  # a point between two controls is implied
                    after = tuple((p + q) / 2 for p, q in zip(control, inner[i + 1]))
                made.append(bezier(start, control, after))
                start = after
        return np.array(made)

    try:
        run()
    except ApproxNotFoundError:
        raise AbsentError("more than 100 parabolas for a cubic") from None
    return Job(run, read)


def qu2cu(curve: Any, tolerance: float) -> Job:
    """fontTools' cubics for parabolas."""
    installed("fonttools")
    from fontTools.qu2cu import quadratic_to_curves

    pieces = osc.approximate(curve, "parabola", tolerance / NEARER).pieces
    ends = [pieces[0].start, *(p.end for p in pieces)]
    quads = [(ends[i], p.control_point or p.middle, ends[i + 1]) for i, p in enumerate(pieces)]
    return Job(
        partial(quadratic_to_curves, quads, tolerance, True),
        lambda found: np.array([bezier(*points) for points in found]),
    )


def opencascade(curve: Any, tolerance: float) -> Job:
    """OpenCASCADE's arcs and segments for a B-spline through many points of the curve."""
    installed("cadquery-ocp-novtk")
    from OCP.collections import HArray1_gp_Pnt2d
    from OCP.Geom2dAdaptor import Geom2dAdaptor_Curve
    from OCP.Geom2dAPI import Geom2dAPI_Interpolate
    from OCP.Geom2dConvert import Geom2dConvert_ApproxArcsSegments
    from OCP.gp import gp_Pnt2d

    points = HArray1_gp_Pnt2d(1, THROUGH)
    for i, (x, y) in enumerate(curve.jets(np.linspace(*curve.interval, THROUGH))[..., 0].tolist()):
        points.SetValue(i + 1, gp_Pnt2d(x, y))
    through = Geom2dAPI_Interpolate(points, False, 1e-14)
    through.Perform()
    source = through.Curve()
    adaptor = Geom2dAdaptor_Curve(source)

    def run() -> Any:
        return Geom2dConvert_ApproxArcsSegments(adaptor, tolerance, ANGLE).GetResult()

    def read(found: Any) -> Any:
        made = []
        for i in range(found.Size()):
            one = found.Value(i + 1)
            low, high = one.FirstParameter(), one.LastParameter()
            made.append(arc(*((p.X(), p.Y()) for p in map(one.Value, (low, (low + high) / 2, high)))))
        return np.array(made)

    return Job(run, read)


def svgelements(curve: Any, tolerance: float) -> Job:
    """svgelements' arcs for cubics; it asks for an error in parts of the radius, here that in the middle."""
    installed("svgelements")
    from svgelements import CubicBezier

    cubics = []
    for four in _cubics(curve, tolerance / NEARER):
        (x0, y0), (x1, y1), (x2, y2), (x3, y3) = four
        dx, dy = (
            x3 + x2 - x1 - x0,
            y3 + y2 - y1 - y0,
        )  # 4/3 of the middle's derivative
        ax, ay = x3 - x2 - x1 + x0, y3 - y2 - y1 + y0  # a third of the second one
        curvature = abs(dx * ay - dy * ax) * 16 / 3 / math.hypot(dx, dy) ** 3
        cubics.append((CubicBezier(*map(complex, (x0, x1, x2, x3), (y0, y1, y2, y3))), tolerance * curvature))

    def run() -> list[Any]:
        return [found for cubic, error in cubics for found in cubic.as_circular_arcs(error=error)]

    def read(found: list[Any]) -> Any:
        return np.array([arc(*((p.x, p.y) for p in map(one.point, (0.0, 0.5, 1.0)))) for one in found])

    try:
        run()
    except RecursionError:
        raise AbsentError("it halves a cubic without end") from None
    return Job(run, read)


#: by what is compared, who does it
FAMILIES: dict[str, dict[str, Peer]] = {
    "cubics": {
        "osculant": partial(ours, "cubic"),
        "its kernel": partial(kernel, "cubic"),
        "kurbopy": kurbo,
        "qu2cu": qu2cu,
    },
    "parabolas": {
        "osculant": partial(ours, "parabola"),
        "its kernel": partial(kernel, "parabola"),
        "cu2qu": cu2qu,
    },
    "arcs": {
        "osculant": partial(ours, "biarc"),
        "its kernel": partial(kernel, "biarc"),
        "OpenCASCADE": opencascade,
        "svgelements": svgelements,
    },
    "conics": {"osculant": partial(ours, "conic"), "its kernel": partial(kernel, "conic")},
}
