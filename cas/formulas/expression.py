"""Expressions as a hash-consed graph: equal expressions are one and the same node.

A `Node` is a number (an exact rational), one of the constants pi and e, a variable, or an operation on one
or two nodes. The constructors fold rationals exactly and do nothing else, so that a graph has the shape of
the formula that it came from; `to_text` writes it out again. Every number is bounded: numerator and
denominator have at most `osculant.cas.formulas.rationals.BITS` bits. Nothing here recurses: graphs may be as
deep as memory allows.
"""

from __future__ import annotations

import re
import threading
from collections.abc import Callable
from fractions import Fraction
from typing import Any
from weakref import WeakValueDictionary

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas.domains import half_turns, is_everywhere_defined
from osculant.cas.formulas.rationals import bounded, exact_power, exact_root, shown

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

#: characters that `to_text` writes at most
TEXT_LIMIT = 200_000

# How tightly a printed node holds together, as in the parser's grammar.
_SUM, _PRODUCT, _SIGNED, _POWER, _ATOM = range(1, 6)
_LEVELS = {"add": _SUM, "sub": _SUM, "mul": _PRODUCT, "div": _PRODUCT, "neg": _SIGNED, "pow": _POWER}
_SIGNS = {"add": " + ", "sub": " - ", "mul": "*", "div": "/"}


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
        return ONE if is_everywhere_defined(base) else _one_where_defined(base)
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


def _one_where_defined(node: Node) -> Node:
    """1 with the domain of an expression."""
    positive = add(mul(node, node), ONE)
    return div(positive, positive)


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
    turns = half_turns(argument) if name in ("sin", "cos", "tan") else None
    if turns is not None and (2 * turns).denominator == 1:
        whole = turns.denominator == 1
        if name == "tan" and not whole:
            raise DomainError(f"tan has a pole at {turns}*pi: take another argument.")
        if whole == (name != "cos"):  # sin and tan at whole multiples of pi, cos between
            return ZERO
    if argument.kind == "number":
        q: Fraction = argument.value
        if name in _DOMAINS and not _DOMAINS[name][0](q):
            raise DomainError(f"{name} is real only for {_DOMAINS[name][1]}; {shown(q)} is not one.")
        if name == "abs":
            return number(abs(q))
        if name == "cbrt" and (root := exact_root(q, 3)) is not None:
            return number(root)
    return _node("call", (argument,), name)


def _level(node: Node) -> int:
    if node.kind == "number":
        if node.value.denominator > 1:
            return _PRODUCT if node.value > 0 else _SUM
        return _ATOM if node.value >= 0 else _SIGNED
    if node.kind == "pow" and node.value == Fraction(1, 2):
        return _ATOM
    return _LEVELS.get(node.kind, _ATOM)


def to_text(node: Node) -> str:
    """Infix text that `parser.parse` reads back as this very node (within the parser's limits).

    FormulaError if the text is longer than `TEXT_LIMIT` characters, as it may be where much is shared.

    >>> t = variable("t")
    >>> to_text(-(t - 1) ** 2 / call("sqrt", t + Fraction(1, 3)))
    '-(t - 1)**2/sqrt(t + 1/3)'
    """
    out: list[str] = []
    length = 0
    stack: list[str | Node] = [node]
    while stack:
        item = stack.pop()
        pieces = [item] if isinstance(item, str) else _pieces(item)
        if len(pieces) == 1 and isinstance(pieces[0], str):
            out.append(pieces[0])
            length += len(pieces[0])
            if length > TEXT_LIMIT:
                raise FormulaError(f"The expression needs more than {TEXT_LIMIT} characters written out.")
        else:
            stack.extend(reversed(pieces))
    return "".join(out)


def _pieces(node: Node) -> list[str | Node]:
    """A node's text, with its arguments still to be written."""

    def at(level: int, argument: Node) -> list[str | Node]:
        return [argument] if _level(argument) >= level else ["(", argument, ")"]

    if node.kind in _SIGNS:
        level = _level(node)
        left, right = node.args
        # A right operand must hold tighter than its operator; a sign there is set in parentheses.
        tight = _POWER if level == _PRODUCT or _level(right) == _SIGNED else _PRODUCT
        return [*at(level, left), _SIGNS[node.kind], *at(tight, right)]
    if node.kind == "neg":
        return ["-", *at(_POWER, node.args[0])]
    if node.kind == "call":
        return [f"{node.value}(", node.args[0], ")"]
    if node.kind == "pow":
        if node.value == Fraction(1, 2):
            return ["sqrt(", node.args[0], ")"]
        exponent = str(node.value)
        return [*at(_ATOM, node.args[0]), f"**{exponent}" if exponent.isdigit() else f"**({exponent})"]
    return [str(node.value) if node.value is not None else node.kind]
