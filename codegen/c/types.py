"""The types of the kernels' values, and what C calls them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from osculant.cas.errors import OsculantError


class TranslationError(OsculantError):
    """Something in a kernel that has no translation."""


#: words of C, and of the emitted files, that variables and fields of kernels may bear
RESERVED = frozenset(
    re.findall(
        r"\w+",
        """
        auto bool break case char const continue default do double else enum extern float for goto if inline
        int long register restrict return short signed sizeof static struct switch typedef union unsigned void
        while row column table integers integer_table jet room y0 y1 yn j0 j1 jn gamma index
        """,
    )
)


def c_name(name: str) -> str:
    """What C calls a variable or a field.

    >>> c_name("area"), c_name("signed")
    ('area', 'signed_')
    """
    return f"{name}_" if name in RESERVED else name


@dataclass(frozen=True)
class Scalar:
    """A number, or what is passed on like one; ``rank`` orders those that widen into each other."""

    c: str
    rank: int = -1


DOUBLE, INTEGER, BOOLEAN = Scalar("double", 2), Scalar("int64_t", 1), Scalar("bool", 0)
NOTHING, JET = Scalar("void"), Scalar("const jet *")


@dataclass(frozen=True)
class Array:
    """An array of numbers: "row" (contiguous), "column" (with a stride) or "table" (rows of one length)."""

    c: str
    of: Scalar = DOUBLE


ROW, COLUMN, TABLE = Array("row"), Array("column"), Array("table")
INTEGERS, INTEGER_TABLE = Array("integers", INTEGER), Array("integer_table", INTEGER)
#: what a row of a table is
ROWS = {TABLE: ROW, INTEGER_TABLE: INTEGERS}


@dataclass(frozen=True)
class Struct:
    """A tuple; ``kind`` is its `NamedTuple` class, None if it has no names."""

    fields: tuple[Type, ...]
    kind: Any = None

    @property
    def uniform(self) -> bool:
        """Whether it is kept as a C array: without names, of one type of numbers."""
        return self.kind is None and len(set(self.fields)) == 1 and isinstance(self.fields[0], Scalar)

    def member(self, index: int) -> str:
        """What C calls a field."""
        if self.uniform:
            return f"at[{index}]"
        return c_name(self.kind._fields[index]) if self.kind else f"f{index}"


@dataclass(frozen=True, eq=False)
class Known:
    """A value that is known when a kernel is translated: a constant, a record, a function, a module."""

    value: Any
    name: str = ""


Type: TypeAlias = Scalar | Array | Struct | Known


def type_of(value: Any) -> Type:
    """The type of a constant.

    >>> type_of((1.0, 2.0)).fields == (DOUBLE, DOUBLE)
    True
    """
    if isinstance(value, bool):
        return BOOLEAN
    if isinstance(value, (int, np.integer)):
        return INTEGER
    if isinstance(value, float):
        return DOUBLE
    if isinstance(value, tuple):
        return Struct(tuple(map(type_of, value)), type(value) if hasattr(value, "_fields") else None)
    raise TranslationError(f"A constant {value!r} has no type in C.")


def is_scalar(value: Any) -> bool:
    """Whether a constant is a number or a truth value."""
    return isinstance(value, (bool, int, float, np.integer))


def unify(a: Type | None, b: Type) -> Type:
    """The type that values of both have.

    >>> unify(INTEGER, DOUBLE) is DOUBLE, unify(None, BOOLEAN) is BOOLEAN
    (True, True)
    """
    if isinstance(b, Known):
        b = type_of(b.value)
    if a is None or a == b:
        return b
    if isinstance(a, Scalar) and isinstance(b, Scalar) and min(a.rank, b.rank) >= 0:
        return max(a, b, key=lambda scalar: scalar.rank)
    if (
        isinstance(a, Struct)
        and isinstance(b, Struct)
        and a.kind is b.kind
        and len(a.fields) == len(b.fields)
    ):
        return Struct(tuple(unify(x, y) for x, y in zip(a.fields, b.fields)), a.kind)
    raise TranslationError(f"A variable is a {a} and a {b}.")


def has_arrays(kind: Type) -> bool:
    """Whether a value of the type points to memory."""
    return isinstance(kind, Array) or (isinstance(kind, Struct) and any(map(has_arrays, kind.fields)))
