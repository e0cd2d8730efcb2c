"""A linear stage of a pair of functions with quadratic parts: new coordinates, and which part leads where."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from osculant.cas.germs import linear
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition.levels import UNIT, Weights
from osculant.cas.recognition.ternary import Row, in_coordinates


@dataclass(frozen=True)
class Stage:
    """New coordinates of the source as linear forms, the matrix of the target, and weights."""

    lines: Sequence[Row]
    target: Sequence[Row]
    weights: Weights


def squares(n: int) -> list[int]:
    """The monomials of degree 2 in n variables."""
    return [m for m in poly.monomials(n, 2) if poly.degree_of(m, n) == 2]


def stage_of(
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
