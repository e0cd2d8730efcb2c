"""Values of invariants at one parameter value, to any number of digits, for curves of any dimension."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError

if TYPE_CHECKING:
    from osculant.cas.formulas.expression import Node
    from osculant.cas.jets.jet import Invariant
    from osculant.cas.numbers.balls import FormulaBalls

#: digits that may be asked for; Python converts no integer of more than 4300 digits to text
MOST_DIGITS = 4000
#: bits spent beyond the digits asked for at first, and how often they are doubled
GUARD, DOUBLINGS = 64, 6


def invariants_to_digits(
    curve: FormulaBalls[Any], at: Node, digits: int, invariants: Sequence[Invariant], order: int
) -> dict[str, Any]:
    """The invariants at a constant, as mpmath numbers by name.

    Args:
        curve: in ball arithmetic.
        at: the parameter value, a constant formula.
        digits: that shall be certain.
        invariants: what to evaluate.
        order: of the jets that they need.

    The balls around them are made narrower until ``digits`` digits are certain. A value whose ball still
    contains 0 with more than 2000 bits is returned as 0; None stands for what does not exist (or cannot be
    told from it) at this point. Vectors are tuples, frames tuples of them.

    Raises DomainError where the curve has not so many finite derivatives, or for a silly number of digits.
    """
    from osculant.cas.formulas.expression import to_text
    from osculant.cas.numbers.balls import constant, precision

    if not 1 <= digits <= MOST_DIGITS:
        raise DomainError(f"{digits} digits cannot be given: ask for 1 to {MOST_DIGITS}.")
    balls: dict[str, Any] = {}
    bits = int(3.33 * digits) + GUARD
    for _ in range(DOUBLINGS):
        with precision(bits):
            t = constant(at)
            if not all(value.is_finite() for row in curve.coefficients(t, order) for value in row):
                raise DomainError(
                    f"The curve has no finite derivatives at t = {to_text(at)} ({curve.explain(t)}): "
                    "choose another point."
                )
            jet = curve.jet(t, order)
            balls = {invariant.name: invariant.of(jet) for invariant in invariants}
            if all(_certain(part, digits) for value in balls.values() for part in _parts(value)):
                break
        bits *= 2
    return {name: _number(value, digits) for name, value in balls.items()}


def _parts(value: Any) -> Iterator[Any]:
    """The numbers of a vector or frame."""
    if isinstance(value, tuple):
        for part in value:
            yield from _parts(part)
    elif value is not None:
        yield value


def _certain(ball: Any, digits: int) -> bool:
    return bool(ball.is_finite() and (ball == 0 or ball.rel_accuracy_bits() > 3.33 * digits + 2))


def _number(value: Any, digits: int) -> Any:
    import mpmath

    if isinstance(value, tuple):
        parts = tuple(_number(part, digits) for part in value)
        return None if None in parts else parts
    if value is None or not value.is_finite():
        return None
    if value.contains(0):
        return mpmath.mpf(0)
    with mpmath.workdps(digits):
        return mpmath.mpf(value.mid().str(digits + 5, radius=False))
