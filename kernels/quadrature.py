"""Contents in doubles, ∫ of a density over jets of order 5: tanh-sinh quadrature, or Gauss on a grid.

`cas.laws.complexity` has the same integral to any number of digits; this is for the prediction beside a
spline, where nine digits and a few thousand samples of machine code do, and for knots to start from.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from osculant.kernels.curves.jets import call_jet
from osculant.kernels.gauss import NODES, SIZES, WEIGHTS
from osculant.kernels.jit import kernel
from osculant.kernels.operations import operation

#: steps of the quadrature are 2^−COARSEST … 2^−FINEST; then the interval is halved, DEPTH times at most
COARSEST, FINEST, DEPTH = 2, 5, 30
#: intervals looked at in all
MOST = 2000
#: two steps that agree to this are good to about its square
AGREEMENT = 1e-6
#: doubles of a jet of order 6 in the plane at most, or of order 3 in space
JET_SIZE = 14
#: parts of the whole that are taken as they are, if the result need not be good
MINOR = 3e-5
#: the argument of sinh at which the nodes' distances from the ends are below a double's resolution
FARTHEST = 3.6


@operation
def density(fit: Any, address: Any, scale: Any, jet: Any, t: Any) -> Any:
    """Pieces per unit of the parameter at t, times ε^{1/order}: the density of the fit's law.

    ``address`` is a compiled jet, of order 5 in the plane and 3 in space, of the curve times ``scale``; 0
    where rounding leaves no number.
    """


@operation
def content(fit: Any, address: Any, scale: Any, jet: Any, a: Any, b: Any, singular: Any) -> Any:
    """∫ density over a panel, at whose ends the law may be ``singular``."""
    if singular:
        return tanh_sinh(fit, address, scale, jet, a, b)[0]
    value = 0.0
    for i in range(SIZES[0]):
        t = a + (b - a) * NODES[0, i]
        value += (b - a) * WEIGHTS[0, i] * density(fit, address, scale, jet, t)
    return value


def by_law(law: Callable[..., float]) -> Callable[..., float]:
    """The `density` of a law in the plane: a kernel of the derivatives 1…5 of both coordinates."""

    def density(fit: Any, address: int, scale: float, jet: np.ndarray[Any, Any], t: float) -> float:
        call_jet(address, t, jet)
        jet *= scale
        value = law(jet[1], jet[2], jet[3], jet[4], jet[5], jet[7], jet[8], jet[9], jet[10], jet[11])
        return value if math.isfinite(value) else 0.0

    return density


@kernel
def tanh_sinh(
    fit: Any, address: int, scale: float, jet: np.ndarray[Any, Any], a: float, b: float
) -> tuple[float, float]:
    """(integral, its change at the last halving of the step) over [a, b]."""
    size = b - a
    total, value, change = 0.0, 0.0, math.inf
    for level in range(COARSEST, FINEST + 1):
        step = 0.5**level
        index = 0 if level == COARSEST else 1
        while index * step < FARTHEST:
            u = index * step
            near = 1.0 / (1.0 + math.exp(math.pi * math.sinh(u)))
            weight = math.pi * math.cosh(u) * near * (1.0 - near)
            total += weight * density(fit, address, scale, jet, a + size * near)
            if index > 0:
                total += weight * density(fit, address, scale, jet, b - size * near)
            index += 1 if level == COARSEST else 2
        previous, value = value, total * size * step
        change = abs(value - previous)
        if level > COARSEST and change <= AGREEMENT * abs(value):
            break
    return value, change


@kernel
def predicted(fit: Any, address: int, scale: float, a: float, b: float) -> float:
    """S = ∫ density over [a, b], of the curve times ``scale``, to about nine digits; NaN if unsettled.

    ``address`` is a compiled jet as `density` needs it.  Singularities at the ends do no harm; where one is
    near, the interval is halved.
    """
    return summed(fit, address, scale, a, b, 0.0)


@kernel
def predicted_roughly(fit: Any, address: int, scale: float, a: float, b: float) -> float:
    """The same where rounding beside a singular end keeps `predicted` from settling: to about four digits."""
    jet = np.empty(JET_SIZE)
    whole = tanh_sinh(fit, address, scale, jet, a, b)[0]
    return summed(fit, address, scale, a, b, MINOR * whole)


@kernel
def summed(fit: Any, address: int, scale: float, a: float, b: float, minor: float) -> float:
    """∫ density over [a, b] in parts; those that are less than ``minor`` are taken as they are."""
    jet = np.empty(JET_SIZE)
    stack = np.empty((DEPTH + 2, 2))
    stack[0, 0], stack[0, 1] = a, b
    open_parts, total = 1, 0.0
    for _ in range(MOST):
        if open_parts == 0:
            return total
        low, high = stack[open_parts - 1, 0], stack[open_parts - 1, 1]
        open_parts -= 1
        value, change = tanh_sinh(fit, address, scale, jet, low, high)
        if change <= AGREEMENT * max(value, total) or open_parts > DEPTH or max(value, change) < minor:
            total += value
        else:
            middle = 0.5 * (low + high)
            stack[open_parts, 0], stack[open_parts, 1] = middle, high
            stack[open_parts + 1, 0], stack[open_parts + 1, 1] = low, middle
            open_parts += 2
    return math.nan


@kernel
def contents(
    fit: Any, address: int, scale: float, times: np.ndarray[Any, Any], out: np.ndarray[Any, Any]
) -> None:
    """∫ density from ``times[0]`` to every one of the increasing ``times`` (m,), into ``out`` (m,).

    Of the curve times ``scale``; out[m−1]·ε^{−1/p} pieces have the error ε each, on the curve scaled, and
    equal steps of the content give equal errors, to leading order.  For knots to start from: as accurate as
    the grid is fine.  Singularities at both ends do no harm.
    """
    jet = np.empty(JET_SIZE)
    last = times.shape[0] - 1
    out[0] = 0.0
    for j in range(1, last + 1):
        singular = j == 1 or j == last
        out[j] = out[j - 1] + content(fit, address, scale, jet, times[j - 1], times[j], singular)
