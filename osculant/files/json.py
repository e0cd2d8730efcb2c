"""Splines as JSON: all that `Spline.to_json` says, every number exactly."""

from __future__ import annotations

from json import dumps
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from osculant.files.facts import Facts
    from osculant.pieces.chain import Chain


def json(chain: Chain, facts: Facts, budget: float) -> str:
    """Return a spline as the text of a JSON file.

    Args:
        chain: its pieces.
        facts: of the spline; its data are what is written. The file of a spline in space has the command
            besides.
        budget: not needed: nothing is rounded.

    Returns:
        The file's text. Numbers are doubles in the shortest form that reads back as the same.
    """
    data = facts.data()
    if chain.dimension == 3 and facts.command is not None:
        data = data | {"command": facts.command}
    return dumps(data, indent=1, allow_nan=False) + "\n"
