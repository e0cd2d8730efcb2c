"""Junction planes, lines and cylinders on random rational data, and bihelices against their contacts."""

from fractions import Fraction

import mpmath as mp
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.asymptotics.space_complexity import curvature_slope_integral
from osculant.cas.errors import DomainError, OsculantError, UndecidedError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry.bihelices import (
    End,
    bihelix_through,
    junction_cylinder,
    junction_line,
    junction_plane,
)
from osculant.cas.geometry.bihelix_rules import (
    SpaceArc,
    equioscillating_bihelix,
    junction_tangent,
    peaks,
    shifted_bihelix,
    thesis_bihelix,
)
from osculant.cas.numbers.roots import increasing_root
from osculant.cas.numbers.vectors import add, cross, dot, scale, subtract

fractions = st.fractions(min_value=-3, max_value=3, max_denominator=12)


def on_sphere(p, q):
    """A rational point of the unit sphere by stereographic projection."""
    below = 1 + p * p + q * q
    return 2 * p / below, 2 * q / below, (p * p + q * q - 1) / below


spheres = st.builds(on_sphere, fractions, fractions)
points = st.tuples(fractions, fractions, fractions)
ends = st.builds(End, points, spheres)


@given(ends, ends, spheres, fractions)
def test_junction_line_lies_in_both_planes(left, right, tangent, factor):
    assume(len({left.tangent, right.tangent, tangent}) == 3)
    line = junction_line(left, right, tangent)
    p = line.at(factor)
    assert junction_plane(left, tangent).offset(p) == 0
    assert junction_plane(right, tangent).offset(p) == 0
    assert line.nearest(p) == p


@given(ends, ends, spheres, fractions)
def test_lines_of_one_circle_are_parallel_on_the_cylinder(left, right, tangent, q):
    assume(len({left.tangent, right.tangent, tangent}) == 3)
    line = junction_line(left, right, tangent)
    cylinder = junction_cylinder(left, right, line.direction)
    # another point of the circle: where a chord through T_L in its plane meets the sphere again
    chord = add(subtract(tangent, left.tangent), scale(q, subtract(right.tangent, left.tangent)))
    again = -2 * dot(left.tangent, chord) / dot(chord, chord)
    other = add(left.tangent, scale(again, chord))
    assert dot(other, other) == 1
    assume(other not in {left.tangent, right.tangent})
    second = junction_line(left, right, other)
    assert cross(line.direction, second.direction) == (0, 0, 0)
    for p in (line.point, second.point, left.point, right.point):
        assert cylinder.distance_squared(p) == cylinder.radius_squared


@given(ends, ends, spheres)
def test_screw_takes_left_to_right(left, right, tangent):
    assume(len({left.tangent, right.tangent, tangent}) == 3)
    axis = junction_line(left, right, tangent).direction
    cylinder = junction_cylinder(left, right, axis)
    assert cylinder.screw(left.point) == right.point
    assert cylinder.turn(left.tangent) == right.tangent
    assert cylinder.turn(axis) == axis


def test_radius_by_angle_and_chord():
    with mp.workdps(40):
        turned = (mp.cos(2) * mp.mpf(0.6), mp.sin(2) * mp.mpf(0.6), mp.mpf(0.8))
        left = End((mp.mpf(0),) * 3, (mp.mpf(0.6), mp.mpf(0), mp.mpf(0.8)))
        right = End((mp.mpf(1), mp.mpf(2), mp.mpf(5)), turned)
        cylinder = junction_cylinder(left, right, (mp.mpf(0), mp.mpf(0), mp.mpf(1)))
        assert mp.almosteq(mp.sqrt(cylinder.radius_squared), mp.sqrt(5) / (2 * mp.sin(1)), 1e-35)


def test_half_turn_and_chord_along_the_axis():
    one, zero = Fraction(1), Fraction(0)
    up = (zero, zero, one)
    left = End((zero, zero, zero), (one, zero, zero))
    half = junction_cylinder(left, End((2 * one, zero, one), (-one, zero, zero)), up)
    assert half.axis.point[:2] == (1, 0)
    assert half.radius_squared == 1
    along = junction_cylinder(left, End((zero, zero, 3 * one), (zero, one, zero)), up)
    assert along.radius_squared == 0


@given(ends, points, spheres)
def test_equal_end_tangents_have_no_line(left, point, tangent):
    right = End(point, left.tangent)
    assume(tangent != left.tangent)
    with pytest.raises(DomainError, match="parallel"):
        junction_line(left, right, tangent)
    with pytest.raises(DomainError, match="no junction cylinder"):
        junction_cylinder(left, right, (1, 0, 0))


def test_degenerate_tangents_and_axes():
    left, right = End((0, 0, 0), (1, 0, 0)), End((1, 1, 0), (0, 1, 0))
    for tangent in (left.tangent, right.tangent):
        with pytest.raises(DomainError, match="equals the tangent at an end"):
            junction_line(left, right, tangent)
    with pytest.raises(DomainError, match="orthogonal"):
        junction_cylinder(left, right, (1, 0, 0))
    with pytest.raises(DomainError, match="orthogonal"):
        junction_cylinder(left, right, (0, 0, 0))


def test_nearly_equal_tangents_are_refused_in_floating_point():
    left = End((mp.mpf(0),) * 3, (mp.mpf(1), mp.mpf(0), mp.mpf(0)))
    right = End((mp.mpf(1),) * 3, (mp.mpf(1), mp.mpf(10) ** -16, mp.mpf(0)))
    with pytest.raises(DomainError):
        junction_line(left, right, (mp.mpf(0), mp.mpf(0), mp.mpf(1)))


@settings(max_examples=8, deadline=None)
@given(ends, ends, spheres, fractions)
def test_bihelix_touches_ends_and_junction(left, right, tangent, factor):
    assume(len({left.tangent, right.tangent, tangent}) == 3)
    point = junction_line(left, right, tangent).at(factor)
    assume(point not in {left.point, right.point})
    spline = bihelix_through(left, right, tangent, point)
    for piece, start, end in ((spline.left, left, spline.junction), (spline.right, spline.junction, right)):
        helix, size = piece.helix, piece.length
        assert 0 <= piece.turning < 2 * mp.pi
        for found, wanted, scaled in (
            (helix.at(0 * size), start.point, size),
            (helix.tangent_at(0 * size), start.tangent, 1),
            (helix.at(size), end.point, size),
            (helix.tangent_at(size), end.tangent, 1),
        ):
            gap = [f - mp.mpf(w.numerator) / w.denominator if isinstance(w, Fraction) else f - w
                   for f, w in zip(found, wanted)]  # fmt: skip
            assert mp.sqrt(dot(gap, gap)) <= 1e-9 * scaled


def test_point_off_the_line_is_refused():
    left, right = End((0, 0, 0), (1, 0, 0)), End((1, 1, 0), (0, 1, 0))
    with pytest.raises(DomainError, match="residual"):
        bihelix_through(left, right, (0, 0, 1), (5, 0, 1))


def helix_arc(high):
    return SpaceArc(parse_tuple("3*cos(t), 3*sin(t), 4*t"), mp.mpf(0), mp.mpf(high))


def test_a_helix_is_its_own_bihelix():
    arc = helix_arc(2)
    assert mp.almosteq(arc.sigma, 10, 1e-14)
    assert mp.almosteq(arc.after(5), 1, 1e-13)
    for rule in (thesis_bihelix, lambda a: shifted_bihelix(a, mp.mpf(0))):
        assert max(peaks(arc, rule(arc))) < 1e-12
    assert junction_tangent(arc.jet(1), mp.mpf(10), mp.mpf(0)) == pytest.approx(arc.jet(1).tangent)


def test_peaks_against_a_dense_search():
    arc = SpaceArc(parse_tuple("t*cos(t), t*sin(t), t"), mp.mpf(1), mp.mpf("1.8"))
    spline = thesis_bihelix(arc)
    dense = mp.mpf(0)
    for i in range(61):
        p = arc.jet(1 + mp.mpf(i) * 8 / 600).point(0)
        best = mp.inf
        for piece in (spline.left, spline.right):
            for j in range(41):
                away = subtract(p, piece.helix.at(piece.length * j / 40))
                best = min(best, dot(away, away) - (piece.length / 80) ** 2)
        dense = max(dense, best)
    top = max(peaks(arc, spline))
    assert mp.sqrt(max(dense, 0)) <= top  # the search can only be too small, by the spacing of its points


def test_equal_peaks_are_nearly_the_ideal_error():
    coordinates = parse_tuple("t*cos(t), t*sin(t), t")
    arc = SpaceArc(coordinates, mp.mpf(1), mp.mpf("1.3"))
    left, right = peaks(arc, equioscillating_bihelix(arc, 4))
    assert left == pytest.approx(right, rel=1e-3)
    ideal = float(curvature_slope_integral(coordinates, 1, "1.3")) ** 3 / 324
    assert left == pytest.approx(ideal, rel=0.01)
    assert left < max(peaks(arc, thesis_bihelix(arc)))


def test_roots_and_their_failure():
    assert increasing_root(lambda x: (x**3 - 8, 3 * x * x), mp.mpf(0), mp.mpf(9), mp.mpf(0)) == pytest.approx(
        2
    )
    with pytest.raises(UndecidedError):
        increasing_root(lambda x: (mp.nan, mp.nan), mp.mpf(0), mp.mpf(1), mp.mpf("0.5"))


def test_complexity_integral_against_quadrature():
    coordinates = parse_tuple("exp(t), t^2, sin(t)")
    ball = curvature_slope_integral(coordinates, 0, 1)
    arc = SpaceArc(coordinates, mp.mpf(0), mp.mpf(1))

    def density(t):
        jet = arc.jet(t)
        return mp.cbrt(abs(jet.curvature_slope)) * jet.speed

    grid = [(density(mp.mpf(2 * i + 1) / 4000)) / 2000 for i in range(2000)]
    assert float(ball.mid()) == pytest.approx(float(sum(grid)), rel=1e-3)


@pytest.mark.parametrize("formula", ["t, t, t", "sqrt(t), t^2, t^3", "abs(t), t^2, t^3"])
def test_complexity_integral_refuses(formula):
    with pytest.raises(OsculantError):
        curvature_slope_integral(parse_tuple(formula), 1, 2)
