"""Equivalences under R, R(H) and K: all rows in dense coordinates, by lines; number fields; other rows."""

from __future__ import annotations

import random
from fractions import Fraction

import numpy as np
import pytest

from osculant.cas.errors import UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.jets_of_maps import map_jet
from osculant.cas.germs.reference import reference
from osculant.cas.recognition.equivalence import NotEquivalent, equivalence
from osculant.cas.recognition.forms import form, stabilised
from tests.cas.recognition.disguise import along, check_scales, diffeomorphism, members

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
        if found.form.group.name == "K":
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
            constant = [f.get(0, 0) for f in found.target.polynomials()]
            assert constant[0] * constant[3] != constant[1] * constant[2]
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


def real_lines(coefficients):
    """How many real lines a binary form without multiple lines has."""
    roots = np.roots([float(c) for c in coefficients])
    return int(sum(abs(roots.imag) < 1e-9)) + int(not coefficients[0])


def test_cubics_by_their_real_lines_over_number_fields():
    draw, degrees = random.Random(4), set()
    for _ in range(30):
        c = [draw.randint(-4, 4) for _ in range(4)]
        a, b, d, e = c
        if not b * b * d * d - 4 * a * d**3 - 4 * b**3 * e - 27 * a * a * e * e + 18 * a * b * d * e:
            continue
        text = f"({a})*x**3 + ({b})*x**2*y + ({d})*x*y**2 + ({e})*y**3 + x**4 - 2*y**5"
        made = equivalence(Germ(text, "x y"), form(SIMPLE["D_k"], k=4))
        assert made.signs == ((-1,) if real_lines(c) == 3 else (1,))
        degrees.add(1 if made.finish is None else made.finish.field.degree)
    assert degrees == {1, 3}


def test_parabolic_functions_have_the_invariants_of_their_modulus():
    draw = random.Random(5)
    for _ in range(12):
        c = [draw.choice((-3, -2, -1, 1, 2, 3)) for _ in range(5)]
        a, b, d, e, f = c
        invariant_i = a * f - Fraction(b * e, 4) + Fraction(d * d, 12)
        invariant_j = (
            Fraction(a * d * f, 6)
            + Fraction(b * d * e, 48)
            - Fraction(d**3, 216)
            - Fraction(a * e * e, 16)
            - Fraction(b * b * f, 16)
        )
        if invariant_i**3 == 27 * invariant_j**2:
            continue
        text = " + ".join(f"({v})*x**{4 - i}*y**{i}" for i, v in enumerate(c)) + " + x**3*y**2"
        made = equivalence(Germ(text, "x y"), form(UNIMODAL["X_9"]))
        s, t = made.signs
        m = float(made.moduli["a"])
        its_i, its_j = s * t + m * m / 12, s * t * m / 6 - m**3 / 216
        assert its_i**3 * float(invariant_j) ** 2 == pytest.approx(
            its_j**2 * float(invariant_i) ** 3, rel=1e-9
        )
        assert its_j * invariant_j >= 0
        lines = real_lines(c)
        assert (s, t) == ((1, -1) if lines == 2 else (1, 1) if lines == 4 or a > 0 else (-1, -1))
        assert lines == 2 or (m < -2 if lines == 4 else abs(m) < 2)


def test_tangent_parabolas_by_the_roots_of_their_cubic():
    draw = random.Random(6)
    for _ in range(12):
        a, b, c, d = (draw.choice((-3, -2, -1, 1, 2, 3)) for _ in range(4))
        roots = np.roots([a, b, c, d])
        real = sorted(r.real for r in roots if abs(r.imag) < 1e-9)
        if len(real) == 2:
            continue
        r = real[len(real) // 2]
        slope = c + 2 * b * r + 3 * a * r * r  # x³ + a'x²y² ± xy⁴ over the root in the middle
        wanted = (b + 3 * a * r) / np.cbrt(a) ** 2 / np.sqrt(abs(slope / np.cbrt(a)))
        made = equivalence(
            Germ(f"({a})*x**3 + ({b})*x**2*y**2 + ({c})*x*y**4 + ({d})*y**6", "x y"), form(UNIMODAL["J_10"])
        )
        assert made.signs == (1 if slope * a > 0 else -1,)
        assert float(made.moduli["a"]) == pytest.approx(wanted, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(("p", "q"), [(1, 1), (-3, 1), (-2, 1), (0, 2), (0, -2), (5, 0), (-5, 0)])
def test_cubic_curves_by_their_j_invariant(p, q):
    text = f"x**3 + ({p})*x*z**2 + ({q})*z**3 - y**2*z + x**2*y**2"
    made = equivalence(Germ(text, "x y z"), form(UNIMODAL["P_8"]))
    assert not made.printed and made.coefficients[(3, 0, 0), 0] == 1
    k = -float(made.moduli["a"]) / 3  # x³ + y³ + z³ = 3k·xyz
    j = 27 * k**3 * (k**3 + 8) ** 3 / (k**3 - 1) ** 3
    assert j == pytest.approx(1728 * 4 * p**3 / (4 * p**3 + 27 * q**2), rel=1e-9, abs=1e-9)
    # it has two branches over the reals if and only if k > 1
    assert (k > 1) == (4 * p**3 + 27 * q**2 < 0)


def test_three_planes_or_one():
    one = equivalence(Germ("x**3 - 2*y**3 + z**4 + x*y*z**2", "x y z"), form(UNIMODAL["U_12"]))
    assert one.finish is None
    two = equivalence(Germ("x**3 - 2*x*y**2 + 5*y**3 + z**4 + y**2*z**2", "x y z"), form(UNIMODAL["U_12"]))
    assert two.finish is not None and two.finish.field.degree == 2
    with pytest.raises(NotEquivalent, match="three real lines"):
        equivalence(Germ("x**3 - 3*x*y**2 + z**4 + x*y*z**2", "x y z"), form(UNIMODAL["U_12"]))


def test_functions_at_the_boundary_over_number_fields():
    for text, sign in (("x + y**3 - 3*y*z**2 + z**3 + x*y", -1), ("-x + y**3 + y*z**2 + z**3", 1)):
        made = equivalence(Germ(text, "x y z", "x"), form(BOUNDARY["D_k"], k=4))
        assert made.signs == (1 if text[0] == "x" else -1, sign)
        assert made.finish is not None and made.finish.images[0] == {poly.variable(0, 3): 1}


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
