"""Families of germs: diagonal forms against ranks, jumps of the codimension against single germs, moduli."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import pytest
import sympy
from flint import fmpq, fmpq_mat, fmpq_poly
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError, FormulaError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.diagonal import diagonal_form
from osculant.cas.germs.family import Family, GenericGerm
from osculant.cas.germs.groups import Group, group
from osculant.cas.germs.parameters import FamilyCodimension, codimension_of_family, moduli
from osculant.cas.germs.reference import reference
from osculant.cas.germs.roots import codimension_at_root, polynomial_text, real_roots

entries = st.lists(st.integers(-2, 2), min_size=1, max_size=3).map(fmpq_poly)
matrices = st.integers(1, 5).flatmap(
    lambda columns: st.lists(
        st.lists(st.one_of(st.just(fmpq_poly([])), entries), min_size=columns, max_size=columns),
        min_size=1,
        max_size=5,
    )
)


@given(matrices, st.fractions(-4, 4, max_denominator=3))
@settings(max_examples=60, deadline=None)
def test_rank_at_a_value_is_read_off_the_diagonal_form(matrix: list, at: Fraction) -> None:
    diagonal = diagonal_form([dict(enumerate(row)) for row in matrix])
    value = fmpq(at.numerator, at.denominator)
    numbers = fmpq_mat(len(matrix), len(matrix[0]), [entry(value) for row in matrix for entry in row])
    assert sum(1 for d in diagonal if d(value) != 0) == numbers.rank()


@given(st.lists(entries, min_size=9, max_size=9))
@settings(max_examples=40, deadline=None)
def test_product_of_the_diagonal_is_the_determinant(entries_: list) -> None:
    a = sympy.Symbol("a")
    as_sympy = [sum(sympy.Integer(int(c.p)) * a**i for i, c in enumerate(e.coeffs())) for e in entries_]
    determinant = sympy.Poly(sympy.Matrix(3, 3, as_sympy).det(), a)
    diagonal = diagonal_form([dict(enumerate(entries_[3 * i : 3 * i + 3])) for i in range(3)])
    if determinant.is_zero:
        assert len(diagonal) < 3
        return
    product = fmpq_poly([1])
    for d in diagonal:
        product *= d
    expected = [fmpq(int(c)) for c in reversed(determinant.all_coeffs())]
    assert product * expected[-1] == fmpq_poly(expected)


#: family, source, group, extended, and the exceptional rational values with their codimensions
FAMILIES = [
    ("x**4 + a*x**2*y**2 + y**4", "x y", "R", False, {2: "infinite", -2: "infinite"}, 10),
    ("x**4 + a*x**2*y**2 + y**4", "x y", "K", True, {2: "infinite", -2: "infinite"}, 9),
    ("x*y*(x + y)*(x + a*y)", "x y", "K", False, {0: "infinite", 1: "infinite"}, 10),
    ("x, y**3 + a*x*y", "x y", "A", True, {0: "infinite"}, 0),
    ("x, x*y + y**6 + a*y**9", "x y", "A", True, {0: 6}, 4),
    ("x, x*y + y**5 + a*y**7", "x y", "A", True, {0: 3}, 2),
    ("x, x*y**2 + y**5 + a*y**6", "x y", "A", True, {0: 5}, 3),
    ("x, y**2, y**3 + a*x**2*y + x**3*y", "x y", "A", True, {0: 2}, 1),
    ("t**4, t**5 + a*t**7", "t", "A", True, {0: 6}, 5),
    ("x**3 + a*x*u + u**2", "x u", "R(H)", True, {0: 4}, 3),
    ("x, a*x*u + u**2", "x u", "A(H)", True, {0: "infinite"}, 0),
]


@cache
def found(text: str, source: str, name: str, extended: bool) -> FamilyCodimension:
    return codimension_of_family(Family(text, source, "a"), name, extended)


@pytest.mark.parametrize(("text", "source", "name", "extended", "jumps", "generic"), FAMILIES)
def test_families_jump_where_they_should(
    text: str, source: str, name: str, extended: bool, jumps: dict, generic: int
) -> None:
    whole = found(text, source, name, extended)
    assert whole.value == generic
    assert {e.value: e.codimension for e in whole.exceptional} == jumps


@given(st.sampled_from(FAMILIES), st.fractions(-6, 6, max_denominator=4))
@settings(max_examples=25, deadline=None)
def test_members_have_the_codimension_of_the_family(row: tuple, value: Fraction) -> None:
    text, source, name, extended, *_ = row
    whole = found(text, source, name, extended)
    if whole.at(value) != "infinite":
        assert codimension(Family(text, source, "a").at(a=value), name, extended).value == whole.at(value)


def test_irrational_values_are_exceptional_too() -> None:
    whole = codimension_of_family(Family("x**3 + a*x*y**2 + y**3", "x y", "a"), "R")
    (jump,) = whole.exceptional
    assert (whole.value, jump.polynomial, jump.value, jump.real) == (5, "4*a**3 + 27", None, 1)
    assert jump.codimension is None
    assert jump.at_least > 5
    # the discriminant, with a simple double line beside: D₄ becomes the product of a line and a double line
    softened = codimension_of_family(Family("x**3 + a*x*y**2 + y**3 + x**4", "x y", "a"), "R")
    assert [(e.polynomial, e.codimension) for e in softened.exceptional] == [("4*a**3 + 27", 6)]


def test_an_algebraic_value_is_conjugate_to_a_rational_one() -> None:
    """At a² = 2 the family is what another one is at a rational value."""
    irrational = codimension_of_family(Family("x, x*y + (a**2 - 2)*y**4 + y**5 + y**7", "x y", "a"), "A")
    rational = codimension_of_family(Family("x, x*y + a*y**4 + y**5 + y**7", "x y", "a"), "A")
    jump, other = irrational.exceptional, rational.exceptional
    assert [(e.polynomial, e.real) for e in jump] == [("a**2 - 2", 2)]
    assert [e.codimension for e in jump] == [e.codimension for e in other] == [4]
    assert irrational.value == rational.value == 3


def test_p3_is_not_finite_at_four_values() -> None:
    whole = codimension_of_family(Family("y, x*y + x**3, x**2*y + a*x**4", "x y", "a"), "A", curves=False)
    assert whole.value == 6
    assert sorted(e.value for e in whole.exceptional) == [0, Fraction(1, 2), 1, Fraction(3, 2)]
    assert all(e.codimension is None and e.at_least > 6 for e in whole.exceptional)


@pytest.mark.parametrize("sign", "+-")
def test_moduli_of_rieger(sign: str) -> None:
    one = Family(f"x, x*y + y**6 {sign} y**8 + a*y**9", "x y", "a")
    whole, single = codimension_of_family(one, "A", extended=True), moduli(one, "A")
    assert (whole.value, whole.exceptional) == (4, ())
    assert (single.number, single.stratum, single.proved) == (1, 5, True)
    two = Family(f"x, x*y + y**7 {sign} y**9 + a*y**10 + b*y**11", "x y", "a b")
    several = moduli(two, "A")
    assert (several.number, several.codimension, several.stratum, several.proved) == (2, 8, 6, False)


@pytest.mark.parametrize(("sign", "alpha"), [("+", Fraction(0)), ("-", Fraction(1))])
def test_two_moduli_of_rieger_have_a_curve_of_jumps(sign: str, alpha: Fraction) -> None:
    """x, xy + y⁷ ± y⁹ + αy¹⁰ + βy¹¹ has A_e codimension 6 but for β = 29/42 ± 9α²/8, where it has 7."""
    family = Family(f"x, x*y + y**7 {sign} y**9 + a*y**10 + b*y**11", "x y", "a b").restricted(a=alpha)
    whole = codimension_of_family(family, "A", extended=True)
    expected = Fraction(29, 42) + Fraction(9, 8) * alpha**2 * (1 if sign == "+" else -1)
    assert whole.value == 6
    assert [(e.value, e.codimension) for e in whole.exceptional] == [(expected, 7)]


def test_removable_parameters() -> None:
    assert moduli(Family("x, y**3 + a*x*y", "x y", "a"), "A").number == 0
    assert moduli(Family("x, x*y + y**6 + a*y**9", "x y", "a"), "A").number == 0
    assert moduli(Family("x**2 + a*x*y + y**2", "x y", "a"), "R").number == 0
    assert moduli(Family("x**4 + a*x**2*y**2 + y**4", "x y", "a"), "R").number > 0
    assert moduli(Family("x*y*(x + y)*(x + a*y)", "x y", "a"), "K").number > 0
    assert moduli(Family("a*x**2", "x", "a"), "R").number == 0


def test_moduli_of_a_table_agree_with_one_member() -> None:
    """X₉ as T_{2,4,4}: Arnold's families have as many moduli as parameters."""
    assert moduli(Family("x**3 + a*x**2*y**2 + y**6", "x y", "a"), "R").number == 1
    parabolic = Family("x**3 + y**3 + z**3 + a*x*y*z", "x y z", "a")
    assert codimension_of_family(parabolic, "R", extended=True).value == 8
    assert [e.polynomial for e in codimension_of_family(parabolic, "R", extended=True).exceptional] == [
        "a + 3",
        "a**2 - 3*a + 9",
    ]
    assert moduli(parabolic, "R").number == 1
    assert moduli(parabolic, "K").stratum == moduli(parabolic, "K").codimension - 1


def test_own_groups() -> None:
    own = Group("scaling", "own", "contact", ("x, 0", "0, y"))
    whole = codimension_of_family(Family("x**2 + a*y**2, x*y", "x y", "a"), own, extended=True)
    assert [e.value for e in whole.exceptional] == [0]
    assert whole.value == codimension(Family("x**2 + a*y**2, x*y", "x y", "a").at(a=7), own, True).value
    with pytest.raises(DomainError, match="fraction"):
        codimension_of_family(Family("a*x", "x", "a"), Group("half", "own", "none", ("x/2",)))


def test_members_and_restrictions() -> None:
    family = Family("x*y + a*b*x**3 + b/2*y**2", "x y", "a b")
    assert family.at(a="1/3", b=6).text(3) == ("2*x**3 + x*y + 3*y**2",)
    assert family.restricted(b=6).at(a="1/3").text(3) == family.at(a="1/3", b=6).text(3)
    (rate,) = family.velocity("b", 3, a=2, b=5)
    assert rate == {poly.monomial((3, 0)): 2, poly.monomial((0, 2)): Fraction(1, 2)}
    assert Family("x*u + a*x", "x u", "a").at(a=1).boundary == "u"
    assert Family("u*x**2", "x", "u").at(u=3).boundary is None
    assert reference("rieger")["4_k"].germ(k=2).n == 2


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        (("x + a", "x", "a"), DomainError),
        (("sin(a*x)", "x", "a"), DomainError),
        (("x**2", "x", ""), DomainError),
        (("a*x", "x a", "a"), DomainError),
        (("a*x + b", "x", "a"), FormulaError),
        (("a*x**4000*y**400", "x y", "a"), DomainError),
        (("a*x", "x", "a", "w"), DomainError),
    ],
)
def test_bad_families(arguments: tuple, error: type[Exception]) -> None:
    with pytest.raises(error):
        Family(*arguments)


def test_bad_questions() -> None:
    family = Family("a*x + b*x**2", "x", "a b")
    for values in ({"a": 1}, {"a": 1, "c": 2, "b": 3}, {"a": "pi", "b": 1}, {"a": "1/0", "b": 1}):
        with pytest.raises(DomainError):
            family.at(**values)
    with pytest.raises(DomainError, match="restricted"):
        codimension_of_family(family, "R")
    with pytest.raises(DomainError):
        family.restricted(a=1, b=2)
    with pytest.raises(UndecidedError):
        codimension_of_family(Family("a*x**2", "x y", "a"), "R")


def test_polynomials_of_exceptional_values() -> None:
    assert polynomial_text((3, 0, -1), "c") == "-c**2 + 3"
    assert [real_roots(q) for q in ((1, 0, 1), (0, 1), (-1, -1, 1), (1, 0, 0, 0, 1))] == [0, 1, 2, 0]
    germ = GenericGerm(Family("x, (a - 1)*y**2 + y**3 + x*y", "x y", "a"))
    at_one = codimension_at_root(germ, group("A"), True, (-1, 1), 3)
    assert (at_one.at_least, at_one.settled) == (0, True)
