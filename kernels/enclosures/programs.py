"""Taylor programs as tables, interpreted in enclosures: nothing is compiled for a formula."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.enclosures.balls import Ball, add, div, function, mul, power, sub
from osculant.kernels.jit import kernel

#: codes of instructions; those of elementary functions are beyond them
OPERATIONS = ("number", "variable", "add", "sub", "mul", "div", "neg", "power")
NUMBER, VARIABLE, ADD, SUB, MUL, DIV, NEG, POWER = range(len(OPERATIONS))
CALL = len(OPERATIONS)


class Table(NamedTuple):
    """A program: instructions in order, each of which makes one value.

    Attributes:
        codes: (n,) what it does.
        first, second: (n,) which values it does that with.
        numbers: (n, 2) the ball of a number; of a power its exponent.
    """

    codes: np.ndarray[Any, Any]
    first: np.ndarray[Any, Any]
    second: np.ndarray[Any, Any]
    numbers: np.ndarray[Any, Any]


@kernel
def run(table: Table, middle: float, radius: float, values: np.ndarray[Any, Any]) -> None:
    """The balls of all values, rows of ``values`` (n, 2), over a ball of the variable."""
    for i in range(table.codes.shape[0]):
        code = table.codes[i]
        x = (values[table.first[i], 0], values[table.first[i], 1])
        y = (values[table.second[i], 0], values[table.second[i], 1])
        if code == MUL:
            x = mul(x, y)
        elif code == ADD:
            x = add(x, y)
        elif code == SUB:
            x = sub(x, y)
        elif code == DIV:
            x = div(x, y)
        elif code == NUMBER:
            x = (table.numbers[i, 0], table.numbers[i, 1])
        elif code == NEG:
            x = (-x[0], x[1])
        elif code == VARIABLE:
            x = (middle, radius)
        elif code == POWER:
            x = power(x, table.numbers[i, 0])
        else:
            x = function(code - CALL, x)
        values[i, 0], values[i, 1] = x


@kernel
def value(table: Table, at: float, index: int, values: np.ndarray[Any, Any]) -> Ball:
    """The ball of one value at a double."""
    run(table, at, 0.0, values)
    return values[index, 0], values[index, 1]
