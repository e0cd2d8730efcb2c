"""Expressions as a hash-consed graph: equal expressions are one and the same node.

A `Node` is a number (an exact rational), one of the constants pi and e, a variable, or an operation on one
or two nodes. The constructors fold rationals exactly and do nothing else, so that a graph has the shape of
the formula that it came from. Every number is bounded: numerator and denominator have at most
`osculant.cas.formulas.rationals.BITS` bits. Nothing here recurses: graphs may be as deep as memory allows.
"""

from __future__ import annotations

import re
import threading
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any
from weakref import WeakValueDictionary

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas.rationals import bounded, exact_power, exact_root, shown
from osculant.cas.formulas.text import to_text

if TYPE_CHECKING:
    import sympy

_CIRCULAR = {"sin", "cos", "tan", "asin", "acos", "atan"}
FUNCTIONS = frozenset(_CIRCULAR | {name + "h" for name in _CIRCULAR} | {"exp", "log", "sqrt", "cbrt", "abs"})
ALIASES = {"ln": "log"}
ALIASES |= {"arc" + name[1:]: name for name in FUNCTIONS if name[0] == "a" and name != "abs"}
ALIASES |= {"ar" + name[1:]: name for name in FUNCTIONS if name[0] == "a" and name[-1] == "h"}
RECIPROCALS = {"sec": "cos", "csc": "sin", "cot": "tan", "sech": "cosh", "csch": "sinh", "coth": "tanh"}
RESERVED = FUNCTIONS | set(ALIASES) | set(RECIPROCALS) | {"pi", "e"}

# Where a function of a rational number is real; the others are real everywhere.
_DOMAINS: dict[str, tuple[Callable[[Fraction], bool], str]] = {
    "log": (lambda q: q > 0, "positive numbers"),
    "asin": (lambda q: abs(q) <= 1, "numbers in [-1, 1]"),
    "acos": (lambda q: abs(q) <= 1, "numbers in [-1, 1]"),
    "acosh": (lambda q: q >= 1, "numbers that are at least 1"),
    "atanh": (lambda q: abs(q) < 1, "numbers in (-1, 1)"),
}


class Node:
    """One vertex of the graph: immutable, and identical (`is`) with every structurally equal node.

    kind: "number", "pi", "e", "variable", "add", "sub", "mul", "div", "neg", "pow" or "call".
    args: the operands, () for the first four kinds.
    value: the Fraction of a "number", the exponent (a Fraction) of a "pow", the name of a "variable" or a
    "call", None otherwise.

    Nodes are made by the constructors of this module and by the operators + - * / ** with nodes, int and
    Fraction.

    >>> t = variable("t")
    >>> (t + 1) ** 2 is (t + 1) ** 2
    True
    >>> print(t**2 / 3 - 1)
    t**2/3 - 1
    """

    __slots__ = ("__weakref__", "args", "kind", "value")
    kind: str
    args: tuple[Node, ...]
    value: Any

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a node is immutable; {name!r} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a node is immutable; {name!r} cannot be deleted")

    def __reduce__(self) -> tuple[Any, ...]:
        return _node, (self.kind, self.args, self.value)

    def __str__(self) -> str:
        return to_text(self)

    def __repr__(self) -> str:
        try:
            return f"Node({to_text(self)!r})"
        except FormulaError:
            return f"<a large {self.kind} node>"

    def __add__(self, other: Node | int | Fraction) -> Node:
        return add(self, _coerce(other)) if isinstance(other, _OPERANDS) else NotImplemented

    def __radd__(self, other: int | Fraction) -> Node:
        return add(_coerce(other), self) if isinstance(other, _OPERANDS) else NotImplemented

    def __sub__(self, other: Node | int | Fraction) -> Node:
        return sub(self, _coerce(other)) if isinstance(other, _OPERANDS) else NotImplemented

    def __rsub__(self, other: int | Fraction) -> Node:
        return sub(_coerce(other), self) if isinstance(other, _OPERANDS) else NotImplemented

    def __mul__(self, other: Node | int | Fraction) -> Node:
        return mul(self, _coerce(other)) if isinstance(other, _OPERANDS) else NotImplemented

    def __rmul__(self, other: int | Fraction) -> Node:
        return mul(_coerce(other), self) if isinstance(other, _OPERANDS) else NotImplemented

    def __truediv__(self, other: Node | int | Fraction) -> Node:
        return div(self, _coerce(other)) if isinstance(other, _OPERANDS) else NotImplemented

    def __rtruediv__(self, other: int | Fraction) -> Node:
        return div(_coerce(other), self) if isinstance(other, _OPERANDS) else NotImplemented

    def __pow__(self, other: Node | int | Fraction) -> Node:
        return power(self, _coerce(other)) if isinstance(other, _OPERANDS) else NotImplemented

    def __rpow__(self, other: int | Fraction) -> Node:
        return power(_coerce(other), self) if isinstance(other, _OPERANDS) else NotImplemented

    def __neg__(self) -> Node:
        return neg(self)

    def __pos__(self) -> Node:
        return self

    def __abs__(self) -> Node:
        return call("abs", self)


_OPERANDS = (Node, int, Fraction)
_table: WeakValueDictionary[tuple[str, tuple[Node, ...], Any], Node] = WeakValueDictionary()
_lock = threading.Lock()


def _node(kind: str, args: tuple[Node, ...] = (), value: Any = None) -> Node:
    key = (kind, args, value)
    with _lock:  # two threads must not make two nodes of one expression
        node = _table.get(key)
        if node is None:
            node = Node.__new__(Node)
            object.__setattr__(node, "kind", kind)
            object.__setattr__(node, "args", args)
            object.__setattr__(node, "value", value)
            _table[key] = node
    return node


def _coerce(operand: Node | int | Fraction) -> Node:
    return operand if isinstance(operand, Node) else number(operand)


def number(q: int | Fraction) -> Node:
    """The exact rational q; FormulaError if it needs more than `rationals.BITS` bits.

    >>> number(Fraction(1, 10)).value
    Fraction(1, 10)
    """
    return _node("number", (), bounded(Fraction(q)))


PI = _node("pi")
E = _node("e")
ZERO = number(0)
ONE = number(1)
MINUS_ONE = number(-1)


def variable(name: str) -> Node:
    """The variable of that name: a letter, then letters, digits and underscores, none of `RESERVED`."""
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name, re.ASCII):
        raise FormulaError(f"{name!r} is no name of a variable; use a letter, then letters, digits or _.")
    if name in RESERVED:
        raise FormulaError(f"{name!r} names a function or a constant; give the variable another name.")
    return _node("variable", (), name)


def add(a: Node, b: Node) -> Node:
    """a + b."""
    if a.kind == b.kind == "number":
        return number(a.value + b.value)
    if a is ZERO:
        return b
    return a if b is ZERO else _node("add", (a, b))


def sub(a: Node, b: Node) -> Node:
    """a - b."""
    if a.kind == b.kind == "number":
        return number(a.value - b.value)
    if a is ZERO:
        return neg(b)
    return a if b is ZERO else _node("sub", (a, b))


def mul(a: Node, b: Node) -> Node:
    """a * b; 0 if either is the number 0."""
    if a.kind == b.kind == "number":
        return number(a.value * b.value)
    for factor, other in ((a, b), (b, a)):
        if factor is ZERO:
            return ZERO
        if factor is ONE:
            return other
        if factor is MINUS_ONE:
            return neg(other)
    return _node("mul", (a, b))


def div(a: Node, b: Node) -> Node:
    """a / b; DomainError if b is the number 0."""
    if b is ZERO:
        raise DomainError("Division by zero: the divisor is exactly 0.")
    if a.kind == b.kind == "number":
        return number(a.value / b.value)
    if b is MINUS_ONE:
        return neg(a)
    return a if b is ONE else _node("div", (a, b))


def neg(a: Node) -> Node:
    """-a."""
    if a.kind == "number":
        return number(-a.value)
    return a.args[0] if a.kind == "neg" else _node("neg", (a,))


def power(base: Node, exponent: Node) -> Node:
    """base ** exponent: kind "pow" for a rational exponent, exp(exponent*log(base)) for any other.

    A power of e becomes a call of exp. Roots are real: DomainError for a negative number under an exponent
    that is not an integer, and for 0 under a negative one; FormulaError if a number would outgrow
    `rationals.BITS`.

    >>> print(power(number(8), number(Fraction(2, 3))), power(variable("t"), variable("s")))
    4 exp(s*log(t))
    """
    if exponent.kind != "number":
        return call("exp", exponent if base is E else mul(exponent, call("log", base)))
    q: Fraction = exponent.value
    if q == 0:
        return ONE
    if q == 1:
        return base
    if base is E:
        return call("exp", exponent)
    if base.kind == "number":
        value = exact_power(base.value, q)
        return _node("pow", (base,), q) if value is None else number(value)
    if base.kind == "pow":
        # With integer exponents, or a root of a (positive) number, x**(a*b) has the same domain.
        inner, (root,) = base.value, base.args
        if inner.denominator == q.denominator == 1 or root.kind == "number":
            return power(root, number(inner * q))
    return _node("pow", (base,), q)


def call(name: str, argument: Node) -> Node:
    """A function of one argument, by a name of `FUNCTIONS`, `ALIASES` or `RECIPROCALS`.

    sqrt becomes a power, sec, csc, cot and their hyperbolic kin quotients; cbrt is the real cube root.
    DomainError where the argument is a number outside the real domain, FormulaError for an unknown name.

    >>> print(call("arcsin", variable("t")), call("sec", PI), call("cbrt", number(-8)))
    asin(t) 1/cos(pi) -2
    """
    name = ALIASES.get(name, name)
    if name in RECIPROCALS:
        return div(ONE, call(RECIPROCALS[name], argument))
    if name not in FUNCTIONS:
        raise FormulaError(f"{name!r} is no function here; there are {', '.join(sorted(FUNCTIONS))}.")
    if name == "sqrt":
        return power(argument, number(Fraction(1, 2)))
    if argument.kind == "number":
        q: Fraction = argument.value
        if name in _DOMAINS and not _DOMAINS[name][0](q):
            raise DomainError(f"{name} is real only for {_DOMAINS[name][1]}; {shown(q)} is not one.")
        if name == "abs":
            return number(abs(q))
        if name == "cbrt" and (root := exact_root(q, 3)) is not None:
            return number(root)
    return _node("call", (argument,), name)


def to_sympy(node: Node, symbols: Mapping[str, sympy.Expr] | None = None) -> sympy.Expr:
    """The same expression in sympy; variables become real symbols, or what `symbols` gives for their names.

    cbrt becomes `osculant.cas.formulas.sympy_bridge.cbrt`. DomainError if sympy finds that the expression is
    nowhere finite and real; FormulaError if a constant in it is beyond 2**BITS or 2**-BITS, or too deep for
    sympy.

    >>> to_sympy(variable("t") / 2 + PI)
    t/2 + pi
    """
    from osculant.cas.formulas import sympy_bridge

    return sympy_bridge.to_sympy(node, symbols)


def from_sympy(expression: object) -> Node:
    """The node of a sympy or symengine expression, or of an int, float or Fraction; never of text.

    A float is read as the rational that its shortest decimal form writes. FormulaError for anything that is
    not built of the operations and functions of this module.

    >>> import sympy
    >>> print(from_sympy(sympy.sin(sympy.Symbol("t")) / 2))
    1/2*sin(t)
    """
    from osculant.cas.formulas import sympy_bridge

    return sympy_bridge.from_sympy(expression)
