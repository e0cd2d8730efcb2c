"""The recurrences of Taylor arithmetic, one per operation and function, written as instructions.

From the normalised Taylor coefficients f⁽ᵏ⁾/k! of its arguments every node of an expression graph gets its
own (Griewank & Walther, *Evaluating Derivatives*, ch. 13).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import factorial
from typing import Any, NamedTuple

from osculant.cas.errors import FormulaError
from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.graph import topological


class Instruction(NamedTuple):
    """One assignment: ``op`` of the values at ``args``; ``value`` is its exact constant or name.

    ``op`` is one of number, constant, variable, parameter, add, sub, mul, div, neg, call, power.
    """

    op: str
    args: tuple[int, ...] = ()
    value: Any = None


def write(
    formulas: Sequence[Node], order: int, variable: str, normalised: bool, parameters: Sequence[str] = ()
) -> tuple[list[Instruction], list[list[int]]]:
    """Instructions, none twice, for the derivatives 0…order of the formulas, and where their values are.

    The second list has for every formula the indices of its derivatives, or of its Taylor coefficients
    f⁽ᵏ⁾/k! if they are to be ``normalised``; some instructions may serve none of these.  ``parameters`` are
    other variables, which do not change.  Raises FormulaError if a formula has a variable besides.

    >>> from osculant.cas.formulas.expression import variable
    >>> steps, [square] = write([variable("t") ** 2], 2, "t", False)
    >>> [steps[index].op for index in square], steps[square[2]].value
    (['mul', 'add', 'number'], Fraction(2, 1))
    """
    writer = Writer(variable, parameters)
    series: dict[Node, list[int]] = {}
    for node in topological(formulas):
        series[node] = writer.series(node, [series[arg] for arg in node.args], order + 1)
    outputs = [
        [c if normalised else writer.scale(c, Fraction(factorial(k))) for k, c in enumerate(series[f])]
        for f in formulas
    ]
    return writer.steps, outputs


class Writer:
    """Writes instructions once each, folding exact rationals so that structural zeros cost nothing."""

    def __init__(self, variable: str, parameters: Sequence[str] = ()) -> None:
        self.variable, self.parameters = variable, parameters
        self.steps: list[Instruction] = []
        self.known: dict[tuple[str, tuple[int, ...], Fraction | str | None], int] = {}
        self.numbers: dict[tuple[int, int], int] = {}  # a fraction takes its time to hash
        self.rationals: dict[int, Fraction] = {}
        self.zero = self.number(Fraction(0))
        self.one = self.number(Fraction(1))

    # --- single values -------------------------------------------------------------------------
    def emit(self, op: str, *args: int, value: Fraction | str | None = None) -> int:
        """The number of an instruction, written if it is new."""
        step = op, args, value
        index = self.known.get(step)
        if index is None:
            index = self.known[step] = len(self.steps)
            self.steps.append(Instruction(*step))
        return index

    def number(self, value: Fraction) -> int:
        """A rational."""
        pair = value.numerator, value.denominator
        if pair not in self.numbers:
            self.numbers[pair] = len(self.steps)
            self.rationals[len(self.steps)] = value
            self.steps.append(Instruction("number", (), value))
        return self.numbers[pair]

    def add(self, a: int, b: int) -> int:
        """a + b."""
        if a == self.zero or b == self.zero:
            return b if a == self.zero else a
        p, q = self.rationals.get(a), self.rationals.get(b)
        return self.emit("add", a, b) if p is None or q is None else self.number(p + q)

    def neg(self, a: int) -> int:
        """−a."""
        p = self.rationals.get(a)
        return self.number(-p) if p is not None else self.emit("neg", a)

    def sub(self, a: int, b: int) -> int:
        """a − b."""
        if b == self.zero:
            return a
        if a == self.zero:
            return self.neg(b)
        p, q = self.rationals.get(a), self.rationals.get(b)
        return self.emit("sub", a, b) if p is None or q is None else self.number(p - q)

    def mul(self, a: int, b: int) -> int:
        """a·b."""
        if a == self.zero or b == self.zero:
            return self.zero
        if a == self.one or b == self.one:
            return b if a == self.one else a
        p, q = self.rationals.get(a), self.rationals.get(b)
        if p is not None and q is not None:
            return self.number(p * q)
        return self.emit("mul", a, b) if a < b else self.emit("mul", b, a)

    def div(self, a: int, b: int) -> int:
        """a/b."""
        if a == self.zero or b == self.one:
            return a
        p, q = self.rationals.get(a), self.rationals.get(b)
        return self.number(p / q) if p is not None and q else self.emit("div", a, b)

    def scale(self, a: int, factor: Fraction) -> int:
        """A rational multiple."""
        return self.mul(a, self.number(factor))

    def call(self, name: str, a: int) -> int:
        """An elementary function of a value."""
        return self.emit("call", a, value=name)

    def dot(self, a: Sequence[int], b: Sequence[int]) -> int:
        """Σ aⱼ b_{n−1−j}: one coefficient of a product."""
        total = self.zero
        for x, y in zip(a, reversed(b), strict=True):
            total = self.add(total, self.mul(x, y))
        return total

    # --- whole series --------------------------------------------------------------------------
    def series(self, node: Node, args: list[list[int]], n: int) -> list[int]:
        """The first n coefficients of a node whose arguments have the series ``args``."""
        kind = node.kind
        if kind == "number":
            return self.padded(self.number(node.value), n)
        if kind in ("pi", "e"):
            return self.padded(self.emit("constant", value=kind), n)
        if kind == "variable":
            if node.value in self.parameters:
                return self.padded(self.emit("parameter", value=str(node.value)), n)
            if node.value != self.variable:
                raise FormulaError(
                    f"The formula contains the variable {node.value!r}; only {self.variable!r} is allowed."
                )
            return self.padded(self.emit("variable"), n)[:1] + self.padded(self.one, n)[: n - 1]
        if kind in ("add", "sub"):
            combine = self.add if kind == "add" else self.sub
            return [combine(x, y) for x, y in zip(*args, strict=True)]
        if kind == "neg":
            return [self.neg(x) for x in args[0]]
        if kind == "mul":
            return self.product(args[0], args[1])
        if kind == "div":
            return self.quotient(args[0], args[1])
        if kind == "pow":
            return self.power(args[0], node.value)
        return _RULES[node.value](self, args[0])

    def padded(self, first: int, n: int) -> list[int]:
        """The series of a constant."""
        return [first] + [self.zero] * (n - 1)

    def product(self, a: list[int], b: list[int]) -> list[int]:
        """The product of two series."""
        return [self.dot(a[: k + 1], b[: k + 1]) for k in range(len(a))]

    def quotient(self, a: list[int], b: list[int]) -> list[int]:
        """a/b of two series."""
        q: list[int] = []
        for k in range(len(a)):
            q.append(self.div(self.sub(a[k], self.dot(q, b[1 : k + 1])), b[0]))
        return q

    def power(self, a: list[int], exponent: Fraction) -> list[int]:
        """a**exponent: repeated products for integers, else the rule of p′a = r a′p."""
        if exponent.denominator == 1:
            whole = self.natural_power(a, abs(int(exponent)))
            return whole if exponent > 0 else self.quotient(self.padded(self.one, len(a)), whole)
        if exponent == Fraction(1, 2):
            return self.powered(a, exponent, self.call("sqrt", a[0]))
        return self.powered(a, exponent, self.emit("power", a[0], value=exponent))

    def natural_power(self, a: list[int], n: int) -> list[int]:
        """a**n by repeated squares."""
        result, square = self.padded(self.one, len(a)), a
        while n:
            if n & 1:
                result = self.product(result, square)
            n >>= 1
            if n:
                square = self.product(square, square)
        return result

    def powered(self, a: list[int], r: Fraction, first: int) -> list[int]:
        """a**r from its first coefficient."""
        p = [first]
        for k in range(1, len(a)):
            weighted = [self.scale(a[j], j * r - (k - j)) for j in range(1, k + 1)]
            p.append(self.div(self.dot(p, weighted), self.scale(a[0], Fraction(k))))
        return p

    def slopes(self, a: list[int]) -> list[int]:
        """The coefficients j·aⱼ, j ≥ 1, of t·a′."""
        return [self.scale(a[j], Fraction(j)) for j in range(1, len(a))]

    def integral(self, first: int, a: list[int], density: Callable[[int, list[int]], int]) -> list[int]:
        """y with y₀ = first and y′ = a′·g, where ``density(k, y)`` gives g_k once y₀…y_k are known."""
        slopes, y, g = self.slopes(a), [first], [density(0, [first])] if len(a) > 1 else []
        for k in range(1, len(a)):
            y.append(self.scale(self.dot(slopes[:k], g), Fraction(1, k)))
            if k + 1 < len(a):
                g.append(density(k, y))
        return y

    def inverse_function(self, name: str, a: list[int], density: list[int]) -> list[int]:
        """y with y′ = a′·g for a function by its name and the series g of its derivative."""
        return self.integral(self.call(name, a[0]), a, lambda k, _y: density[k])

    def paired(self, a: list[int], names: tuple[str, str], sign: int) -> tuple[list[int], list[int]]:
        """s, c with s′ = a′c and c′ = sign·a′s (sine and cosine, hyperbolic or not)."""
        slopes = self.slopes(a)
        s, c = [self.call(names[0], a[0])], [self.call(names[1], a[0])]
        for k in range(1, len(a)):
            next_s = self.scale(self.dot(slopes[:k], c), Fraction(1, k))
            next_c = self.scale(self.dot(slopes[:k], s), Fraction(sign, k))
            s.append(next_s)
            c.append(next_c)
        return s, c

    def one_plus(self, a: list[int], sign: int) -> list[int]:
        """1 + sign·a²."""
        square = self.product(a, a)
        combine = self.add if sign > 0 else self.sub
        return [combine(one, x) for one, x in zip(self.padded(self.one, len(a)), square, strict=True)]


def _tan(w: Writer, a: list[int]) -> list[int]:
    # tan′ = (1 + tan²)a′
    def density(k: int, y: list[int]) -> int:
        return w.add(w.one if k == 0 else w.zero, w.dot(y[: k + 1], y[: k + 1]))

    return w.integral(w.call("tan", a[0]), a, density)


def _tanh(w: Writer, a: list[int]) -> list[int]:
    # tanh′ = g a′ and g′ = −2 tanh g a′ with g = 1/cosh²; 1 − tanh² would cancel where tanh is nearly ±1
    slopes, below = w.slopes(a), w.div(w.one, w.call("cosh", a[0]))
    y, g = [w.call("tanh", a[0])], [w.mul(below, below)]
    products: list[int] = []
    for k in range(1, len(a)):
        products.append(w.dot(y, g))
        next_y = w.scale(w.dot(slopes[:k], g), Fraction(1, k))
        g.append(w.scale(w.dot(slopes[:k], products), Fraction(-2, k)))
        y.append(next_y)
    return y


def _inverse_root(w: Writer, a: list[int], square: list[int]) -> list[int]:
    return w.power(square, Fraction(-1, 2))


def _log(w: Writer, a: list[int]) -> list[int]:
    return w.inverse_function("log", a, w.quotient(w.padded(w.one, len(a)), a))


def _abs(w: Writer, a: list[int]) -> list[int]:
    sign = w.call("sign", a[0])
    return [w.mul(sign, x) for x in a]


def _reciprocal(w: Writer, a: list[int]) -> list[int]:
    return w.quotient(w.padded(w.one, len(a)), a)


def _less_one(w: Writer, a: list[int]) -> list[int]:
    return [w.neg(x) for x in w.one_plus(a, -1)]


_RULES: Mapping[Any, Callable[[Writer, list[int]], list[int]]] = {
    "exp": lambda w, a: w.integral(w.call("exp", a[0]), a, lambda k, y: y[k]),
    "log": _log,
    "sin": lambda w, a: w.paired(a, ("sin", "cos"), -1)[0],
    "cos": lambda w, a: w.paired(a, ("sin", "cos"), -1)[1],
    "sinh": lambda w, a: w.paired(a, ("sinh", "cosh"), 1)[0],
    "cosh": lambda w, a: w.paired(a, ("sinh", "cosh"), 1)[1],
    "tan": _tan,
    "tanh": _tanh,
    "atan": lambda w, a: w.inverse_function("atan", a, _reciprocal(w, w.one_plus(a, 1))),
    "atanh": lambda w, a: w.inverse_function("atanh", a, _reciprocal(w, w.one_plus(a, -1))),
    "asin": lambda w, a: w.inverse_function("asin", a, _inverse_root(w, a, w.one_plus(a, -1))),
    "acos": lambda w, a: w.inverse_function(
        "acos", a, [w.neg(g) for g in _inverse_root(w, a, w.one_plus(a, -1))]
    ),
    "asinh": lambda w, a: w.inverse_function("asinh", a, _inverse_root(w, a, w.one_plus(a, 1))),
    "acosh": lambda w, a: w.inverse_function("acosh", a, _inverse_root(w, a, _less_one(w, a))),
    "cbrt": lambda w, a: w.powered(a, Fraction(1, 3), w.call("cbrt", a[0])),
    "abs": _abs,
}
