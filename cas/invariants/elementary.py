"""A formula's graph → elements of a differential field (`osculant.cas.invariants.differential_field`).

Kernels are chosen so that relations are seen: sin(t) and cos(t/3) are polynomials in sin(t/3) and cos(t/3),
tan is their quotient, exp(2t) and exp(−t) are powers of one exponential, a phase such as π/3 is expanded.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import gcd, lcm

import sympy

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import ONE, PI, Node, call, div, mul, neg, number, power
from osculant.cas.formulas.graph import topological
from osculant.cas.formulas.sympy_bridge import from_sympy, to_sympy
from osculant.cas.invariants.differential_field import Element, Field

#: multiples of a common angle that are still expanded
MULTIPLES = 24

#: function → (kernel for even parts, kernel for odd parts, square of the imaginary unit)
FAMILIES = {
    **dict.fromkeys(("sin", "cos", "tan"), ("cos", "sin", -1)),
    **dict.fromkeys(("sinh", "cosh", "tanh"), ("cosh", "sinh", 1)),
}


def embed(formulas: Sequence[Node], variable: str = "t") -> list[Element]:
    """The formulas as elements of one new field, whose variable has derivative 1.

    Raises UndecidedError for a formula beyond the field's caps, DomainError for one that divides by zero.

    >>> from osculant.cas.invariants.field_forms import expression
    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> x, y = embed(parse_tuple("cos(t/3)**3*cos(t), cos(t/3)**3*sin(t)"))
    >>> expression(x.derivative() ** 2 + y.derivative() ** 2)
    cos(t/3)**4
    """
    embedding = _Embedding(formulas, variable)
    return [embedding.element(formula) for formula in formulas]


def _split(node: Node) -> tuple[Fraction, Node]:
    """(q, rest) with node = q*rest and no rational factor left in the rest."""
    if node.kind == "number":
        return node.value, ONE
    if node.kind == "neg":
        q, rest = _split(node.args[0])
        return -q, rest
    if node.kind in {"mul", "div"}:
        (p, left), (q, right) = map(_split, node.args)
        if node.kind == "mul":
            return p * q, mul(left, right)
        return p / q, div(left, right)
    return Fraction(1), node


def _angle(node: Node, constant: frozenset[Node]) -> tuple[Fraction, Node, Node | None]:
    """(q, core, shift) with node = q*core + shift, where the shift is a rational multiple of π or absent."""
    if node.kind in {"add", "sub"}:
        first, second = node.args
        sign = 1 if node.kind == "add" else -1
        if second in constant and _split(second)[1] is PI:
            return *_split(first), second if sign > 0 else neg(second)
        if first in constant and _split(first)[1] is PI:
            q, core = _split(second)
            return sign * q, core, first
    return *_split(node), None


class _Embedding:
    def __init__(self, formulas: Sequence[Node], variable: str) -> None:
        self.field = Field()
        self.values: dict[Node, Element] = {}
        self.kernels: dict[object, Element] = {}
        self.variable = self.field.generator(sympy.Symbol(variable, real=True))
        self.field.differentiate(self.variable, self.field.number(1))
        nodes = topological(formulas)
        varying: set[Node] = set()
        for node in nodes:
            if node.kind == "variable" or any(argument in varying for argument in node.args):
                varying.add(node)
        self.constant = frozenset(nodes) - varying
        self.units = self._common_units([node for node in varying if node.kind == "call"])

    def _common_units(self, calls: list[Node]) -> dict[tuple[str, Node], Fraction]:
        """For each core of an angle or exponent the largest unit of which all its factors are multiples."""
        factors: dict[tuple[str, Node], set[Fraction]] = {}
        for node in calls:
            if node.value in FAMILIES or node.value == "exp":
                family = FAMILIES[node.value][0] if node.value in FAMILIES else "exp"
                q, core, _ = _angle(node.args[0], self.constant)
                factors.setdefault((family, core), set()).add(abs(q))
        units = {}
        for key, all_factors in factors.items():
            below = lcm(*(q.denominator for q in all_factors))
            unit = Fraction(gcd(*(int(q * below) for q in all_factors)), below)
            if max(all_factors) <= MULTIPLES * unit:
                units[key] = unit
        return units

    def element(self, formula: Node) -> Element:
        """The element of a node, by the elements of its arguments."""
        if formula not in self.values:
            for node in topological([formula]):
                if node not in self.values:
                    try:
                        self.values[node] = self._rule(node, [self.values[a] for a in node.args])
                    except ZeroDivisionError:
                        raise DomainError(
                            "The formula divides by a quantity that is zero everywhere."
                        ) from None
        return self.values[formula]

    def _rule(self, node: Node, args: list[Element]) -> Element:
        match node.kind:
            case "number":
                return self.field.number(node.value)
            case "variable":
                return self.variable
            case "pi" | "e":
                return self._constant(to_sympy(node))
            case "add":
                return args[0] + args[1]
            case "sub":
                return args[0] - args[1]
            case "mul":
                return args[0] * args[1]
            case "div":
                return args[0] / args[1]
            case "neg":
                return -args[0]
            case "pow" if node.value.denominator == 1:
                return args[0] ** int(node.value)
            case "pow":
                root = self._root(node.args[0], node.value.denominator)
                return root ** int(node.value.numerator)
        if node in self.constant:
            value = to_sympy(node)
            return self._constant(value) if value.is_Function else self.element(from_sympy(value))
        return self._function(node.value, node.args[0])

    def _constant(self, value: sympy.Expr) -> Element:
        if value not in self.kernels:
            self.kernels[value] = self.field.generator(value)
        return self.kernels[value]

    def _root(self, base: Node, degree: int, real_cube: bool = False) -> Element:
        """base**(1/degree), or cbrt(base)."""
        key = ("root", base, degree, real_cube)
        if key not in self.kernels:
            inside = self.element(base)
            one = number(Fraction(1, degree))
            symbol = to_sympy(call("cbrt", base) if real_cube else power(base, one))
            kernel = self.field.generator(symbol, degree, inside)
            self.kernels[key] = kernel
            self.field.differentiate(kernel, kernel * inside.derivative() / (degree * inside))
        return self.kernels[key]

    def _function(self, name: str, u: Node) -> Element:
        """The element of a function of a varying argument."""
        if name in FAMILIES:
            even, odd = self._pair(FAMILIES[name], u)
            return {"cos": even, "cosh": even, "sin": odd, "sinh": odd}.get(name) or odd / even
        if name == "exp":
            q, core = _split(u)
            unit = self.units.get(("exp", core))
            if unit is None:
                return self._kernel("exp", u)
            return self._kernel("exp", mul(number(unit), core)) ** int(q / unit)
        if name == "cbrt":
            return self._root(u, 3, real_cube=True)
        return self._kernel(name, u)

    def _pair(self, family: tuple[str, str, int], u: Node) -> tuple[Element, Element]:
        """(cos u, sin u) or (cosh u, sinh u)."""
        even, odd, square = family
        q, core, shift = _angle(u, self.constant)
        unit = self.units.get((even, core))
        if unit is None or (shift is not None and square > 0):
            q, unit, core, shift = Fraction(1), Fraction(1), u, None
        base = mul(number(unit), core)
        c, s = self._kernel(even, base), self._kernel(odd, base)
        real, imaginary = self.field.number(1), self.field.number(0)
        for _ in range(abs(int(q / unit))):  # (c + is)ⁿ
            real, imaginary = real * c + square * (imaginary * s), real * s + imaginary * c
        if q < 0:
            imaginary = -imaginary
        if shift is not None:
            c, s = (self.element(from_sympy(to_sympy(call(name, shift)))) for name in ("cos", "sin"))
            real, imaginary = real * c - imaginary * s, real * s + imaginary * c
        return real, imaginary

    def _kernel(self, name: str, u: Node) -> Element:
        """The generator name(u), with its derivative and relation."""
        key = (name, u)
        if key not in self.kernels:
            inside = self.element(u)
            symbol = to_sympy(call(name, u))
            if name in {"sin", "sinh"}:
                return self._odd_partner(key, symbol, inside)
            squared = inside**2 if name == "abs" else None
            kernel = self.field.generator(symbol, 2 if name == "abs" else 0, squared)
            self.kernels[key] = kernel
            if name not in {"cos", "cosh"}:  # those get theirs with their odd partner
                self.field.differentiate(kernel, self._outer(name, u, kernel) * inside.derivative())
        return self.kernels[key]

    def _odd_partner(self, key: tuple[str, Node], symbol: sympy.Expr, inside: Element) -> Element:
        """sin or sinh beside its even partner; their derivatives are set together."""
        name, u = key
        even_name, _, sign = FAMILIES[name]
        even = self._kernel(even_name, u)
        odd = self.kernels[key] = self.field.generator(symbol, 2, sign * (even**2 - 1))
        self.field.differentiate(odd, even * inside.derivative())
        self.field.differentiate(even, sign * odd * inside.derivative())
        return odd

    def _outer(self, name: str, u: Node, kernel: Element) -> Element:
        """The derivative of a function at u."""
        if name == "exp":
            return kernel
        if name == "abs":
            return kernel / self.element(u)
        half = number(Fraction(-1, 2))
        rules: dict[str, Callable[[], Node]] = {
            "log": lambda: ONE / u,
            "asin": lambda: power(1 - u * u, half),
            "acos": lambda: -power(1 - u * u, half),
            "atan": lambda: ONE / (1 + u * u),
            "asinh": lambda: power(1 + u * u, half),
            "acosh": lambda: power(u - 1, half) * power(u + 1, half),
            "atanh": lambda: ONE / (1 - u * u),
        }
        return self.element(rules[name]())
