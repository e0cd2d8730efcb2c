"""How the error of one bihelix grows with its arc: `python -m benchmarks.monotonicity`.

The thesis assumes that it grows (section 4.1.2). For arcs from one end of a curve that become longer and
longer this prints where it falls instead, for both rules: the largest error up to which no fall was seen.
"""

from __future__ import annotations

import numpy as np

from osculant.approximation.coordinates import Coordinates
from osculant.approximation.division import divide
from osculant.curves.extent import extent
from osculant.curves.space import SpaceCurve
from osculant.kernels import bihelix_spline
from osculant.kernels.bihelices.family import EQUIOSCILLATING, THESIS
from osculant.kernels.curves.space import JET_SIZE, sample_many

CURVES = {
    "conical spiral": ("t*cos(t), t*sin(t), t", "pi/6", "2*pi"),
    "moment curve": ("t, t^2, t^3", "1", "3"),
    "helix of growing pitch": ("cos(t), sin(t), t^2/8", "1/2", "5"),
}
STEPS = 400


def scan(curve: SpaceCurve, rule: int) -> tuple[int, int, float]:
    """(arcs that had a bihelix, falls, largest error before the first fall) over `STEPS` longer arcs."""
    place = Coordinates(curve, extent(curve)).place()
    stretch = divide(curve, "bihelix").stretches[0]
    compiled, table = curve.compiled, np.empty((1, bihelix_spline.COLUMNS))
    times = np.linspace(stretch.a, stretch.b, STEPS + 1)
    jets = np.empty((len(times), JET_SIZE))
    sample_many(compiled.address, times, jets)
    points, velocities = jets[:, ::4], jets[:, 1::4]
    frames = np.hstack([points, velocities / np.linalg.norm(velocities, axis=1)[:, None]])
    first = tuple(map(float, frames[0]))
    errors = []
    for b, last in zip(map(float, times[1:]), (tuple(map(float, row)) for row in frames[1:])):
        count, reached, _ = bihelix_spline.spline(
            rule, compiled.address, place, stretch.a, first, b, last, 0.999e9, 1e9, 0.0, table
        )
        if count == 1 and reached == b:
            errors.append(float(table[0, 2]))
    falls = [i for i in range(1, len(errors)) if errors[i] < errors[i - 1] * (1 - 1e-6)]
    return len(errors), len(falls), errors[falls[0] - 1] if falls else errors[-1]


def main() -> None:
    """Print a line for every curve and rule."""
    for name, formula in CURVES.items():
        curve = SpaceCurve(*formula)
        for label, rule in (("thesis", THESIS), ("equioscillating", EQUIOSCILLATING)):
            arcs, falls, error = scan(curve, rule)
            print(f"{name}, {label}: {arcs} arcs, {falls} falls, none up to the error {error:.3g}")


if __name__ == "__main__":
    main()
