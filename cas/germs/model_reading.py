"""From the formulas of a germ to its model: every function in them becomes a variable."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from osculant.cas.errors import DomainError, OsculantError
from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.graph import topological
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import rational
from osculant.cas.germs.expansion import moving_nodes
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.model import Model, Quotient, polynomial, ring

#: degree of the polynomials of a model at most
DEGREE = 400
#: higher powers of units are functions, as those with other exponents are
HIGH = 100
#: functions that are modelled: the derivative as a function of the argument a and of the value v
RULES: dict[str, Callable[[Quotient, Quotient], Quotient]] = {
    "exp": lambda a, v: v,
    "log": lambda a, v: (a[1], a[0]),
    "atan": lambda a, v: (a[1] ** 2, a[1] ** 2 + a[0] ** 2),
    "atanh": lambda a, v: (a[1] ** 2, a[1] ** 2 - a[0] ** 2),
    "half": lambda a, v: (v[1] ** 2 + v[0] ** 2, 2 * v[1] ** 2),
    "halfh": lambda a, v: (v[1] ** 2 - v[0] ** 2, 2 * v[1] ** 2),
}
#: functions by the tangent T of half the angle, which keeps their relations: numerator, denominator
HALVES: dict[str, tuple[str, Callable[[Any, Any], Quotient]]] = {
    "sin": ("half", lambda t, one: (2 * t, one + t**2)),
    "cos": ("half", lambda t, one: (one - t**2, one + t**2)),
    "tan": ("half", lambda t, one: (2 * t, one - t**2)),
    "sinh": ("halfh", lambda t, one: (2 * t, one - t**2)),
    "cosh": ("halfh", lambda t, one: (one + t**2, one - t**2)),
    "tanh": ("halfh", lambda t, one: (2 * t, one + t**2)),
}
#: powers with other exponents, as functions
ROOTS = {"sqrt": Fraction(1, 2), "cbrt": Fraction(1, 3)}


def model_of(germ: Germ) -> Model | None:
    """The model of a germ; None if a function in it has none here (abs, asin, …), or for a high degree."""
    jet = germ.polynomial(poly.LARGEST)
    if jet is not None:
        context = ring(germ.source, germ.field)
        one = context.constant(1)
        components = tuple((polynomial(f, context, germ.n), one) for f in jet)
        return Model(context, germ.n, components, (), germ.field)
    return _Reading(germ).model()


class _Reading:
    """The way from an expression graph to a model."""

    def __init__(self, germ: Germ) -> None:
        self.germ = germ
        self.nodes, self.moving = topological(germ.components), moving_nodes(germ.components, germ.source)
        high = [node for node in self.nodes if node.kind == "pow" and abs(node.value) > HIGH]
        bases = [f.get(0, 0) for f in germ.expanded(tuple(node.args[0] for node in high), 0)]
        self.high = {node for node, base in zip(high, bases) if base}
        self.keys: dict[tuple[str, Node], int] = {}
        for node in self.nodes:
            for key in self.functions(node):
                self.keys.setdefault(key, len(self.keys))
        names = [*germ.source, *(f"_{k}" for k in range(len(self.keys)))]
        self.context = ring(names, germ.field)
        self.gens = list(self.context.gens())

    def whole(self, node: Node) -> bool:
        """Whether a node is a power that is multiplied out."""
        return node.kind == "pow" and node.value.denominator == 1 and node not in self.high

    def constant(self, node: Node) -> bool:
        """Whether a node is a function of numbers."""
        return node.kind in {"call", "pow"} and node not in self.moving

    def functions(self, node: Node) -> list[tuple[str, Node]]:
        """The function that a node needs as a variable, if it needs one."""
        if node.kind == "pow" and not self.whole(node) and not self.constant(node):
            return [(f"^{node.value}", node.args[0])]
        if node.kind != "call" or self.constant(node):
            return []
        name = f"^{ROOTS[node.value]}" if node.value in ROOTS else node.value
        return [(HALVES[name][0] if name in HALVES else name, node.args[0])]

    def model(self) -> Model | None:
        values: dict[Node, Quotient] = {}
        rules: dict[int, tuple[Node, Callable[[Quotient], Quotient]]] = {}
        try:
            for node in self.nodes:
                args = [values[a] for a in node.args]
                degree = max((f.total_degree() for pair in args for f in pair), default=0)
                if degree * (abs(int(node.value)) if self.whole(node) else 1) > DEGREE:
                    return None
                values[node] = self.quotient(node, args, rules)
        except (KeyError, OsculantError):
            return None
        field = self.germ.field
        draft = Model(self.context, self.germ.n, tuple(values[f] for f in self.germ.components), (), field)
        done: list[tuple[tuple[Any, ...], Any]] = []
        arguments: list[tuple[Any, Any] | None] = []
        for k in range(len(self.keys)):  # a function's argument has only functions before it
            argument, derivative = rules[k]
            inner = Model(self.context, self.germ.n, (values[argument],), tuple(done), field)
            unit = inner.one
            for _, denominator in done:
                unit = unit * denominator
            above, below = derivative(values[argument])
            arguments.append(self.argument(draft, values[argument], above, below))
            bottom = below * unit * values[argument][1] ** 2
            if values[argument][1].is_constant():  # the gradient was not multiplied by its square
                above, bottom = above / values[argument][1].leading_coefficient(), below * unit
            done.append((tuple(above * g for g in inner.gradient(0)), bottom))
        return Model(draft.context, draft.n, draft.components, tuple(done), field, tuple(arguments))

    def argument(self, draft: Model, value: Quotient, above: Any, below: Any) -> tuple[Any, Any] | None:
        """What `Model.arguments` tells of a function."""
        s, t = value
        if not t.is_constant():
            return None
        s = s / t.leading_coefficient()
        start, slope = draft.at_origin(s), draft.at_origin(above) / draft.at_origin(below)
        numbers = [polynomial({0: c} if c else {}, self.context, self.germ.n) for c in (start, slope)]
        return s - numbers[0], numbers[1]

    def quotient(self, node: Node, args: list[Quotient], rules: dict[int, Any]) -> Quotient:
        one = self.context.constant(1)
        if node.kind == "number" or self.constant(node):
            return self.number(node), one
        if node.kind == "variable" and node.value not in self.germ.source:
            return self.gens[-1], one  # the stated root
        if node.kind == "variable":
            return self.gens[self.germ.source.index(node.value)], one
        if node.kind in {"add", "sub"}:
            (a, b), (c, d) = args
            c = c if node.kind == "add" else -c
            return (a + c, b) if b == d else (a * d + c * b, b * d)
        if node.kind == "neg":
            return -args[0][0], args[0][1]
        if node.kind == "mul":
            return args[0][0] * args[1][0], args[0][1] * args[1][1]
        if node.kind == "div":
            return args[0][0] * args[1][1], args[0][1] * args[1][0]
        if self.whole(node):
            e = int(node.value)
            a, b = args[0] if e >= 0 else args[0][::-1]
            return a ** abs(e), b ** abs(e)
        return self.function(node, args[0], rules)

    def function(self, node: Node, argument: Quotient, rules: dict[int, Any]) -> Quotient:
        """The variable of a function plus the value at the origin; the rule is noted."""
        ((name, inner),) = self.functions(node)
        one, k = self.context.constant(1), self.keys[name, inner]
        variable = self.gens[self.germ.n + k]
        value = (variable + self.start(name, inner), one)
        if name.startswith("^"):
            factor = rational(Fraction(name[1:]))
            rules[k] = inner, lambda a: (value[0] * a[1] * factor, value[1] * a[0])
        else:
            rules[k] = inner, lambda a: RULES[name](a, value)
        return HALVES[node.value][1](variable, one) if node.kind == "call" and node.value in HALVES else value

    def number(self, node: Node) -> Any:
        """The value of a node at the origin as a polynomial; an OsculantError if it is not in the field."""
        c = self.germ.expanded((node,), 0)[0].get(0, 0)
        return polynomial({0: c} if c else {}, self.context, self.germ.n)

    def start(self, name: str, inner: Node) -> Any:
        """The value of the function at the origin; an OsculantError if it is not in the field."""
        from osculant.cas.formulas.expression import call, number, power

        if name in {"half", "halfh"}:  # other angles have no rational sines
            if at := self.germ.expanded((inner,), 0)[0].get(0, 0):
                raise DomainError(f"A function has no rational value at {at}.")
            return self.context.constant(0)
        node = power(inner, number(Fraction(name[1:]))) if name.startswith("^") else call(name, inner)
        return self.number(node)
