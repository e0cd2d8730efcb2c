"""The number of pieces that theory predicts, from the error c·J·σᵖ of one short arc of Euclidean length σ.

Hausdorff distance (Theorem 3.6.1): all pieces have the error ε, and N(ε) = C ε^{−1/p} with the content
C = S = ∫ (c·J)^{1/p} ds.

Area (Theorem 3.6.4): the displacement is integrated along the arc, so J is the same and p is one more.
The errors add, least if all pieces have the same, ε/N; N = S (ε/N)^{−1/p} gives N(ε) = C ε^{−1/(p−1)} with
C = S^{p/(p−1)} (3.25), (3.26).

The laws are those of `osculant.cas.laws.table`.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

from flint import arb

from osculant.cas.laws.law import Law
from osculant.cas.laws.table import law_of
from osculant.cas.numbers.balls import PRECISION, FormulaBalls, precision
from osculant.cas.numbers.quadrature import integral

#: samples that tell the branches of a law apart, and halvings that find where one ends
BRANCH_SAMPLES, BRANCH_HALVINGS = 129, 100


def complexity_constant(
    curve: FormulaBalls[Any], primitive: str, low: Any, high: Any, metric: str = "hausdorff"
) -> tuple[Any, float]:
    """(C, estimated error) over one stretch [low, high] between special points, to about 20 digits.

    Args:
        curve: in ball arithmetic.
        primitive: a name of `osculant.cas.laws.table`.
        low: first end, a ball.
        high: last end.
        metric: "hausdorff" or "area".

    Double exponential quadrature in 320-bit balls: algebraic singularities at the ends (inflections,
    cusps, sextactic points) do no harm.  Raises UndecidedError if the finest step does not settle it, and
    DomainError for a primitive or a metric without a law.

    >>> from flint import arb
    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> from osculant.cas.jets.balls import CurveBalls, SpaceBalls
    >>> spiral = CurveBalls(parse_tuple("t*cos(t), t*sin(t)"))
    >>> cone = SpaceBalls(parse_tuple("t*cos(t), t*sin(t), t"))
    >>> with precision(PRECISION):
    ...     low, high = arb.pi() / 6, 2 * arb.pi()
    >>> round(float(complexity_constant(spiral, "conic", low, high)[0]), 12)
    1.269590117037
    >>> round(float(complexity_constant(spiral, "conic", low, high, "area")[0]), 12)
    2.03777820081
    >>> round(float(complexity_constant(cone, "bihelix", low, high)[0]), 6)
    0.851459
    """
    return law_integral(curve, law_of(primitive, metric), low, high)


def law_integral(curve: FormulaBalls[Any], law: Law, low: Any, high: Any) -> tuple[Any, float]:
    """The same for any law; where its J is the least of several values, from one kink or jump to the next."""
    with precision(PRECISION):
        c = law.ball()
        content, error = arb(0), 0.0
        for part in pairwise([low, *_breaks(curve, law, low, high), high]):
            value, change = integral(lambda t: law.density(curve.jet(t, law.jet), c).mid(), *part)
            content, error = content + value, error + change
        if law.spline_order == law.order or content == 0:
            return content, error
        whole = (content**law.order).root(law.spline_order)
        return whole, error * float(whole / content) * law.order / law.spline_order


def _breaks(curve: FormulaBalls[Any], law: Law, low: Any, high: Any) -> Iterator[Any]:
    """Where the branch of a law changes between two parameters, as far as `BRANCH_SAMPLES` samples see it."""
    label = law.branch
    if label is None:
        return
    places = [(low + (high - low) * (2 * i + 1) / (2 * BRANCH_SAMPLES)).mid() for i in range(BRANCH_SAMPLES)]
    labels = [label(curve.jet(t, law.jet)) for t in places]
    for (a, before), (b, after) in pairwise(zip(places, labels)):
        if before == after:
            continue
        for _ in range(BRANCH_HALVINGS):
            middle = ((a + b) / 2).mid()
            a, b = (middle, b) if label(curve.jet(middle, law.jet)) == before else (a, middle)
        yield b
