"""Zeros of forms along a curve, such as the one that vanishes where the curvature does.

Which forms is a parameter: a table of `ZeroForm` by name. Simple zeros are isolated in ball arithmetic;
multiple ones are decided exactly where they lie at a simple rational, at a simple multiple of pi, or at an
end of the interval; the rest is called undecided. The work is bounded.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any, Generic, TypeVar

from flint import arb

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import Node
from osculant.cas.numbers.balls import PRECISION, FormulaBalls, ball, constant, padded, precision
from osculant.cas.numbers.parts import polynomial_parts
from osculant.cas.zeros.isolate import (
    LENGTH,
    SMALLEST,
    Blind,
    Box,
    Decide,
    Isolation,
    Look,
    differentiated,
    first_infinite,
    isolate,
    refine,
    taylor_form,
)
from osculant.cas.zeros.multiple_zeros import MultipleZeros
from osculant.cas.zeros.multiplicity import order_of_zero, simple_numbers
from osculant.cas.zeros.points import SpecialPoint, merged

#: unresolved boxes that are nearer than this many widths are one place
NEAR = 256
#: bits of the interval to which a simple zero is known, if nothing else is asked
BITS = PRECISION // 2
#: probes that may show that a form does not vanish identically
PROBES = ("0.38196601", "0.61803399", "0.14589803", "0.85410197", "0.5278640")
#: features of the curve that are larger than this part of it have a probe of their own
HIDDEN = 2.0**-40
#: intervals at most on which a form is looked at alone
MOST_SPANS = 32
#: bits that isolation has beyond those that tell it where to look; a form is as good as nothing below this
#: part of what it is elsewhere
SPARE, TINY = 96, 2.0**-1000

Jet = TypeVar("Jet")


@dataclass(frozen=True)
class ZeroForm(Generic[Jet]):
    """A form over jets whose zeros matter.

    ``order`` is that of the jets it needs; ``parts`` gives forms that vanish too wherever it does, and may
    sooner be seen not to.
    """

    form: Callable[[Jet], Any]
    order: int
    parts: Callable[[Jet], tuple[Any, ...]] = lambda jet: ()


#: (curve, forms) → the first look at their zeros
Looks = Callable[[FormulaBalls[Any], Mapping[str, ZeroForm[Any]]], Look]


class FormZeros(Generic[Jet]):
    """The zeros of some forms along a curve.

    Args:
        curve: in ball arithmetic.
        forms: by name.
        look: makes of them what looks first.

    >>> from osculant.cas.jets.balls import CurveBalls
    >>> from osculant.cas.formulas.parser import parse_constant, parse_tuple
    >>> forms = {"inflection": ZeroForm(lambda jet: jet.inflection_form, 2)}
    >>> zeros = FormZeros(CurveBalls(parse_tuple("t, t^3")), forms)
    >>> [point] = zeros.within(parse_constant("-1"), parse_constant("2"), ["inflection"])
    >>> sorted(point.kinds), abs(point.at) < 1e-30
    (['inflection'], True)
    """

    def __init__(
        self, curve: FormulaBalls[Jet], forms: Mapping[str, ZeroForm[Jet]], look: Looks | None = None
    ) -> None:
        self.curve, self.forms = curve, forms
        self.look: Look = look(curve, forms) if look else Blind()

    def vanishes(self, name: str, low: Any, high: Any) -> bool:
        """Whether a form seems to vanish identically: its balls contain 0 at every probe, to 600 digits.

        So they do where the curve has its features, if only in places.  False is a proof; True asks for a
        symbolic one.
        """
        for bits in (PRECISION, 2048):
            with precision(bits):
                for probe in PROBES:
                    t = arb((low + (high - low) * arb(probe)).mid())
                    series = self.series(name, t, 1)
                    if series is None:
                        raise DomainError(undefined(self.curve, t, t, ()))
                    if not series[0].contains(0):
                        return False
        return all(self._is_zero(name, t) for t in self._features(low, high))

    def _is_zero(self, name: str, t: float) -> bool:
        """Whether the form cannot be told from 0 at a double."""
        with precision(PRECISION):
            series = self.series(name, arb(t), 1)
            return series is None or series[0].contains(0)

    def _features(self, low: Any, high: Any) -> list[float]:
        """The middles of the curve's parts, the narrowest first."""
        parts = sorted(self._parts(low, high), key=lambda part: part[1] - part[0])
        return [(start + end) / 2 for start, end in parts]

    def _parts(self, low: Any, high: Any) -> list[tuple[float, float]]:
        """Parts of the curve that are at least as fine as its features."""
        a, b = float(low.mid()), float(high.mid())
        with precision(PRECISION):
            points = (row[0] for t in (low, high) for row in self.curve.coefficients(arb(t.mid()), 0))
            largest = max(float(abs(x).upper()) for x in points if x.is_finite())
        return list(pairwise(polynomial_parts(self.curve, a, b, HIDDEN * (largest or 1.0))))

    def require_finite(self, low: Node, high: Node, names: Sequence[str]) -> None:
        """Raises DomainError, naming the parameter, unless the named forms are finite on [low, high]."""
        with precision(PRECISION):
            infinite = first_infinite(self.evaluate, names, constant(low), constant(high), self.look)
            if infinite is not None:
                raise DomainError(undefined(self.curve, *infinite, (low, high)))

    def within(
        self, low: Node, high: Node, names: Sequence[str], limit: int | None = None, bits: int = BITS
    ) -> list[SpecialPoint]:
        """The zeros of the named forms in [low, high], in order, merged where they coincide.

        Points at the ends are reported too. The curve has to be finite there: see `require_finite`.
        After ``limit`` boxes, by default `isolate.WORK_LIMIT`, what is left is undecided.  Simple zeros are
        known to 2^-bits of the interval.
        """
        with precision(PRECISION):
            a, b = constant(low), constant(high)
            multiple = MultipleZeros(self, (low, high))
            found, ends = self._isolated(multiple, names, a, b, limit)
            accuracy = (b - a) * arb(2) ** -bits
            points = self._simple(found, accuracy) + multiple.points + ends
            known = [point.at for point in points]
            small = (b - a) * NEAR * arb(2) ** -SMALLEST
            for box in _joined(found.unresolved):
                whole = ball(box.low, box.high)
                if box.high - box.low < small:
                    places = [next((at for at in known if at.overlaps(whole)), arb(whole.mid()))]
                else:  # the work limit left it over: then both its ends are knots
                    places = [arb(box.low.mid()), arb(box.high.mid())]
                points += [SpecialPoint(at, frozenset(box.open), decided=False) for at in places]
            return merged(points, b - a)

    def _isolated(
        self, decide: Decide, names: Sequence[str], low: Any, high: Any, limit: int | None
    ) -> tuple[Isolation, list[SpecialPoint]]:
        """`isolate`, and the ends of where a form is as good as nothing, which is left out.

        A bump on a line curves it everywhere, but only about the bump so that digits, or anybody, could tell.
        """
        begun = self.look(names, low, high)
        whole = {name for box in begun.unresolved if box.low is low and box.high is high for name in box.open}
        flat = [name for name in whole if self._is_flat(name, low, high)]
        boxes = [
            Box(b.low, b.high, tuple(name for name in b.open if name not in flat)) for b in begun.unresolved
        ]
        found = isolate(self.evaluate, decide, names, low, high, limit, boxes)
        for name in names:
            found.brackets[name] += begun.brackets[name]
        found.slopes = begun.slopes
        ends: list[SpecialPoint] = []
        for name in flat:
            for start, end in self._told(name, low, high):
                part = isolate(self.evaluate, decide, [name], start, end, limit)
                found.brackets[name] += part.brackets[name]
                found.unresolved += part.unresolved
                inside = [at for at in (start, end) if at > low and at < high]
                ends += [SpecialPoint(at, frozenset([name]), decided=False) for at in inside]
        return found, ends

    def _is_flat(self, name: str, low: Any, high: Any) -> bool:
        """Whether a form is as good as nothing about one of the probes, beside another."""
        places = [float((low + (high - low) * arb(probe)).mid()) for probe in PROBES]
        sizes = [self._size(name, t, 0.0) for t in places]
        return not min(sizes) > max(sizes) * TINY

    def _size(self, name: str, t: float, reach: float) -> Any:
        """The largest term of the Taylor polynomial of a form within reach of a double; infinite without one.

        It is 0 if no coefficient can be told from 0.
        """
        with precision(PRECISION - SPARE):
            series = self.series(name, arb(t), LENGTH if reach else 1)
        if series is None:
            return arb("inf")
        if all(c.contains(0) for c in series):
            return arb(0)
        return max(abs(c).upper() * arb(reach) ** k for k, c in enumerate(series))

    def _told(self, name: str, low: Any, high: Any) -> list[tuple[Any, Any]]:
        """The intervals on which a form is not as good as nothing, the whole if they are many."""
        spans: list[tuple[Any, Any]] = []
        parts = self._parts(low, high)
        sizes = [
            [self._size(name, t, (end - start) / 2) for t in (start, (start + end) / 2, end)]
            for start, end in parts
        ]
        largest = max((min(three) for three in sizes if all(x.is_finite() for x in three)), default=arb(0))
        for (start, end), three in zip(parts, sizes, strict=True):
            if not min(three) > largest * TINY:
                continue
            if spans and spans[-1][1] == start:
                start = spans.pop()[0]
            spans.append((start, end))
        if len(spans) > MOST_SPANS:
            return [(low, high)]
        a, b = float(low.mid()), float(high.mid())
        return [(low if x == a else arb(x), high if y == b else arb(y)) for x, y in spans]

    def evaluate(self, t: Any, names: Sequence[str], terms: int) -> dict[str, list[list[Any]]] | None:
        """Series of several forms and of their parts over one ball; None where the curve is not finite."""
        jet = self.curve.series_jet(t, max(self.forms[name].order for name in names), terms)
        if jet is None:
            return None
        return {
            name: [padded(s, terms) for s in (self.forms[name].form(jet), *self.forms[name].parts(jet))]
            for name in names
        }

    def series(self, name: str, t: Any, length: int) -> list[Any] | None:
        """Taylor coefficients of one form at all points of the ball t; None where not finite."""
        written = self.look.written(name, length)
        if written is not None:
            [series] = written.run(t, self.curve.field)
            return series if all(c.is_finite() for c in series) else None
        return self.curve.form_series(self.forms[name].form, t, self.forms[name].order, length)

    def _simple(self, found: Isolation, accuracy: Any) -> list[SpecialPoint]:
        points = []
        for name, brackets in found.brackets.items():

            def value(t: Any, name: str = name) -> Any:
                series = self.series(name, t, 1)
                return arb.nan() if series is None else series[0]

            def slope(t: Any, name: str = name) -> Any:
                series = self.series(name, t, 2)
                if series is not None and not series[1].contains(0):
                    return series[1]
                centre = arb(t.mid())  # a wide ball: the Taylor form that isolated the zero
                over, at = self.series(name, t, LENGTH), self.series(name, centre, LENGTH)
                if over is None or at is None:
                    return arb.nan()
                return taylor_form(differentiated(at), differentiated(over), t - centre)

            for low, high in brackets:
                known = found.slopes.get((name, float(low.mid())))
                steep = slope if known is None else partial(_always, known)
                zero = refine(value, steep, low, high, accuracy)
                if zero is not None:
                    points.append(SpecialPoint(zero, frozenset([name])))
        return points

    def vanishes_at(self, name: str, candidate: Node, multiplicity: int) -> bool:
        """Whether the first ``multiplicity`` Taylor coefficients of a form vanish exactly at a constant."""
        wanted = self.forms[name]
        return order_of_zero(self.curve, wanted.form, wanted.order, candidate, multiplicity)


def _always(known: Any, t: Any) -> Any:
    return known


def _joined(boxes: list[Box]) -> list[Box]:
    """Unresolved boxes as one where less than `NEAR` of their widths lies between them."""
    joined: list[Box] = []
    for box in sorted(boxes, key=lambda box: float(box.low.mid())):
        if joined and joined[-1].high + NEAR * (box.high - box.low) > box.low:
            last = joined.pop()
            box = Box(last.low, box.high, tuple(sorted({*last.open, *box.open})))
        joined.append(box)
    return joined


def undefined(curve: FormulaBalls[Any], low: Any, high: Any, ends: Sequence[Node]) -> str:
    """The sentence for a small interval in which the curve has no finite series."""
    whole = ball(low, high)
    known = [constant(end) for end in ends] + [constant(c) for c in simple_numbers(low, high)]
    at = next((t for t in known if t.overlaps(whole)), whole)
    value = curve.coefficients(at, 0)
    reason = f"at t = {float(at.mid()):.10g} ({curve.explain(whole)})"
    if all(row[0].is_finite() for row in value):
        return (
            f"The curve has no finite derivatives {reason}: reparametrise it, or take an interval without it."
        )
    return f"The curve is undefined or infinite {reason}: take an interval without it."
