"""Splines as DXF: plane biarcs as one LWPOLYLINE with bulges, or as ARC and LINE; bihelices as a POLYLINE.

A bulge is tan(θ/4) for an arc that turns by θ between two vertices, so that nearly straight arcs are as good
as any, and an arc is exact to the rounding of its numbers: DXF holds doubles. An ARC has a centre, a radius
and angles in degrees instead. Where their rounding would move it by more than the reserve kept for writing
(`osculant.tolerances`), as it may a nearly straight one, it is a LWPOLYLINE of its own.

DXF has no helical arc that programs agree on: chords stand for it, n = ⌈L√(κ/(8τ))⌉ for the length L and a
tolerance τ of their own. The file's custom properties tell it, with version, command, tolerance and error.
Files are made by ezdxf, the extra `cad`.
"""

from __future__ import annotations

import io
import math
from typing import TYPE_CHECKING, Any, Literal

from osculant.cas.errors import DomainError, OsculantError
from osculant.files.motions import chords_needed
from osculant.pieces.conics import conic_arcs
from osculant.pieces.helices import HelixArc
from osculant.pieces.piece import largest_of
from osculant.tolerances import checked_tolerance, writing_reserve
from osculant.version import __version__

if TYPE_CHECKING:
    from collections.abc import Sequence

    from osculant.pieces.conics import Piece, Point
    from osculant.spline import Spline

VERSION = "R2010"  # custom properties came with R2004, LWPOLYLINE with R2000
LAYER = "spline"
UNITS = {None: 0, "inch": 1, "mm": 4}  # $INSUNITS
LARGEST_TURNING = 1.01 * math.pi  # of one bulge; more is cut in halves
UNIT = 2.0**-53  # the relative error of rounding


def dxf(
    spline: Spline,
    *,
    entities: Literal["polyline", "arcs"] = "polyline",
    chord_tolerance: float | None = None,
    units: Literal["mm", "inch"] | None = None,
    command: str | None = None,
) -> str:
    """Return a spline of biarcs or bihelices as the text of a DXF file.

    Args:
        spline: the spline.
        entities: "polyline" for one LWPOLYLINE with bulges, closed if it ends where it starts; "arcs" for an
            ARC or LINE for every arc. A spline in space is one POLYLINE in any case.
        chord_tolerance: for the chords of helical arcs; by default the spline's tolerance, so that such a
            drawing is within twice that.
        units: recorded in the drawing; by default it has none.
        command: the command line that made the spline, recorded too.

    Returns:
        The file's text, of DXF version R2010. Custom properties record version, curve, primitive, tolerance,
        and the errors of the spline and of chords.

    Raises:
        DomainError: a piece of a conic that is neither circle nor line; entities or units unknown.
        OsculantError: ezdxf is not installed.

    >>> import osculant as osc
    >>> lines = dxf(osc.approximate(osc.curve("cos(t), sin(t)", 0, "pi"), "biarc")).split()
    >>> start = lines.index("LWPOLYLINE")
    >>> lines[start + 11 : start + 21]
    ['90', '3', '70', '0', '10', '1.0', '20', '0.0', '42', '0.41421356237309503']
    """
    try:
        from ezdxf.filemanagement import new
    except ImportError as error:
        raise OsculantError(
            "Writing DXF needs ezdxf, which is not installed; `pip install osculant[cad]` adds it."
        ) from error
    if entities not in ("polyline", "arcs"):
        raise DomainError(f"The entities of a DXF file are 'polyline' or 'arcs', not {entities!r}.")
    if units not in UNITS:
        raise DomainError(f"The units of a DXF file are 'mm' or 'inch', not {units!r}.")

    document = new(VERSION, units=UNITS[units])
    document.layers.add(LAYER)
    space = document.modelspace()
    attributes = {"layer": LAYER}
    chorded = [arc for arc in spline.chain.arcs if isinstance(arc, HelixArc)]
    plane = [] if chorded else conic_arcs(spline.pieces)
    allowed = checked_tolerance(spline.tolerance if chord_tolerance is None else chord_tolerance)
    if chorded:
        space.add_polyline3d(_chords(chorded, allowed), dxfattribs=attributes)
    elif entities == "polyline":
        _polyline(space, plane, attributes)
    else:
        reserve = spline.reserve
        for arc in plane:
            _arc(space, arc, reserve, attributes)

    bent = sum(arc.kind != "segment" for arc in chorded)
    facts = {
        "osculant": __version__,
        "command": command,
        "curve": spline.curve.text,
        "primitive": f"{spline.primitive}, {len(spline)} pieces",
        "tolerance": f"{spline.tolerance!r} ({spline.metric})",
        "error": f"{spline.error!r} ({spline.error_kind})",
        "chords": f"{bent} helical arcs, at most {allowed!r} more" if bent else None,
    }
    for key, fact in facts.items():
        if fact is not None:
            document.header.custom_vars.append(
                key, " ".join(fact.split())
            )  # a line break would end the value
    text = io.StringIO()
    document.write(text)
    return text.getvalue()


def turning(arc: Piece) -> float:
    """Return the angle by which an arc or a segment turns, positive to the left.

    Raises:
        DomainError: another piece.

    >>> from osculant.pieces.conics import Piece
    >>> turning(Piece.arc((0.0, 3.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0))) == math.pi
    True
    """
    if arc.kind == "segment":
        return 0.0
    if arc.kind != "arc":
        raise DomainError(
            f"A DXF polyline has lines and circular arcs, and the piece on {arc.interval} is of kind "
            f"{arc.kind!r}: approximate with biarcs."
        )
    (ax, ay), _, (cx, cy) = arc.legs
    return 2 * math.atan2(ax * cy - ay * cx, ax * cx + ay * cy)


def _vertices(arc: Piece) -> list[tuple[float, float, float]]:
    """Return x, y and bulge of the vertices of an arc but for its end."""
    angle = turning(arc)
    if abs(angle) <= LARGEST_TURNING:
        return [(*arc.start, math.tan(angle / 4))]
    x, y = arc.point(0.5).tolist()  # by symmetry the middle of the arc
    return [(*arc.start, math.tan(angle / 8)), (x, y, math.tan(angle / 8))]


def _polyline(space: Any, arcs: Sequence[Piece], attributes: dict[str, str]) -> None:
    """Add arcs as one LWPOLYLINE."""
    vertices = [vertex for arc in arcs for vertex in _vertices(arc)]
    first, last = arcs[0].start, arcs[-1].end
    largest = largest_of(arc.bounding_box() for arc in arcs)
    closed = len(vertices) > 1 and math.dist(first, last) <= writing_reserve(0.0, largest)
    if not closed:
        vertices.append((*last, 0.0))
    space.add_lwpolyline(vertices, format="xyb", close=closed, dxfattribs=attributes)


def _arc(space: Any, arc: Piece, reserve: float, attributes: dict[str, str]) -> None:
    """Add an arc as ARC, a segment as LINE; as a LWPOLYLINE an arc whose digits are unstable."""
    angle = turning(arc)
    (x, y), (cx, cy) = arc.start, arc.legs[2]
    sine = math.sin(angle / 2)
    if sine == 0:
        space.add_line(arc.start, arc.end, dxfattribs=attributes)
        return
    radius = math.hypot(cx, cy) / (2 * abs(sine))
    # The centre, the radius and the angles, up to 360 degrees, are each rounded a few times.
    if 6 * UNIT * (math.tau * radius + max(abs(x), abs(y))) > reserve:
        _polyline(space, [arc], attributes)
        return
    cotangent = 1 / math.tan(angle / 2)
    centre: Point = (x + (cx - cy * cotangent) / 2, y + (cy + cx * cotangent) / 2)
    ends = [math.degrees(math.atan2(q - centre[1], p - centre[0])) for p, q in (arc.start, arc.end)]
    if angle < 0:  # an ARC is anticlockwise
        ends.reverse()
    space.add_arc(centre, radius, ends[0] % 360, ends[1] % 360, dxfattribs=attributes)


def _chords(arcs: Sequence[HelixArc], tolerance: float) -> list[tuple[float, ...]]:
    """Return the vertices of chords within a tolerance of helical arcs."""
    points = [tuple(arcs[0].start)]
    for arc in arcs:
        n = chords_needed(arc.curvature * arc.length**2, tolerance)
        points += [tuple(arc.point(i / n).tolist()) for i in range(1, n + 1)]
    return points
