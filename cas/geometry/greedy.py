"""Greedy splines to many digits, straight from the geometry: knots of arcs whose error is ε.

No series enters: an arc is the solution of d = ±ε and d′ = 0 at its peaks, with d the displacement along the
normal to a bitangent conic (`osculant.cas.geometry.bitangent`). So the counts are an independent check of
the leading constants and of `osculant.cas.laws.next_term`. Short arcs only: one peak (parabola), or
one in each half (conic).
"""

from __future__ import annotations

from typing import Any

import mpmath
import sympy as sp

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.cas.geometry.pencil import lobes

#: a guess of an arc's length is improved so often before Newton's method
REFINEMENTS = 4


def greedy_knots(
    curve: ReferenceCurve, primitive: str, low: Any, tolerance: Any, length: Any, count: int
) -> list[Any]:
    """The parameter values t₀ = low < t₁ < … of ``count`` arcs with Hausdorff distance ``tolerance`` each.

    Args:
        curve: regular, with κ ≠ 0 inside, and k (parabola) or dk/dr (conic) not 0 inside the arcs.
        primitive: "parabola" or "conic" (the conic that minimises the distance).
        low: where the spline begins.
        tolerance: the Hausdorff distance of each arc.
        length: a rough guess of t₁ − t₀; for it all arcs in question must exist.
        count: the number of arcs.

    At the current precision of mpmath. Raises DomainError for an unknown primitive and UndecidedError if
    Newton's method does not find an arc.

    >>> spiral = ReferenceCurve("t*cos(t), t*sin(t)")
    >>> knots = greedy_knots(spiral, "parabola", mpmath.pi / 6, mpmath.mpf("1e-4"), mpmath.mpf("0.25"), 2)
    >>> [mpmath.nstr(t, 8) for t in knots]
    ['0.52359878', '0.74101729', '0.96339622']
    """
    if primitive not in {"parabola", "conic"}:
        raise DomainError(f"Greedy splines are made of 'parabola' or 'conic' arcs, not of {primitive!r}.")
    knots, length = [mpmath.mpf(low)], mpmath.mpf(length)
    for _ in range(count):
        try:
            length = _next_length(curve, primitive, knots[-1], mpmath.mpf(tolerance), length)
        except (ValueError, ZeroDivisionError, DomainError, UndecidedError) as error:
            raise UndecidedError(
                f"No {primitive} arc of error {mpmath.nstr(tolerance, 5)} was found from "
                f"t = {mpmath.nstr(knots[-1], 10)}: take a smaller tolerance."
            ) from error
        knots.append(knots[-1] + length)
    return knots


def _next_length(curve: ReferenceCurve, primitive: str, a: Any, tolerance: Any, guess: Any) -> Any:
    shape = lobes(0 if primitive == "parabola" else 1)
    names = ("first",) if primitive == "parabola" else ("first", "last")
    places = [mpmath.mpf(sp.N(shape[name], mpmath.mp.dps)) for name in names]
    for _ in range(REFINEMENTS + 1):
        pencil = BitangentPencil(curve, a, a + guess)
        q = pencil.parabola if primitive == "parabola" else pencil.through(a + guess / 2)
        d = pencil.displacement(a + places[0] * guess, q).d
        # the error is like the length to the power 4 or 5, and like one more at an end where it vanishes
        guess *= mpmath.root(tolerance / abs(d), 5)
    sign = mpmath.sign(d)

    def equations(length: Any, *rest: Any) -> list[Any]:
        arc = BitangentPencil(curve, a, a + length)
        q, peaks = (arc.parabola, rest) if primitive == "parabola" else (rest[0], rest[1:])
        found, wanted = [], sign
        for peak in peaks:  # the peaks are in parts of the arc; their heights alternate
            foot = arc.displacement(a + peak * length, q)
            found += [foot.d / tolerance - wanted, foot.along / foot.across * arc.chord / tolerance]
            wanted = -wanted
        return found

    start = [guess, *places] if primitive == "parabola" else [guess, q, *places]
    return mpmath.findroot(equations, start, maxsteps=40)[0]
