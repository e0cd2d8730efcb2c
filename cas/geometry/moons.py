"""Areas between an arc and its bitangent conics: the equisymmetric conic and the one of least area (3.4).

The strip along the normals has the signed area ∫ d(1 − κd/2) ds; a conic that crosses the arc once cuts it
into two moons of opposite sign. mpmath's arithmetic at its current precision, as in
`osculant.cas.geometry.bitangent`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import pairwise
from typing import Any

from mpmath import mp

from osculant.cas.errors import UndecidedError
from osculant.cas.geometry.bitangent import BitangentPencil
from osculant.cas.numbers.roots import root_between

#: Gauss–Legendre nodes for every digit wanted: ample on arcs without singularities nearby
NODES_PER_DIGIT = 1.5
#: the crossing of the least-area conic is looked for farther from the ends than this part of the arc
NEAR_END = 32


@cache
def gauss(count: int, digits: int) -> tuple[tuple[Any, Any], ...]:
    """Nodes and weights of Gauss–Legendre quadrature on [0, 1].

    >>> [mp.nstr(x, 6) for x, _ in gauss(2, 15)]
    ['0.788675', '0.211325']
    """
    found = []
    with mp.workdps(digits + 5):
        for i in range(count):
            x = mp.cos(mp.pi * (4 * i + 3) / (4 * count + 2))
            step = mp.mpf(1)
            while abs(step) > mp.mpf(10) ** (-digits // 2 - 2):  # Newton: the next step is the square of it
                value, slope = _legendre(count, x)
                step = value / slope
                x -= step
            found.append(((1 + x) / 2, 1 / ((1 - x * x) * _legendre(count, x)[1] ** 2)))
    return tuple(found)


def _legendre(degree: int, x: Any) -> tuple[Any, Any]:
    """The Legendre polynomial and its derivative."""
    below, value = mp.mpf(1), x
    for n in range(2, degree + 1):
        below, value = value, ((2 * n - 1) * x * value - (n - 1) * below) / n
    return value, degree * (x * value - below) / (x * x - 1)


def integral(function: Callable[[Any], Any], low: Any, high: Any) -> Any:
    """∫ of a smooth function, to about the working precision.

    >>> mp.nstr(integral(mp.exp, 0, 1), 12)
    '1.71828182846'
    """
    nodes = gauss(int(NODES_PER_DIGIT * mp.dps) + 12, mp.dps)
    return (high - low) * mp.fsum(w * function(low + (high - low) * x) for x, w in nodes)


def signed_area(pencil: BitangentPencil, q: Any, low: Any = None, high: Any = None) -> Any:
    """∫ d(1 − κd/2) ds of the member Q over [low, high], by default the arc.

    >>> from osculant.cas.geometry.bitangent import ReferenceCurve
    >>> quarter = BitangentPencil(ReferenceCurve("cos(t), sin(t)"), 0, mp.pi / 2)
    >>> mp.nstr(signed_area(quarter, quarter.parabola), 6), mp.nstr(mp.pi / 4 - 1 + mp.mpf(1) / 6, 6)
    ('-0.0479352', '-0.0479352')
    """

    def strip(t: Any) -> Any:
        frame, d = pencil.frame(t), pencil.displacement(t, q).d
        return d * (1 - frame.curvature * d / 2) * frame.speed

    return integral(strip, pencil.a if low is None else low, pencil.b if high is None else high)


def area_slope(pencil: BitangentPencil, q: Any, low: Any = None, high: Any = None) -> Any:
    """d/dQ of `signed_area`, ∫ ∂d/∂Q (1 − κd) ds: the foot's ends do not move."""

    def strip(t: Any) -> Any:
        frame, at = pencil.frame(t), pencil.displacement(t, q)
        return at.by_q * (1 - frame.curvature * at.d) * frame.speed

    return integral(strip, pencil.a if low is None else low, pencil.b if high is None else high)


def moons(pencil: BitangentPencil, q: Any) -> list[Any]:
    """The areas of the regions between the arc and the member Q, in order, all positive."""
    ends = [pencil.a, *pencil.crossings(q), pencil.b]
    return [abs(signed_area(pencil, q, low, high)) for low, high in pairwise(ends)]


def equisymmetric(pencil: BitangentPencil) -> Any:
    """The Q whose two moons have the same area (Lemma 3.4.1): the signed area vanishes. Newton's method.

    Raises UndecidedError if it does not settle.
    """
    q, before = pencil.through((pencil.a + pencil.b) / 2), mp.inf
    for _ in range(60):
        step = signed_area(pencil, q) / area_slope(pencil, q)
        if step == 0 or (abs(step) >= before / 2 and abs(step) < q * mp.sqrt(mp.eps)):
            return q
        q, before = q - max(-q / 2, min(q / 2, step)), abs(step)
    raise UndecidedError("The equisymmetric conic did not settle: shorten the arc.")


def imbalance(pencil: BitangentPencil, t: Any) -> Any:
    """How the area grows with Q at the member through α(t), to a factor ±1: 0 where it is stationary.

    The moons have opposite signs, so d/dQ of their sum is the difference of the parts of `area_slope` on both
    sides of the crossing.
    """
    q = pencil.through(t)
    return area_slope(pencil, q, pencil.a, t) - area_slope(pencil, q, t, pencil.b)


def least_area(pencil: BitangentPencil) -> Any:
    """The crossing t of the member whose area from the arc is stationary: the least one, if it is unique."""
    margin = (pencil.b - pencil.a) / NEAR_END
    return root_between(lambda t: imbalance(pencil, t), pencil.a + margin, pencil.b - margin)
