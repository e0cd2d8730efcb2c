"""Expressions written out: infix text with no parentheses but those that reading it back needs."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from osculant.cas.errors import FormulaError

if TYPE_CHECKING:  # a node writes itself by way of this module
    from osculant.cas.formulas.expression import Node

#: characters that `to_text` writes at most
TEXT_LIMIT = 200_000

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
    """Infix text that `parser.parse` reads back as this very node (within the parser's limits).

    FormulaError if the text is longer than `TEXT_LIMIT` characters, as it may be where much is shared.

    >>> from osculant.cas.formulas.expression import call, variable
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
