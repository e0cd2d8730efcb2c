"""A Taylor program → a function of C that computes with pairs of doubles."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from osculant.cas.numbers.recurrences import Instruction
from osculant.cas.numbers.taylor import Program
from osculant.codegen.c.program import Translation
from osculant.codegen.c.types import DOUBLE, Struct

#: digits of constants on their way to pairs
PRECISION = 200


def pair_function(
    translation: Translation,
    name: str,
    compiled: Program,
    parameters: Sequence[str],
    pair: type,
    functions: Mapping[str, Callable[..., Any]],
) -> str:
    """The C function that writes all outputs of a program, the high and the low part of each.

    Args:
        translation: that the functions for pairs join.
        name: of the function, ``void name(double t, const double *parameters, double *out)``.
        compiled: the program.
        parameters: names, in the order of the values at run time.
        pair: the `NamedTuple` class of a pair.
        functions: kernels for pairs by the program's operations and elementary functions.
    """
    kind = Struct((DOUBLE, DOUBLE), pair)
    c = translation.c_type(kind)

    def call(operation: str, *arguments: str) -> str:
        made = translation.function(functions[operation], [kind] * len(arguments))
        return f"{made.name}({', '.join(arguments)})"

    lines = ["(void)t;", "(void)parameters;"]
    for index, step in enumerate(compiled.instructions):
        arguments = [f"v{argument}" for argument in step.args]
        if step.op == "variable":
            value = f"({c}){{t, 0.0}}"
        elif step.op == "parameter":
            value = f"({c}){{parameters[{list(parameters).index(step.value)}], 0.0}} /* {step.value} */"
        elif step.op in ("number", "constant"):
            value = _literal(c, step)
        elif step.op == "power":
            value = call("power", *arguments, _literal(c, step))
        else:
            value = call(step.value if step.op == "call" else step.op, *arguments)
        lines.append(f"const {c} v{index} = {value};")
    wanted = [index for output in compiled.outputs for index in output]
    for place, index in enumerate(wanted):
        lines += [f"out[{2 * place}] = v{index}.high;", f"out[{2 * place + 1}] = v{index}.low;"]
    head = f"static void {name}(double t, const double *parameters, double *out) {{"
    return "\n".join([head, *(f"    {line}" for line in lines), "}"])


def parts(value: Fraction) -> tuple[float, float]:
    """The two doubles whose sum is nearest to a number; infinite ones where it is beyond them.

    >>> parts(Fraction(1, 3))
    (0.3333333333333333, 1.850371707708594e-17)
    """
    try:
        high = float(value)
    except OverflowError:
        return math.copysign(math.inf, value), 0.0
    return high, float(value - Fraction(high))


def _literal(c: str, step: Instruction) -> str:
    """A number, or pi or e."""
    if isinstance(step.value, Fraction):
        high, low = parts(step.value)
    else:
        import mpmath

        with mpmath.workprec(PRECISION):
            exact = +(mpmath.pi if step.value == "pi" else mpmath.e)
            high = float(exact)
            low = float(exact - high)
    shown = [
        repr(part) if math.isfinite(part) else ("INFINITY" if part > 0 else "-INFINITY")
        for part in (high, low)
    ]
    return f"({c}){{{shown[0]}, {shown[1]}}}"
