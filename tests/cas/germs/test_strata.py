"""Families with several parameters against discriminants, single members and one-parameter families."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest
import sympy

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.elimination import generic_rank
from osculant.cas.germs.family import Family
from osculant.cas.germs.groups import Group
from osculant.cas.germs.model import ring
from osculant.cas.germs.parameters import codimension_of_family
from osculant.cas.germs.search import Patience
from osculant.cas.germs.strata import stratification


def told(text: str, source: str, parameters: str, group: str = "R") -> tuple:
    found = stratification(Family(text, source, parameters), group, extended=True)
    return found.value, {frozenset(s.conditions): s.codimension for s in found.exceptional}


def test_one_parameter() -> None:
    value, strata = told("x, x*y + y**3, x*y**2 + c*y**4", "x y", "c", "A")
    assert value == 4
    assert strata == {frozenset([q]): "infinite" for q in ("c", "2*c - 1", "c - 1", "2*c - 3")}


@pytest.mark.parametrize(
    ("text", "parameters", "value", "strata"),
    [
        ("x**3 + a*x*y**2 + b*y**3", "a b", 4, {"4*a**3 + 27*b**2": "infinite", "a, b": "infinite"}),
        ("x**2 + 2*a*x*y + b*y**2", "a b", 1, {"a**2 - b": "infinite"}),
        ("x**4 + a*x**2*y**2 + b*y**4", "a b", 9, {"a**2 - 4*b": "infinite", "b": "infinite"}),
        ("a*x**2*y + b*y**4 + x**5", "a b", 5, {"a": 12, "b": "infinite"}),
    ],
)
def test_functions(text: str, parameters: str, value: int, strata: dict) -> None:
    found = told(text, "x y", parameters)
    assert found == (value, {frozenset(k.split(", ")): v for k, v in strata.items()})


def test_umbrellas_and_cusps() -> None:
    assert told("x, y**2, y**3 + a*x**2*y + b*x**3*y", "x y", "a b", "A") == (
        1,
        {frozenset(["a"]): 2, frozenset(["a", "b"]): "infinite"},
    )
    assert told("x, x*y + a*y**3 + b*y**4 + y**5", "x y", "a b", "A") == (
        0,
        {frozenset(["a"]): 1, frozenset(["a", "b"]): 3},
    )


def test_members_have_what_the_strata_say() -> None:
    text = "x, x*y + y**3, x*y**2 + b*y**3 + c*y**4"
    family = Family(text, "x y", "b c")
    value, strata = told(text, "x y", "b c", "A")
    assert value == codimension(family.at(b="5/7", c=-4), "A", extended=True).value
    assert strata[frozenset(["b"])] == codimension(family.at(b=0, c=7), "A", extended=True).value
    for c in (0, "1/2", 1, "3/2"):
        q = {0: "c", "1/2": "2*c - 1", 1: "c - 1", "3/2": "2*c - 3"}[c]
        assert any(strata.get(frozenset(key)) == "infinite" for key in (["b", q], [q]))
        assert codimension(family.at(b=0, c=c), "A", extended=True).value == "infinite"
    assert codimension(family.at(b=3, c=1), "A", extended=True).value == strata[frozenset(["c - 1"])]


def test_irrational_strata() -> None:
    value, strata = told("(a**2 - 2)*x**2 + b*x**3", "x", "a b")
    assert (value, strata[frozenset(["a**2 - 2"])]) == (1, 2)
    found = stratification(Family("(a**2 + 1)*x**2 + b*x**3", "x", "a b"), "R")
    assert {s.conditions: s.real for s in found.exceptional}[("a**2 + 1",)] == 0


def test_what_is_not_known_is_said() -> None:
    """A discriminant that is linear in no parameter, and not an orbit of scalings."""
    found = stratification(Family("x**3 + a*x**2*y + b*x*y**2 + c*y**3", "x y", "a b c"), "R")
    (discriminant,) = (s for s in found.exceptional if len(s.conditions) == 1)
    assert discriminant.codimension is None
    assert discriminant.at_least == found.value == 5
    with pytest.raises(UndecidedError):
        stratification(Family("(a + b*x)*x**2 + (1 + b)*x**2*y**2", "x y", "a b"), "R", patience=Patience(2))


def test_own_groups_have_no_scalings() -> None:
    own = Group("scaling", "own", "contact", ("x, 0", "0, y"))
    family = Family("x**2 + a*y**2 + b*y**2, x*y", "x y", "a b")
    found = stratification(family, own, extended=True)
    one = codimension_of_family(Family("x**2 + a*y**2, x*y", "x y", "a"), own, extended=True)
    assert found.value == one.value
    assert [s.conditions for s in found.exceptional] == [("a + b",)]


def test_ranks_at_random_values() -> None:
    a, b = ring(["a", "b"]).gens()
    rows = [
        {0: a, 1: b + 1, 2: a * b},
        {0: b, 1: a, 2: a - b},
        {0: a + b, 1: a + b + 1, 2: a * b + a - b},
        {0: a * a, 2: b},
    ]
    found = generic_rank(rows)
    assert found.rank == 3
    for i in range(-4, 5):
        for j in range(-4, 5):
            values = [
                [Fraction(str(row.get(c, a - a).compose(*_numbers(i, j)))) for c in range(3)] for row in rows
            ]
            drops = _rank(values) < 3
            zero = any(q.compose(*_numbers(i, j)).is_zero() for q in found.candidates)
            assert zero or not drops


@pytest.mark.parametrize(
    ("text", "source", "group"),
    [
        ("x**3 + a*x**2*y + b*y**4 + y**5", "x y", "R"),
        ("x**2*y + a*y**3 + b*x*y**2 + y**5", "x y", "R"),
        ("x**2 + a*x*u + b*u**2 + u**3", "x u", "R(H)"),
        ("x, y**3 + a*x*y + b*x**2*y", "x y", "A"),
        ("(a*b - 1)*x**2 + (a - b)*x**3 + x**4", "x", "R"),
    ],
)
def test_every_member_has_the_codimension_of_its_stratum(text: str, source: str, group: str) -> None:
    family = Family(text, source, "a b")
    found = stratification(family, group, extended=True)
    for a, b in product((-1, 0, 1, 2), (-1, 0, 1, Fraction(1, 4))):
        at = {"a": sympy.Rational(a), "b": sympy.Rational(str(b))}
        here = [
            s.codimension
            for s in found.exceptional
            if all(sympy.sympify(q).subs(at) == 0 for q in s.conditions)
        ]
        value = codimension(family.at(a=a, b=b), group, extended=True).value
        assert value == ("infinite" if "infinite" in here else max([found.value, *here]))


def _numbers(i: int, j: int) -> list:
    context = ring(["a", "b"])
    return [context.constant(i), context.constant(j)]


def _rank(rows: list) -> int:
    from flint import fmpq, fmpq_mat

    flat = [fmpq(v.numerator, v.denominator) for row in rows for v in row]
    return fmpq_mat(len(rows), len(rows[0]), flat).rank()
