"""What an end costs a spline where the integrand of the number of pieces vanishes: a constant.

Near an end where k (parabolas) or dk/dr (conics) has a simple zero, rescaling leaves one model for all curves
as ε → 0: to leading order the displacement of the arc [a, b] is that of Hermite interpolation,

    parabola  d(u) = (u−a)²(u−b)² f[a,a,b,b,u],         f = u⁵/5!,
    conic     d(u) = (u−a)²(u−b)² (f[a,a,b,b,u] − q),   f = u⁶/6!,  q minimax,

by the canonical form with k, or dk/dr, a multiple of u. The divided difference of a monomial is a complete
homogeneous polynomial of the nodes. The greedy spline of error 1 from u = 0 has knots uₙ, and

    correction = lim (n − ∫₀^{uₙ} ρ₀ du),   ρ₀ = e₀^{1/p}, e₀ the leading error, proportional to u.

The model has no scale but the arcs' own, so with X = ∫₀^{uₙ} ρ₀ du the rest is a series in odd powers of 1/X:
ρ₁, ρ₂, … of `osculant.cas.laws.next_term` integrate to multiples of 1/X, 1/X³, …, and extrapolation
removes them.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from itertools import combinations_with_replacement
from math import factorial, prod
from typing import Any

import mpmath
import sympy as sp

from osculant.cas.asymptotics.arc_displacement import peak_spread
from osculant.cas.errors import DomainError, UndecidedError

#: how often the approximation crosses the arc inside; with the contacts at both ends, twofold, that many
#: conditions make the order of the error
CROSSINGS = {"parabola": 0, "conic": 1}
#: the number of terms removed, the first arc count used, and the step between counts
TERMS, FIRST, STEP = 11, 6, 4


def model(primitive: str) -> tuple[Any, tuple[Any, Any, Any, Any]]:
    """d(x) of the model on the arc m ± e at u = m + ex, and its symbols (m, e, q, x); q stays for conics.

    >>> d, (m, e, q, x) = model("parabola")
    >>> sp.factor(d)
    e**4*(x - 1)**2*(x + 1)**2*(e*x + 5*m)/120
    """
    order = _order(primitive)
    m, e, q, x = sp.symbols("m e q x")
    nodes = (m - e, m - e, m + e, m + e, m + e * x)
    # f has the degree order + 1, and a divided difference at five nodes lowers the degree by four
    divided = sum(map(prod, combinations_with_replacement(nodes, order + 1 - 4)))
    bracket = divided / factorial(order + 1)
    if primitive == "conic":
        # the parts that do not depend on x belong to q
        bracket = sp.expand(bracket) - sp.expand(bracket).coeff(x, 0) - q
    return sp.expand(e**4 * (1 - x**2) ** 2 * bracket), (m, e, q, x)


def _order(primitive: str) -> int:
    if primitive not in CROSSINGS:
        raise DomainError(f"End corrections are known for 'parabola' and 'conic', not for {primitive!r}.")
    return 4 + CROSSINGS[primitive]


@cache
def end_correction(primitive: str, digits: int = 12) -> Any:
    """The pieces that an end with a simple zero of k (parabolas) or dk/dr (conics) costs, an mpmath float.

    Args:
        primitive: "parabola" or "conic".
        digits: of the result, at most 15; the extrapolation is repeated with one term less as a check.

    Raises DomainError for an unknown primitive or more digits, UndecidedError if the extrapolations differ.

    >>> [mpmath.nstr(end_correction(primitive), 10) for primitive in ("parabola", "conic")]
    ['0.05503001968', '0.04836568094']
    """
    if not 1 <= digits <= 15:
        raise DomainError(f"An end correction is computed to 1 … 15 digits, not to {digits}.")
    with mpmath.workdps(40):
        contents = greedy_contents(primitive, FIRST + STEP * (TERMS - 1))
        points = [(n, contents[n - 1]) for n in range(FIRST, len(contents) + 1, STEP)]
        value, check = (_extrapolated(part) for part in (points, points[1:]))
        if abs(value - check) > mpmath.mpf(10) ** -digits:
            raise UndecidedError(f"The end correction of a {primitive} did not settle to {digits} digits.")
        return value


def greedy_contents(primitive: str, count: int) -> list[Any]:
    """∫₀^{uₙ} ρ₀ du for n = 1 … count, uₙ the knots of the greedy spline of the model with error 1.

    Raises DomainError for an unknown primitive or a count below 1.
    """
    order = _order(primitive)
    if not isinstance(count, int) or count < 1:
        raise DomainError(f"A greedy spline is followed over 1 or more arcs, not over {count!r}.")
    equations, rate = _conditions(primitive)
    power = 1 + mpmath.mpf(1) / order
    knot, length, found = mpmath.mpf(0), (order + 1) * rate ** -(1 / power), []
    peaks = [mpmath.mpf(0)] if primitive == "parabola" else [1 / mpmath.sqrt(peak_spread())] * 2
    if primitive == "conic":
        peaks = [-peaks[0], peaks[1]]
    state: list[Any] = [length, *peaks, *([0] if primitive == "conic" else [])]
    for _ in range(count):
        # the next knot where ρ₀ has the content 1 more, a start good enough for Newton
        content = rate * knot**power / power
        state[0] = ((content + 1) * power / rate) ** (1 / power) - knot
        state = list(mpmath.findroot(partial(equations, knot), state, maxsteps=60))
        knot += state[0]
        found.append(rate * knot**power / power)
    return found


def _conditions(primitive: str) -> tuple[Callable[..., Any], Any]:
    """The equations of an arc from a of length h with error 1, in (h, peaks…, q), and ρ₀/u^{1/p}."""
    d, (m, e, q, x) = model(primitive)
    value, slope = (sp.lambdify((m, e, q, x), f, "mpmath") for f in (d, sp.diff(d, x)))
    order = _order(primitive)
    peak = 0 if primitive == "parabola" else 1 / sp.sqrt(peak_spread())
    # the leading error is linear in the middle m; e is half the length
    leading = d.subs(q, 0).coeff(m, 1).subs({x: peak, e: sp.Rational(1, 2)})
    rate = mpmath.mpf(sp.N(leading, mpmath.mp.dps + 5)) ** (mpmath.mpf(1) / order)

    def parabola(a: Any, h: Any, p: Any) -> tuple[Any, ...]:
        at = (a + h / 2, h / 2, 0, p)
        return value(*at) - 1, slope(*at)

    def conic(a: Any, h: Any, low: Any, high: Any, q: Any) -> tuple[Any, ...]:
        first, last = (a + h / 2, h / 2, q, low), (a + h / 2, h / 2, q, high)
        return value(*first) + 1, value(*last) - 1, slope(*first), slope(*last)

    return (parabola if primitive == "parabola" else conic), rate


def _extrapolated(points: list[tuple[int, Any]]) -> Any:
    """The constant term of n − X as a series in 1, 1/X, 1/X³, … through the points (n, X)."""
    rows = [[1, *(x ** (1 - 2 * j) for j in range(1, len(points)))] for _, x in points]
    solution = mpmath.lu_solve(mpmath.matrix(rows), mpmath.matrix([n - x for n, x in points]))
    return solution[0]
