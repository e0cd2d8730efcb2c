"""What the checks of claims are made of: reading forms, proving identities, comparing numbers and balls."""

from __future__ import annotations

import random
import re
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from operator import and_
from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence
from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.parser import parse, parse_tuple
from osculant.cas.formulas.sympy_bridge import to_sympy

#: random points at which a form is tried before it is proved, the digits used and those that must vanish
TRIALS, DIGITS, VANISHING = 3, 60, 40
#: characters of an identity that is shown
LONGEST = 160


def read(form: str, symbols: Mapping[str, Any]) -> Any:
    """The form's text as a sympy expression in the given symbols (any sympy expressions, by name).

    >>> x = sp.Symbol("x", positive=True)
    >>> read("a**2 + 1", {"a": sp.sqrt(x)})
    x + 1
    """
    return _insert(parse(form, tuple(symbols)), symbols)


def read_tuple(form: str, symbols: Mapping[str, Any], count: int | None = None) -> tuple[Any, ...]:
    """The same for several expressions separated by commas.

    Raises DomainError if there are not ``count`` of them.

    >>> read_tuple("a, 2", {"a": sp.Symbol("a")}, 2)
    (a, 2)
    """
    parts = parse_tuple(form, tuple(symbols))
    if count is not None and len(parts) != count:
        raise DomainError(f"The form {form!r} has {len(parts)} part{'s'[: len(parts) != 1]}: give {count}.")
    return tuple(_insert(node, symbols) for node in parts)


def integers(form: str, count: int | None = None) -> tuple[int, ...]:
    """Integers separated by commas. Raises DomainError for other numbers, or if there are not ``count``.

    >>> integers("4, 2 + 3")
    (4, 5)
    """
    return tuple(integer(part) for part in read_tuple(form, {}, count))


def integer(part: Any) -> int:
    """A part of a form that must be an integer, such as an order. Raises DomainError for others.

    >>> integer(sp.Integer(3))
    3
    """
    if not part.is_Integer:
        raise DomainError(f"An integer is expected in the form, not {part}.")
    return int(part)


def order(part: Any) -> int:
    """A part of a form that is the order of a remainder. Raises DomainError for what is no integer ≥ 1.

    >>> order(sp.Integer(3))
    3
    """
    if integer(part) < 1:
        raise DomainError(f"The order of a remainder is 1 at least, not {part}.")
    return int(part)


def split(form: str, count: int) -> list[str]:
    """The texts between a form's commas. Raises DomainError if there are not ``count``.

    >>> split("-1, pi", 2)
    ['-1', 'pi']
    """
    parts = [part.strip() for part in form.split(",")]
    if len(parts) != count:
        raise DomainError(f"The form {form!r} has {len(parts)} part{'s'[: len(parts) != 1]}: give {count}.")
    return parts


def rounding(form: str, digits: int) -> tuple[Fraction, Fraction]:
    """A decimal number and half a unit of its last digit.

    Raises DomainError for other texts, and for a number with less than ``digits`` digits after the point.

    >>> rounding("0.25", 2)
    (Fraction(1, 4), Fraction(1, 200))
    """
    given = len(form.partition(".")[2])
    try:
        value = Fraction(form)
    except ValueError:
        raise DomainError(f"A decimal number is expected, not {form!r}.") from None
    if given < digits:
        raise DomainError(f"A number with {digits} digits after the point is expected, not {form!r}.")
    return value, Fraction(1, 2) / 10**given


def positive(expression: Any, what: str) -> Evidence:
    """Whether an expression in positive symbols is positive at a point.

    That decides its sign everywhere if its square is known and not 0.

    >>> x = sp.Symbol("x", positive=True)
    >>> bool(positive(x**2, "x²")), bool(positive(-x, "−x"))
    (True, False)
    """
    source = random.Random(20100)
    point = {symbol: _sample(symbol, source) for symbol in sorted(expression.free_symbols, key=str)}
    value = sp.N(expression, DIGITS, subs=point)
    at = ", ".join(f"{s} = {q}" for s, q in point.items()) or "every point"
    return Evidence(bool(value.is_positive), (f"{what} is {sp.N(value, 6)} at {at}",))


def _insert(node: Any, symbols: Mapping[str, Any]) -> Any:
    expression = to_sympy(node)
    return expression.subs({s: symbols[s.name] for s in expression.free_symbols}, simultaneous=True)


def vanishes(expression: Any, what: str, relations: Sequence[tuple[Any, Any]] = ()) -> Evidence:
    """Proof that an expression is 0 for all values of its symbols, or a point where it is not.

    Args:
        expression: a sympy expression; symbols declared positive (integer) are tried at positive (integer)
            values only.  Functions without a definition and their derivatives, f(t), f'(t), …, are taken
            for independent symbols: that is what an identity for all functions means.
        what: what the expression is the difference of, for the certificate.
        relations: pairs (polynomial, symbol): the polynomial is 0, and is divided out as one in the symbol.
            Relations make the free trial points invalid, so then only the division decides.

    Raises UndecidedError if it vanishes at the trial points but no proof is found, DomainError if relations
    are to be divided out of what is no polynomial.

    >>> a, b = sp.symbols("a b")
    >>> vanishes((a + b) ** 2 - a**2 - 2 * a * b - b**2, "binomial").certificate
    ('binomial: -a^2 - 2 a b - b^2 + (a + b)^2 = 0 identically',)
    >>> bool(vanishes(a - b, "a = b"))
    False
    """
    expression = _without_functions(sp.sympify(expression))
    if expression.has(sp.zoo):
        return Evidence(False, (f"{what}: one side is infinite",))
    if not relations:
        refuted = _counterexample(expression)
        if refuted is not None:
            point, value = refuted
            at = ", ".join(f"{s} = {q}" for s, q in point.items()) or "every point"
            return Evidence(False, (f"{what}: both sides differ by {sp.N(value, 12)} at {at}",))
    if _is_zero(expression, relations):
        return Evidence(True, (f"{what}: {_shown(expression)} = 0 identically{_modulo(relations)}",))
    if relations:
        return Evidence(False, (f"{what}: both sides differ modulo the relations",))
    raise UndecidedError(f"{what}: both sides agree at random points, but no proof was found.")


def _shown(expression: Any) -> str:
    """The difference of both sides as it was before it was simplified, or how long it is."""
    if expression == 0:
        return "the difference of both sides"
    text = re.sub(r"(?<=\w|\))\*(?=\w|\()", " ", str(expression).replace("**", "^"))
    if len(text) <= LONGEST:
        return text
    return f"the difference of both sides, an expression of {sp.count_ops(expression)} operations,"


def _modulo(relations: Sequence[tuple[Any, Any]]) -> str:
    return " modulo the relations" if relations else ""


def _without_functions(expression: Any) -> Any:
    """The expression with f(t) and its derivatives for undefined functions f as symbols of that name."""
    expression = expression.doit() if expression.has(sp.Derivative) else expression
    unknown = expression.atoms(sp.core.function.AppliedUndef)
    jets = [d for d in expression.atoms(sp.Derivative) if d.expr in unknown]
    return expression.xreplace(
        {jet: sp.Symbol(str(jet), positive=jet.is_positive) for jet in (*jets, *unknown)}
    )


def _counterexample(expression: Any) -> tuple[dict[Any, Any], Any] | None:
    """A point where the expression has a value and that is not 0; points without a value do not count."""
    source = random.Random(20100)
    symbols = sorted(expression.free_symbols, key=str)
    for _ in range(TRIALS):
        point = {symbol: _sample(symbol, source) for symbol in symbols}
        value = sp.N(expression, DIGITS, subs=point)
        if value.is_number and value.is_finite and abs(value) > sp.Float(10) ** -VANISHING:
            return point, value
    return None


def _sample(symbol: Any, source: random.Random) -> Any:
    sign = 1 if symbol.is_positive or symbol.is_nonnegative else source.choice((1, -1))
    size = source.randint(20, 90)
    return sp.Integer(sign * size) if symbol.is_integer else sp.Rational(sign * size, 71)


def _is_zero(expression: Any, relations: Sequence[tuple[Any, Any]]) -> bool:
    numerator = sp.expand(sp.numer(sp.together(expression)))
    for polynomial, symbol in relations:
        try:
            numerator = sp.expand(sp.rem(numerator, polynomial, symbol))
        except sp.polys.polyerrors.BasePolynomialError as failed:
            raise DomainError(f"The difference of both sides is no polynomial in {symbol}.") from failed
    if numerator == 0 or sp.expand(sp.powsimp(numerator, force=True)) == 0:
        return True
    return not relations and sp.simplify(expression) == 0


def agrees(value: Any, expected: Any, digits: float, what: str) -> Evidence:
    """Whether two numbers agree to a relative 10^−digits; with 0 only if that is not the expected one.

    The comparison carries 15 digits more than are wanted; a float has no more than its own 16. Raises
    DomainError for a text that is no number.

    >>> agrees(3.14159, 22 / 7, 3, "pi").certificate
    ('pi: 3.14159 against 3.14285714286, relative difference 4.0e-4 (wanted 1e-3)',)
    """
    import mpmath as mp

    with mp.workdps(max(15, int(digits)) + 15):
        value, expected = _number(value), _number(expected)
        difference = abs(value / expected - 1) if expected else mp.inf
        line = (
            f"{what}: {mp.nstr(value, 12)} against {mp.nstr(expected, 12)}, relative difference "
            f"{_power_of_ten(difference)} (wanted 1e-{digits:g})"
        )
        return Evidence(bool(difference <= mp.mpf(10) ** -digits), (line,))


def _number(value: Any) -> Any:
    import mpmath as mp

    try:
        return mp.mpf(value)
    except ValueError:
        raise DomainError(f"{value!r} is no number.") from None


def _power_of_ten(x: Any) -> str:
    import mpmath as mp

    return "0" if x == 0 else mp.nstr(x, 2, min_fixed=0, max_fixed=0)


def encloses(ball: Any, expected: Any, what: str) -> Evidence:
    """Whether a python-flint ball contains a number given as a ball or rational, and is narrow (1e-6).

    >>> from flint import arb
    >>> bool(encloses(arb(2).sqrt() ** 2, arb(2), "√2²"))
    True
    """
    narrow = float(ball.rad()) <= 1e-6 * max(1e-300, abs(float(ball.mid())))
    line = f"{what}: {ball.str(20)} against {expected!s}"
    return Evidence(bool(narrow and (ball - expected).contains(0)), (line,))


def all_of(evidence: Iterable[Evidence]) -> Evidence:
    """The conjunction of some evidence, at least one piece."""
    return reduce(and_, evidence)
