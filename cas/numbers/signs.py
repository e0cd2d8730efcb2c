"""The sign of an elementary function of one variable on an open interval, proved in ball arithmetic."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.sympy_bridge import from_sympy
from osculant.cas.numbers.balls import ball, constant, precision
from osculant.cas.numbers.fields import Balls
from osculant.cas.numbers.taylor import program

#: derivatives tried at an end where the function vanishes, halvings of the interval, and bits
ORDER, HALVINGS, BITS = 16, 24, 128


def sign_between(function: sp.Expr, variable: sp.Symbol, low: sp.Expr, high: sp.Expr) -> int:
    """The constant sign of a function on the open interval (low, high); the function may vanish at the ends.

    At an end where f, …, f⁽ⁿ⁻¹⁾ vanish exactly and f⁽ⁿ⁾ does not, the sign near it is that of f⁽ⁿ⁾ over a
    ball reaching inwards (Taylor's formula with remainder); between, the interval is halved until balls, by
    the mean value theorem, exclude 0.

    Args:
        function: an elementary expression in the variable alone.
        variable: its variable.
        low: the lower end, exact.
        high: the upper end, exact.

    Returns:
        1 or −1, proved; 0 if the function does not have one sign inside.

    Raises DomainError if the interval is empty, UndecidedError after `HALVINGS` halvings (as at a double zero
    inside) or `ORDER` vanishing derivatives.

    >>> x = sp.Symbol("x", real=True)
    >>> sign_between(sp.sin(x) - x * sp.cos(x), x, sp.Integer(0), sp.pi)
    1
    >>> sign_between(sp.cos(x), x, sp.Integer(0), sp.pi)
    0
    """
    low, high = sp.sympify(low), sp.sympify(high)
    if not sp.N(high - low) > 0:
        raise DomainError(f"The interval from {low} to {high} is empty: exchange its ends.")
    orders = _vanishing(function, variable, low), _vanishing(function, variable, high)
    node = from_sympy(function)
    steps = program([node], max(*orders, 1), variable.name)

    def derivative(at: Any, order: int) -> Any:
        return steps.run(at, Balls())[0][order]

    with precision(BITS):
        left, right = constant(from_sympy(low)), constant(from_sympy(high))
        inner_left, first = _near(derivative, orders[0], left, right)
        inner_right, last = _near(derivative, orders[1], right, left)
        last *= (-1) ** orders[1]
        if first != last:
            return 0
        return first if _keeps(derivative, first, inner_left, inner_right, HALVINGS) else 0


def _vanishing(function: sp.Expr, variable: sp.Symbol, end: sp.Expr) -> int:
    for order in range(ORDER):
        if sp.simplify(function.subs(variable, end)) != 0:
            return order
        function = sp.diff(function, variable)
    raise UndecidedError(f"{ORDER} derivatives vanish at {end}: no sign was found near it.")


def _near(derivative: Callable[[Any, int], Any], order: int, end: Any, other: Any) -> tuple[Any, int]:
    """How far from the end towards the other one that derivative keeps its sign, and the sign."""
    reach = (other - end) / 2
    for _ in range(HALVINGS):
        value = derivative(ball(end, end + reach), order)
        if value > 0 or value < 0:
            return end + reach, 1 if value > 0 else -1
        reach = reach / 2
    raise UndecidedError(f"The sign near {end} was not found in {HALVINGS} halvings.")


def _keeps(derivative: Callable[[Any, int], Any], sign: int, left: Any, right: Any, halvings: int) -> bool:
    if left >= right:
        return True
    middle, whole = (left + right) / 2, ball(left, right)
    value = sign * derivative(middle, 0)
    if value <= 0:
        return False
    if value + sign * derivative(whole, 1) * (whole - middle) > 0:
        return True
    if halvings == 0:
        raise UndecidedError(f"The sign near {middle} was not found in {HALVINGS} halvings.")
    return _keeps(derivative, sign, left, middle, halvings - 1) and _keeps(
        derivative, sign, middle, right, halvings - 1
    )
