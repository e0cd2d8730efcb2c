"""What the jets of plane and of space curves share: derivatives, roots, quotients, and their errors."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

from osculant.cas.errors import DomainError
from osculant.cas.numbers.fields import field_of

Root = Callable[[Any, int], Any]


def real_root(value: Any, degree: int) -> Any:
    """The real square root (degree 2) or the real cube root (degree 3), in the kind of number of the value.

    Floats, mpmath numbers and python-flint balls; integers become floats, sympy expressions stay exact. The
    cube root of a negative number is negative; the square root of one is the number system's own affair.

    >>> real_root(-8.0, 3), real_root(9, 2)
    (-2.0, 3.0)
    """
    return field_of(value).function("sqrt" if degree == 2 else "cbrt")(value)


def natural_power(value: Any, exponent: int) -> Any:
    """A product, since a ball around 0 has no `**`: flint takes it for exp(n log x).

    >>> natural_power(2, 3), natural_power(2, 0)
    (8, 1)
    """
    result = value if exponent else value * 0 + 1
    for _ in range(exponent - 1):
        result = result * value
    return result


class Jet:
    """A curve's derivatives at one parameter value.

    Args:
        coordinates: for every coordinate its derivatives, not divided by factorials, of one order.
        root: ``root(value, degree)``, the real roots of such numbers.

    Raises DomainError for coordinates of unequal orders, for a derivative that is not there, and where a
    quotient has the denominator 0 and the numbers refuse that, as rationals and floats do; sympy and balls
    have values of their own for it.
    """

    #: a form that is zero exactly where κ = 0, or where the curve is singular
    inflection_form: Any

    def __init__(self, coordinates: Sequence[Sequence[Any]], root: Root) -> None:
        self.coordinates = tuple(tuple(coordinate) for coordinate in coordinates)
        self.root = root
        orders = [len(coordinate) - 1 for coordinate in self.coordinates]
        if len(set(orders)) > 1:
            found = ", ".join(map(str, orders))
            raise DomainError(f"The coordinates of a jet have one order, not {found}: cut or extend them.")

    def _need(self, *orders: int) -> None:
        """Refuse derivatives that the jet does not have."""
        known = len(self.coordinates[0]) - 1
        if max(orders) > known:
            raise DomainError(
                f"The jet has order {known}, and the derivative of order {max(orders)} is needed: add it."
            )

    def _ratio(self, above: Any, below: Any) -> Any:
        """A quotient; where the denominator is 0 the message says of the curve what that means."""
        try:
            return above / below
        except ZeroDivisionError:
            reason = "speed is 0, so the curve is singular" if self.speed_squared == 0 else "curvature is 0"
            raise DomainError(f"An invariant does not exist here: the {reason}.") from None

    def point(self, order: int) -> tuple[Any, ...]:
        """The derivative of that order, a vector."""
        self._need(order)
        return tuple(coordinate[order] for coordinate in self.coordinates)

    def dot(self, i: int, j: int) -> Any:
        """⟨ij⟩ = ⟨α⁽ⁱ⁾, α⁽ʲ⁾⟩."""
        first, *rest = (a * b for a, b in zip(self.point(i), self.point(j), strict=True))
        return sum(rest, first)

    @cached_property
    def speed_squared(self) -> Any:
        """|α̇|² = ⟨11⟩: zero exactly at cusps and other singular points."""
        return self.dot(1, 1)

    @cached_property
    def speed(self) -> Any:
        """ds/dt = |α̇|."""
        return self.root(self.speed_squared, 2)


@dataclass(frozen=True)
class Invariant:
    """How an invariant of a jet is called and where it exists.

    name: of the attribute; title: in words; latex: its symbol; text: the symbol without LaTeX;
    exists: on regular points, or only where also κ ≠ 0, or everywhere.
    """

    name: str
    title: str
    text: str
    latex: str
    exists: Literal["everywhere", "regular", "curved"]

    def of(self, jet: Jet) -> Any:
        """The value at the jet, a pair for a vector; None where it does not exist (an exact zero below)."""
        singular = self.exists != "everywhere" and jet.speed_squared == 0
        straight = self.exists == "curved" and jet.inflection_form == 0
        return None if singular or straight else getattr(jet, self.name)
