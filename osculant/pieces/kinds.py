"""The kinds of arcs that pieces are made of: the words alone, without the geometry."""

from __future__ import annotations

from typing import Literal

#: arcs in the plane; an "ellipse" that is a circle may be called either
ConicKind = Literal["ellipse", "parabola", "hyperbola", "segment", "arc"]
#: arcs in space
HelixKind = Literal["helix", "arc", "segment"]

#: all kinds, and how one speaks of several of each
KINDS = {
    "segment": "lines",
    "arc": "circular arcs",
    "parabola": "parabolas",
    "ellipse": "ellipses",
    "hyperbola": "hyperbolas",
    "cubic": "cubic Bézier curves",
    "helix": "helical arcs",
}
