"""Splines across sextactic points, zeros of k and vertices: `split="never"`."""

from __future__ import annotations

import numpy as np
import pytest

import osculant as osc
from osculant.cas.errors import DomainError

SEXTIC = ("4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)", "-3*pi/4", "3*pi/4")


def test_the_sextic_unsplit_takes_the_known_numbers():
    curve = osc.curve(*SEXTIC)
    for power, count in enumerate((2, 3, 5, 7, 11, 17, 27, 43), 1):
        spline = osc.approximate(curve, "conic", 10.0**-power, split="never")
        assert len(spline) == count
        assert max(spline.errors) <= 10.0**-power
        assert (spline.split, spline.splits) == ("never", ())
        assert spline.minimal in ("unknown", "proved")


@pytest.mark.parametrize("metric", ["hausdorff", "area"])
@pytest.mark.parametrize(
    ("primitive", "formula"),
    [
        ("conic", SEXTIC),
        ("conic", ("t, cosh(t)", -1.5, 2)),
        ("conic", ("cos(t) + cos(2*t)/20, sin(t)", 0, 3)),
        ("parabola", ("t, exp(t)", -1, 1)),
        ("parabola", ("t, 1/(1 + t^2)", -0.5, 0.5)),
        ("biarc", ("2*cos(t), sin(t)", 0.3, 5)),
    ],
)
def test_unsplit_takes_no_more_pieces_and_keeps_the_tolerance(primitive, formula, metric):
    curve = osc.curve(*formula)
    for tolerance in (1e-2, 1e-4, 1e-6):
        split, unsplit = (
            osc.approximate(curve, primitive, tolerance, metric=metric, split=how)
            for how in ("theory", "never")
        )
        assert len(unsplit) <= len(split)
        assert unsplit.error <= tolerance


def test_unsplit_errors_are_certified():
    spline = osc.approximate(osc.curve(*SEXTIC), "conic", 1e-4, split="never")
    certificate = spline.certify()
    assert certificate.within
    assert certificate.lower <= spline.error <= 1e-4
    assert spline.error_kind == "certified"
    assert spline.minimal == "unknown"


def test_unsplit_with_a_number_of_pieces():
    curve = osc.curve(*SEXTIC)
    spline = osc.approximate(curve, "conic", pieces=7, split="never")
    assert len(spline) == 7
    assert spline.error < osc.approximate(curve, "conic", pieces=7).error
    assert max(spline.errors) <= min(spline.errors) * (1 + 1e-6)
    assert np.allclose(np.array(spline.knots), -np.array(spline.knots)[::-1], atol=1e-6)


def test_inflections_and_cusps_are_always_knots():
    wave = osc.approximate(osc.curve("t, sin(t)", 0.5, 6), "conic", 1e-3, split="never")
    assert wave.splits == pytest.approx((np.pi,))
    cusp = osc.approximate(osc.curve("t^2, t^3", -1, 1), "conic", 1e-3, split="never")
    assert cusp.splits == (0.0,)


def test_a_word_that_is_not_known():
    with pytest.raises(DomainError, match="way to split 'often' is unknown: choose theory or never"):
        osc.approximate(osc.curve(*SEXTIC), "conic", split="often")


@pytest.mark.parametrize(
    ("formula", "choice"),
    [
        (("t, t^5 - 3*t^3 + t", -2, 2), {"pieces": 40, "metric": "area"}),
        (("2*cos(t) + cos(2*t)/5, sin(t) + sin(3*t)/7", 0, "2*pi"), {"pieces": 7}),
        (("t, log(t)", 0.1, 5), {"pieces": 7}),
        (("(1 + cos(3*t)/1000)*cos(t), (1 + cos(3*t)/1000)*sin(t)", 0, "2*pi"), {"tolerance": 1e-2}),
    ],
)
def test_biarcs_across_vertices_have_two_arcs_of_some_length(formula, choice):
    spline = osc.approximate(osc.curve(*formula), "biarc", split="never", **choice)
    assert spline.max_tangent_jump() < 1e-11
    assert all(min(piece.lengths) > 1e-3 * max(piece.lengths) for piece in spline.pieces)
