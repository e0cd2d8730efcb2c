"""Which kernels Python calls, and with what: those that a library built before has."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from osculant.codegen.c.types import (
    DOUBLE,
    INTEGER,
    INTEGER_TABLE,
    INTEGERS,
    JET,
    ROW,
    TABLE,
    Known,
    Struct,
    Type,
)
from osculant.kernels import jit, operations

#: families with machine code of their own besides the fits' ones
OTHERS = ("curves", "enclosures")


@dataclass(frozen=True)
class Entry:
    """A kernel that Python calls, and the types of its arguments."""

    kernel: Any
    kinds: tuple[Type, ...]

    @property
    def record(self) -> Any:
        """The record that is the first argument, if there is one."""
        return self.kinds[0].value if isinstance(self.kinds[0], Known) else None


def entries(family: str) -> Iterator[Entry]:
    """The kernels of a family that Python calls."""
    if family == "curves":
        yield from _of_curves()
    elif family == "enclosures":
        yield from _of_enclosures()
    else:
        for record in records(family):
            yield from _of_record(record)


def families() -> list[str]:
    """All families that have a library."""
    return [*sorted(path.parent.name for path in jit.ROOM.glob("*/records.py")), *OTHERS]


def records(family: str) -> list[Any]:
    """The records of a family: those that say something with all that they may say."""
    importlib.import_module(f"{jit.PACKAGE}.{family}.records")
    found = []
    for kind in operations.registered():
        if jit.family_of(kind.__module__) == family:
            found += [kind(*values) for values in getattr(sys.modules[kind.__module__], "VARIANTS", [()])]
    return found


def _of_record(record: Any) -> Iterator[Entry]:
    from osculant.kernels import counting, course, given_knots, quadrature, search, shapes
    from osculant.kernels.curves import plane, space

    fit = Known(record)
    if operations.registered()[type(record)]["dimension"] == 2:
        place: Type = Struct((DOUBLE,) * 5, plane.Place)
        frame: Type = Struct((DOUBLE,) * 4, plane.Frame)
    else:
        place, vector = Struct((DOUBLE,) * 5, space.Place), Struct((DOUBLE,) * 3)
        frame = Struct((vector, vector), space.Frame)
    stretch = (fit, JET, place, DOUBLE, frame, DOUBLE, frame)
    yield Entry(search.spline, (*stretch, DOUBLE, DOUBLE, DOUBLE, TABLE, TABLE))
    yield Entry(counting.count_larger, (*stretch, DOUBLE, DOUBLE, TABLE))
    yield Entry(course.lay_out, (fit, JET, place, ROW, TABLE))
    yield Entry(given_knots.fit_arcs, (fit, JET, place, ROW, frame, frame, TABLE, TABLE))
    yield Entry(shapes.shapes, (fit, TABLE, place, ROW, TABLE))
    yield Entry(quadrature.contents, (fit, JET, DOUBLE, ROW, ROW))
    if "density" in operations.registered()[type(record)]:
        yield Entry(quadrature.predicted, (fit, JET, DOUBLE, DOUBLE, DOUBLE))
        yield Entry(quadrature.predicted_roughly, (fit, JET, DOUBLE, DOUBLE, DOUBLE))


def _of_curves() -> Iterator[Entry]:
    from osculant.kernels.curves import invariants, jets, plane, space

    yield Entry(jets.sample_many, (JET, ROW, TABLE))
    yield Entry(invariants.invariants_at, (JET, ROW, TABLE))
    for kind in (plane, space):
        yield Entry(kind.frame_at, (JET, Struct((DOUBLE,) * 5, kind.Place), DOUBLE))


def _of_enclosures() -> Iterator[Entry]:
    from osculant.kernels.enclosures import isolation, parts, programs

    table = Struct((INTEGERS, INTEGERS, INTEGERS, TABLE), programs.Table)
    forms = Struct((INTEGER_TABLE, INTEGERS, INTEGERS), isolation.Forms)
    room = Struct((TABLE, TABLE, TABLE), isolation.Room)
    yield Entry(isolation.isolate, (table, forms, DOUBLE, DOUBLE, INTEGER, room, TABLE, TABLE))
    numbers = (DOUBLE, DOUBLE, INTEGER, INTEGER, TABLE, TABLE, TABLE, TABLE)
    yield Entry(parts.polynomial_parts, (table, INTEGER_TABLE, *numbers))
