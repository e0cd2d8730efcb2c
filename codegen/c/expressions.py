"""Expressions of a kernel → expressions of C, in the order in which Python evaluates them."""

from __future__ import annotations

import ast
import math
from collections.abc import Sequence
from typing import Any

from osculant.codegen.c import calls
from osculant.codegen.c.scope import (
    AND,
    ATOM,
    CHOICE,
    EQUAL,
    LESS,
    OR,
    PLUS,
    TIMES,
    UNARY,
    Scope,
    Value,
    c_name,
)  # fmt: skip
from osculant.codegen.c.types import (
    BOOLEAN,
    COLUMN,
    DOUBLE,
    INTEGER,
    ROW,
    TABLE,
    Array,
    Known,
    Scalar,
    Struct,
    TranslationError,
    Type,
    is_scalar,
    type_of,
    unify,
)  # fmt: skip

#: operators of C that do what Python's do, and how tightly they bind
ARITHMETIC = {ast.Add: ("+", PLUS), ast.Sub: ("-", PLUS), ast.Mult: ("*", TIMES), ast.Div: ("/", TIMES)}
COMPARISONS = {
    ast.Lt: ("<", LESS), ast.LtE: ("<=", LESS), ast.Gt: (">", LESS), ast.GtE: (">=", LESS),
    ast.Eq: ("==", EQUAL), ast.NotEq: ("!=", EQUAL),
}  # fmt: skip


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
    found: Value = translate(scope, node)
    return found


def known(scope: Scope, node: ast.expr) -> Any:
    """What an expression is if it is known; raises KeyError if it is not."""
    value = expression(scope, node)
    if isinstance(value.type, Known):
        return value.type.value
    raise KeyError(ast.unparse(node))


def _constant(scope: Scope, node: ast.Constant) -> Value:
    return Value("", Known(node.value))


def _name(scope: Scope, node: ast.Name) -> Value:
    name = node.id
    if name in scope.aliases:
        return Value("", scope.aliases[name])
    if name in scope.types:
        return Value(c_name(name), scope.types[name])
    if name in scope.assigned:
        raise TranslationError(f"The variable {name} is used before it is assigned to.")
    return Value("", Known(scope.names[name], name))


def _attribute(scope: Scope, node: ast.Attribute) -> Value:
    whole = expression(scope, node.value)
    if isinstance(whole.type, Known):
        return Value("", Known(getattr(whole.type.value, node.attr), node.attr))
    if isinstance(whole.type, Struct):
        return part_of(scope, whole, whole.type.kind._fields.index(node.attr))
    if node.attr == "size" and whole.type is TABLE:
        return Value(f"{whole.text}.n * {whole.text}.m", INTEGER, TIMES)
    raise TranslationError(f"Not translated: {ast.unparse(node)}.")


def _tuple(scope: Scope, node: ast.Tuple) -> Value:
    parts = [expression(scope, part) for part in node.elts]
    if all(isinstance(part.type, Known) for part in parts):
        return Value("", Known(tuple(part.type.value for part in parts)))  # type: ignore[union-attr]
    values = [plain(scope, part) for part in parts]
    return built(scope, Struct(tuple(value.type for value in values)), values)


def _unary(scope: Scope, node: ast.UnaryOp) -> Value:
    value = expression(scope, node.operand)
    if isinstance(value.type, Known):
        negated = not value.type.value if isinstance(node.op, ast.Not) else -value.type.value
        return Value("", Known(negated, f"-{value.type.name}" if value.type.name else ""))
    if isinstance(node.op, ast.Not):
        return Value(f"!{value.within(UNARY)}", BOOLEAN, UNARY)
    space = " " if value.text.startswith("-") else ""
    return Value(f"-{space}{value.within(UNARY)}", value.type, UNARY)


def _binary(scope: Scope, node: ast.BinOp) -> Value:
    left, right = expression(scope, node.left), expression(scope, node.right)
    if isinstance(node.op, ast.Pow):
        return _power(scope, left, right)
    if isinstance(left.type, Known) and isinstance(right.type, Known):
        return Value("", Known(_folded(node.op, left.type.value, right.type.value)))
    a, b = plain(scope, left), plain(scope, right)
    kind = unify(unify(a.type, b.type), INTEGER)
    if isinstance(node.op, (ast.FloorDiv, ast.Mod)):
        if kind is not INTEGER:
            raise TranslationError(f"Not translated: {ast.unparse(node)}.")
        name = "quotient" if isinstance(node.op, ast.FloorDiv) else "remainder_of"
        return Value(f"{name}({a.text}, {b.text})", INTEGER)
    sign, binds = ARITHMETIC[type(node.op)]
    if sign == "/":
        kind = DOUBLE
        if a.type is not DOUBLE and b.type is not DOUBLE:
            a = Value(f"(double){a.within(UNARY)}", DOUBLE, UNARY)
    return Value(f"{a.within(binds)} {sign} {b.within(binds + 1)}", kind, binds)


def _folded(operator: ast.operator, a: Any, b: Any) -> Any:
    """Two constants' value, by the arithmetic of doubles and integers."""
    if isinstance(operator, ast.Div):
        return a / b
    if isinstance(operator, ast.FloorDiv):
        return a // b
    if isinstance(operator, ast.Mod):
        return a % b
    return a + b if isinstance(operator, ast.Add) else a - b if isinstance(operator, ast.Sub) else a * b


def _power(scope: Scope, base: Value, exponent: Value) -> Value:
    """Powers with whole constant exponents are products, of squares of squares, as numba's are."""
    if isinstance(base.type, Known) and isinstance(exponent.type, Known):
        return Value("", Known(base.type.value**exponent.type.value))
    a, n = plain(scope, base), exponent.type
    if not (isinstance(n, Known) and isinstance(n.value, int)):
        b = plain(scope, exponent)
        return Value(f"{'pow' if b.type is DOUBLE else 'whole_power'}({a.text}, {b.text})", DOUBLE)
    square = a if a.text.isidentifier() else scope.temporary(a)
    left, found = n.value, None
    while left:
        if left & 1:
            found = (
                square
                if found is None
                else Value(f"{found.within(TIMES)} * {square.within(UNARY)}", a.type, TIMES)
            )
        left >>= 1
        if left:
            square = Value(f"{square.within(UNARY)} * {square.within(UNARY)}", a.type, TIMES)
            square = square if left == 1 and found is None else scope.temporary(square)
    if found is None or n.value < 0:
        raise TranslationError(f"Powers with the exponent {n.value} are not translated.")
    return found


def _compare(scope: Scope, node: ast.Compare) -> Value:
    left, parts, folded = expression(scope, node.left), [], True
    for i, (operator, other) in enumerate(zip(node.ops, node.comparators)):
        right = expression(scope, other)
        if isinstance(left.type, Known) and isinstance(right.type, Known):
            if not _holds(operator, left.type.value, right.type.value):
                return Value("", Known(False))
        else:
            folded = False
            a, b = plain(scope, left), plain(scope, right)
            if i + 1 < len(node.ops) and not b.text.isidentifier() and b.binds < UNARY:
                b = right = scope.temporary(b)
            sign, binds = COMPARISONS[type(operator)]
            parts.append(Value(f"{a.within(PLUS)} {sign} {b.within(PLUS)}", BOOLEAN, binds))
        left = right
    return Value("", Known(True)) if folded else _joined(parts, "&&", AND)


def _holds(operator: ast.cmpop, a: Any, b: Any) -> bool:
    if isinstance(operator, (ast.Eq, ast.NotEq)):
        return bool((a == b) is isinstance(operator, ast.Eq))
    if isinstance(operator, (ast.Lt, ast.LtE)):
        return bool(a < b if isinstance(operator, ast.Lt) else a <= b)
    return bool(a > b if isinstance(operator, ast.Gt) else a >= b)


def _joined(parts: Sequence[Value], sign: str, binds: int) -> Value:
    if len(parts) == 1:
        return parts[0]
    return Value(f" {sign} ".join(part.within(EQUAL) for part in parts), BOOLEAN, binds)


def _boolean(scope: Scope, node: ast.BoolOp) -> Value:
    """``and``, ``or``: what comes later may need lines of its own, which run only where it counts."""
    stops = isinstance(node.op, ast.Or)
    sign, binds = ("||", OR) if stops else ("&&", AND)
    parts: list[Value] = []
    for i, part in enumerate(node.values):
        with scope.aside() as lines:
            value = expression(scope, part)
        if isinstance(value.type, Known):
            if bool(value.type.value) is stops:
                return (
                    Value("", Known(stops))
                    if not parts
                    else _joined([*parts, literal(scope, value.type)], sign, binds)
                )
            continue
        if lines and parts:
            return _later(scope, node, i, _joined(parts, sign, binds), stops)
        scope.lines += lines
        parts.append(value)
    return _joined(parts, sign, binds) if parts else Value("", Known(not stops))


def _later(scope: Scope, node: ast.BoolOp, first: int, so_far: Value, stops: bool) -> Value:
    """The rest of ``and`` or ``or`` from a part on, in a block of its own."""
    scope.serial += 1
    name = f"t{scope.serial}_"
    scope.emit(f"bool {name} = {so_far.text};")
    with scope.block(f"if ({'!' if stops else ''}{name})"):
        rest = node.values[first:]
        value = expression(scope, rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest))
        scope.emit(f"{name} = {plain(scope, value).text};")
    return Value(name, BOOLEAN)


def _choice(scope: Scope, node: ast.IfExp) -> Value:
    test = expression(scope, node.test)
    if isinstance(test.type, Known):
        return expression(scope, node.body if test.type.value else node.orelse)
    with scope.aside() as first:
        a = plain(scope, expression(scope, node.body))
    with scope.aside() as second:
        b = plain(scope, expression(scope, node.orelse))
    kind = unify(a.type, b.type)
    a_text, b_text = convert(scope, a, kind), convert(scope, b, kind)
    if not first and not second:
        return Value(f"{test.within(OR)} ? {a_text.within(OR)} : {b_text.within(CHOICE)}", kind, CHOICE)
    scope.serial += 1
    name = f"t{scope.serial}_"
    scope.emit(f"{scope.translation.c_type(kind)} {name};")
    with scope.block(f"if ({test.text})", "} else {"):
        scope.lines += ["    " + line for line in first]
        scope.emit(f"{name} = {a_text.text};")
    scope.depth += 1
    scope.lines += ["    " + line for line in second]
    scope.emit(f"{name} = {b_text.text};")
    scope.depth -= 1
    scope.emit("}")
    return Value(name, kind)


def _subscript(scope: Scope, node: ast.Subscript) -> Value:
    if isinstance(node.value, ast.Attribute) and node.value.attr == "shape":
        return _shape(scope, node.value.value, known(scope, node.slice))
    whole = expression(scope, node.value)
    indices = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
    if isinstance(whole.type, Known):
        return _of_known(scope, whole.type, indices)
    if isinstance(whole.type, Struct):
        return _of_tuple(scope, whole, expression(scope, indices[0]))
    if not whole.text.replace(".", "").replace("_", "").isalnum():
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
    if not whole.text.replace(".", "").replace("_", "").isalnum():
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
    if whole.type is not TABLE:
        place = _place(scope, indices[0], f"{text}.n")
        step = f"{place.within(TIMES)} * {text}.stride" if whole.type is COLUMN else place.text
        return Value(f"{text}.p[{step}]", DOUBLE)
    first = indices[0]
    if isinstance(first, ast.Slice):
        if len(indices) == 2 and first.lower is first.upper is None:
            column = _place(scope, indices[1], f"{text}.m")
            return Value(f"(column){{{text}.p + {column.within(PLUS)}, {text}.n, {text}.m}}", COLUMN)
        if len(indices) == 1 and first.lower is None and first.upper is not None:
            rows = plain(scope, expression(scope, first.upper))
            return Value(f"(table){{{text}.p, {rows.text}, {text}.m}}", TABLE)
        raise TranslationError("Of slices only whole columns and the first rows are translated.")
    row = _place(scope, first, f"{text}.n")
    if len(indices) == 1:
        return Value(f"(row){{{text}.p + {row.within(TIMES)} * {text}.m, {text}.m}}", ROW)
    column = _place(scope, indices[1], f"{text}.m")
    return Value(f"{text}.p[{row.within(TIMES)} * {text}.m + {column.within(PLUS)}]", DOUBLE)


def _shape(scope: Scope, node: ast.expr, axis: int) -> Value:
    whole = expression(scope, node)
    if isinstance(whole.type, Known):
        return Value("", Known(whole.type.value.shape[axis]))
    assert isinstance(whole.type, Array)
    return Value(f"{whole.within(ATOM)}.{'nm'[axis]}", INTEGER)


def _call(scope: Scope, node: ast.Call) -> Value:
    arguments: list[Value] = []
    if isinstance(node.func, ast.Attribute) and node.func.attr == "reshape":
        return calls.reshaped(scope, expression(scope, node.func.value), expression(scope, node.args[0]))
    function = known(scope, node.func)
    for part in node.args:
        if not isinstance(part, ast.Starred):
            arguments.append(expression(scope, part))
            continue
        whole = expression(scope, part.value)
        if isinstance(whole.type, Known):
            arguments += [Value("", Known(value)) for value in whole.type.value]
            continue
        whole = whole if whole.text.isidentifier() else scope.temporary(whole)
        assert isinstance(whole.type, Struct)
        arguments += [part_of(scope, whole, i) for i in range(len(whole.type.fields))]
    return called(scope, function, arguments)


def called(scope: Scope, function: Any, arguments: list[Value]) -> Value:
    """The value of a call: of an operation, a function of Python, a tuple's class or a kernel."""
    function = scope.translation.chosen(function, arguments)
    if not callable(function):
        return Value("", Known(function))
    if function in calls.KNOWN:
        return calls.KNOWN[function](scope, arguments, plain)
    if isinstance(function, type):  # a NamedTuple
        values = [plain(scope, value) for value in arguments]
        return built(scope, Struct(tuple(value.type for value in values), function), values)
    return calls.of_kernel(scope, function, arguments, convert)


_KINDS: dict[type[ast.expr], Any] = {
    ast.Constant: _constant, ast.Name: _name, ast.Attribute: _attribute, ast.Tuple: _tuple,
    ast.UnaryOp: _unary, ast.BinOp: _binary, ast.Compare: _compare, ast.BoolOp: _boolean,
    ast.IfExp: _choice, ast.Subscript: _subscript, ast.Call: _call,
}  # fmt: skip

__all__ = ["built", "called", "convert", "expression", "is_scalar", "known", "literal", "part_of", "plain"]
