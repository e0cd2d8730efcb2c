"""Fields that move a germ, added up by sympy; jets of maps against series that are known."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
import sympy

import osculant as osc
from osculant.cas.errors import DomainError, FormulaError
from osculant.germs.solutions import VERSIONS


def applied(germ, combination, fields):
    """X·f by sympy: every term from its side, multiplier and text."""
    source = sympy.symbols(germ.source)
    f = [sympy.sympify(c) for c in germ.components]
    total = [sympy.Integer(0)] * len(f)
    for term in combination.terms:
        c = sympy.sympify(str(term.coefficient))
        if term.side == "source":
            factor = c * sympy.prod(x**e for x, e in zip(source, term.multiplier))
            name = term.field.rpartition("∂/∂")[2]
            if fields == "boundary" and name == "u":
                factor *= sympy.Symbol("u")
            total = [t + factor * sympy.diff(g, name) for t, g in zip(total, f)]
        elif term.side == "target":
            factor = c * sympy.prod(g**e for g, e in zip(f, term.multiplier))
            j = int(term.field.rpartition("∂/∂y")[2]) - 1
            total[j] += factor
        else:
            factor = c * sympy.prod(x**e for x, e in zip(source, term.multiplier))
            i, j = (int(part[1:]) - 1 for part in term.field.split()[-2:])
            total[j] += factor * f[i]
    return total


def cut(expression, source, order):
    if expression == 0:
        return {}
    found = sympy.Poly(sympy.expand(expression), *sympy.symbols(source)).terms()
    return {m: sympy.nsimplify(sympy.expand(c)) for m, c in found if sum(m) <= order and sympy.expand(c) != 0}


@pytest.mark.parametrize(
    ("text", "source", "group", "order"),
    [
        ("x, y**2, x*y", "x y", "A", 4),
        ("x, x*y + y**4", "x y", "A", 5),
        ("x**3 + x*y**3", "x y", "R", 6),
        ("x**2 + y**3, x*y", "x y", "K", 4),
        ("x, u**2 + x*u", "x u", "A(H)", 4),
        ("x**2 + y**2, y**3", "x y", "C", 5),
        ("x**2, x**3", "x", "L", 8),
        ("sqrt(2)*x**3 + x*y**3 + y**4", "x y", "R", 5),
        ("x, sqrt(2)*x*y + y**3", "x y", "A", 4),
    ],
)
def test_what_is_solved_is_added_up(text, source, group, order):
    germ, random_ = osc.germ(text, source), random.Random(text)
    names, boundary = source.split(), "boundary" if "(H)" in group else ""
    terms = [
        "*".join(
            [
                str(Fraction(random_.randint(-5, 5), random_.randint(1, 3))),
                *(f"{n}**{e}" for n, e in zip(names, m)),
            ]
        )
        for m in [(order - k, k)[: len(names)] for k in range(3)]
    ]
    components = [random_.choice(terms) for _ in range(germ.target)]
    solved = 0
    for version in VERSIONS:
        for j in range(germ.target):
            wanted = [c if i == j else "0" for i, c in enumerate(components)]
            found = germ.solve(", ".join(wanted), order, group, version)
            if found is None:
                continue
            solved += 1
            assert found.order == order
            for told, asked in zip(applied(germ, found, boundary), wanted):
                assert cut(told, germ.source, order) == cut(sympy.sympify(asked), germ.source, order)
    assert solved


def test_what_is_not_solved_raises_the_codimension():
    germ = osc.germ("x, y**2, y**3 + x**2*y", "x y")
    assert germ.solve("0, 0, y", 6, version="extended") is None  # the unfolding's term
    assert germ.solve("0, 0, x*y", 6, version="extended") is not None
    assert str(germ.solve("0, 0, 0", 6)) == "0"
    assert osc.germ("x**2", "x").solve([{(2,): 1}], 3).terms[0].coefficient == Fraction(1, 2)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("x", 3), "1 components, the germ 2"),
        (("x, y", 0), "order: 0"),
        (("x, y", 2.0), "order: 2.0"),
        (("x, y", True), "order: True"),
        (("x, y", 61), "order: 61"),
        (("x, y", 3, "A", "full"), "version: 'full'"),
        (("x, y", 3, "A(H)"), "boundary variable"),
        (("x, pi*y", 3), "pi is neither rational nor algebraic"),
    ],
)
def test_questions_that_are_none(arguments, words):
    with pytest.raises(DomainError, match=words):
        osc.germ("x, y**2", "x y").solve(*arguments)
    with pytest.raises(FormulaError):
        osc.germ("x, y**2", "x y").solve("x, z", 3)


@pytest.mark.parametrize(
    ("text", "inverse"), [("sin(x)", "asin(x)"), ("exp(x) - 1", "log(1 + x)"), ("x/(1 - x)", "x/(1 + x)")]
)
def test_inverses_that_are_known(text, inverse):
    f, g = osc.map_jet(text, "x", 12), osc.map_jet(inverse, "x", 12)
    assert f.inverse() == g and g.inverse() == f
    assert f.compose(g) == g.compose(f) == osc.map_jet("x", "x", 12)
    assert hash(f.inverse()) == hash(g) and f != g


def test_maps_of_the_plane():
    f = osc.map_jet("x + x*y - y**2/2, 2*y + x + x**2", "x y", 5)
    g = osc.map_jet("sin(x) + y**3, y - x**2/3", "x y", 5)
    identity = osc.map_jet("x, y", "x y", 5)
    assert f.compose(f.inverse()) == identity == f.inverse().compose(f)
    assert f.compose(g).inverse() == g.inverse().compose(f.inverse())
    field = osc.map_jet("y + x*y, x**2", "x y", 5)
    back = osc.map_jet("-y - x*y, -x**2", "x y", 5)
    assert back.flow(field.flow(g)) == g
    assert field.flow(f.compose(g)) == f.compose(field.flow(g))
    assert repr(identity) == "<JetOfMap x, y in x y to order 5>" and identity.order == 5


def test_flows_that_are_known():
    # x' = x², y' = x y flows to x/(1 − x), y/(1 − x)
    moved = osc.map_jet("x**2, x*y", "x y", 6).flow(osc.map_jet("x, y", "x y", 6))
    assert moved == osc.map_jet("x/(1 - x), y/(1 - x)", "x y", 6)


@pytest.mark.parametrize(
    ("act", "words"),
    [
        (lambda: osc.map_jet("1 + x", "x", 3), "not 0"),
        (lambda: osc.map_jet("x", "x", 0), "order: 0"),
        (lambda: osc.map_jet("x", "x", 201), "order: 201"),
        (lambda: osc.map_jet("sqrt(2)*x", "x", 3), "irrational coefficients"),
        (lambda: osc.map_jet("x**2", "x", 3).inverse(), "not invertible"),
        (lambda: osc.map_jet("x", "x", 3).compose(osc.map_jet("x", "x", 4)), "order 4"),
        (lambda: osc.map_jet("x", "x", 3).flow(osc.map_jet("x", "x", 3)), "nilpotent"),
        (lambda: osc.map_jet("x**2", "x", 3).flow(osc.map_jet("y", "y", 3)), "same names"),
    ],
)
def test_jets_that_are_none(act, words):
    with pytest.raises(DomainError, match=words):
        act()
