"""The number of pieces that theory predicts: N(ε) = C ε^{−1/p}, C = ∫ (c·J)^{1/p} ds.

c·J·σᵖ is the error of one short arc of Euclidean length σ (Theorem 3.6.1): J = |k|κ^{5/3}, p = 4 for
parabolas (3.17) and J = |dk/dr|κ², p = 5 for conics (3.18); J = |dκ/ds|, p = 3 for biarcs.  c comes from
`leading`, for biarcs from `asymptotics.arc_laws`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

from flint import arb

from osculant.cas.balls import PRECISION, CurveBalls, precision
from osculant.cas.errors import UndecidedError
from osculant.cas.invariants import PlaneJet
from osculant.cas.leading import error_constant

#: steps of the quadrature are 2^−COARSEST … 2^−FINEST; then the interval is halved, DEPTH times at most
COARSEST, FINEST, DEPTH = 2, 6, 24
#: two steps that agree to this end the quadrature; the error after the second is less by this factor
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


#: (3.17), (3.18), and biarcs
LAWS = {
    "parabola": Law(4, _parabola),
    "conic": Law(5, lambda jet: abs(jet.affine_curvature_slope) * jet.curvature * jet.curvature),
    "biarc": Law(3, lambda jet: abs(jet.curvature_slope)),
}


def law_constant(primitive: str) -> Any:
    """c of a primitive's law: a ball at the current precision.

    >>> round(1 / float(law_constant("biarc")), 9)
    324.0
    """
    if primitive != "biarc":
        return error_constant(primitive)
    from osculant.cas.asymptotics.arc_laws import arc_law  # which integrates by this module

    constant = arc_law("biarc").constant
    return arb(int(constant.p)) / int(constant.q)


def complexity_constant(curve: CurveBalls, primitive: str, low: Any, high: Any) -> tuple[Any, float]:
    """(C, estimated error) over one stretch [low, high] between special points, to about 20 digits.

    Double exponential quadrature in 320-bit balls: algebraic singularities at the ends (inflections,
    cusps, sextactic points) do no harm.  Raises UndecidedError if the finest step does not settle it.

    >>> from osculant.cas.formula import parse_tuple
    >>> spiral = CurveBalls(parse_tuple("t*cos(t), t*sin(t)"))
    >>> with precision(PRECISION):
    ...     low, high = arb.pi() / 6, 2 * arb.pi()
    >>> round(float(complexity_constant(spiral, "conic", low, high)[0]), 12)
    1.269590117037
    """
    law = LAWS[primitive]
    with precision(PRECISION):
        constant = law_constant(primitive)

        def density(t: Any) -> Any:
            return law.density(curve.jet(t, law.order), constant).mid()

        return integral(density, low, high)


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

    >>> with precision(PRECISION):
    ...     value, change = double_exponential(lambda t: t.sqrt(), arb(0), arb(1))
    >>> abs(float(value) - 2 / 3) < 1e-15, change < 1e-10
    (True, True)
    """
    total, value, change, size = arb(0), arb(0), float("inf"), high - low
    for level in range(COARSEST, FINEST + 1):
        for near, weight in nodes(level):
            total += weight * density(low + size * near)
            if near < 0.5:
                total += weight * density(high - size * near)
        previous, value = value, total * size * arb(2) ** -level
        change = abs(float(value - previous))
        if level > COARSEST and change <= AGREEMENT * abs(float(value)):
            break
    return value, change


@cache
def nodes(level: int) -> tuple[tuple[Any, Any], ...]:
    """(distance from the nearer end of [0, 1], weight) of the nodes that are new at step 2^−level.

    >>> len(nodes(2)) > 10
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
