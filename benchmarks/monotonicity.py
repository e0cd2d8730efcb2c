"""How the error of one bihelix grows with its arc: `python -m benchmarks.monotonicity`.

The thesis assumes that it grows (section 4.1.2). For arcs from one end of a curve that become longer and
longer this prints where it falls instead, for both rules: the largest error up to which no fall was seen.
"""

from __future__ import annotations

import math

import numpy as np

from osculant.approximation.arcs import Arcs
from osculant.approximation.coordinates import Coordinates
from osculant.approximation.division import divide
from osculant.curves.extent import extent
from osculant.curves.space import SpaceCurve
from osculant.primitives.table import choose

CURVES = {
    "conical spiral": ("t*cos(t), t*sin(t), t", "pi/6", "2*pi"),
    "moment curve": ("t, t^2, t^3", "1", "3"),
    "helix of growing pitch": ("cos(t), sin(t), t^2/8", "1/2", "5"),
}
STEPS = 400


def scan(curve: SpaceCurve, rule: str) -> tuple[int, int, float]:
    """(arcs that had a bihelix, falls, largest error before the first fall) over `STEPS` longer arcs."""
    fit, (stretch, *_) = choose("bihelix", "hausdorff", rule, dimension=3), divide(curve, "bihelix").stretches
    coordinates = Coordinates(curve, extent(curve))
    errors = []
    whole = Arcs(coordinates, fit, stretch)
    for b in np.linspace(stretch.a, stretch.b, STEPS + 1)[1:].tolist():
        end = stretch if b == stretch.b else whole.ending_at(b)
        error = Arcs(coordinates, fit, end).fitted(np.array([stretch.a, b])).error
        if math.isfinite(error):
            errors.append(error)
    falls = [i for i in range(1, len(errors)) if errors[i] < errors[i - 1] * (1 - 1e-6)]
    return len(errors), len(falls), errors[falls[0] - 1] if falls else errors[-1]


def main() -> None:
    """Print a line for every curve and rule."""
    for name, formula in CURVES.items():
        curve = SpaceCurve(*formula)
        for rule in ("thesis", "equioscillating"):
            arcs, falls, error = scan(curve, rule)
            print(f"{name}, {rule}: {arcs} arcs, {falls} falls, none up to the error {error:.3g}")


if __name__ == "__main__":
    main()
