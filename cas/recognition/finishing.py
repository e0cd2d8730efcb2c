"""Last steps over a real number field: a rational normal form is made that of a list by one change more.

The reduction is rational; where a form has lines that are not, it stops at the lowest terms as they are. The
lines are real roots, and over their field one more change of the source, and exact arithmetic, make the form.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import Algebraic, NumberField, exact
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition.forms import Column
from osculant.cas.recognition.obstruction import NotEquivalent
from osculant.cas.recognition.real_fields import real_roots, sign

Terms = Mapping[Column, Any]
#: images of two variables
Pair = tuple[Polynomial, Polynomial]

X, Y = poly.variable(0, 2), poly.variable(1, 2)


@dataclass(frozen=True)
class Finish:
    """A change of the source over a number field: ``images`` of the variables, after all others."""

    field: NumberField
    images: tuple[Polynomial, ...]

    def exchanged(self, order: Sequence[int]) -> Finish:
        """The change with variable i called variable order[i]."""
        n = len(order)
        images = [
            {
                sum(e * poly.variable(order[i], n) for i, e in enumerate(poly.exponents_of(m, n))): c
                for m, c in f.items()
            }
            for f in self.images
        ]
        return Finish(self.field, tuple(images))


@dataclass(frozen=True)
class Finished:
    """The terms after a change of two variables, whose images are polynomials in them and a third.

    If they are not those of the form but a rational normal form, the ``moduli`` of the form are told by name.
    """

    images: tuple[Polynomial, ...]
    terms: dict[Column, Any]
    moduli: Mapping[str, Any] | None = None

    @property
    def field(self) -> NumberField | None:
        """The field of the numbers; None for ℚ."""
        numbers = [c for f in self.images for c in f.values()]
        return next((c.field for c in numbers if isinstance(c, Algebraic)), None)


#: terms, n, the order, and the places of the variables → what they can be made
Finisher = Callable[[Terms, int, int, Sequence[int]], Iterator[Finished]]


def unchanged(n: int) -> tuple[Polynomial, ...]:
    """The images of the variables under the identity."""
    return tuple({poly.variable(i, n): Fraction(1)} for i in range(n))


def substituted(terms: Terms, images: Sequence[Polynomial], n: int, order: int) -> dict[Column, Any]:
    """A germ of few terms after a change of the source.

    >>> substituted({((2,), 0): Fraction(1)}, [{poly.variable(0, 1): Fraction(3)}], 1, 2)
    {((2,), 0): Fraction(9, 1)}
    """
    found: dict[Column, Any] = {}
    for (m, j), c in terms.items():
        product: Polynomial = {0: exact(c)}
        for image, e in zip(images, m):
            for _ in range(e):
                product = poly.times(product, image, n, order)
        for packed, value in product.items():
            column = (poly.exponents_of(packed, n), j)
            found[column] = exact(found.get(column, Fraction(0)) + value)
    return {column: c for column, c in found.items() if c}


def _finished(
    terms: Terms, pair: Sequence[Mapping[tuple[int, int], Any]], n: int, order: int, places: Sequence[int]
) -> Finished:
    """The terms after a change of two variables; its images by their exponents in these."""
    images = list(unchanged(n))
    for place, image in zip(places[:2], pair):
        images[place] = {
            e * poly.variable(places[0], n) + f * poly.variable(places[1], n): exact(c)
            for (e, f), c in image.items()
            if c
        }
    return Finished(tuple(images), substituted(terms, images, n, order))


def _form(terms: Terms, degree: int, places: Sequence[int]) -> list[Fraction]:
    """The coefficients of the binary form of that degree, from y^d on."""
    found = [Fraction(0)] * (degree + 1)
    for (m, _), c in terms.items():
        i, j = places[:2]
        if m[i] + m[j] == degree == sum(m):
            found[m[i]] = c
    return found


def _lines(form: Sequence[Fraction]) -> Iterator[tuple[Any, Any]]:
    """The real points (x : y) where a binary form vanishes, y = 0 first."""
    if not form[-1]:
        yield Fraction(1), Fraction(0)
    for r in real_roots(_trimmed(form)):
        yield r, Fraction(1)


def _trimmed(form: Sequence[Fraction]) -> list[Fraction]:
    found = list(form)
    while found and not found[-1]:
        found.pop()
    return found


def cubic(terms: Terms, n: int, order: int, places: Sequence[int]) -> Iterator[Finished]:
    """a·x²y + b·y³ of a binary cubic: y is a real line, x apolar to it."""
    form = _form(terms, 3, places)
    if not _discriminant(form):
        raise NotEquivalent("The cubic has a double line.")
    for a, b in _lines(form):
        # the line is b·x − a·y; x = X + a·Y, y = … takes it to a multiple of Y
        first: list[dict[tuple[int, int], Any]] = (
            [{(1, 0): a, (0, 1): Fraction(1)}, {(1, 0): Fraction(1)}] if b else [{(1, 0): 1}, {(0, 1): 1}]
        )
        moved = _form(_finished(terms, first, n, order, places).terms, 3, places)  # no X³: Y is the line
        shift = moved[1] / (-2 * moved[2])  # X ↦ X + shift·Y clears X·Y²
        pair = [
            {(1, 0): image.get((1, 0), 0), (0, 1): image.get((0, 1), 0) + image.get((1, 0), 0) * shift}
            for image in first
        ]
        yield _finished(terms, pair, n, order, places)
        return


def cubes(terms: Terms, n: int, order: int, places: Sequence[int]) -> Iterator[Finished]:
    """a·x³ + b·y³ of a binary cubic with one real line, and z² times xy at most."""
    form = _form(terms, 3, places)
    d, c, b, a = form
    hessian = [b * d * 3 - c * c, 9 * a * d - b * c, 3 * a * c - b * b]  # from y² on
    if hessian[1] ** 2 <= 4 * hessian[0] * hessian[2]:
        raise NotEquivalent("The cubic has three real lines, or a double one.")
    p, q = next(_lines(hessian))
    r, s = (-hessian[1] / hessian[2] - p, 1) if q else (-hessian[0], hessian[1])
    pair: list[dict[tuple[int, int], Any]] = [{(1, 0): p, (0, 1): r}, {(1, 0): q, (0, 1): s}]
    moved = _finished(terms, pair, n, order, places)
    i, j = places[:2]
    k = next(k for k in range(n) if k not in (i, j))
    images = list(unchanged(n))
    for place in (i, j):
        cube = tuple(3 * int(v == place) for v in range(n))
        square = tuple(2 * int(v in (place, k)) for v in range(n))
        factor = moved.terms.get((square, 0), 0) / (-3 * moved.terms[cube, 0])
        if factor:
            images[place] = {poly.variable(place, n): Fraction(1), 2 * poly.variable(k, n): factor}
    both = tuple(_composed(f, images, n, order) for f in moved.images)
    yield Finished(both, substituted(terms, both, n, order))


def tangent_cubic(terms: Terms, n: int, order: int, places: Sequence[int]) -> Iterator[Finished]:
    """x³ + a·x²y² ± xy⁴ of x³, xy⁴ and y⁶: x ↦ x + r·y², r the real root in the middle."""
    i, j = places[:2]

    def coefficient(e: int, f: int) -> Fraction:
        m = tuple(e * int(v == i) + f * int(v == j) for v in range(n))
        return Fraction(terms.get((m, 0), 0))

    a, b, c = coefficient(3, 0), coefficient(1, 4), coefficient(0, 6)
    if not 4 * b**3 + 27 * a * c * c:
        raise NotEquivalent("The cubic of the lowest terms has a double root.")
    roots = list(real_roots([c, b, Fraction(0), a]))
    for r in roots:
        if len(roots) == 1 or sign(3 * a * r * r + b) != sign(a):
            yield _finished(terms, [{(1, 0): 1, (0, 2): r}, {(0, 1): 1}], n, order, places)


def quartic(terms: Terms, n: int, order: int, places: Sequence[int]) -> Iterator[Finished]:
    """a·x⁴ + b·x²y² + c·y⁴ of a binary quartic: x and y are a pair of lines of its sextic covariant.

    Of several spellings it is that with a, c > 0 and, if the form is positive, b² < 4ac.
    """
    form = _form(terms, 4, places)
    for p, q in _lines(_sextic(form)):
        first: list[dict[tuple[int, int], Any]] = (
            [{(1, 0): Fraction(1), (0, 1): p}, {(0, 1): Fraction(1)}]
            if q
            else [{(0, 1): Fraction(1)}, {(1, 0): Fraction(1)}]
        )
        moved = _form(_finished(terms, first, n, order, places).terms, 4, places)
        if not moved[0]:
            raise NotEquivalent("The quartic has a double line.")
        shift = moved[1] / (-4 * moved[0])
        pair = [
            {(0, 1): image.get((0, 1), 0), (1, 0): image.get((1, 0), 0) + image.get((0, 1), 0) * shift}
            for image in first
        ]
        found = _finished(terms, pair, n, order, places)
        e, d, b, _, a = _form(found.terms, 4, places)
        signs, definite = (sign(a), sign(e)), sign(b * b - 4 * a * e) < 0
        if d or not b * b - 4 * a * e:
            raise NotEquivalent("The quartic has a double line.")
        if signs[0] != signs[1] or definite or (signs == (1, 1) and sign(b) < 0):
            yield found
            return
    raise NotEquivalent("The quartic has a double line.")


def _sextic(form: Sequence[Fraction]) -> list[Fraction]:
    """The Jacobian of a binary quartic and its Hessian, from y⁶ on; the first is (x⁰y⁴, …, x⁴)."""
    f: Polynomial = {i * X + (4 - i) * Y: c for i, c in enumerate(form) if c}

    def slope(g: Polynomial, i: int) -> Polynomial:
        return poly.derivative(g, i, 2)

    fx, fy = slope(f, 0), slope(f, 1)
    h = poly.plus(
        poly.times(slope(fx, 0), slope(fy, 1), 2, 9), poly.times(slope(fx, 1), slope(fx, 1), 2, 9), -1
    )
    t = poly.plus(poly.times(fx, slope(h, 1), 2, 9), poly.times(fy, slope(h, 0), 2, 9), -1)
    if not t:
        raise NotEquivalent("The quartic is a square.")
    return [Fraction(t.get(i * X + (6 - i) * Y, 0)) for i in range(7)]


def _discriminant(form: Sequence[Fraction]) -> Fraction:
    d, c, b, a = form
    return b * b * c * c - 4 * a * c**3 - 4 * b**3 * d - 27 * a * a * d * d + 18 * a * b * c * d


def _composed(f: Polynomial, images: Sequence[Polynomial], n: int, order: int) -> Polynomial:
    found = substituted({(poly.exponents_of(m, n), 0): c for m, c in f.items()}, images, n, order)
    return {poly.monomial(m): c for (m, _), c in found.items()}
