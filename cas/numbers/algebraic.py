"""Real algebraic numbers by their polynomials: exact, with balls of any precision."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from osculant.cas.errors import DomainError, UndecidedError

#: decimals that tell apart the real roots of one polynomial; those of constants of laws are far apart
APART = 40


@dataclass(frozen=True)
class Algebraic:
    """A real root of an irreducible polynomial with integer coefficients.

    Attributes:
        coefficients: the highest first.
        index: of the root among the real ones, in increasing order.

    >>> root = Algebraic((1, 0, -2), 1)
    >>> root.number(), str(root)
    (CRootOf(x**2 - 2, 1), '1.4142135623731')
    """

    coefficients: tuple[int, ...]
    index: int

    def number(self) -> Any:
        """The root as a number of sympy's."""
        x = sp.Symbol("x")
        return sp.rootof(sp.Poly(self.coefficients, x), self.index, radicals=False)

    def ball(self) -> Any:
        """The root as a ball at flint's current precision."""
        from flint import arb, fmpz_poly

        near = arb(str(sp.N(self.number(), APART)))
        roots: Any = fmpz_poly([int(c) for c in reversed(self.coefficients)]).complex_roots()
        found = [root.real for root, _ in roots if root.imag == 0 and abs(root.real - near) < 1e-20]
        if len(found) != 1:
            raise UndecidedError(f"The root {near} of {self.coefficients} is not told from the others.")
        return found[0]

    def image(self, expression: Any, symbol: Any) -> Algebraic:
        """The value of a rational expression in the symbol at this number.

        >>> Algebraic((1, 0, -2), 1).image(sp.Symbol("z") + 1, sp.Symbol("z")).coefficients
        (1, -2, -1)
        """
        value = sp.Symbol("value")
        above, below = sp.fraction(sp.together(expression))
        own = sp.Poly(self.coefficients, symbol).as_expr()
        near = expression.subs(symbol, sp.N(self.number(), APART))
        return _nearest(sp.resultant(own, below * value - above, symbol), value, near)

    def __str__(self) -> str:
        return str(sp.N(self.number(), 14))


def algebraic(equation: Any, symbol: Any, between: tuple[Any, Any]) -> Algebraic:
    """The root of a polynomial with rational coefficients inside an interval.

    Raises DomainError unless there is one.

    >>> z = sp.Symbol("z")
    >>> algebraic(z**3 - 2, z, (0, 2)).coefficients
    (1, 0, 0, -2)
    """
    low, high = between
    _, factors = sp.factor_list(equation, symbol)
    found = []
    for factor, _ in factors:
        poly = sp.Poly(factor, symbol)
        for index, root in enumerate(poly.real_roots(radicals=False)):
            if low < root < high:
                found.append(Algebraic(tuple(int(c) for c in poly.clear_denoms()[1].all_coeffs()), index))
    if len(found) != 1:
        raise DomainError(f"{equation} has {len(found)} roots between {low} and {high}: one is needed.")
    return found[0]


def _nearest(polynomial: Any, symbol: Any, near: Any) -> Algebraic:
    """The root of a polynomial that is the number ``near``."""
    width = sp.Rational(1, 10 ** (APART // 2))
    middle = sp.Rational(str(near))
    return algebraic(polynomial, symbol, (middle - width, middle + width))
