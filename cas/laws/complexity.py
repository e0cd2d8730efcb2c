"""The number of pieces that theory predicts, from the error c·J·σᵖ of one short arc of Euclidean length σ.

Hausdorff distance (Theorem 3.6.1): J = |k|κ^{5/3}, p = 4 for parabolas (3.17) and J = |dk/dr|κ², p = 5 for
conics (3.18); J = |dκ/ds|, p = 3 for biarcs.  All pieces have the error ε, and N(ε) = C ε^{−1/p} with the
content C = S = ∫ (c·J)^{1/p} ds.

Area (Theorem 3.6.4): the displacement is integrated along the arc, so J is the same and p is one more.
The errors add, least if all pieces have the same, ε/N; N = S (ε/N)^{−1/p} gives N(ε) = C ε^{−1/(p−1)} with
C = S^{p/(p−1)} (3.25), (3.26).

c comes from `leading`, for biarcs from `asymptotics.arc_laws`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from flint import arb

from osculant.cas.errors import UndecidedError
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.laws.leading import error_constant
from osculant.cas.numbers.balls import PRECISION, CurveBalls, precision

#: steps of the quadrature are 2^−COARSEST … 2^−FINEST; then the interval is halved, DEPTH times at most
COARSEST, FINEST, DEPTH = 1, 6, 24
#: steps that agree to this end the quadrature; the error after the last is less by this factor
AGREEMENT = 1e-10
#: nodes nearer to an end than this part of the interval are left out: at the worst end singularity,
#: t^(−2/5), they weigh less than 1e-18
NEAREST = 1e-32


@dataclass(frozen=True)
class Law:
    """How the error of one short arc depends on it: c·``invariant``·σ^``order``, for jets of any numbers."""

    order: int
    invariant: Callable[[PlaneJet], Any]

    def density(self, jet: PlaneJet, constant: Any) -> Any:
        """(c·J)^{1/p} |α̇| at a jet of balls."""
        value = constant * self.invariant(jet)
        return value.root(self.order) * jet.speed if value > 0 else arb(0) * jet.speed


def _parabola(jet: PlaneJet) -> Any:
    kappa = abs(jet.curvature)
    return abs(jet.affine_curvature) * kappa * jet.root(kappa * kappa, 3)


#: (3.17), (3.18), and biarcs: the laws of the Hausdorff distance
LAWS = {
    "parabola": Law(4, _parabola),
    "conic": Law(5, lambda jet: abs(jet.affine_curvature_slope) * jet.curvature * jet.curvature),
    "biarc": Law(3, lambda jet: abs(jet.curvature_slope)),
}


def law_of(primitive: str, metric: str = "hausdorff") -> Law:
    """The law of a primitive in a metric; in "area" the same invariant with one order more.

    >>> law_of("conic").order, law_of("conic", "area").order
    (5, 6)
    """
    law = LAWS[primitive]
    return replace(law, order=law.order + 1) if metric == "area" else law


def law_constant(primitive: str, metric: str = "hausdorff") -> Any:
    """c of a primitive's law: a ball at the current precision.

    The same for the conics, and biarcs, of equal moons and of least area (Theorem 3.6.4, and
    `osculant.cas.laws.arcs`).

    >>> round(1 / float(law_constant("biarc")), 9), round(1 / float(law_constant("biarc", "area")), 9)
    (324.0, 576.0)
    """
    if primitive != "biarc":
        return error_constant(primitive, metric)
    from osculant.cas.laws.arcs import arc_law  # which integrates by this module

    constant = arc_law("biarc", metric).constant
    return arb(int(constant.p)) / int(constant.q)


def complexity_constant(
    curve: CurveBalls, primitive: str, low: Any, high: Any, metric: str = "hausdorff"
) -> tuple[Any, float]:
    """(C, estimated error) over one stretch [low, high] between special points, to about 20 digits.

    Double exponential quadrature in 320-bit balls: algebraic singularities at the ends (inflections,
    cusps, sextactic points) do no harm.  Raises UndecidedError if the finest step does not settle it.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> spiral = CurveBalls(parse_tuple("t*cos(t), t*sin(t)"))
    >>> with precision(PRECISION):
    ...     low, high = arb.pi() / 6, 2 * arb.pi()
    >>> round(float(complexity_constant(spiral, "conic", low, high)[0]), 12)
    1.269590117037
    >>> round(float(complexity_constant(spiral, "conic", low, high, "area")[0]), 12)
    2.03777820081
    """
    law = law_of(primitive, metric)
    with precision(PRECISION):
        constant = law_constant(primitive, metric)

        def density(t: Any) -> Any:
            return law.density(curve.jet(t, LAWS[primitive].order), constant).mid()

        content, error = integral(density, low, high)
        if metric != "area" or content == 0:
            return content, error
        whole = (content**law.order).root(law.order - 1)
        return whole, error * float(whole / content) * law.order / (law.order - 1)


def integral(density: Callable[[Any], Any], low: Any, high: Any) -> tuple[Any, float]:
    """(∫ density, estimated error) over [low, high]: double exponential, halved where it does not settle.

    At flint's current precision, which should be `PRECISION`. Raises UndecidedError, naming the place, if the
    finest step of the smallest interval does not settle it: the integral may diverge there.

    >>> with precision(PRECISION):
    ...     value, error = integral(lambda t: 1 / t.sqrt(), arb(0), arb(4))
    >>> round(float(value), 12), error < 1e-15
    (4.0, True)
    """
    total, error, parts = arb(0), 0.0, [(low, high, 0)]
    while parts:
        a, b, depth = parts.pop()
        value, change = double_exponential(density, a, b)
        if change <= AGREEMENT * max(abs(float(value)), abs(float(total))):
            total, error = total + value, error + change * AGREEMENT
        elif depth == DEPTH:
            raise UndecidedError(
                f"The complexity integral did not settle near t = {float(a):.10g}: split there."
            )
        else:  # a singularity beside the real line: it is relatively farther from each half
            middle = (a + b) / 2
            parts += [(middle, b, depth + 1), (a, middle, depth + 1)]
    return total, error


def double_exponential(density: Callable[[Any], Any], low: Any, high: Any) -> tuple[Any, float]:
    """(∫ density, change at the last halving of the step) over [low, high] by tanh-sinh quadrature.

    Every halving squares the relative error, so the change should be about the square of the one before. The
    larger of both is returned: two steps may agree by chance.

    >>> with precision(PRECISION):
    ...     value, change = double_exponential(lambda t: t.sqrt(), arb(0), arb(1))
    >>> abs(float(value) - 2 / 3) < 1e-15, change < 1e-10
    (True, True)
    """
    total, value, size = arb(0), arb(0), high - low
    latest = change = float("inf")
    for level in range(COARSEST, FINEST + 1):
        for near, weight in nodes(level):
            total += weight * density(low + size * near)
            if near < 0.5:
                total += weight * density(high - size * near)
        previous, value, before = value, total * size * arb(2) ** -level, latest
        latest, height = abs(float(value - previous)), abs(float(value))
        change = max(latest, before * (before / height) if height else before)
        if change <= AGREEMENT * height:
            break
    return value, change


@cache
def nodes(level: int) -> tuple[tuple[Any, Any], ...]:
    """(distance from the nearer end of [0, 1], weight) of the nodes that are new at step 2^−level.

    >>> len(nodes(3)) > 10
    True
    """
    with precision(PRECISION):
        step, pi = arb(2) ** -level, arb.pi()
        found: list[tuple[Any, Any]] = []
        index = 0
        while True:
            if level == COARSEST or index % 2:
                u = step * index
                near = 1 / (1 + (pi * u.sinh()).exp())
                if near < NEAREST:
                    return tuple(found)
                found.append((near, pi * u.cosh() * near * (1 - near)))
            index += 1
