"""Walks over expression graphs, without recursion: every node once, its arguments before it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TypeVar

from osculant.cas.expression import Node

Result = TypeVar("Result")


def topological(roots: Iterable[Node]) -> list[Node]:
    """Every node that the roots depend on, once, each after its arguments; the roots' order decides the rest.

    >>> from osculant.cas.expression import variable
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

    >>> from osculant.cas.expression import variable
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

    >>> from osculant.cas.expression import PI, variable
    >>> sorted(variables([variable("x") * variable("y"), PI]))
    ['x', 'y']
    """
    return {node.value for node in topological(roots) if node.kind == "variable"}
