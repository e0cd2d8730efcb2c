"""Splines as DXF: plane biarcs as one LWPOLYLINE with bulges, or as ARC and LINE; bihelices as a POLYLINE.

A bulge is tan(θ/4) for an arc that turns by θ between two vertices, so that nearly straight arcs are as good
as any, and an arc is exact to the rounding of its numbers: DXF holds doubles. An ARC has a centre, a radius
and angles in degrees instead. Where their rounding would move it by more than the budget, as it may a nearly
straight one, it is a LWPOLYLINE of its own.

DXF has no helical arc that programs agree on: chords stand for it, n = ⌈L√(κ/(8τ))⌉ for the length L and a
tolerance τ of their own. The file's custom properties tell it, with version, command, tolerance and error.
Files are made by ezdxf, the extra `cad`.
"""

from __future__ import annotations

import io
import math
from typing import TYPE_CHECKING, Any, Literal

from osculant.cas.errors import DomainError
from osculant.files.facts import header
from osculant.files.round_arcs import chords_needed, circular_arcs, helical_arcs
from osculant.files.writing import not_installed
from osculant.pieces.piece import largest_of
from osculant.tolerances import checked_tolerance, writing_share

if TYPE_CHECKING:
    from collections.abc import Sequence

    from osculant.files.facts import Facts
    from osculant.pieces.chain import Chain
    from osculant.pieces.conics import Piece, Point
    from osculant.pieces.helices import HelixArc

VERSION = "R2010"  # custom properties came with R2004, LWPOLYLINE with R2000
LAYER = "spline"
UNITS = {None: 0, "inch": 1, "mm": 4}  # $INSUNITS
LARGEST_TURNING = 1.01 * math.pi  # of one bulge; more is cut in halves
UNIT = 2.0**-53  # the relative error of rounding


def dxf(
    chain: Chain,
    facts: Facts,
    budget: float,
    *,
    entities: Literal["polyline", "arcs"] = "polyline",
    chord_tolerance: float | None = None,
    units: Literal["mm", "inch"] | None = None,
) -> str:
    """Return a spline of biarcs or bihelices as the text of a DXF file.

    Args:
        chain: its pieces.
        facts: of the spline, recorded as custom properties, with the error of chords.
        budget: by how much the digits of an ARC may move it; all else is exact.
        entities: "polyline" for one LWPOLYLINE with bulges, closed if it ends where it starts; "arcs" for an
            ARC or LINE for every arc. A spline in space is one POLYLINE in any case.
        chord_tolerance: for the chords of helical arcs; by default the spline's tolerance, so that such a
            drawing is within twice that.
        units: recorded in the drawing; by default it has none.

    Returns:
        The file's text, of DXF version R2010.

    Raises:
        DomainError: a piece of a conic that is neither circle nor line; entities or units unknown.
        OsculantError: ezdxf is not installed.

    >>> import osculant as osc
    >>> half = osc.approximate(osc.curve("cos(t), sin(t)", 0, "pi"), "biarc")
    >>> lines = dxf(half.chain, half.facts(), 0.0).split()
    >>> start = lines.index("LWPOLYLINE")
    >>> lines[start + 11 : start + 21]
    ['90', '3', '70', '0', '10', '1.0', '20', '0.0', '42', '0.41421356237309503']
    """
    try:
        from ezdxf.filemanagement import new
    except ImportError as error:
        raise not_installed("Writing DXF", "ezdxf", "cad") from error
    if entities not in ("polyline", "arcs"):
        raise DomainError(f"The entities of a DXF file are 'polyline' or 'arcs', not {entities!r}.")
    if units not in UNITS:
        raise DomainError(f"The units of a DXF file are 'mm' or 'inch', not {units!r}.")

    plane, helical = circular_arcs(chain, "A DXF polyline"), helical_arcs(chain)
    document = new(VERSION, units=UNITS[units])
    document.layers.add(LAYER)
    space = document.modelspace()
    attributes = {"layer": LAYER}
    allowed = checked_tolerance(facts.tolerance if chord_tolerance is None else chord_tolerance)
    if helical:
        space.add_polyline3d(_chords(helical, allowed), dxfattribs=attributes)
    elif entities == "polyline":
        _polyline(space, plane, attributes)
    else:
        for arc in plane:
            _arc(space, arc, budget, attributes)

    bent = sum(arc.kind != "segment" for arc in helical)
    chords = f"{bent} helical arcs, at most {allowed!r} more" if bent else None
    for name, fact in header(facts, chords=chords).items():
        document.header.custom_vars.append(name, " ".join(fact.split()))  # a line break would end the value
    text = io.StringIO()
    document.write(text)
    return text.getvalue()


def _vertices(arc: Piece) -> list[tuple[float, float, float]]:
    """Return x, y and bulge of the vertices of an arc but for its end."""
    angle = arc.turning
    if abs(angle) <= LARGEST_TURNING:
        return [(*arc.start, math.tan(angle / 4))]
    x, y = arc.point(0.5).tolist()  # by symmetry the middle of the arc
    return [(*arc.start, math.tan(angle / 8)), (x, y, math.tan(angle / 8))]


def _polyline(space: Any, arcs: Sequence[Piece], attributes: dict[str, str]) -> None:
    """Add arcs as one LWPOLYLINE."""
    vertices = [vertex for arc in arcs for vertex in _vertices(arc)]
    first, last = arcs[0].start, arcs[-1].end
    largest = largest_of(arc.bounding_box() for arc in arcs)
    closed = len(vertices) > 1 and math.dist(first, last) <= writing_share(0.0, math.ulp(largest))
    if not closed:
        vertices.append((*last, 0.0))
    space.add_lwpolyline(vertices, format="xyb", close=closed, dxfattribs=attributes)


def _arc(space: Any, arc: Piece, budget: float, attributes: dict[str, str]) -> None:
    """Add an arc as ARC, a segment as LINE; as a LWPOLYLINE an arc whose digits are unstable."""
    angle = arc.turning
    (x, y), (cx, cy) = arc.start, arc.legs[2]
    sine = math.sin(angle / 2)
    if sine == 0:
        space.add_line(arc.start, arc.end, dxfattribs=attributes)
        return
    radius = math.hypot(cx, cy) / (2 * abs(sine))
    # The centre, the radius and the angles, up to 360 degrees, are each rounded a few times.
    if 6 * UNIT * (math.tau * radius + max(abs(x), abs(y))) > budget:
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
