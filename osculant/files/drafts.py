"""A file before it is written: what it draws, by the numbers that it will hold, and its text."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from osculant.files.deviation import Follow, area, distance
from osculant.files.strokes import Path, Stroke

if TYPE_CHECKING:
    from osculant.files.facts import Facts
    from osculant.pieces.chain import Chain


@dataclass(frozen=True, kw_only=True)
class Draft:
    """What a writer makes of a chain.

    Attributes:
        text: makes the file's text, given what it shall say about its error.
        readings: the strokes it draws, read back from its own numbers, once for every way of reading them;
            none if it holds the pieces exactly.
        ends: the curve's parameters where strokes begin and end, one more than there are.
        moves: how many strokes it has, or pieces.
        numbers: how many numbers it holds for them.
        converted: how many pieces others stand for.
    """

    text: Callable[[str | None], str]
    readings: Sequence[Sequence[Stroke]] = ()
    ends: Sequence[float] = ()
    moves: int
    numbers: int
    converted: int = 0

    def error(self, chain: Chain, facts: Facts, follow: Follow | None) -> float:
        """The error of what is drawn, by its own numbers, in the metric of the spline.

        Distances are measured from the curve; where it cannot be followed, and areas, from the pieces, to
        which the pieces' own error is added.

        Args:
            chain: the pieces.
            facts: about them.
            follow: the curve's points at parameters; None if they are not known.
        """
        if not self.readings:
            return facts.error
        paths = [Path(strokes) for strokes in self.readings]
        if facts.metric == "area":
            return facts.error + max(area(path, chain.evaluate, self.ends) for path in paths)
        if follow is not None:
            measured = max(distance(path, follow, self.ends) for path in paths)
            if measured <= facts.tolerance:
                return measured
        bound = facts.error + max(distance(path, chain.evaluate, self.ends) for path in paths)
        return bound if follow is None or not measured < bound else measured


class Written(NamedTuple):
    """A file that was written.

    Attributes:
        path: where.
        format: the name of its format.
        error: of what it draws, measured on its own numbers.
        moves: how many lines, arcs and curves it holds, or pieces.
        numbers: how many numbers for them.
    """

    path: str
    format: str
    error: float
    moves: int
    numbers: int

    def to_json(self) -> dict[str, Any]:
        """Plain data: "path", "format", "error", "moves", "numbers"."""
        return self._asdict()
