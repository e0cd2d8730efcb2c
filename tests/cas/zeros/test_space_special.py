"""Special points of space curves against places known by hand and against mpmath at 50 digits."""

from __future__ import annotations

import mpmath as mp
import pytest

from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_constant, parse_tuple
from osculant.cas.jets.balls import SpaceBalls
from osculant.cas.zeros.form_zeros import FormZeros, ZeroForm
from osculant.cas.zeros.points import SpecialPoint
from osculant.cas.zeros.space import special_points, zeros

ALL = ("cusp", "inflection", "vertex")


def found(text: str, low: str, high: str, names=ALL, planar: bool = False) -> list[SpecialPoint]:
    ends = parse_constant(low), parse_constant(high)
    return special_points(SpaceBalls(parse_tuple(text)), *ends, names, planar)


def kinds_at(points: list[SpecialPoint]) -> list[tuple[float, list[str], bool]]:
    return [(round(float(p.at), 12) + 0.0, sorted(p.kinds), p.decided) for p in points]


def test_vertices_of_an_elliptic_helix():
    quarter = round(float(mp.pi / 2), 12)
    points = kinds_at(found("2*cos(t), sin(t), t/5", "1", "4"))
    assert points == [(quarter, ["vertex"], True), (round(float(mp.pi), 12), ["vertex"], True)]


def test_a_vertex_that_is_no_simple_number_to_fifty_digits():
    def squared(t):  # κ² of (t, t³, t⁴), differentiated by mpmath
        a, b = (1, 3 * t**2, 4 * t**3), (0, 6 * t, 12 * t**2)
        c = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
        return sum(k * k for k in c) / sum(k * k for k in a) ** 3

    [point] = found("t, t^3, t^4", "1/10", "1")
    assert point.kinds == {"vertex"}
    with mp.workdps(100):
        expected = mp.findroot(lambda t: mp.diff(squared, t), mp.mpf(float(point.at)))
        assert abs(mp.mpf(point.at.mid().str(60, radius=False)) - expected) < mp.mpf(10) ** -45


def test_a_cusp_has_all_kinds_and_is_proved():
    assert kinds_at(found("t^2, t^3, t^4", "-1", "1")) == [(0.0, ["cusp", "inflection", "vertex"], True)]


def test_zero_curvature_at_a_simple_number_is_proved():
    points = kinds_at(found("t, t^3, t^4", "-1", "1"))
    assert (0.0, ["inflection", "vertex"], True) in points
    assert len(points) == 3


def test_zero_curvature_elsewhere_is_undecided_unless_the_curve_is_planar():
    text = "t, (t - sqrt(2))^3, 2*(t - sqrt(2))^3"
    root = round(2**0.5, 12)
    assert kinds_at(found(text, "1", "2", ["inflection"])) == [(root, ["inflection"], False)]
    assert kinds_at(found(text, "1", "2", ["inflection"], planar=True)) == [(root, ["inflection"], True)]


def test_ends_are_reported():
    assert kinds_at(found("t, sin(t), t^4", "0", "1", ["inflection"])) == [(0.0, ["inflection"], True)]
    assert kinds_at(found("t^2, t^3, t^5", "0", "1", ["cusp"])) == [(0.0, ["cusp"], True)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1, 2, 3", {"cusp", "inflection", "vertex", "planar", "slope"}),
        ("t, 2*t, t^3 - t^3", {"inflection", "vertex", "planar", "slope"}),
        ("cos(t), sin(t), 2", {"vertex", "planar", "slope"}),
        ("cos(t), sin(t), 2*t", {"vertex", "slope"}),
        ("t, t^2, 3*t^2 + t", {"planar", "slope"}),
        ("exp(t)*cos(t), exp(t)*sin(t), exp(t)", {"slope"}),  # a generalised helix: τ/κ is constant
        ("t, t^2, t^3", set()),
    ],
)
def test_forms_that_vanish_identically(text, expected):
    curve = SpaceBalls(parse_tuple(text))
    low, high = (parse_constant(end) for end in ("0", "1"))
    from osculant.cas.numbers.balls import constant

    names = ("cusp", "inflection", "vertex", "planar", "slope")
    assert {name for name in names if zeros(curve).vanishes(name, constant(low), constant(high))} == expected


@pytest.mark.parametrize(
    ("text", "place"),
    [("t, 1/(t - 1), t", "t = 1 "), ("t, t^2, sqrt(t - 1)", "t = "), ("t, abs(t - 1), t", "t = 1 ")],
)
def test_where_the_curve_is_not_finite_is_said(text, place):
    with pytest.raises(DomainError, match=place):
        ends = parse_constant("0"), parse_constant("2")
        zeros(SpaceBalls(parse_tuple(text))).require_finite(*ends, ["vertex"])


def test_zeros_of_any_form():
    forms = {"turning back": ZeroForm(lambda jet: jet.x[1], 1)}
    zeros = FormZeros(SpaceBalls(parse_tuple("cos(t), t, t^2")), forms)
    points = zeros.within(parse_constant("-1"), parse_constant("4"), ["turning back"])
    assert kinds_at(points) == [(0.0, ["turning back"], True), (3.14159265359, ["turning back"], True)]
