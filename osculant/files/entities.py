"""Arcs of the plane as entities of a DXF drawing, and what those draw, by their own numbers.

A bulge is tan(θ/4) for an arc that turns by θ between two vertices, so that nearly straight arcs are as good
as any. An ARC has a centre, a radius and angles in degrees instead, and an ELLIPSE a centre, an axis and
eccentric angles: where their rounding would move it by more than a few rounding units, the arc is a
LWPOLYLINE of its own, or a SPLINE. A rational SPLINE of degree two with double knots is its conics exactly:
of weight w between weights 1, those of w near 0 or less in halves.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import groupby, pairwise
from typing import TYPE_CHECKING, Any

from osculant.files.strokes import Bezier, Stroke, bulged, elliptic
from osculant.pieces.beziers import ellipse
from osculant.pieces.cubics import Cubic
from osculant.pieces.piece import largest_of
from osculant.tolerances import writing_share

if TYPE_CHECKING:
    from osculant.pieces.conics import Piece, Point
    from osculant.pieces.piece import Coordinates

LARGEST_TURNING = 1.01 * math.pi  # of one bulge; more is cut in halves
LEAST_WEIGHT = 0.25  # of a conic in a SPLINE; others are cut in halves
UNIT = 2.0**-53  # the relative error of rounding
SLIMMEST = 1e-5  # the least ratio of the axes of an ELLIPSE
ROUND = ("segment", "arc")


class Drawing:
    """A model space and what was drawn in it.

    Args:
        space: of ezdxf.
        attributes: of all entities.
        at: the curve's parameter where the first stroke begins.
        noise: by how much the digits of an ARC or an ELLIPSE may move it.

    Attributes:
        strokes: of all entities, in order.
        ends: the curve's parameters where they begin and end.
        numbers: that entities hold for them.
    """

    def __init__(self, space: Any, attributes: dict[str, str], at: float, noise: float = 0.0) -> None:
        self.space, self.attributes, self.noise = space, attributes, noise
        self.strokes: list[Stroke] = []
        self.ends, self.numbers = [at], 0

    def polygon(self, points: Sequence[Coordinates], at: Sequence[float]) -> None:
        """Add a POLYLINE in space."""
        self.space.add_polyline3d(points, dxfattribs=self.attributes)
        self.strokes += [Bezier((tuple(p), tuple(q))) for p, q in pairwise(points)]
        self.ends += at
        self.numbers += 3 * len(points)

    def plane(self, arcs: Sequence[Piece | Cubic], ends: Sequence[float], *, each: bool) -> None:
        """Add arcs of conics and lines as few entities, or each as one.

        Args:
            arcs: end to end.
            ends: the curve's parameters where they begin and end.
            each: whether every arc is an entity of its own.
        """
        spans = list(zip(arcs, pairwise(ends)))
        if each:
            for arc, span in spans:
                if isinstance(arc, Cubic):
                    self._cubics([(arc, span)])
                elif arc.kind in ROUND:
                    self._arc(arc, span)
                elif arc.kind != "ellipse" or not self._ellipse(arc, span):
                    self._spline([(arc, span)])
            return
        for kind, group in groupby(spans, key=lambda pair: _family(pair[0])):
            chosen = list(group)
            conics = [(arc, span) for arc, span in chosen if not isinstance(arc, Cubic)]
            if kind == "round":
                self._polyline(conics, may_close=len(conics) == len(arcs))
            elif kind == "conic":
                self._spline(conics)
            else:
                self._cubics([(arc, span) for arc, span in chosen if isinstance(arc, Cubic)])

    def _add(self, strokes: Sequence[Stroke], span: tuple[float, float]) -> None:
        """Note strokes that share a span of the curve's parameter."""
        a, b = span
        self.strokes += strokes
        self.ends += [a + (k + 1) / len(strokes) * (b - a) for k in range(len(strokes))]

    def _polyline(
        self, arcs: Sequence[tuple[Piece, tuple[float, float]]], *, may_close: bool = False
    ) -> None:
        """Add arcs as one LWPOLYLINE."""
        rows = [vertices_of(arc) for arc, _ in arcs]
        vertices = [vertex for row in rows for vertex in row]
        first, last = arcs[0][0].start, arcs[-1][0].end
        largest = largest_of(arc.bounding_box() for arc, _ in arcs)
        near = math.dist(first, last) <= writing_share(0.0, math.ulp(largest))
        closed = may_close and len(vertices) > 1 and near
        stop = vertices[0][:2] if closed else last
        self.space.add_lwpolyline(
            vertices if closed else [*vertices, (*last, 0.0)],
            format="xyb",
            close=closed,
            dxfattribs=self.attributes,
        )
        self.numbers += 3 * len(vertices) + (0 if closed else 2)
        for i, ((_, span), row) in enumerate(zip(arcs, rows)):
            end = rows[i + 1][0][:2] if i + 1 < len(rows) else stop
            points = [*(vertex[:2] for vertex in row), end]
            parts = [_bulge(p, q, v[2]) for (p, q), v in zip(pairwise(points), row)]
            self._add([stroke for part in parts for stroke in part], span)

    def _spline(self, arcs: Sequence[tuple[Piece, tuple[float, float]]]) -> None:
        """Add conics as one rational SPLINE."""
        points: list[Point] = [arcs[0][0].start]
        weights = [1.0]
        for arc, span in arcs:
            parts = quadratics(arc)
            strokes = []
            for control, weight, end in parts:
                strokes.append(Bezier((points[-1], control, end), (1.0, weight, 1.0)))
                points += [control, end]
                weights += [weight, 1.0]
            self._add(strokes, span)
        count = len(points) // 2
        knots = [0.0, *(float(k) for k in range(count + 1) for _ in range(2)), float(count)]
        self.space.add_rational_spline(points, weights, 2, knots, dxfattribs=self.attributes)
        self.numbers += 3 * len(points)

    def _cubics(self, arcs: Sequence[tuple[Cubic, tuple[float, float]]]) -> None:
        """Add cubics as one SPLINE."""
        points: list[Point] = [arcs[0][0].start]
        for arc, span in arcs:
            self._add([Bezier((arc.start, *arc.controls, arc.end))], span)
            points += [*arc.controls, arc.end]
        knots = [0.0, *(float(k) for k in range(len(arcs) + 1) for _ in range(3)), float(len(arcs))]
        self.space.add_open_spline(points, 3, knots, dxfattribs=self.attributes)
        self.numbers += 2 * len(points)

    def _arc(self, arc: Piece, span: tuple[float, float]) -> None:
        """Add an arc as ARC, a segment as LINE; as a LWPOLYLINE an arc whose digits are unstable."""
        angle = arc.turning
        sine = math.sin(angle / 2)
        if sine == 0:
            self.space.add_line(arc.start, arc.end, dxfattribs=self.attributes)
            self.numbers += 4
            self._add([Bezier((arc.start, arc.end))], span)
            return
        (x, y), (cx, cy) = arc.start, arc.legs[2]
        radius = math.hypot(cx, cy) / (2 * abs(sine))
        cotangent = 1 / math.tan(angle / 2)
        centre: Point = (x + (cx - cy * cotangent) / 2, y + (cy + cx * cotangent) / 2)
        # the centre, the radius and the angles are each rounded a few times
        if 6 * UNIT * (math.tau * radius + max(abs(x), abs(y))) > self.noise:
            self._polyline([(arc, span)])
            return
        first, last = (math.atan2(q - centre[1], p - centre[0]) for p, q in (arc.start, arc.end))
        ends = [math.degrees(first) % 360, math.degrees(last) % 360]
        self.space.add_arc(
            centre, radius, *(ends if angle > 0 else reversed(ends)), dxfattribs=self.attributes
        )
        self.numbers += 5
        axes = ((radius, 0.0), (0.0, radius))
        self._add(_swept(centre, *axes, math.radians(ends[0]), math.radians(ends[1]), angle > 0), span)

    def _ellipse(self, arc: Piece, span: tuple[float, float]) -> bool:
        """Add an arc as ELLIPSE, if its digits are stable."""
        conic = ellipse(arc)
        (a, b), rotation = conic.radii, conic.rotation
        if not b > SLIMMEST * a:
            return False
        c, s = math.cos(rotation), math.sin(rotation)
        mean = [(x + y) / 2 for x, y in zip(arc.start, arc.end)]
        bulge = [e / ((1 + arc.weight) * (1 - arc.weight)) for e in arc.bulge]
        centre = (mean[0] - arc.weight * bulge[0], mean[1] - arc.weight * bulge[1])
        gaps = [(x - centre[0], y - centre[1]) for x, y in (arc.start, arc.end)]
        first, last = (math.atan2((c * y - s * x) / b, (c * x + s * y) / a) for x, y in gaps)
        strokes = _swept(centre, (a * c, a * s), (-b * s, b * c), first, last, conic.positive)
        # as ellipses are drawn, the ends follow from the centre
        drawn = [
            (
                centre[0] + a * c * math.cos(t) - b * s * math.sin(t),
                centre[1] + a * s * math.cos(t) + b * c * math.sin(t),
            )
            for t in (first, last)
        ]
        off = max(math.dist(p, q) for p, q in zip(drawn, (arc.start, arc.end)))
        if off + math.ulp(a) > self.noise:
            return False
        ends = (first, last) if conic.positive else (last, first)
        self.space.add_ellipse(
            centre, (a * c, a * s), b / a, ends[0] % math.tau, ends[1] % math.tau, dxfattribs=self.attributes
        )
        self.numbers += 7
        self._add(strokes, span)
        return True


def _family(arc: Piece | Cubic) -> str:
    """What entity a run of arcs of that kind is: "cubic", "round" or "conic"."""
    if isinstance(arc, Cubic):
        return "cubic"
    return "round" if arc.kind in ROUND else "conic"


def vertices_of(arc: Piece) -> list[tuple[float, float, float]]:
    """Return x, y and bulge of the vertices of an arc of a circle, or a segment, but for its end."""
    angle = arc.turning
    if abs(angle) <= LARGEST_TURNING:
        return [(*arc.start, math.tan(angle / 4))]
    x, y = arc.point(0.5).tolist()  # by symmetry the middle of the arc
    return [(*arc.start, math.tan(angle / 8)), (x, y, math.tan(angle / 8))]


def quadratics(arc: Piece) -> list[tuple[Point, float, Point]]:
    """A conic as rational quadratics between weights 1: the control point, its weight and the end of each.

    >>> from osculant.pieces.conics import Piece
    >>> quadratics(Piece("ellipse", (0, 1), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), 0.0, 0.0))[0]
    ((1.0, 1.0), 0.7071067811865476, (0.0, 1.0))
    """
    w = arc.weight
    (x, y), (ax, ay), _ = arc.start, arc.legs[0], arc.legs[1]
    if w >= LEAST_WEIGHT:
        return [((x + ax / w, y + ay / w), w, arc.end)]
    (bx, by), (p, q) = arc.legs[1], arc.end
    half = math.sqrt((1 + w) / 2)
    middle: Point = tuple(arc.point(0.5).tolist())
    return [
        ((x + ax / (1 + w), y + ay / (1 + w)), half, middle),
        ((p - bx / (1 + w), q - by / (1 + w)), half, arc.end),
    ]


def _bulge(start: Coordinates, end: Coordinates, bulge: float) -> list[Stroke]:
    """What a bulge draws, in halves if it turns far."""
    angle = 4 * math.atan(bulge)
    if abs(angle) < 2:
        return [bulged(start, end, angle)]
    (x, y), (p, q) = start, end
    middle = ((x + p + bulge * (q - y)) / 2, (y + q - bulge * (p - x)) / 2)
    return [bulged(start, middle, angle / 2), bulged(middle, end, angle / 2)]


def _swept(centre: Point, p: Point, q: Point, first: float, last: float, positive: bool) -> list[Stroke]:
    """An arc of an ellipse between eccentric angles, as parts that turn by less than π."""
    turned = (last - first) % math.tau
    turned = turned if positive else turned - math.tau
    count = math.ceil(abs(turned) / 2)
    angles = [first + k / count * turned for k in range(count + 1)]
    points = [tuple(c + u * math.cos(t) + v * math.sin(t) for c, u, v in zip(centre, p, q)) for t in angles]
    return [elliptic(centre, p, q, a, b, ends) for a, b, ends in zip(angles, angles[1:], pairwise(points))]
