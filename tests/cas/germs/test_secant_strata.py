"""Secant germs of surfaces X = (x, Φ∘π) over every row π of table 6.1, Φ a random diffeomorphism."""

from __future__ import annotations

from random import Random

import pytest

from osculant.cas.formulas.expression import ZERO, number, variable
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.immersions import Immersion
from osculant.cas.germs.reference import reference
from osculant.cas.germs.secants import Secant, secant
from osculant.cas.germs.unfolding import is_stable

ROWS = [
    (entry, signs, parameters)
    for entry in reference("table 6.1").entries
    for signs, parameters in entry.tried()
]
#: the degree of Φ, its coefficients, the seeds for each row, and how many of them at least are generic
DEGREE, COEFFICIENTS, SEEDS, GENERIC = 3, [c for c in range(-9, 10) if c], range(4), 3


def diffeomorphism(chance: Random, n: int) -> list[poly.Polynomial]:
    """All terms from degree 2 to `DEGREE`, and a unipotent triangular derivative."""
    found = []
    for i in range(n):
        terms = [m for m in poly.monomials(n, DEGREE) if m]
        f: poly.Polynomial = {m: chance.choice(COEFFICIENTS) for m in terms}
        for j in range(n):
            f[poly.variable(j, n)] = int(i == j) if j >= i else chance.choice(COEFFICIENTS)
        found.append({m: c for m, c in f.items() if c})
    return found


def surface(projection: Germ, order: int, seed: str) -> Immersion:
    """The jet of (x, Φ∘π) of that order: of the secant germ, half that order is known."""
    chance = Random(seed)
    jet = projection.jet(order)
    components: list[poly.Polynomial] = []
    for f in diffeomorphism(chance, projection.p):
        total: poly.Polynomial = {}
        for m, c in f.items():
            term: poly.Polynomial = {0: c}
            for g, e in zip(jet, poly.exponents_of(m, projection.p)):
                for _ in range(e):
                    term = poly.times(term, g, 2, order)
            total = poly.plus(total, term)
        components.append(total)
    nodes = [as_node(f, ("x", "y")) for f in components]
    return Immersion([variable("x"), *nodes], ("x", "y"), [ZERO] * 2, [number(1), ZERO])


def made(row, seed: int) -> Secant:
    entry, signs, parameters = row
    order = entry.value("determinacy", **parameters)
    projection = entry.projected(signs, **parameters)
    return secant(surface(projection, 2 * order + 1, f"{entry.id} {signs} {seed}"), order)


def in_class(row, seed: int) -> bool:
    """Whether the secant germ is stable; then it is of the class of the row, as its numbers tell.

    It is not stable where the surface is not generic: where some coefficients of Φ satisfy an equation.
    """
    entry, _, parameters = row
    found = made(row, seed)
    if not found.settled or not is_stable(found.germ, "A(H)"):
        return False
    assert codimension(found.germ, "A(H)").value == entry.value("cod", **parameters)
    assert determinacy(found.germ, "A(H)").degree == entry.value("determinacy", **parameters)
    return True


@pytest.mark.slow
@pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row[0].called(row[1], **row[2])}")
def test_secant_germs_over_a_row_have_its_class(row):
    assert sum(in_class(row, seed) for seed in SEEDS) >= GENERIC


@pytest.mark.parametrize(
    "row", [r for r in ROWS if r[0].id in {"3-5", "4-2", "6-2"}], ids=lambda row: row[0].id
)
def test_secant_germs_over_some_rows_have_their_class(row):
    assert in_class(row, 0)
