"""The kinds of functions of the lists for R: their lowest jets, coordinates from these, and weights."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from osculant.cas.errors import UndecidedError
from osculant.cas.germs import linear
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition.finishing import Finished, Finisher, Terms, cubes, cubic, quartic, tangent_cubic
from osculant.cas.recognition.forms import Form
from osculant.cas.recognition.levels import UNIT
from osculant.cas.recognition.rational_forms import complex_lines, hesse
from osculant.cas.recognition.splitting import diagonal_basis, hessian
from osculant.cas.recognition.ternary import (
    Row,
    chord_conic,
    completed,
    concurrent,
    cuspidal,
    in_coordinates,
    linear_factors,
    nodal,
    tangent_conic,
    with_multiplicities,
)

#: the jet of a degree of a function of c variables → new coordinates, as rows of linear forms
Lines = Callable[[Polynomial, int], Iterator[Sequence[Row]]]


@dataclass(frozen=True)
class Kind:
    """How the rows of a kind of functions are prepared.

    Attributes:
        corank: of the Hessian.
        degree: of the lowest jet of what is left after splitting.
        lines: coordinates from that jet.
        weights: of the variables that are left, in the order of the row; squares weigh half the degree.
        weight: of the lowest terms, by these weights.
        more: a change of higher order after the lines, from the function.
        finish: the last step over a number field, if the lowest terms stay as they are until then.
        open: exponents of the terms that may remain until then, of the variables that are left.
        next: exponents of such terms in the degree of determinacy, as how much less the first has.
    """

    corank: int
    degree: int
    lines: Lines
    weights: tuple[int, ...]
    weight: int
    more: Callable[[Polynomial], Iterator[Sequence[Polynomial]]] | None = None
    finish: Finisher | None = None
    open: tuple[tuple[int, ...], ...] = ()
    next: tuple[int, ...] = ()


def _as_it_is(jet: Polynomial, n: int) -> Iterator[Sequence[Row]]:
    if jet:
        yield [[Fraction(int(i == j)) for j in range(n)] for i in range(n)]


def _powers(*multiplicities: int) -> Lines:
    """Linear factors with these multiplicities, in their order, as the first coordinates."""

    def lines(jet: Polynomial, n: int) -> Iterator[Sequence[Row]]:
        for rows in with_multiplicities(jet, n, multiplicities):
            yield completed(rows, n)

    return lines


def _double_and_others(jet: Polynomial, n: int) -> Iterator[Sequence[Row]]:
    """x²·(a·x² + b·y²): the double line, and the one conjugate to it for the other quadratic factor."""
    lines, _ = linear_factors(jet, n)
    for line in (line for line, m in lines if m == 2):
        rows = completed([line], n)
        inside = in_coordinates(jet, rows, 4)
        x, y = poly.variable(0, 2), poly.variable(1, 2)
        square, mixed = Fraction(inside.get(2 * x + 2 * y, 0)), Fraction(inside.get(3 * x + y, 0))
        if square:
            factor = mixed / (2 * square)
            yield [line, [s + factor * t for s, t in zip(rows[1], line)]]


def _found(search: Callable[[Polynomial], Sequence[Row] | None]) -> Lines:
    def lines(jet: Polynomial, n: int) -> Iterator[Sequence[Row]]:
        rows = search(jet)
        if rows is not None:
            yield rows

    return lines


def _roles(lines: Lines, *places: int) -> Lines:
    """The same coordinates with the names of a row: place i of the row has the coordinate ``places[i]``."""

    def named(jet: Polynomial, n: int) -> Iterator[Sequence[Row]]:
        for rows in lines(jet, n):
            yield [rows[i] for i in places]

    return named


def _chord(jet: Polynomial, n: int) -> Iterator[Sequence[Row]]:
    return chord_conic(jet)


def _cube(f: Polynomial) -> Iterator[Sequence[Polynomial]]:
    """x ↦ x + r·y² such that of x³, x²y², xy⁴, y⁶ only the first two are left: r a double root."""
    x, y = poly.variable(0, 2), poly.variable(1, 2)
    cubic = {(3 - i) * poly.variable(0, 2) + i * y: f.get((3 - i) * x + 2 * i * y, 0) for i in range(4)}
    lines, _ = linear_factors({m: c for m, c in cubic.items() if c}, 2)
    for line, m in lines:
        if m == 2 and line[0]:
            yield [{x: Fraction(1), 2 * y: -line[1] / line[0]}, {y: Fraction(1)}]


def _weighted(*weights: int) -> tuple[int, ...]:
    return tuple(UNIT * w for w in weights)


def _binary(degree: int) -> tuple[tuple[int, int], ...]:
    return tuple((i, degree - i) for i in range(degree + 1))


def _ternary(degree: int) -> tuple[tuple[int, int, int], ...]:
    return tuple((i, j, degree - i - j) for i in range(degree + 1) for j in range(degree + 1 - i))


def _definite_square(jet: Polynomial, n: int) -> Iterator[Sequence[Row]]:
    """c·(x² + d·y²)² with d > 0."""
    lines, others = linear_factors(jet, n)
    if lines or [m for _, m in others] != [2]:
        return
    _, basis = diagonal_basis(hessian(others[0][0], n))
    rows = linear.inverse(basis)
    inside = in_coordinates(jet, rows, 4)
    if inside[2 * poly.variable(0, n) + 2 * poly.variable(1, n)] * inside[4 * poly.variable(0, n)] > 0:
        yield rows


def _exchanged(finish: Finisher) -> Finisher:
    """With the first two variables in each other's place."""

    def exchanged(terms: Terms, n: int, order: int, places: Sequence[int]) -> Iterator[Finished]:
        return finish(terms, n, order, (places[1], places[0]))

    return exchanged


_X3, _D, _E = _powers(3), (UNIT + 1, UNIT + 2), (UNIT + 2, UNIT + 1)
_PARABOLA = ((3, 0), (1, 4), (0, 6))
_PLANES = (*((*m, 0) for m in _binary(3)), *((*m, 2) for m in _binary(2)), (0, 0, 4))
_CUBIC = Kind(2, 3, _as_it_is, _weighted(1, 1), 3 * UNIT, finish=cubic, open=_binary(3))

#: kinds by the name of the row
KINDS: dict[str, Kind] = {
    "A_k": Kind(1, 0, _as_it_is, (UNIT + 2,), 2 * UNIT),
    **{f"A_{k}": Kind(1, 0, _as_it_is, (UNIT + 2,), 2 * UNIT) for k in (2, 3, 4, 5)},
    "D_4": _CUBIC,
    **{name: replace(_CUBIC, finish=_exchanged(cubic)) for name in ("D_4-", "D_4+")},
    "D_5": Kind(2, 3, _roles(_powers(2, 1), 1, 0), _D[::-1], 2 * UNIT),
    "D_k": Kind(2, 3, _powers(2, 1), _D, 2 * UNIT),
    **{name: Kind(2, 3, _X3, _E, 2 * UNIT) for name in ("E_6", "E_7", "E_8", "E_12", "E_13", "E_14")},
    "J_10": Kind(2, 3, _X3, _E, 2 * UNIT, finish=tangent_cubic, open=_PARABOLA),
    "J_10+k": Kind(2, 3, _X3, _weighted(2, 1), 6 * UNIT, _cube),
    "X_9": Kind(2, 4, _as_it_is, _weighted(1, 1), 4 * UNIT, finish=quartic, open=_binary(4)),
    "X_9+k": Kind(2, 4, _double_and_others, _weighted(1, 1), 4 * UNIT),
    "Y_r,s": Kind(2, 4, _powers(2, 2), _weighted(1, 1), 4 * UNIT),
    "Z_11": Kind(2, 4, _powers(3, 1), _weighted(4, 3), 15 * UNIT),
    "Z_12": Kind(2, 4, _powers(3, 1), _weighted(3, 2), 11 * UNIT),
    "Z_13": Kind(2, 4, _powers(3, 1), _weighted(5, 3), 18 * UNIT),
    "W_12": Kind(2, 4, _powers(4), _weighted(5, 4), 20 * UNIT),
    "W_13": Kind(2, 4, _powers(4), _weighted(4, 3), 16 * UNIT),
    "Y_r": Kind(
        2,
        4,
        _definite_square,
        _weighted(1, 1),
        4 * UNIT,
        finish=complex_lines,
        open=_binary(4),
        next=(0, 1),
    ),
    "P_8": Kind(3, 3, _as_it_is, _weighted(1, 1, 1), 3 * UNIT, finish=hesse, open=_ternary(3)),
    "P_8+k": Kind(3, 3, _found(nodal), _weighted(1, 1, 1), 3 * UNIT),
    "T_3,4,r": Kind(3, 3, _chord, _weighted(1, 1, 1), 3 * UNIT),
    "T_3,5,5": Kind(3, 3, _chord, _weighted(1, 1, 1), 3 * UNIT),
    "T_4,4,r": Kind(3, 3, _powers(1, 1, 1), _weighted(1, 1, 1), 3 * UNIT),
    "Q_10": Kind(3, 3, _found(cuspidal), _weighted(8, 6, 9), 24 * UNIT),
    "Q_11": Kind(3, 3, _roles(_found(cuspidal), 0, 2, 1), _weighted(6, 7, 4), 18 * UNIT),
    "Q_12": Kind(3, 3, _found(cuspidal), (5 * UNIT, 3 * UNIT + 1, 6 * UNIT), 15 * UNIT),
    "S_11": Kind(3, 3, _found(tangent_conic), _weighted(4, 5, 6), 16 * UNIT),
    "S_12": Kind(3, 3, _roles(_found(tangent_conic), 1, 2, 0), _weighted(4, 5, 3), 13 * UNIT),
    "U_12": Kind(3, 3, _found(concurrent), _weighted(4, 4, 3), 12 * UNIT, finish=cubes, open=_PLANES),
}


def function_kind(form: Form) -> tuple[Kind, int]:
    """The kind of a row of the lists of functions and its corank; raises UndecidedError if it has none."""
    name = form.entry.id.removesuffix("^0")
    name = "D_4" if name == "D_k" and dict(form.integers)["k"] == 4 else name
    if name not in KINDS:
        raise UndecidedError(f"No equivalences with {form} are built.")
    kind = KINDS[name]
    return kind, 0 if name == "A_k" and dict(form.integers)["k"] == 1 else kind.corank
