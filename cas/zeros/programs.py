"""Forms over jets as Taylor programs: straight lines of instructions, for whoever has another arithmetic.

Jets take any numbers; here they are made of power series of instructions, so that what a form does with them
is written down instead of done.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.graph import topological
from osculant.cas.numbers.recurrences import Writer
from osculant.cas.numbers.taylor import Program, pruned


class WrittenSeries:
    """A power series whose coefficients are the numbers of instructions."""

    def __init__(self, writer: Writer, coefficients: list[int]) -> None:
        self.writer, self.coefficients = writer, coefficients

    def _other(self, other: Any) -> WrittenSeries:
        if isinstance(other, WrittenSeries):
            return other
        first = self.writer.number(Fraction(other))
        return WrittenSeries(self.writer, self.writer.padded(first, len(self.coefficients)))

    def _termwise(self, combine: Callable[[int, int], int], other: Any) -> WrittenSeries:
        pairs = zip(self.coefficients, self._other(other).coefficients, strict=True)
        return WrittenSeries(self.writer, [combine(a, b) for a, b in pairs])

    def __add__(self, other: Any) -> WrittenSeries:
        return self._termwise(self.writer.add, other)

    def __sub__(self, other: Any) -> WrittenSeries:
        return self._termwise(self.writer.sub, other)

    def __rsub__(self, other: Any) -> WrittenSeries:
        return self._other(other) - self

    def __neg__(self) -> WrittenSeries:
        return WrittenSeries(self.writer, [self.writer.neg(a) for a in self.coefficients])

    def __mul__(self, other: Any) -> WrittenSeries:
        if not isinstance(other, WrittenSeries):
            scaled = [self.writer.scale(a, Fraction(other)) for a in self.coefficients]
            return WrittenSeries(self.writer, scaled)
        return WrittenSeries(self.writer, self.writer.product(self.coefficients, other.coefficients))

    __radd__, __rmul__ = __add__, __mul__


def form_program(
    coordinates: Sequence[Node],
    jet_type: Callable[..., Any],
    forms: Callable[[Any], Sequence[WrittenSeries]],
    order: int,
    length: int,
    variable: str = "t",
    parameters: Sequence[str] = (),
) -> Program:
    """The program for the first ``length`` Taylor coefficients of forms over a jet of that order.

    Its outputs have a row for each form.  ``parameters`` are variables that do not change along the curve.
    Raises FormulaError if a coordinate has another variable.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> from osculant.cas.jets.plane import PlaneJet
    >>> from osculant.cas.numbers.fields import Doubles
    >>> bend = form_program(parse_tuple("t, t^3"), PlaneJet, lambda jet: [jet.inflection_form], 2, 3)
    >>> bend.run(2.0, Doubles())
    [[12.0, 6.0, 0.0]]
    """
    writer = Writer(variable, parameters)
    series: dict[Node, list[int]] = {}
    for node in topological(coordinates):
        series[node] = writer.series(node, [series[arg] for arg in node.args], order + length)
    chains = []
    for coordinate in coordinates:
        row, chain = series[coordinate], []
        for _ in range(order + 1):
            chain.append(WrittenSeries(writer, row[:length]))
            row = writer.slopes(row)
        chains.append(chain)
    return pruned(writer.steps, [form.coefficients for form in forms(jet_type(*chains))])
