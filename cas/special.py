"""Special points of a plane curve: where theory wants a spline to be split.

* cusps and other singular points, α̇ = 0;
* inflections, κ = 0;
* for parabolas k = 0, for conics dk/dr = 0 (sextactic points).

Simple zeros are isolated in ball arithmetic.  Multiple zeros (all cusps are) are decided exactly where they
lie at a simple rational, at a simple multiple of pi, or at an end of the interval; the rest is called
undecided.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from flint import arb

from osculant.cas.balls import PRECISION, CurveBalls, Form, ball, constant, padded, precision
from osculant.cas.errors import DomainError
from osculant.cas.exact import order_of_zero, simple_numbers
from osculant.cas.expression import Node
from osculant.cas.isolate import (
    SMALLEST,
    Box,
    Isolation,
    differentiated,
    first_infinite,
    isolate,
    refine,
    taylor_form,
)

#: form over jets and the order of the jet it needs
FORMS: Mapping[str, tuple[Form, int]] = {
    "cusp": (lambda jet: jet.speed_squared, 1),
    "inflection": (lambda jet: jet.inflection_form, 2),
    "parabolic": (lambda jet: jet.parabolic_form, 4),
    "sextactic": (lambda jet: jet.sextactic_form, 5),
}
#: what else vanishes at such a zero, and may sooner be seen not to
PARTS: Mapping[str, Form] = {"cusp": lambda jet: (jet.x[1], jet.y[1])}
#: terms of the Taylor forms
LENGTH = 14
#: Taylor coefficients looked at, in turn, for the multiplicity of a zero
MULTIPLE = (2, 10, 30, 90)
#: terms beyond the multiplicity that show a zero to be alone
BEYOND = 16
#: unresolved boxes that are nearer than this many widths are one place
NEAR = 256
#: two zeros nearer than this, in parts of the interval, are one knot
SAME = 2.0**-60
#: probes that may show that a form does not vanish identically
PROBES = ("0.38196601", "0.61803399", "0.14589803", "0.85410197", "0.5278640")


@dataclass(frozen=True)
class SpecialPoint:
    """A point where the curve is split.

    ``at`` is a ball around the parameter value; ``kinds`` are among cusp, inflection, parabolic and
    sextactic; ``decided`` is False where a zero could be neither proved nor excluded.
    """

    at: Any
    kinds: frozenset[str]
    decided: bool = True


def vanishes(curve: CurveBalls, name: str, low: Any, high: Any) -> bool:
    """Whether a form seems to vanish identically: its balls contain 0 at every probe, to 600 digits.

    False is a proof; True asks for a symbolic one.
    """
    form, order = FORMS[name]
    for bits in (PRECISION, 2048):
        with precision(bits):
            for probe in PROBES:
                t = arb((low + (high - low) * arb(probe)).mid())
                series = curve.form_series(form, t, order, 1)
                if series is None:
                    raise DomainError(undefined(curve, t, t, ()))
                if not series[0].contains(0):
                    return False
    return True


def require_finite(curve: CurveBalls, low: Node, high: Node) -> None:
    """Raises DomainError, naming the parameter value, unless the derivatives are finite on [low, high]."""
    with precision(PRECISION):
        infinite = first_infinite(_Evaluation(curve), tuple(FORMS), constant(low), constant(high))
        if infinite is not None:
            raise DomainError(undefined(curve, *infinite, (low, high)))


def special_points(curve: CurveBalls, low: Node, high: Node, names: Sequence[str]) -> list[SpecialPoint]:
    """The special points of the given kinds inside [low, high], in order, merged where they coincide.

    Points at the ends are reported too (their frames are limits).  The curve has to be finite there:
    see `require_finite`.

    >>> from osculant.cas.formula import parse_constant, parse_tuple
    >>> cubic = CurveBalls(parse_tuple("t, t^3"))
    >>> [point] = special_points(cubic, parse_constant("-1"), parse_constant("2"), ["cusp", "inflection"])
    >>> sorted(point.kinds), abs(point.at) < 1e-30
    (['inflection'], True)
    """
    with precision(PRECISION):
        a, b = constant(low), constant(high)
        evaluate = _Evaluation(curve)
        multiple = _MultipleZeros(curve, (low, high))
        found = isolate(evaluate, multiple, names, a, b)
        points = _simple(curve, found, a, b) + multiple.points
        known = [point.at for point in points]
        small = (b - a) * NEAR * arb(2) ** -SMALLEST
        for box in _joined(found.unresolved):
            whole = ball(box.low, box.high)
            if box.high - box.low < small:
                places = [next((at for at in known if at.overlaps(whole)), arb(whole.mid()))]
            else:  # the work limit left it over: then both its ends are knots
                places = [arb(box.low.mid()), arb(box.high.mid())]
            points += [SpecialPoint(at, frozenset(box.open), decided=False) for at in places]
        return _merged(points, b - a)


class _Evaluation:
    """Series of several forms over one ball, sharing the curve's own series."""

    def __init__(self, curve: CurveBalls) -> None:
        self.curve = curve

    def __call__(self, t: Any, names: Sequence[str]) -> dict[str, list[list[Any]]] | None:
        jet = self.curve.series_jet(t, max(FORMS[name][1] for name in names), LENGTH)
        if jet is None:
            return None
        found = {}
        for name in names:
            parts = PARTS[name](jet) if name in PARTS else ()
            found[name] = [padded(series, LENGTH) for series in (FORMS[name][0](jet), *parts)]
        return found


def _simple(curve: CurveBalls, found: Isolation, a: Any, b: Any) -> list[SpecialPoint]:
    points = []
    for name, brackets in found.brackets.items():
        form, order = FORMS[name]

        def value(t: Any, form: Form = form, order: int = order) -> Any:
            series = curve.form_series(form, t, order, 1)
            return arb.nan() if series is None else series[0]

        def slope(t: Any, form: Form = form, order: int = order) -> Any:
            series = curve.form_series(form, t, order, 2)
            if series is not None and not series[1].contains(0):
                return series[1]
            centre = arb(t.mid())  # a wide ball: the Taylor form that isolated the zero
            over = curve.form_series(form, t, order, LENGTH)
            at = curve.form_series(form, centre, order, LENGTH)
            if over is None or at is None:
                return arb.nan()
            return taylor_form(differentiated(at), differentiated(over), t - centre)

        for low, high in brackets:
            zero = refine(value, slope, low, high, PRECISION // 2)
            if zero is not None:
                points.append(SpecialPoint(zero, frozenset([name])))
    return points


def _joined(boxes: list[Box]) -> list[Box]:
    """Unresolved boxes as one where less than `NEAR` of their widths lies between them."""
    joined: list[Box] = []
    for box in sorted(boxes, key=lambda box: float(box.low.mid())):
        if joined and joined[-1].high + NEAR * (box.high - box.low) > box.low:
            last = joined.pop()
            box = Box(last.low, box.high, tuple(sorted({*last.open, *box.open})))
        joined.append(box)
    return joined


class _MultipleZeros:
    """Proves that a form has one zero, a multiple one, in a neighbourhood of a small interval.

    If at a simple number c the first m Taylor coefficients of the form vanish exactly and its m-th
    derivative has one sign on the neighbourhood, the form is (t − c)^m times something without zeros.
    """

    def __init__(self, curve: CurveBalls, ends: tuple[Node, Node]) -> None:
        self.curve = curve
        self.ends = [(end, constant(end)) for end in ends]
        # asked again at every width until the answer is yes
        self.multiplicity, self.order_of_zero = cache(self._multiplicity), cache(order_of_zero)
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
        form, order = FORMS[name]
        multiplicity = self.multiplicity(name, candidate)
        if multiplicity < 2:
            return False  # not a zero, or a simple one, which isolation finds by itself
        centre = arb(whole.mid())
        over = self.curve.form_series(form, whole, order, multiplicity + BEYOND)
        around = self.curve.form_series(form, centre, order, multiplicity + BEYOND)
        if over is None or around is None:
            return False
        for _ in range(multiplicity):
            around, over = differentiated(around), differentiated(over)
        if taylor_form(around, over, whole - centre).contains(0):
            return False
        return self.order_of_zero(self.curve.coordinates, form, order, candidate, multiplicity)

    def _multiplicity(self, name: str, candidate: Node) -> int:
        """How many Taylor coefficients at the candidate seem to vanish before one that does not."""
        form, order = FORMS[name]
        for length in MULTIPLE:
            series = self.curve.form_series(form, constant(candidate), order, length)
            for count, c in enumerate(series or [arb(1)]):
                if not c.contains(0):
                    return count
        return 0


def _merged(points: list[SpecialPoint], size: Any) -> list[SpecialPoint]:
    merged: list[SpecialPoint] = []
    for point in sorted(points, key=lambda point: float(point.at.mid())):
        if merged and not abs(point.at - merged[-1].at) > size * SAME:
            last = merged.pop()
            sharper = min(point, last, key=lambda p: float(p.at.rad()))
            point = SpecialPoint(sharper.at, last.kinds | point.kinds, last.decided and point.decided)
        merged.append(point)
    return merged


def undefined(curve: CurveBalls, low: Any, high: Any, ends: Sequence[Node]) -> str:
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
