"""All functions of one translation, the tuples and tables that they use, and the text of a C file."""

from __future__ import annotations

import ast
import inspect
import re
import textwrap
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from osculant.codegen.c import arithmetic, calls, logic, statements, subscripts
from osculant.codegen.c.scope import FRAME, Scope, Value, assignments
from osculant.codegen.c.types import (
    DOUBLE,
    INTEGER,
    NOTHING,
    Array,
    Known,
    Scalar,
    Struct,
    TranslationError,
    Type,
    c_name,
)

#: functions with no loops and at most so many lines are copied into their callers
SHORT = 24
#: what translates expressions: each enters its translators into `values` when it is imported
TRANSLATORS = (arithmetic, calls, logic, subscripts)
#: rounds in which a function's types are found
ROUNDS = 8

#: what every file begins with: arrays, and what Python's operators do to integers
PRELUDE = """\
typedef struct { double *p; int64_t n; } row;
typedef struct { double *p; int64_t n, stride; } column;
typedef struct { double *p; int64_t n, m; } table;
typedef struct { int64_t *p; int64_t n; } integers;
typedef struct { int64_t *p; int64_t n, m; } integer_table;
typedef struct {
    void (*evaluate)(double t, const double *parameters, double *out);
    const double *parameters;
} jet;

static inline double min_of(double a, double b) { return b < a ? b : a; }
static inline double max_of(double a, double b) { return b > a ? b : a; }
static inline int64_t min_of_integers(int64_t a, int64_t b) { return b < a ? b : a; }
static inline int64_t max_of_integers(int64_t a, int64_t b) { return b > a ? b : a; }
static inline int64_t quotient(int64_t a, int64_t b) { return a / b - (a % b != 0 && (a < 0) != (b < 0)); }
static inline int64_t remainder_of(int64_t a, int64_t b) { return a - quotient(a, b) * b; }
static inline double whole_power(double a, int64_t n) {
    double power = 1.0;
    if (n < 0) return 1.0 / whole_power(a, -n);
    for (; n != 0; n >>= 1, a *= a) if (n & 1) power *= a;
    return power;
}
static inline double *zeroed(double *p, int64_t n) { for (int64_t i = 0; i < n; i++) p[i] = 0.0; return p; }
"""


@dataclass(frozen=True)
class Function:
    """A kernel in C: its name, types, and the doubles of room that it takes as first argument, if any."""

    name: str
    parameters: tuple[Type, ...]
    result: Type
    room: int


class Translation:
    r"""A growing C file.

    Args:
        operations: of each record what it does, by the operation's name (`osculant.kernels.operations`).
        stubs: the operations by name.

    >>> from osculant.codegen.c.types import BOOLEAN
    >>> from osculant.kernels.bracket import safeguarded
    >>> translation = Translation({}, {})
    >>> translation.function(safeguarded, [DOUBLE, DOUBLE, BOOLEAN, DOUBLE, DOUBLE]).name
    'bracket_safeguarded'
    >>> print(*translation.text().splitlines()[-5:], sep="\n")
        if (!(new >= low && new <= high)) {
            new = 0.5 * (low + high);
        }
        return (tuple_of_3_doubles){{new, low, high}};
    }
    """

    def __init__(
        self, operations: Mapping[type, Mapping[str, Any]], stubs: Mapping[str, Callable[..., Any]]
    ) -> None:
        self._operations, self._stubs = operations, stubs
        self._functions: dict[Any, Function] = {}
        self._structs: dict[Struct, str] = {}
        self._tables: dict[int, tuple[str, Type, Any]] = {}
        self._names: set[str] = set()
        self._typedefs: list[str] = []
        self._texts: list[str] = []

    # --- types and tables ------------------------------------------------------------------------
    def c_type(self, kind: Type) -> str:
        """What C calls a type; tuples are declared when they are first met."""
        if isinstance(kind, (Scalar, Array)):
            return kind.c
        assert isinstance(kind, Struct), "what is known has no type in C"
        if kind not in self._structs:
            parts = [self.c_type(part) for part in kind.fields]
            if kind.kind is not None:
                name = self._free(f"{kind.kind.__module__.rsplit('.', 1)[-1]}_{kind.kind.__name__}")
            else:
                name = self._free(
                    f"{len(parts)}_{'doubles' if kind.fields[0] == DOUBLE else 'integers'}"
                    if kind.uniform
                    else "tuple"
                )
            if kind.uniform:
                inside = f"{parts[0]} at[{len(parts)}];"
            else:
                inside = " ".join(_declared(c, kind.member(i)) + ";" for i, c in enumerate(parts))
            self._structs[kind] = name
            self._typedefs.append(f"typedef struct {{ {inside} }} {name};")
        return self._structs[kind]

    def table(self, constant: Known) -> tuple[str, Type]:
        """The name of a constant array in C, and the type of its entries."""
        key = id(constant.value)
        if key not in self._tables:
            array = np.asarray(constant.value)
            kind = INTEGER if array.dtype.kind in "iub" else DOUBLE
            name = self._free(constant.name or "table")
            self._tables[key] = (name, kind, constant.value)
            sizes = "".join(f"[{size}]" for size in array.shape)
            self._typedefs.append(f"static const {kind.c} {name}{sizes} = {_braces(array, kind)};")
        return self._tables[key][:2]

    def _free(self, name: str) -> str:
        name = name if not name[0].isdigit() else f"tuple_of_{name}"
        found, serial = name, 1
        while found in self._names:
            serial += 1
            found = f"{name}_{serial}"
        self._names.add(found)
        return found

    # --- functions -------------------------------------------------------------------------------
    def chosen(self, function: Any, arguments: Sequence[Value]) -> Any:
        """What an operation does for the record that is its first argument; all else is itself."""
        plain = getattr(function, "__wrapped__", function)
        name = getattr(plain, "__name__", "")
        if name == "call_jet":
            return calls.JET
        if self._stubs.get(name) is not plain:
            return plain
        assert isinstance(arguments[0].type, Known)
        chosen = self._operations[type(arguments[0].type.value)].get(name, plain)
        return getattr(chosen, "__wrapped__", chosen)

    def function(self, function: Any, kinds: Sequence[Type]) -> Function:
        """The kernel translated for arguments of these types."""
        function = getattr(function, "__wrapped__", function)
        if not inspect.isfunction(function):
            raise TranslationError(
                f"The function {getattr(function, '__name__', function)} is not translated."
            )
        # records without fields are equal tuples: their types tell them apart
        key = (
            function,
            *((type(kind.value), kind.value) if isinstance(kind, Known) else kind for kind in kinds),
        )
        if key not in self._functions:
            self._functions[key] = self._translated(function, kinds)
        return self._functions[key]

    def _translated(self, function: Any, kinds: Sequence[Type]) -> Function:
        node = ast.parse(textwrap.dedent(inspect.getsource(function))).body[0]
        assert isinstance(node, ast.FunctionDef)
        names = [argument.arg for argument in node.args.args]
        known = {name: kind for name, kind in zip(names, kinds, strict=True) if isinstance(kind, Known)}
        passed = {name: kind for name, kind in zip(names, kinds, strict=True) if name not in known}
        scope = Scope(self, _names_of(function), assignments(node), dict(passed), frozenset(names))
        try:
            for _ in range(ROUNDS):
                before = dict(scope.types), scope.result
                scope.restart()
                scope.aliases.update(known)
                statements.body(scope, node.body)
                if (scope.types, scope.result) == before:
                    break
        except TranslationError as error:
            if "In " in str(error):
                raise
            raise TranslationError(f"In {function.__module__}.{function.__name__}: {error}") from None
        parameters = tuple(
            scope.types.get(name, kind) if name in passed else kind for name, kind in zip(names, kinds)
        )
        room = scope.frame + scope.beyond if scope.allocates else 0
        name = self._free(f"{function.__module__.rsplit('.', 1)[-1]}_{function.__name__}")
        made = Function(name, parameters, scope.result or NOTHING, room)
        self._texts.append(self._text(function, node, names, made, scope))
        return made

    def _text(
        self, function: Any, node: ast.FunctionDef, names: Sequence[str], made: Function, scope: Scope
    ) -> str:
        arguments = [
            _declared(self.c_type(kind), c_name(name))
            for name, kind in zip(names, made.parameters)
            if not isinstance(kind, Known)
        ]
        if made.room:
            arguments.insert(0, "double *room")
        loops = any(isinstance(part, (ast.For, ast.While)) for part in ast.walk(node))
        short = not loops and len(scope.lines) <= SHORT
        locals_: dict[str, list[str]] = {}
        for name, kind in scope.types.items():
            if name not in names and name != "_":
                start = " = 0" if name in scope.conditional and isinstance(kind, Scalar) else ""
                locals_.setdefault(self.c_type(kind), []).append(c_name(name) + start)
        lines = [f"    {_declared(c, ', '.join(found))};" for c, found in locals_.items()]
        used = set(re.findall(r"\w+", " ".join(scope.lines)))
        unused = [name for name, kind in zip(names, made.parameters) if not isinstance(kind, Known)]
        lines += [f"    (void){c_name(name)};" for name in unused if c_name(name) not in used]
        lines += [line.replace(FRAME, str(scope.frame)) for line in scope.lines]
        summary = (ast.get_docstring(node) or "").split("\n")[0]
        head = f"/* {function.__module__}.{function.__name__}: {summary} */\n"
        inline = "INLINE" if short else "static"
        signature = (
            f"{inline} {_declared(self.c_type(made.result), made.name)}({', '.join(arguments) or 'void'})"
        )
        return head + signature + " {\n" + "\n".join(lines) + "\n}\n"

    def text(self) -> str:
        """Everything translated so far, callees before callers."""
        return "\n".join([PRELUDE, *self._typedefs, "", *self._texts])


def _names_of(function: Any) -> dict[str, Any]:
    """What a function's free names stand for."""
    closure = inspect.getclosurevars(function)
    return {**closure.builtins, **function.__globals__, **closure.nonlocals}


def _declared(kind: str, name: str) -> str:
    return f"{kind}{name}" if kind.endswith("*") else f"{kind} {name}"


def _braces(array: Any, kind: Type) -> str:
    if array.ndim == 0:
        return str(int(array)) if kind is INTEGER else repr(float(array))
    return "{" + ", ".join(_braces(part, kind) for part in array) + "}"
