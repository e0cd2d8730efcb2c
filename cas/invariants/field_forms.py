"""Elements of a differential field in factored form: as sympy expressions, and their real roots."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from math import gcd, lcm, prod
from typing import Any

import sympy
from flint import fmpq

from osculant.cas.errors import UndecidedError
from osculant.cas.formulas.sympy_bridge import cbrt
from osculant.cas.invariants.differential_field import Element, Field

#: terms and total degree beyond which a polynomial is not factored
FACTOR_TERMS, FACTOR_DEGREE = 150, 60
#: terms of a sum in a sympy expression, which is slow to make and long to read
PRINTED_TERMS = 80
#: a polynomial is expanded if that leaves less than this share of the factored form's operations
EXPANDED = 0.75
#: primes that are taken out of a number's root
SMALL_PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47)

Factors = list[tuple[Any, int]]


def expression(element: Element) -> sympy.Expr:
    """The sympy expression: one rational number, and above and below the line primitive polynomials.

    Each polynomial is factored, or expanded where that is clearly shorter. UndecidedError if a sum has more
    than `PRINTED_TERMS` terms.

    >>> field = Field()
    >>> t = field.generator(sympy.Symbol("t", real=True))
    >>> expression((2 * t**2 - 2) / (3 * t**2 + 9)), expression((t + 1) ** 3 / 7)
    (2*(t**2 - 1)/(3*(t**2 + 3)), (t + 1)**3/7)
    """
    (top, above), (bottom, below) = (_shortest(element.field, p) for p in (element.above, element.below))
    number = top / bottom
    if below == 1 and above.is_Add and abs(number) != 1:
        return sympy.Mul(number, above, evaluate=False)  # sympy would multiply the number into the sum
    return sympy.Mul(number, above, sympy.Pow(below, -1))


def root(element: Element, degree: int) -> Element:
    """The real square root (of an element that is nowhere negative) or cube root, adjoined if need be.

    Powers with an evident root come out of it, a square only if its root is evidently positive.

    >>> field = Field()
    >>> t = field.generator(sympy.Symbol("t", real=True))
    >>> expression(root(4 * (t**2 + 1) ** 2, 2)), expression(root((t - 1) ** 2 * t**4, 2))
    (2*(t**2 + 1), t**2*Abs(t - 1))
    >>> expression(root(-16 * t**4 / (t**2 + 1) ** 2, 3))
    -2*2**(1/3)*t*cbrt(t)/(t**2 + 1)**(2/3)
    """
    field = element.field
    (top, upper), (bottom, lower) = (_factors(field, p) for p in (element.above, element.below))
    outer, inner = _number_root(
        Fraction(int(top.p), int(top.q)) / Fraction(int(bottom.p), int(bottom.q)), degree
    )
    outside, inside = field.number(outer), field.number(inner)
    symbols = [sympy.Pow(sympy.Integer(abs(inner)), sympy.Rational(1, degree))]
    signless: Factors = []
    for factor, exponent in [*upper, *((factor, -exponent) for factor, exponent in lower)]:
        base = Element(field, factor, field.one)
        positive = _is_positive(field, factor)
        # Of f² the square root is |f|, so only fourth powers come out; 1/f² stays 1/|f|.
        whole = exponent // degree if positive or degree == 3 else 2 * int(exponent / 4)
        rest = exponent - degree * whole
        outside, inside = outside * base**whole, inside * base**rest
        if positive:
            symbols.append(_plain(field, factor) ** sympy.Rational(rest, degree))
        else:
            signless.append((factor, rest))
    if inside == 1:
        return outside
    remaining = sympy.Mul(*(power**exponent for power, exponent in _merged(field, signless)))
    remaining = -remaining if inner < 0 else remaining
    symbols.append(sympy.sqrt(remaining) if degree == 2 else cbrt(remaining))
    return outside * field.generator(sympy.Mul(*symbols), degree, inside, cleared=False)


def _number_root(q: Fraction, degree: int) -> tuple[Fraction, int]:
    """(a, b) with q = b*aᵈ, b an integer without d-th powers of small primes, b >= 0 if d is odd."""
    outer, inner = Fraction(1, q.denominator), q.numerator * q.denominator ** (degree - 1)
    if inner < 0 and degree % 2:
        outer, inner = -outer, -inner
    for prime in SMALL_PRIMES:
        while inner and inner % prime**degree == 0:
            outer, inner = outer * prime, inner // prime**degree
    whole, exact = sympy.integer_nthroot(abs(inner), degree)
    return (outer * int(whole), 1) if exact and inner > 0 else (outer, inner)


def _shortest(field: Field, polynomial: Any) -> tuple[sympy.Expr, sympy.Expr]:
    """(content, expression) of a polynomial; the expression factored or expanded."""
    content, factors = _factors(field, polynomial)
    number = sympy.Rational(int(content.p), int(content.q))
    product = sympy.Mul(*(base**exponent for base, exponent in _merged(field, factors)))
    if number == 0 or len(polynomial) > PRINTED_TERMS:
        return number, product
    expanded = _plain(field, polynomial / content)
    return number, expanded if expanded.count_ops() < EXPANDED * product.count_ops() else product


def _factors(field: Field, polynomial: Any) -> tuple[Any, Factors]:
    """Content and primitive factors, each with its exponent and with the sign in which it reads best."""
    if len(polynomial) > FACTOR_TERMS or polynomial.total_degree() > FACTOR_DEGREE:
        content, factors = _powers_split_off(polynomial)
    else:
        content, factors = polynomial.factor()
    result = []
    for factor, power in factors:
        exponent, unit = int(power), _unit(factor)
        content *= unit**exponent
        result.append((factor / unit, exponent))
    return content, result


def _powers_split_off(polynomial: Any) -> tuple[Any, Factors]:
    """Content and factors as `factor` gives them, but only what divides every term is told from the rest."""
    powers = [min(map(int, column)) for column in zip(*polynomial.monoms())]
    found = [(generator, k) for generator, k in zip(polynomial.context().gens(), powers) if k]
    for generator, k in found:
        polynomial = polynomial / generator**k
    if polynomial.is_constant():
        return polynomial.leading_coefficient(), found
    return fmpq(1), [*found, (polynomial, 1)]


def _unit(polynomial: Any) -> Any:
    """The number to divide by for coprime integer coefficients that are mostly positive.

    If as many are negative, the first is made positive in a polynomial in t and the last in any other.
    """
    coefficients = polynomial.coeffs()
    below = lcm(*(int(c.q) for c in coefficients))
    size = fmpq(gcd(*(int(c.p) * below // int(c.q) for c in coefficients)), below)
    positive = sum(c > 0 for c in coefficients)
    in_t = any(polynomial.degrees()[:1])
    leading = coefficients[0 if in_t else -1]
    upright = leading > 0 if 2 * positive == len(coefficients) else 2 * positive > len(coefficients)
    return size if upright else -size


def _merged(field: Field, factors: Factors) -> Iterator[tuple[sympy.Expr, int]]:
    """Factors as expressions, where a kernel's relation is undone: (1 − cos)(1 + cos) is sin²."""
    left = dict(enumerate(exponent for _, exponent in factors))
    for generator in field.generators:
        if generator.degree != 2 or generator.power is None or generator.power.below != field.one:
            continue
        content, parts = _factors(field, generator.power.above)
        places = _places([part for part, _ in parts], [factor for factor, _ in factors])
        if content not in {1, -1} or len(parts) < 2 or None in places or any(e > 1 for _, e in parts):
            continue
        exponents = sorted((left[place] for place in places if place is not None), key=abs)
        often = exponents[0] if exponents[0] * exponents[-1] > 0 else 0
        for place in places:
            if place is not None:
                left[place] -= often
        yield int(content.p) * generator.symbol**2, often  # content is ±1
    for index, exponent in left.items():
        yield _plain(field, factors[index][0]), exponent


def _places(parts: list[Any], factors: list[Any]) -> list[int | None]:
    return [next((i for i, factor in enumerate(factors) if factor == part), None) for part in parts]


def _plain(field: Field, polynomial: Any) -> sympy.Expr:
    """The sympy expression of a polynomial, expanded; UndecidedError for one that nobody would read."""
    if len(polynomial) > PRINTED_TERMS:
        raise UndecidedError(f"An expression has more than {PRINTED_TERMS} terms.")
    symbols = [generator.symbol for generator in field.generators]
    terms: Iterable[sympy.Expr] = (
        sympy.Rational(int(c.p), int(c.q)) * prod(s**e for s, e in zip(symbols, m) if e)
        for m, c in polynomial.to_dict().items()
    )
    return sympy.Add(*terms)


def _is_positive(field: Field, polynomial: Any) -> bool:
    return len(polynomial) <= 12 and bool(_plain(field, polynomial).is_positive)
