"""Pencils of ternary quadratic forms, and the coordinates in which they are those of Giusti's space curves.

The degenerate members are the roots of the determinant; their multiplicities and ranks tell S, T, U, W and Z
apart (Segre's symbols), and the lines of these members are the coordinates.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

from osculant.cas.errors import UndecidedError
from osculant.cas.germs import linear
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition.levels import UNIT
from osculant.cas.recognition.pair_stages import Stage, squares, stage_of
from osculant.cas.recognition.splitting import hessian
from osculant.cas.recognition.ternary import (
    Row,
    completed,
    in_coordinates,
    linear_factors,
    row,
    with_multiplicities,
)


def _members(pencil: Sequence[Polynomial]) -> tuple[list[tuple[Polynomial, int]], bool]:
    """The rational degenerate members with the multiplicities of their roots; whether all are degenerate."""
    a, b = (hessian(q, 3) for q in pencil)
    s, t = poly.variable(0, 2), poly.variable(1, 2)
    entries = [[{s: x, t: y} for x, y in zip(*rows)] for rows in zip(a, b)]
    entries = [[{m: c for m, c in e.items() if c} for e in rows] for rows in entries]
    determinant: Polynomial = {}
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        minor = poly.plus(
            poly.times(entries[1][j], entries[2][k], 2, 2), poly.times(entries[1][k], entries[2][j], 2, 2), -1
        )
        determinant = poly.plus(determinant, poly.times(entries[0][i], minor, 2, 3))
    if not determinant:
        return [], True
    roots, _ = linear_factors(determinant, 2)
    found = []
    for (p, q), multiplicity in roots:  # p·s + q·t = 0 at (q, −p)
        member = poly.plus({m: q * c for m, c in pencil[0].items() if q}, pencil[1], -p) if p else pencil[0]
        found.append((member, multiplicity))
    return found, False


def general(pencil: Sequence[Polynomial]) -> Iterator[Stage]:
    """(a·x² + b·y² + c·z², yz): any degenerate member with rational lines."""
    members, degenerate = _members(pencil)
    if degenerate or any(m > 1 for _, m in members):
        return
    known = False
    for member, _ in members:
        factors, _ = linear_factors(member, 3)
        if [m for _, m in factors] != [1, 1]:
            continue
        pair = [line for line, _ in factors]
        for lines in _polar(pencil, pair):
            known = True
            yield from stage_of(pencil, lines, [(2, 0, 0), (0, 1, 1)], (0, 0, 0), (2 * UNIT, 2 * UNIT))
    if not known:
        raise UndecidedError(
            "The degenerate members of the pencil of quadratic parts have no rational lines."
        )


def _polar(pencil: Sequence[Polynomial], pair: Sequence[Row]) -> Iterator[list[Row]]:
    """x such that a member of the pencil has no terms xy and xz, for the lines y and z of another."""
    rows = completed(pair, 3)
    rows = [rows[2], rows[0], rows[1]]
    for q in pencil:
        inside = in_coordinates(q, rows, 2)
        if square := Fraction(inside.get(poly.monomial((2, 0, 0)), 0)):
            half = [Fraction(inside.get(poly.monomial(m), 0)) / (2 * square) for m in ((1, 1, 0), (1, 0, 1))]
            x = [a + half[0] * b + half[1] * c for a, b, c in zip(*rows)]
            yield [x, rows[1], rows[2]]
            return


def _double(pencil: Sequence[Polynomial]) -> Iterator[Stage]:
    """(x² ± y², yz): the double member has rank 2, the simple one is yz, z the line off its vertex."""
    members, _ = _members(pencil)
    double = [q for q, m in members if m == 2]
    single = [q for q, m in members if m == 1]
    if not double or not single or linear.rank(hessian(double[0], 3), 3) != 2:
        return
    (vertex,) = linear.null_space(hessian(double[0], 3), 3)
    for pair in with_multiplicities(single[0], 3, (1, 1)):
        if not _value(pair[0], vertex) and _value(pair[1], vertex):
            for lines in _polar([double[0]], pair):
                yield from stage_of(pencil, lines, [(2, 0, 0), (0, 1, 1)], (0, 0, 0), (2 * UNIT, 2 * UNIT))


def _square_and_pair(pencil: Sequence[Polynomial]) -> Iterator[Stage]:
    """(x², yz): the double member has rank 1."""
    members, _ = _members(pencil)
    double = [q for q, m in members if m == 2 and linear.rank(hessian(q, 3), 3) == 1]
    single = [q for q, m in members if m == 1]
    if not double or not single:
        return
    (line,) = next(with_multiplicities(double[0], 3, (2,)))
    for pair in with_multiplicities(single[0], 3, (1, 1)):
        yield from stage_of(pencil, [line, *pair], [(2, 0, 0), (0, 1, 1)], (0, 0, 0), (2 * UNIT, 2 * UNIT))


def _triple_pair(pencil: Sequence[Polynomial]) -> Iterator[Stage]:
    """(x² + yz, xy): the only degenerate member has rank 2; on its plane y = 0 the others are squares."""
    members, _ = _members(pencil)
    if [m for _, m in members] != [3] or linear.rank(hessian(members[0][0], 3), 3) != 2:
        return
    other = next(q for q in pencil if linear.rank([_values(q), _values(members[0][0])], 6) == 2)
    for pair in with_multiplicities(members[0][0], 3, (1, 1)):
        rows = completed(pair, 3)
        inside = in_coordinates(other, rows, 2)
        square = Fraction(inside.get(poly.monomial((2, 0, 0)), 0))
        rest = {m: c for m, c in inside.items() if m != poly.monomial((2, 0, 0))}
        unit = poly.variable(1, 3)
        mixed = poly.monomial((1, 1, 0))
        rest.pop(mixed, None)
        if square and all(poly.exponents_of(m, 3)[1] for m in rest):
            third = linear.product([row({m - unit: c for m, c in rest.items()}, 3)], rows)[0]
            lines = [rows[0], rows[1], third]
            yield from stage_of(
                pencil, lines, [(2, 0, 0), (1, 1, 0)], (1, 2, 0), (2 * UNIT + 2, 2 * UNIT + 3)
            )


def _triple_square(pencil: Sequence[Polynomial]) -> Iterator[Stage]:
    """(x², y² + xz): the only degenerate member has rank 1; on its line the others are squares."""
    members, _ = _members(pencil)
    if [m for _, m in members] != [3] or linear.rank(hessian(members[0][0], 3), 3) != 1:
        return
    (line,) = next(with_multiplicities(members[0][0], 3, (2,)))
    other = next(q for q in pencil if linear.rank([_values(q), _values(members[0][0])], 6) == 2)
    rows = completed([line], 3)
    inside = in_coordinates(other, rows, 2)
    factors, _ = linear_factors({m: c for m, c in inside.items() if not poly.exponents_of(m, 3)[0]}, 3)
    if [m for _, m in factors] != [2]:
        return
    tangent = linear.product([factors[0][0]], rows)[0]
    rows = completed([line, tangent], 3)
    inside = in_coordinates(other, rows, 2)
    unit = poly.variable(0, 3)
    along = {m - unit: c for m, c in inside.items() if poly.exponents_of(m, 3)[0]}
    third = linear.product([row(along, 3)], rows)[0]
    lines = [line, tangent, third]
    yield from stage_of(pencil, lines, [(2, 0, 0), (0, 2, 0)], (2, 1, 0), (2 * UNIT + 4, 2 * UNIT + 2))


def _two_squares(pencil: Sequence[Polynomial]) -> Iterator[Stage]:
    """(x², y²): all members are degenerate, two are squares."""
    _, degenerate = _members(pencil)
    slopes = [[hessian(q, 3)[i][j] for j in range(3)] for q in pencil for i in range(3)]
    kernel = linear.null_space(slopes, 3)
    if not degenerate or len(kernel) != 1:
        return
    rows = completed(linear.null_space(kernel, 3), 3)
    inside = [hessian(in_coordinates(q, rows, 2), 3) for q in pencil]
    # the squares are the members whose 2 × 2 determinant vanishes
    (a, b) = inside
    determinant: Polynomial = {
        poly.monomial((2, 0)): a[0][0] * a[1][1] - a[0][1] ** 2,
        poly.monomial((1, 1)): a[0][0] * b[1][1] + a[1][1] * b[0][0] - 2 * a[0][1] * b[0][1],
        poly.monomial((0, 2)): b[0][0] * b[1][1] - b[0][1] ** 2,
    }
    for roots in with_multiplicities({m: c for m, c in determinant.items() if c}, 2, (1, 1)):
        squares = []
        for p, q in roots:
            member = (
                poly.plus({m: q * c for m, c in pencil[0].items() if q}, pencil[1], -p) if p else pencil[0]
            )
            (line,) = next(with_multiplicities(member, 3, (2,)))
            squares.append(line)
        lines = completed(squares, 3)
        yield from stage_of(pencil, lines, [(2, 0, 0), (0, 2, 0)], (1, 1, 0), (2 * UNIT, 2 * UNIT))


def _value(line: Row, point: Row) -> Fraction:
    return sum((a * b for a, b in zip(line, point)), Fraction(0))


def _values(q: Polynomial) -> Row:
    return [Fraction(q.get(m, 0)) for m in squares(3)]


#: by the letter of the row: the stages of a pencil
SPACE: dict[str, Callable[[Sequence[Polynomial]], Iterator[Stage]]] = {
    "S": _double,
    "T": _square_and_pair,
    "U": _triple_pair,
    "W": _triple_square,
    "Z": _two_squares,
}
