"""Equivalences under R, R(H) and K: all rows in dense coordinates, by lines; number fields; other rows."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from osculant.cas.errors import UndecidedError
from osculant.cas.germs import groups
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.jets_of_maps import map_jet
from osculant.cas.germs.reference import reference
from osculant.cas.recognition.equivalence import NotEquivalent, equivalence
from osculant.cas.recognition.forms import form, stabilised
from tests.cas.recognition.disguise import along, check_scales, diffeomorphism, members
from tests.random_germs import Change

#: degrees of determinacy up to which lists are tried, in the ordinary tests and in the slow ones
LISTS = {
    "thom": (5, 6),
    "simple functions": (5, 8),
    "unimodal functions": (5, 8),
    "boundary functions": (4, 7),
    "simple icis": (4, 6),
}
SIMPLE, UNIMODAL = reference("simple functions"), reference("unimodal functions")
BOUNDARY = reference("boundary functions")


def matrix(draw, n, p, order):
    """A p × p matrix of dense polynomials, invertible at the origin: lower triangular there."""
    rows = []
    for i in range(p):
        row = []
        for j in range(p):
            entry = {
                m: Fraction(draw.randint(-3, 3), draw.randint(1, 3)) for m in poly.monomials(n, order - 1)
            }
            entry[0] = Fraction(draw.choice((-2, -1, 1, 3))) if i == j else entry[0] if i > j else Fraction(0)
            row.append({m: c for m, c in entry.items() if c})
        rows.append(row)
    return rows


def disguised(germ, found, seed):
    """The germ in random coordinates, with squares ±z² for further variables of the form."""
    draw, k, n = random.Random(seed), found.order, found.n
    more = n - germ.n
    jet = [
        {poly.monomial((*poly.exponents_of(m, germ.n), *(0,) * more)): c for m, c in f.items()}
        for f in germ.jet(k)
    ]
    for i in range(germ.n, n):
        jet[0][2 * poly.variable(i, n)] = draw.choice((-1, 1))
    f = map_jet(jet, n, k).compose(diffeomorphism(draw, n, k, found.boundary)).polynomials()
    if found.group.name == "K":
        rows = []
        for row in matrix(draw, n, germ.p, k):
            total = {}
            for entry, g in zip(row, f):
                total = poly.plus(total, poly.times(entry, g, n, k))
            rows.append(total)
        f = rows
    boundary = None if found.boundary is None else found.variables[found.boundary]
    return Germ([as_node(g, found.variables) for g in f], found.variables, boundary)


def check(found, germ, seed):
    """Asserts that a rational equivalence is one, along two lines."""
    draw, k, n, p = random.Random(seed), found.order, found.form.n, found.form.p
    assert found.finish is None
    for _ in range(2):
        point = [Fraction(draw.randint(-5, 5), draw.randint(1, 4)) for _ in range(n)]
        line = [[Fraction(0), a] + [Fraction(0)] * (k - 1) for a in point]
        image = along(germ.jet(k), along(found.source.polynomials(), line, k), k)
        if found.form.group.target == "contact":
            entries = [{m: c for m, c in f.items() if m} for f in found.target.polynomials()]
            factors = along(entries, line, k)
            for factor, f in zip(factors, found.target.polynomials()):
                factor[0] += Fraction(f.get(0, 0))
            image = [
                [
                    sum(factors[i * p + j][a] * image[j][b - a] for j in range(p) for a in range(b + 1))
                    for b in range(k + 1)
                ]
                for i in range(p)
            ]
            constant = [float(f.get(0, 0)) for f in found.target.polynomials()]
            assert np.linalg.det(np.reshape(constant, (p, p))) != 0
        wanted = [[Fraction(0)] * (k + 1) for _ in range(p)]
        for (m, j), c in found.coefficients.items():
            value = c
            for a, e in zip(point, m):
                value *= a**e
            wanted[j][sum(m)] += value
        assert image == wanted
    assert found.source.linear_part().det() != 0
    if (u := found.form.boundary) is not None:
        of_u = found.source.polynomials()[u]
        assert all(poly.exponents_of(m, n)[u] for m in of_u) and of_u[poly.variable(u, n)] > 0
        assert found.scales.source[u].sign == 1
    if found.printed:
        check_scales(found)
    else:
        assert found.form.entry.id in ("P_8", "Y_r")


def tried(name, seeds, most):
    for found, germ, signs, moduli in members(name, most):
        plain = equivalence(germ, found)
        for seed in range(seeds):
            moved = disguised(germ, found, f"{found} {signs} {moduli} {seed}")
            made = equivalence(moved, found)
            check(made, moved, seed)
            assert (made.signs, made.moduli) == (plain.signs, plain.moduli), str(found)
            assert {k: abs(Fraction(v)) for k, v in made.moduli.items()} == {
                k: abs(v) for k, v in moduli.items()
            }


@pytest.mark.parametrize("name", LISTS)
def test_every_row_in_dense_coordinates(name):
    tried(name, 1, LISTS[name][0])


@pytest.mark.slow
@pytest.mark.parametrize("name", LISTS)
def test_many_coordinates(name):
    tried(name, 4, LISTS[name][1])


@pytest.mark.parametrize("n", [3, 4])
def test_squares_of_further_variables_and_their_signs(n):
    for found, germ, _, _ in members("simple functions", 5 if n == 3 else 4):
        more = stabilised(found, n)
        moved = disguised(germ, more, f"{found} {n}")
        made = equivalence(moved, more)
        check(made, moved, n)
        # the inertia of the Hessian is an invariant: that of the signs of the squares
        squares = [made.signs[t.sign] for t in more.terms if sum(t.monomial) == 2]
        (f,) = moved.jet(2)
        whole = np.zeros((n, n))
        for m, c in f.items():
            i, j = [i for i, e in enumerate(poly.exponents_of(m, n)) for _ in range(e)]
            whole[i, j] += float(c)
            whole[j, i] += float(c)
        values = np.linalg.eigvalsh(whole)
        size = max(abs(values)) * 1e-12
        assert (sum(values > size), sum(values < -size)) == (squares.count(1), squares.count(-1))
        assert squares == sorted(squares, reverse=True) or found.entry.id == "A_k"


def strangers(names, n, most):
    known = [row for name in names for row in members(name, most) if row[0].n == n]
    forms = list(dict.fromkeys(row[0] for row in known))
    for own, germ, _, _ in known:
        for other in forms:
            if other != own:
                yield own, germ, other


@pytest.mark.parametrize(
    ("names", "n", "most"),
    [
        (("simple functions", "unimodal functions"), 2, 5),
        (("unimodal functions",), 3, 4),
        (("boundary functions",), 2, 5),
        (("boundary functions",), 3, 5),
        (("simple icis",), 2, 5),
        (("simple icis",), 3, 5),
    ],
)
def test_other_rows_are_refused(names, n, most):
    for own, germ, other in strangers(names, n, most):
        with pytest.raises(NotEquivalent):
            found = equivalence(germ, other)
            pytest.fail(f"{own} is {other} with signs {found.signs}")


@pytest.mark.parametrize(
    ("name", "group"), [("simple functions", "K"), ("boundary functions", "K(H)"), ("thom", "K")]
)
def test_functions_up_to_units(name, group):
    for found, germ, signs, _ in members(name, 4):
        up_to = replace(found, group=groups.group(group))
        plain = equivalence(germ, up_to)
        moved = Change(f"{found} {signs}", found.order).applied(germ, group)
        made = equivalence(moved, up_to)
        check(made, moved, 2)
        assert made.signs == plain.signs
    with pytest.raises(UndecidedError, match="for K are built"):
        equivalence(Germ("x**3 + y**7", "x y"), replace(form(UNIMODAL["E_12^0"]), group=groups.group("K")))


def test_beyond_the_determinacy_degree():
    for text, source, row, integers in (
        ("x**3 + 2*x*y**3 + y**5 + x**2*y**2", "x y", "E_7", {}),
        ("(x**2 + 2*y**2)**2 + x**5 + x**4*y + y**6", "x y", "Y_r", {"r": 5}),
        ("x**3 + 2*y**4 + y*z**2 + x*y**3 + z**4 + x*y*z**3", "x y z", "Q_10", {}),
    ):
        found = form((SIMPLE if row == "E_7" else UNIMODAL)[row], **integers)
        germ = Germ(text, source)
        made = equivalence(germ, found, found.order + 2)
        check(made, germ, 1)
        assert {k: float(v) for k, v in made.moduli.items()} == pytest.approx(
            {k: float(v) for k, v in equivalence(germ, found).moduli.items()}
        )


def test_what_is_refused():
    cusp = form(SIMPLE["A_k"], k=2)
    with pytest.raises(NotEquivalent, match="no critical point"):
        equivalence(Germ("x + y**2", "x y"), cusp)
    with pytest.raises(NotEquivalent, match="corank 2, not 1"):
        equivalence(Germ("x**3 + y**3", "x y"), cusp)
    with pytest.raises(NotEquivalent) as refused:
        equivalence(Germ("2*x**4 + y**2", "x y"), form(SIMPLE["A_k"], k=4))
    assert (refused.value.column, refused.value.value) == (((4, 0), 0), 2)
    with pytest.raises(NotEquivalent, match="another kind"):
        equivalence(Germ("x**3 + y**3", "x y"), form(SIMPLE["E_6"]))
    with pytest.raises(UndecidedError, match="not rational"):
        equivalence(Germ("(x**2 - 2*y**2)**2 + x**5", "x y"), form(UNIMODAL["Y_r,s"], r=5, s=5))
    with pytest.raises(NotEquivalent):
        equivalence(Germ("(x**2 + 2*y**2)**2 + x**5", "x y"), form(UNIMODAL["Y_r,s"], r=5, s=5))
    with pytest.raises(NotEquivalent, match="critical point"):
        equivalence(Germ("x**2 + y**2", "x y", "x"), form(BOUNDARY["A_k"], k=1))
