"""The reference bitangent conics against dense sampling, closed forms, shapely and the kernels."""

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from shapely.geometry import Polygon

import osculant as osc
from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.cas.geometry.moons import equisymmetric, gauss, least_area, moons, signed_area
from osculant.cas.numbers.roots import root_between
from tests.oracles import hausdorff

SPIRAL = "t*cos(t), t*sin(t)"
CAYLEY = "4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)"


@pytest.fixture(autouse=True)
def digits():
    with mp.workdps(25):
        yield


def spiral(t):
    return t * np.cos(t), t * np.sin(t)


def piece(pencil, q):
    """A member of the pencil as the oracle takes it."""
    return SimpleNamespace(
        interval=(float(pencil.a), float(pencil.b)),
        start=tuple(map(float, pencil.first.point)),
        end=tuple(map(float, pencil.last.point)),
        middle=tuple(map(float, pencil.control(q))),
        weight=float(pencil.weight(q)),
    )


@settings(max_examples=10)
@given(st.floats(0.3, 5), st.floats(0.2, 1.2))
def test_the_best_conic_and_the_parabola_agree_with_dense_sampling(a, length):
    pencil = BitangentPencil(ReferenceCurve(SPIRAL), a, a + length)
    for q in (pencil.best(), pencil.parabola):
        sampled = hausdorff(spiral, [piece(pencil, q)])
        assert float(pencil.hausdorff(q)) == pytest.approx(sampled, rel=1e-5, abs=1e-13)


@settings(max_examples=8)
@given(st.floats(0.3, 5), st.floats(0.2, 1.5))
def test_the_best_conic_equioscillates_and_every_other_one_is_worse(a, length):
    pencil = BitangentPencil(ReferenceCurve(SPIRAL), a, a + length)
    q = pencil.best()
    (_, first), (_, last) = pencil.peaks(q)
    assert abs(first + last) < 1e-15 * abs(first)
    for factor in ("0.999", "1.001"):
        assert pencil.hausdorff(q * mp.mpf(factor)) > pencil.hausdorff(q)


def test_members_lie_on_the_conic_and_touch_the_curve():
    pencil = BitangentPencil(ReferenceCurve(CAYLEY), 0, 3 * mp.pi / 4)
    q = pencil.through(1)
    for x in (mp.mpf(0), mp.mpf("0.3"), mp.mpf("0.8"), mp.mpf(1)):
        l0, l1, l2 = pencil.lines(pencil.member(q, x))
        assert abs(l1**2 - 4 * q * l0 * l2) < 1e-22
    assert abs(pencil.weight(q)) < 1e-22
    (crossing,) = pencil.crossings(q)
    assert abs(crossing - 1) < 1e-20


def test_the_slope_in_q_is_that_of_the_displacement():
    pencil = BitangentPencil(ReferenceCurve(SPIRAL), 1, 2)
    q, t, step = pencil.parabola, mp.mpf("1.3"), mp.mpf(10) ** -8
    high, low = (pencil.displacement(t, q + s).d for s in (step, -step))
    assert abs((high - low) / (2 * step) / pencil.displacement(t, q).by_q - 1) < 1e-13


@pytest.mark.parametrize(("a", "b", "primitive"), [(1, 2, "conic"), (2, 4, "conic"), (1, 2, "parabola")])
def test_the_kernels_find_the_same_error(a, b, primitive):
    pencil = BitangentPencil(ReferenceCurve(SPIRAL), a, b)
    q = pencil.best() if primitive == "conic" else pencil.parabola
    error = float(pencil.hausdorff(q))
    spline = osc.approximate(osc.curve(SPIRAL, a, b), primitive, error * 1.0001)
    assert len(spline) == 1
    assert spline.error == pytest.approx(error, rel=1e-5)
    assert len(osc.approximate(osc.curve(SPIRAL, a, b), primitive, error * 0.999)) == 2


@pytest.mark.parametrize("a", [1, 3])
def test_a_right_turning_curve_has_the_same_pencil(a):
    left = BitangentPencil(ReferenceCurve(SPIRAL), a, a + 1)
    right = BitangentPencil(ReferenceCurve("t*cos(t), -t*sin(t)"), a, a + 1)
    q = left.best()
    assert abs(right.best() - q) < 1e-15
    assert abs(right.weight(q) - left.weight(q)) < 1e-20
    assert abs(right.displacement(a + 0.3, q).d + left.displacement(a + 0.3, q).d) < 1e-20
    assert abs(signed_area(right, q) + signed_area(left, q)) < 1e-20


def test_the_signed_area_is_that_of_the_regions_by_green():
    pencil = BitangentPencil(ReferenceCurve(SPIRAL), 1, 2)
    q = pencil.parabola
    polygon = Polygon(
        [*zip(*spiral(np.linspace(1, 2, 4001)))]
        + [tuple(map(float, pencil.member(q, mp.mpf(x)))) for x in np.linspace(1, 0, 2001)[1:-1]]
    )
    assert float(abs(signed_area(pencil, q))) == pytest.approx(polygon.area, rel=1e-3)
    # parabola: [e₁, e₂]/3 between chord and arc, e₁ and e₂ the legs; curve: ½∫[α − P₀, α′]
    p, m, r = pencil.first.point, pencil.control(q), pencil.last.point
    legs = ((m[0] - p[0]) * (r[1] - m[1]) - (m[1] - p[1]) * (r[0] - m[0])) / 3
    sector = (mp.mpf(2) ** 3 - 1) / 6  # ½∫t²dt of the spiral, from the origin
    triangle = (p[0] * r[1] - p[1] * r[0]) / 2
    assert abs(abs(signed_area(pencil, q)) - abs(legs - (sector - triangle))) < 1e-20


def test_the_equisymmetric_conic_has_equal_moons():
    pencil = BitangentPencil(ReferenceCurve(SPIRAL), 1, 3)
    first, last = moons(pencil, equisymmetric(pencil))
    assert abs(first - last) < 1e-18
    t = least_area(pencil)
    least = sum(moons(pencil, pencil.through(t)))
    assert least < first + last
    for s in (t - 0.01, t + 0.01):
        assert sum(moons(pencil, pencil.through(s))) > least


def test_gauss_is_exact_for_polynomials():
    for count in (1, 2, 7):
        for power in range(2 * count):
            value = mp.fsum(w * x**power for x, w in gauss(count, 25))
            assert abs(value - mp.mpf(1) / (power + 1)) < 1e-24


def test_more_digits_give_the_same_result():
    found = []
    for digits in (15, 40):
        with mp.workdps(digits):
            pencil = BitangentPencil(ReferenceCurve(CAYLEY), 0, 3 * mp.pi / 4)
            found.append(pencil.hausdorff(pencil.best()))
    assert abs(found[0] - found[1]) < 1e-14


def test_bad_input_is_refused():
    curve = ReferenceCurve(SPIRAL)
    with pytest.raises(DomainError, match="no chord"):
        BitangentPencil(curve, 1, 1)
    with pytest.raises(DomainError, match="two coordinates"):
        ReferenceCurve("t, t, t")
    with pytest.raises(DomainError, match="one side"):
        BitangentPencil(ReferenceCurve("t, t^3"), -1, 1)
    with pytest.raises(DomainError, match="no tangent"):
        BitangentPencil(ReferenceCurve("t^2, t^3"), 0, 1)
    with pytest.raises(DomainError, match="π or more"):
        _ = BitangentPencil(ReferenceCurve("cos(t), sin(t)"), 0, 4).parabola
    pencil = BitangentPencil(ReferenceCurve("cos(t), sin(t)"), 0, 4)
    for factor in (0.1, 10):  # normals miss the ellipse, or meet the hyperbola beyond its unbounded arc
        with pytest.raises(UndecidedError, match="misses the conic"):
            pencil.hausdorff(pencil.through(1) * factor)


def test_poles_ends_and_members_that_do_not_exist():
    with pytest.raises(DomainError, match=r"undefined at t = 0\.0"):
        BitangentPencil(ReferenceCurve("t, log(t)"), 0, 1)
    with pytest.raises(DomainError, match=r"undefined at t = 0\.0"):
        BitangentPencil(ReferenceCurve("t, 1/t"), 0, 1)
    with pytest.raises(DomainError, match="no tangent at t = nan"):
        BitangentPencil(ReferenceCurve(SPIRAL), mp.nan, 1)
    for end in ("a", None, 1j):
        with pytest.raises(DomainError, match=r"end of an arc .* is not a real number"):
            BitangentPencil(ReferenceCurve(SPIRAL), end, 1)
    pencil = BitangentPencil(ReferenceCurve("cos(t), sin(t)"), 0, 1)
    for t in (0, 1):
        with pytest.raises(DomainError, match="inner point of the arc"):
            pencil.through(t)
    for q in (-1, 0, mp.nan, "q"):
        for attempt in (
            pencil.weight,
            pencil.control,
            lambda q: pencil.member(q, 0.5),
            lambda q: pencil.displacement(0.5, q),
            pencil.peaks,
            pencil.hausdorff,
        ):
            with pytest.raises(DomainError, match="parameter Q"):
                attempt(q)


def test_a_root_at_an_end_is_found():
    assert root_between(lambda t: t, mp.mpf(0), mp.mpf(1)) == 0
    assert root_between(lambda t: t - 1, mp.mpf(0), mp.mpf(1)) == 1
    root = root_between(lambda t: mp.tanh(50 * (t - mp.mpf("0.9"))), mp.mpf(0), mp.mpf(1))
    assert abs(root - mp.mpf("0.9")) < 1e-22
