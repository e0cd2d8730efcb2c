"""Closed forms of the mathematics → numba source (design, step 3a).

A `ClosedForm` names a function, its arguments and the sympy expressions it returns; `source` prints
a module of them with common subexpressions shared.  The printed modules are committed under
``kernels/generated`` and compared with a fresh print by the lint run.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from sympy.printing.pycode import PythonCodePrinter


@dataclass(frozen=True)
class ClosedForm:
    """One function to print: its name, one-line purpose, arguments and named results in order."""

    name: str
    purpose: str
    arguments: tuple[sp.Symbol, ...]
    results: dict[str, sp.Expr]


class _NumbaPrinter(PythonCodePrinter):  # type: ignore[misc]
    """Python source with `math` functions, float literals and small powers written as products."""

    def _print_cbrt(self, expr: sp.Expr) -> str:
        return f"np.cbrt({self._print(expr.args[0])})"

    def _print_Rational(self, expr: sp.Rational) -> str:
        return repr(float(expr)) if expr.q == 1 else f"({float(expr.p)!r} / {float(expr.q)!r})"

    def _print_Integer(self, expr: sp.Integer) -> str:
        return repr(float(expr))

    def _print_Pow(self, expr: sp.Pow, **kwargs: object) -> str:
        base, exponent = expr.as_base_exp()
        if exponent.is_Integer and 2 <= int(exponent) <= 4:
            return "(" + " * ".join([self.parenthesize(base, 100)] * int(exponent)) + ")"
        if exponent == -1:
            return f"(1.0 / {self.parenthesize(base, 100)})"
        return str(super()._print_Pow(expr, **kwargs))


def function_source(form: ClosedForm) -> str:
    """The source of one jitted function.

    >>> x = sp.Symbol("x")
    >>> source = function_source(ClosedForm("square", "x squared.", (x,), {"y": x**2}))
    >>> source.splitlines()[1], source.splitlines()[-1]
    ('def square(x: float) -> float:', '    return (x * x)')
    """
    printer = _NumbaPrinter({"fully_qualified_modules": True})
    shared, results = sp.cse(list(form.results.values()), symbols=sp.numbered_symbols("_v"), order="none")
    parameters = ", ".join(f"{argument.name}: float" for argument in form.arguments)
    kind = "float" if len(results) == 1 else f"tuple[{', '.join(['float'] * len(results))}]"
    lines = ["@kernel", f"def {form.name}({parameters}) -> {kind}:", f'    """{form.purpose}"""']
    lines += [f"    {symbol} = {printer.doprint(value)}" for symbol, value in shared]
    lines.append(f"    return {', '.join(printer.doprint(result) for result in results)}")
    return "\n".join(lines)


def module_source(
    derivation: str, forms: Sequence[ClosedForm], constants: Mapping[str, sp.Expr | int]
) -> str:
    """A whole generated module: header naming the derivation and versions, constants, functions.

    Constants are printed as the nearest double of their exact value, Python's integers as they are.
    """
    import mpmath

    functions = [function_source(form) for form in forms]
    uses_math, uses_numpy = (any(name in text for text in functions) for name in ("math.", "np."))
    parts = [
        f'"""Generated from {derivation} by codegen.generate; do not edit.\n\n'
        f'Made with sympy {sp.__version__}, mpmath {mpmath.__version__}: `make generate`.\n"""',
        "from __future__ import annotations\n\n"
        + ("import math\n\n" if uses_math else "")
        + ("import numpy as np\n\n" if uses_numpy else "")
        + "from osculant.kernels.jit import kernel",
        "\n".join(f"{name} = {_printed(value)}" for name, value in constants.items()),
        *functions,
    ]
    return "\n\n\n".join(part.rstrip() for part in parts if part.strip()) + "\n"


def _printed(value: sp.Expr | int) -> str:
    return str(value) if isinstance(value, int) else f"{float(value)!r}  # {value}"
