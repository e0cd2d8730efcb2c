"""Parts of tuples, constant tables and arrays."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from osculant.codegen.c.scope import ATOM, PLUS, TIMES, Scope, Value
from osculant.codegen.c.types import (
    COLUMN,
    INTEGER,
    ROW,
    ROWS,
    TABLE,
    Array,
    Known,
    Struct,
    TranslationError,
)
from osculant.codegen.c.values import expression, known, part_of, plain, translates


@translates(ast.Subscript)
def _subscript(scope: Scope, node: ast.Subscript) -> Value:
    if isinstance(node.value, ast.Attribute) and node.value.attr == "shape":
        return _shape(scope, node.value.value, known(scope, node.slice))
    whole = expression(scope, node.value)
    indices = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
    if isinstance(whole.type, Known):
        return _of_known(scope, whole.type, indices)
    if isinstance(whole.type, Struct):
        return _of_tuple(scope, whole, expression(scope, indices[0]))
    if not _is_path(whole.text):
        whole = scope.temporary(whole)
    return _of_array(scope, whole, indices)


def _of_known(scope: Scope, whole: Known, indices: Sequence[ast.expr]) -> Value:
    """Part of a constant tuple or array; where the index varies it becomes a table of C."""
    places = [expression(scope, index) for index in indices]
    if all(isinstance(place.type, Known) for place in places):
        value = whole.value
        for place in places:
            value = value[place.type.value]  # type: ignore[union-attr]
        return Value("", Known(value.item() if hasattr(value, "item") else value))
    name, kind = scope.translation.table(whole)
    return Value(name + "".join(f"[{plain(scope, place).text}]" for place in places), kind)


def _of_tuple(scope: Scope, whole: Value, index: Value) -> Value:
    assert isinstance(whole.type, Struct)
    if isinstance(index.type, Known):
        return part_of(scope, whole, index.type.value)
    kind = whole.type.fields[0]
    if len(set(whole.type.fields)) > 1:
        raise TranslationError(f"The index {index.text} of a tuple of several types varies.")
    if not _is_path(whole.text):
        whole = scope.temporary(whole)
    tuple_type = whole.type
    assert isinstance(tuple_type, Struct)
    first = f"{whole.text}.at" if tuple_type.uniform else f"(&{whole.text}.{tuple_type.member(0)})"
    return Value(f"{first}[{index.text}]", kind)


def _place(scope: Scope, node: ast.expr, size: str) -> Value:
    """An index; negative ones count from the end."""
    index = expression(scope, node)
    if isinstance(index.type, Known) and index.type.value < 0:
        return Value(f"{size} - {-index.type.value}", INTEGER, PLUS)
    return plain(scope, index)


def _of_array(scope: Scope, whole: Value, indices: Sequence[ast.expr]) -> Value:
    text = whole.text
    if whole.type is ROW and isinstance(indices[0], ast.Slice):
        first, last = indices[0].lower, indices[0].upper
        start = plain(scope, expression(scope, first)).within(PLUS) if first is not None else "0"
        stop = plain(scope, expression(scope, last)).within(PLUS) if last is not None else f"{text}.n"
        return Value(
            f"(row){{{text}.p + {start}, {stop} - {start}}}" if first else f"(row){{{text}.p, {stop}}}", ROW
        )
    assert isinstance(whole.type, Array)
    if whole.type not in ROWS:
        place = _place(scope, indices[0], f"{text}.n")
        step = f"{place.within(TIMES)} * {text}.stride" if whole.type is COLUMN else place.text
        return Value(f"{text}.p[{step}]", whole.type.of)
    first = indices[0]
    if isinstance(first, ast.Slice) and whole.type is TABLE:
        if len(indices) == 2 and first.lower is first.upper is None:
            column = _place(scope, indices[1], f"{text}.m")
            return Value(f"(column){{{text}.p + {column.within(PLUS)}, {text}.n, {text}.m}}", COLUMN)
        if len(indices) == 1 and first.lower is None and first.upper is not None:
            rows = plain(scope, expression(scope, first.upper))
            return Value(f"(table){{{text}.p, {rows.text}, {text}.m}}", TABLE)
        raise TranslationError("Of slices only whole columns and the first rows are translated.")
    row = _place(scope, first, f"{text}.n")
    if len(indices) == 1:
        kind = ROWS[whole.type]
        return Value(f"({kind.c}){{{text}.p + {row.within(TIMES)} * {text}.m, {text}.m}}", kind)
    column = _place(scope, indices[1], f"{text}.m")
    return Value(f"{text}.p[{row.within(TIMES)} * {text}.m + {column.within(PLUS)}]", whole.type.of)


def _shape(scope: Scope, node: ast.expr, axis: int) -> Value:
    whole = expression(scope, node)
    if isinstance(whole.type, Known):
        return Value("", Known(whole.type.value.shape[axis]))
    assert isinstance(whole.type, Array)
    return Value(f"{whole.within(ATOM)}.{'nm'[axis]}", INTEGER)


def _is_path(text: str) -> bool:
    """Whether an expression is a variable or a field of one, and may be written twice."""
    return all(part.isidentifier() for part in text.split("."))
