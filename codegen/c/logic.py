"""Comparisons and choices; what is evaluated only under a condition stays under it."""

from __future__ import annotations

import ast
from collections.abc import Sequence
from typing import Any

from osculant.codegen.c.scope import AND, CHOICE, EQUAL, LESS, OR, PLUS, UNARY, Scope, Value
from osculant.codegen.c.types import BOOLEAN, Known, unify
from osculant.codegen.c.values import convert, expression, literal, plain, translates

COMPARISONS = {
    ast.Lt: ("<", LESS), ast.LtE: ("<=", LESS), ast.Gt: (">", LESS), ast.GtE: (">=", LESS),
    ast.Eq: ("==", EQUAL), ast.NotEq: ("!=", EQUAL),
}  # fmt: skip


@translates(ast.Compare)
def _compare(scope: Scope, node: ast.Compare) -> Value:
    left, parts, folded = expression(scope, node.left), [], True
    for i, (operator, other) in enumerate(zip(node.ops, node.comparators)):
        right = expression(scope, other)
        if isinstance(operator, (ast.In, ast.NotIn)):
            return _among(scope, left, right, isinstance(operator, ast.In))
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


def _among(scope: Scope, value: Value, others: Value, wanted: bool) -> Value:
    """Whether a number is one of some constants, or is not."""
    assert isinstance(others.type, Known)
    if isinstance(value.type, Known):
        return Value("", Known((value.type.value in others.type.value) is wanted))
    value = value if value.text.isidentifier() else scope.temporary(value)
    sign, joint, binds = ("==", "||", OR) if wanted else ("!=", "&&", AND)
    texts = [f"{value.text} {sign} {literal(scope, Known(other)).text}" for other in others.type.value]
    return Value(f" {joint} ".join(texts), BOOLEAN, binds)


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


@translates(ast.BoolOp)
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


@translates(ast.IfExp)
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
