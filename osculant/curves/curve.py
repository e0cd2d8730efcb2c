"""What curves given by formulas have in common: their coordinates and their interval."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any, ClassVar

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas.expression import Node, number, to_text
from osculant.cas.formulas.parser import parse, parse_constant, parse_tuple

#: characters of a constant shown in messages
LONGEST_SHOWN = 40
#: intervals shorter than this part of their ends are beyond doubles
RESOLVED = 1e-13
#: digits of values if nothing else is asked for
DIGITS = 15


def as_constant(value: Any, argument: str) -> Node:
    """An end of an interval or another constant, exactly: a formula as text, a number, or sympy's.

    Floats are read as the decimal they print as.  Raises FormulaError, naming the ``argument``.

    >>> to_text(as_constant("2*pi", "high"))
    '2*pi'
    """
    if isinstance(value, Node):
        return value
    if isinstance(value, str):
        try:
            return parse_constant(value)
        except FormulaError as error:
            raise FormulaError(f"{argument}: {error}", argument=argument) from None
    if isinstance(value, float):
        if not math.isfinite(value):
            raise FormulaError(
                f"{argument} is {value}: give a finite number or a formula such as 2*pi.", argument=argument
            )
        return number(Fraction(repr(value)))
    if isinstance(value, (int, Fraction)):
        return number(Fraction(value))
    from osculant.cas.formulas.sympy_bridge import from_sympy

    return from_sympy(value)


class FormulaCurve:
    """A curve t ↦ (x(t), …) on a closed interval; `dimension` tells how many coordinates it has.

    Args:
        coordinates: text such as ``"t, t^2"``, or sympy or symengine expressions in t.
        low, high: the ends of the interval, as text, numbers or sympy constants; without them the curve
            has its invariants, but nothing can be approximated.

    Raises FormulaError for text that is no formula or has another number of coordinates, DomainError for an
    interval that is empty or reversed. Singular points are found when they matter, not here.
    """

    #: number of coordinates, what such a curve is called, and an example
    dimension: ClassVar[int]
    called: ClassVar[str]
    example: ClassVar[str]

    def __init__(self, coordinates: Any, low: Any = None, high: Any = None) -> None:
        self.coordinates = coordinates_of(coordinates)
        if len(self.coordinates) != self.dimension:
            raise FormulaError(
                f"A {self.called} curve has {_NUMBERS[self.dimension]} coordinates, such as "
                f"{self.example!r}; this formula has {len(self.coordinates)}."
            )
        self.text = ", ".join(to_text(c) for c in self.coordinates)
        if (low is None) != (high is None):
            raise DomainError("A curve needs both ends of its interval, or neither.")
        self._ends = None if low is None else (as_constant(low, "low"), as_constant(high, "high"))
        if self._ends is not None:
            self._check_interval(*self._ends)

    def _check_interval(self, low: Node, high: Node) -> None:
        from osculant.cas.numbers.balls import PRECISION, constant, precision

        with precision(PRECISION):
            a, b = constant(low), constant(high)
            for name, value, node in (("low", a, low), ("high", b, high)):
                if not value.is_finite():
                    raise FormulaError(
                        f"{name} {to_text(node)} has no finite real value: give another number.",
                        argument=name,
                    )
            if not a < b:
                raise DomainError(
                    f"The interval from {_shown(low)} to {_shown(high)} is empty or reversed: "
                    "the first end must be smaller than the second."
                )
            if not (
                math.isfinite(float(a))
                and math.isfinite(float(b))
                and float(b) - float(a) > RESOLVED * max(abs(float(a)), abs(float(b)))
            ):
                raise DomainError(
                    f"The interval from {_shown(low)} to {_shown(high)} is too short or too far out for "
                    "double numbers: scale the parameter."
                )

    @property
    def ends(self) -> tuple[Node, Node]:
        """The ends of the interval as exact constants; raises DomainError if the curve has none."""
        if self._ends is None:
            raise DomainError(f"The curve {self.text} has no interval: give both ends, such as 0 and 2*pi.")
        return self._ends

    @property
    def interval(self) -> tuple[float, float]:
        """The ends of the interval as the nearest doubles."""
        from osculant.cas.numbers.balls import PRECISION, constant, precision

        with precision(PRECISION):
            low, high = (float(constant(end).mid()) for end in self.ends)
        return low, high

    def __repr__(self) -> str:
        where = "" if self._ends is None else f", t from {to_text(self._ends[0])} to {to_text(self._ends[1])}"
        return f"<{type(self).__name__} {self.text}{where}>"


_NUMBERS = {2: "two", 3: "three"}


def _shown(constant: Node) -> str:
    """A constant in a message: its formula, unless that is long."""
    text = to_text(constant)
    return text if len(text) <= LONGEST_SHOWN else text[: LONGEST_SHOWN - 1] + "…"


def coordinates_of(given: Any) -> tuple[Node, ...]:
    """The coordinates' expressions, from text or a sequence of formulas, as many as there are.

    >>> len(coordinates_of("t, t^2, t^3")), len(coordinates_of(["t", "t^2"]))
    (3, 2)
    """
    if isinstance(given, str):
        return parse_tuple(given)
    if isinstance(given, Sequence):
        return tuple(part if isinstance(part, Node) else _coordinate(part) for part in given)
    raise FormulaError(f"A curve is given by two or three formulas, such as 't, t^2'; {given!r} is not.")


def _coordinate(given: Any) -> Node:
    if isinstance(given, str):
        return parse(given)
    from osculant.cas.formulas.sympy_bridge import from_sympy

    return from_sympy(given)
