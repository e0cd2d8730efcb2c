"""Linear stages of functions for R: coordinates in which the lowest terms are those of a row, and weights.

A function is split (`osculant.cas.recognition.splitting`); the lowest jet of what is left tells the lines
that become coordinates, over ℚ. Each kind of row has weights for which its lowest terms are the lowest level:
with flags where only degrees count, else those of the quasi-homogeneous part.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from osculant.cas.germs import linear
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.jets_of_maps import MapJet, map_jet
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition.forms import Column, Form
from osculant.cas.recognition.function_kinds import Kind, function_kind
from osculant.cas.recognition.levels import UNIT, Weights
from osculant.cas.recognition.moves import Moved
from osculant.cas.recognition.obstruction import NotEquivalent
from osculant.cas.recognition.reduction import Start
from osculant.cas.recognition.splitting import Splitting, splitting


def function_starts(moved: Moved, form: Form) -> Iterator[Start]:
    """The starts of the reduction of a function for R, one after another.

    Raises NotEquivalent for a function of another corank or with another lowest jet, UndecidedError for rows
    that have no kind and if the lines that become coordinates are not rational.
    """
    (f,) = moved.f.polynomials()
    if any(poly.degree_of(m, moved.n) == 1 for m in f):
        raise NotEquivalent("The function has no critical point.")
    kind, corank = function_kind(form)
    found = splitting(f, moved.n, moved.order)
    if found.corank != corank:
        raise NotEquivalent(f"The Hessian has corank {found.corank}, not {corank}.")
    yield from started(moved, form, kind, found, tuple(range(corank)))


def started(
    moved: Moved, form: Form, kind: Kind, found: Splitting, places: tuple[int, ...], u: int | None = None
) -> Iterator[Start]:
    """The starts for a function that is split.

    Args:
        moved: the function, not moved yet.
        form: the row.
        kind: its kind.
        found: the splitting.
        places: those of the variables that are left.
        u: the place of the boundary variable if the function is without critical points: u stands alone then.
    """
    n, c, order = moved.n, len(places), moved.order
    function = {m: v for m, v in found.rest.items() if u is None or not poly.exponents_of(m, n)[u]}
    rest = _narrowed(function, n, places)
    scale = 1 if kind.weight == 2 * UNIT else 2  # so that half the weight is whole
    weights = [UNIT if u == i else scale * kind.weight // 2 for i in range(n)]
    for place, weight in zip(places, kind.weights):
        weights[place] = scale * weight
    columns: set[Column] = {column for column in form.columns if not kind.open or not _among(column, places)}
    next_ = [(form.order - less, less) for less in kind.next]
    for exponents in (*kind.open, *next_):
        whole = [0] * n
        for place, e in zip(places, exponents):
            whole[place] = e
        columns.add((tuple(whole), 0))
    last = kind.finish
    finish = None if last is None else lambda terms: last(terms, n, order, places)
    for images in _coordinates(kind, rest, c, order):
        yield Start(
            moved.substituted(found.change).substituted(_widened(images, n, places, order)),
            Weights(tuple(weights), (UNIT,)),
            {},
            frozenset(columns),
            boundary=form.boundary,
            finish=finish,
        )


def _coordinates(kind: Kind, rest: Polynomial, c: int, order: int) -> Iterator[Sequence[Polynomial]]:
    """Changes of the variables that are left; raises NotEquivalent if there is none."""
    units: Sequence[Polynomial] = [{poly.variable(i, c): Fraction(1)} for i in range(c)]
    if c == 0 or not kind.degree:
        yield units
        return
    if any(poly.degree_of(m, c) < kind.degree for m in rest):
        raise NotEquivalent(f"The function has terms of degree less than {kind.degree} beyond its squares.")
    jet = {m: v for m, v in rest.items() if poly.degree_of(m, c) == kind.degree}
    known = False
    for rows in kind.lines(jet, c):
        inverse = linear.inverse(list(rows))
        images = [{poly.variable(j, c): v for j, v in enumerate(row) if v} for row in inverse]
        change = map_jet(images, c, order)
        for further in [units] if kind.more is None else kind.more(_one(map_jet([rest], c, order), change)):
            known = True
            yield change.compose(map_jet(further, c, order)).polynomials()
    if not known:
        raise NotEquivalent("The lowest jet of the function is of another kind.")


def _one(f: MapJet, change: MapJet) -> Polynomial:
    return f.compose(change).polynomials()[0]


def _among(column: Column, places: Sequence[int]) -> bool:
    """Whether a term is one of the variables that are left."""
    return not any(e for i, e in enumerate(column[0]) if i not in places)


def _narrowed(f: Polynomial, n: int, places: Sequence[int]) -> Polynomial:
    """A function of some of n variables as one of these."""
    return {poly.monomial([poly.exponents_of(m, n)[i] for i in places]): v for m, v in f.items()}


def _widened(images: Sequence[Polynomial], n: int, places: Sequence[int], order: int) -> MapJet:
    """A change of some of n variables."""
    wide: list[Polynomial] = [{poly.variable(i, n): 1} for i in range(n)]
    for place, f in zip(places, images):
        wide[place] = {
            sum(e * poly.variable(p, n) for e, p in zip(poly.exponents_of(m, len(places)), places)): v
            for m, v in f.items()
        }
    return map_jet(wide, n, order)
