"""The pencil of bitangent conics: symbolic proofs, and numbers where those would repeat the derivation."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.geometry import pencil
from osculant.cas.geometry.pencil import Q, chord, sin_a, sin_b, sin_psi

u = sp.Symbol("u", real=True)
cos_a, cos_b = sp.symbols("cos_a cos_b", real=True)
#: √(Q/(sin A sin B))
ratio = sp.Symbol("ratio", positive=True)

BEZIER = pencil.weights()
MOVE = pencil.displacement()


def in_lines(expr, root):
    """An expression of the displacement with a symbol for the root −√(B² − 4AC)."""
    half = sp.Rational(1, 2)
    return expr.replace(lambda e: e.is_Pow and abs(e.exp) == half, lambda e: (-root) ** int(2 * e.exp))


# F = 0.


def residual(d):
    """F(α + dN), where d contains a symbol R for the signed root; zero if it follows from R² = B² − 4AC."""
    root = sp.Symbol("R")
    foot = [line + d * slope for line, slope in zip(LINES, NORMALS, strict=True)]
    a, b, c = sp.Poly(sp.expand(pencil.implicit(tuple(MOVING))), pencil.d).all_coeffs()
    numerator = sp.numer(sp.together(pencil.implicit(tuple(foot))))
    return sp.rem(sp.expand(numerator), sp.expand(root**2 - b**2 + 4 * a * c), root)


LINES, NORMALS = (pencil.l0, pencil.l1, pencil.l2), (pencil.n0, pencil.n1, pencil.n2)
MOVING = [line + pencil.d * slope for line, slope in zip(LINES, NORMALS, strict=True)]


def test_the_foot_lies_on_the_conic():
    d = in_lines(MOVE["d"], sp.Symbol("R"))
    assert residual(d) == 0
    for wrong in (-d, 2 * d, d + 1):
        assert residual(wrong) != 0
    for place, name in enumerate(("foot0", "foot1", "foot2")):
        foot = in_lines(MOVE[name], sp.Symbol("R"))
        assert sp.simplify(foot - LINES[place] - d * NORMALS[place]) == 0


def test_the_displacement_vanishes_with_the_residual():
    # F = (l₁ + dn₁)² − 4 with l₁ near 2: of the roots d near 0 and near ∓4 it is the one where F falls
    values = {pencil.n1: -1, pencil.n0: 0, pencil.n2: 0, pencil.l0: 1, pencil.l2: 1, Q: 1}
    assert numbers(MOVE["d"], values | {pencil.l1: 2}) == 0
    with mpmath.workdps(50):
        small = mpmath.mpf(10) ** -20
        assert close(numbers(MOVE["d"], values | {pencil.l1: 2 + small}), small, 15)
        assert close(numbers(MOVE["d"], values | {pencil.n1: 1, pencil.l1: 2 + small}), -4 - small, 15)


def test_a_member_through_a_point():
    x = sp.symbols("x0:3")
    at = dict(zip(LINES, x, strict=True))
    through = pencil.through().subs(at)
    assert sp.simplify(pencil.implicit(x).subs(Q, through)) == 0
    assert sp.simplify(pencil.implicit(x).subs(Q, 2 * through)) != 0


# The rational Bézier form, in the frame P₀ = 0, ĉ = (1, 0): [T₀, ĉ] = sin A and [ĉ, T₂] = sin B.

T0, T2 = sp.Matrix([cos_a, -sin_a]), sp.Matrix([cos_b, sin_b])
P2 = sp.Matrix([chord, 0])


def bracket(v, w):
    return v[0] * w[1] - v[1] * w[0]


def values_of_lines(x):
    """(l₀, l₁, l₂) of the issue's definition at a point."""
    return bracket(T2, x - P2), bracket(sp.Matrix([1, 0]), x), bracket(T0, x)


def in_ratio(expr):
    """An expression of the Bézier form without roots, sin ψ = sin(A + B) written out."""
    psi = cos_a * sin_b + sin_a * cos_b
    return sp.simplify(expr.subs(Q, ratio**2 * sin_a * sin_b)).subs(sin_psi, psi)


def on_conic(weight, reach):
    """Whether the rational Bézier curve with that weight and V = reach·T₀ lies on F = 0, identically in u."""
    b0, b1, b2 = (1 - u) ** 2, 2 * u * (1 - u), u**2
    x = (b1 * reach * T0 + b2 * P2) / (b0 + weight * b1 + b2)
    form = pencil.implicit(values_of_lines(x)).subs(Q, ratio**2 * sin_a * sin_b)
    numerator = sp.expand(sp.numer(sp.together(form)))
    return sp.rem(numerator, sin_a**2 + cos_a**2 - 1, cos_a).expand() == 0


def test_bezier_form_lies_on_the_conic():
    weight, reach = in_ratio(BEZIER["weight"]), in_ratio(BEZIER["reach"])
    assert bracket(T0, T2) == in_ratio(sin_psi)
    assert on_conic(weight, reach)
    for wrong in (2 * weight, reach), (weight, 2 * reach), (weight, reach * sin_a / sin_b), (-weight, reach):
        assert not on_conic(*wrong)


def test_bezier_form_has_the_end_tangents():
    weight, reach = in_ratio(BEZIER["weight"]), in_ratio(BEZIER["reach"])
    middle = reach * T0  # wP₁ = wP₀ + V: at P₀ the tangent is V by definition, at P₂ it is wP₂ − wP₁
    assert sp.expand(bracket(weight * P2 - middle, T2)) == 0
    assert sp.expand(bracket(weight * P2 - 2 * middle, T2)) != 0


def test_the_parabola_has_weight_one():
    psi = sp.Symbol("psi", positive=True)
    turning = {sin_psi: psi}
    assert sp.simplify(BEZIER["weight"].subs(turning).subs(Q, BEZIER["parabola"].subs(turning))) == 1
    assert sp.simplify(BEZIER["weight"].subs(turning).subs(Q, 2 * BEZIER["parabola"].subs(turning))) != 1


def test_the_kind_of_conic_follows_from_the_weight():
    """The quadratic part of F has a determinant of the sign of 1 − w²: an ellipse exactly for |w| < 1."""
    x, y = sp.symbols("x y")
    form = sp.Poly(sp.expand(pencil.implicit(values_of_lines(sp.Matrix([x, y])))), x, y)
    xx, xy, yy = (form.coeff_monomial(m) for m in (x**2, x * y, y**2))
    determinant = sp.expand((xx * yy - xy**2 / 4).subs(Q, ratio**2 * sin_a * sin_b))
    weight = in_ratio(BEZIER["weight"])
    positive = 4 * ratio**2 * sin_a**2 * sin_b**2
    difference = sp.expand(determinant - positive * (1 - weight**2))
    assert sp.rem(sp.rem(difference, cos_a**2 + sin_a**2 - 1, cos_a), cos_b**2 + sin_b**2 - 1, cos_b) == 0


# A curve: an arc of (t cos t, t sin t), in 50 digits.


def numbers(expr, values):
    """The value of an expression in mpmath at the current precision."""
    return sp.lambdify(list(values), expr, "mpmath")(*map(mpmath.mpf, values.values()))


class Arc:
    """A plane arc in mpmath with its pencil; derivatives by differences."""

    def __init__(self, curve, low, high):
        self.curve = curve
        self.start, self.end = curve(low), curve(high)
        self.first, self.last = self.tangent(low), self.tangent(high)
        across = [q - p for p, q in zip(self.start, self.end, strict=True)]
        self.chord = mpmath.hypot(*across)
        self.direction = [x / self.chord for x in across]
        self.sines = {
            sin_a: bracket(self.first, self.direction),
            sin_b: bracket(self.direction, self.last),
            sin_psi: bracket(self.first, self.last),
        }

    def velocity(self, t):
        return [mpmath.diff(lambda s, i=i: self.curve(s)[i], t) for i in (0, 1)]

    def tangent(self, t):
        velocity = self.velocity(t)
        return [x / mpmath.hypot(*velocity) for x in velocity]

    def normal(self, t):
        x, y = self.tangent(t)
        return [-y, x]

    def lines(self, p):
        from_start = [x - o for x, o in zip(p, self.start, strict=True)]
        from_end = [x - o for x, o in zip(p, self.end, strict=True)]
        return (
            bracket(self.last, from_end),
            bracket(self.direction, from_start),
            bracket(self.first, from_start),
        )

    def distance(self, t, q):
        """d by root finding on F along the normal."""
        point, normal = self.curve(t), self.normal(t)

        def form(d):
            l0, l1, l2 = self.lines([p + d * n for p, n in zip(point, normal, strict=True)])
            return l1**2 - 4 * q * l0 * l2

        return mpmath.findroot(form, (0, self.chord / 1000), tol=mpmath.mpf(10) ** -90, verify=False)

    def view(self, t, q):
        """Symbols and their values at a point of the curve."""
        velocity = self.velocity(t)
        acceleration = [mpmath.diff(lambda s, i=i: self.curve(s)[i], t, 2) for i in (0, 1)]
        values = dict(zip(LINES, self.lines(self.curve(t)), strict=True))
        for symbols, v in ((NORMALS, self.normal(t)), ((pencil.t0, pencil.t1, pencil.t2), self.tangent(t))):
            slopes = bracket(self.last, v), bracket(self.direction, v), bracket(self.first, v)
            values |= dict(zip(symbols, slopes, strict=True))
        speed = mpmath.hypot(*velocity)
        values |= {pencil.speed: speed, pencil.curvature: bracket(velocity, acceleration) / speed**3}
        return values | {Q: q}


def spiral(t):
    return t * mpmath.cos(t), t * mpmath.sin(t)


@pytest.mark.parametrize(("low", "high"), [("1", "1.5"), ("2", "4.3"), ("0.3", "0.30001"), ("1.5", "4.9")])
@pytest.mark.parametrize("share", ["0.01", "0.4", "0.93"])
def test_displacement_and_its_derivatives(low, high, share):
    with mpmath.workdps(50):
        low, high, share = mpmath.mpf(low), mpmath.mpf(high), mpmath.mpf(share)
        arc, t = Arc(spiral, low, high), low + share * (high - low)
        middle = arc.lines(spiral((low + high) / 2))
        q = numbers(pencil.through(), dict(zip(LINES, middle, strict=True))) * mpmath.mpf("1.0003")
        values = arc.view(t, q)
        got = {name: numbers(expr, values) for name, expr in MOVE.items()}
        point = [p + got["d"] * n for p, n in zip(spiral(t), arc.normal(t), strict=True)]
        assert close(got["d"], arc.distance(t, q))
        for name, line in zip(("foot0", "foot1", "foot2"), arc.lines(point), strict=True):
            assert abs(got[name] - line) < mpmath.mpf(10) ** -40
        by_q = mpmath.diff(lambda x: arc.distance(t, x), q, h=mpmath.mpf(10) ** -15)
        assert close(got["by_q"], by_q, 20)
        step = (high - low) * mpmath.mpf(10) ** -12
        slope = (arc.distance(t + step, q) - arc.distance(t - step, q)) / (2 * step)
        assert close(got["slope"], slope, 12)
        assert not close(-got["slope"], slope, 3)
        without = got["slope"] / (1 - values[pencil.curvature] * got["d"])
        assert abs(got["d"]) < 1e-10 or not close(without, slope, 12)


def close(x, y, digits=30):
    return abs(x - y) <= mpmath.mpf(10) ** -digits * abs(y)


def test_common_normals_are_where_the_displacement_is_stationary():
    with mpmath.workdps(30):
        arc = Arc(spiral, mpmath.mpf(2), mpmath.mpf(3))
        middle = arc.lines(spiral(mpmath.mpf("2.5")))
        q = numbers(pencil.through(), dict(zip(LINES, middle, strict=True)))
        peak = mpmath.findroot(lambda t: numbers(MOVE["slope"], arc.view(t, q)), (2.2, 2.3))
        d = arc.distance(peak, q)
        foot = [p + d * n for p, n in zip(spiral(peak), arc.normal(peak), strict=True)]
        gradient = [mpmath.diff(lambda x, i=i: form_at(arc, q, foot, i, x), foot[i]) for i in (0, 1)]
        tangent = arc.tangent(peak)
        assert abs(gradient[0] * tangent[0] + gradient[1] * tangent[1]) < 1e-20 * mpmath.hypot(*gradient)


def form_at(arc, q, point, place, x):
    moved = list(point)
    moved[place] = x
    l0, l1, l2 = arc.lines(moved)
    return l1**2 - 4 * q * l0 * l2


# Turning to beyond π: arcs of the unit circle and of an ellipse, whose member of the pencil is known.


def circle(t):
    return mpmath.cos(t), mpmath.sin(t)


def ellipse(t):
    return 3 * mpmath.cos(t), mpmath.sin(t) + mpmath.cos(t)


@pytest.mark.parametrize("curve", [circle, ellipse])
@pytest.mark.parametrize("turning", ["0.01", "1", "3.14159", "pi", "3.1416", "4.5", "6"])
def test_weight_of_an_arc_of_an_ellipse_is_the_cosine_of_half_its_parameter(curve, turning):
    with mpmath.workdps(50):
        angle = +mpmath.pi if turning == "pi" else mpmath.mpf(turning)
        arc = Arc(curve, mpmath.mpf("0.2"), mpmath.mpf("0.2") + angle)
        for share in (mpmath.mpf("0.1"), mpmath.mpf("0.5"), mpmath.mpf("0.97")):
            at = mpmath.mpf("0.2") + share * angle
            q = numbers(pencil.through(), dict(zip(LINES, arc.lines(curve(at)), strict=True)))
            values = arc.sines | {Q: q, chord: arc.chord}
            weight, reach = numbers(BEZIER["weight"], values), numbers(BEZIER["reach"], values)
            assert abs(weight - mpmath.cos(angle / 2)) < mpmath.mpf(10) ** -40
            assert abs(numbers(MOVE["d"], arc.view(mpmath.mpf("0.2") + angle / 3, q))) < mpmath.mpf(10) ** -40
            for s in (mpmath.mpf("0.3"), mpmath.mpf("0.8")):
                b0, b1, b2 = (1 - s) ** 2, 2 * s * (1 - s), s**2
                point = [
                    (b0 * p + b1 * (weight * p + reach * v) + b2 * e) / (b0 + weight * b1 + b2)
                    for p, v, e in zip(arc.start, arc.first, arc.end, strict=True)
                ]
                x, y = point if curve is circle else (point[0] / 3, point[1] - point[0] / 3)
                assert abs(x**2 + y**2 - 1) < mpmath.mpf(10) ** -40


@pytest.mark.parametrize("turning", ["pi", "4.5"])
def test_displacement_beside_a_half_turn(turning):
    with mpmath.workdps(50):
        angle = +mpmath.pi if turning == "pi" else mpmath.mpf(turning)
        arc = Arc(circle, mpmath.mpf(0), angle)
        q = numbers(pencil.through(), dict(zip(LINES, arc.lines(circle(angle / 2)), strict=True)))
        for factor in (mpmath.mpf("1.001"), mpmath.mpf("0.999")):
            t = angle * mpmath.mpf("0.6")
            d = numbers(MOVE["d"], arc.view(t, q * factor))
            assert close(d, arc.distance(t, q * factor))
            assert mpmath.sign(d) == mpmath.sign(1 - factor)  # a larger Q lies outside, on the right


def test_the_displacement_is_not_real_where_the_normal_misses():
    # a member near the chord, seen from a point of the circle where the normal is parallel to the chord
    arc = Arc(circle, mpmath.mpf(0), mpmath.mpf("4.5"))
    parallel, across = (mpmath.mpf("2.25") + x for x in (mpmath.pi / 2, 0))
    assert numbers(MOVE["d"], arc.view(parallel, mpmath.mpf("1e-6"))).imag != 0
    assert numbers(MOVE["d"], arc.view(across, mpmath.mpf("1e-6"))).imag == 0


# The leading error of a short arc.


@pytest.mark.parametrize("crossings", [0, 1])
def test_lobes_are_stationary(crossings):
    shape, x = pencil.lobe_shape(crossings)
    peaks = pencil.lobes(crossings)
    slope = sp.diff(shape, x)
    for end in (0, 1):
        assert shape.subs(x, end) == slope.subs(x, end) == 0  # double zeros
    heights = []
    assert set(peaks) == {"first", "sharpness"} | ({"last"} if crossings else set())
    for at in (peaks["first"], peaks.get("last", peaks["first"])):  # a parabola's error has one peak
        assert 0 < at < 1
        assert sp.simplify(slope.subs(x, at)) == 0
        assert sp.simplify(slope.subs(x, at + sp.Rational(1, 100))) != 0
        assert sp.simplify(sp.diff(shape, x, 2).subs(x, at) + peaks["sharpness"] * shape.subs(x, at)) == 0
        heights.append(sp.simplify(shape.subs(x, at)))
    assert heights[0] == heights[1] * (-1) ** crossings  # equal lobes: the optimum
    assert shape.subs(x, sp.Rational(1, 2)) == (0 if crossings else heights[0])


def test_lobes_where_they_are():
    assert pencil.lobes(0) == {"first": sp.Rational(1, 2), "sharpness": 16}
    conic = pencil.lobes(1)
    assert sp.simplify(conic["first"] - (5 - sp.sqrt(5)) / 10) == 0
    assert sp.simplify(conic["last"] - (5 + sp.sqrt(5)) / 10) == 0
    assert conic["sharpness"] == 50


@given(st.floats(0.1, 0.9).filter(lambda x: abs(x - 0.5) > 1e-3))
@settings(max_examples=30, deadline=None)
def test_the_middle_is_the_best_crossing(crossing):
    shape, x = pencil.lobe_shape(1)
    polynomial = sp.Poly(sp.expand(shape / (x - sp.Rational(1, 2))), x)
    coefficients = [float(c) for c in polynomial.all_coeffs()]
    places = [k / 400 for k in range(401)]

    def height(c):
        return max(abs(mpmath.polyval(coefficients, p) * (p - c)) for p in places)

    assert height(crossing) > height(0.5)


def test_a_short_arc_has_that_shape():
    """The displacement of the conic through the middle of a very short arc of the spiral."""
    with mpmath.workdps(60):
        low, size = mpmath.mpf(2), mpmath.mpf(10) ** -6
        arc = Arc(spiral, low, low + size)
        middle = arc.lines(spiral(low + size / 2))
        q = numbers(pencil.through(), dict(zip(LINES, middle, strict=True)))
        shape, x = pencil.lobe_shape(1)
        d = [numbers(MOVE["d"], arc.view(low + s * size, q)) for s in (mpmath.mpf("0.2"), mpmath.mpf("0.7"))]
        ratio_of_shape = shape.subs(x, sp.Rational(1, 5)) / shape.subs(x, sp.Rational(7, 10))
        assert abs(d[0] / d[1] - ratio_of_shape.p / mpmath.mpf(ratio_of_shape.q)) < 1e-4
