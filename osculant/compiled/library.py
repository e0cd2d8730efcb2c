"""The C source of an approximator: the translated kernels, the curve, and the functions that are called."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from osculant.codegen.c.jets import jet_function
from osculant.codegen.c.program import Translation
from osculant.codegen.c.types import BOOLEAN, DOUBLE, INTEGER, JET, ROW, TABLE, Known, Type
from osculant.compiled.features import features_arrays, features_lines, features_type
from osculant.compiled.interface import Argument, given, signature
from osculant.compiled.numbers import RESOLVING, UNITS, Numbers
from osculant.compiled.precise import precise_jet
from osculant.version import __version__

if TYPE_CHECKING:
    from osculant.compiled.subject import Subject
    from osculant.primitives.primitive import Fit

#: the forms that split curves at run time: numbers of `osculant.kernels.standalone.special`, by dimension
FORMS = {2: {"inflection": 1, "parabolic": 2, "sextactic": 3, "vertex": 4}, 3: {"vertex": 5}}
#: derivatives that the forms take
LONGEST = {0: 0, 1: 2, 2: 4, 3: 5, 4: 3, 5: 3}

#: what every source begins with
HEAD = """\
#include "{name}.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#if defined(__GNUC__)
#define INLINE static inline __attribute__((always_inline))
#else
#define INLINE static inline
#endif

"""


@dataclass(frozen=True)
class Approximator:
    """What a library that approximates is made from.

    Attributes:
        subject: the curve.
        fit: what the pieces are.
        split: "theory" or "never".
        numbers: of a fixed curve.
    """

    subject: Subject
    fit: Fit
    split: str
    numbers: Numbers | None

    @property
    def record(self) -> Any:
        """The record of the fit in the kernels."""
        return self.fit.record(self.numbers.order if self.numbers else self.fit.order)

    @property
    def fields(self) -> tuple[str, ...]:
        """The names of a piece's numbers."""
        return tuple(self.piece._fields)

    @property
    def piece(self) -> Any:
        """The `NamedTuple` class of a piece."""
        from osculant.kernels.operations import piece_type

        return piece_type(type(self.record))

    @property
    def form_names(self) -> list[str]:
        """The forms whose zeros split the curve at run time, two at most."""
        subject, primitive = self.subject, self.fit.primitive
        names = [*primitive.splits, *(primitive.theory if self.split == "theory" else ())]
        known = FORMS[subject.dimension] if subject.coordinates is not None else {}
        return [name for name in names if name in known][:2]

    @property
    def forms(self) -> list[int]:
        """Their numbers, two of them, 0 for none."""
        return [*(FORMS[self.subject.dimension][name] for name in self.form_names), 0, 0][:2]

    def functions(self) -> list[tuple[str, str, list[Argument]]]:
        """(name, purpose, arguments) of the functions that are called."""
        name, which = self.subject.name, given(self.subject)
        before = [argument for argument in which if not argument.name.startswith("split")]
        after = [argument for argument in which if argument.name.startswith("split")]
        error = "distance" if self.fit.degree == 1 else "area between"
        array = [
            Argument(f"{name}_piece *pieces", "where to write them; may be NULL if capacity is 0"),
            Argument("size_t capacity", "how many it has room for"),
            Argument("size_t *count", "how many there are; those beyond capacity are not written"),
        ]
        bound = "a bound of each piece's error" if self.fit.degree == 1 else "a bound of the errors' sum"
        return [
            (
                f"{name}_for_tolerance",
                f"The fewest {self.fit.primitive.plural} found whose {error} is within a tolerance.",
                [*before, Argument("double tolerance", bound), *after, *array],
            ),
            (
                f"{name}_for_pieces",
                f"At most so many {self.fit.primitive.plural}, their largest error about the least.",
                [*before, Argument("size_t number", "how many pieces there may be"), *after, *array],
            ),
        ]


def source(wanted: Approximator, command: str) -> str:
    """The C file of an approximator, behind the header that `osculant.compiled.header` writes.

    Args:
        wanted: what it does.
        command: that compiles it.
    """
    from osculant.kernels import operations
    from osculant.kernels.standalone import free, stretches

    translation = Translation(operations.registered(), operations.operations())
    record: Type = Known(wanted.record)
    if wanted.numbers is not None:
        common = [record, JET, ROW, TABLE, TABLE]
        entries = [
            translation.function(stretches.for_tolerance, [*common, DOUBLE, INTEGER, TABLE]),
            translation.function(stretches.for_number, [*common, INTEGER, INTEGER, TABLE]),
        ]
    else:
        forms: list[Type] = [INTEGER, JET, BOOLEAN, INTEGER, INTEGER]
        numbers: list[Type] = [DOUBLE, DOUBLE, DOUBLE, DOUBLE, ROW, BOOLEAN, ROW]
        numbers.insert(4, features_type())
        kinds = [record, JET, JET, *forms, *numbers, DOUBLE, INTEGER, INTEGER, TABLE]
        entries = [translation.function(free.approximate, kinds)] * 2
    outcome = translation.c_type(entries[0].result)
    curve = _curve(wanted, translation)
    parts = [
        title_of(wanted.subject, wanted.fit.primitive.plural, command),
        HEAD.format(name=wanted.subject.name),
        translation.text(),
        curve,
    ]
    for (name, _, arguments), entry, tolerant in zip(wanted.functions(), entries, (True, False)):
        call = _fixed_call if wanted.numbers is not None else _free_call
        body = [
            f"double room[{entry.room}];",
            *call(wanted, entry.name, outcome, tolerant),
            "if (count != NULL) *count = (size_t)outcome.found;",
            "return (int)outcome.status;",
        ]
        parts.append(
            signature(name, arguments) + "\n{\n" + "\n".join("    " + line for line in body) + "\n}\n"
        )
    return "\n".join(parts)


def title_of(about: Subject, what: str, command: str) -> str:
    """The comment at the top of a source."""
    return (
        f"/*\n * {about.name}.c: {what} for the curve {about.text}.\n"
        f" * Generated by osculant {__version__} from its kernels, named above each function; do not edit.\n"
        f" * {command}\n */\n"
    )


def _curve(wanted: Approximator, translation: Translation) -> str:
    """The jets of the formula, and of a fixed curve its numbers."""
    subject, parts = wanted.subject, []
    if subject.coordinates is not None:
        parts.append("/* The curve and its derivatives. */")
        parts.append(
            jet_function("curve_jet", subject.coordinates, subject.dimension, subject.parameters) + "\n"
        )
    order = _order(wanted)
    if wanted.numbers is None and order > subject.dimension and subject.coordinates is not None:
        parts.append("/* The same with as many derivatives as special points take. */")
        parts.append(jet_function("longer_jet", subject.coordinates, order, subject.parameters) + "\n")
    if wanted.numbers is None and subject.coordinates is not None:
        parts.append("/* The derivatives 0 ... 3, and of each form value and slope, in pairs of doubles. */")
        parts.append(precise_jet(translation, subject, wanted.form_names) + "\n")
        parts.append("/* Its Taylor program, as enclosures of doubles interpret it. */")
        parts.append(features_arrays(subject) + "\n")
    if wanted.numbers is not None:
        parts.append(
            "/* Of the curve: scale, noise, floor, shares, resolution, origin; stretches; features. */"
        )
        parts.append(array_of("size_of_curve", [wanted.numbers.size], flat=True))
        parts.append(array_of("stretches_of_curve", wanted.numbers.stretches))
        parts.append(array_of("edges_of_curve", wanted.numbers.edges))
    else:
        parts.append(
            "/* The floor of tolerances and the shares kept for rounding, in rounding units; resolution. */"
        )
        outlined = subject.dimension == 2 and wanted.split == "theory"
        parts.append(array_of("units", [UNITS if outlined else RESOLVING], flat=True))
    return "\n".join(parts)


def _order(wanted: Approximator) -> int:
    return max([wanted.subject.dimension, *(LONGEST[form] for form in wanted.forms)])


def array_of(name: str, rows: Sequence[Sequence[float]], flat: bool = False) -> str:
    """A constant array of C, or its one row if it is to be flat."""
    inside = [", ".join(_number(float(value)) for value in row) for row in rows]
    if flat:
        return f"static const double {name}[{len(rows[0])}] = {{{inside[0]}}};"
    lines = ",\n    ".join("{" + row + "}" for row in inside)
    return f"static const double {name}[{len(rows)}][{len(rows[0])}] = {{\n    {lines}\n}};"


def _number(value: float) -> str:
    return "INFINITY" if value == float("inf") else repr(value)


def _pieces(wanted: Approximator) -> str:
    return f"(table){{(double *)pieces, (int64_t)capacity, {len(wanted.fields)}}}"


def _fixed_call(wanted: Approximator, entry: str, outcome: str, tolerant: bool) -> list[str]:
    numbers = wanted.numbers
    assert numbers is not None
    sought = "tolerance" if tolerant else "(int64_t)number"
    return [
        "const jet at = {curve_jet, NULL};",
        f"const row size = {{(double *)size_of_curve, {len(numbers.size)}}};",
        f"const table stretches = {{(double *)stretches_of_curve, {len(numbers.stretches)}, "
        f"{len(numbers.stretches[0])}}};",
        f"const table edges = {{(double *)edges_of_curve, {len(numbers.edges)}, 2}};",
        f"const {outcome} outcome = {entry}(room, &at, size, stretches, edges, {sought}, "
        f"{wanted.fit.degree}, {_pieces(wanted)});",
    ]


def _free_call(wanted: Approximator, entry: str, outcome: str, tolerant: bool) -> list[str]:
    subject = wanted.subject
    own = subject.coordinates is None
    parameters = "parameters" if subject.parameters or own else "NULL"
    order = _order(wanted)
    longer = "at" if own or order == subject.dimension else "longer"
    lines = [f"const jet at = {{{'evaluate' if own else 'curve_jet'}, {parameters}}};"]
    if longer == "longer":
        lines.append(f"const jet longer = {{longer_jet, {parameters}}};")
    if not own:
        lines.append(f"const jet precise = {{precise_jet, {parameters}}};")
    lines += features_lines(subject)
    ends = "low, 0.0, high, 0.0"
    if subject.ends is not None:
        ends = ", ".join(repr(part) for which in (0, 1) for part in parts_of_end(subject, which))
    form, other = wanted.forms
    sought = "tolerance, 0" if tolerant else "0.0, number < 20000000 ? (int64_t)number : 20000000"
    precise = "&at, false" if own else "&precise, true"
    lines.append(
        f"const {outcome} outcome = {entry}(room, &at, &{longer}, {order}, {precise}, {form}, {other}, "
        f"{ends}, features, "
        f"(row){{(double *)splits, splits == NULL ? 0 : (int64_t)split_count}}, splits != NULL, "
        f"(row){{(double *)units, {len(UNITS)}}}, {sought}, {wanted.fit.degree}, {_pieces(wanted)});"
    )
    return lines


def end_of(subject: Subject, which: int) -> str:
    """An end of the interval, 0 or 1, as a double of C."""
    return repr(parts_of_end(subject, which)[0])


def parts_of_end(subject: Subject, which: int) -> tuple[float, float]:
    """The nearest double to an end of the interval, 0 or 1, and what it lacks."""
    from osculant.cas.numbers.balls import PRECISION, constant, precision

    assert subject.ends is not None
    with precision(PRECISION):
        exact = constant(subject.ends[which])
        high = float(exact.mid())
        return high, float((exact - high).mid())
