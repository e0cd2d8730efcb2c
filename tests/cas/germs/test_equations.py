"""Equations of images and discriminants, Fitting ideals, logarithmic and liftable fields, R(V) and K(V)."""

from __future__ import annotations

import pytest
import sympy

from osculant.cas.errors import DomainError, FormulaError, UndecidedError
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.colength import Zeros, colength
from osculant.cas.germs.equation import equation, liftable_fields
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.invariants import Invariants
from osculant.cas.germs.logarithmic import logarithmic_fields, preserving
from osculant.cas.germs.multigerm import MultiGerm
from osculant.cas.germs.multigerm import codimension as of_multigerm
from osculant.cas.germs.pushforward import Pushforward
from osculant.cas.germs.search import Patience
from osculant.cas.germs.syzygies import syzygies
from osculant.cas.germs.weights import weights

IMAGES = [
    ("t**2, t**3", "t"),
    ("t**4, t**6 + t**7", "t"),
    ("t + t**2, t**3", "t"),
    ("x, y**2, x*y", "x y"),
    ("x, y**2, y**3 + x**3*y", "x y"),
    ("x, y**2, y**3 + x**2*y + x**5*y", "x y"),
    ("x + y**2, y**2, y**3 + x**2*y", "x y"),
    ("x, x*y + y**5, y**3", "x y"),
    ("x, x*y + y**3, x*y**2 + 2*y**4", "x y"),
    ("x, y, x*y**2", "x y"),
    ("x**2 + y**2, x*y, x**3 + 2*y**3", "x y"),
    ("x, y, z**2, z*(z**2 + x**2 + y**2)", "x y z"),
]
DISCRIMINANTS = [
    ("x, x*y + y**3", "x y"),
    ("x, x*y + y**4 + y**5", "x y"),
    ("x, x**2*y + y**4", "x y"),
    ("x*y + y**3, x", "x y"),
    ("x**2 + y**2, x*y", "x y"),
    ("x, y, z**4 + x*z + y*z**2", "x y z"),
    ("x, y, z**5 + x*z + y**2*z**2 + y*z**3", "x y z"),
]


def components(text: str, source: str) -> tuple:
    return sympy.symbols(source, seq=True), [sympy.sympify(part) for part in text.split(",")]


def symbolic(f: object, p: int) -> tuple:
    return sympy.symbols([f"y{j + 1}" for j in range(p)]), sympy.sympify(str(f).replace("^", "**"))


@pytest.mark.parametrize(("text", "source"), IMAGES)
def test_images(text: str, source: str) -> None:
    """The equation is 0 on the image, and irreducible at the origin."""
    _, parts = components(text, source)
    targets, f = symbolic(equation(Germ(text, source)), len(parts))
    assert sympy.expand(f.subs(dict(zip(targets, parts)), simultaneous=True)) == 0
    factors = sympy.factor_list(f)[1]
    assert [k for q, k in factors if q.subs(dict.fromkeys(targets, 0)) == 0] == [1]


@pytest.mark.parametrize(("text", "source"), DISCRIMINANTS)
def test_discriminants(text: str, source: str) -> None:
    """Pulled back to the source, the equation is divisible by the square of the Jacobian determinant."""
    variables, parts = components(text, source)
    targets, f = symbolic(equation(Germ(text, source)), len(parts))
    jacobian = sympy.Matrix(parts).jacobian(variables).det()
    pulled = sympy.expand(f.subs(dict(zip(targets, parts)), simultaneous=True))
    for factor, _ in sympy.factor_list(jacobian)[1]:
        if factor.subs(dict.fromkeys(variables, 0)) == 0:
            assert sympy.rem(pulled, sympy.expand(factor**2), variables[-1]) == 0
    assert pulled != 0


def test_discriminants_in_print() -> None:
    assert str(equation(Germ("x, x*y + y**3", "x y"))) == "4*y1^3 + 27*y2^2"
    t, a, b, c = sympy.symbols("t y1 y2 c")
    swallowtail = sympy.discriminant(t**4 + b * t**2 + a * t - sympy.Symbol("y3"), t)
    _, found = symbolic(equation(Germ("x, y, z**4 + x*z + y*z**2", "x y z")), 3)
    assert sympy.expand(found - swallowtail) == 0 or sympy.expand(found + swallowtail) == 0
    quintic = sympy.discriminant(t**5 + a * t + c, t).subs(c, -b)
    _, found = symbolic(equation(Germ("x, x*y + y**5", "x y")), 2)
    assert sympy.expand(found - quintic) == 0


def test_what_has_no_equation() -> None:
    with pytest.raises(DomainError, match="no critical points"):
        equation(Germ("x, y", "x y"))
    with pytest.raises(DomainError, match="p = n or n"):
        equation(Germ("x, y, x*y, x**2", "x y"))
    with pytest.raises(UndecidedError, match="quasi-homogeneous"):
        equation(Germ("x**2 + y**3, y**2 + x**3", "x y"))
    with pytest.raises(UndecidedError, match="over the origin"):
        equation(Germ("t**2 - t**3, t**3 - t**4", "t"))  # t = 1 lies over the origin too
    cover = equation(Germ("t**2, t**4", "t"))
    assert [k for _, k in cover.factor()[1]] == [2]


CORANK_ONE = ["x, x*y + y**5, y**3", "x, x*y + y**8, y**3", "x, x*y + y**3, x*y**2 + 3*y**4", "x, y**2, x*y"]
CORANK_TWO = ["x**2 + y**2, x*y, x**3 + 2*y**3", "x**2, y**2, x**3 + x**2*y + 2*x*y**2 + y**3"]


@pytest.mark.parametrize("text", [*CORANK_ONE, *CORANK_TWO])
def test_triple_points_by_weights(text: str) -> None:
    """Mond 1991: C and T of quasi-homogeneous germs by their weights; T by the second Fitting ideal."""
    germ = Germ(text, "x y")
    found = weights(germ)
    assert found is not None
    (v, w), (a, b, c) = found.source, found.target
    caps = sympy.Rational((b - v) * (c - w) + (a - w) * (c - w) + (a - v) * (b - v), v * w)
    epsilon, delta = a + b + c - v - w, sympy.Rational(a * b * c, v * w)
    triple = (delta - epsilon) * (delta - 2 * epsilon) / (6 * v * w) + caps / 3
    questions = Invariants(germ).questions()
    assert questions["cross_caps"]() == caps
    module = Pushforward(germ)
    fitting = colength(Zeros(module.context, module.fitting(2)), "F2")
    assert questions["triple_points"]() == fitting == triple


HYPERSURFACES = [
    ("x**3 - y**2", "x y"),
    ("x*y*z", "x y z"),
    ("z**2 - x**2*y", "x y z"),
    ("x*y*(x + y)", "x y"),
]
HYPERSURFACES += [("x**2 + y**3 + z**5", "x y z"), ("(x**2 - y**3)*(x - y)", "x y"), ("x + y**2", "x y")]


@pytest.mark.parametrize(("h", "source"), HYPERSURFACES)
def test_logarithmic_fields(h: str, source: str) -> None:
    """ξ(h) is a multiple of h; two fields in the plane have the determinant h up to a unit (Saito)."""
    variables, f = sympy.symbols(source), sympy.sympify(h)
    fields = [[sympy.sympify(c) for c in field] for field in logarithmic_fields(h, source.split())]
    for field in fields:
        moved = sympy.expand(sum(c * f.diff(x) for c, x in zip(field, variables)))
        assert sympy.rem(moved, sympy.expand(f), *variables) == 0
    if len(fields) == len(variables) == 2:
        quotient = sympy.cancel(sympy.Matrix(fields).det() / f)
        assert quotient.subs(dict.fromkeys(variables, 0)).is_number


def test_relations_are_all() -> None:
    """The relations of a regular sequence are those of Koszul; none for one function."""
    from osculant.cas.germs.model import ring

    x, y, z = ring(["x", "y", "z"]).gens()
    found = syzygies([x, y**2, z**3])
    assert len(found) == 3
    assert all(sum((a * g for a, g in zip(r, [x, y**2, z**3])), x * 0).is_zero() for r in found)
    assert syzygies([x + y]) == []
    with pytest.raises(UndecidedError):
        syzygies([(x + y + z) ** 9 + x**4, (x - 2 * y) ** 8 + z**5, x**7 + y**9 * z], Patience(0.1))


LIFTED = ["x, x*y + y**3", "x, x*y + y**4", "x, y**2, x*y", "x, y**2, y**3 + x**2*y"]


@pytest.mark.parametrize("text", LIFTED)
def test_liftable_fields_lift(text: str) -> None:
    """η∘f = df(ξ) for polynomials ξ, found by linear algebra over the source's monomials."""
    variables, parts = components(text, "x y")
    targets = sympy.symbols([f"y{j + 1}" for j in range(len(parts))])
    for field in liftable_fields(Germ(text, "x y")):
        values = [sympy.sympify(c).subs(dict(zip(targets, parts)), simultaneous=True) for c in field]
        monomials = [variables[0] ** i * variables[1] ** j for i in range(9) for j in range(9 - i)]
        unknowns = sympy.symbols(f"c:{2 * len(monomials)}")
        xi = [sum(c * m for c, m in zip(unknowns[k * len(monomials) :], monomials)) for k in range(2)]
        equations = [
            coefficient
            for part, value in zip(parts, values)
            for coefficient in sympy.Poly(
                sum(x * part.diff(v) for x, v in zip(xi, variables)) - value, *variables
            ).coeffs()
        ]
        assert sympy.linsolve(equations, *unknowns) != sympy.EmptySet


UMBRELLA = [
    ("y - x", "x, x, y"),
    ("y - z", "y, x, x"),
    ("x - y**2", "y**2, y, x"),
    ("y - x**3", "x, x**3, y"),
    ("y - x**2 - z", "x, x**2 + y, y"),
    ("z - x**2 - y**2", "x, y, x**2 + y**2"),
    ("x - z", "y, x, y"),
]


@pytest.mark.parametrize(("h", "plane"), UMBRELLA)
def test_a_sheet_through_an_umbrella(h: str, plane: str) -> None:
    """The A_e codimension of a cross-cap with a sheet {h = 0} is that of h for K(V), V the cross-cap."""
    group = preserving("K", "z**2 - x**2*y", ["x", "y", "z"])
    both = MultiGerm([Germ("x, y**2, x*y", "x y"), Germ(plane, "x y")])
    value = codimension(Germ(h, "x y z"), group, extended=True).value
    assert of_multigerm(both, extended=True).value == value


@pytest.mark.parametrize("k", [2, 3, 4])
def test_three_sheets(k: int) -> None:
    """A third sheet in contact with the line of two: h for K(V), V two planes."""
    group = preserving("K", "y*z", ["x", "y", "z"])
    value = codimension(Germ(f"z - y - x**{k}", "x y z"), group, extended=True).value
    three = MultiGerm([Germ(f, "x y") for f in ("x, y, 0", "x, 0, y", f"x, y, y + x**{k}")])
    assert of_multigerm(three, extended=True).value == value == k - 1


def test_groups_of_a_boundary() -> None:
    """V = {u = 0}: R(V) is R(H) and K(V) is K(H)."""
    for f in ("u + x**4", "x*u + u**3", "x**2 + u**3", "u**2 + x**3"):
        germ = Germ(f, "x u")
        for kind in ("R", "K"):
            own = codimension(germ, preserving(kind, "u", ["x", "u"]), extended=True).value
            assert own == codimension(germ, f"{kind}(H)", extended=True).value


def test_bad_hypersurfaces() -> None:
    for h, error in (
        ("x + 1", DomainError),
        ("sin(x)", DomainError),
        ("0", DomainError),
        ("w", FormulaError),
    ):
        with pytest.raises(error):
            logarithmic_fields(h, ["x", "y"])
    with pytest.raises(DomainError, match="R, K or A"):
        preserving("C", "x*y", ["x", "y"])
