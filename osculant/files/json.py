"""Splines as JSON: all that `Spline.to_json` says, every number exactly."""

from __future__ import annotations

import math
from json import dumps
from typing import TYPE_CHECKING, Any

from osculant.files.drafts import Draft

if TYPE_CHECKING:
    from osculant.files.facts import Facts
    from osculant.pieces.chain import Chain


def json(chain: Chain, facts: Facts, room: float) -> Draft:
    """Return a spline as the text of a JSON file.

    Args:
        chain: its pieces.
        facts: of the spline; its data are what is written. The file of a spline in space has the command
            besides.
        room: not needed: nothing is rounded.

    Returns:
        The file before it is written. Numbers are doubles in the shortest form that reads back as the same.
    """

    def text(error: str | None) -> str:
        data = facts.data()
        if chain.dimension == 3 and facts.command is not None:
            data = data | {"command": facts.command}
        return dumps(data, indent=1, allow_nan=False) + "\n"

    return Draft(text=text, moves=len(chain), numbers=chain.numbers)


def data_of(spline: Any) -> dict[str, Any]:
    """A spline as plain dictionaries, lists and numbers.

    Keys: "curve" (the formula), "primitive", "rule", "closed", "corner" (the angle at the seam in radians),
    "split", "given", "gap", "choice" (null where they do not apply), "metric", "tolerance", "reserved" (what
    of it was left for writing), "pieces" (their number), "arcs" (the number of arcs that they are made of),
    "knots", "error", "error_kind", "errors", "predicted", "predicted_pieces", "predicted_error" (null where
    unknown or not finite), "minimal", "undecided" (parameters), "bridged" (first and last parameter and the
    extent of arcs that are passed over), "max_tangent_jump" (in radians), "splits" and "cusps" (parameters),
    "segments" (the pieces, as `Piece.to_json`, `Biarc.to_json`, `Cubic.to_json` or `SpacePiece.to_json`
    says), "certificate" (`Certificate.to_json`; null: none was asked for).
    """
    predicted = spline.predicted
    finite = predicted is not None and math.isfinite(predicted)
    return {
        "curve": spline.curve.text,
        "primitive": spline.primitive,
        "rule": spline.rule,
        "closed": spline.closed,
        "corner": spline.corner,
        "split": spline.split,
        "given": spline.given,
        "gap": spline.gap,
        "choice": None if spline.choice is None else list(spline.choice),
        "metric": spline.metric,
        "tolerance": float(spline.tolerance),
        "reserved": float(spline.reserved),
        "pieces": len(spline),
        "arcs": len(spline.chain.arcs),
        "knots": spline.knots,
        "error": spline.error,
        "error_kind": spline.error_kind,
        "errors": spline.errors,
        "predicted": predicted if finite else None,
        "predicted_pieces": spline.predicted_pieces if finite else None,
        "predicted_error": spline.predicted_error if finite else None,
        "minimal": spline.minimal,
        "undecided": list(map(float, spline.undecided)),
        "bridged": [list(map(float, arc)) for arc in spline.bridged],
        "max_tangent_jump": spline.max_tangent_jump(),
        "splits": list(map(float, spline.splits)),
        "cusps": spline.cusps,
        "segments": [piece.to_json() for piece in spline.pieces],
        "certificate": None if spline.certificate is None else spline.certificate.to_json(),
    }
