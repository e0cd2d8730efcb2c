"""Exact decisions at nice numbers: is a form over jets zero there, and to which order?"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import factorial
from typing import Any

from flint import arb

from osculant.cas.formulas.expression import PI, Node, mul, number
from osculant.cas.numbers.balls import FormulaBalls, constant, precision
from osculant.cas.numbers.fields import ExactNumbers
from osculant.cas.numbers.taylor import program

#: largest denominator of a number called simple
DENOMINATOR = 360
#: bits at which a number that is not zero must show it before sympy is asked
SCREEN = 1024


class Truncated:
    """A polynomial in h, cut after the length it was given: just enough arithmetic for forms over jets.

    >>> (Truncated([1, 1]) * Truncated([1, 1])).terms
    [1, 2]
    """

    def __init__(self, terms: Sequence[Any]) -> None:
        self.terms = list(terms)

    def __add__(self, other: Truncated) -> Truncated:
        return Truncated([a + b for a, b in zip(self.terms, other.terms, strict=True)])

    def __sub__(self, other: Truncated) -> Truncated:
        return Truncated([a - b for a, b in zip(self.terms, other.terms, strict=True)])

    def __mul__(self, other: Truncated | int) -> Truncated:
        if isinstance(other, int):
            return Truncated([other * a for a in self.terms])
        n = len(self.terms)
        return Truncated(
            [
                sum((self.terms[j] * other.terms[k - j] for j in range(k + 1)), 0 * self.terms[0])
                for k in range(n)
            ]
        )

    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> Truncated:
        result = self
        for _ in range(exponent - 1):
            result = result * self
        return result


def simple_rational(low: Fraction, high: Fraction) -> Fraction:
    """The fraction with the smallest denominator in [low, high].

    >>> simple_rational(Fraction(33, 100), Fraction(34, 100))
    Fraction(1, 3)
    """
    if low <= 0 <= high:
        return Fraction(0)
    if high < 0:
        return -simple_rational(-high, -low)
    whole = -(-low.numerator // low.denominator)
    if whole <= high:
        return Fraction(whole)
    rest = simple_rational(1 / (high - whole + 1), 1 / (low - whole + 1))
    return whole - 1 + 1 / rest


def simple_numbers(low: Any, high: Any) -> list[Node]:
    """The simplest rational and the simplest multiple of pi in a small interval, if they are simple."""
    found = []
    for unit, node in ((arb(1), number(1)), (arb.pi(), PI)):
        ends = [(end / unit).mid().fmpq() for end in (low, high)]
        q = simple_rational(*(Fraction(int(end.p), int(end.q)) for end in ends))
        if q.denominator <= DENOMINATOR and abs(q) < 10**6:
            found.append(mul(number(q), node) if q else number(0))
    return found


def is_zero(value: Any, at: Any) -> bool:
    """Whether an exact sympy number is 0; ``at`` is a ball around it that screens most others out."""
    import sympy as sp

    if not at.contains(0):
        return False
    expanded = sp.expand(value)
    if expanded.has(sp.cos, sp.sin):  # in roots of unity, as at a multiple of pi, everything cancels
        expanded = sp.expand(expanded.rewrite(sp.exp))
    return bool(expanded == 0 or (sp.count_ops(expanded) < 500 and sp.simplify(expanded) == 0))


def order_of_zero(
    curve: FormulaBalls[Any], form: Callable[[Any], Any], order: int, candidate: Node, multiplicity: int
) -> bool:
    """Whether the first ``multiplicity`` Taylor coefficients of a form vanish exactly at a constant.

    >>> from osculant.cas.formulas.parser import parse_constant, parse_tuple
    >>> from osculant.cas.jets.balls import CurveBalls
    >>> cycloid = CurveBalls(parse_tuple("t - sin(t), 1 - cos(t)"))
    >>> order_of_zero(cycloid, lambda jet: jet.speed_squared, 1, parse_constant("2*pi"), 2)
    True
    """
    with precision(SCREEN):
        balls = curve.form_series(form, constant(candidate), order, multiplicity)
    if balls is None or not all(c.contains(0) for c in balls):
        return False
    field = ExactNumbers()
    at = program([candidate], 0).run(field.number(Fraction(0)), field)[0][0]
    rows = program(curve.coordinates, order + multiplicity - 1, curve.variable).run(at, field)
    derivatives = [
        [Truncated([row[i + k] / factorial(k) for k in range(multiplicity)]) for i in range(order + 1)]
        for row in rows
    ]
    terms = form(curve.jet_type(*derivatives)).terms
    return all(is_zero(term, near) for term, near in zip(terms, balls, strict=True))
