"""What the checker reads: formulas and numbers, exactly and bounded, by Python's grammar but never run."""

from __future__ import annotations

import ast
import keyword
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from fractions import Fraction
from typing import Any

#: characters of a formula, digits of a number and size of a decimal's exponent at most
LONGEST, DIGITS, EXPONENT = 1_000_000, 4000, 4000
#: what certificates may take in all: products of terms, and places of tables
WORK = 100_000_000

TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(?![\w.])|(?P<name>[^\W\d]\w*)|(?P<sign>\*\*|[-+*/^()]))"
)
#: how the generator of a number field is called in trees
ROOT = "w0"
RATIONAL = re.compile(r"-?\d+(/\d+)?")


class RejectedError(ValueError):
    """A certificate that does not prove what it says; the message tells the first step that fails."""


def require(condition: bool, complaint: str) -> None:
    """Raise RejectedError with the complaint unless the condition holds."""
    if not condition:
        raise RejectedError(complaint)


#: what the certificate that is being checked may still take, if there is a bound
_left: ContextVar[list[int] | None] = ContextVar("_left", default=None)


@contextmanager
def limited(work: int = WORK) -> Iterator[None]:
    """A block that may take so much: beyond that `spend` rejects.

    >>> with limited(2):
    ...     spend(2)
    """
    token = _left.set([work])
    try:
        yield
    finally:
        _left.reset(token)


def spend(amount: int) -> None:
    """Count what is about to be done; RejectedError if the block `limited` does not allow so much more."""
    left = _left.get()
    if left is not None:
        left[0] -= amount
        require(left[0] >= 0, "it takes more work than the checker does")


def parsed(text: Any, names: Sequence[str], root: str | None = None) -> ast.expr:
    """The tree of a formula in which the variables are called v0, v1, … and decimals are quotients.

    A name of the root that generates the number field becomes `ROOT`.

    Raises RejectedError for what is no such formula.

    >>> ast.unparse(parsed("2.5*in^2", ["in"]))
    '5 / 2 * v0 ** 2'
    """
    require(isinstance(text, str) and len(text) <= LONGEST, "a formula that is no text, or too long")
    pieces, at, text = list[str](), 0, text.strip()
    while at < len(text):
        found = TOKEN.match(text, at)
        if found is None:
            raise RejectedError(f"{text[:60]!r} is no formula")
        at = found.end()
        if found["number"]:
            value = _decimal(found["number"])
            pieces.append(str(value) if value.denominator == 1 else f"({value})")
        elif root is not None and found["name"] == root:
            pieces.append(ROOT)
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
    require(len(written) <= DIGITS, "a number with too many digits")
    exponent = written.lower().partition("e")[2]
    require(abs(int(exponent or 0)) <= EXPONENT, "a number too large")
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
