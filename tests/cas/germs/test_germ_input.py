"""What a germ can be made of, what is refused, and that every answer comes in bounded time."""

from __future__ import annotations

import time
from fractions import Fraction

import pytest
import sympy

from osculant.cas.errors import DomainError, FormulaError, OsculantError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group
from osculant.cas.germs.local_algebra import milnor_number, q_algebra
from osculant.cas.germs.unfolding import is_stable

#: no answer may take longer than this many seconds of processor time
PATIENCE = 10.0


@pytest.mark.parametrize(
    ("text", "source", "error", "words"),
    [
        ("x + 1", "x", DomainError, "is 1 at the origin"),
        ("x, cos(y)", "x y", DomainError, "Component 2"),
        ("x + z", "x y", FormulaError, "'z'"),
        ("x, y", "x", FormulaError, "'y'"),
        ("x", "x x", DomainError, "all different"),
        ("x", "", DomainError, "one or more"),
        ("", "x", FormulaError, "empty"),
        ("x,, y", "x y", FormulaError, "missing"),
        ("(x", "x", FormulaError, "parenthesis"),
        ("x; y", "x y", FormulaError, "commas"),
        ("x = y", "x y", FormulaError, "'='"),
        ("__import__('os')", "x", FormulaError, "no meaning"),
        ("x", "pi", FormulaError, "'pi'"),
        ("x", "sin", FormulaError, "'sin'"),
        ("1e4000*x", "x", FormulaError, "bits"),
        ("x/0", "x", FormulaError, "zero"),
        ("+".join(["x"] * 3000), "x", FormulaError, "characters"),
        *(
            (f, "x", DomainError, "not analytic at the origin")
            for f in ("1/x", "log(x)", "sqrt(x)", "abs(x)")
        ),
        *((f, "x", DomainError, "not analytic") for f in ("x**(1/3)", "sqrt(x**2)", "x**-1", "sin(x)/x-1")),
        ("x**y", "x y", DomainError, "not analytic"),
        *(
            (f, "x", DomainError, "rational")
            for f in ("pi*x", "e*x", "sin(sqrt(2))*x", "sin(1)*x", "exp(1+x)-e")
        ),
    ],
)
def test_refused(text, source, error, words):
    with pytest.raises(error) as raised:
        Germ(text, source)
    assert words in str(raised.value)
    assert isinstance(raised.value, OsculantError)


def test_refused_boundaries_groups_and_orders():
    with pytest.raises(DomainError, match="'u' is not a source variable"):
        Germ("x", "x", boundary="u")
    for group in ("A(H)", "K(H)", "R(H)"):
        with pytest.raises(DomainError, match="boundary"):
            codimension(Germ("x, y**2", "x y"), group)
    with pytest.raises(DomainError, match="no group 'B'"):
        codimension(Germ("x", "x"), "B")
    for order in (-1, 4096, 10**6):
        with pytest.raises(DomainError, match="order"):
            Germ("x", "x").jet(order)
    with pytest.raises(DomainError, match="Milnor"):
        milnor_number(Germ("x, y", "x y"))
    with pytest.raises(DomainError, match="Stability"):
        is_stable(Germ("x", "x"), "K")


def test_the_boundary_may_have_any_name():
    one, two = Germ("x, u**2+x*u", "x u"), Germ("x, y**2+x*y", "x y", boundary="y")
    assert codimension(one, "A(H)").value == codimension(two, "A(H)").value == 1
    assert codimension(Germ("x, u**2+x*u", "x u", boundary="x"), "A(H)").value != 1


@pytest.mark.parametrize(
    ("text", "source"),
    [
        ("sin(x)+y", "x y"),
        ("exp(x*y)-1, x-tan(y)", "x y"),
        ("sqrt(1+x)-1", "x"),
        ("sqrt(4+x*y)-2+x", "x y"),
        ("cbrt(8+x)-2", "x"),
        ("(1+x)**(-3)-1", "x"),
        ("(1+x-y)**(2/5)-1", "x y"),
        ("log(1+x+y**2)", "x y"),
        ("x/(1+x+y)", "x y"),
        ("sin(x)/cos(y), atan(x*y)", "x y"),
        ("cosh(x)-cos(y)", "x y"),
        ("asin(x/2+y)", "x y"),
        ("exp(sin(x+y**2))-1", "x y"),
        ("x*y*sinh(z)+tanh(x)", "x y z"),
    ],
)
def test_analytic_germs_against_sympy(text, source):
    order, names = 5, sympy.symbols(source.split())
    s = sympy.Symbol("s", positive=True)
    read = {"cbrt": lambda x: x ** sympy.Rational(1, 3)} | {str(x): x for x in names}
    for component, ours in zip(sympy.sympify(f"[{text}]", locals=read), Germ(text, source).jet(order)):
        series = (
            component.subs({x: s * x for x in names}, simultaneous=True).series(s, 0, order + 1).removeO()
        )
        terms = sympy.Poly(sympy.expand(series).subs(s, 1), *names).terms()
        expected = {e: Fraction(int(c.p), int(c.q)) for e, c in terms if c}
        assert {poly.exponents_of(m, len(names)): Fraction(c) for m, c in ours.items()} == expected


def test_analytic_germs_have_the_codimensions_of_their_normal_forms():
    assert codimension(Germ("x, x*sin(y)+tan(y)**3", "x y"), "A").value == 2
    assert codimension(Germ("cosh(x)-cos(y)+sin(x)*y**2", "x y"), "R", extended=True).value == 1
    assert codimension(Germ("exp(x)-1, (exp(u)-1)**2+x*u", "x u"), "A(H)").value == 1
    assert q_algebra(Germ("sin(x)**2, log(1+y)**3", "x y")).hilbert == (1, 2, 2, 1)


CUSP = ("2*x, 3*y", "2*y, 3*x**2")  # the logarithmic fields of x³ = y²


@pytest.mark.parametrize(
    ("germ", "extended", "ordinary"),
    # θ/(2x f_x + 3y f_y, 2y f_x + 3x² f_y), by hand
    [("x", 1, 0), ("y", 2, 1), ("x+y", 1, 0), ("y+x**2", 2, 1), ("x**2+y", 2, 1)],
)
def test_functions_on_a_cusp(germ, extended, ordinary):
    group = Group("R(cusp)", "own", "none", CUSP)
    assert codimension(Germ(germ, "x y"), group, extended=True).value == extended
    assert codimension(Germ(germ, "x y"), group).value == ordinary


def test_own_modules_agree_with_the_named_groups():
    everything = ("1, 0", "0, 1")
    tangent_to_h = ("1, 0", "0, u")
    for germ in ("x, u**2+x*u", "x*u+x**3, u-x**2", "x, u**3+x**2*u"):
        f = Germ(germ, "x u")
        for target, letter in (("left", "A"), ("contact", "K")):
            for fields, name in ((everything, letter), (tangent_to_h, f"{letter}(H)")):
                own = Group("own", "own", target, fields)
                for extended in (False, True):
                    assert codimension(f, own, extended).value == codimension(f, name, extended).value


def test_liftable_fields_of_the_fold():
    # fields on the target of (x, y²) that lift are tangent to its discriminant: those of a boundary
    liftable = Group("K(V)", "own", "contact", ("1, 0", "0, 2*u"))
    for germ in ("u+x**3", "u**2+x", "x**2+u**2"):
        f = Germ(germ, "x u")
        assert codimension(f, liftable, True).value == codimension(f, "K(H)", True).value


def test_other_generators_of_an_extended_module_change_nothing():
    f = Germ("x*y + y**3", "x y")
    values = [
        codimension(f, Group("own", "own", "none", fields), extended=True).value
        for fields in [("1, 0", "0, x"), ("1, 0", "1, x"), ("exp(x), y", "0, x", "1, 0", "0, sin(x)")]
    ]
    assert values[0] == values[1]


def test_refused_fields():
    with pytest.raises(DomainError, match="3 components"):
        codimension(Germ("x", "x y"), Group("own", "own", "none", ("1, 0, 0",)))
    with pytest.raises(DomainError, match="not analytic"):
        codimension(Germ("x", "x y"), Group("own", "own", "none", ("sqrt(x), 0",)))
    with pytest.raises(FormulaError):
        codimension(Germ("x", "x y"), Group("own", "own", "none", ("z, 0",)))
    assert codimension(Germ("x", "x y"), Group("own", "own", "none", ("0, 0",))).value == "infinite"
    assert codimension(Germ("x", "x y"), Group("own", "own", "none", ())).value == "infinite"


DENSE = ", ".join(
    "+".join(
        f"{(7 * i + 3 * j + k) % 11 + 1}*x**{i}*y**{j}" for i in range(9) for j in range(9 - i) if i + j > 1
    )
    for k in (1, 4)
)


@pytest.mark.parametrize(
    ("germ", "source", "group", "value"),
    [
        ("x**2, y**2, z**2", "x y z", "K", 12),
        ("x**2, y**2, z**2", "x y z", "A", "infinite"),
        ("x*y, x**5+y**7", "x y", "K", 12),
        # 34 cusps and 141 double folds by Thom polynomials, μ of the discriminant 11·34: 374 − 2·34 − 141 + 2
        ("x*y, x**5+y**7", "x y", "A", 167),
        ("a**2+b**2+c**2+d**2+w**3", "a b c d w", "R", 6),
        ("a*b+c**3, c*d+w**2+a**2", "a b c d w", "A", "infinite"),
        ("a, b, c, d, w**3+a*w", "a b c d w", "A", 2),
        (DENSE, "x y", "A", 4),
        (DENSE, "x y", "K", 4),
        ("x, y**2, 0", "x y", "A", "infinite"),
        ("0", "x", "R", "infinite"),
        ("0, 0", "x y", "A", "infinite"),
        ("x, (x+y)**1000000 + y**3 + x*y", "x y", "A", 2),
        ("x, y**2, x**1000000 + x*y", "x y", "A", 2),
        ("x, x*y + y**3 + (x**2*y+x)**(10**6)", "x y", "A", 2),
        ("x**1000000 + x**2", "x", "R", 1),
        ("x**1000000", "x", "K", None),
        ("x**64", "x", "R", 63),
        ("x, x**70*y + y**3", "x y", "A", 71),
        ("sin(x)-x, y", "x y", "A", "infinite"),
        ("asin(x)**2, asin(y)**2, 0", "x y", "A", None),
        ("x, y, z, 0, 0, 0", "x y z", "A", 0),
        ("x, 10**12*x*y + y**6", "x y", "A", 8),
        ("x, x*y + y**6/10**9 + 10**12*x**2*y**2", "x y", "A", 8),
    ],
)
def test_answers_come_in_bounded_time(germ, source, group, value):
    # None: the truth is out of reach, which must be said
    begun = time.process_time()
    try:
        assert codimension(Germ(germ, source), group).value == value
    except UndecidedError:
        assert value is None
    assert time.process_time() - begun < PATIENCE


@pytest.mark.parametrize(
    ("germ", "source", "group", "degree"),
    [
        ("x*y, x**5+y**7", "x y", "K", 7),
        ("a**2+b**2+c**2+d**2+w**3", "a b c d w", "R", 3),
        ("x, y, z, 0, 0, 0", "x y z", "A", 1),
        ("x**2*y**2", "x y", "K", "infinite"),
        ("x, y", "x y", "A", 1),
        ("x", "x", "R", 1),
    ],
)
def test_determinacy_comes_in_bounded_time(germ, source, group, degree):
    begun = time.process_time()
    assert determinacy(Germ(germ, source), group).degree == degree
    assert time.process_time() - begun < PATIENCE
