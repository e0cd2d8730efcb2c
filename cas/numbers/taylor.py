"""Taylor arithmetic: a formula's graph → a straight-line program for its derivatives.

`program` writes, for every node of the expression graph, the recurrence of its normalised Taylor
coefficients f⁽ᵏ⁾/k! (Griewank & Walther, *Evaluating Derivatives*, ch. 13), one small instruction
at a time and none twice.  The length grows linearly with the formula and quadratically with the
order, so nothing swells.  A program is data: `Program.run` interprets it in any field of numbers
(exact, 50 digits, balls), and `codegen.jets` prints it as machine code.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from osculant.cas.formulas.expression import Node
from osculant.cas.numbers.fields import Field
from osculant.cas.numbers.recurrences import Instruction, write

#: precisions for which a program keeps its numbers
MOST_PLANS = 4


@dataclass(frozen=True)
class Program:
    """Instructions in order, and which values are the derivatives asked for.

    ``outputs[i][k]`` is the index of the k-th derivative (not divided by k!) of the i-th formula.
    """

    instructions: tuple[Instruction, ...]
    outputs: tuple[tuple[int, ...], ...]

    def run(self, at: Any, field: Field) -> list[list[Any]]:
        """The derivatives of all formulas at ``at``, a number of the field.

        >>> from osculant.cas.formulas.expression import variable
        >>> from osculant.cas.numbers.fields import Doubles
        >>> t = variable("t")
        >>> program([t**3], 3).run(2.0, Doubles())
        [[8.0, 12.0, 12.0, 6.0]]
        """
        values = self.trace(at, field)
        return [[values[index] for index in output] for output in self.outputs]

    def trace(self, at: Any, field: Field) -> list[Any]:
        """The value of every instruction at ``at``."""
        values: list[Any] = []
        append = values.append
        for work, first, second in self._plan(field):
            if second >= 0:
                append(work(values[first], values[second]))
            elif first >= 0:
                append(work(values[first]))
            else:
                append(at if work is None else work)
        return values

    def _plan(self, field: Field) -> list[tuple[Any, int, int]]:
        """For each instruction what is called with which values, −1 for none.

        What takes no values is a number itself, or None for the variable.  All is kept for a field's
        precision, which is that of numbers.
        """
        key = type(field), field.precision()
        plan = self._plans.get(key)
        if plan is None:
            plan = [self._planned(step, field) for step in self.instructions]
            if len(self._plans) == MOST_PLANS:
                self._plans.clear()
            self._plans[key] = plan
        return plan

    @cached_property
    def _plans(self) -> dict[Any, list[tuple[Any, int, int]]]:
        return {}

    @staticmethod
    def _planned(step: Instruction, field: Field) -> tuple[Any, int, int]:
        op, args, value = step
        if op in _ARITHMETIC:
            return _ARITHMETIC[op], args[0], args[1] if len(args) == 2 else -1
        if op == "call":
            return field.function(value), args[0], -1
        if op == "power":
            return lambda base: field.power(base, value), args[0], -1
        if op == "variable":
            return None, -1, -1
        return (field.number(value) if op == "number" else field.constant(value)), -1, -1


_ARITHMETIC: dict[str, Callable[..., Any]] = {
    "mul": operator.mul,
    "add": operator.add,
    "sub": operator.sub,
    "div": operator.truediv,
    "neg": operator.neg,
}


def program(
    formulas: Sequence[Node],
    order: int,
    variable: str = "t",
    normalised: bool = False,
    parameters: Sequence[str] = (),
) -> Program:
    """The program for the derivatives 0…order of the formulas in one variable.

    ``normalised`` asks for the Taylor coefficients f⁽ᵏ⁾/k! instead.  ``parameters`` are variables that do not
    change along the curve; a program that has any is there to be printed, not to be run.  Raises FormulaError
    if a formula has a variable besides.

    >>> from osculant.cas.formulas.expression import call, variable
    >>> nested = variable("t")
    >>> for _ in range(30):
    ...     nested = call("sin", nested)
    >>> len(program([nested], 5).instructions) < 3000
    True
    """
    return pruned(*write(formulas, order, variable, normalised, parameters))


def pruned(steps: Sequence[Instruction], outputs: Sequence[Sequence[int]]) -> Program:
    """Drop what no output needs and renumber."""
    needed = {index for output in outputs for index in output}
    for index in range(len(steps) - 1, -1, -1):
        if index in needed:
            needed.update(steps[index].args)
    order = sorted(needed)
    place = {old: new for new, old in enumerate(order)}
    kept = [steps[old] for old in order]
    return Program(
        tuple(Instruction(op, tuple(map(place.__getitem__, args)), value) for op, args, value in kept),
        tuple(tuple(place[index] for index in output) for output in outputs),
    )
