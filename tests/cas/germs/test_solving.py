"""Exact solutions of X·f = target: the fields are applied anew, by sympy, and must give the target."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
import sympy

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version, group
from osculant.cas.germs.solving import fields, solve
from osculant.cas.germs.tangent import vectors
from osculant.cas.germs.tangent_space import tangent

CASES = [
    ("x**3 + y**4/3", "x y", "R", 5),
    ("x**2/2 + y**3, x*y", "x y", "K", 4),
    ("x, x*y + y**3/7", "x y", "A", 5),
    ("x/2 - y, (x + y**2)**2/3, y**3 + x**3*y", "x y", "A", 4),
    ("x, u**2/5 + x*u", "x u", "A(H)", 4),
    ("x**2 + y**2/3", "x y", "C", 3),
    ("x, y**2", "x y", "L", 4),
]


def applied(field, weight, germ, order):
    """The field times the weight, applied to the germ by sympy."""
    x, names = sympy.symbols(germ.source), germ.source
    f = [sympy.sympify(text) for text in germ.text(order + 1)]
    found = [sympy.Integer(0)] * germ.p
    factor = sympy.Rational(weight.numerator, weight.denominator)
    if field.side == "source":
        monomial = sympy.prod(v**e for v, e in zip(x, field.multiplier))
        if germ.boundary is not None and names[field.generator] == germ.boundary:
            monomial *= x[field.generator]
        return [factor * monomial * sympy.diff(g, x[field.generator]) for g in f]
    if field.side == "target":
        found[field.generator] = factor * sympy.prod(g**e for g, e in zip(f, field.multiplier))
    else:
        i, j = field.generator
        found[j] = factor * sympy.prod(v**e for v, e in zip(x, field.multiplier)) * f[i]
    return found


def as_dictionary(f, germ, order):
    terms = sympy.Poly(sympy.expand(f), *sympy.symbols(germ.source)).terms()
    return {poly.monomial(e): Fraction(int(c.p), int(c.q)) for e, c in terms if c and sum(e) <= order}


@pytest.mark.parametrize("case", CASES, ids=lambda c: f"{c[2]}: {c[0]}")
@pytest.mark.parametrize("version", Version)
def test_solutions_give_the_target(case, version):
    text, source, name, order = case
    germ, draw = Germ(text, source), random.Random(order)
    made = list(fields(germ, name, version, order))
    # a target in the tangent space: a random combination of its vectors
    target = [{} for _ in range(germ.p)]
    for _, vector in draw.sample(made, min(7, len(made))):
        weight = Fraction(draw.randint(-5, 5), draw.randint(1, 4))
        target = [poly.plus(f, g, weight) for f, g in zip(target, vector)]
    found = solve(germ, name, version, order, target)
    assert found is not None
    total = [sympy.Integer(0)] * germ.p
    for field, weight in found.items():
        total = [a + b for a, b in zip(total, applied(field, weight, germ, order))]
    assert [as_dictionary(f, germ, order) for f in total] == [
        {m: Fraction(c) for m, c in f.items()} for f in target
    ]


@pytest.mark.parametrize("case", CASES, ids=lambda c: f"{c[2]}: {c[0]}")
def test_what_a_functional_sees_has_no_solution(case):
    text, source, name, order = case
    germ = Germ(text, source)
    known = tangent(germ, group(name), Version.ORDINARY, order)
    column = max(known.annihilator.free)
    m, j = known.space.term(column)
    outside = [{m: 1} if i == j else {} for i in range(germ.p)]
    assert solve(germ, name, Version.ORDINARY, order, outside) is None


def test_fields_and_vectors_are_the_same():
    for text, source, name, order in CASES:
        germ = Germ(text, source)
        spanned = [v for v in vectors(germ, group(name), Version.EXTENDED, order) if any(v)]
        assert len(spanned) == len(list(fields(germ, name, Version.EXTENDED, order)))


def test_fields_of_ones_own():
    cusp = Group("R(cusp)", "own", "none", ("2*x, 3*y", "2*y, 3*x**2"))
    germ = Germ("x + y**2", "x y")
    found = solve(germ, cusp, Version.EXTENDED, 2, germ.jet(2))
    assert found is not None  # x + y² = (2x∂x + 3y∂y)f/2 − y·(2y∂x + 3x²∂y)f + …
    assert {field.side for field in found} == {"source"}
