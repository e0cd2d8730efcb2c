"""Canonical forms of a plane curve to any order: the curve in its own frame, and as a graph over its tangent.

Both frames move by e₁′ = a·e₂, e₂′ = −b·e₁ along the curve γ′ = e₁, with different parameters:

* Euclidean: (e₁, e₂) = (T, N), a = b = κ, by arc length s                                  (2.6);
* affine: (e₁, e₂) = (t, n), a = 1, b = k, by affine arc length r                           (2.7).

So the coordinates of e₁ in the frame at 0 solve a linear differential equation, one coefficient after the
other, and those of γ are their integrals. Reverting the first coordinate gives the graph (Lemma 2.2.2).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from math import factorial
from typing import Any

from flint import Ordering, fmpq_mpoly_ctx

from osculant.cas.errors import DomainError
from osculant.cas.numbers.power_series import PowerSeries, ratio

#: the highest orders computed, with generators for the curvatures and with curvatures given: beyond, the
#: polynomials and then the number of products take too long
GENERIC, GIVEN = 20, 60


def euclidean_arc(
    order: int, curvatures: Sequence[Any] | None = None
) -> tuple[PowerSeries, PowerSeries, tuple[Any, ...]]:
    """A curve by Euclidean arc length s in its Frenet frame at s = 0: γ(s) = γ(0) + X(s)T₀ + Y(s)N₀.

    Args:
        order: the highest power of s wanted, at least 1; X and Y then have ``order + 1`` coefficients.
        curvatures: κ and its derivatives by s at s = 0 (not divided by factorials), as elements of any ring
            `PowerSeries` allows; order − 1 of them are needed, more are ignored. Without them the result
            has polynomial coefficients in new generators kappa0, kappa1, … (flint's ``fmpq_mpoly``).

    Returns: (X, Y, (κ₀, κ₁, …)), the last being the ``curvatures`` or the generators.

    Raises DomainError for an order that is no integer, below 1, above `GIVEN` (or `GENERIC`, without
    curvatures), or one that the curvatures given do not carry.

    >>> X, Y, (k0, k1, *_) = euclidean_arc(4)
    >>> X
    PowerSeries([0, 1, 0, -1/6*kappa0^2, -1/8*kappa0*kappa1])
    >>> Y[3] == k1 / 6
    True
    """
    kappa = _jet(order, order - 1, curvatures, "kappa", "κ")
    turning = series_of_derivatives(kappa[: max(1, order - 1)])
    X, Y = _arc(turning, turning, order)
    return X, Y, kappa


def affine_arc(
    order: int, curvatures: Sequence[Any] | None = None
) -> tuple[PowerSeries, PowerSeries, tuple[Any, ...]]:
    """A curve by affine arc length r in its affine frame at r = 0: γ(r) = γ(0) + X(r)t₀ + Y(r)n₀.

    Args and returns are those of `euclidean_arc`, with the affine curvature k and its derivatives by r, of
    which order − 2 are needed; the generators are called k0, k1, …

    Raises DomainError for an order that is no integer, below 1, above `GIVEN` (or `GENERIC`, without
    curvatures), or one that the curvatures given do not carry.

    >>> X, Y, _ = affine_arc(5)
    >>> X
    PowerSeries([0, 1, 0, -1/6*k0, -1/24*k1, 1/120*k0^2 - 1/120*k2])
    >>> Y
    PowerSeries([0, 0, 1/2, 0, -1/24*k0, -1/60*k1])
    """
    k = _jet(order, order - 2, curvatures, "k", "k")
    zero = k[0] * 0
    bending = series_of_derivatives(k[: max(1, order - 2)])
    X, Y = _arc(PowerSeries([zero + 1, *(zero,) * (order - 1)]), bending, order)
    return X, Y, k


def graph(along: PowerSeries, across: PowerSeries) -> PowerSeries:
    """The second coordinate as a series in the first, for a curve through the origin.

    Raises DomainError unless ``along`` begins with c₁x, c₁ having a reciprocal in the ring.

    >>> graph(PowerSeries([0, 2, 0]), PowerSeries([0, 0, 1]))
    PowerSeries([0, 0, 1/4])
    """
    return across.at(along.reversion())


def affine_graph(order: int, curvatures: Sequence[Any] | None = None) -> tuple[PowerSeries, tuple[Any, ...]]:
    """The affine canonical form (Lemma 2.2.2): y(x) where the curve is γ(0) + x·t₀ + y(x)·n₀.

    Arguments and errors are those of `affine_arc`, but order − 3 curvatures are enough: the highest
    coefficient of X, which has one more, does not matter to y. Returns (y, (k₀, k₁, …)).

    >>> affine_graph(6)[0]
    PowerSeries([0, 0, 1/2, 0, 1/8*k0, 1/40*k1, 1/16*k0^2 + 1/240*k2])
    """
    k = _jet(order, order - 3, curvatures, "k", "k")
    X, Y, _ = affine_arc(order, [*k, k[0] * 0])
    return graph(X, Y), k


def series_of_derivatives(derivatives: Sequence[Any]) -> PowerSeries:
    """Taylor's series of a function from its derivatives at 0, not divided by factorials.

    >>> series_of_derivatives([1, 2, 6, 24])
    PowerSeries([1, 2, 3, 4])
    """
    return PowerSeries([d * ratio(1, factorial(i), d) for i, d in enumerate(derivatives)])


def moving_frame(
    a: PowerSeries, b: PowerSeries, length: int
) -> tuple[tuple[PowerSeries, PowerSeries], tuple[PowerSeries, PowerSeries]]:
    """The frame with e₁′ = a·e₂ and e₂′ = −b·e₁, in coordinates of the frame at 0.

    Args:
        a: a series with at least ``length − 1`` coefficients.
        b: another over the same ring.
        length: number of coefficients wanted, at least 1.

    Returns ((e₁₁, e₁₂), (e₂₁, e₂₂)): the coordinates of e₁, then those of e₂.

    Raises DomainError if a or b are too short.

    >>> one = PowerSeries([1, 0, 0])
    >>> moving_frame(one, one, 4)[0]  # cosine and sine
    (PowerSeries([1, 0, -1/2, 0]), PowerSeries([0, 1, 0, -1/6]))
    """
    zero = a[0] * 0
    columns = []
    for start in ((zero + 1, zero), (zero, zero + 1)):  # the two coordinates do not mix
        first, second = [start[0]], [start[1]]
        for n in range(length - 1):
            rate = sum((a[i] * second[n - i] for i in range(n + 1)), zero)
            back = sum((b[i] * first[n - i] for i in range(n + 1)), zero)
            first.append(rate * ratio(1, n + 1, rate))
            second.append(back * ratio(-1, n + 1, back))
        columns.append((PowerSeries(first), PowerSeries(second)))
    (e11, e21), (e12, e22) = columns
    return (e11, e12), (e21, e22)


def _arc(a: PowerSeries, b: PowerSeries, order: int) -> tuple[PowerSeries, PowerSeries]:
    # e₁ to order − 1 needs b to order − 3 only where a = 1, so b may be padded; b's missing terms are unused
    padding = [b[0] * 0] * (order - 1 - b.length)
    tangent, _ = moving_frame(a, PowerSeries([*b.coefficients, *padding]), order)
    return tangent[0].integral(), tangent[1].integral()


def _jet(order: int, needed: int, given: Sequence[Any] | None, name: str, symbol: str) -> tuple[Any, ...]:
    if not isinstance(order, int):
        raise DomainError(f"The order of a canonical form is a whole number, not {order!r}.")
    if order < 1:
        raise DomainError(f"A canonical form of order {order} says nothing: ask for order 1 or more.")
    if order > GIVEN or (given is None and order > GENERIC):
        raise DomainError(
            f"A canonical form of order {order} takes too long: the highest is {GENERIC}, or {GIVEN} if the "
            "curvatures are given."
        )
    needed = max(needed, 1)
    if given is None:
        return _generators(name, needed)
    if len(given) < needed:
        raise DomainError(
            f"The canonical form of order {order} needs {symbol} and its derivatives up to order "
            f"{needed - 1}, but only {len(given)} values are given: give {needed} or lower the order."
        )
    return tuple(given)


@cache
def _generators(name: str, count: int) -> tuple[Any, ...]:
    ring = fmpq_mpoly_ctx.get([f"{name}{i}" for i in range(count)], Ordering.degrevlex)
    return tuple(ring.gens())
