"""From stretches of a space curve to pieces: the fewest for a tolerance, or the best of a given number."""

from __future__ import annotations

from typing import TYPE_CHECKING

from osculant.approximation.allocation import given_pieces, within
from osculant.approximation.equal_errors import equalise
from osculant.approximation.exact_helices import Helices, SpaceSegments
from osculant.approximation.runs import share_of
from osculant.approximation.space_arcs import SpaceArcs
from osculant.kernels.bihelices import family as bihelix
from osculant.kernels.curves.space import Place
from osculant.kernels.jit import announce
from osculant.tolerances import window

if TYPE_CHECKING:
    from osculant.approximation.runs import Part, Progress, Run
    from osculant.approximation.space_stretches import SpaceDivision, SpaceStretch
    from osculant.curves.extent import Extent
    from osculant.curves.space import SpaceCurve
    from osculant.pieces.helices import SpacePiece

#: rounding units of the largest coordinate that positions may be wrong by
NOISE_ULPS = 4
#: so few greedy pieces are checked for one too many in any case
FEW = 30

RULES = {"equioscillating": bihelix.EQUIOSCILLATING, "thesis": bihelix.THESIS}


class SpaceFitting:
    """A divided space curve, ready to be approximated with bihelices by a rule for junctions."""

    def __init__(self, curve: SpaceCurve, rule: str, division: SpaceDivision, size: Extent) -> None:
        announce()
        self.curve, self.rule, self.division, self.size = curve, RULES[rule], division, size
        self.noise = NOISE_ULPS * size.rounding()
        x, y, z = size.origin
        self.place: Place = (x, y, z, size.scale, self.noise * size.scale)
        self.parts = [self.part(stretch) for stretch in division.stretches]

    def part(self, stretch: SpaceStretch) -> SpaceArcs | SpaceSegments:
        """A stretch with the way to fit pieces to it."""
        if stretch.shape == "segment":
            return SpaceSegments(self.curve, stretch)
        if stretch.shape == "exact" and self.division.proved:
            return Helices(self.curve, stretch)
        return SpaceArcs(self.curve, self.rule, self.place, stretch, self.noise)

    def within(self, tolerance: float, progress: Progress | None = None) -> list[Run]:
        """The fewest pieces found with errors up to the tolerance, stretch by stretch."""
        low, high = window(tolerance, self.size.rounding())
        runs = []
        for i, part in enumerate(self.parts):
            share = share_of(progress, i, len(self.parts))
            runs.append(_fewer(part, within(part, low, high, tolerance, share)[0], tolerance))
        return runs

    def of_number(self, count: int) -> list[Run]:
        """The pieces, ``count`` in all, with the least greatest error."""
        return given_pieces(self.parts, count)

    def pieces(self, runs: list[Run]) -> list[SpacePiece]:
        """The pieces of all stretches."""
        return [piece for part, run in zip(self.parts, runs, strict=True) for piece in part.pieces(run)]


def _fewer(part: Part, run: Run, tolerance: float) -> Run:
    """A run with fewer pieces, where errors that fall as arcs grow have ended greedy pieces early."""
    while not part.exact and part.least < len(run) <= FEW:
        fewer = equalise(part, len(run) - 1)
        if fewer.error > tolerance:
            break
        run = fewer
    return run
