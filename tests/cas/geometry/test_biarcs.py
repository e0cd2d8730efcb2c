"""Areas between biarcs and curves against polygons and closed forms."""

import math

import mpmath as mp
import numpy as np
import pytest
from shapely import Polygon

from osculant.cas.errors import DomainError
from osculant.cas.geometry.biarcs import equisymmetric, member, signed_area


def spiral(t):
    return t * mp.expj(t), mp.expj(t) * (1 + 1j * t)


def family(low, high):
    (p, v), (q, w) = spiral(low), spiral(high)
    return lambda mu: member(p, v / abs(v), q, mp.arg(w / v), mu)


def points_of(biarc, count):
    """Points of both arcs, each followed by its own length."""
    found = []
    arcs = ((biarc.start, biarc.heading, biarc.junction), (biarc.junction, biarc.direction, biarc.end))
    for bend, (p, T, q) in zip(biarc.curvatures, arcs):
        turning = 2 * mp.arg((q - p) / T)
        for i in range(count):
            angle = turning * i / count
            found.append(complex(p + T * (mp.expj(angle) - 1) / (1j * bend)))
    return [*found, complex(biarc.end)]


@pytest.mark.parametrize(("low", "high"), [(2, 3), (1, 3.4), (0.7, 1.1)])
@pytest.mark.parametrize("mu", [0.3, 0.5, 0.7])
def test_signed_areas_are_those_of_polygons(low, high, mu):
    biarc = family(low, high)(mp.mpf(mu))
    curve = [complex(spiral(t)[0]) for t in np.linspace(low, high, 4001)]
    corners = np.array([*points_of(biarc, 2000), *curve[::-1]])
    x, y = corners.real, corners.imag
    shoelace = (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2
    assert float(signed_area(biarc, spiral, low, high)) == pytest.approx(shoelace, abs=1e-6)


def test_equal_moons_make_the_symmetric_difference():
    low, high = mp.mpf(2), mp.mpf(3)
    mu, area, crossing = equisymmetric(family(low, high), spiral, low, high)
    biarc = family(low, high)(mu)
    moons = [signed_area(biarc, spiral, *ends) for ends in ((low, crossing), (crossing, high))]
    assert abs(sum(moons)) < 1e-14 and moons[0] * moons[1] < 0
    # both are convex, so closing them by the chord makes polygons whose difference is the moons
    curve = [complex(spiral(t)[0]) for t in np.linspace(2, 3, 4001)]
    closed, other = (Polygon([(z.real, z.imag) for z in path]) for path in (curve, points_of(biarc, 2000)))
    assert closed.is_valid and other.is_valid
    assert float(area) == pytest.approx(closed.symmetric_difference(other).area, rel=1e-4)


def test_arcs_of_more_than_half_a_turn():
    """A full turn less a little, of a circle: the biarc is the circle whatever the junction."""
    turning = 2 * mp.pi - mp.mpf("0.1")
    for mu in ("0.1", "0.5", "0.9"):
        circle = member(mp.mpc(1), mp.mpc(0, 1), mp.expj(turning), turning, mp.mpf(mu))
        around = signed_area(circle, lambda t: (mp.expj(t), 1j * mp.expj(t)), 0, turning)
        assert abs(around) < 1e-13


def test_moons_that_do_not_balance():
    def ellipse(t):
        return mp.mpc(2 * mp.cos(t), mp.sin(t)), mp.mpc(-2 * mp.sin(t), mp.cos(t))

    (p, v), (q, w) = ellipse(-0.5), ellipse(0.5)

    def about_the_vertex(mu):
        return member(p, v / abs(v), q, mp.arg(w / v), mu)

    with pytest.raises(DomainError, match="balance"):
        equisymmetric(about_the_vertex, ellipse, mp.mpf(-0.5), mp.mpf(0.5))
    assert math.isfinite(signed_area(about_the_vertex(mp.mpf(0.5)), ellipse, -0.5, 0.5))
