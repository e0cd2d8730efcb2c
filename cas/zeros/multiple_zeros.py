"""Multiple zeros of forms, proved at simple numbers."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

from flint import arb

from osculant.cas.formulas.expression import Node
from osculant.cas.numbers.balls import ball, constant
from osculant.cas.zeros.isolate import differentiated, taylor_form
from osculant.cas.zeros.multiplicity import simple_numbers
from osculant.cas.zeros.points import SpecialPoint

if TYPE_CHECKING:
    from osculant.cas.zeros.form_zeros import FormZeros

#: Taylor coefficients looked at, in turn, for the multiplicity of a zero
MULTIPLE = (2, 10, 30, 90)
#: terms beyond the multiplicity that show a zero to be alone
BEYOND = 16


class MultipleZeros:
    """Proves that a form has one zero, a multiple one, in a neighbourhood of a small interval.

    If at a simple number c the first m Taylor coefficients of the form vanish exactly and its m-th
    derivative has one sign on the neighbourhood, the form is (t − c)^m times something without zeros.
    """

    def __init__(self, zeros: FormZeros[Any], ends: tuple[Node, Node]) -> None:
        self.zeros = zeros
        self.ends = [(end, constant(end)) for end in ends]
        # asked again at every width until the answer is yes
        self.multiplicity, self.vanishes_at = cache(self._multiplicity), cache(zeros.vanishes_at)
        self.points: list[SpecialPoint] = []

    def __call__(self, name: str, low: Any, high: Any) -> tuple[Any, Any] | None:
        """The neighbourhood, if a zero is proved in it (and noted in ``points``)."""
        width = high - low
        low, high = arb((low - width).mid()), arb((high + width).mid())
        candidates = [(end, at) for end, at in self.ends if at >= low and at <= high]
        for number in simple_numbers(low, high):
            at = constant(number)
            if not (at < self.ends[0][1] or at > self.ends[1][1]):
                candidates.append((number, at))
        for candidate, at in candidates:
            if self.only_zero(name, candidate, ball(low, high)):
                self.points.append(SpecialPoint(at, frozenset([name])))
                return low, high
        return None

    def only_zero(self, name: str, candidate: Node, whole: Any) -> bool:
        """Whether the form has a multiple zero exactly at the candidate and no other in ``whole``."""
        multiplicity = self.multiplicity(name, candidate)
        if multiplicity < 2:
            return False  # not a zero, or a simple one, which isolation finds by itself
        centre = arb(whole.mid())
        over = self.zeros.series(name, whole, multiplicity + BEYOND)
        around = self.zeros.series(name, centre, multiplicity + BEYOND)
        if over is None or around is None:
            return False
        for _ in range(multiplicity):
            around, over = differentiated(around), differentiated(over)
        if taylor_form(around, over, whole - centre).contains(0):
            return False
        return self.vanishes_at(name, candidate, multiplicity)

    def _multiplicity(self, name: str, candidate: Node) -> int:
        """How many Taylor coefficients at the candidate seem to vanish before one that does not."""
        for length in MULTIPLE:
            series = self.zeros.series(name, constant(candidate), length)
            for count, c in enumerate(series or [arb(1)]):
                if not c.contains(0):
                    return count
        return 0
