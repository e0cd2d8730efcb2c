"""A Taylor program → a function of C: derivatives as `osculant.codegen.jets` computes them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.rationals import as_double
from osculant.cas.numbers.recurrences import Instruction
from osculant.cas.numbers.taylor import program

#: operators of C
_SIGNS = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


def jet_function(name: str, formulas: Sequence[Node], order: int, parameters: Sequence[str] = ()) -> str:
    """The C function that writes the derivatives 0…order of all formulas into ``out``, one after the other.

    Args:
        name: of the function, ``void name(double t, const double *parameters, double *out)``.
        formulas: in t and the parameters.
        order: of the last derivative.
        parameters: names, in the order of the values at run time.

    What does not depend on t or a parameter is computed now, by the same libm that compiled jets have.

    >>> from osculant.cas.formulas.parser import parse
    >>> print(jet_function("square", [parse("a*t^2", ("t", "a"))], 1, ["a"]))
    static void square(double t, const double *parameters, double *out) {
        const double v2 = t * t;
        const double v3 = t + t;
        const double v4 = parameters[0] /* a */ * v2;
        const double v5 = parameters[0] /* a */ * v3;
        out[0] = v4;
        out[1] = v5;
    }
    """
    compiled = program(formulas, order, parameters=parameters)
    values: list[str] = []
    constants: list[float | None] = []
    lines: list[str] = []
    for index, step in enumerate(compiled.instructions):
        known = _constant(step, [constants[a] for a in step.args])
        constants.append(known)
        if known is not None:
            values.append(_literal(known))
        elif step.op == "variable":
            values.append("t")
        elif step.op == "parameter":
            place = list(parameters).index(step.value)
            values.append(f"parameters[{place}] /* {step.value} */")
        else:
            lines.append(f"const double v{index} = {_operation(step, [values[a] for a in step.args])};")
            values.append(f"v{index}")
    places = [index for output in compiled.outputs for index in output]
    lines += [f"out[{place}] = {values[index]};" for place, index in enumerate(places)]
    if "parameters[" not in "".join(lines):
        lines.insert(0, "(void)parameters;")
    if not any(step.op == "variable" for step in compiled.instructions):
        lines.insert(0, "(void)t;")
    head = f"static void {name}(double t, const double *parameters, double *out) {{"
    return "\n".join([head, *(f"    {line}" for line in lines), "}"])


def _operation(step: Instruction, args: list[str]) -> str:
    """One instruction as an expression."""
    if step.op in _SIGNS:
        return f"{args[0]} {_SIGNS[step.op]} {args[1]}"
    if step.op == "neg":
        return f"-({args[0]})" if args[0].startswith("-") else f"-{args[0]}"
    if step.op == "power":
        assert isinstance(step.value, Fraction)
        return f"pow({args[0]}, {_literal(as_double(step.value))})"
    if step.value == "sign":
        return f"{args[0]} > 0.0 ? 1.0 : ({args[0]} < 0.0 ? -1.0 : NAN)"
    return f"{'fabs' if step.value == 'abs' else step.value}({args[0]})"


def _constant(step: Instruction, args: Sequence[float | None]) -> float | None:
    """The value of an instruction that depends on nothing, None of others."""
    if step.op in ("variable", "parameter") or any(arg is None for arg in args):
        return None
    values: list[Any] = list(args)
    if step.op == "number":
        assert isinstance(step.value, Fraction)
        return as_double(step.value)
    if step.op == "constant":
        return math.pi if step.value == "pi" else math.e
    try:
        if step.op == "power":
            return math.pow(values[0], as_double(Fraction(step.value)))
        if step.op == "call":
            if step.value == "sign":
                return math.copysign(1.0, values[0]) if values[0] else math.nan
            return float(abs(values[0]) if step.value == "abs" else getattr(math, str(step.value))(values[0]))
        a, b = float(values[0]), float(values[-1])
        return a / b if step.op == "div" else {"add": a + b, "sub": a - b, "mul": a * b, "neg": -a}[step.op]
    except (ValueError, ZeroDivisionError, OverflowError):
        return None  # left to the compiler and libm


def _literal(value: float) -> str:
    """A double with as many digits as tell it from all others, negative ones in parentheses."""
    if not math.isfinite(value):
        return "NAN" if math.isnan(value) else ("INFINITY" if value > 0 else "(-INFINITY)")
    return repr(value) if math.copysign(1.0, value) > 0 else f"({value!r})"
