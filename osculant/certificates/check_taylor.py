"""Taylor coefficients of functions, for the checker: rational, or of the number field of a certificate."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from osculant.certificates.check_numbers import Algebraic, current
from osculant.certificates.check_text import require


def taylor(name: str, at: Any, order: int) -> list[Any]:
    """The Taylor coefficients of a function at a point where they are of the field; RejectedError elsewhere.

    >>> taylor("exp", Fraction(0), 3)[3], taylor("^1/2", Fraction(4), 1)
    (Fraction(1, 6), [Fraction(2, 1), Fraction(1, 4)])
    """
    if name in {"sqrt", "cbrt"}:
        name = "^1/2" if name == "sqrt" else "^1/3"
    if name.startswith("^"):
        return _binomial(Fraction(name[1:]), at, order)
    if name == "log":
        require(at == 1, f"log has no rational value at {at}")
        return [Fraction(0), *(Fraction((-1) ** (k + 1), k) for k in range(1, order + 1))]
    require(at == 0, f"{name} has no rational value at {at}")
    factorial = [Fraction(1)]
    for k in range(1, order + 2):
        factorial.append(factorial[-1] / k)
    if name == "exp":
        return factorial[: order + 1]
    odd = {"sin": -1, "sinh": 1, "cos": -1, "cosh": 1}
    if name in odd:
        first = int(name.startswith("sin"))
        return [
            factorial[k] * odd[name] ** (k // 2) if k % 2 == first else Fraction(0) for k in range(order + 1)
        ]
    if name in {"tan", "tanh"}:  # y′ = 1 ± y²
        sign, y = (1 if name == "tan" else -1), [Fraction(0)]
        for k in range(order):
            square = sum((y[i] * y[k - i] for i in range(k + 1)), Fraction(0))
            y.append((int(k == 0) + sign * square) / (k + 1))
        return y
    # the derivative is (1 ± x²) to a power
    inverse = {"atan": (1, Fraction(-1)), "atanh": (-1, Fraction(-1))}
    inverse |= {"asin": (-1, Fraction(-1, 2)), "asinh": (1, Fraction(-1, 2))}
    require(name in inverse, f"{name} is no function that the checker reads")
    sign, exponent = inverse[name]
    outer = _binomial(exponent, Fraction(1), order)
    found = [Fraction(0)] * (order + 1)
    for k, c in enumerate(outer):
        if 2 * k + 1 <= order:
            found[2 * k + 1] = c * sign**k / (2 * k + 1)
    return found


def _binomial(e: Fraction, at: Any, order: int) -> list[Any]:
    require(at != 0, "a power that is not analytic at 0")
    root = _root(at, e.denominator)
    found: list[Any] = [root**e.numerator]
    for k in range(order):
        found.append(found[-1] * (e - k) / ((k + 1) * at))
    return found


def _root(value: Any, degree: int) -> Any:
    """The root of that degree, rational or of the field."""
    field = current()
    if degree == 1:
        return value
    if isinstance(value, Algebraic):
        return value.field.root(value, degree)
    negative = value < 0 and degree % 2 == 1
    require(value > 0 or negative, f"no root of {value}")
    parts = []
    for part in (abs(value.numerator), value.denominator):
        root = _whole_root(part, degree)
        if root**degree != part and field is not None:
            return field.root(value, degree)
        require(root**degree == part, f"the root of {value} is not rational")
        parts.append(root)
    return Fraction(*parts) * (-1 if negative else 1)


def _whole_root(value: int, degree: int) -> int:
    """The largest whole number whose power is at most a positive one."""
    if degree == 1:
        return value
    low, high = 1, 1 << (value.bit_length() // degree + 1)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle**degree <= value else (low, middle)
    return low
