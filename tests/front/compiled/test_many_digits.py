"""Compiled invariants and distances at 100,000 places, each against mpmath."""

import mpmath
import numpy as np
import pytest
from scipy.spatial import cKDTree

import osculant as osc
from tests.front.compiled.fixed import needs_cc

pytestmark = [needs_cc, pytest.mark.slow]

COUNT, DIGITS = 100_000, 30
LOW, HIGH = np.pi / 6, 2 * np.pi
#: feet nearer to an end of the interval may be the end
NEAR = 1e-9


def bracket(p, q):
    return (mpmath.conj(p) * q).imag


def derivatives(t, order):
    """Of t·exp(it), turned by −t: all that is invariant is the same."""
    turns = (1, 1j, -1, -1j)
    return [mpmath.mpc(turns[n % 4]) * t + n * mpmath.mpc(turns[(n - 1) % 4]) for n in range(order + 1)]


def plane_invariants(t):
    """From their definitions: κ = [12]/|α̇|³, φ = [12]^⅓, dk/dr by the quotient rule."""
    _, d1, d2, d3, d4, d5 = derivatives(t, 5)
    speed = abs(d1)
    d, d13, d23, d14 = bracket(d1, d2), bracket(d1, d3), bracket(d2, d3), bracket(d1, d4)
    curvature = d / speed**3
    slope = (d13 / speed**3 - 3 * d * (mpmath.conj(d1) * d2).real / speed**5) / speed
    phi = mpmath.cbrt(d)
    above = 3 * d * (4 * d23 + d14) - 5 * d13**2
    rise = (
        3 * d13 * (4 * d23 + d14)
        + 3 * d * (4 * bracket(d2, d4) + bracket(d2, d4) + bracket(d1, d5))
        - 10 * d13 * (d23 + d14)
    )
    k = above / (9 * phi**8)
    rate = (rise - above * mpmath.mpf(8) / 3 * d13 / d) / (9 * phi**8) / phi
    return speed, curvature, slope, phi, k, rate


def test_invariants_in_the_plane(tmp_path):
    module = osc.compile_evaluator("t*cos(t), t*sin(t)", "invariants", folder=tmp_path).load()
    found = module.invariants(np.linspace(LOW, HIGH, COUNT))
    names = ("speed", "curvature", "curvature_slope", "affine_speed", "affine_curvature")
    with mpmath.workdps(DIGITS):
        for row in found:
            t = mpmath.mpf(float(row["t"]))
            *values, rate = plane_invariants(t)
            for name, value in zip(names, values):
                least = 0.1 if name in ("curvature_slope", "affine_curvature") else 0.0  # they change sign
                assert abs(float(row[name]) - value) <= 4e-15 * max(abs(value), least)
            assert abs(float(row["affine_curvature_slope"]) - rate) <= 1e-14 * max(abs(values[-1]), 0.1)
            turn = mpmath.expj(t)
            tangent = (1 + 1j * t) / values[0] * turn
            assert abs(complex(row["tx"], row["ty"]) - tangent) <= 1e-15
            assert abs(complex(row["x"], row["y"]) - t * turn) <= 2e-15


def test_invariants_in_space(tmp_path):
    module = osc.compile_evaluator("t*cos(t), t*sin(t), t", "invariants", folder=tmp_path).load()
    found = module.invariants(np.linspace(LOW, HIGH, COUNT))
    with mpmath.workdps(DIGITS):
        for row in found:
            t = mpmath.mpf(float(row["t"]))
            s = t * t
            speed, area = mpmath.sqrt(2 + s), mpmath.sqrt(8 + 5 * s + s * s)  # |α̇|, |α̇ × α̈|
            curvature, torsion = area / speed**3, (6 + s) / area**2
            rise = (5 * t + 2 * t * s) / area / speed**3 - 3 * t * area / speed**5
            for name, value in (("speed", speed), ("curvature", curvature), ("torsion", torsion)):
                assert abs(float(row[name]) - value) <= 4e-15 * abs(value)
            assert abs(float(row["curvature_slope"]) - rise / speed) <= 1e-14 * curvature
            turn = mpmath.expj(t)
            tangent, second = (1 + 1j * t) * turn, (2j - t) * turn
            # B ~ α̇ × α̈, whose part along z is 2 + t², and N = B × T
            flat = 1j * second  # the plane part of α̇ × α̈ is i(ż α̈ − z̈ α̇), turned back
            across = (mpmath.mpc(-second.imag, second.real)) / area
            assert abs(flat / area - across) < 1e-25
            assert abs(complex(row["tx"], row["ty"]) - tangent / speed) <= 1e-15
            assert abs(float(row["tz"]) - 1 / speed) <= 1e-15
            assert abs(complex(row["bx"], row["by"]) - across) <= 3e-15
            assert abs(float(row["bz"]) - (2 + s) / area) <= 3e-15
            normal = 1j * (across / speed - (2 + s) / area * tangent / speed) * -1
            assert abs(complex(row["nx"], row["ny"]) - normal) <= 3e-15


def test_distances(tmp_path):
    """The foot is refined by Newton's method in mpmath; that none is nearer, a dense polygon tells."""
    module = osc.compile_evaluator("t*cos(t), t*sin(t)", "distance", "pi/6", "2*pi", folder=tmp_path).load()
    points = np.random.default_rng(3).uniform(-8, 8, (COUNT, 2))
    found = module.distance(points)
    times = np.linspace(LOW, HIGH, 400_001)
    dense = np.stack([times * np.cos(times), times * np.sin(times)], axis=1)
    nearest, _ = cKDTree(dense).query(points)
    sagitta = (6.4 * (times[1] - times[0])) ** 2  # of neighbours among the dense, far more than it
    assert (found["distance"] <= nearest + 1e-14).all()
    assert (nearest <= np.sqrt(found["distance"] ** 2 + sagitta) + 1e-14).all()
    with mpmath.workdps(DIGITS):
        for (x, y), row in zip(points.tolist(), found):
            p, t = mpmath.mpc(x, y), mpmath.mpf(float(row["t"]))
            if LOW + NEAR < t < HIGH - NEAR:
                away = t * mpmath.expj(t) - p
                first, second = (1 + 1j * t) * mpmath.expj(t), (2j - t) * mpmath.expj(t)
                slope = (mpmath.conj(away) * first).real
                bend = abs(first) ** 2 + (mpmath.conj(away) * second).real
                if abs(bend) > 1e-3:  # near the evolute feet are ill-conditioned
                    t -= slope / bend
            exact = abs(t * mpmath.expj(t) - p)
            assert abs(float(row["distance"]) - exact) <= 4e-15 * max(1, exact)
            if LOW + NEAR < t < HIGH - NEAR and bend > 1e-3:
                assert abs(float(row["t"]) - t) <= 1e-14 / bend * 40
