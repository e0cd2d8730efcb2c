"""The functions of Python that kernels call, and calls of kernels."""

from __future__ import annotations

import ast
import builtins
import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from osculant.codegen.c.scope import FRAME, UNARY, Scope, Value
from osculant.codegen.c.types import (
    BOOLEAN,
    DOUBLE,
    INTEGER,
    NOTHING,
    ROW,
    TABLE,
    Known,
    Struct,
    TranslationError,
    has_arrays,
    type_of,
    unify,
)
from osculant.codegen.c.values import built, convert, expression, known, part_of, plain, translates

#: (scope, arguments) → the value of a call
Translator = Callable[[Scope, Sequence[Value]], Value]


def _of_libm(name: str) -> Translator:
    """A function of doubles that libm has."""

    def call(scope: Scope, arguments: Sequence[Value]) -> Value:
        if all(isinstance(value.type, Known) for value in arguments):
            values = [value.type.value for value in arguments]  # type: ignore[union-attr]
            return Value("", Known(getattr(math, name)(*values)))
        texts = [plain(scope, value).text for value in arguments]
        return Value(f"{name}({', '.join(texts)})", DOUBLE)

    return call


def _predicate(name: str) -> Translator:
    """Whether a double is one of a kind."""

    def call(scope: Scope, arguments: Sequence[Value]) -> Value:
        return Value(f"(bool){name}({plain(scope, arguments[0]).text})", BOOLEAN, UNARY)

    return call


def _rounded(name: str) -> Translator:
    """To a whole number."""

    def call(scope: Scope, arguments: Sequence[Value]) -> Value:
        value = plain(scope, arguments[0])
        text = f"{name}({value.text})" if name else value.within(UNARY)
        return value if value.type is INTEGER else Value(f"(int64_t){text}", INTEGER, UNARY)

    return call


def _float(scope: Scope, arguments: Sequence[Value]) -> Value:
    [value] = arguments
    if isinstance(value.type, Known):
        return Value("", Known(float(value.type.value)))
    return value if value.type is DOUBLE else Value(f"(double){value.within(UNARY)}", DOUBLE, UNARY)


def _abs(scope: Scope, arguments: Sequence[Value]) -> Value:
    value = plain(scope, arguments[0])
    return Value(f"{'fabs' if value.type is DOUBLE else 'llabs'}({value.text})", value.type)


def _extreme(name: str) -> Translator:
    """The least or the greatest, from the left: of two that are not ordered, the first."""

    def call(scope: Scope, arguments: Sequence[Value]) -> Value:
        values = [plain(scope, value) for value in arguments]
        kind = values[0].type
        for value in values[1:]:
            kind = unify(kind, value.type)
        suffix = "" if kind is DOUBLE else "_integers"
        found = values[0].text
        for value in values[1:]:
            found = f"{name}{suffix}({found}, {value.text})"
        return Value(found, kind)

    return call


def _len(scope: Scope, arguments: Sequence[Value]) -> Value:
    kind = arguments[0].type
    if isinstance(kind, (Known, Struct)):
        return Value("", Known(len(kind.value if isinstance(kind, Known) else kind.fields)))
    return Value(f"{arguments[0].text}.n", INTEGER)


def _room(zero: bool) -> Translator:
    """`np.empty`, `np.zeros`: room of a size that is known."""

    def call(scope: Scope, arguments: Sequence[Value]) -> Value:
        shape = arguments[0].type
        if not isinstance(shape, Known):
            raise TranslationError("The size of an array is not known: C has no room for it.")
        sizes = shape.value if isinstance(shape.value, tuple) else (shape.value,)
        count = math.prod(sizes)
        place = scope.room(count)
        if zero:
            place = f"zeroed({place}, {count})"
        inside = ", ".join([place, *map(str, sizes)])
        kind = ROW if len(sizes) == 1 else TABLE
        return Value(f"({kind.c}){{{inside}}}", kind)

    return call


def _jet(scope: Scope, arguments: Sequence[Value]) -> Value:
    jet, t, out = (plain(scope, value).text for value in arguments)
    return Value(f"{jet}->evaluate({t}, {jet}->parameters, {out}.p)", NOTHING)


def reshaped(scope: Scope, whole: Value, shape: Value) -> Value:
    """A table with rows of another length."""
    if whole.type is not TABLE or not isinstance(shape.type, Struct):
        raise TranslationError("Only tables are reshaped.")
    whole, shape = scope.temporary(whole), scope.temporary(shape)
    return Value(f"(table){{{whole.text}.p, {shape.text}.at[0], {shape.text}.at[1]}}", TABLE)


def of_kernel(scope: Scope, function: Any, arguments: Sequence[Value]) -> Value:
    """A call of a kernel, translated for the types of the arguments, with room for what it allocates."""
    kinds = [_passed(value.type) for value in arguments]
    callee = scope.translation.function(function, kinds)
    passed = [
        convert(scope, value, wanted).text
        for value, wanted in zip(arguments, callee.parameters, strict=True)
        if not isinstance(wanted, Known)
    ]
    if callee.room:
        scope.allocates = True
        if has_arrays(callee.result):  # what it returns lies in its room
            passed.insert(0, scope.room(callee.room))
        else:
            scope.beyond = max(scope.beyond, callee.room)
            passed.insert(0, f"room + {FRAME}")
    return Value(f"{callee.name}({', '.join(passed)})", callee.result)


def _passed(kind: Any) -> Any:
    """Constants are passed as values; records and functions are not passed at all."""
    if isinstance(kind, Known) and not callable(kind.value):
        value = kind.value
        if not (isinstance(value, tuple) and hasattr(value, "_fields")):
            return type_of(value)
    return kind


KNOWN: dict[Any, Translator] = {
    **{getattr(math, name): _of_libm(name) for name in (
        "sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh",
        "acosh", "atanh", "exp", "log", "copysign", "hypot",
    )},
    **{getattr(math, name): _predicate(name) for name in ("isnan", "isinf", "isfinite")},
    math.ceil: _rounded("ceil"), math.floor: _rounded("floor"), builtins.int: _rounded(""),
    builtins.float: _float, builtins.abs: _abs, builtins.len: _len,
    builtins.min: _extreme("min_of"), builtins.max: _extreme("max_of"),
    np.empty: _room(False), np.zeros: _room(True), np.cbrt: _of_libm("cbrt"),
}  # fmt: skip

#: what stands for numba's intrinsic: the call of a compiled jet
JET = _jet
KNOWN[JET] = _jet


@translates(ast.Call)
def _call(scope: Scope, node: ast.Call) -> Value:
    arguments: list[Value] = []
    if isinstance(node.func, ast.Attribute) and node.func.attr == "reshape":
        return reshaped(scope, expression(scope, node.func.value), expression(scope, node.args[0]))
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
    if function in KNOWN:
        return KNOWN[function](scope, arguments)
    if isinstance(function, type):  # a NamedTuple
        values = [plain(scope, value) for value in arguments]
        return built(scope, Struct(tuple(value.type for value in values), function), values)
    return of_kernel(scope, function, arguments)
