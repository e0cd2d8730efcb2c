"""Splines as DXF: circular arcs and lines as a LWPOLYLINE, conics and cubics as a SPLINE, helices as chords.

`osculant.files.entities` makes them; DXF holds doubles, so that all arcs of the plane are exact to the
rounding of their numbers. DXF has no helical arc that programs agree on: a POLYLINE of chords stands for it
(`osculant.files.round_arcs`). The file's custom properties tell version, command, tolerance and errors. Files
are made by ezdxf, the extra `cad`.
"""

from __future__ import annotations

import io
import math
from collections.abc import Collection
from itertools import groupby
from typing import TYPE_CHECKING, Any, Literal

from osculant.cas.errors import DomainError
from osculant.files.drafts import Draft
from osculant.files.entities import Drawing
from osculant.files.facts import header
from osculant.files.round_arcs import balanced_chords, check_room, helical_arcs, sliding
from osculant.files.writing import not_installed
from osculant.pieces.chain import plane_arcs

if TYPE_CHECKING:
    from osculant.files.facts import Facts
    from osculant.pieces.chain import Chain

VERSION = "R2010"  # custom properties came with R2004, LWPOLYLINE with R2000
LAYER = "spline"
UNITS = {None: 0, "inch": 1, "mm": 4}  # $INSUNITS
ENTITIES = ("polyline", "arcs")
NOISE = 256  # rounding units of the largest coordinate by which an ARC or ELLIPSE may be off
#: of the tolerance, what is kept for helices that chords stand for: of these there are many more than pieces,
#: and their number falls with the root of it
CONVERTED = 0.9


def needs(tolerance: float, kinds: Collection[str], **options: Any) -> tuple[float, ...]:
    """What to keep for writing, as lengths: each is worth a trial, and the first if nothing is converted.

    Args:
        tolerance: of the spline, as a length.
        kinds: of the arcs that the spline may have.
        options: those of `dxf`.

    >>> needs(1.0, ["ellipse"]), needs(1.0, ["helix"])
    ((0.0,), (0.0, 0.9))
    """
    check(**options)
    return (0.0, CONVERTED * tolerance) if "helix" in kinds else (0.0,)


def check(*, entities: str = "polyline", units: str | None = None) -> None:
    """Raises DomainError for options of `dxf` that make no sense."""
    if entities not in ENTITIES:
        raise DomainError(f"The entities of a DXF file are 'polyline' or 'arcs', not {entities!r}.")
    if units not in UNITS:
        raise DomainError(f"The units of a DXF file are 'mm' or 'inch', not {units!r}.")


def dxf(
    chain: Chain,
    facts: Facts,
    room: float,
    *,
    entities: Literal["polyline", "arcs"] = "polyline",
    units: Literal["mm", "inch"] | None = None,
) -> Draft:
    """Return a spline as a DXF file.

    Args:
        chain: its pieces.
        facts: of the spline, recorded as custom properties.
        room: how far chords of helices may be from the pieces; all else is exact.
        entities: "polyline" for one LWPOLYLINE with bulges, closed if it ends where it starts, and one
            SPLINE for consecutive conics, a rational one, or cubics; "arcs" for an ARC, LINE, ELLIPSE or
            SPLINE for every arc. A spline in space is one POLYLINE in any case.
        units: recorded in the drawing; by default it has none.

    Returns:
        The file, of DXF version R2010, before it is written.

    Raises:
        DomainError: entities or units unknown.
        ToleranceError: no room for the chords of helices.
        OsculantError: ezdxf is not installed.

    >>> import osculant as osc
    >>> half = osc.approximate(osc.curve("cos(t), sin(t)", 0, "pi"), "biarc")
    >>> lines = dxf(half.chain, half.facts(), 0.0).text(None).split()
    >>> start = lines.index("LWPOLYLINE")
    >>> lines[start + 11 : start + 21]
    ['90', '3', '70', '0', '10', '1.0', '20', '0.0', '42', '0.41421356237309503']
    """
    try:
        from ezdxf.filemanagement import new
    except ImportError as error:
        raise not_installed("Writing DXF", "ezdxf", "cad") from error
    check(entities=entities, units=units)
    document = new(VERSION, units=UNITS[units])
    document.layers.add(LAYER)
    noise = NOISE * math.ulp(chain.largest)
    drawing = Drawing(document.modelspace(), {"layer": LAYER}, float(chain.ends[0]), noise)
    converted = 0
    if chain.dimension == 3:
        if any(arc.kind != "segment" for arc in chain.arcs):
            check_room(room, facts.length_tolerance(chain))
        points, at, converted = _chords(chain, room)
        drawing.polygon(points, at)
    else:
        drawing.plane(plane_arcs(chain.pieces), chain.ends.tolist(), each=entities == "arcs")

    def text(error: str | None) -> str:
        chords = f"for {converted} helical arcs" if converted else None
        for name, fact in header(facts, written=error, chords=chords).items():
            document.header.custom_vars.append(
                name, " ".join(fact.split())
            )  # a line break would end the value
        text = io.StringIO()
        document.write(text)
        return text.getvalue()

    return Draft(
        text=text,
        readings=[drawing.strokes],
        ends=drawing.ends,
        moves=len(drawing.strokes),
        numbers=drawing.numbers,
        converted=converted,
    )


def _chords(chain: Chain, room: float) -> tuple[list[tuple[float, ...]], list[float], int]:
    """The vertices of a polygon along a chain in space, their parameters, and how many arcs it replaces."""
    arcs, ends = helical_arcs(chain), chain.ends.tolist()
    points, at, converted = [tuple(chain.pieces[0].start)], [], 0
    smooth = sliding(arcs)
    runs = [0]  # the number of the run that an arc belongs to
    for before, after, tangent in zip(arcs, arcs[1:], smooth):
        together = before.kind != "segment" and after.kind != "segment" and tangent is not None
        runs.append(runs[-1] + (not together))
    for _, group in groupby(range(len(arcs)), key=lambda i: runs[i]):
        chosen = list(group)
        first, last = chosen[0], chosen[-1]
        if arcs[first].kind == "segment":
            points.append(tuple(arcs[first].end))
            at.append(ends[first + 1])
            continue
        converted += len(chosen)
        vertices, parameters = balanced_chords(arcs[first : last + 1], ends[first : last + 2], room)
        points += vertices
        at += parameters
    return points, at, converted
