"""Jets of maps: composition against sympy, inverses, flows against their differential equation."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
import sympy

from osculant.cas.errors import DomainError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.jets_of_maps import MapJet, map_jet


def random_polynomial(draw, n, order, least):
    """A dense polynomial with the terms of degrees least, …, order."""
    return {
        m: c
        for m in poly.monomials(n, order)
        if poly.degree_of(m, n) >= least
        and (c := draw.choice([0, 1, -1, 2, Fraction(1, 2), Fraction(-2, 3)]))
    }


def random_map(draw, n, p, order, least=1):
    return map_jet([random_polynomial(draw, n, order, least) for _ in range(p)], n, order)


def expressions(jet, names):
    return [
        sum(
            sympy.Rational(Fraction(c).numerator, Fraction(c).denominator)
            * sympy.prod(x**e for x, e in zip(names, poly.exponents_of(m, len(names))))
            for m, c in f.items()
        )
        for f in jet.polynomials()
    ]


def cut(expression, names, order):
    terms = sympy.Poly(sympy.expand(expression), *names).terms()
    return {poly.monomial(e): Fraction(int(c.p), int(c.q)) for e, c in terms if c and sum(e) <= order}


@pytest.mark.parametrize(("m", "n", "p", "order"), [(1, 1, 2, 6), (2, 2, 3, 4), (3, 2, 2, 3), (2, 3, 1, 4)])
def test_composition(m, n, p, order):
    draw = random.Random(m + 10 * n + 100 * p)
    inner, outer = random_map(draw, m, n, order), random_map(draw, n, p, order)
    x, y = sympy.symbols(f"x:{m}"), sympy.symbols(f"y:{n}")
    put = dict(zip(y, expressions(inner, x)))
    expected = [cut(f.subs(put, simultaneous=True), x, order) for f in expressions(outer, y)]
    found = outer.compose(inner).polynomials()
    assert [{k: Fraction(c) for k, c in f.items()} for f in found] == expected


@pytest.mark.parametrize(("n", "order"), [(1, 9), (2, 6), (3, 4), (4, 3)])
def test_inverses(n, order):
    draw = random.Random(n)
    identity = tuple({poly.variable(i, n): 1} for i in range(n))
    tried = 0
    while tried < 3:
        jet = random_map(draw, n, n, order)
        if jet.linear_part().det() == 0:
            with pytest.raises(DomainError, match="not invertible"):
                jet.inverse()
            continue
        tried += 1
        back = jet.inverse()
        assert back.compose(jet).polynomials() == jet.compose(back).polynomials() == identity


def nilpotent(draw, n, order):
    """A field with a strictly triangular linear part and dense higher terms."""
    components = [random_polynomial(draw, n, order, 2) for _ in range(n)]
    for i, f in enumerate(components):
        f.update({poly.variable(j, n): draw.choice([1, -2, Fraction(1, 3)]) for j in range(i + 1, n)})
    return components


@pytest.mark.parametrize(("n", "order"), [(1, 7), (2, 5), (3, 4)])
def test_flows(n, order):
    draw = random.Random(n)
    components = nilpotent(draw, n, order)
    identity = map_jet([{poly.variable(i, n): 1} for i in range(n)], n, order)

    def at(time) -> MapJet:
        scaled = [{m: c * Fraction(time) for m, c in f.items()} for f in components]
        return map_jet(scaled, n, order).flow(identity)

    # a one-parameter group …
    assert at(1).compose(at(Fraction(1, 2))).polynomials() == at(Fraction(3, 2)).polynomials()
    assert at(-1).polynomials() == at(1).inverse().polynomials()
    # … with the field as velocity at 0
    tiny = Fraction(1, 10**12)
    for i, f in enumerate(at(tiny).polynomials()):
        for m in poly.monomials(n, order):
            slope = (Fraction(f.get(m, 0)) - (m == poly.variable(i, n))) / tiny
            assert abs(slope - components[i].get(m, 0)) < Fraction(1, 10**6)
    # functions are carried along by composition
    f = random_map(draw, n, 2, order)
    field = map_jet(components, n, order)
    assert field.flow(f).polynomials() == f.compose(field.flow(identity)).polynomials()


def test_refused():
    x = poly.variable(0, 1)
    for components, order in (([], 2), ([{x: 1}], 0), ([{0: 1, x: 1}], 3)):
        with pytest.raises(DomainError):
            map_jet(components, 1, order)
    line, plane = map_jet([{x: 1}], 1, 3), map_jet([{poly.variable(0, 2): 1}], 2, 3)
    with pytest.raises(DomainError, match="not composed"):
        plane.compose(line)
    with pytest.raises(DomainError, match="not invertible"):
        plane.inverse()
    with pytest.raises(DomainError, match="nilpotent"):
        line.flow(line)
    with pytest.raises(DomainError, match="same order"):
        line.flow(plane)
