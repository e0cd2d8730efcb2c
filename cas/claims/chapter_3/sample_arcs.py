"""Arcs on which hypotheses are tried: zeros that are counted, and how errors grow."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import sympy as sp
from flint import arb
from mpmath import mp

from osculant.cas.claims.claim import Evidence
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.numbers.balls import ball, precision

#: ends tried; parts of an interval on which balls decide a sign, each halved this often where they do not
ENDS, PARTS, DEPTH = 7, 16, 8


def zeros_inside(expression: Any, x: Any, low: Any, high: Any) -> int:
    """The zeros of a rational function in an interval, with multiplicity, counted exactly.

    >>> t = sp.Symbol("t")
    >>> zeros_inside(t**2 * (t - 3) / (t + 4), t, -1, 1)
    2
    """
    numerator = sp.Poly(sp.numer(sp.together(expression)), x)
    return sum(m * factor.count_roots(low, high) for factor, m in numerator.sqf_list()[1])


def monotone_curvature(graph: Any, x: Any, low: Any, high: Any) -> bool:
    """Whether dk/dr has no zero on a graph y(x) with rational y, and y″ none: decided exactly.

    >>> t = sp.Symbol("t")
    >>> monotone_curvature(t**2 + t**5, t, 0, 1), monotone_curvature(t**2 + t**4, t, -1, 1)
    (False, False)
    """
    second = sp.diff(graph, x, 2)
    # k = −½(y″^(−2/3))″ by R3.3-10, so dk/dr has the sign of −(y″^(−2/3))‴ = y″^(−11/3)·factor
    power, factor = sp.Rational(-2, 3), sp.S.One
    for _ in range(3):
        factor = sp.together(power * sp.diff(second, x) * factor + second * sp.diff(factor, x))
        power -= 1
    return zeros_inside(second, x, low, high) == 0 and zeros_inside(factor, x, low, high) == 0


def growth(text: str, low: str, high: str, form: str, member: Any) -> Evidence:
    """Whether the error of the chosen member grows with the arc's end, and the form has no zero on the arc.

    Args:
        text: the curve.
        low: the fixed end, as text.
        high: the last end tried, as text.
        form: the attribute of `PlaneJet` that must not vanish.
        member: the Q chosen from a pencil.

    >>> growth("t, exp(t)", "0", "1", "parabolic_form", lambda pencil: pencil.parabola).holds
    True
    """
    certain = has_no_zero(text, low, high, form)
    curve = ReferenceCurve(text)
    with mp.workdps(20):
        a, b = mp.mpf(low), mp.mpf(high)
        pencils = [BitangentPencil(curve, a, a + (b - a) * i / ENDS) for i in range(2, ENDS + 1)]
        errors = [pencil.hausdorff(member(pencil)) for pencil in pencils]
    grows = all(one < two for one, two in pairwise(errors))
    line = (
        f"{text} from t = {low} to {ENDS - 1} ends up to {high}: error from {mp.nstr(errors[0], 6)} to "
        f"{mp.nstr(errors[-1], 6)}, {'increasing' if grows else 'not increasing'}"
    )
    return Evidence(certain and grows, (line,))


def has_no_zero(text: str, low: str, high: str, form: str) -> bool:
    """Whether a form of the jets certainly has no zero on an interval: balls on parts of it.

    >>> has_no_zero("t, exp(t)", "-1", "1", "sextactic_form")
    True
    >>> has_no_zero("t, t^2", "-1", "1", "parabolic_form")
    False
    """
    curve = CurveBalls(parse_tuple(text))
    with precision(64):
        step = (arb(high) - arb(low)) / PARTS
        parts = [(arb(low) + step * i, arb(low) + step * (i + 1), 0) for i in range(PARTS)]
        while parts:
            a, b, depth = parts.pop()
            if not getattr(curve.jet(ball(a, b), 5), form).contains(0):
                continue
            if depth == DEPTH:
                return False
            parts += [(a, (a + b) / 2, depth + 1), ((a + b) / 2, b, depth + 1)]
    return True
