"""Linear stages of Giusti's simple complete intersections under K: the pencil of the quadratic parts.

Two quadratic forms span a pencil; its members of low rank and their lines are the coordinates. Where both
components have quadratic parts these become monomials at once; where only one has, a product of lines or a
square, the other is cleared of its multiples by the reduction.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from osculant.cas.germs import linear
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import rational
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition.forms import Form
from osculant.cas.recognition.jets import matrix_of
from osculant.cas.recognition.levels import UNIT
from osculant.cas.recognition.moves import Moved
from osculant.cas.recognition.obstruction import NotEquivalent
from osculant.cas.recognition.pair_stages import Stage, squares, stage_of
from osculant.cas.recognition.reduction import Start
from osculant.cas.recognition.space_pencils import SPACE, general
from osculant.cas.recognition.splitting import diagonal_basis, hessian
from osculant.cas.recognition.ternary import completed, with_multiplicities

#: how far below 3·UNIT the weight of a component of order 3 stands: its terms x·f₁ and f₂ in the first both
#: raise levels then
BELOW = 100


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
    size = linear.rank([[Fraction(q.get(m, 0)) for m in squares(n)] for q in pencil], len(squares(n)))
    if n == 2:
        wide = name == "F_p,q" and integers["p"] == 2
        if size == (2 if wide else 1):
            if name == "F_p,q":
                yield from _crossing(pencil, integers["p"], integers["q"])
            else:
                yield from _square(pencil)
        return
    if size == 2:
        yield from (SPACE[name[0]](pencil) if name != "S_k" or integers["k"] > 5 else general(pencil))


def _crossing(pencil: Sequence[Polynomial], p: int, q: int) -> Iterator[Stage]:
    """(xy, xᵖ ± y^q)."""
    cubic = (2 * UNIT, 3 * UNIT - BELOW)
    if p > 2:
        first = next(g for g in pencil if g)
        for lines in with_multiplicities(first, 2, (1, 1)):
            yield from stage_of(pencil, lines, [(1, 1)], (0, 0), cubic)
        return
    matrices = [hessian(g, 2) for g in pencil]  # the quadratic forms on linear forms that the pencil kills
    ((a, b, c),) = linear.null_space([[m[0][0], 2 * m[0][1], m[1][1]] for m in matrices], 3)
    corank, basis = diagonal_basis([[a, b], [b, c]])
    lines = [list(column) for column in zip(*basis)]
    if corank != (0 if q == 2 else 1):
        return
    flag = int(q > 2)  # y is known up to multiples of x, with x² in the first component, if x is double
    yield from stage_of(pencil, lines, [(1, 1), (2, 0)], (flag, 0), (2 * UNIT, 2 * UNIT + flag))


def _square(pencil: Sequence[Polynomial]) -> Iterator[Stage]:
    """(x² + …, terms of order 3)."""
    first = next(g for g in pencil if g)
    for lines in with_multiplicities(first, 2, (2,)):
        yield from stage_of(pencil, completed(lines, 2), [(2, 0)], (2, 1), (2 * UNIT, 3 * UNIT - BELOW))
