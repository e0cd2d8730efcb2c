"""What the checks of claims are made of: reading forms, proving identities, comparing numbers and balls."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence
from osculant.cas.errors import UndecidedError
from osculant.cas.formula import parse, parse_tuple
from osculant.cas.sympy_bridge import to_sympy

#: random points at which a form is tried before it is proved, the digits used and those that must vanish
TRIALS, DIGITS, VANISHING = 3, 60, 40


def read(form: str, symbols: Mapping[str, Any]) -> Any:
    """The form's text as a sympy expression in the given symbols (any sympy expressions, by name).

    >>> x = sp.Symbol("x", positive=True)
    >>> read("a**2 + 1", {"a": sp.sqrt(x)})
    x + 1
    """
    return _insert(parse(form, tuple(symbols)), symbols)


def read_tuple(form: str, symbols: Mapping[str, Any]) -> tuple[Any, ...]:
    """The same for several expressions separated by commas."""
    return tuple(_insert(node, symbols) for node in parse_tuple(form, tuple(symbols)))


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

    Raises UndecidedError if it vanishes at the trial points but no proof is found.

    >>> a, b = sp.symbols("a b")
    >>> vanishes((a + b) ** 2 - a**2 - 2 * a * b - b**2, "binomial").certificate
    ('binomial: the difference of both sides is identically 0',)
    >>> bool(vanishes(a - b, "a = b"))
    False
    """
    expression = _without_functions(sp.sympify(expression))
    if not relations:
        refuted = _counterexample(expression)
        if refuted is not None:
            point, value = refuted
            at = ", ".join(f"{s} = {q}" for s, q in point.items()) or "every point"
            return Evidence(False, (f"{what}: both sides differ by {sp.N(value, 12)} at {at}",))
    if _is_zero(expression, relations):
        return Evidence(True, (f"{what}: the difference of both sides is identically 0",))
    if relations:
        return Evidence(False, (f"{what}: both sides differ modulo the relations",))
    raise UndecidedError(f"{what}: both sides agree at random points, but no proof was found.")


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
        numerator = sp.expand(sp.rem(numerator, polynomial, symbol))
    if numerator == 0 or sp.expand(sp.powsimp(numerator, force=True)) == 0:
        return True
    return not relations and sp.simplify(expression) == 0


def agrees(value: Any, expected: Any, digits: float, what: str) -> Evidence:
    """Whether two numbers agree to a relative 10^−digits; the expected one is not 0.

    The comparison carries 15 digits more than are wanted; a float has no more than its own 16.

    >>> agrees(3.14159, 22 / 7, 3, "pi").certificate
    ('pi: 3.14159 against 3.14285714286, relative difference 4.0e-4 (wanted 1e-3)',)
    """
    import mpmath as mp

    with mp.workdps(max(15, int(digits)) + 15):
        value, expected = mp.mpf(value), mp.mpf(expected)
        difference = abs(value / expected - 1)
        line = (
            f"{what}: {mp.nstr(value, 12)} against {mp.nstr(expected, 12)}, relative difference "
            f"{_power_of_ten(difference)} (wanted 1e-{digits:g})"
        )
        return Evidence(bool(difference <= mp.mpf(10) ** -digits), (line,))


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
