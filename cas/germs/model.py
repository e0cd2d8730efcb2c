"""A germ as rational functions of the source variables and of a few analytic functions, exactly.

Every transcendental or algebraic function T = f(a) − f(a(0)) of the germ becomes a variable of its own that
is 0 at the origin; ∂T/∂xᵢ is a rational function of all variables. What vanishes identically in these m + n
variables vanishes on the graph of T too, so a set of dimension d there meets the graph in dimension d − m at
least. Ideals do not change if a generator is multiplied by a unit: denominators are cleared.
T = a·(c + U) with a the argument and U analytic: with U in place of T, what vanishes with a is seen.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import Ordering, fmpq, fmpq_mpoly_ctx, fmpq_poly

from osculant.cas.errors import DomainError, OsculantError
from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.graph import topological
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import Algebraic, NumberField, rational
from osculant.cas.germs.expansion import moving_nodes
from osculant.cas.germs.germ import Germ

#: degree of the polynomials of a model at most
DEGREE = 400
#: higher powers of units are functions, as those with other exponents are
HIGH = 100
#: the name of the generator of a number field as a variable: no variable of a formula has it
GENERATOR = "_r"
#: a rational function: numerator, denominator (a unit at the origin)
Quotient = tuple[Any, Any]

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


@dataclass(frozen=True)
class Model:
    """The components of a germ, and the derivatives of the functions in them.

    Attributes:
        context: the ring of the variables; the first n are those of the source.
        n: the source dimension.
        components: numerators and denominators.
        rules: for each function its partial derivatives by the source variables, over one denominator.
        field: the number field of the coefficients: its generator is the last variable; None for ℚ.
        arguments: for each function its argument less the value at the origin, and its derivative there as a
            polynomial; None for an argument with a denominator.

    >>> model = model_of(Germ("x, y**3*exp(x)", "x y"))
    >>> model.extra, [str(f) for f in model.gradient(1)]
    (1, ['y^3*_0 + y^3', '3*y^2*_0 + 3*y^2'])
    """

    context: Any
    n: int
    components: tuple[Quotient, ...]
    rules: tuple[tuple[tuple[Any, ...], Any], ...]
    field: NumberField | None = None
    arguments: tuple[tuple[Any, Any] | None, ...] = ()

    @property
    def extra(self) -> int:
        """How many functions became variables."""
        return len(self.rules)

    @property
    def variables(self) -> list[Any]:
        """All variables, those of the source first."""
        return list(self.context.gens())

    @property
    def constants(self) -> list[Any]:
        """The generator of the number field as a variable, if there is one."""
        return [] if self.field is None else self.variables[-1:]

    def divided(self, f: Any) -> Any:
        """A polynomial with U in place of T for the functions T = a·(c + U), a the argument and c = T′(a(0)).

        U is analytic and 0 at the origin too, but what vanishes with a need not be told any more.
        """
        images = self.variables
        for k, told in enumerate(self.arguments):
            if told is not None:
                argument, slope = told
                images[self.n + k] = argument.compose(*images) * (slope + images[self.n + k])
        return f.compose(*images)

    def at_origin(self, f: Any, exponents: tuple[int, ...] = ()) -> Any:
        """The number before a power product of the source variables: by default the value at the origin."""
        width = self.context.nvars() - len(self.constants)
        wanted = (*exponents, *([0] * (width - len(exponents))))
        if self.field is None:
            c = f.to_dict().get(wanted, fmpq(0))
            return Fraction(int(c.p), int(c.q))
        return split(f, self.field).get(wanted, Fraction(0))

    def derivatives(self, f: Any) -> list[Any]:
        """The partial derivatives of a polynomial by the source variables, all times one unit."""
        unit = self.one
        for _, denominator in self.rules:
            unit = unit * denominator
        found = []
        for i in range(self.n):
            total = f.derivative(i) * unit
            for k, (numerators, denominator) in enumerate(self.rules):
                outer = f.derivative(self.n + k)
                if not outer.is_zero() and not numerators[i].is_zero():
                    total = total + outer * numerators[i] * (unit // denominator)
            found.append(total)
        return found

    def gradient(self, j: int) -> list[Any]:
        """The partial derivatives of a component, all times one unit."""
        numerator, denominator = self.components[j]
        above = self.derivatives(numerator)
        if denominator.is_constant():
            return above
        below = self.derivatives(denominator)
        return [a * denominator - b * numerator for a, b in zip(above, below)]

    @property
    def one(self) -> Any:
        """The polynomial 1."""
        return self.context.constant(1)

    @property
    def zero(self) -> Any:
        """The polynomial 0."""
        return self.context.constant(0)

    def restricted(self, i: int) -> Model:
        """The germ on xᵢ = 0, in the other variables; raises ValueError for a germ that is not rational."""
        if self.rules:
            raise ValueError("only a rational germ is restricted")
        names = [name for k, name in enumerate(self.context.names()) if k != i]
        context = ring(names)
        gens = list(context.gens())
        images = [*gens[:i], context.constant(0), *gens[i:]]
        moved = tuple(
            (a.compose(*images, ctx=context), b.compose(*images, ctx=context)) for a, b in self.components
        )
        return Model(context, self.n - 1, moved, (), self.field)


def split(f: Any, field: NumberField) -> dict[tuple[int, ...], Any]:
    """A polynomial whose last variable is the generator of a field, as one over the field."""
    parts: dict[tuple[int, ...], dict[int, fmpq]] = {}
    for m, c in f.to_dict().items():
        parts.setdefault(tuple(map(int, m[:-1])), {})[int(m[-1])] = c
    found = {}
    for m, powers in parts.items():
        value = field.number(fmpq_poly([powers.get(i, fmpq(0)) for i in range(max(powers) + 1)]))
        if value:
            found[m] = value
    return found


def ring(names: Sequence[str], field: NumberField | None = None) -> Any:
    """The polynomials over ℚ in variables of these names, and the generator of a field, if there is one."""
    if field is not None:
        names = [*names, GENERATOR]
    return fmpq_mpoly_ctx.get(list(names), Ordering.degrevlex)


def model_of(germ: Germ) -> Model | None:
    """The model of a germ; None if a function in it has none here (abs, asin, …), or for a high degree."""
    jet = germ.polynomial(poly.LARGEST)
    if jet is not None:
        context = ring(germ.source, germ.field)
        one = context.constant(1)
        components = tuple((polynomial(f, context, germ.n), one) for f in jet)
        return Model(context, germ.n, components, (), germ.field)
    return _Reading(germ).model()


def polynomial(f: poly.Polynomial, context: Any, n: int) -> Any:
    """A polynomial of this room as one of the ring, whose first n variables are its own.

    The last variable is the generator of the number field of the coefficients, if there is one.
    """
    rest = (0,) * (context.nvars() - n)
    terms = {}
    for m, c in f.items():
        parts = c.coefficients() if isinstance(c, Algebraic) else (Fraction(c),)
        for i, part in enumerate(parts):
            if part:
                power = (*rest[1:], i) if i else rest
                terms[(*poly.exponents_of(m, n), *power)] = rational(part)
    return context.from_dict(terms)


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
            r = Fraction(name[1:])
            factor = fmpq(r.numerator, r.denominator)
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
