"""Linear stages of Giusti's simple complete intersections under K: the pencil of the quadratic parts.

Two quadratic forms span a pencil; its members of low rank and their lines are the coordinates. Where both
components have quadratic parts these become monomials at once; where only one has, a product of lines or a
square, the other is cleared of its multiples by the reduction.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from osculant.cas.errors import UndecidedError
from osculant.cas.germs import linear
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import rational
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition.forms import Form
from osculant.cas.recognition.jets import matrix_of
from osculant.cas.recognition.levels import UNIT, Weights
from osculant.cas.recognition.moves import Moved
from osculant.cas.recognition.obstruction import NotEquivalent
from osculant.cas.recognition.reduction import Start
from osculant.cas.recognition.splitting import diagonal_basis, hessian
from osculant.cas.recognition.ternary import (
    Row,
    completed,
    in_coordinates,
    linear_factors,
    row,
    with_multiplicities,
)

#: how far below 3·UNIT the weight of a component of order 3 stands: its terms x·f₁ and f₂ in the first both
#: raise levels then
BELOW = 100


@dataclass(frozen=True)
class Stage:
    """New coordinates of the source as linear forms, the matrix of the target, and weights."""

    lines: Sequence[Row]
    target: Sequence[Row]
    weights: Weights


def intersection_starts(moved: Moved, form: Form) -> Iterator[Start]:
    """The starts of the reduction of a germ for K, one after another.

    Raises NotEquivalent for another pencil, UndecidedError for lines that are not rational.
    """
    n = moved.n
    parts = [{m: c for m, c in g.items() if poly.degree_of(m, n) <= 2} for g in moved.f.polynomials()]
    if any(poly.degree_of(m, n) == 1 for g in parts for m in g):
        raise NotEquivalent("The germ has a linear part.")
    known = False
    for stage in _of_the_row(form, parts, n):
        known = True
        source, target = (
            matrix_of([[rational(v) for v in r] for r in rows])
            for rows in (linear.inverse(list(stage.lines)), stage.target)
        )
        yield Start(moved.changed(source, target), stage.weights, {}, frozenset(form.columns))
    if not known:
        raise NotEquivalent("The quadratic parts are another pencil.")


def _of_the_row(form: Form, pencil: Sequence[Polynomial], n: int) -> Iterator[Stage]:
    name, integers = form.entry.id, dict(form.integers)
    size = linear.rank([[Fraction(q.get(m, 0)) for m in _squares(n)] for q in pencil], len(_squares(n)))
    if n == 2:
        wide = name == "F_p,q" and integers["p"] == 2
        if size == (2 if wide else 1):
            if name == "F_p,q":
                yield from _crossing(pencil, integers["p"], integers["q"])
            else:
                yield from _square(pencil)
        return
    if size == 2:
        yield from (_SPACE[name[0]](pencil) if name != "S_k" or integers["k"] > 5 else _general(pencil))


def _squares(n: int) -> list[int]:
    return [m for m in poly.monomials(n, 2) if poly.degree_of(m, n) == 2]


def _stage(
    pencil: Sequence[Polynomial],
    lines: Sequence[Row],
    leading: Sequence[tuple[int, ...]],
    source: Sequence[int],
    target: Sequence[int],
) -> Iterator[Stage]:
    """The stage in which component j has the leading monomial j and not the others; none if there is none."""
    moved = [in_coordinates(q, lines, 2) if q else {} for q in pencil]
    columns = [poly.monomial(m) for m in leading]
    matrix = [[Fraction(q.get(m, 0)) for q in moved] for m in columns]
    if len(columns) == 1:  # the other quadratic part is a multiple of the first
        a, b = matrix[0]
        rows = [[Fraction(1), Fraction(0)], [-b / a, Fraction(1)]] if a else [[a, b], [b, a]]
    elif linear.rank(matrix, 2) == 2:
        rows = linear.inverse([list(r) for r in zip(*matrix)])
    else:
        return
    weights = Weights(tuple(UNIT + w for w in source), tuple(target))
    yield Stage(lines, rows, weights)


def _crossing(pencil: Sequence[Polynomial], p: int, q: int) -> Iterator[Stage]:
    """(xy, xᵖ ± y^q)."""
    cubic = (2 * UNIT, 3 * UNIT - BELOW)
    if p > 2:
        first = next(g for g in pencil if g)
        for lines in with_multiplicities(first, 2, (1, 1)):
            yield from _stage(pencil, lines, [(1, 1)], (0, 0), cubic)
        return
    matrices = [hessian(g, 2) for g in pencil]  # the quadratic forms on linear forms that the pencil kills
    ((a, b, c),) = linear.null_space([[m[0][0], 2 * m[0][1], m[1][1]] for m in matrices], 3)
    corank, basis = diagonal_basis([[a, b], [b, c]])
    lines = [list(column) for column in zip(*basis)]
    if corank != (0 if q == 2 else 1):
        return
    yield from _stage(pencil, lines, [(1, 1), (2, 0)], (1, 0), (2 * UNIT, 2 * UNIT))


def _square(pencil: Sequence[Polynomial]) -> Iterator[Stage]:
    """(x² + …, terms of order 3)."""
    first = next(g for g in pencil if g)
    for lines in with_multiplicities(first, 2, (2,)):
        yield from _stage(pencil, completed(lines, 2), [(2, 0)], (2, 1), (2 * UNIT, 3 * UNIT - BELOW))


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


def _general(pencil: Sequence[Polynomial]) -> Iterator[Stage]:
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
            yield from _stage(pencil, lines, [(2, 0, 0), (0, 1, 1)], (0, 0, 0), (2 * UNIT, 2 * UNIT))
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
                yield from _stage(pencil, lines, [(2, 0, 0), (0, 1, 1)], (0, 0, 0), (2 * UNIT, 2 * UNIT))


def _square_and_pair(pencil: Sequence[Polynomial]) -> Iterator[Stage]:
    """(x², yz): the double member has rank 1."""
    members, _ = _members(pencil)
    double = [q for q, m in members if m == 2 and linear.rank(hessian(q, 3), 3) == 1]
    single = [q for q, m in members if m == 1]
    if not double or not single:
        return
    (line,) = next(with_multiplicities(double[0], 3, (2,)))
    for pair in with_multiplicities(single[0], 3, (1, 1)):
        yield from _stage(pencil, [line, *pair], [(2, 0, 0), (0, 1, 1)], (0, 0, 0), (2 * UNIT, 2 * UNIT))


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
            yield from _stage(pencil, lines, [(2, 0, 0), (1, 1, 0)], (1, 2, 0), (2 * UNIT + 2, 2 * UNIT + 3))


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
    yield from _stage(pencil, lines, [(2, 0, 0), (0, 2, 0)], (2, 1, 0), (2 * UNIT + 4, 2 * UNIT + 2))


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
        yield from _stage(pencil, lines, [(2, 0, 0), (0, 2, 0)], (1, 1, 0), (2 * UNIT, 2 * UNIT))


def _value(line: Row, point: Row) -> Fraction:
    return sum((a * b for a, b in zip(line, point)), Fraction(0))


def _values(q: Polynomial) -> Row:
    return [Fraction(q.get(m, 0)) for m in _squares(3)]


_SPACE = {
    "S": _double,
    "T": _square_and_pair,
    "U": _triple_pair,
    "W": _triple_square,
    "Z": _two_squares,
}
