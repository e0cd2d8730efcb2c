"""Arithmetic: what Python's operators do to doubles and integers, in C."""

from __future__ import annotations

import ast
from typing import Any

from osculant.codegen.c.scope import PLUS, TIMES, UNARY, Scope, Value
from osculant.codegen.c.types import BOOLEAN, DOUBLE, INTEGER, Known, TranslationError, unify
from osculant.codegen.c.values import expression, plain, translates

#: operators of C that do what Python's do, and how tightly they bind
ARITHMETIC = {ast.Add: ("+", PLUS), ast.Sub: ("-", PLUS), ast.Mult: ("*", TIMES), ast.Div: ("/", TIMES)}

#: and those of bits
BITS = {ast.BitAnd: "&", ast.BitOr: "|", ast.LShift: "<<"}


@translates(ast.UnaryOp)
def _unary(scope: Scope, node: ast.UnaryOp) -> Value:
    value = expression(scope, node.operand)
    if isinstance(value.type, Known):
        negated = not value.type.value if isinstance(node.op, ast.Not) else -value.type.value
        return Value("", Known(negated, f"-{value.type.name}" if value.type.name else ""))
    if isinstance(node.op, ast.Not):
        return Value(f"!{value.within(UNARY)}", BOOLEAN, UNARY)
    if isinstance(node.op, ast.Invert):
        return Value(f"~{value.within(UNARY)}", INTEGER, UNARY)
    space = " " if value.text.startswith("-") else ""
    return Value(f"-{space}{value.within(UNARY)}", value.type, UNARY)


@translates(ast.BinOp)
def _binary(scope: Scope, node: ast.BinOp) -> Value:
    left, right = expression(scope, node.left), expression(scope, node.right)
    if isinstance(node.op, ast.Pow):
        return _power(scope, left, right)
    if isinstance(left.type, Known) and isinstance(right.type, Known):
        return Value("", Known(_folded(node.op, left.type.value, right.type.value)))
    a, b = plain(scope, left), plain(scope, right)
    kind = unify(unify(a.type, b.type), INTEGER)
    if type(node.op) in BITS:
        return Value(f"((int64_t){a.within(UNARY)} {BITS[type(node.op)]} {b.within(UNARY)})", INTEGER)
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
