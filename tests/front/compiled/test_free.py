"""Curves whose interval or constants are arguments, and curves of the caller's own."""

import ctypes
import math
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import numpy as np
import pytest

import osculant as osc
from tests.front.compiled.fixed import greedy, knots_of, needs_cc, needs_libm_alone

pytestmark = needs_cc


@pytest.fixture(scope="module")
def ellipse(tmp_path_factory):
    folder = tmp_path_factory.mktemp("ellipse")
    return osc.compile_approximator("a*cos(t), b*sin(t)", "biarc", parameters="a b", folder=folder).load()


@pytest.mark.parametrize(
    ("a", "b", "low", "high"), [(2, 1, 0.0, 6.0), (3, 1, 0.2, 5.0), (1.5, 1.4, 1.0, 3.0)]
)
def test_special_points_are_found_at_run_time(ellipse, a, b, low, high):
    curve = osc.curve(f"{a}*cos(t), {b}*sin(t)", low, high)
    for tolerance in (1e-2, 1e-4):
        spline = osc.approximate(curve, "biarc", tolerance, closed=False)
        pieces = ellipse.approximate(low, high, a, b, tolerance)
        assert len(pieces) == len(spline)
        assert np.abs(knots_of(pieces) - np.array(spline.knots)).max() < 1e-11
        vertices = [k * math.pi / 2 for k in range(1, 4) if low < k * math.pi / 2 < high]
        assert all(np.abs(knots_of(pieces) - at).min() < 1e-15 * 10 for at in vertices)


def test_a_circle_among_ellipses_has_no_special_points(ellipse):
    assert len(ellipse.approximate(0.0, 3.0, 1.0, 1.0, 1e-9)) == 1


def test_a_sweep_of_many_ellipses(ellipse):
    rng = np.random.default_rng(5)
    for a, b in rng.uniform(0.5, 5.0, (2000, 2)):
        pieces = ellipse.approximate(0.0, math.pi / 2, a, b, 1e-3)
        assert pieces["error"].max() <= 1e-3
        # the ends are on the ellipse, and the first piece is perpendicular to the axis
        assert math.isclose(pieces["x0"][0], a) and abs(pieces["x2"][-1]) < 1e-15 * a * 2
        assert abs(pieces["tx0"][0]) < 1e-15 and pieces["ty0"][0] == 1.0
        inner = pieces[1:]
        on = (inner["x0"] / a) ** 2 + (inner["y0"] / b) ** 2
        assert np.abs(on - 1.0).max(initial=0.0) < 1e-14


@pytest.mark.slow
def test_a_sweep_of_a_hundred_thousand_ellipses(tmp_path):
    """Ellipses and their mirror images take as many biarcs; some are compared with the kernels' own."""
    module = osc.compile_approximator(
        "a*cos(t), b*sin(t)", "biarc", 0, "2*pi", parameters="a b", folder=tmp_path
    ).load()
    axes = np.random.default_rng(8).uniform(0.5, 5.0, (50_000, 2))
    counts = [(len(module.approximate(a, b, 1e-3)), len(module.approximate(b, a, 1e-3))) for a, b in axes]
    assert all(one == other and one % 4 == 0 for one, other in counts)
    assert len(set(counts)) == 4
    for a, b in axes[::250]:
        formula = f"({Fraction(a)})*cos(t), ({Fraction(b)})*sin(t)"
        knots, errors = greedy((formula, 0, "2*pi"), "biarc", 1e-3)
        pieces = module.approximate(a, b, 1e-3)
        assert knots_of(pieces).tolist() == knots.tolist() and pieces["error"].tolist() == errors.tolist()


def test_two_threads_find_the_same_bits(ellipse):
    def work(shift):
        return [ellipse.approximate(0.0, 6.0, 2.0 + i % 7, 1.0, 1e-6).tobytes() for i in range(60)]

    with ThreadPoolExecutor(2) as pool:
        first, second = pool.map(work, range(2))
    assert first == second == work(0)


CURVES = [
    ("t, sin(t)+sin(3*t)/5", "conic", 0.0, 6.0),
    ("t, t^3", "parabola", -1.0, 1.5),
    ("t^2, t^3", "conic", -1.0, 1.0),
    ("2*cos(t), sin(t), t/5", "bihelix", 1.0, 4.0),
]


@pytest.mark.parametrize(("formula", "primitive", "low", "high"), CURVES)
def test_free_intervals_have_as_many_pieces(tmp_path, formula, primitive, low, high):
    module = osc.compile_approximator(formula, primitive, folder=tmp_path).load()
    for tolerance in (1e-2, 1e-5):
        spline = osc.approximate(osc.curve(formula, low, high), primitive, tolerance, closed=False)
        pieces = module.approximate(low, high, tolerance)
        assert len(pieces) == len(spline)
        assert np.abs(knots_of(pieces) - np.array(spline.knots)).max() < 1e-10


WAVE, TUBE = "t, {a}*sin(t)+{b}*exp(-t)", "2*cos({a}*t), {b}*sin(t), t/5"
#: formula, primitive, and its constants and interval; the first has a cusp and special points, others a few
SAME = [
    ("{a}*t^2, t^3+{b}*t^4", "conic", (0.7, 0.3, -1.0, 1.2)),
    ("t*cos({a}*t), {b}*sin(t)", "conic", (1.1, 2.0, 0.5, 6.0)),
    (WAVE, "parabola", (0.3, 0.7, -1.0, 6.0)),
    ("{a}*cos(t), {b}*sin(t)", "biarc", (1.3, 0.7, 0.2, 6.1)),
    (TUBE, "bihelix", (1.0, 0.8, 0.5, 6.0)),
    ("t, {a}/({b}+t^2)", "polygon", (1.0, 0.04, -1.0, 1.0)),
    (WAVE, "cubic", (0.3, 0.7, -1.0, 6.0)),
    ("exp({a}*t)*cos(t), log(3+{b}*sin(t))*atan(t)", "conic", (0.2, 0.9, 0.1, 7.0)),
]


@pytest.mark.parametrize(("formula", "primitive", "at"), SAME)
def test_knots_are_those_of_the_kernels(tmp_path, formula, primitive, at):
    """To the last bit, also where rounding moves knots, if Python has the same curve."""
    a, b, low, high = at
    module = osc.compile_approximator(
        formula.format(a="a", b="b"), primitive, parameters="a b", folder=tmp_path
    ).load()
    exact = formula.format(a=f"({Fraction(a)})", b=f"({Fraction(b)})")
    for tolerance in (1e-1, 1e-2, 1e-4, 1e-7) if primitive != "cubic" else (1e-1, 1e-3, 1e-6):
        knots, errors = greedy((exact, Fraction(low), Fraction(high)), primitive, tolerance)
        pieces = module.approximate(low, high, a, b, tolerance)
        assert knots_of(pieces).tolist() == knots.tolist()
        assert pieces["error"].tolist() == errors.tolist()


#: curves that stand still: at a double, beside one, on the grid, going on and turning back
STILL = [
    ("2*cos(t)+cos(2*t), 2*sin(t)-sin(2*t)", ("conic", "parabola", "biarc", "cubic", "polygon"), 0, 6),
    ("t-sin(t), 1-cos(t)", ("parabola", "cubic"), -1, 15),
    ("(t-1/3)^2, (t-1/3)^3", ("parabola", "cubic"), -1, 1),
    ("(t-1/3)^3, (t-1/3)^4", ("conic", "biarc", "polygon"), -1, 1),
    ("(t-1/3)^4, (t-1/3)^5", ("conic", "parabola", "biarc"), -1, 1),
    ("(t-1/3)^5, (t-1/3)^7", ("conic", "polygon"), -1, 1),
    ("(t-1/3)^2, (t-1/3)^3, (t-1/3)^4", ("bihelix", "polygon"), -1, 1),
]


@pytest.mark.parametrize(
    ("formula", "primitive", "low", "high"),
    [(formula, name, low, high) for formula, names, low, high in STILL for name in names],
)
def test_where_a_curve_stands_still_it_is_split(tmp_path, formula, primitive, low, high):
    module = osc.compile_approximator(formula, primitive, folder=tmp_path).load()
    for tolerance in (1e-2, 1e-5):
        knots, errors = greedy((formula, low, high), primitive, tolerance)
        pieces = module.approximate(float(low), float(high), tolerance)
        assert knots_of(pieces).tolist() == knots.tolist()
        assert pieces["error"].tolist() == errors.tolist()


def test_features_between_samples_are_seen(tmp_path):
    """A bump on a line, far narrower than panels that are even, with its inflections."""
    formula = "t, a*exp(-((t - b)*10^4)^2)"
    exact = formula.replace("a*", "(1/4)*").replace("b", "79/128")
    for primitive in ("polygon", "conic"):
        module = osc.compile_approximator(
            formula, primitive, parameters="a b", folder=tmp_path, name=primitive
        ).load()
        pieces = module.approximate(0.0, 1.0, 0.25, 0.6171875, 1e-3)
        knots, _ = greedy((exact, 0, 1), primitive, 1e-3)
        assert len(pieces) == 6 and knots_of(pieces).tolist() == knots.tolist()


def test_special_points_are_taken_from_the_caller(ellipse):
    given = ellipse.approximate(1.0, 3.0, 2.0, 1.0, 1e-3, splits=[math.pi / 2])
    found = ellipse.approximate(1.0, 3.0, 2.0, 1.0, 1e-3)
    assert len(given) == len(found)
    assert np.abs(knots_of(given) - knots_of(found)).max() < 1e-12
    more = ellipse.approximate(1.0, 3.0, 2.0, 1.0, 1e-3, splits=[1.25, math.pi / 2])
    assert 1.25 in knots_of(more)
    assert len(ellipse.approximate(1.6, 3.0, 2.0, 1.0, 1e-3, splits=[])) >= 1
    with pytest.raises(ellipse.Failure, match="argument"):
        ellipse.approximate(1.0, 3.0, 2.0, 1.0, 1e-3, splits=[2.0, 1.5])


def test_statuses(ellipse):
    cases = {
        2: (0.0, 6.0, 2.0, 1.0, 1e-14),
        3: (0.0, 6.0, math.nan, 1.0, 1e-3),
        6: (6.0, 0.0, 2.0, 1.0, 1e-3),
    }
    for status, arguments in cases.items():
        with pytest.raises(ellipse.Failure) as caught:
            ellipse.approximate(*arguments)
        assert caught.value.status == status
    with pytest.raises(ellipse.Failure) as caught:
        ellipse.approximate(0.0, 6.0, 2.0, 1.0, -1.0)
    assert caught.value.status == 6
    with pytest.raises(ellipse.Failure) as caught:
        ellipse.approximate(0.0, 6.0, 2.0, 1.0, pieces=1)
    assert caught.value.status == 7 and caught.value.count >= 4
    with pytest.raises(ValueError, match="either"):
        ellipse.approximate(0.0, 6.0, 2.0, 1.0)


def test_an_array_that_is_too_small_is_not_written_beyond(ellipse):
    function = ellipse._for_tolerance
    whole = ellipse.approximate(0.0, 6.0, 2.0, 1.0, 1e-4)
    room = np.full(len(whole), -1.0, dtype=np.float64).repeat(len(ellipse.PIECE)).view(ellipse.PIECE)
    parameters, count = np.array([2.0, 1.0]), ctypes.c_size_t(0)
    small = len(whole) - 3
    status = function(
        0.0,
        6.0,
        ellipse._pointer(parameters),
        1e-4,
        None,
        0,
        ellipse._pointer(room),
        small,
        ctypes.byref(count),
    )
    assert status == 1 and count.value == len(whole)
    assert room[:small].tobytes() == whole[:small].tobytes()
    assert set(room[small:].tolist()) == {(-1.0,) * len(ellipse.PIECE)}


def test_a_jet_of_the_callers_own(tmp_path):
    module = osc.compile_approximator(None, "conic", jet=2, folder=tmp_path).load()
    seen = []

    @ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_double))
    def jet(t, parameters, out):
        seen.append(parameters[0])
        k = parameters[0]
        out[0], out[1], out[2] = t, 1.0, 0.0
        out[3], out[4], out[5] = math.exp(k * t), k * math.exp(k * t), k * k * math.exp(k * t)

    pieces = module.approximate(jet, 0.0, 3.0, 1e-5, parameters=[0.5])
    spline = osc.approximate(osc.curve("t, exp(t/2)", 0, 3), "conic", 1e-5)
    assert set(seen) == {0.5}
    assert len(pieces) == len(spline)
    assert np.abs(knots_of(pieces) - np.array(spline.knots)).max() < 1e-9


def test_errors_are_distances(ellipse):
    """Against an independent two-sided distance."""
    from osculant.pieces.biarcs import Biarc

    def points(times):
        return np.stack([3.0 * np.cos(times), np.sin(times)], axis=-1)

    for row in ellipse.approximate(0.1, 1.5, 3.0, 1.0, 1e-3).tolist():
        a, b, error, *numbers = row
        starts = [tuple(numbers[i : i + 2]) for i in range(0, 10, 2)]
        piece = Biarc("biarc", (a, b), *starts[:3], (starts[3], starts[4]), tuple(numbers[10:]), error)
        t = np.linspace(a, b, 4001)
        dense = points(t)
        nodes = np.concatenate([arc.point(np.linspace(0, 1, 20001)) for arc in piece.arcs])
        nearest = [np.sqrt(((nodes - p) ** 2).sum(axis=1)).min() for p in dense[::40]]
        assert max(nearest) == pytest.approx(error, rel=2e-3)


def test_no_symbols_but_those_of_libm(tmp_path):
    made = [
        osc.compile_approximator(
            "a*cos(t), b*sin(t)", "conic", parameters="a b", folder=tmp_path, name="one"
        ),
        osc.compile_approximator("t, t^2, exp(t)", "bihelix", folder=tmp_path, name="two"),
        osc.compile_approximator(None, "cubic", jet=2, folder=tmp_path, name="three"),
        osc.compile_evaluator("t, t^2, exp(t)", "invariants", folder=tmp_path, name="four"),
        osc.compile_evaluator("t, tan(t)", "distance", 0, 1, folder=tmp_path, name="five"),
    ]
    for library in made:
        needs_libm_alone(library.library)
