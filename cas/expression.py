"""Expressions as a hash-consed graph: equal expressions are one and the same node.

A `Node` is a number (an exact rational), one of the constants pi and e, a variable, or an operation on one
or two nodes. The constructors fold rationals exactly and do nothing else, so that a graph has the shape of
the formula that it came from. Every number is bounded: numerator and denominator have at most `BITS` bits.
Nothing here recurses: graphs may be as deep as memory allows.
"""

from __future__ import annotations

import math
import re
import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeVar
from weakref import WeakValueDictionary

from osculant.cas.errors import DomainError, FormulaError

if TYPE_CHECKING:
    import sympy

Result = TypeVar("Result")
BITS = 4096
TEXT_LIMIT = 200_000

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


def _bits(q: Fraction) -> int:
    return max(q.numerator.bit_length(), q.denominator.bit_length())


def _too_large() -> FormulaError:
    return FormulaError(f"A number of this formula needs more than {BITS} bits; use smaller numbers.")


def number(q: int | Fraction) -> Node:
    """The exact rational q; FormulaError if it needs more than `BITS` bits.

    >>> number(Fraction(1, 10)).value
    Fraction(1, 10)
    """
    q = Fraction(q)
    if _bits(q) > BITS:
        raise _too_large()
    return _node("number", (), q)


def decimal(text: str) -> Fraction:
    """The exact rational that a decimal literal such as "1.5e-3" writes, its size checked before computing.

    >>> decimal("0.1"), decimal("-2.50e2")
    (Fraction(1, 10), Fraction(-250, 1))
    """
    match = re.fullmatch(r"([+-]?)(\d*)\.?(\d*)(?:[eE]([+-]?)0*(\d+))?", text, re.ASCII)
    if match is None or not match[2] + match[3]:
        raise FormulaError(f"{text!r} is not a decimal number; write for instance 0.5 or 1e-6.")
    sign, whole, part, exponent_sign, exponent = match.groups(default="")
    digits = (whole + part).lstrip("0")
    if not digits:
        return Fraction(0)
    significant = digits.rstrip("0")
    limit = BITS * 0.30103 + 1  # decimal digits
    if len(significant) > limit or len(exponent) > 6:
        raise _too_large()
    scale = int(exponent_sign + (exponent or "0")) - len(part) + len(digits) - len(significant)
    if abs(scale) > limit:
        raise _too_large()
    return Fraction(int(sign + significant)) * Fraction(10) ** scale


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
    that is not an integer, and for 0 under a negative one; FormulaError if a number would outgrow `BITS`.

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
        return _number_power(base.value, q)
    if base.kind == "pow":
        # With integer exponents, or a root of a (positive) number, x**(a*b) has the same domain.
        inner, (root,) = base.value, base.args
        if inner.denominator == q.denominator == 1 or root.kind == "number":
            return power(root, number(inner * q))
    return _node("pow", (base,), q)


def _number_power(base: Fraction, exponent: Fraction) -> Node:
    if base == 0 and exponent < 0:
        raise DomainError(f"Division by zero: 0 has no power {_short(exponent)}.")
    if base < 0 and exponent.denominator > 1:
        raise DomainError(f"{_short(base)} has no real power {_short(exponent)}; cbrt is the real cube root.")
    if (_bits(base) - 1) * abs(exponent) >= BITS:  # a lower bound of the result's bits, before computing it
        raise _too_large()
    root = exact_root(base, exponent.denominator)
    if root is None:
        return _node("pow", (number(base),), exponent)
    return number(root**exponent.numerator)


def _short(q: Fraction) -> str:
    return str(q) if _bits(q) <= 64 else "of that size"


def exact_root(q: Fraction, degree: int) -> Fraction | None:
    """The rational r with r**degree == q, and r >= 0 where the degree is even, if there is one.

    >>> exact_root(Fraction(-8, 27), 3), exact_root(Fraction(2), 2)
    (Fraction(-2, 3), None)
    """
    if q < 0:
        root = exact_root(-q, degree) if degree % 2 else None
        return None if root is None else -root
    above, below = _integer_root(q.numerator, degree), _integer_root(q.denominator, degree)
    return None if above is None or below is None else Fraction(above, below)


def _integer_root(n: int, degree: int) -> int | None:
    if n <= 1 or degree == 1:
        return n
    if degree >= n.bit_length():  # 1 < the root < 2
        return None
    if degree == 2:
        root = math.isqrt(n)
    else:  # Newton's iteration from above descends to the floor of the root
        root, step = 0, 1 << -(-n.bit_length() // degree)
        while root == 0 or step < root:
            root, step = step, ((degree - 1) * step + n // step ** (degree - 1)) // degree
    return root if root**degree == n else None


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
            raise DomainError(f"{name} is real only for {_DOMAINS[name][1]}; {_short(q)} is not one.")
        if name == "abs":
            return number(abs(q))
        if name == "cbrt" and (root := exact_root(q, 3)) is not None:
            return number(root)
    return _node("call", (argument,), name)


def topological(roots: Iterable[Node]) -> list[Node]:
    """Every node that the roots depend on, once, each after its arguments; the roots' order decides the rest.

    >>> t = variable("t")
    >>> [node.kind for node in topological([t * t + 1, t * t])]
    ['variable', 'mul', 'number', 'add']
    """
    order: dict[Node, None] = {}
    stack = list(roots)[::-1]
    while stack:
        node = stack[-1]
        waiting = [argument for argument in node.args if argument not in order]
        if waiting and node not in order:
            stack.extend(reversed(waiting))
        else:
            order[stack.pop()] = None
    return list(order)


def fold(roots: Sequence[Node], rule: Callable[[Node, list[Result]], Result]) -> list[Result]:
    """The values of the roots, where rule(node, values of its arguments) is asked once per node.

    >>> depth = fold([variable("t") ** 2 + 1], lambda node, depths: 1 + max(depths, default=0))
    >>> depth
    [3]
    """
    values: dict[Node, Result] = {}
    for node in topological(roots):
        values[node] = rule(node, [values[argument] for argument in node.args])
    return [values[root] for root in roots]


def variables(roots: Iterable[Node]) -> set[str]:
    """The names of the variables that occur.

    >>> sorted(variables([variable("x") * variable("y"), PI]))
    ['x', 'y']
    """
    return {node.value for node in topological(roots) if node.kind == "variable"}


# How tightly a printed node holds together, as in the parser's grammar.
_SUM, _PRODUCT, _SIGNED, _POWER, _ATOM = range(1, 6)
_LEVELS = {"add": _SUM, "sub": _SUM, "mul": _PRODUCT, "div": _PRODUCT, "neg": _SIGNED, "pow": _POWER}
_SIGNS = {"add": " + ", "sub": " - ", "mul": "*", "div": "/"}


def _level(node: Node) -> int:
    if node.kind == "number":
        if node.value.denominator > 1:
            return _PRODUCT if node.value > 0 else _SUM
        return _ATOM if node.value >= 0 else _SIGNED
    if node.kind == "pow" and node.value == Fraction(1, 2):
        return _ATOM
    return _LEVELS.get(node.kind, _ATOM)


def to_text(node: Node) -> str:
    """Infix text that `osculant.cas.formula.parse` reads back as this very node (within the parser's limits).

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


def to_sympy(node: Node, symbols: Mapping[str, sympy.Expr] | None = None) -> sympy.Expr:
    """The same expression in sympy; variables become real symbols, or what `symbols` gives for their names.

    cbrt becomes `osculant.cas.sympy_bridge.cbrt`. DomainError if sympy finds that the expression is nowhere
    finite and real; FormulaError if a constant in it is beyond 2**BITS or 2**-BITS, or too deep for sympy.

    >>> to_sympy(variable("t") / 2 + PI)
    t/2 + pi
    """
    from osculant.cas import sympy_bridge  # sympy takes a second to import

    return sympy_bridge.to_sympy(node, symbols)


def from_sympy(expression: object) -> Node:
    """The node of a sympy or symengine expression, or of an int, float or Fraction; never of text.

    A float is read as the rational that its shortest decimal form writes. FormulaError for anything that is
    not built of the operations and functions of this module.

    >>> import sympy
    >>> print(from_sympy(sympy.sin(sympy.Symbol("t")) / 2))
    1/2*sin(t)
    """
    from osculant.cas import sympy_bridge

    return sympy_bridge.from_sympy(expression)
