"""Walks over expression graphs, without recursion: every node once, its arguments before it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TypeVar

from osculant.cas.formulas.expression import Node, add, call, div, mul, neg, number, power, sub

Result = TypeVar("Result")


def topological(roots: Iterable[Node]) -> list[Node]:
    """Every node that the roots depend on, once, each after its arguments; the roots' order decides the rest.

    >>> from osculant.cas.formulas.expression import variable
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

    >>> from osculant.cas.formulas.expression import variable
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

    >>> from osculant.cas.formulas.expression import PI, variable
    >>> sorted(variables([variable("x") * variable("y"), PI]))
    ['x', 'y']
    """
    return {node.value for node in topological(roots) if node.kind == "variable"}


def substitute(roots: Sequence[Node], values: Mapping[str, Node]) -> list[Node]:
    """The roots with expressions in the place of variables; variables without a value stay.

    >>> from osculant.cas.formulas.expression import number, variable
    >>> print(substitute([variable("x") ** 2 + variable("y")], {"x": variable("y") + 1})[0])
    (y + 1)**2 + y
    """
    binary = {"add": add, "sub": sub, "mul": mul, "div": div}

    def rule(node: Node, args: list[Node]) -> Node:
        if node.kind == "variable":
            return values.get(node.value, node)
        if node.kind in binary:
            return binary[node.kind](*args)
        if node.kind == "neg":
            return neg(args[0])
        if node.kind == "pow":
            return power(args[0], number(node.value))
        return call(node.value, args[0]) if node.kind == "call" else node

    return fold(roots, rule)
