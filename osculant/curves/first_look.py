"""A first look at the zeros of forms in enclosures of doubles, a hundred times as fast as ball arithmetic.

Where it finds that a form has no zero, or at most one, this rests on the C library's functions being right to
the 8 ulps that `osculant.kernels.zeros.enclosures` allows them.  That there is one, ball arithmetic confirms
when it narrows the bracket.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from osculant.cas.numbers.balls import FormulaBalls
    from osculant.cas.numbers.taylor import Program
    from osculant.cas.zeros.form_zeros import ZeroForm
    from osculant.cas.zeros.isolate import Isolation
    from osculant.kernels.zeros.programs import Table

#: terms of the Taylor models: 4 take the least time
TERMS = 4
#: instructions that all boxes together may take, and boxes at most and at least
BUDGET, MOST, LEAST = 2e7, 20_000, 200
#: zeros, and places that are open; a form open in more places is left to ball arithmetic altogether
ZEROS, OPEN, FEW = 4096, 512, 32
#: a place beyond which a zero is not told from an end of the interval, in units of rounding of the ends
NEAR = 2.0**-48


class FirstLook:
    """The first look at the zeros of some forms along a curve.

    Args:
        curve: in ball arithmetic, for its formulas.
        forms: by name.
    """

    def __init__(self, curve: FormulaBalls[Any], forms: Mapping[str, ZeroForm[Any]]) -> None:
        self.curve, self.forms = curve, forms
        self._programs: dict[tuple[str, ...], tuple[Table, Any]] = {}

    def __call__(self, names: Sequence[str], low: Any, high: Any) -> Isolation:
        """Brackets of simple zeros on [low, high], and what is open.

        The ends are balls. Brackets have doubles as ends, where the sign is certain; what is too near to an
        end of the interval is open.
        """
        import numpy as np
        from flint import arb

        from osculant.cas.zeros.isolate import Box, Isolation
        from osculant.kernels.zeros.isolation import Room, isolate

        whole = Isolation({name: [] for name in names}, [Box(low, high, tuple(names))])
        a, b = float(low.lower()), float(high.upper())
        a, b = a - math.ulp(a), b + math.ulp(b)
        if not math.isfinite(b - a) or not names:
            return whole
        table, forms = self._program(tuple(names))
        size = len(table.codes)
        budget = min(MOST, max(LEAST, int(BUDGET / (2 * size))))
        brackets, boxes = np.empty((ZEROS, 3)), np.empty((OPEN, 3))
        room = Room(np.empty((size, 2)), np.empty((size, 2)), np.empty((budget + 2, 3)))
        found = isolate(table, forms, a, b, budget, room, brackets, boxes)
        if found.brackets > ZEROS or found.open > OPEN:
            return whole
        near = NEAR * max(abs(a), abs(b))
        opened = [(start, end, int(bits)) for start, end, bits in boxes[: found.open].tolist()]
        result = Isolation({name: [] for name in names})
        for form, start, end in brackets[: found.brackets].tolist():
            if start - a <= near or b - end <= near:
                opened.append((start - near, end + near, 1 << int(form)))
            else:
                result.brackets[names[int(form)]].append((arb(start), arb(end)))
        for k, name in enumerate(names):
            parts = _joined(sorted((start, end) for start, end, bits in opened if bits >> k & 1))
            if len(parts) > FEW:
                result.brackets[name] = []
                parts = [(a, b)]
            for start, end in parts:
                ends = low if start <= a + near else arb(start), high if end >= b - near else arb(end)
                result.unresolved.append(Box(*ends, (name,)))
        return result

    def _program(self, names: tuple[str, ...]) -> tuple[Table, Any]:
        """The table of the forms' program, and which of its values they are."""
        if names not in self._programs:
            import numpy as np

            from osculant.cas.zeros.programs import form_program
            from osculant.kernels.zeros.isolation import Forms

            forms = [self.forms[name] for name in names]
            owners: list[int] = []

            def series(jet: Any) -> list[Any]:
                rows: list[Any] = []
                for k, form in enumerate(forms):
                    rows += [form.form(jet), *form.parts(jet)]
                    owners.extend([k] * (len(rows) - len(owners)))
                return rows

            program = form_program(
                self.curve.coordinates,
                self.curve.jet_type,
                series,
                max(form.order for form in forms),
                TERMS,
                self.curve.variable,
            )
            rows, leading = np.array(program.outputs), np.searchsorted(owners, range(len(forms)))
            self._programs[names] = table_of(program), Forms(rows, np.array(owners), leading)
        return self._programs[names]


def _joined(parts: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Intervals in order, as one where they touch."""
    found: list[tuple[float, float]] = []
    for start, end in parts:
        if found and start <= found[-1][1]:
            start, end = found[-1][0], max(end, found.pop()[1])
        found.append((start, end))
    return found


def table_of(program: Program) -> Table:
    """A program as kernels interpret it.

    >>> from osculant.cas.formulas.parser import parse
    >>> from osculant.cas.numbers.taylor import program
    >>> table_of(program([parse("t^2")], 0)).codes.tolist()
    [1, 4]
    """
    import numpy as np

    from osculant.kernels.zeros.enclosures import NAMES
    from osculant.kernels.zeros.programs import CALL, OPERATIONS, Table

    codes = {name: code for code, name in enumerate(OPERATIONS)}
    codes |= {f"call {name}": CALL + code for code, name in enumerate(NAMES)}
    size = len(program.instructions)
    codes_of, first, second = np.zeros((3, size), dtype=np.int64)
    table = Table(codes_of, first, second, np.zeros((size, 2)))
    for i, step in enumerate(program.instructions):
        if step.op in ("number", "constant"):
            table.numbers[i] = _ball(step.value)
        elif step.op == "power":
            table.numbers[i] = float(step.value), 0.0
        op = {"call": f"call {step.value}", "constant": "number"}.get(step.op, step.op)
        table.codes[i] = codes[op]
        if step.args:
            table.first[i], table.second[i] = step.args[0], step.args[-1]
    return table


def _ball(value: Any) -> tuple[float, float]:
    """A rational, pi or e as a double, and how far off it is at most."""
    if isinstance(value, str):
        number = math.pi if value == "pi" else math.e
        return number, math.ulp(number)
    try:
        number = float(value)
    except OverflowError:
        return math.inf, math.inf
    return number, 0.0 if Fraction(number) == value else math.ulp(number)
