"""What the checker reads: formulas and numbers, exactly and bounded, by Python's grammar but never run."""

from __future__ import annotations

import ast
import keyword
import re
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

#: characters of a formula, digits of a number and size of a decimal's exponent at most
LONGEST, DIGITS, EXPONENT = 1_000_000, 4000, 4000
#: what certificates may take in all: products of terms, and places of tables
WORK = 100_000_000

TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(?![\w.])|(?P<name>[^\W\d]\w*)|(?P<sign>\*\*|[-+*/^()]))"
)
RATIONAL = re.compile(r"-?\d+(/\d+)?")


class RejectedError(ValueError):
    """A certificate that does not prove what it says; the message tells the first step that fails."""


def require(condition: bool, complaint: str) -> None:
    """Raise RejectedError with the complaint unless the condition holds."""
    if not condition:
        raise RejectedError(complaint)


class Work:
    """What checking one certificate may still take."""

    left = WORK

    @classmethod
    def begin(cls) -> None:
        """A new certificate."""
        cls.left = WORK

    @classmethod
    def spend(cls, amount: int) -> None:
        """Raises RejectedError if so much more is too much."""
        cls.left -= amount
        require(cls.left >= 0, "it takes more work than the checker does")


def parsed(text: Any, names: Sequence[str]) -> ast.expr:
    """The tree of a formula in which the variables are called v0, v1, … and decimals are quotients.

    Raises RejectedError for what is no such formula.

    >>> ast.unparse(parsed("2.5*in^2", ["in"]))
    '5 / 2 * v0 ** 2'
    """
    require(isinstance(text, str) and len(text) <= LONGEST, "a formula that is no text, or too long")
    pieces, at, text = list[str](), 0, text.strip()
    while at < len(text):
        found = TOKEN.match(text, at)
        require(found is not None, f"{text[:60]!r} is no formula")
        assert found is not None
        at = found.end()
        if found["number"]:
            value = _decimal(found["number"])
            pieces.append(str(value) if value.denominator == 1 else f"({value})")
        elif found["name"] in names:
            pieces.append(f"v{list(names).index(found['name'])}")
        elif found["name"]:
            called = text[at:].lstrip().startswith("(") and not keyword.iskeyword(found["name"])
            require(called, f"{found['name'][:60]!r} is no variable")
            pieces.append(found["name"])
        else:
            pieces.append("**" if found["sign"] == "^" else found["sign"])
    try:
        return ast.parse(" ".join(pieces), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise RejectedError(f"{text[:60]!r} is no formula") from None


def _decimal(written: str) -> Fraction:
    """A number as it is written, exactly."""
    size = re.search(r"[eE]([+-]?\d{1,9})$", written)
    require(len(written) <= DIGITS, "a number with too many digits")
    require("e" not in written.lower() or bool(size and abs(int(size[1])) <= EXPONENT), "a number too large")
    return Fraction(written)


def rational(value: Any) -> Fraction:
    """A number of a certificate: whole, or the text of a quotient.

    >>> rational("-3/6"), rational(2)
    (Fraction(-1, 2), Fraction(2, 1))
    """
    if isinstance(value, int) and not isinstance(value, bool):
        return Fraction(value)
    known = isinstance(value, str) and len(value) <= LONGEST and RATIONAL.fullmatch(value)
    require(bool(known), f"{str(value)[:60]!r} is no rational number")
    return Fraction(value)
