"""From stretches of a space curve to pieces: the fewest for a tolerance, or the best of a given number."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from osculant.allocation import given_pieces, within
from osculant.cas.errors import DomainError
from osculant.equal_errors import equalise
from osculant.exact_helices import Helices, SpaceSegments
from osculant.kernels import bihelix
from osculant.kernels.jit import announce
from osculant.kernels.space_curve import JET_SIZE, Place, sample_many
from osculant.runs import share_of
from osculant.space_arcs import SpaceArcs
from osculant.tolerances import window

if TYPE_CHECKING:
    from osculant.helix_pieces import SpacePiece, Vector
    from osculant.runs import Part, Progress, Run
    from osculant.space import SpaceCurve
    from osculant.space_stretches import SpaceDivision, SpaceStretch

#: samples that tell the size of a curve
SAMPLES = 257
#: rounding units of the largest coordinate that positions may be wrong by
NOISE_ULPS = 4
#: so few greedy pieces are checked for one too many in any case
FEW = 30

RULES = {"equioscillating": bihelix.EQUIOSCILLATING, "thesis": bihelix.THESIS}


@dataclass(frozen=True)
class SpaceExtent:
    """Size of a curve: its first point, largest absolute coordinate and largest extent."""

    origin: Vector
    largest: float
    size: float

    @property
    def rounding(self) -> float:
        """One rounding unit of the largest coordinate."""
        return math.ulp(self.largest)

    @property
    def scale(self) -> float:
        """The power of two that makes the curve's size about 1."""
        return 2.0 ** -math.frexp(self.size)[1] if self.size > 0 else 1.0


def extent(curve: SpaceCurve) -> SpaceExtent:
    """Sample a curve that is finite on its interval; raises DomainError if doubles cannot hold it.

    >>> from osculant.space import SpaceCurve
    >>> extent(SpaceCurve("t, t^2, -t", 0, 3))
    SpaceExtent(origin=(0.0, 0.0, 0.0), largest=9.0, size=9.0)
    """
    a, b = curve.interval
    jets = np.empty((SAMPLES, JET_SIZE))
    sample_many(curve.compiled.address, np.linspace(a, b, SAMPLES), jets)
    points = jets[:, ::4]
    # a double next to an end may lie outside the interval, where the formula need not be defined
    if not np.isfinite(points[1:-1]).all():
        raise DomainError(
            f"The curve {curve.text} leaves the range of double numbers on its interval: "
            "scale it or take a smaller interval."
        )
    points = points[np.isfinite(points).all(axis=1)]
    with np.errstate(over="ignore"):
        size = float(np.ptp(points, axis=0).max())
    if not math.isfinite(size):
        raise DomainError(f"The curve {curve.text} is too large for double numbers: scale it.")
    x, y, z = (points[0] + 0.0).tolist()
    return SpaceExtent((x, y, z), float(np.abs(points).max()), size)


class SpaceFitting:
    """A divided space curve, ready to be approximated with bihelices by a rule for junctions."""

    def __init__(self, curve: SpaceCurve, rule: str, division: SpaceDivision, size: SpaceExtent) -> None:
        announce()
        self.curve, self.rule, self.division, self.size = curve, RULES[rule], division, size
        self.noise = NOISE_ULPS * size.rounding
        self.place: Place = (*size.origin, size.scale, self.noise * size.scale)
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
        low, high = window(tolerance, self.size.rounding)
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
