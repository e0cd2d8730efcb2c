"""Space curves with a given number of bihelices: equal errors, the inverse of a tolerance, bad requests."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

import osculant as osc
from osculant.approximation.coordinates import Coordinates
from osculant.approximation.division import divide
from osculant.approximation.equal_errors import equalise
from osculant.approximation.exact_helices import Helices
from osculant.approximation.fitting import Fitting
from osculant.cas.errors import DomainError, ToleranceError
from osculant.curves.extent import extent
from osculant.curves.space import SpaceCurve
from osculant.primitives.table import choose

CURVES = {
    "conical spiral": SpaceCurve("t*cos(t), t*sin(t), t", "pi/6", "2*pi"),
    "moment curve": SpaceCurve("t, t^2, t^3", 0, 1),
    "elliptic helix": SpaceCurve("2*cos(t), sin(t), t/5", "3/10", 3),
}
#: a closed curve whose eight stretches between vertices come in equal pairs
CROWN = SpaceCurve("cos(t), sin(t), sin(2*t)/2", 0, "2*pi")
#: errors are known to about so many units of rounding of the largest coordinate
NOISE_ULPS = 16


def errors_by_stretch(spline):
    """The pieces' errors, an array for each stretch between split points."""
    ends = [spline.knots[0], *spline.splits, spline.knots[-1]]
    return [
        np.array([p.error for p in spline.pieces if low <= p.interval[0] < high])
        for low, high in pairwise(ends)
    ]


BIHELIX = choose("bihelix", "hausdorff", dimension=3)


def fitting_of(curve):
    return Fitting(curve, BIHELIX, divide(curve, "bihelix"), extent(curve))


@pytest.mark.parametrize("name", CURVES)
def test_a_number_of_pieces_is_the_inverse_of_a_tolerance(name):
    fitting = fitting_of(CURVES[name])
    noise = NOISE_ULPS * fitting.size.rounding()
    before = math.inf
    for count in range(sum(part.least for part in fitting.parts), 61):
        runs = fitting.for_number(count).runs
        assert sum(map(len, runs)) == count
        for run in runs:
            assert np.ptp(run.errors) <= 1e-9 * run.error + 2 * noise  # rounding at both ends
        error = max(run.error for run in runs)
        assert error < before
        before = error
        assert fitting.for_tolerance(error * (1 + 1e-9)).count == count


@pytest.mark.parametrize("name", CURVES)
def test_splines_of_a_given_number_of_pieces(name):
    curve = CURVES[name]
    noise = NOISE_ULPS * extent(curve).rounding()
    for count in (4, 23, 60):
        spline = osc.approximate(curve, pieces=count)
        assert len(spline) == count
        assert (spline.given, spline.minimal, spline.rule) == ("pieces", "unknown", "equioscillating")
        assert spline.max_tangent_jump() < 1e-13
        for errors in errors_by_stretch(spline):
            assert np.ptp(errors) <= 1e-9 * errors.max() + 2 * noise
        assert spline.error <= spline.tolerance <= spline.error * (1 + 3e-7) + noise
        assert len(osc.approximate(curve, tolerance=spline.error * (1 + 1e-9))) == count
    assert spline.predicted_error == pytest.approx(spline.error, rel=0.2 if spline.splits else 1e-3)


@pytest.mark.parametrize("count", [9, 40])
def test_no_knots_nearby_are_better(count):
    (part,) = fitting_of(CURVES["conical spiral"]).parts
    spline = osc.approximate(CURVES["conical spiral"], pieces=count)
    knots = np.array(spline.knots)
    assert part.fitted(knots).error == pytest.approx(spline.error, rel=1e-10)
    rng = np.random.default_rng(count)
    for size in (1e-2, 1e-4, 1e-6):
        for _ in range(20):
            moved = knots.copy()
            moved[1:-1] += size * rng.uniform(-1, 1, count - 1) * np.diff(knots).min()
            assert part.fitted(moved).error > spline.error


def test_equal_contents_are_near_equal_errors():
    for name in ("conical spiral", "moment curve"):
        (part,) = fitting_of(CURVES[name]).parts
        errors = part.fitted(part.spread(60)).errors
        assert np.ptp(errors) < 0.05 * errors.max()


def test_stretches_share_the_pieces():
    curve = SpaceCurve("2*cos(t), sin(t), t/5", "3/10", 5)
    before = math.inf
    for count in (4, 9, 20, 33, 60):
        spline = osc.approximate(curve, pieces=count)
        stretches = errors_by_stretch(spline)
        assert (len(spline), len(stretches)) == (count, 4)
        assert spline.error <= before
        before = spline.error
        # a stretch with a piece less would have a larger error than the whole
        for part, errors in zip(fitting_of(curve).parts, stretches, strict=True):
            if len(errors) > 1:
                assert equalise(part, len(errors) - 1).error >= spline.error * (1 - 1e-9)


@pytest.mark.parametrize("rule", ["equioscillating", "thesis"])
def test_both_rules(rule):
    spline = osc.approximate(CURVES["moment curve"], pieces=12, rule=rule)
    assert (len(spline), spline.rule) == (12, rule)
    assert np.ptp(spline.errors) < 1e-9 * spline.error
    assert len(osc.approximate(CURVES["moment curve"], tolerance=spline.error, rule=rule)) == 12


def test_the_thesis_rule_has_larger_errors():
    ours, thesis = (
        osc.approximate(CURVES["conical spiral"], pieces=15, rule=rule).error
        for rule in ("equioscillating", "thesis")
    )
    assert ours < thesis < 1.6 * ours


@pytest.mark.parametrize("factor", ["10^6", "10^(-6)"])
def test_the_unit_of_length_does_not_matter(factor):
    size = float(eval_power(factor))
    spline = osc.approximate(SpaceCurve(f"{factor}*t, {factor}*t^2, {factor}*t^3", 0, 1), pieces=10)
    plain = osc.approximate(CURVES["moment curve"], pieces=10)
    assert spline.error / size == pytest.approx(plain.error, rel=1e-8)
    assert np.allclose(spline.knots, plain.knots, atol=1e-8)


def eval_power(text):
    base, exponent = text.split("^")
    return float(base) ** int(exponent.strip("()"))


@pytest.mark.parametrize(
    ("text", "high", "kind", "least", "numbers"),
    [
        ("2*cos(t), 2*sin(t), 1", "2*pi", "arc", 2, 5),
        ("3*cos(t), 3*sin(t), 4*t", "4*pi", "helix", 3, 6),
        ("3*cos(t^2 + t), 3*sin(t^2 + t), -4*t^2 - 4*t", "7/2", "helix", 3, 6),
        ("t^3 + t, 2*t^3 + 2*t, 1 - t^3 - t", "5", "segment", 1, 3),
    ],
)
def test_exact_curves_take_any_number_of_pieces(text, high, kind, least, numbers):
    curve = SpaceCurve(text, 0, high)
    size = extent(curve).size
    for count in (least, least + 1, 17):
        spline = osc.approximate(curve, pieces=count)
        assert [piece.kind for piece in spline.pieces] == [kind] * count
        assert (spline.error, spline.error_kind) == (0.0, "exact")
        assert spline.predicted_pieces == least
        assert spline.numbers == 3 + numbers * count
        lengths = [piece.length for piece in spline.pieces]
        assert max(lengths) < 1.001 * min(lengths)
        assert all(piece.arcs[0].turning < math.tau for piece in spline.pieces)
        for piece in spline.pieces:  # ends are the curve's
            for point, t in ((piece.start, piece.interval[0]), (piece.end, piece.interval[1])):
                assert math.dist(point, curve.compiled(t)[:, 0]) < 1e-13 * size
        assert spline.max_tangent_jump() < 1e-12
    if least > 1:
        with pytest.raises(DomainError, match=f"takes at least {least}, as it turns too far"):
            osc.approximate(curve, pieces=least - 1)


def test_a_whole_turn_is_too_much_for_one_arc():
    for high, least in (("2*pi - 10^(-6)", 1), ("2*pi", 2), ("4*pi", 3)):
        curve = SpaceCurve("cos(t), sin(t), 0", 0, high)
        (stretch,) = divide(curve, "bihelix").stretches
        assert Helices(Coordinates(curve, extent(curve)), BIHELIX, stretch).least == least


def test_closed_curves():
    spline = osc.approximate(CROWN, pieces=24, closed=True)
    assert spline.closed and spline.to_json()["closed"] is True
    assert np.allclose(spline.pieces[0].start, spline.pieces[-1].end, atol=1e-14)
    first, last = spline.pieces[0], spline.pieces[-1]
    assert np.allclose(first.tangent(0.0), last.tangent(1.0), atol=1e-14)
    for closed in (None, False):
        again = osc.approximate(CROWN, pieces=24, closed=closed)
        assert again == spline
    assert not osc.approximate(CURVES["moment curve"], pieces=3).closed
    with pytest.raises(DomainError, match="is not closed: it begins at"):
        osc.approximate(SpaceCurve("cos(t), sin(t), sin(2*t)/2", 0, "6.2832"), closed=True)


def test_vertices_need_not_split():
    split, whole = (osc.approximate(CROWN, tolerance=1e-4, split=split) for split in ("theory", "never"))
    assert (split.split, whole.split) == ("theory", "never")
    assert len(split.splits) == 7
    assert whole.splits == ()
    assert len(whole) < len(split)
    assert whole.error <= 1e-4
    # theory's integral has the same singularities
    assert whole.predicted == pytest.approx(split.predicted, rel=1e-12)
    assert whole.predicted_pieces <= split.predicted_pieces
    cusp = osc.approximate(SpaceCurve("t^2, t^3, t^4", -1, 1), pieces=8, split="never")
    assert cusp.splits == tuple(cusp.cusps) == (0.0,)
    flat = osc.approximate(SpaceCurve("t, t^3, 0", -1, 1), pieces=8, split="never")
    assert flat.splits == (0.0,)


def test_cusps_with_any_number_of_pieces():
    curve = SpaceCurve("t^2, t^3, t^4", -1, 1)
    for count in (2, 3, 10, 11, 30):
        spline = osc.approximate(curve, pieces=count)
        assert len(spline) == count
        assert spline.cusps == [0.0]
        assert spline.max_tangent_jump() < 1e-13


def test_what_the_spline_says():
    spline = osc.approximate(CURVES["moment curve"], "best", pieces=7)
    assert (spline.primitive, spline.given, spline.gap) == ("bihelix", "pieces", None)
    assert spline.choice == ("bihelix: 7 pieces, 87 numbers",)
    assert spline.numbers == 3 + 7 * 12
    data = spline.to_json()
    assert {name: data[name] for name in ("closed", "split", "given", "gap", "choice")} == {
        "closed": False, "split": "theory", "given": "pieces", "gap": None,
        "choice": list(spline.choice),
    }  # fmt: skip
    assert data["predicted_error"] == spline.predicted_error
    plain = osc.approximate(CURVES["moment curve"], tolerance=1e-3)
    assert (plain.choice, plain.given, plain.tolerance) == (None, "tolerance", 1e-3)


def test_bad_requests():
    curve = CURVES["moment curve"]
    for bad in (0, -3, 2.5, "many"):
        with pytest.raises(DomainError, match=f"number of pieces is {bad}: give a whole number"):
            osc.approximate(curve, pieces=bad)
    with pytest.raises(DomainError, match=r"Both a tolerance, 0\.1, and a number of pieces, 3, are given"):
        osc.approximate(curve, tolerance=0.1, pieces=3)
    with pytest.raises(DomainError, match="takes at least 8, as it is split into 8 parts"):
        osc.approximate(CROWN, pieces=7)
    with pytest.raises(DomainError, match="metric 'area' is one of plane curves"):
        osc.approximate(curve, pieces=3, metric="area")
    with pytest.raises(DomainError, match="way to split 'often' is unknown"):
        osc.approximate(curve, pieces=3, split="often")
    with pytest.raises(ToleranceError, match="below the rounding floor"):
        osc.approximate(curve, tolerance=1e-15)
