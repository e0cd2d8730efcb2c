"""Random functions of two variables: each is of one row of the lists, the one with its Milnor number.

Those with Milnor number 14 at most are all simple or unimodal (Arnold; bimodal ones begin at 15), so exactly
one form must be reached, and the others be refused.
"""

from __future__ import annotations

import random

import pytest

from osculant.cas.errors import OsculantError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.local_algebra import milnor_number
from osculant.cas.germs.reference import reference
from osculant.cas.germs.search import Patience
from osculant.cas.recognition.equivalence import NotEquivalent, equivalence
from osculant.cas.recognition.forms import form

SIMPLE, UNIMODAL = reference("simple functions"), reference("unimodal functions")
#: lowest terms, with a small number for the %d
LOWEST = (
    "0",
    "(x + %d*y)**3",
    "(x + %d*y)**2*(y - 3*x)",
    "(x + %d*y)**4",
    "(x + %d*y)**3*(y - x)",
    "(x + %d*y)**2*(x - y)**2",
    "(x + %d*y)**2*(x**2 + y**2)",
    "(x**2 + %d*y**2)**2",
    "(x + %d*y)**2*(y - 3*x)*(x - y)",
)


def rows(milnor):
    """The forms of two variables with that Milnor number."""
    yield form(SIMPLE["A_k"], k=milnor)
    if milnor >= 4:
        yield form(SIMPLE["D_k"], k=milnor)
    if milnor > 10:
        yield form(UNIMODAL["J_10+k"], k=milnor - 10)
    if milnor > 9:
        yield form(UNIMODAL["X_9+k"], k=milnor - 9)
    for r in range(5, milnor):
        if milnor - 1 - r >= r:
            yield form(UNIMODAL["Y_r,s"], r=r, s=milnor - 1 - r)
        if 2 * r + 1 == milnor:
            yield form(UNIMODAL["Y_r"], r=r)
    for entry in (*SIMPLE.entries, *UNIMODAL.entries):
        integers = [p for p in entry.parameters if p.least is not None]
        if len(entry.variables) == 2 and not integers and int(entry.values["milnor"]) == milnor:
            yield form(entry)


def drawn(draw):
    """A function with chosen lowest terms and random higher ones."""
    lowest = draw.choice(LOWEST)
    lowest = lowest % draw.randint(1, 3) if "%" in lowest else lowest
    degree = max((poly.degree_of(m, 2) for m in Germ(f"{lowest} + x", "x y").jet(5)[0]), default=1)
    terms = {
        m: draw.choice((-2, -1, 1, 2, 3))
        for m in poly.monomials(2, 7)
        if poly.degree_of(m, 2) > degree and draw.random() < 0.4
    }
    return Germ(f"{lowest} + {as_node(terms, ('x', 'y'))}", "x y")


def reached(germ):
    """(Milnor number, the forms that are reached); None if the number is large or infinite."""
    try:
        milnor = milnor_number(germ, Patience(2))
    except OsculantError:
        return None
    if not 1 <= milnor <= 14:
        return None
    found = []
    for row in rows(milnor):
        try:
            equivalence(germ, row)
        except NotEquivalent:
            continue
        found.append(str(row))
    return milnor, found


def tried(seeds):
    seen = set()
    for seed in seeds:
        germ = drawn(random.Random(seed))
        if germ.jet(1)[0] or (known := reached(germ)) is None:
            continue
        milnor, found = known
        assert len(found) == 1, (seed, str(germ), milnor, found)
        seen.add(found[0].split(" of ")[0])
    return seen


def test_each_function_is_of_one_row():
    assert len(tried(range(60))) >= 8


@pytest.mark.slow
def test_many_functions_are_of_one_row():
    assert tried(range(60, 1000)) >= {
        "A_k",
        "D_k",
        "E_6",
        "E_7",
        "E_8",
        "X_9+k",
        "Y_r,s",
        "Y_r",
        "Z_11",
        "W_12",
    }
