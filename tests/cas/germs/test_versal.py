"""Unfoldings: their velocities, stability through the germ that is unfolded, germs at other points."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import pytest

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import variable
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.moved import moved
from osculant.cas.germs.unfolding import is_stable, stable_unfolding, unfolded_germ, unfolding
from osculant.cas.germs.versal import Family, versality

GROUPS = ["A", "A(H)"]
MAPS = [
    ("x, y**2, x*y", "x y"),
    ("x, y**2, x**2*y + y**3", "x y"),
    ("x, y**2, 0", "x y"),
    ("x, x*y + y**3", "x y"),
    ("x, x*y + y**4", "x y"),
    ("a, b, x**4 + a*x + b*x**2", "a b x"),
    ("a, b, x**4 + a*x + a*b*x**2", "a b x"),
    ("x, x, y", "x y"),
    ("x, y", "x y"),
    ("x, y, x*y", "x y"),
    ("x, x**2 + y**2 - u**2", "x y u"),
    ("x, x*u + u**2 + y**2", "x y u"),
    ("x, y, u**2 + x*u + y**2*u", "x y u"),
    ("x, u**2 + x*u", "x u"),
    ("u, x**2 + u*x", "x u"),
    ("x, u", "x u"),
]


@pytest.mark.parametrize("name", GROUPS)
@pytest.mark.parametrize("formula, source", MAPS)
def test_stability_does_not_depend_on_components_that_are_variables(formula, source, name):
    """Target coordinates are mixed, so that no component is a variable: the other way to decide."""
    germ = Germ(formula, source, "u" if "u" in source else source[-1])
    mixed = [f + 2 * g for f, g in zip(germ.components, germ.components[1:])] + [germ.components[-1] * 3]
    other = Germ([f + g**2 for f, g in zip(mixed, mixed[::-1])], germ.source, germ.boundary)
    assert unfolded_germ(other) is None
    assert is_stable(germ, name) == is_stable(other, name)


def test_velocities_are_the_derivatives_at_zero():
    family = Family(Germ("b, x*exp(a) + b*y, a, a*b + x*y", "x a y b"), ["a", "b"])
    assert (family.germ.source, str(family.germ)) == (("x", "y"), "(x*exp(0), x*y)")
    x, y = poly.monomial((1, 0)), poly.monomial((0, 1))
    assert family.velocities(3) == [({x: 1}, {}), ({y: 1}, {})]


@pytest.mark.parametrize("seed", range(6))
def test_random_families_are_versal_exactly_if_they_are_stable_maps(seed):
    """For K and functions: (t, F) is stable exactly if F is versal, up to the constant."""
    random = Random(seed)
    terms = " + ".join(
        f"{name}*({random.choice(['x', 'y', 'x*y', 'x^2', 'y^2', '1', 'x + y'])})" for name in "abcd"
    )
    whole = Germ(f"a, b, c, d, x^3 + y^3 + {terms} + a^2*x*y", "a b c d x y")
    found = versality(Family(whole, "abcd"), "K")
    assert found.codimension == 4
    assert is_stable(whole, "A") == all(not monomial for monomial, _ in found.missing)


def test_a_missing_term_completes_an_unfolding():
    for formula, name in (("x**2*y + y**5", "R"), ("x, y**2, y**3 + x**4*y", "A"), ("x**2, y**3", "K")):
        germ = Germ(formula, "x y")
        whole = unfolding(germ, name).germ
        size = len(whole.source) - 2
        found = versality(Family(whole, whole.source[:size]), name)
        assert (found.versal, found.codimension, found.reached) == (True, size, size)
        # the terms of the stable unfolding and the constants are versal for K, none is missing but they
        stable = stable_unfolding(germ, "A").germ
        parameters = stable.source[: len(stable.source) - 2]
        if parameters:
            missing = versality(Family(stable, parameters), "K").missing
            assert all(monomial == 0 for monomial, _ in missing)


def test_germs_at_other_points():
    """The Whitney umbrella has cross-caps at 0, and a family of cusps lies on a curve."""
    cusps = parse_tuple("x, y**4 + x*y**2 + z*y, z", ("x", "y", "z"))
    # the third derivative 24y, the second 12y² + 2x and the first 4y³ + 2xy + z
    kinds = {}
    for y in (Fraction(0), Fraction(1), Fraction(1, 2)):
        x = -6 * y**2
        z = -4 * y**3 - 2 * x * y
        germ = moved(cusps, "xyz", (x, y, z))
        kinds[y] = codimension(germ, "A").value, codimension(moved(cusps, "xyz", (x + 1, y, z)), "A").value
    assert kinds[Fraction(0)] == (3, 1)  # swallowtail, fold
    assert kinds[Fraction(1)] == kinds[Fraction(1, 2)] == (2, 0)  # cusps, and no singular point


def test_moving_there_and_back_is_nothing():
    random = Random(5)
    source = ("x", "y")
    for _ in range(10):
        chosen = random.sample(poly.monomials(2, 5)[1:], 6)
        f = {m: Fraction(random.randint(-4, 4) or 1, random.randint(1, 3)) for m in chosen}
        germ = Germ([as_node(f, source), variable("x")], source)
        point = [Fraction(random.randint(-3, 3), random.randint(1, 4)) for _ in source]
        there = moved(germ.components, source, point)
        back = moved(there.components, source, [-a for a in point])
        assert back.polynomial(9) == germ.polynomial(9)
        # values: f(a + x) − f(a)
        at = [Fraction(1, 3), Fraction(-2)]
        assert _value(there.jet(9)[0], at) == _value(f, [a + b for a, b in zip(at, point)]) - _value(f, point)


def _value(f, at):
    return sum(
        (c * at[0] ** e[0] * at[1] ** e[1] for c, e in ((c, poly.exponents_of(m, 2)) for m, c in f.items())),
        Fraction(0),
    )


def test_an_analytic_germ_is_moved_where_its_values_are_rational():
    log = parse_tuple("log(x)*y", ("x", "y"))
    assert moved(log, "xy", (1, 0)).jet(2) == ({poly.monomial((1, 1)): 1},)
    with pytest.raises(DomainError, match="irrational"):
        moved(log, "xy", (2, 0))
    with pytest.raises(DomainError, match="not analytic"):
        moved(log, "xy", (0, 0))
