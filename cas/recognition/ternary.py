"""Lines and points of binary forms and ternary cubics over ℚ: the coordinates in which they are normal.

Each function takes a form as a polynomial and gives linear forms (rows of numbers) that are the new
coordinates; it gives None where the form is of another kind, and raises UndecidedError where lines that are
needed are not rational.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import permutations
from typing import Any

from osculant.cas.errors import UndecidedError
from osculant.cas.germs import linear
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.jets_of_maps import map_jet
from osculant.cas.germs.model import polynomial, ring
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition.real_fields import real_roots
from osculant.cas.recognition.splitting import diagonal_basis, hessian

Row = list[Fraction]


def linear_factors(form: Polynomial, n: int) -> tuple[list[tuple[Row, int]], list[tuple[Polynomial, int]]]:
    """The rational linear factors of a form with their multiplicities, and the other irreducible factors.

    >>> x, y = poly.variable(0, 2), poly.variable(1, 2)
    >>> linear_factors({2 * x + y: 2, 3 * x: 2}, 2)[0]  # 2x²(x + y)
    [([Fraction(1, 1), Fraction(0, 1)], 2), ([Fraction(1, 1), Fraction(1, 1)], 1)]
    """
    context = ring([f"x{i + 1}" for i in range(n)])
    found: list[tuple[Row, int]] = []
    others: list[tuple[Polynomial, int]] = []
    for factor, multiplicity in polynomial(form, context, n).factor()[1]:
        terms: Polynomial = {
            poly.monomial(tuple(map(int, m))): Fraction(int(c.p), int(c.q))
            for m, c in factor.to_dict().items()
        }
        if factor.total_degree() == 1:
            found.append((row(terms, n), int(multiplicity)))
        else:
            others.append((terms, int(multiplicity)))
    return sorted(found), others


def row(form: Polynomial, n: int) -> Row:
    """The coefficients of a linear form."""
    return [Fraction(form.get(poly.variable(i, n), 0)) for i in range(n)]


def in_coordinates(form: Polynomial, rows: Sequence[Sequence[Fraction]], degree: int) -> Polynomial:
    """A form in the coordinates that are given by these linear forms."""
    n = len(rows)
    images = [{poly.variable(j, n): c for j, c in enumerate(r) if c} for r in linear.inverse(list(rows))]
    return map_jet([form], n, degree).compose(map_jet(images, n, degree)).polynomials()[0]


def completed(rows: Sequence[Row], n: int) -> list[Row]:
    """Linear forms and further ones, units, so that they are coordinates together."""
    leading = linear.echelon(list(rows), n)[1]
    units = [[Fraction(int(i == j)) for j in range(n)] for i in range(n) if i not in leading]
    return [*rows, *units]


def with_multiplicities(form: Polynomial, n: int, wanted: Sequence[int]) -> Iterator[list[Row]]:
    """The factors of a product of linear forms with these multiplicities, in every order that fits.

    Raises UndecidedError if it may be such a product of real lines that are not rational.
    """
    lines, others = linear_factors(form, n)
    if others:
        found = [m for _, m in lines]
        found += [m for f, m in others for _ in range(max(poly.degree_of(e, n) for e in f))]
        if sorted(found) == sorted(wanted) and all(_real_lines(f, n) for f, _ in others):
            raise UndecidedError("The lines of the lowest jet are not rational.")
        return
    for chosen in permutations(lines):
        if [m for _, m in chosen] == list(wanted):
            yield [line for line, _ in chosen]


def _real_lines(form: Polynomial, n: int) -> bool:
    """Whether an irreducible form may be a product of real lines."""
    degree = max(poly.degree_of(m, n) for m in form)
    if n == 2:
        slope = [Fraction(form.get(poly.monomial((i, degree - i)), 0)) for i in range(degree + 1)]
        return len(list(real_roots(slope))) == degree
    if degree == 2:
        corank, basis = diagonal_basis(hessian(form, n))
        images = [{poly.variable(j, n): c for j, c in enumerate(row) if c} for row in basis]
        values = map_jet([form], n, 2).compose(map_jet(images, n, 2)).polynomials()[0].values()
        return corank == n - 2 and len({v > 0 for v in values}) == 2
    determinant = hessian_determinant(form)  # of a product of three lines a multiple of it
    terms = sorted({*form, *determinant})
    return linear.rank([[Fraction(f.get(m, 0)) for m in terms] for f in (form, determinant)], len(terms)) < 2


def cuspidal(form: Polynomial) -> list[Row] | None:
    """(x, y, z) with form = a·x³ + b·y·z²: by the Hessian of a cuspidal cubic, which is −24abx·z²."""
    lines, others = linear_factors(hessian_determinant(form), 3)
    double = [line for line, m in lines if m == 2]
    single = [line for line, m in lines if m == 1]
    if others or not double or not single:
        return None
    rest = in_coordinates(form, completed([single[0], double[0]], 3), 3)  # a·x³ + z²·(linear)
    square = 2 * poly.variable(1, 3)
    along = {m - square: c for m, c in rest.items() if poly.exponents_of(m, 3)[1] >= 2}
    if {m for m in rest if m - square not in along} - {3 * poly.variable(0, 3)}:
        return None
    third = linear.product([row(along, 3)], completed([single[0], double[0]], 3))[0]
    return [single[0], third, double[0]]


def tangent_conic(form: Polynomial) -> list[Row] | None:
    """(x, y, z) with form = a·z·(y² + b·x·z): a conic and its tangent z = 0."""
    found = _line_and_conic(form)
    if found is None:
        return None
    line, conic = found
    rows = completed([line], 3)
    lines, others = linear_factors(_without(in_coordinates(conic, rows, 2), 0), 3)
    if others or [m for _, m in lines] != [2]:
        return None
    tangent = linear.product([lines[0][0]], rows)[0]
    rows = completed([tangent, line], 3)
    rest = in_coordinates(conic, rows, 2)
    unit = poly.variable(1, 3)
    along = {m - unit: c for m, c in rest.items() if poly.exponents_of(m, 3)[1]}
    other = linear.product([row(along, 3)], rows)[0]
    return [other, tangent, line]


def chord_conic(form: Polynomial) -> Iterator[list[Row]]:
    """(x, y, z) with form = x·(a·x² + b·y·z), in both orders of y and z.

    Raises UndecidedError if the points where the line x = 0 meets the conic are not rational.
    """
    found = _line_and_conic(form)
    if found is None:
        return
    line, conic = found
    rows = completed([line], 3)
    lines, others = linear_factors(_without(in_coordinates(conic, rows, 2), 0), 3)
    if others and _real_lines(others[0][0], 3):
        raise UndecidedError("The points of a line and a conic of the lowest jet are not rational.")
    if [m for _, m in lines] != [1, 1]:
        return
    pair = [linear.product([f], rows)[0] for f, _ in lines]
    rest = in_coordinates(conic, [line, *pair], 2)
    x, y, z = (poly.variable(i, 3) for i in range(3))
    mixed = Fraction(rest[y + z])
    for i, j in ((0, 1), (1, 0)):
        first, second = pair[i], pair[j]
        a, b = (Fraction(rest.get(x + (y, z)[s], 0)) / mixed for s in (j, i))
        yield [
            line,
            [s + a * t for s, t in zip(first, line)],
            [s + b * t for s, t in zip(second, line)],
        ]


def nodal(form: Polynomial) -> list[Row] | None:
    """(x, y, z) with form = a·x³ + b·y³ + c·x·y·z.

    Raises UndecidedError if the tangents at the node are not rational.
    """
    point = _singular_point(form)
    if point is None:
        return None
    basis = linear.null_space([point], 3)  # two linear forms that vanish at the node
    place = next(i for i, v in enumerate(point) if v)
    rows: list[Row] = [*basis, [Fraction(int(i == place)) for i in range(3)]]
    inside = in_coordinates(form, rows, 3)
    z = poly.variable(2, 3)
    cone = {m - z: c for m, c in inside.items() if poly.exponents_of(m, 3)[2] == 1}
    if any(poly.exponents_of(m, 3)[2] > 1 for m in inside):
        return None
    lines, others = linear_factors(cone, 3)
    if others and _real_lines(others[0][0], 3):
        raise UndecidedError("The tangents at the node of the lowest jet are not rational.")
    if [m for _, m in lines] != [1, 1]:
        return None
    first, second = (linear.product([f], rows)[0] for f, _ in lines)
    rows = [first, second, rows[2]]
    inside = in_coordinates(form, rows, 3)
    x, y = poly.variable(0, 3), poly.variable(1, 3)
    c = Fraction(inside[x + y + z])
    a, b = Fraction(inside.get(2 * x + y, 0)) / c, Fraction(inside.get(x + 2 * y, 0)) / c
    return [first, second, [w + a * s + b * t for w, s, t in zip(rows[2], first, second)]]


def concurrent(form: Polynomial) -> list[Row] | None:
    """(x, y, z) such that the form depends on x and y only."""
    slopes = [poly.derivative(form, i, 3) for i in range(3)]
    terms = sorted({m for f in slopes for m in f})
    kernel = linear.null_space([[Fraction(f.get(m, 0)) for f in slopes] for m in terms], 3)
    if len(kernel) != 1:
        return None
    return completed(linear.null_space(kernel, 3), 3)


def _line_and_conic(form: Polynomial) -> tuple[Row, Polynomial] | None:
    lines, others = linear_factors(form, 3)
    if len(lines) != 1 or len(others) != 1 or lines[0][1] != 1:
        return None
    line = lines[0][0]
    rest = in_coordinates(form, completed([line], 3), 3)
    unit = poly.variable(0, 3)
    divided = {m - unit: c for m, c in rest.items()}
    back = linear.inverse(completed([line], 3))
    return line, in_coordinates(divided, back, 2)


def _without(form: Polynomial, i: int) -> Polynomial:
    """The form where variable i is 0."""
    return {m: c for m, c in form.items() if not poly.exponents_of(m, 3)[i]}


def hessian_determinant(form: Polynomial) -> Polynomial:
    """The determinant of the second derivatives of a ternary cubic."""
    rows = [[poly.derivative(poly.derivative(form, i, 3), j, 3) for j in range(3)] for i in range(3)]
    total: Polynomial = {}
    for i, j, k in permutations(range(3)):
        sign = 1 if (i, j, k) in ((0, 1, 2), (1, 2, 0), (2, 0, 1)) else -1
        product = poly.times(poly.times(rows[0][i], rows[1][j], 3, 3), rows[2][k], 3, 3)
        total = poly.plus(total, product, sign)
    return total


def _singular_point(form: Polynomial) -> Row | None:
    """The node of a cubic with no other singular point: what the partial derivatives span in degree 4."""
    columns = [m for m in poly.monomials(3, 4) if poly.degree_of(m, 3) == 4]
    factors = [m for m in poly.monomials(3, 2) if poly.degree_of(m, 3) == 2]
    spanned: list[list[Any]] = []
    for i in range(3):
        slope = poly.derivative(form, i, 3)
        for f in factors:
            moved = {m + f: c for m, c in slope.items()}
            spanned.append([Fraction(moved.get(m, 0)) for m in columns])
    found = linear.null_space(spanned, len(columns))
    if len(found) != 1:
        return None
    values = dict(zip(columns, found[0]))
    for m in (m for m in poly.monomials(3, 3) if poly.degree_of(m, 3) == 3):
        point = [Fraction(values[m + poly.variable(i, 3)]) for i in range(3)]
        if any(point):
            return point
    return None
