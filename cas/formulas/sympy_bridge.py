"""Between our expression graphs and sympy: conversions both ways, and the real cube root that sympy lacks."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import mpmath
import sympy

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas import expression as ex
from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.graph import fold
from osculant.cas.formulas.rationals import BITS, decimal, exact_root


class cbrt(sympy.Function):  # type: ignore[misc]  # sympy's own naming of functions; sympy is untyped here
    """The real cube root as a sympy function: odd, with the derivative 1/(3*cbrt(x)**2).

    sympy's own cbrt is the principal complex root, which is not real for negative numbers.

    >>> x = sympy.Symbol("x", real=True)
    >>> cbrt(-8), cbrt(-x), cbrt(x).diff(x)
    (-2, -cbrt(x), 1/(3*cbrt(x)**2))
    """

    nargs = 1
    is_real = True

    @classmethod
    def eval(cls, x: Any) -> Any:
        """The value at a perfect cube; the sign in front of the root."""
        if x.is_Rational:
            root = exact_root(Fraction(int(x.p), int(x.q)), 3)
            if root is not None:
                return sympy.Rational(root.numerator, root.denominator)
        if x.could_extract_minus_sign():
            return -cls(-x)
        return None

    def fdiff(self, argindex: int = 1) -> Any:
        """The derivative."""
        return 1 / (3 * self**2)

    def _eval_is_zero(self) -> Any:
        return self.args[0].is_zero

    def _eval_is_positive(self) -> Any:
        return self.args[0].is_positive

    def _eval_is_negative(self) -> Any:
        return self.args[0].is_negative

    def _eval_evalf(self, prec: int) -> Any:
        x = self.args[0]._evalf(prec)
        if not x.is_Float:
            return self.func(x)
        with mpmath.workprec(prec):
            value = mpmath.mpf(x._mpf_)
            return sympy.Float(mpmath.sign(value) * mpmath.cbrt(abs(value)), precision=prec)

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        root = rf"\sqrt[3]{{{printer._print(self.args[0])}}}"
        return root if exp is None else rf"\left({root}\right)^{{{exp}}}"

    def _mpmathcode(self, printer: Any) -> str:
        sign, root = (printer._module_format(f"mpmath.{name}") for name in ("sign", "cbrt"))
        x = printer._print(self.args[0])
        return f"({sign}({x})*{root}(abs({x})))"


_FUNCTIONS = {name: getattr(sympy, name) for name in ex.FUNCTIONS - {"abs", "cbrt", "sqrt"}} | {
    "abs": sympy.Abs,
    "cbrt": cbrt,
}
ROOT_BITS = 256  # sympy factorises numbers under roots
_INFINITE = {sympy.zoo, sympy.nan, sympy.oo, -sympy.oo}


def to_sympy(node: Node, symbols: Mapping[str, sympy.Expr] | None = None) -> sympy.Expr:
    """The same expression in sympy; variables become real symbols, or what `symbols` gives for their names.

    cbrt becomes the function of that name here. DomainError if sympy finds that the expression is nowhere
    finite and real; FormulaError if a constant in it is beyond 2**BITS or 2**-BITS, or too deep for sympy.

    >>> to_sympy(ex.variable("t") / 2 + ex.PI)
    t/2 + pi
    """
    given = symbols or {}

    def rule(node: Node, args: list[Any]) -> Any:
        match node.kind:
            case "number":
                result = sympy.Rational(node.value.numerator, node.value.denominator)
            case "pi":
                result = sympy.pi
            case "e":
                result = sympy.E
            case "variable":
                name = node.value
                result = given[name] if name in given else sympy.Symbol(name, real=True)
            case "add":
                result = args[0] + args[1]
            case "sub":
                result = args[0] - args[1]
            case "mul":
                result = args[0] * args[1]
            case "div":
                result = args[0] / args[1]
            case "neg":
                result = -args[0]
            case "pow":
                base, exponent = node.args[0], node.value
                if (
                    base.kind == "number"
                    and sum(map(int.bit_length, base.value.as_integer_ratio())) > ROOT_BITS
                ):
                    raise FormulaError(f"A root of a number of over {ROOT_BITS} bits is too hard for sympy.")
                result = args[0] ** sympy.Rational(exponent.numerator, exponent.denominator)
            case _:
                result = _FUNCTIONS[node.value](args[0])
                # Of |exp(x)| sympy makes exp(re(x)) if it cannot tell that x is real.
                if node.value == "abs" and result.has(sympy.re, sympy.im, sympy.arg):
                    result = sympy.Abs(args[0], evaluate=False)
        if result in _INFINITE:
            raise DomainError("The expression is nowhere finite: it divides by zero, or takes its logarithm.")
        if result.is_number and not result.is_Rational:
            _check_magnitude(result)
        return result

    try:
        (result,) = fold([node], rule)
    except (OverflowError, RecursionError):
        raise FormulaError(
            "The expression is too large or too deep for sympy; write a smaller one."
        ) from None
    if result.has(sympy.I):
        raise DomainError(
            "The expression is nowhere real: it takes a root or logarithm of a negative quantity."
        )
    return result


def _check_magnitude(constant: Any) -> None:
    """FormulaError beyond 2**(+-BITS): sympy would compute exp(exp(exp(9))) - 1 in full to find its sign."""
    value = constant.evalf(3)
    if value.is_Float and value != 0:
        _, _, exponent, width = value._mpf_
        if abs(exponent + width) > BITS:
            raise FormulaError(f"A constant of the expression is beyond 2**{BITS} or 2**-{BITS}.")


def from_sympy(expression: object) -> Node:
    """The node of a sympy or symengine expression, or of an int, float or Fraction; never of text.

    A float is read as the rational that its shortest decimal form writes. FormulaError for anything that is
    not built of the operations and functions of `osculant.cas.formulas.expression`.

    >>> print(from_sympy(sympy.sin(sympy.Symbol("t")) / 2))
    1/2*sin(t)
    """
    if isinstance(expression, Node):
        return expression
    if isinstance(expression, (int, float, Fraction)):
        expression = sympy.Float(expression) if isinstance(expression, float) else sympy.Rational(expression)
    elif hasattr(expression, "_sympy_"):
        expression = expression._sympy_()
    if not isinstance(expression, sympy.Expr):
        kind = type(expression).__name__
        raise FormulaError(f"A {kind} is not an expression; give a formula, or one of sympy or symengine.")
    nodes: dict[sympy.Basic, Node] = {}
    stack: list[sympy.Basic] = [expression]
    while stack:
        waiting = [argument for argument in stack[-1].args if argument not in nodes]
        if waiting:
            stack.extend(waiting)
        else:
            item = stack.pop()
            nodes[item] = _convert(item, [nodes[argument] for argument in item.args])
    return nodes[expression]


def _convert(item: Any, args: list[Node]) -> Node:
    if item.is_Symbol:
        return ex.variable(item.name)
    if item.is_Rational:
        return ex.number(Fraction(int(item.p), int(item.q)))
    if item.is_Float:
        short = repr(float(item))
        return ex.number(decimal(short if item._prec <= 53 and short[-1].isdigit() else str(item)))
    if item is sympy.pi:
        return ex.PI
    if item is sympy.E:
        return ex.E
    if item.is_Add:
        return _sum(args)
    if item.is_Mul:
        return _product(args)
    if item.is_Pow:
        return ex.power(*args)
    if item.func is sympy.sign:
        return ex.div(args[0], ex.call("abs", args[0]))
    name = {"Abs": "abs"}.get(item.func.__name__, item.func.__name__)
    if item.is_Function and len(args) == 1 and name in ex.RESERVED:
        return ex.call(name, args[0])
    raise FormulaError(f"{item.func.__name__} is not part of a formula; rewrite the expression without it.")


def _sum(terms: list[Node]) -> Node:
    total = ex.ZERO
    for term in terms:
        total = ex.sub(total, term.args[0]) if term.kind == "neg" else ex.add(total, term)
    return total


def _product(factors: list[Node]) -> Node:
    """The product as one quotient with its sign in front; negative powers go below the line."""
    above = below = ex.ONE
    negative = factors[0].kind == "number" and factors[0].value < 0
    for factor in [ex.neg(factors[0]), *factors[1:]] if negative else factors:
        if factor.kind == "pow" and factor.value < 0:
            below = ex.mul(below, ex.power(factor.args[0], ex.number(-factor.value)))
        else:
            above = ex.mul(above, factor)
    quotient = ex.div(above, below)
    return ex.neg(quotient) if negative else quotient
