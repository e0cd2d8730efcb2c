"""Tangent vectors with the vector fields that make them, and exact solutions of X·f = target.

Every spanning vector of a tangent space is kept with its field: the side, the multiplier and the generator.
The annihilator tells whether a target is a combination of them modulo M^{k+1}; `solve` finds one and adds it
up anew.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal

from flint import fmpq, fmpq_mat, nmod_mat

from osculant.cas.errors import UndecidedError
from osculant.cas.germs import linear
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import Algebraic, exact
from osculant.cas.germs.annihilator import annihilator
from osculant.cas.germs.elimination_mod_p import blocks
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version, group
from osculant.cas.germs.tangent import JetSpace, Vector, spanning

#: modulo the first of these that does not lower the rank, independent rows are chosen
PRIMES = (2**30 - 35, 2**31 - 1, 2**29 - 3)

Row = dict[int, Any]


@dataclass(frozen=True)
class TangentField:
    """A vector field of a group, as a generator times a monomial.

    Attributes:
        side: "source" x^α ξ, "target" y^β ∂/∂y_j (A, L), or "contact" x^α f_i e_j (K, C).
        multiplier: the exponents α or β.
        generator: the number of ξ among the source fields of the group (for fields of one's own and a version
            other than the extended one: among the generators of that version), that of j, or (i, j).
    """

    side: Literal["source", "target", "contact"]
    multiplier: tuple[int, ...]
    generator: int | tuple[int, int]


def fields(
    germ: Germ, name: str | Group, version: Version, order: int
) -> Iterator[tuple[TangentField, Vector]]:
    """The fields of that version of a group and what they make of a germ, modulo terms above the order.

    >>> for field, vector in fields(Germ("x**2", "x"), "R", Version.ORDINARY, 2):
    ...     print(field, vector == ({poly.monomial((2,)): 2},))
    TangentField(side='source', multiplier=(1,), generator=0) True
    """
    for side, multiplier, generator, vector in spanning(germ, group(name), version, order):
        if any(vector):
            yield TangentField(side, multiplier, generator), vector


def solve(
    germ: Germ, name: str | Group, version: Version, order: int, target: Sequence[poly.Polynomial]
) -> dict[TangentField, Any] | None:
    """A combination X of the fields with X·f = target modulo M^{order+1}, exactly.

    Args:
        germ: f.
        name: the group.
        version: which of its fields.
        order: the order of the jets.
        target: a polynomial for each component of f; terms above the order do not count.

    Returns the coefficients that are not 0, or None if there is no such combination, which the exact
    annihilator proves; the combination was added up in exact arithmetic. Raises UndecidedError if no prime
    tried tells the rank.

    >>> found = solve(Germ("x**3", "x"), "R", Version.ORDINARY, 4, [{poly.monomial((4,)): 1}])
    >>> {field.multiplier: c for field, c in found.items()}
    {(2,): Fraction(1, 3)}
    >>> solve(Germ("x**3", "x"), "R", Version.ORDINARY, 4, [{poly.monomial((2,)): 1}]) is None
    True
    """
    space = JetSpace(germ.n, germ.p, order)
    place = space.place()
    wanted = _row([poly.cut(f, germ.n, order) for f in target], space, place)
    kept = [(field, vector) for field, vector in fields(germ, name, version, order)]
    whole = [space.row(vector, place) for _, vector in kept]  # integers, multiples of the vectors
    known = annihilator(whole, space.columns, germ.field)
    if any(sum((v * wanted[c] for c, v in f.items() if c in wanted), Fraction(0)) for f in known.functionals):
        return None
    rows = [_row(vector, space, place) for _, vector in kept]
    weights: dict[TangentField, Any] = {}
    for _, where in blocks(whole, space.columns):
        part = {c: wanted[c] for c in where if c in wanted}
        if part:
            inside = set(where)
            here = [i for i, row in enumerate(rows) if next(iter(row)) in inside]
            found = _combination([rows[i] for i in here], part, where)
            weights |= {kept[here[k]][0]: v for k, v in found.items()}
    return weights


def _row(vector: Sequence[poly.Polynomial], space: JetSpace, place: Mapping[int, int]) -> Row:
    return {space.p * place[m] + j: exact(c) for j, f in enumerate(vector) for m, c in f.items() if c}


def _combination(rows: Sequence[Row], target: Row, where: Sequence[int]) -> dict[int, Any]:
    """Weights of rows that add up to a target in their span."""
    if any(isinstance(v, Algebraic) for row in (*rows, target) for v in row.values()):
        return _over_field(rows, target, where)
    for prime in PRIMES:
        chosen, columns = _independent(rows, where, prime)
        size = len(chosen)
        square = fmpq_mat(size, size, [_rational(rows[i].get(c)) for c in columns for i in chosen])
        try:
            solution = square.solve(fmpq_mat(size, 1, [_rational(target.get(c)) for c in columns]))
        except ZeroDivisionError:
            continue
        values = {i: Fraction(int(solution[k, 0].p), int(solution[k, 0].q)) for k, i in enumerate(chosen)}
        found = {i: v for i, v in values.items() if v}
        total: Row = {}
        for i, v in found.items():
            for c, entry in rows[i].items():
                total[c] = total.get(c, Fraction(0)) + v * entry
        if {c: v for c, v in total.items() if v} == target:
            return found
    raise UndecidedError(f"The rank of {len(rows)} rows was not told by {len(PRIMES)} primes.")


def _over_field(rows: Sequence[Row], target: Row, where: Sequence[int]) -> dict[int, Any]:
    """The same over a number field."""
    zero = Fraction(0)
    equations = [[row.get(c, zero) for row in rows] for c in where]
    solved = linear.solution(equations, [target.get(c, zero) for c in where], len(rows))
    assert solved is not None  # the annihilator has told that there is one
    return {i: v for i, v in enumerate(solved) if v}


def _independent(rows: Sequence[Row], where: Sequence[int], prime: int) -> tuple[list[int], list[int]]:
    """(rows, columns) of a square part that is regular modulo a prime, of the rank modulo the prime."""
    place = {c: i for i, c in enumerate(where)}
    matrix = nmod_mat(len(where), len(rows), prime)  # transposed: leading columns of its form are rows
    for k, row in enumerate(rows):
        for c, v in row.items():
            matrix[place[c], k] = _residue(v, prime)
    chosen = _leading(matrix)
    part = nmod_mat(len(chosen), len(where), prime)
    for i, k in enumerate(chosen):
        for c, v in rows[k].items():
            part[i, place[c]] = _residue(v, prime)
    return chosen, [where[j] for j in _leading(part)]


def _leading(matrix: nmod_mat) -> list[int]:
    form, rank = matrix.rref()
    found, column = [], 0
    for i in range(rank):
        while not int(form[i, column]):
            column += 1
        found.append(column)
    return found


def _residue(v: Fraction, prime: int) -> int:
    return v.numerator * pow(v.denominator, -1, prime) % prime if v.denominator % prime else 0


def _rational(v: Fraction | None) -> fmpq:
    return fmpq(0) if v is None else fmpq(v.numerator, v.denominator)
