"""A curve in enclosures of doubles: where it is surely finite, and where it is nearly a polynomial."""

from __future__ import annotations

import math
import sys
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.cas.numbers.parts import FIRST, NARROWEST, ORDER, WORK_LIMIT
from osculant.cas.numbers.parts import levels as levels_in_balls
from osculant.curves.kept import kept

if TYPE_CHECKING:
    from osculant.cas.numbers.balls import FormulaBalls
    from osculant.cas.numbers.taylor import Program
    from osculant.kernels.enclosures.programs import Table

#: boxes that are looked at for whether the curve is finite, unclear ones at most, and how narrow they get
VISITS, UNCLEAR, LEAST = 4096, 32, 2.0**-40


class Enclosed:
    """Taylor coefficients of a curve's coordinates in enclosures of doubles (`osculant.kernels.enclosures`).

    Args:
        curve: in ball arithmetic, for its program.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> from osculant.cas.jets.balls import CurveBalls
    >>> hyperbola = Enclosed(CurveBalls(parse_tuple("t, 1/t")))
    >>> hyperbola.unclear(0.5, 1.0), [a < 0 < b for a, b in hyperbola.unclear(-1.0, 1.0)]
    ([], [True])
    """

    def __init__(self, curve: FormulaBalls[Any]) -> None:
        self.curve = curve

    @cached_property
    def _program(self) -> tuple[Table, Any]:
        program = self.curve.program(ORDER)
        return table_of(program), np.array(program.outputs)

    def unclear(self, low: float, high: float) -> list[tuple[float, float]] | None:
        """Narrow intervals of [low, high] outside of which all coefficients are finite; None if many."""
        _, left = self._halved([low, high], sys.float_info.max, LEAST * (high - low), VISITS)
        return None if left is None else joined(sorted(left))

    def parts(self, low: float, high: float, accuracy: float) -> list[float]:
        """Edges of parts of [low, high] on which the curve is a polynomial to the accuracy.

        They are found as `osculant.cas.numbers.parts.polynomial_parts` does it in ball arithmetic.

        >>> from osculant.cas.formulas.parser import parse_tuple
        >>> from osculant.cas.jets.balls import CurveBalls
        >>> len(Enclosed(CurveBalls(parse_tuple("t, t^2"))).parts(0.0, 1.0, 1e-3))
        17
        """
        return [edge for edge, _ in self.levels(low, high, accuracy)]

    def levels(self, low: float, high: float, accuracy: float) -> list[tuple[float, float]]:
        """(edge, accuracy below which it is one) of `parts` for all accuracies down to one.

        Where doubles leave much unclear, as they overflow on the way, balls are asked for it all.

        >>> from osculant.cas.formulas.parser import parse_tuple
        >>> from osculant.cas.jets.balls import CurveBalls
        >>> curve = Enclosed(CurveBalls(parse_tuple("t, exp(t)")))
        >>> found = curve.levels(0.0, 8.0, 1e-12)
        >>> [edge for edge, level in found if level > 1e-9] == curve.parts(0.0, 8.0, 1e-9)
        True
        """
        begun = [low + (high - low) * i / FIRST for i in range(FIRST)] + [high]
        new, left = self._halved(begun, accuracy, NARROWEST * (high - low), WORK_LIMIT)
        if left is None:
            return levels_in_balls(self.curve, low, high, accuracy)
        return sorted([*((edge, math.inf) for edge in begun), *new])

    def _halved(
        self, edges: list[float], accuracy: float, least: float, most: int
    ) -> tuple[list[tuple[float, float]], list[tuple[float, float]] | None]:
        """New edges as `levels` has them, and what parts are not accurate enough; None if these are many."""
        from osculant.kernels.enclosures.parts import polynomial_parts

        (table, rows), count = self._program, len(edges) - 1
        pending, new, left = np.empty((most + 1, 3)), np.empty((most, 2)), np.empty((UNCLEAR, 2))
        pending[:count] = [(a, b, math.inf) for a, b in pairwise(edges)]
        values = np.empty((len(table.codes), 2))
        found, remaining = polynomial_parts(
            table, rows, accuracy, least, most, count, pending, new, left, values
        )
        levels = [(edge, level) for edge, level in new[:found].tolist()]
        return levels, [(a, b) for a, b in left[:remaining].tolist()] if remaining <= UNCLEAR else None


@kept
def enclosed(curve: FormulaBalls[Any]) -> Enclosed:
    """The curve in enclosures of doubles, made once.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> from osculant.cas.jets.balls import CurveBalls
    >>> parabola = CurveBalls(parse_tuple("t, t^2"))
    >>> enclosed(parabola) is enclosed(parabola)
    True
    """
    return Enclosed(curve)


def joined(parts: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Intervals in order, as one where they touch.

    >>> joined([(0.0, 1.0), (1.0, 2.0), (3.0, 4.0)])
    [(0.0, 2.0), (3.0, 4.0)]
    """
    found: list[tuple[float, float]] = []
    for start, end in parts:
        if found and start <= found[-1][1]:
            start, end = found[-1][0], max(end, found.pop()[1])
        found.append((start, end))
    return found


def table_of(program: Program) -> Table:
    """A program as kernels interpret it.

    >>> from osculant.cas.formulas.parser import parse
    >>> from osculant.cas.numbers.taylor import program
    >>> table_of(program([parse("t^2")], 0)).codes.tolist()
    [1, 4]
    """
    from osculant.kernels.enclosures.balls import NAMES
    from osculant.kernels.enclosures.programs import CALL, OPERATIONS, Table

    numbers = {name: code for code, name in enumerate(OPERATIONS)}
    numbers |= {f"call {name}": CALL + code for code, name in enumerate(NAMES)}
    codes, first, second, balls = [], [], [], []
    for op, args, value in program.instructions:
        ball = 0.0, 0.0
        if op in ("number", "constant"):
            ball, op = _ball(value), "number"
        elif op == "power":
            ball = float(value), 0.0
        elif op == "call":
            op = f"call {value}"
        codes.append(numbers[op])
        balls.append(ball)
        first.append(args[0] if args else 0)
        second.append(args[-1] if args else 0)
    whole = np.array([codes, first, second], dtype=np.int64)
    return Table(whole[0], whole[1], whole[2], np.array(balls, dtype=np.float64).reshape(-1, 2))


def _ball(value: Any) -> tuple[float, float]:
    """A rational, pi or e as a double, and how far off it is at most."""
    if isinstance(value, str):
        number = math.pi if value == "pi" else math.e
        return number, math.ulp(number)
    try:
        number = float(value)
    except OverflowError:
        return math.inf, math.inf
    return number, 0.0 if Fraction(number) == value else math.ulp(number)
