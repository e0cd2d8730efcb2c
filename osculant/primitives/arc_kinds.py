"""Which arcs the pieces of each primitive are made of: a format can be asked whether it holds them."""

from __future__ import annotations

from typing import get_args

from osculant.pieces.kinds import ConicKind

#: the kinds of arcs (`osculant.pieces.kinds.KINDS`), those of pieces that are exact among them
ARC_KINDS = {
    "parabola": ("parabola", "segment"),
    "conic": ("ellipse", "parabola", "hyperbola", "segment", "arc"),
    "biarc": ("arc", "segment"),
    "bihelix": ("helix", "arc", "segment"),
}


def may_become(primitive: str | None) -> list[str]:
    """The primitives that a spline may be of if this one is asked for: several for "best", in the plane.

    >>> may_become("best"), may_become("bihelix"), may_become(None)
    (['parabola', 'conic', 'biarc'], ['bihelix'], [])
    """
    if primitive == "best":
        return [name for name, kinds in ARC_KINDS.items() if set(kinds) <= set(get_args(ConicKind))]
    return [primitive] if primitive in ARC_KINDS else []
