"""Secant germs against the definition at rational points, changes of coordinates, projections, two points."""

from __future__ import annotations

import re
from fractions import Fraction
from itertools import product

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.claims.chapter_6.secant_rows import key
from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import to_text
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.germs import multigerm
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.even import double, doubled, fresh, halve, halved
from osculant.cas.germs.frenet import frenet
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.immersions import Immersion
from osculant.cas.germs.secants import chord, projected, secant, variable_names, variety
from osculant.cas.germs.secants_apart import SecantApart, secant_apart
from osculant.cas.jets.space import SpaceJet

rationals = st.fractions(-3, 3, max_denominator=4)


def values(germ: Germ, at: dict[str, Fraction]) -> list[sp.Rational]:
    """The components of a germ at a point, by sympy and not by the engine."""
    symbols = {name: sp.Rational(c.numerator, c.denominator) for name, c in at.items()}
    return [sp.sympify(to_text(node), rational=True).subs(symbols) for node in germ.components]


@given(st.tuples(*[rationals] * 5, rationals.filter(bool)), st.sampled_from([(1, 0), (0, 1), (2, -3)]))
@settings(max_examples=10, deadline=None)
def test_secant_germs_are_the_directions_of_secants(point: tuple, direction: tuple) -> None:
    """X(q) − X(p) by the definition, in the linear coordinates that the immersion states."""
    a, b, x, y, v, k = point
    text = "x + y^2, y - x*y, x*y + x^3 - 2*x^2*y^3"
    found = secant(Immersion.of(text, "x y", f"{a}, {b}", "{}, {}".format(*direction)))
    frames = found.immersion.source_frame, found.immersion.target_frame
    source, target = (sp.Matrix([[sp.Rational(to_text(c)) for c in row] for row in f]) for f in frames)
    x1, y1 = sp.symbols("x1 y1")
    whole = sp.Matrix([x1 + y1**2, y1 - x1 * y1, x1 * y1 + x1**3 - 2 * x1**2 * y1**3])

    def image(sign: int) -> sp.Matrix:
        inner = sp.Matrix([(x + sign * k) / 2, (y + sign * k * v) / 2])
        place = sp.Matrix([a, b]) + source * inner
        return target * whole.subs({x1: place[0], y1: place[1]}, simultaneous=True)

    apart = sp.nsimplify(image(1) - image(-1)) / k
    if apart[0] == 0:
        return  # off the chart
    at = dict(zip(found.even.source, (x, y, k, v)))
    assert values(found.even, at) == [c / apart[0] for c in apart[1:]]
    at_u = dict(zip(found.germ.source, (x, y, k * k, v)))
    assert values(found.germ, at_u) == [c / apart[0] for c in apart[1:]]
    assert (found.germ.boundary, found.order, found.settled) == ("u", None, True)


def test_chords_of_three_variables_are_those_defined() -> None:
    x, y, z, lam, v, w = symbols = sp.symbols("x y z lam v w")
    for exponents in ((1, 0, 2), (0, 3, 1), (2, 2, 1)):
        ends = [
            sp.prod(((b + s * lam * o) / 2) ** e for b, o, e in zip((x, y, z), (1, v, w), exponents))
            for s in (1, -1)
        ]
        terms = chord({poly.monomial(exponents): 3}, 3).items()
        made = sum(
            sp.Rational(str(c)) * sp.prod(s**e for s, e in zip(symbols, poly.exponents_of(m, 6)))
            for m, c in terms
        )
        assert sp.expand(made - 3 * sp.cancel((ends[0] - ends[1]) / lam)) == 0
    assert chord({}, 2) == {}


@pytest.mark.parametrize(
    ("text", "source", "at", "direction"),
    [
        ("x, y, x^3 + x*y^2, x*y", "x y", None, None),
        ("x + y^2, y + x^2, x^3 + x*y", "x y", "1/2, 2", "1, 3"),
        ("exp(x), sin(y) + x, x^3 + x*y, cos(x + y)", "x y", None, "1, 2"),
        ("x, y, z, x*y*z + x^3, y^2 + z^3", "x y z", "1, 0, 2", "0, 1, 1"),
        ("t, t^2, t^4 + t^5", "t", "sqrt(2)", None),
        ("x, y, z, w, x^2 + y*z + w^3", "x y z w", None, None),
        ("u, v, u^2 + v^3", "u v", "3^(1/3), 0", "sqrt(2), 1"),
    ],
)
def test_the_secant_germ_and_the_projection_are_linked(text, source, at, direction) -> None:
    found = secant(Immersion.of(text, source, at, direction))
    whole = found.immersion.polynomial
    n = found.immersion.n
    top = max(poly.degree_of(m, n) for f in whole for m in f) if whole else 2
    assert found.linked() >= min(top, (2 * (found.order or 99) + 1) // 3)
    assert (found.germ.n, found.germ.p, found.immersion.projection.p) == (2 * n, found.even.p, found.even.p)
    assert codimension(found.germ, "A(H)").value != "infinite" or whole


@pytest.mark.parametrize(
    ("text", "size"),
    [("x, y, x^3 + x*y^2", 2), ("x, y, y^2 + x^3, x*y", 1), ("x, y, x^2, x^3 - x*y^2 + y^2", 1)],
)
def test_the_class_does_not_depend_on_coordinates(text: str, size: int) -> None:
    """Of the source, by diffeomorphisms that keep the direction, and of the target, by affine ones."""
    plain = secant(Immersion.of(text, "x y"))
    wanted = key(plain.germ)
    assert codimension(plain.germ, "A(H)").value == size
    inner = {"x": "(2*x + y + x*y - x^2)", "y": "(3*y - x^2 + 2*x*y + y^2)"}
    changed = re.sub("[xy]", lambda name: inner[name[0]], text)
    first, *rest = changed.split(", ")
    mixed = ", ".join([f"{first} + {rest[-1]} + 1", *(f"{f} - 2*({first})" for f in rest)])
    for moved in (changed, mixed):
        found = secant(Immersion.of(moved, "x y"))
        assert found.settled and key(found.germ) == wanted and found.linked() > 0


def test_a_wrong_link_is_seen() -> None:
    right = secant(Immersion.of("x, y, x^3 + x*y", "x y"))
    other = secant(Immersion.of("x, y, x^3 + 2*x*y", "x y"))
    with pytest.raises(AssertionError):
        type(right)(right.immersion, None, other.germ, other.even, True).linked()
    with pytest.raises(DomainError, match="no polynomial"):
        projected({poly.monomial((0, 0, 0, 2)): 1}, 2)


def test_analytic_immersions_are_expanded_until_the_jet_determines_the_germ() -> None:
    curve = "t, t^2, sin(t)^4*(1 + t)"
    found = secant(Immersion.of(curve, "t"))
    assert found.settled and found.order == 2
    assert codimension(found.germ, "A(H)").value == 1
    by_hand = secant(Immersion.of("t, t^2, t^4 + t^5 - 2/3*t^6 - 2/3*t^7", "t"), order=2)
    assert str(by_hand.germ) == str(found.germ)
    low = secant(Immersion.of(curve, "t"), order=1)
    assert not low.settled and low.order == 1
    assert not secant(Immersion.of("t, t^2, exp(t^4) - 1", "t")).settled  # symmetric: not finite
    with pytest.raises(DomainError, match="order: jets of order 1 to"):
        secant(Immersion.of(curve, "t"), order=0)
    many = ", ".join(["x", "y", "(x + y + x*y)^14 + x*y"])
    assert secant(Immersion.of(many, "x y")).order is not None  # too many terms to be taken as a whole


def test_names_do_not_clash() -> None:
    assert variable_names(("lam", "v")) == ("lam", "v", "lamlam", "vv")
    assert fresh("u", ["u", "uu"]) == "uuu"
    found = secant(Immersion.of("u, lam, u*lam", "u lam"))
    assert found.germ.source == ("p1", "p2", "u", "v") and found.germ.boundary == "u"
    assert secant(Immersion.of("v, lam, lam*v", "v lam")).even.source == ("v", "lam", "lamlam", "vv")
    assert variety(Immersion.of("t, t^2", "t")).source == ("t", "u", "s")


def test_even_germs_are_read_and_written_back() -> None:
    even = Germ("x, x*lam**2 + lam**4", "x lam")
    f = halved(even, "lam")
    assert str(f) == "(x, x*u + u**2)" and f.boundary == "u"
    assert doubled(f, "lam").polynomial(9) == even.polynomial(9)
    assert halved(Germ("u + lam**2", "u lam"), "lam").source == ("u", "uu")
    assert str(halved(Germ("sqrt(2)*l**2", "l"), "l")) == "(sqrt(2)*u)"
    for text, said in [
        ("x, x*lam", r"component 2 of the germ has the term x\*lam, which is odd in lam"),
        ("cos(lam) - 1, x", "must be a polynomial"),
    ]:
        with pytest.raises(DomainError, match=said):
            halved(Germ(text, "x lam"), "lam")
    with pytest.raises(DomainError, match="'y' is not a source variable: choose one of x, lam"):
        halved(even, "y")
    for i, j in product(range(3), repeat=2):
        m = {poly.monomial((i, 2 * j)): 1}
        assert double(halve(m, 1, 2), 1, 2) == m


@pytest.mark.parametrize(
    ("text", "source", "at", "direction", "said"),
    [
        ("x^2, y, x*y", "x y", None, None, r"no immersion at \(0, 0\): its derivative has rank 1"),
        ("x, y, x*y", "x y", None, "0, 0", "direction: the direction is 0"),
        ("x, y, x*y", "x y", "1", None, "at: 1 coordinate for 2 source variables"),
        ("x, y, x*y", "x y", None, "1, 2, 3", "direction: 3 coordinates for 2 source variables"),
        ("x, x^2", "x y", None, None, "source variable y does not occur"),
        ("log(x), x", "x", None, None, r"at: log\(x\) is not analytic at \(0\)"),
        ("x, 1/(x - 1)", "x", "1", None, r"at: .* is not analytic at \(1\)"),
        ("exp(x), x", "x", "1", None, r"irrational Taylor coefficient at \(1\)"),
        ("x", "x", None, None, "map to the line"),
        ("x, y, x*y", "x y", None, "pi, 1", "direction: pi is neither rational nor algebraic"),
        ("x, x^2, x^3", "x x", None, None, "all different"),
    ],
)
def test_what_has_no_secant_germ(text, source, at, direction, said) -> None:
    with pytest.raises(DomainError, match=said):
        secant(Immersion.of(text, source, at, direction))


def apart(text: str, source: str, at: str, to: str) -> SecantApart:
    names = source.split()
    return secant_apart(parse_tuple(text, names), names, parse_tuple(at, ()), parse_tuple(to, ()))


def test_secants_at_two_points_are_versal_or_not() -> None:
    """The tangent at t = 0 goes through X(1); X′(1) is in the osculating plane at 0, or not."""
    leaving = apart("t - 2*t^4, t^2 - t^4, t^3 - t^4", "t", "1", "0")
    assert leaving.versality().versal and leaving.versality().codimension == 1
    staying = apart("t - 2*t^4, t^2 - t^4, t^3*(1 - t)^2", "t", "1", "0").versality()
    assert (staying.versal, staying.codimension, staying.reached) == (False, 1, 0)
    assert leaving.bigerm_codimension() == "infinite"
    assert apart("t, t^2, t^3", "t", "0", "1").bigerm_codimension() == 0
    morse = apart("t, (t^2 - 1)^2", "t", "-1", "1")  # a line tangent at both
    assert morse.germ.rank == 0 and morse.bigerm_codimension() == 1


def test_the_two_branches_are_one_germ_exchanged() -> None:
    found = apart("x, y, x^2 + y^3", "x y", "0, 0", "1, 2")
    at = dict(zip(found.germ.source, map(Fraction, ("1/3", "2", "-1/5", "1/7"))))
    exchanged = dict(zip((*found.source, *found.parameters), at.values()))
    assert values(found.germ, at) == values(found.back, exchanged)
    p, q = (at["px"], at["py"]), (1 + at["x"], 2 + at["y"])
    d = (q[0] - p[0], q[1] - p[1], q[0] ** 2 + q[1] ** 3 - p[0] ** 2 - p[1] ** 3)
    d = [sp.Rational(c.numerator, c.denominator) for c in d]
    assert values(found.germ, at) == [(d[1] - 2 * d[0]) / d[0], (d[2] - 9 * d[0]) / d[0]]


def test_equal_planes_as_a_bigerm_have_infinite_codimension() -> None:
    """What `bigerm_codimension` says of two equal branches, where the engine can prove it."""
    for text in ("x, y**2", "x, x*y + y**3"):
        branch = Germ(text, "x y")
        assert multigerm.codimension(multigerm.MultiGerm([branch, branch]), True).value == "infinite"
    assert multigerm.codimension(multigerm.MultiGerm([Germ("x", "x y")] * 2), True).value == 0


@pytest.mark.parametrize(
    ("text", "at", "to", "said"),
    [
        ("t^2 - 1, t^3 - t", "-1", "1", "to: both points have the same image"),
        ("log(t), t", "1", "0", r"to: log\(t\) is not analytic at \(0\)"),
        ("log(t), t", "0", "1", r"at: log\(t\) is not analytic at \(0\)"),
        ("t^2, t^3", "1", "0", r"no immersion at \(0\)"),
        ("t, t^2", "1, 2", "0", "at: 2 coordinates for 1 source variable:"),
        ("t", "1", "0", "map to the line"),
    ],
)
def test_two_points_without_a_secant(text, at, to, said) -> None:
    with pytest.raises(DomainError, match=said):
        apart(text, "t", at, to)


@given(st.lists(st.lists(st.integers(-3, 3), min_size=5, max_size=5), min_size=3, max_size=3))
@settings(max_examples=4, deadline=None)
def test_frenet_data_are_those_of_the_jets(coefficients: list) -> None:
    """Against `SpaceJet`; τ″ by arc length from τ′ at the next order, with sympy."""
    t = sp.Symbol("t")
    curve = [sum(c * t**i for i, c in enumerate(row, start=1)) for row in coefficients]
    jet = SpaceJet(
        *([sp.diff(f, t, i) for i in range(5)] for f in curve), root=lambda v, d: v ** sp.Rational(1, d)
    )
    germ = Germ(", ".join(map(str, curve)), "t")
    if jet.inflection_form.subs(t, 0) == 0:
        with pytest.raises(DomainError, match="The curvature is 0"):
            frenet(germ)
        return
    found = frenet(germ)
    second = sp.diff(jet.torsion_slope, t) / jet.speed
    kappa, tau = jet.curvature, jet.torsion
    wanted = [kappa, tau, jet.curvature_slope, jet.torsion_slope, second]
    wanted.append(3 * kappa * second - jet.curvature_slope * jet.torsion_slope)
    told = [found.curvature, found.torsion, found.curvature_slope, found.torsion_slope]
    for node, expression in zip([*told, found.torsion_second, found.condition], wanted, strict=True):
        difference = sp.sympify(to_text(node), rational=True) - expression.subs(t, 0)
        assert abs(sp.N(difference, 30)) < 1e-20


def test_the_cases_of_space_curves_have_the_codimensions_of_their_germs() -> None:
    cases = {
        "t, t^2, t^3": ("fold", 0),
        "3*cos(t), 3*sin(t), 4*t": ("fold", 0),
        "t, t^2, t^4 + t^5": ("pitchfork", 1),
        "t, t^2 + t^3, t^4": ("pitchfork", 1),
        "t, t^2, t^5": ("neither", 2),
        "t, t^2, t^4": ("neither", "infinite"),
    }
    for text, (case, size) in cases.items():
        immersion = Immersion.of(text, "t")
        assert frenet(immersion.moved).case == case
        assert codimension(secant(immersion).germ, "A(H)").value == size
    with pytest.raises(DomainError, match="curve in space"):
        frenet(Germ("t, t^2", "t"))
