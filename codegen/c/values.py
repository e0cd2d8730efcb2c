"""Values: constants, names and tuples as expressions of C, and where all other expressions attach."""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from osculant.codegen.c.scope import ATOM, TIMES, UNARY, Scope, Value
from osculant.codegen.c.types import (
    BOOLEAN,
    INTEGER,
    TABLE,
    Known,
    Scalar,
    Struct,
    TranslationError,
    Type,
    c_name,
    type_of,
)

Translator = TypeVar("Translator", bound=Callable[[Scope, Any], Value])
#: by the kind of a node of Python's syntax tree, what translates it
_KINDS: dict[type[ast.expr], Callable[[Scope, Any], Value]] = {}


def translates(kind: type[ast.expr]) -> Callable[[Translator], Translator]:
    """Make a function of a scope and a node the translator of all nodes of a kind."""

    def enter(translator: Translator) -> Translator:
        _KINDS[kind] = translator
        return translator

    return enter


def literal(scope: Scope, known: Known) -> Value:
    """A constant in C; those with a name are followed by it.

    Doubles are written with as many digits as tell them from all others.
    """
    value, kind = known.value, type_of(known.value)
    if isinstance(kind, Struct):
        return built(scope, kind, [literal(scope, Known(part)) for part in value])
    if kind is BOOLEAN:
        return Value("true" if value else "false", BOOLEAN)
    if kind is INTEGER:
        text = str(int(value))
    elif math.isfinite(value):
        text = repr(float(value))
    else:
        text = "NAN" if math.isnan(value) else ("INFINITY" if value > 0 else "-INFINITY")
    note = f" /* {known.name} */" if known.name and text not in ("NAN", "INFINITY") else ""
    return Value(text + note, kind, UNARY if text.startswith("-") else ATOM)


def plain(scope: Scope, value: Value) -> Value:
    """The value as an expression of C, also if it is known."""
    return literal(scope, value.type) if isinstance(value.type, Known) else value


def built(scope: Scope, kind: Struct, parts: Sequence[Value]) -> Value:
    """A tuple from its parts."""
    inside = ", ".join(
        convert(scope, part, wanted).text for part, wanted in zip(parts, kind.fields, strict=True)
    )
    name = scope.translation.c_type(kind)
    return Value(f"({name}){{{{{inside}}}}}" if kind.uniform else f"({name}){{{inside}}}", kind)


def convert(scope: Scope, value: Value, wanted: Type) -> Value:
    """The value as one of a type that is as wide or wider."""
    value = plain(scope, value)
    if value.type == wanted or isinstance(value.type, Scalar):
        return value
    assert isinstance(wanted, Struct) and isinstance(value.type, Struct)
    whole = value if value.text.isidentifier() else scope.temporary(value)
    return built(scope, wanted, [part_of(scope, whole, i) for i in range(len(wanted.fields))])


def part_of(scope: Scope, value: Value, index: int) -> Value:
    """A field of a tuple."""
    assert isinstance(value.type, Struct)
    index = index % len(value.type.fields)
    return Value(f"{value.within(ATOM)}.{value.type.member(index)}", value.type.fields[index])


def expression(scope: Scope, node: ast.expr) -> Value:
    """The value of an expression; raises TranslationError for what kernels may not contain."""
    translate = _KINDS.get(type(node))
    if translate is None:
        raise TranslationError(f"Not translated: {ast.unparse(node)}.")
    return translate(scope, node)


def known(scope: Scope, node: ast.expr) -> Any:
    """What an expression is if it is known; raises KeyError if it is not."""
    value = expression(scope, node)
    if isinstance(value.type, Known):
        return value.type.value
    raise KeyError(ast.unparse(node))


@translates(ast.Constant)
def _constant(scope: Scope, node: ast.Constant) -> Value:
    return Value("", Known(node.value))


@translates(ast.Name)
def _name(scope: Scope, node: ast.Name) -> Value:
    name = node.id
    if name in scope.aliases:
        return Value("", scope.aliases[name])
    if name in scope.types:
        return Value(c_name(name), scope.types[name])
    if name in scope.assigned:
        raise TranslationError(f"The variable {name} is used before it is assigned to.")
    return Value("", Known(scope.names[name], name))


@translates(ast.Attribute)
def _attribute(scope: Scope, node: ast.Attribute) -> Value:
    whole = expression(scope, node.value)
    if isinstance(whole.type, Known):
        return Value("", Known(getattr(whole.type.value, node.attr), node.attr))
    if isinstance(whole.type, Struct):
        return part_of(scope, whole, whole.type.kind._fields.index(node.attr))
    if node.attr == "size" and whole.type is TABLE:
        return Value(f"{whole.text}.n * {whole.text}.m", INTEGER, TIMES)
    raise TranslationError(f"Not translated: {ast.unparse(node)}.")


@translates(ast.Tuple)
def _tuple(scope: Scope, node: ast.Tuple) -> Value:
    parts = [expression(scope, part) for part in node.elts]
    if all(isinstance(part.type, Known) for part in parts):
        return Value("", Known(tuple(part.type.value for part in parts)))  # type: ignore[union-attr]
    values = [plain(scope, part) for part in parts]
    return built(scope, Struct(tuple(value.type for value in values)), values)
