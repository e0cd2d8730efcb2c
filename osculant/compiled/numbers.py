"""What is known of a fixed curve before run time, as numbers for `osculant.kernels.standalone`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from osculant.approximation.approximate import check_areas
from osculant.approximation.coordinates import NOISE_ULPS
from osculant.approximation.division import divide
from osculant.approximation.fitting import OUTLINED, RESOLVED, resolution
from osculant.cas.errors import UndecidedError
from osculant.curves.enclosed import enclosed
from osculant.curves.extent import extent
from osculant.tolerances import FLOOR_ULPS, WINDOW, WINDOW_ULPS

if TYPE_CHECKING:
    from osculant.curves.curve import FormulaCurve
    from osculant.primitives.primitive import Fit

#: edges of a curve's features at most, as `osculant.kernels.standalone.stretches.EDGES` has room for them
MOST_EDGES = 2000
#: for curves that are known only at run time: the floor of tolerances in rounding units, what is kept of one
#: for rounding, in parts of it and in rounding units at least, and the resolution over the tolerance where
#: the curve is split as theory wants it
UNITS = (float(FLOOR_ULPS), WINDOW / 4, WINDOW_ULPS / 4, OUTLINED)
#: and where it is not, or in space
RESOLVING = (*UNITS[:3], RESOLVED)

Rows = tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class Numbers:
    """What the kernels take of a fixed curve.

    Attributes:
        size: `osculant.kernels.operations.SCALE` …
        stretches: `osculant.kernels.standalone.stretches.START` …, a row each.
        edges: where panels end, and the resolution below which they do.
        splits: the parameters where stretches meet.
        undecided: those of them that were not decided.
        order: of the errors of short arcs.
    """

    size: tuple[float, ...]
    stretches: Rows
    edges: Rows
    splits: tuple[float, ...]
    undecided: tuple[float, ...]
    order: int


def numbers(curve: FormulaCurve, fit: Fit, split: str = "theory", split_at: Sequence[Any] = ()) -> Numbers:
    """The numbers of a curve with its interval: its size, its stretches with their frames, and its features.

    Args:
        curve: with its interval.
        fit: what the pieces are.
        split: "theory" or "never", as for `osculant.approximate`.
        split_at: further split points.

    The ends of the interval are knots, also of closed curves; no arc is passed over.  Raises DomainError
    where the curve is undefined, and what `divide` raises.

    >>> from osculant.curves.plane import PlaneCurve
    >>> from osculant.primitives.table import choose
    >>> found = numbers(PlaneCurve("t, sin(t)", 1, 4), choose("conic", "hausdorff"))
    >>> [len(row) for row in found.stretches], found.splits
    ([11, 11, 11], (1.5707963267948966, 3.141592653589793))
    """
    curve.check_finite()
    size = extent(curve)
    check_areas(curve, size, fit)
    division = divide(curve, fit.primitive.name, split_at, "open", split)
    rounding = size.rounding(fit.degree)
    features = resolution(curve, fit, division, size, 1.0)
    numbers_of_size = (
        size.scale, NOISE_ULPS * size.rounding() * size.scale,
        FLOOR_ULPS * rounding, WINDOW / 4, WINDOW_ULPS * rounding / 4, features, *size.origin,
    )  # fmt: skip
    kinds = {stretch.kind for stretch in division.stretches}
    order = fit.law("level").order if kinds == {"level"} else fit.order
    low, high = curve.interval
    edges = enclosed(curve.balls).levels(low, high, FLOOR_ULPS * rounding * features)
    if len(edges) > MOST_EDGES:
        raise UndecidedError(
            f"The curve {curve.text} has features on {len(edges)} parts of its interval, and a library has "
            f"room for {MOST_EDGES}: take shorter intervals."
        )
    stretches = tuple(
        (s.a, s.b, s.bend, *s.start.point, *s.start.tangent, *s.end.point, *s.end.tangent)
        for s in division.stretches
    )
    return Numbers(numbers_of_size, stretches, tuple(edges), division.splits, division.undecided, order)
