"""What is known of one function while it is translated: names, lines of C, and room for its arrays."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

from osculant.codegen.c.types import Known, Type, unify

if TYPE_CHECKING:
    from osculant.codegen.c.program import Translation

#: how tightly C's operators bind
ATOM, UNARY, TIMES, PLUS, LESS, EQUAL, AND, OR, CHOICE = 9, 8, 7, 6, 5, 4, 3, 2, 1
#: stands, until it is known, for the room that a function takes for its own arrays
FRAME = "@FRAME@"


class Value(NamedTuple):
    """An expression of C, its type, and how tightly it binds."""

    text: str
    type: Type
    binds: int = ATOM

    def within(self, binds: int) -> str:
        """The text, in parentheses unless it binds at least so tightly."""
        return self.text if self.binds >= binds else f"({self.text})"


@dataclass
class Scope:
    """One function on its way to C.

    Attributes:
        translation: the whole that it belongs to.
        names: the function's globals and closure.
        assigned: how often each name is assigned to.
        types: of parameters and variables, as wide as they were found to be.
        parameters: the names of all parameters.
        aliases: variables that stand for something known.
        result: the type that it returns, None as long as no return was seen.
        conditional: variables that are first assigned to in a block.
        lines: of C.
        depth: of indentation.
        serial: number of the last temporary.
        frame: doubles of room for its own arrays.
        beyond: the most that a callee needs beyond that.
        allocates: whether it needs room at all.
    """

    translation: Translation
    names: dict[str, Any]
    assigned: dict[str, int]
    types: dict[str, Type]
    parameters: frozenset[str]
    aliases: dict[str, Known] = field(default_factory=dict)
    result: Type | None = None
    conditional: set[str] = field(default_factory=set)
    lines: list[str] = field(default_factory=list)
    depth: int = 1
    serial: int = 0
    frame: int = 0
    beyond: int = 0
    allocates: bool = False

    def restart(self) -> None:
        """Forget the lines, not the types: they were too narrow."""
        self.lines, self.aliases, self.serial = [], {}, 0
        self.frame, self.beyond, self.allocates = 0, 0, False

    def emit(self, line: str) -> None:
        """Add a line of C."""
        self.lines.append("    " * self.depth + line)

    @contextmanager
    def block(self, head: str, tail: str = "}") -> Iterator[None]:
        """Lines in braces."""
        self.emit(head + " {")
        self.depth += 1
        yield
        self.depth -= 1
        self.emit(tail)

    @contextmanager
    def aside(self) -> Iterator[list[str]]:
        """Lines that are not emitted but collected."""
        kept, self.lines = self.lines, []
        try:
            yield self.lines
        finally:
            self.lines = kept

    def temporary(self, value: Value) -> Value:
        """The value in a variable of its own."""
        self.serial += 1
        name = f"t{self.serial}_"
        kind = self.translation.c_type(value.type)
        self.emit(
            f"const {kind} {name} = {value.text};"
            if not kind.endswith("*")
            else f"{kind}{name} = {value.text};"
        )
        return Value(name, value.type)

    def variable(self, name: str, kind: Type) -> None:
        """Widen a variable to hold values of a type."""
        self.types[name] = unify(self.types.get(name), kind)

    def room(self, size: int) -> str:
        """Room for so many doubles among the function's own."""
        self.allocates = True
        place = self.frame
        self.frame += size
        return f"room + {place}" if place else "room"


def assignments(function: ast.FunctionDef) -> dict[str, int]:
    """How often each name is assigned to in a function, loops counting twice."""
    found: dict[str, int] = {}
    for node in ast.walk(function):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found[node.id] = found.get(node.id, 0) + 1
    return found
