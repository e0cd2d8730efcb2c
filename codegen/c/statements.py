"""Statements of a kernel → lines of C."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from osculant.codegen.c.scope import Scope, Value
from osculant.codegen.c.types import (
    DOUBLE,
    INTEGER,
    NOTHING,
    ROW,
    Known,
    Struct,
    TranslationError,
    Type,
    c_name,
    is_scalar,
    unify,
)
from osculant.codegen.c.values import convert, expression, known, literal, part_of, plain

#: what is done to every number of a row
SIGNS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}


def body(scope: Scope, nodes: Sequence[ast.stmt]) -> bool:
    """Translate statements in order; returns whether what follows is never reached."""
    return any(statement(scope, node) for node in nodes)


def statement(scope: Scope, node: ast.stmt) -> bool:
    """Translate one statement; returns whether what follows is never reached."""
    if isinstance(node, ast.Expr):
        if not isinstance(node.value, ast.Constant):
            scope.emit(f"{expression(scope, node.value).text};")
    elif isinstance(node, ast.Assign):
        _assign(scope, node.targets, node.value)
    elif isinstance(node, ast.AugAssign):
        _augmented(scope, node)
    elif isinstance(node, ast.If):
        return _if(scope, node)
    elif isinstance(node, ast.For):
        _for(scope, node)
    elif isinstance(node, ast.While):
        _while(scope, node)
    elif isinstance(node, ast.Return):
        _return(scope, node)
        return True
    elif isinstance(node, (ast.Break, ast.Continue)):
        scope.emit("break;" if isinstance(node, ast.Break) else "continue;")
        return True
    else:
        raise TranslationError(f"Not translated: {ast.unparse(node)}.")
    return False


def _return(scope: Scope, node: ast.Return) -> None:
    if node.value is None:
        scope.result = NOTHING
        scope.emit("return;")
        return
    value = plain(scope, expression(scope, node.value))
    scope.result = unify(scope.result, value.type)
    scope.emit(f"return {convert(scope, value, scope.result).text};")


def _if(scope: Scope, node: ast.If) -> bool:
    test = expression(scope, node.test)
    if isinstance(test.type, Known):
        return body(scope, node.body if test.type.value else node.orelse)
    with scope.block(f"if ({test.text})", "} else {" if node.orelse else "}"):
        left = body(scope, node.body)
    if not node.orelse:
        return False
    scope.depth += 1
    other = body(scope, node.orelse)
    scope.depth -= 1
    scope.emit("}")
    return left and other


def _while(scope: Scope, node: ast.While) -> None:
    with scope.aside() as lines:
        test = plain(scope, expression(scope, node.test))
    with scope.block("for (;;)" if lines else f"while ({test.text})"):
        if lines:
            scope.lines += ["    " + line for line in lines]
            scope.emit(f"if (!({test.text})) break;")
        body(scope, node.body)


def _for(scope: Scope, node: ast.For) -> None:
    if isinstance(node.iter, ast.Call):
        function = known(scope, node.iter.func)
        if function is range:
            return _range(scope, node, node.iter.args)
        if function is enumerate:
            assert isinstance(node.target, ast.Tuple)
            index, target = node.target.elts
            return _over(scope, node.iter.args[0], target, node.body, index)
    return _over(scope, node.iter, node.target, node.body)


def _range(scope: Scope, node: ast.For, bounds: Sequence[ast.expr]) -> None:
    """A loop over whole numbers; its bounds are computed once, and its variable keeps its last value."""
    values = [expression(scope, bound) for bound in bounds]
    step = values[2].type.value if len(values) == 3 and isinstance(values[2].type, Known) else 1
    start = plain(scope, values[0]).text if len(values) > 1 else "0"
    stop = plain(scope, values[min(1, len(values) - 1)])
    if not isinstance(values[min(1, len(values) - 1)].type, Known):
        stop = scope.temporary(Value(stop.text, INTEGER))
    assert isinstance(node.target, ast.Name)
    scope.serial += 1
    name = node.target.id
    counter = f"i{scope.serial}_"
    scope.variable(name, INTEGER)
    sign, move = ("<", "++") if step > 0 else (">", "--")
    move = f"{counter}{move}" if abs(step) == 1 else f"{counter} += {step}"
    with scope.block(f"for (int64_t {counter} = {start}; {counter} {sign} {stop.text}; {move})"):
        if name != "_":
            scope.emit(f"{c_name(name)} = {counter};")
        body(scope, node.body)


def _over(
    scope: Scope,
    iterable: ast.expr,
    target: ast.expr,
    inside: Sequence[ast.stmt],
    index: ast.expr | None = None,
) -> None:
    """A loop over the parts of a tuple, with their indices if they are wanted."""
    whole = expression(scope, iterable)
    if isinstance(whole.type, Known):
        parts = [literal(scope, Known(value)) for value in whole.type.value]
    else:
        whole = whole if whole.text.isidentifier() else scope.temporary(whole)
        assert isinstance(whole.type, Struct)
        parts = [part_of(scope, whole, i) for i in range(len(whole.type.fields))]
    kind: Type = parts[0].type
    for part in parts[1:]:
        kind = unify(kind, part.type)
    scope.serial += 1
    items, counter = f"items{scope.serial}_", f"i{scope.serial}_"
    inner = ", ".join(part.text for part in parts)
    scope.emit(f"const {scope.translation.c_type(kind)} {items}[] = {{{inner}}};")
    with scope.block(f"for (int64_t {counter} = 0; {counter} < {len(parts)}; {counter}++)"):
        if index is not None:
            _store(scope, index, Value(counter, INTEGER))
        _store(scope, target, Value(f"{items}[{counter}]", kind))
        body(scope, inside)


def _augmented(scope: Scope, node: ast.AugAssign) -> None:
    load = ast.parse(ast.unparse(node.target), mode="eval").body
    if isinstance(node.target, ast.Name) and scope.types.get(node.target.id) is ROW:
        _each(scope, load, node)
    else:
        _assign(scope, [node.target], ast.BinOp(load, node.op, node.value))


def _each(scope: Scope, row: ast.expr, node: ast.AugAssign) -> None:
    """row *= factor: every number of a row."""
    name = expression(scope, row).text
    scope.serial += 1
    counter = f"i{scope.serial}_"
    factor = scope.temporary(plain(scope, expression(scope, node.value)))
    with scope.block(f"for (int64_t {counter} = 0; {counter} < {name}.n; {counter}++)"):
        scope.emit(f"{name}.p[{counter}] {SIGNS[type(node.op)]}= {factor.text};")


def _assign(scope: Scope, targets: Sequence[ast.expr], node: ast.expr) -> None:
    target = targets[0]
    if len(targets) > 1:  # a = b = value
        value = scope.temporary(plain(scope, expression(scope, node)))
        for each in targets:
            _store(scope, each, value)
    elif isinstance(target, ast.Tuple) and isinstance(node, ast.Tuple):
        _together(scope, target.elts, node.elts)
    else:
        _store(scope, target, expression(scope, node))


def _together(scope: Scope, targets: Sequence[ast.expr], nodes: Sequence[ast.expr]) -> None:
    """a, b = x, y: all values are found before any is stored, unless that makes no difference."""
    if _independent(targets, nodes):
        for target, node in zip(targets, nodes, strict=True):
            _store(scope, target, expression(scope, node))
        return
    values = []
    for node in nodes:
        value = expression(scope, node)
        values.append(value if isinstance(value.type, Known) else scope.temporary(value))
    for target, value in zip(targets, values, strict=True):
        _store(scope, target, value)


def _independent(targets: Sequence[ast.expr], nodes: Sequence[ast.expr]) -> bool:
    stored: set[str] = set()
    arrays = any(isinstance(target, ast.Subscript) for target in targets)
    for target, node in zip(targets, nodes, strict=True):
        parts = list(ast.walk(node))
        if any(isinstance(part, ast.Name) and part.id in stored for part in parts):
            return False
        if arrays and any(isinstance(part, (ast.Subscript, ast.Call)) for part in parts):
            return False
        stored |= {part.id for part in ast.walk(target) if isinstance(part, ast.Name)}
    return True


def _store(scope: Scope, target: ast.expr, value: Value) -> None:
    if isinstance(target, ast.Tuple):
        whole = plain(scope, value)
        whole = whole if whole.text.isidentifier() else scope.temporary(whole)
        for i, part in enumerate(target.elts):
            _store(scope, part, part_of(scope, whole, i))
    elif isinstance(target, ast.Name):
        _store_name(scope, target.id, value)
    else:
        place = expression(scope, target)
        if place.type is not DOUBLE:
            raise TranslationError(f"Not a place of an array: {ast.unparse(target)}.")
        scope.emit(f"{place.text} = {plain(scope, value).text};")


def _store_name(scope: Scope, name: str, value: Value) -> None:
    if name == "_":
        return
    once = scope.assigned.get(name) == 1 and name not in scope.parameters
    if isinstance(value.type, Known) and once and not is_scalar(value.type.value):
        scope.aliases[name] = value.type
        return
    value = plain(scope, value)
    if name not in scope.types and scope.depth > 1:
        scope.conditional.add(name)
    scope.variable(name, value.type)
    scope.emit(f"{c_name(name)} = {convert(scope, value, scope.types[name]).text};")
