"""Real roots of polynomials as numbers: rational, or the generator of a real number field; signs of such.

A field knows which real root its generator is by a ball in flint's precision, so its numbers have signs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import log
from typing import Any

from flint import arb_poly, ctx, fmpq_poly, fmpz_poly

from osculant.cas.errors import UndecidedError
from osculant.cas.formulas.expression import variable
from osculant.cas.germs.algebraic import Algebraic, NumberField, rational

#: the name of the generator of a field
NAME = "theta"
#: degree of a field at most
DEGREE = 6


def real_roots(coefficients: Sequence[Fraction]) -> Iterator[Any]:
    """The real roots of a polynomial without multiple roots, c₀ first: those of low degree first.

    Raises UndecidedError when a root of a factor of degree above `DEGREE` is reached.

    >>> [str(r) for r in real_roots([Fraction(v) for v in (2, -1, -2, 1)])]
    ['-1', '1', '2']
    >>> [sign(r) for r in real_roots([Fraction(v) for v in (-2, 0, 1)])]
    [-1, 1]
    """
    factors = [factor for factor, _ in fmpq_poly([rational(Fraction(c)) for c in coefficients]).factor()[1]]
    lines = (-factor[0] / factor[1] for factor in factors if factor.degree() == 1)
    yield from sorted(Fraction(int(r.p), int(r.q)) for r in lines)
    for factor in sorted((f for f in factors if f.degree() > 1), key=lambda f: int(f.degree())):
        whole = fmpz_poly([int(c * factor.denom()) for c in factor.coeffs()])
        for index in range(len(_balls(whole))):
            if factor.degree() > DEGREE:
                raise UndecidedError(
                    f"The coordinates need a number of degree {factor.degree()}: up to {DEGREE} is built."
                )
            yield NumberField(factor, variable(NAME), _Ball(whole, index)).generator


class _Ball:
    """A ball around the real root with that index, from below, in flint's precision."""

    def __init__(self, polynomial: Any, index: int) -> None:
        self.polynomial, self.index = polynomial, index

    def __call__(self) -> Any:
        return _balls(self.polynomial)[self.index]


def _balls(polynomial: Any) -> list[Any]:
    found = [root.real for root, _ in polynomial.complex_roots() if root.imag == 0]
    return sorted(found, key=lambda ball: float(ball.mid()))


def sign(value: Any) -> int:
    """The sign of a rational number or of a number of a real field.

    >>> sign(Fraction(-1, 2)), sign(0)
    (-1, 0)
    """
    if not isinstance(value, Algebraic):
        return int(value > 0) - int(value < 0)
    return 1 if _ball(value, 1) > 0 else -1


def logarithm(value: Any) -> float:
    """The logarithm of a positive number, however large or small.

    >>> logarithm(Fraction(2**5000, 2**4999)) == log(2)
    True
    >>> round(logarithm(next(real_roots([Fraction(v) for v in (-2, 0, 0, 1)]))), 12)
    0.231049060187
    """
    if not isinstance(value, Algebraic):
        return log(value.numerator) - log(value.denominator)
    kept, ctx.prec = ctx.prec, 64
    try:
        return float(_ball(value, 60).log().mid())
    finally:
        ctx.prec = kept


def _ball(value: Algebraic, bits: int) -> Any:
    """A ball around a number of a real field that is known to so many bits."""
    if value.field.real is None:
        raise UndecidedError("A number of a field that is not told to be real has no sign.")
    kept, precision = ctx.prec, 64
    try:
        while True:  # the number is not 0
            ctx.prec = precision
            ball = arb_poly(value.value)(value.field.real())
            if ball.rel_accuracy_bits() >= bits and not ball.contains(0):
                return ball
            precision *= 2
    finally:
        ctx.prec = kept


def size(value: Any) -> Any:
    """The absolute value."""
    return -value if sign(value) < 0 else value
