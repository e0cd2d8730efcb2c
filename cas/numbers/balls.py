"""A curve in ball arithmetic: enclosures of its Taylor series over points and intervals."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache
from typing import Any, Generic, TypeVar

from flint import arb, arb_series, ctx

from osculant.cas.formulas.expression import Node
from osculant.cas.numbers.fields import Balls
from osculant.cas.numbers.taylor import Program, program, pruned

#: bits of all decisions; the roots of simple zeros are located to about this accuracy
PRECISION = 320
#: terms that power series may have; beyond flint's default of 10 it would drop some in silence
TERMS = 128

Jet = TypeVar("Jet")


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """flint's working precision for a while, with power series of up to `TERMS` terms."""
    before = ctx.prec, ctx.cap
    ctx.prec, ctx.cap = bits, TERMS
    try:
        yield
    finally:
        ctx.prec, ctx.cap = before


def ball(low: Any, high: Any) -> Any:
    """The smallest ball around two others."""
    return arb(low).union(arb(high))


def constant(node: Node) -> Any:
    """The ball of a constant formula at the current precision.

    >>> from osculant.cas.formulas.parser import parse_constant
    >>> constant(parse_constant("1/4"))
    0.250000000000000
    """
    return _constant(node, ctx.prec)


@lru_cache(maxsize=4096)
def _constant(node: Node, bits: int) -> Any:
    return program([node], 0).run(arb(0), Balls())[0][0]


class FormulaBalls(Generic[Jet]):
    """Taylor series of the coordinates of a curve as enclosures, and jets of them.

    Args:
        coordinates: the formulas, as many as ``jet_type`` takes.
        jet_type: the jets made of them.
        variable: name of the parameter.
    """

    def __init__(
        self, coordinates: Sequence[Node], jet_type: Callable[..., Jet], variable: str = "t"
    ) -> None:
        self.coordinates = tuple(coordinates)
        self.jet_type = jet_type
        self.variable = variable
        self.field = Balls()
        self._programs: dict[int, Program] = {}

    def program(self, order: int) -> Program:
        """The program for the normalised Taylor coefficients 0…order, written once.

        It is a part of those for higher orders: where there is one, nothing has to be written.
        """
        if order not in self._programs:
            whole = self._programs.get(max(self._programs, default=-1))
            if whole is not None and len(whole.outputs[0]) > order:
                part = pruned(whole.instructions, [row[: order + 1] for row in whole.outputs])
            else:
                part = program(self.coordinates, order, self.variable, normalised=True)
            self._programs[order] = part
        return self._programs[order]

    def coefficients(self, t: Any, order: int) -> list[list[Any]]:
        """Normalised Taylor coefficients 0…order of each coordinate at all points of the ball t."""
        return self.program(order).run(t, self.field)

    def jet(self, t: Any, order: int) -> Jet:
        """The jet of that order at a ball, derivatives as balls."""
        factorials = [arb(1)]
        for k in range(1, order + 1):
            factorials.append(factorials[-1] * k)
        return self.jet_type(
            *([c * f for c, f in zip(row, factorials, strict=True)] for row in self.coefficients(t, order))
        )

    def series_jet(self, t: Any, order: int, length: int) -> Jet | None:
        """The jet of that order as power series of ``length`` terms about t; None where not finite."""
        rows = self.coefficients(t, order + length - 1)
        if not all(c.is_finite() for row in rows for c in row):
            return None
        derivatives: list[list[Any]] = []
        for row in rows:
            chain = []
            for _ in range(order + 1):
                chain.append(arb_series(row[:length], length))
                row = [k * c for k, c in enumerate(row)][1:]
            derivatives.append(chain)
        return self.jet_type(*derivatives)

    def form_series(self, form: Callable[[Jet], Any], t: Any, order: int, length: int) -> list[Any] | None:
        """Taylor coefficients of a form over jets of that order, at all points of the ball t."""
        jet = self.series_jet(t, order, length)
        return None if jet is None else padded(form(jet), length)

    def explain(self, t: Any) -> str:
        """Why the curve has no finite series at t: the first operation that fails, in words."""
        compiled = self.program(1)
        values = compiled.trace(t, self.field)
        for step, value in zip(compiled.instructions, values, strict=True):
            if not value.is_finite():
                return REASONS.get(step.op) or REASONS.get(str(step.value)) or f"{step.value} is undefined"
        return "it is undefined"


#: what it means that an operation has no finite value
REASONS = {
    "div": "a division by zero",
    "power": "a root of a number that is not positive",
    "sqrt": "a root of a number that is not positive",
    "log": "a logarithm of a number that is not positive",
    "tan": "a pole of tan",
    "sign": "abs has no derivative at 0",
    "mul": "a pole",
    "add": "a pole",
    "sub": "a pole",
}


def padded(series: Any, length: int) -> list[Any]:
    """The first coefficients of a power series, NaN where it does not reach so far."""
    found = list(series.coeffs())[:length]
    return found + [arb(0) if series.prec >= length else arb.nan()] * (length - len(found))
