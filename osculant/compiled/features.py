"""A formula's Taylor program in the source of a library, for `osculant.kernels.standalone.features`."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import TYPE_CHECKING, Any

from osculant.cas.numbers.parts import FIRST, NARROWEST, ORDER, WORK_LIMIT
from osculant.cas.numbers.recurrences import Instruction
from osculant.cas.numbers.taylor import Program, program
from osculant.codegen.c.types import BOOLEAN, DOUBLE, INTEGER, INTEGER_TABLE, INTEGERS, TABLE, Struct, Type
from osculant.curves.enclosed import table_of

if TYPE_CHECKING:
    from osculant.compiled.subject import Subject


def features_type() -> Type:
    """The type of a curve's features in the kernels."""
    from osculant.kernels.enclosures.programs import Table
    from osculant.kernels.standalone.features import Features

    table = Struct((INTEGERS, INTEGERS, INTEGERS, TABLE), Table)
    return Struct((table, INTEGER_TABLE, TABLE, BOOLEAN, INTEGER, DOUBLE, INTEGER), Features)


@cache
def _programmed(subject: Subject) -> tuple[Any, tuple[tuple[int, ...], ...], dict[int, int]]:
    """(the table, where the coefficients are, and by the number of an instruction which constant it is)."""
    assert subject.coordinates is not None
    written = program(subject.coordinates, ORDER, normalised=True, parameters=subject.parameters)
    places = {
        i: subject.parameters.index(step.value)
        for i, step in enumerate(written.instructions)
        if step.op == "parameter"
    }
    steps = [
        Instruction("constant", (), "e") if i in places else s for i, s in enumerate(written.instructions)
    ]
    return table_of(Program(tuple(steps), written.outputs)), written.outputs, places


def features_arrays(subject: Subject) -> str:
    """The program's arrays as constants of C."""
    table, outputs, _ = _programmed(subject)
    rows = [index for output in outputs for index in output]
    columns = {"codes": table.codes, "firsts": table.first, "seconds": table.second, "rows": rows}
    lines = [
        f"static const int64_t {name}_of_curve[{len(values)}] = {{{_listed(values)}}};"
        for name, values in columns.items()
    ]
    numbers = ", ".join(_double(float(number)) for number in table.numbers.ravel())
    lines.append(f"static const double numbers_of_curve[{table.numbers.size}] = {{{numbers}}};")
    return "\n".join(lines)


def _listed(values: Iterable[int]) -> str:
    return ", ".join(str(int(value)) for value in values)


def _double(value: float) -> str:
    return "INFINITY" if value == float("inf") else "-INFINITY" if value == -float("inf") else repr(value)


def features_lines(subject: Subject) -> list[str]:
    """The lines of a function of C that make ``features``, with the values of the constants."""
    kind = "features_Features"
    limits = f"{FIRST}, {NARROWEST!r}, {WORK_LIMIT}"
    if subject.coordinates is None:
        return [f"const {kind} features = {{{{{{NULL, 0}}, {{NULL, 0}}, {{NULL, 0}}, {{NULL, 0, 2}}}}, "
                f"{{NULL, 0, 0}}, {{NULL, 0, 2}}, false, {limits}}};"]  # fmt: skip
    table, outputs, places = _programmed(subject)
    n, terms = len(table.codes), len(outputs[0])
    columns = ", ".join(f"{{(int64_t *){name}_of_curve, {n}}}" for name in ("codes", "firsts", "seconds"))
    lines = [
        f"double numbers[{2 * n}], values[{2 * n}];",
        f"for (int i = 0; i < {2 * n}; i++) numbers[i] = numbers_of_curve[i];",
    ]
    for index, which in places.items():
        lines.append(f"numbers[{2 * index}] = parameters[{which}], numbers[{2 * index + 1}] = 0.0;")
    lines.append(
        f"const {kind} features = {{{{{columns}, {{numbers, {n}, 2}}}}, "
        f"{{(int64_t *)rows_of_curve, {len(outputs)}, {terms}}}, {{values, {n}, 2}}, true, {limits}}};"
    )
    return lines
