"""The main job: counts, errors, splits and limits of `approximate`, checked from outside."""

import math

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import osculant as osc
from osculant.kernels.curves.jets import sample_many
from osculant.kernels.curves.plane import JET_SIZE
from tests.hausdorff import Formula
from tests.hausdorff import distance as precise_distance
from tests.oracles import hausdorff

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
SEXTIC = ("4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)", "-3*pi/4", "3*pi/4")
# plane.md's tables 3.1 and 3.3 for 1e-1 … 1e-8
COUNTS = {
    ("spiral", "parabola"): [5, 9, 15, 26, 46, 82, 145, 257],
    ("spiral", "conic"): [3, 4, 6, 9, 13, 21, 32, 51],
    ("sextic", "parabola"): [6, 8, 14, 24, 44, 76, 134, 238],
    ("sextic", "conic"): [2, 4, 6, 8, 12, 18, 28, 44],
}


def points_of(curve):
    """The curve as a function of arrays."""

    def at(t):
        jets = np.empty((len(t), JET_SIZE))
        sample_many(curve.compiled.address, np.ascontiguousarray(t), jets)
        return jets[:, 0], jets[:, 3]

    return at


def check_spline(spline, sample=12):
    """What every spline promises; the error against an independent two-sided distance, piece by piece."""
    curve, tolerance = spline.curve, spline.tolerance
    assert spline.error <= tolerance
    forced = {*spline.splits, *spline.undecided, spline.knots[-1]}
    largest = float(np.abs(spline.sample(3)).max())
    delta = max(1e-6, 32 * math.ulp(largest) / tolerance)
    if spline.minimal != "unknown":  # one piece of a stretch, the first or the last, takes what is left
        left = 0
        for piece in spline.pieces:
            left += piece.error < tolerance * (1 - delta)
            assert piece.error <= tolerance and left <= 1
            left = 0 if piece.interval[1] in forced else left
    for before, after in zip(spline.pieces, spline.pieces[1:]):
        assert before.end == after.start
        assert before.interval[1] == after.interval[0]
    assert spline.max_tangent_jump() < 1e-12 * max(1.0, largest)
    step = max(1, len(spline) // sample)
    points = points_of(curve)
    for i, piece in list(enumerate(spline.pieces))[::step]:
        distance = hausdorff(points, [piece])
        slack = 64 * math.ulp(largest) if piece.error else 1e-11 * largest  # golden section, at cusps
        if abs(distance - piece.error) > 1e-5 * piece.error + slack:  # it misses much at sharp bends
            distance = finer(spline, i)
        assert distance <= piece.error * (1 + 1e-5) + slack
        bends = curve.tabulate(np.linspace(*piece.interval, 200))["curvature"]
        # where normals meet, or an arc is passed over, the error is an upper bound
        if np.nanmax(np.abs(bends)) * tolerance < 0.5 and not spline.bridged:
            assert distance == pytest.approx(piece.error, rel=1e-5, abs=slack)


def finer(spline, i):
    """The distance of a piece from its arc by extended precision."""
    (low, high), a, b = spline.curve.ends, *spline.curve.interval
    formula = Formula(spline.curve.text, str(low), str(high))
    segment = spline.to_json()["segments"][i]
    return float(precise_distance(formula, segment, formula.parts(a, b, 1e-3 * spline.tolerance), 6))


@pytest.mark.parametrize(("name", "primitive"), COUNTS)
def test_counts_of_the_tables(name, primitive):
    curve = osc.curve(*(SPIRAL if name == "spiral" else SEXTIC))
    split_at = () if name == "spiral" else (0,)
    counts = [
        len(osc.approximate(curve, primitive, 10.0**-e, split_at=split_at))
        for e in range(1, len(COUNTS[name, primitive]) + 1)
    ]
    assert counts == COUNTS[name, primitive]


def test_deeper_than_the_tables():
    spiral = osc.curve(*SPIRAL)
    assert [len(osc.approximate(spiral, "conic", e)) for e in (1e-9, 1e-10)] == [81, 127]
    # plane.md: 201.2 and 318.9; near the rounding floor the window of errors costs up to δ/5 of the count
    assert len(osc.approximate(spiral, "conic", 1e-11)) == 202
    assert 319 <= len(osc.approximate(spiral, "conic", 1e-12)) <= 319 * (1 + 0.03 / 5) + 1


def test_unsplit_parabolas_on_the_sextic():
    sextic = osc.curve(*SEXTIC)
    assert [len(osc.approximate(sextic, "parabola", 10.0**-e)) for e in (5, 6, 7, 8)] == [43, 75, 133, 237]


def test_one_conic_on_the_half_sextic_at_one_tenth():
    # turning by π exactly: w = 0, out of reach of a parameter by w or by P₁
    spline = osc.approximate(osc.curve(SEXTIC[0], 0, SEXTIC[2]), "conic", 0.1)
    assert len(spline) == 1
    assert abs(spline.pieces[0].weight) < 1e-12
    assert spline.error == pytest.approx(0.0933688, abs=1e-7)
    check_spline(spline)


@pytest.mark.parametrize("exponent, count", [(3, 2), (6, 8), (9, 29)])
def test_arcs_that_end_at_an_inflection(exponent, count):
    assert len(osc.approximate(osc.curve("t, t^3", 0, 1), "conic", 10.0**-exponent)) == count


@pytest.mark.parametrize(
    ("formula", "low", "high", "splits"),
    [
        ("t^2, t^3", -1, 1, (0.0,)),
        ("t - sin(t), 1 - cos(t)", 1, 8, (math.pi, 2 * math.pi)),
        ("cos(t)^3, sin(t)^3", 0, "2*pi", tuple(k * math.pi / 4 for k in range(1, 8))),
        ("t, t^4", -1, 1, (0.0,)),
        ("t, exp(-t^2)", -2, 2, None),
        ("cos(t)*(3 + cos(5*t)), sin(t)*(3 + cos(5*t))", 0, "2*pi", None),
        ("t + exp(t)/9, log(t + 2)", -1, 3, None),
        ("t, cbrt(t + 2)*atan(t)", -1, 3, None),
        ("t, t^100", -1, 1, None),
        ("2*t/(1 + t^4), t^2/(1 + t^4)", -1, 2, None),
    ],
)
@pytest.mark.parametrize("primitive", ["conic", "parabola"])
def test_odd_curves(formula, low, high, splits, primitive):
    spline = osc.approximate(osc.curve(formula, low, high), primitive, 1e-5)
    if primitive == "conic" and splits is not None:
        assert spline.splits == pytest.approx(splits, abs=1e-15)
    if (
        "100" not in formula
    ):  # that is flat to rounding on half its interval, and its zero of order 98 undecided
        assert spline.undecided == ()
        assert spline.minimal in ("by theory", "proved")
    check_spline(spline)


def test_a_parabola_that_would_turn_beyond_pi_is_cut_shorter():
    ring = osc.approximate(osc.curve("(1 + t/100)*cos(t), (1 + t/100)*sin(t)", 0, "2*pi"), "parabola", 100)
    assert len(ring) >= 3
    check_spline(ring)


def test_conics_themselves():
    ellipse = osc.approximate(osc.curve("3*cos(t), 2*sin(t)", 0, "2*pi"), "conic", 1e-9)
    assert (len(ellipse), ellipse.error, ellipse.error_kind) == (3, 0.0, "exact")
    assert ellipse.knots == pytest.approx([0, 2 * math.pi / 3, 4 * math.pi / 3, 2 * math.pi])
    half = osc.approximate(osc.curve("3*cos(t), 2*sin(t)", 0, "3*pi/4"), "conic", 1e-9)
    assert (len(half), half.minimal) == (1, "proved")
    for formula in ("t, 1/t", "cosh(t), sinh(t)", "t, sqrt(1 + t^2)", "(1-t^2)/(1+t^2), 2*t/(1+t^2)"):
        spline = osc.approximate(osc.curve(formula, "1/2", 2), "conic", 1e-9)
        assert (len(spline), spline.error_kind) == (1, "exact")
        points = points_of(spline.curve)
        assert hausdorff(points, spline.pieces) < 1e-14
    parabola = osc.approximate(osc.curve("t + t^2, t - t^2", -3, 4), "parabola", 1e-9)
    assert (len(parabola), parabola.pieces[0].kind, parabola.error) == (1, "parabola", 0.0)
    # an ellipse is no parabola
    assert len(osc.approximate(osc.curve("3*cos(t), 2*sin(t)", 0, "2*pi"), "parabola", 1e-3)) > 8


def test_straight_lines_are_segments():
    line = osc.approximate(osc.curve("exp(t), 2*exp(t) - 1", 0, 1), "conic", 1e-9)
    assert [piece.kind for piece in line.pieces] == ["segment"]
    assert (line.error_kind, line.minimal) == ("exact", "proved")
    there_and_back = osc.approximate(osc.curve("sin(t), 2*sin(t)", 0, "pi"), "conic", 1e-9)
    assert there_and_back.splits == pytest.approx((math.pi / 2,))
    assert len(there_and_back) == 2


def spline_counts(formula, low, high, tolerance):
    return [
        len(osc.approximate(osc.curve(formula, low, high), primitive, tolerance))
        for primitive in ("conic", "parabola")
    ]


@pytest.mark.parametrize("exponent", [3, 7])
def test_counts_do_not_depend_on_the_frame(exponent):
    x, y = "exp(t/2)*cos(2*t)", "t + sin(t)^2"
    expected = spline_counts(f"{x}, {y}", 0, 2, 10.0**-exponent)
    assert spline_counts(f"{y}, {x}", 0, 2, 10.0**-exponent) == expected  # mirrored
    for scale in (6, -6, 150, -150):
        moved = f"({x})*10^{scale}, ({y})*10^{scale}".replace("^-", "^(-") if scale > 0 else ""
        moved = moved or f"({x})/10^{-scale}, ({y})/10^{-scale}"
        assert spline_counts(moved, 0, 2, float(f"1e{scale - exponent}")) == expected
    shifted = f"{x} + 10^6, {y} - 10^6"
    if exponent == 3:
        assert spline_counts(shifted, 0, 2, 10.0**-exponent) == expected


@pytest.mark.parametrize("exponent", [2, 4, 6])
def test_reversed_curves(exponent):
    # the greedy count from the other end is the same minimum
    curve, back = "t*cos(t), t*sin(t)", "(-t)*cos(-t), (-t)*sin(-t)"
    forth = spline_counts(curve, "pi/6", "2*pi", 10.0**-exponent)
    assert spline_counts(back, "-2*pi", "-pi/6", 10.0**-exponent) == forth


def test_split_points_of_the_user():
    spiral = osc.curve(*SPIRAL)
    spline = osc.approximate(spiral, "conic", 1e-6, split_at=["pi", 4])
    assert spline.splits == (math.pi, 4.0)
    assert {math.pi, 4.0} <= set(spline.knots)
    check_spline(spline)


def test_a_cusp_at_an_irrational_place_is_a_knot():
    spline = osc.approximate(osc.curve("(t^3 - 2)^2, (t^3 - 2)^3", 1, 2), "conic", 1e-4)
    assert not spline.undecided
    assert any(abs(knot - 2 ** (1 / 3)) < 1e-9 for knot in spline.knots)


@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc", "cubic", "polygon"])
@pytest.mark.parametrize(
    ("formula", "cusps"),
    [
        ("2*cos(t)+cos(2*t), 2*sin(t)-sin(2*t)", (2 * math.pi / 3, 4 * math.pi / 3)),
        ("(t-1/3)^2, (t-1/3)^3", (1 / 3,)),
        ("(t-1/3)^4, (t-1/3)^5", (1 / 3,)),
    ],
)
def test_cusps_between_doubles_are_not_passed_over(formula, cusps, primitive):
    for tolerance in (1e-2, 1e-4):
        spline = osc.approximate(osc.curve(formula, 0, 6), primitive, tolerance)
        assert not spline.bridged
        assert all(min(abs(knot - cusp) for knot in spline.knots) <= math.ulp(cusp) for cusp in cusps)


def test_undecided_points_are_knots_and_spoil_the_claim(monkeypatch):
    monkeypatch.setattr("osculant.cas.zeros.isolate.WORK_LIMIT", 20)
    for limit in ("special.SOON", "special.LIMIT", "first_look.MOST"):
        monkeypatch.setattr(f"osculant.curves.{limit}", 20)
    spline = osc.approximate(osc.curve("t, sin(t) + sin(3*t)/5", 0, 9), "conic", 1e-4)
    assert spline.undecided and set(spline.undecided) <= {0.0, 9.0, *spline.knots}
    assert spline.minimal == "unknown"


coefficient = st.integers(-4, 4)


@st.composite
def rational(draw):
    terms = "+".join(f"({draw(coefficient)})*t^{k}" for k in range(4))
    return f"({terms})/(1+{draw(st.integers(0, 4))}*t^2)"


@st.composite
def trigonometric(draw):
    names = st.sampled_from(["sin", "cos"])
    return "+".join(f"({draw(coefficient)})*{draw(names)}({draw(st.integers(1, 3))}*t)" for _ in range(3))


RANDOM_JOBS = (
    st.one_of(st.tuples(rational(), rational()), st.tuples(trigonometric(), trigonometric())),
    st.sampled_from(["conic", "parabola"]),
    st.integers(1, 7),
)


@settings(max_examples=25, suppress_health_check=list(HealthCheck))
@given(*RANDOM_JOBS)
def test_random_curves_against_an_independent_distance(formulas, primitive, exponent):
    check_random_job(formulas, primitive, exponent)


@pytest.mark.slow
@settings(max_examples=150, suppress_health_check=list(HealthCheck))
@given(*RANDOM_JOBS)
def test_many_random_curves(formulas, primitive, exponent):
    check_random_job(formulas, primitive, exponent)


def check_random_job(formulas, primitive, exponent):
    curve = osc.curve(", ".join(formulas), "-0.9", "1.3")
    try:
        spline = osc.approximate(curve, primitive, 10.0**-exponent)
    except osc.DomainError as error:
        assert "single point" in str(error)
        return
    check_spline(spline, sample=4)


@pytest.mark.parametrize(
    ("formula", "low", "high", "tolerance", "error", "words"),
    [
        ("t, 1/t", -1, 1, 1e-3, osc.DomainError, "t = 0 "),
        ("t, tan(t)", 0, 3, 1e-3, osc.DomainError, "t = 1.570796"),
        ("t, sqrt(t - 1)", 0, 3, 1e-3, osc.DomainError, "t = 0 "),
        ("t, log(t)", 0, 1, 1e-3, osc.DomainError, "t = 0 "),
        ("t, abs(t - 1)", 0, 3, 1e-3, osc.DomainError, "t = 1 "),
        ("t, cbrt(t)", -1, 1, 1e-3, osc.DomainError, "t = 0 "),
        ("t, exp(t)", 0, 1000, 1e-3, osc.DomainError, "range of double"),
        ("1, 2", 0, 1, 1e-3, osc.DomainError, "single point"),
        ("t, t^3", 0, 1, 0, osc.ToleranceError, "positive"),
        ("t, t^3", 0, 1, -1, osc.ToleranceError, "positive"),
        ("t, t^3", 0, 1, math.nan, osc.ToleranceError, "positive"),
        ("t, t^3", 0, 1, "much", osc.ToleranceError, "'much'"),
        ("t, t^3", 0, 1, 1e-14, osc.ToleranceError, "2.22e-13"),
    ],
)
def test_refusals_name_the_thing(formula, low, high, tolerance, error, words):
    with pytest.raises(error, match=words):
        osc.approximate(osc.curve(formula, low, high), "conic", tolerance)


def test_refused_choices():
    curve = osc.curve(*SPIRAL)
    with pytest.raises(osc.DomainError, match="circle"):
        osc.approximate(curve, "circle", 1e-3)
    with pytest.raises(osc.DomainError, match="metric 'volume' is unknown"):
        osc.approximate(curve, "conic", 1e-3, metric="volume")
    with pytest.raises(osc.DomainError, match="split point 7"):
        osc.approximate(curve, "conic", 1e-3, split_at=[7])
    with pytest.raises(osc.DomainError, match="no interval"):
        osc.approximate(osc.curve("t, t^3"), "conic", 1e-3)
