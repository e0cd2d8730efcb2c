"""Where expressions have values, as far as it is seen from their form."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from osculant.cas.formulas.expression import Node

#: functions that are not defined for all real numbers
PARTIAL = {"log", "asin", "acos", "acosh", "atanh", "tan"}


def is_everywhere_defined(node: Node) -> bool:
    """Whether an expression is seen to have a value wherever its variables do: no quotient or root in it.

    >>> from osculant.cas.formulas.parser import parse
    >>> is_everywhere_defined(parse("t^2 + sin(t)")), is_everywhere_defined(parse("acos(t)"))
    (True, False)
    """
    pending, seen = [node], {node}
    while pending:
        part = pending.pop()
        natural = part.kind != "pow" or (part.value.denominator == 1 and part.value >= 0)
        if part.kind == "div" or not natural or (part.kind == "call" and part.value in PARTIAL):
            return False
        new = set(part.args) - seen
        seen |= new
        pending += new
    return True


def half_turns(node: Node) -> Fraction | None:
    """The rational q of a constant that is written as q*pi, q not 0; None of any other expression.

    >>> from osculant.cas.formulas.parser import parse
    >>> half_turns(parse("-3*pi/2"))
    Fraction(-3, 2)
    """
    if node.kind == "pi":
        return Fraction(1)
    if node.kind == "neg":
        q = half_turns(node.args[0])
        return None if q is None else -q
    if node.kind in ("mul", "div"):
        for part, factor in (node.args, node.args[::-1]):
            if factor.kind == "number" and (node.kind == "mul" or factor is node.args[1]):
                q = half_turns(part)
                if q is not None:
                    value: Fraction = factor.value
                    return q * value if node.kind == "mul" else q / value
    return None
