"""The trees of a classification as an SVG drawing: an outline, a line for each branch."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any
from xml.sax.saxutils import escape

#: the end of the name of a file with a drawing
SUFFIX = ".svg"
#: the height of a line, the indent of a branch, the margin, the width of a letter
LINE, INDENT, MARGIN, LETTER = 20, 22, 24, 7.3
#: colours by the kind of a branch
COLOURS = {"branch": "#555", "class": "#06750d", "merged": "#1a4fa3", "stratum": "#8a3d9e", "closed": "#999"}


def drawing(branches: Sequence[dict[str, Any]], title: str) -> str:
    """The SVG text of an outline, as `Classification.tree` has it.

    >>> text = drawing([{"depth": 0, "branch": "x", "codimension": 0, "kind": "class", "fate": "0.1"}], "t")
    >>> text.startswith("<svg"), "x · codimension 0 · 0.1" in text
    (True, True)
    """
    parts: list[str] = []
    last: dict[int, float] = {}
    widest = float(len(title))
    for row, branch in enumerate(branches):
        depth, y = branch["depth"], MARGIN + LINE * (row + 2)
        x = MARGIN + INDENT * depth
        if depth:
            up = last[depth - 1]
            parts.append(
                f'<path d="M{x - INDENT + 4} {up + 5:g}V{y - 5}H{x - 4}" fill="none" stroke="#bbb"/>'
            )
        last[depth] = y
        shown = f"{branch['branch']} · codimension {branch['codimension']}"
        if branch["fate"]:
            shown += f" · {branch['fate']}"
        colour = COLOURS[branch["kind"]]
        parts.append(f'<text x="{x}" y="{y}" fill="{colour}">{escape(shown)}</text>')
        widest = max(widest, len(shown) + x / LETTER)
    width, height = round(widest * LETTER + 2 * MARGIN), MARGIN * 2 + LINE * (len(branches) + 2)
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
        f'viewBox="0 0 {width} {height}" font-family="monospace" font-size="12">'
        f'<rect width="{width}" height="{height}" fill="#fff"/>'
        f'<text x="{MARGIN}" y="{MARGIN + LINE / 2:g}" font-weight="bold">{escape(title)}</text>'
    )
    return "\n".join([head, *parts, "</svg>"]) + "\n"
