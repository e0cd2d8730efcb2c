"""Weights against Milnor numbers, families where a scaling moves the parameter."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.family import Family
from osculant.cas.germs.geometry import prove
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import group
from osculant.cas.germs.local_algebra import milnor_number
from osculant.cas.germs.parameters import codimension_of_family
from osculant.cas.germs.weights import graded_by, weights
from tests.cas.germs.oracles import milnor_orlik

ISOLATED = [
    "x**2 + y**2",
    "x**5 + y**2",
    "x**2*y + y**4",
    "x**3 + y**4",
    "x**3 + x*y**3",
    "x**3 + y**5",
    "x**4 + x**2*y**2 + y**4",
    "x**3 + y**7",
]
NOT_ISOLATED = [
    "(x**2 + y**2)**2",
    "x**2*y",
    "x**2",
    "(x**3 - 2*y**2)**2",
    "(x + 3*y)**2*(x - y)",
    "x**2*y**2",
]


@pytest.mark.parametrize("text", ISOLATED)
def test_milnor_and_orlik(text: str) -> None:
    germ = Germ(text, "x y")
    assert milnor_orlik(germ) == milnor_number(germ)
    assert prove(germ, group("R")) is None


@pytest.mark.parametrize("text", NOT_ISOLATED)
def test_critical_points_that_are_not_isolated(text: str) -> None:
    assert prove(Germ(text, "x y"), group("R")) is not None
    assert prove(Germ(text, "x y"), group("K")) is not None


def test_weights_that_grade_a_germ() -> None:
    assert graded_by(Germ("a, b, z**4 + a*z + b*z**2", "a b z")) == (3, 2, 1)
    assert graded_by(Germ("x**2 + y**2", "x y")) is None  # all equal: nothing is gained
    assert graded_by(Germ("sin(x)", "x")) is None


@given(
    st.lists(st.integers(1, 6), min_size=2, max_size=3),
    st.lists(st.integers(4, 14), min_size=1, max_size=2),
    st.integers(1, 5),
)
@settings(max_examples=40, deadline=None)
def test_germs_made_of_monomials_of_one_weight_have_weights(source: list, target: list, c: int) -> None:
    n = len(source)
    components, used = [], []
    for d in target:
        terms = [
            m
            for m in poly.monomials(n, 14)
            if m and sum(w * e for w, e in zip(source, poly.exponents_of(m, n))) == d
        ]
        used.append(terms)
        products = ("*".join(f"x{i}**{e}" for i, e in enumerate(poly.exponents_of(m, n))) for m in terms)
        components.append(" + ".join(f"{c}*{product}" for product in products) or "0")
    found = weights(Germ(", ".join(components), [f"x{i}" for i in range(n)]))
    assert found is not None
    for terms, d in zip(used, found.target):
        of_terms = {sum(w * e for w, e in zip(found.source, poly.exponents_of(m, n))) for m in terms}
        assert of_terms <= {d}


def test_germs_without_weights() -> None:
    assert weights(Germ("x**2 + x**3", "x")) is None
    assert weights(Germ("x, x*y + y**5 + y**7", "x y")) is None
    with pytest.raises(DomainError):
        weights(Germ("sin(x)", "x"))
    with pytest.raises(DomainError):
        milnor_orlik(Germ("x, y**2", "x y"))


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("y, x*y + x**3, x**2*y + 2*x**4 + a*x**5", "A"),
        ("x, x*y + y**6 + a*y**9", "A"),
        ("x**3 + y**4 + a*x*y**3", "R"),
        ("x**3 + y**2 + a*x*y**2", "R"),
    ],
)
def test_a_parameter_that_scalings_move_can_jump_only_at_zero(text: str, name: str) -> None:
    """The scaling of the variables turns f_a into f_{ca} for every c but 0."""
    family = Family(text, "x y", "a")
    assert weights(family.at(a=0)) is not None
    assert weights(family.at(a=1)) is None
    whole = codimension_of_family(family, name, curves=False)
    assert {e.value for e in whole.exceptional} <= {Fraction(0)}
