"""Dense germs are seen modulo a prime first: the same tangent spaces, and what a prime hides is not lost."""

from __future__ import annotations

import random

import numpy as np
import pytest
from flint import nmod_mat

from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Version, group
from osculant.cas.germs.lifting import primes
from osculant.cas.germs.linear_fields import pairings
from osculant.cas.germs.modular_first import Unsettled, seen_first
from osculant.cas.germs.modular_ring import BELOW, ModularRing
from osculant.cas.germs.modular_span import Span, product
from osculant.cas.germs.modular_tangent import APART, is_dense, modular_tangent
from osculant.cas.germs.tangent_space import tangent
from osculant.cas.germs.unipotent import modular_rank, residue
from tests.cas.germs.checker import Problem, check_codimension
from tests.random_germs import Change

#: a prime that is tried first for jets of some order
ORDER = 3
FIRST = next(primes(BELOW - APART * ORDER - 1))
GERMS = [
    ("x**3 + y**4", "x y", "R"),
    ("x**2*y + y**5 + x*u", "x y u", "R(H)"),
    ("x**2 + y**3, y**2 + x**3", "x y", "K"),
    ("x, x*u + u**3", "x u", "K(H)"),
    ("x, x*y + y**4", "x y", "A"),
    ("x, y**2, y**3 + x**3*y", "x y", "A"),
    ("x, y, z**2, z**3 + (x**2 + y**2)*z", "x y z", "A"),
    ("x**2 + y**3, y**2 + x**3", "x y", "A"),
    ("x, y, x*z + z**3 + y*u, u + z**2", "x y z u", "A(H)"),
    ("x, u", "x u", "A(H)"),
]


def dense(text: str, source: str, name: str, order: int = 9) -> Germ:
    germ = Change(7, order).applied(Germ(text, source), name)
    assert is_dense(germ, group(name), order)
    return germ


@pytest.mark.parametrize("prime", [101, FIRST, 2**31 - 1])
def test_products_and_spans_modulo_primes(prime):
    chance = np.random.default_rng(prime)
    a, b = chance.integers(0, prime, (40, 300)), chance.integers(0, prime, (300, 30))
    assert (product(a, b, prime) == a.astype(object) @ b.astype(object) % prime).all()
    low = product(chance.integers(0, prime, (200, 17)), chance.integers(0, prime, (17, 90)), prime)
    span = Span(90, prime)
    span.add_all([low[i : i + 50] for i in range(0, 200, 50)])
    assert len(span.pivots) == nmod_mat(200, 90, low.ravel().tolist(), prime).rank() == 17
    free, values = span.annihilator()
    assert len(free) == 73 and not product(low, values, prime).any()
    assert modular_rank(low[span.used].tolist(), prime) == 17


def test_rings_multiply_and_differentiate():
    ring = ModularRing(3, 3, 6, 1, 101)
    chance = random.Random(1)
    f, g = (np.array([chance.randrange(101) for _ in range(ring.size)]) for _ in range(2))
    expected = np.zeros(ring.size, dtype=np.int64)
    terms = [tuple(e) for e in ring.exponents.tolist()]
    place = {e: i for i, e in enumerate(terms)}
    for e, a in zip(terms, f):
        for d, b in zip(terms, g):
            if (at := place.get(tuple(x + y for x, y in zip(e, d)))) is not None:
                expected[at] = (expected[at] + a * b) % 101
    assert (ring.times(f, g) == expected).all()
    slope = ring.derivative(f, 2)
    raised = [(i, place.get((e[0], e[1], e[2] + 1)), e[2] + 1) for i, e in enumerate(terms)]
    assert all(slope[i] == f[at] * factor % 101 for i, at, factor in raised if at is not None)


@pytest.mark.parametrize(("text", "source", "name"), GERMS)
@pytest.mark.parametrize("version", Version)
def test_jets_modulo_a_prime_are_those_over_the_rationals(text, source, name, version):
    germ, g = dense(text, source, name), group(name)
    for order in (2, 4):
        exact = tangent(germ, g, version, order)
        seen = modular_tangent(germ, g, version, order, None)
        assert seen is not None
        assert seen.codimension == exact.annihilator.codimension
        assert seen.depth == exact.depth
        values = seen.pairings(germ, g)
        for field, found in values.items():
            known = pairings(field, germ, exact.space, exact.annihilator.functionals)
            assert any(found) == any(known)
        known_rows = [
            [residue(v, seen.prime) for v in pairings(f, germ, exact.space, exact.annihilator.functionals)]
            for f in values
        ]
        # the same relations between the fields
        assert modular_rank(list(values.values()), seen.prime) == modular_rank(known_rows, seen.prime)
        both = [[*a, *b] for a, b in zip(values.values(), known_rows)]
        assert modular_rank(both, seen.prime) == modular_rank(known_rows, seen.prime)


@pytest.mark.parametrize(("text", "source", "name"), GERMS)
def test_dense_germs_have_the_numbers_of_sparse_ones(text, source, name):
    sparse, germ = Germ(text, source), dense(text, source, name)
    for extended in (True, False):
        known, found = codimension(sparse, name, extended), codimension(germ, name, extended)
        assert found.value == known.value and found.tangent is not None and known.tangent is not None
        assert found.tangent.depth == known.tangent.plain_depth
    assert determinacy(germ, name).degree == determinacy(sparse, name).degree


def test_fewer_orders_settle_the_tangent_space():
    germ = dense("x, x*y + y**4", "x y", "A")
    first = seen_first(germ, group("A"), Version.ORDINARY, 3, 3)
    assert first == Unsettled(3, 3)
    found = seen_first(germ, group("A"), Version.ORDINARY, 4, 3)
    assert not isinstance(found, Unsettled) and found is not None
    assert found.depth == 3 and found.space.order == 6 and found.codimension == 3


@pytest.mark.parametrize("case", [GERMS[0], GERMS[2], GERMS[4], GERMS[5]])
def test_certificates_of_dense_germs(case):
    text, source, name = case
    germ = dense(text, source, name, 6)
    problem = Problem(str(germ)[1:-1], source, name)
    for extended in (False, True):
        found = codimension(germ, name, extended)
        check_codimension(problem, extended, found.value, found.certificate())
        assert found.tangent is not None and found.tangent.annihilator.prime < BELOW


@pytest.mark.parametrize(
    ("text", "name", "value"),
    [(f"x, x*y + {FIRST}*y**3 + y**4", "A", 0), (f"{FIRST}*x**2 + x**3 + y**2", "R", 1)],
)
def test_a_prime_in_a_coefficient_is_no_trap(text, name, value):
    germ, g = dense(text, "x y", name, 8), group(name)
    seen = modular_tangent(germ, g, Version.EXTENDED, ORDER, 4)
    assert seen is not None and seen.prime == FIRST and seen.codimension > value
    assert codimension(germ, name, extended=True).value == value
    assert determinacy(germ, name).degree == determinacy(Germ(text, "x y"), name).degree


@pytest.mark.parametrize(
    ("text", "name"),
    [("(x + y + x**2 + x*y)**2*(1 + x + y + y**2)", "R"), ("(x + y**2 + x*y)**2*(y + x**2), 0", "A")],
)
def test_infinite_dense_germs_stay_infinite(text, name):
    assert codimension(Germ(text, "x y"), name).value == "infinite"
