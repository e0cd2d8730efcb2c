"""A first look at the zeros of forms in enclosures of doubles, a hundred times as fast as ball arithmetic.

Where it finds that a form has no zero, or at most one, this rests on the C library's functions being right to
the 8 ulps that `osculant.kernels.enclosures.balls` allows them.  That there is one is seen by signs, and
again by an interval Newton step that narrows the bracket: the form in balls, its slope from here.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from osculant.curves.enclosed import enclosed, joined, table_of

if TYPE_CHECKING:
    from osculant.cas.numbers.balls import FormulaBalls
    from osculant.cas.numbers.taylor import Program
    from osculant.cas.zeros.form_zeros import ZeroForm
    from osculant.cas.zeros.isolate import Isolation
    from osculant.kernels.enclosures.programs import Table

#: terms of the Taylor models: 4 take the least time
TERMS = 4
#: instructions that all boxes together may take, and boxes at most and at least
BUDGET, MOST, LEAST = 2e7, 20_000, 200
#: zeros, and places that are open; a form open in more places is left to ball arithmetic altogether
ZEROS, OPEN, FEW = 4096, 512, 32
#: a place beyond which a zero is not told from an end of the interval, in units of rounding of the ends
NEAR = 2.0**-48


class _Interval:
    """Doubles around an interval whose ends are balls, and back: what is next to an end is that end.

    Attributes:
        low, high: the ends.
        a, b: doubles outside of them.
        near: how near to a double is next to it.
    """

    def __init__(self, low: Any, high: Any) -> None:
        a, b = float(low.lower()), float(high.upper())
        self.low, self.high = low, high
        self.a, self.b = a - math.ulp(a), b + math.ulp(b)
        self.near = NEAR * max(abs(self.a), abs(self.b))

    @property
    def is_finite(self) -> bool:
        """Whether doubles reach so far."""
        return math.isfinite(self.b - self.a)

    def exact(self, start: float, end: float) -> tuple[Any, Any]:
        """A part of the interval, with its ends as balls."""
        from flint import arb

        first = self.low if start <= self.a + self.near else arb(start)
        return first, self.high if end >= self.b - self.near else arb(end)


class FirstLook:
    """The first look at the zeros of some forms along a curve.

    Args:
        curve: in ball arithmetic, for its formulas.
        forms: by name.
    """

    def __init__(self, curve: FormulaBalls[Any], forms: Mapping[str, ZeroForm[Any]]) -> None:
        self.curve, self.forms = curve, forms
        self._programs: dict[tuple[str, ...], tuple[Table, Any]] = {}
        self._written: dict[tuple[str, int], Program] = {}

    def unclear(self, low: Any, high: Any) -> list[tuple[Any, Any]]:
        """Intervals of [low, high] outside of which the curve is finite."""
        interval = _Interval(low, high)
        found = enclosed(self.curve).unclear(interval.a, interval.b) if interval.is_finite else None
        return [(low, high)] if found is None else [interval.exact(*part) for part in found]

    def written(self, name: str, length: int) -> Program | None:
        """The program for a form's first Taylor coefficients; None if they are not among those looked at."""
        known = self._written.get((name, TERMS))
        if known is None or length > TERMS:
            return None
        if (name, length) not in self._written:
            from osculant.cas.numbers.taylor import pruned

            self._written[name, length] = pruned(known.instructions, [known.outputs[0][:length]])
        return self._written[name, length]

    def __call__(self, names: Sequence[str], low: Any, high: Any) -> Isolation:
        """Brackets of simple zeros on [low, high], and what is open.

        The ends are balls. Brackets have doubles as ends, where the sign is certain; what is too near to an
        end of the interval is open.  Their slopes are enclosures in doubles.
        """
        import numpy as np
        from flint import arb

        from osculant.cas.zeros.isolate import Blind, Box, Isolation
        from osculant.kernels.enclosures.isolation import Room, isolate

        interval = _Interval(low, high)
        if not interval.is_finite or not names:
            return Blind()(names, low, high)
        table, forms = self._program(tuple(names))
        size = len(table.codes)
        budget = min(MOST, max(LEAST, int(BUDGET / (2 * size))))
        brackets, boxes = np.empty((ZEROS, 5)), np.empty((OPEN, 3))
        room = Room(np.empty((size, 2)), np.empty((size, 2)), np.empty((budget + 2, 3)))
        found = isolate(table, forms, interval.a, interval.b, budget, room, brackets, boxes)
        if found.brackets > ZEROS or found.open > OPEN:
            return Blind()(names, low, high)
        near = interval.near
        opened = [(start, end, int(bits)) for start, end, bits in boxes[: found.open].tolist()]
        result = Isolation({name: [] for name in names})
        for form, start, end, slope, radius in brackets[: found.brackets].tolist():
            if start - interval.a <= near or interval.b - end <= near:
                opened.append((start - near, end + near, 1 << int(form)))
            else:
                result.brackets[names[int(form)]].append(interval.exact(start, end))
                if abs(slope) > radius:
                    result.slopes[names[int(form)], start] = arb(slope, radius)
        for k, name in enumerate(names):
            parts = joined(sorted((start, end) for start, end, bits in opened if bits >> k & 1))
            if len(parts) > FEW:
                result.brackets[name] = []
                parts = [(interval.a, interval.b)]
            result.unresolved += [Box(*interval.exact(*part), (name,)) for part in parts]
        return result

    def _program(self, names: tuple[str, ...]) -> tuple[Table, Any]:
        """The table of the forms' program, and which of its values they are."""
        if names not in self._programs:
            import numpy as np

            from osculant.cas.numbers.taylor import Program
            from osculant.cas.zeros.programs import form_program
            from osculant.kernels.enclosures.isolation import Forms

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
            for name, first in zip(names, leading.tolist()):
                self._written[name, TERMS] = Program(program.instructions, (program.outputs[first],))
            self._programs[names] = table_of(program), Forms(rows, np.array(owners), leading)
        return self._programs[names]
