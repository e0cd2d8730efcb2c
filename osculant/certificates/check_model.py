"""A germ as quotients of polynomials of the variables and of the functions in it, for the checker.

Every function T = f(a) − f(a(0)) becomes a variable that is 0 at the origin, with its derivatives. Imports
nothing of osculant but the checker's own algebra.
"""

from __future__ import annotations

import ast
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from osculant.certificates.check_algebra import (
    Polynomial,
    composed,
    constant,
    derivative,
    generator,
    plus,
    power,
    times,
)
from osculant.certificates.check_numbers import current
from osculant.certificates.check_taylor import taylor
from osculant.certificates.check_text import ROOT, RejectedError, parsed, require

Quotient = tuple[Polynomial, Polynomial]
#: functions by the tangent T of half the angle (h: hyperbolic): coefficients of 1, T, T² above and below
HALVES = {
    "sin": ("half", (0, 2, 0), (1, 0, 1)),
    "cos": ("half", (1, 0, -1), (1, 0, 1)),
    "tan": ("half", (0, 2, 0), (1, 0, -1)),
    "sinh": ("halfh", (0, 2, 0), (1, 0, -1)),
    "cosh": ("halfh", (1, 0, 1), (1, 0, -1)),
    "tanh": ("halfh", (0, 2, 0), (1, 0, 1)),
}
ROOTS = {"sqrt": "1/2", "cbrt": "1/3"}
#: higher powers of units are functions too
HIGH = 100


class Model:
    """The components of a germ.

    Args:
        components: their texts.
        source: the names of the variables.
        functions: how many functions there are in them, at most.

    Attributes:
        width: the number of variables, functions included.
        components: numerators and denominators.
    """

    def __init__(self, components: Sequence[str], source: Sequence[str], functions: int) -> None:
        self.n, self.width = len(source), len(source) + functions
        self.source = [f"v{i}" for i in range(self.n)]
        self.known: dict[tuple[str, str], int] = {}
        #: of the functions: the derivatives by the source variables, and their denominator
        self.rules: dict[int, tuple[list[Polynomial], Polynomial]] = {}
        #: of functions whose argument has no denominator: it less its value at the origin, the slope there
        self.arguments: dict[int, tuple[Polynomial, Any]] = {}
        field = current()
        root = None if field is None else field.name
        self.components = [self.quotient(parsed(text, source, root)) for text in components]
        require(len(self.rules) == functions, "the germ has another number of functions")

    def quotient(self, node: ast.expr) -> Quotient:
        """An expression as numerator and denominator."""
        one = constant(1, self.width)
        if isinstance(node, ast.Constant) and type(node.value) is int:
            return constant(node.value, self.width), one
        if isinstance(node, ast.Name) and node.id == ROOT:
            return constant(generator(), self.width), one
        if isinstance(node, ast.Name) and node.id in self.source:
            return self.variable(self.source.index(node.id)), one
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.UAdd):
            a, b = self.quotient(node.operand)
            return (plus({}, a, -1), b) if isinstance(node.op, ast.USub) else (a, b)
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
            return self.raised(node)
        if isinstance(node, ast.BinOp):
            (a, b), (c, d) = self.quotient(node.left), self.quotient(node.right)
            if isinstance(node.op, ast.Add | ast.Sub):
                sign = 1 if isinstance(node.op, ast.Add) else -1
                return plus(times(a, d), times(c, b), sign), times(b, d)
            if isinstance(node.op, ast.Mult):
                return times(a, c), times(b, d)
            require(isinstance(node.op, ast.Div), "an operation that the checker does not read")
            self.unit(c)
            return times(a, d), times(b, c)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and len(node.args) == 1:
            name = node.func.id
            name = f"^{ROOTS[name]}" if name in ROOTS else name
            return self.function(name, node.args[0])
        raise RejectedError("a formula that the checker does not read")

    def raised(self, node: ast.BinOp) -> Quotient:
        """A power: of a number as exponent."""
        above, below = self.quotient(node.right)
        zero = (0,) * self.width
        require(set(above) <= {zero} and set(below) <= {zero}, "an exponent that is no number")
        e = above.get(zero, Fraction(0)) / below[zero]
        if e.denominator > 1:
            return self.function(f"^{e}", node.left)
        a, b = self.quotient(node.left)
        if abs(e) > HIGH and zero in a:
            return self.function(f"^{e}", node.left)
        if e < 0:
            self.unit(a)
            a, b = b, a
        return power(a, abs(int(e)), self.width), power(b, abs(int(e)), self.width)

    def variable(self, i: int) -> Polynomial:
        """The variable number i."""
        return {tuple(int(i == j) for j in range(self.width)): Fraction(1)}

    def unit(self, f: Polynomial) -> Any:
        """The value at the origin of a polynomial that must not be 0 there."""
        value: Any = f.get((0,) * self.width, Fraction(0))
        require(value != 0, "a denominator that is 0 at the origin")
        return value

    def function(self, written: str, argument: ast.expr) -> Quotient:
        """A function of an argument: its variable plus its value at the origin."""
        name = HALVES[written][0] if written in HALVES else written
        key = ast.unparse(argument)
        s, t = self.quotient(argument)
        zero = (0,) * self.width
        at = s.get(zero, Fraction(0)) / self.unit(t)
        if set(s) <= {zero} and set(t) <= {zero}:  # a number
            return constant(taylor(written, at, 0)[0], self.width), constant(1, self.width)
        if (name, key) not in self.known:
            self.known[name, key] = self.n + len(self.known)
            require(self.n + len(self.known) <= self.width, "the germ has another number of functions")
        k = self.known[name, key]
        variable = self.variable(k)
        require(name not in {"half", "halfh"} or at == 0, f"{written} has no rational value at {at}")
        start = Fraction(0) if name in {"half", "halfh"} else taylor(name, at, 0)[0]
        value = plus(variable, constant(start, self.width))
        if k not in self.rules:
            outer = self.slope(name, (s, t), value)
            gradient, unit = self.derivatives(s, t)
            self.rules[k] = [times(outer[0], g) for g in gradient], times(outer[1], unit)
            if set(t) <= {zero}:
                moved = plus(times(s, constant(1 / t[zero], self.width)), constant(at, self.width), -1)
                self.arguments[k] = moved, outer[0].get(zero, Fraction(0)) / outer[1][zero]
        if written not in HALVES:
            return value, constant(1, self.width)
        powers = [constant(1, self.width), variable, times(variable, variable)]
        found: list[Polynomial] = []
        for coefficients in HALVES[written][1:]:
            total: Polynomial = {}
            for c, f in zip(coefficients, powers):
                total = plus(total, f, int(c))
            found.append(total)
        return found[0], found[1]

    def slope(self, name: str, argument: Quotient, v: Polynomial) -> Quotient:
        """The derivative of a function by its argument, at that value."""
        s, t = argument
        one = constant(1, self.width)
        if name.startswith("^"):
            return times(times(v, t), constant(Fraction(name[1:]), self.width)), s
        if name in {"half", "halfh"}:
            return plus(one, times(v, v), 1 if name == "half" else -1), constant(2, self.width)
        if name == "exp":
            return v, one
        if name == "log":
            return t, s
        require(name in {"atan", "atanh"}, f"{name} is no function that the checker differentiates")
        return times(t, t), plus(times(t, t), times(s, s), 1 if name == "atan" else -1)

    def derivatives(self, above: Polynomial, below: Polynomial) -> tuple[list[Polynomial], Polynomial]:
        """The partial derivatives of a quotient by the source variables: numerators, and one denominator."""
        unit = constant(1, self.width)
        for _, denominator in self.rules.values():
            unit = times(unit, denominator)
        a, b = self.total(above), self.total(below)
        found = [plus(times(x, below), times(y, above), -1) for x, y in zip(a, b)]
        return found, times(unit, times(below, below))

    def total(self, f: Polynomial) -> list[Polynomial]:
        """The partial derivatives of a polynomial, times the product of the functions' denominators."""
        unit = constant(1, self.width)
        for _, denominator in self.rules.values():
            unit = times(unit, denominator)
        found = [times(derivative(f, i), unit) for i in range(self.n)]
        for k, (numerators, _) in self.rules.items():
            outer = derivative(f, k)
            if outer:
                rest = constant(1, self.width)
                for other, (_, denominator) in self.rules.items():
                    rest = times(rest, denominator) if other != k else rest
                found = [plus(g, times(outer, times(n, rest))) for g, n in zip(found, numerators)]
        return found

    def gradients(self) -> list[list[Polynomial]]:
        """The rows of df, each times a unit."""
        return [self.derivatives(a, b)[0] for a, b in self.components]

    def divided(self, f: Polynomial) -> Polynomial:
        """A polynomial with U in place of T for functions T = a·(c + U): a the argument, c the slope at 0.

        U is analytic and 0 at the origin, as T is.
        """
        images = [self.variable(i) for i in range(self.width)]
        for k, (argument, slope) in sorted(self.arguments.items()):
            factor = plus(images[k], constant(slope, self.width))
            images[k] = times(composed(argument, images, self.width), factor)
        return composed(f, images, self.width)

    def restricted(self, i: int) -> Model:
        """The germ on xᵢ = 0, in the other variables."""
        require(not self.rules, "only a rational germ is restricted")
        found = Model.__new__(Model)
        found.source = [name for k, name in enumerate(self.source) if k != i]
        found.n = found.width = self.n - 1
        found.known, found.rules, found.arguments = {}, {}, {}
        gens = [found.variable(k) for k in range(self.n - 1)]
        images: list[Polynomial] = [*gens[:i], {}, *gens[i:]]
        found.components = [
            (composed(a, images, found.n), composed(b, images, found.n)) for a, b in self.components
        ]
        return found
