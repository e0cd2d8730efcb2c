"""The second term of the number of pieces: N(ε) = C ε^{−1/p} + c₁ ε^{1/p} + O(ε^{3/p}), c₁ = ∫ρ₁ ds.

The greedy spline divides a curve into arcs of equal error ε. Let ρ(s) be a density of which every arc has the
content 1. An arc of length h about s has the content hρ + h³ρ″/24 + O(h⁵) and the error
hᵖ(e₀ + e₂h²) + O(hᵖ⁺⁴) (`osculant.cas.asymptotics.short_arcs`). With a = e₀^{−1/p} the two conditions give

    ρ = ε^{−1/p}/a + ε^{1/p}ρ₁ + …,   ρ₁ = a·e₂/(p e₀) − (a²/24) d²(e₀^{1/p})/ds².

There is no term of order 1: it could only come from an odd power of h, and an arc is the same for −h. This
holds where e₀ is smooth and not 0, up to both ends: no inflection, and k ≠ 0 (parabolas) or dk/dr ≠ 0
(conics); otherwise the integral diverges, and `osculant.cas.asymptotics.end_corrections` tells what an end
costs.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from itertools import pairwise
from typing import Any

import sympy as sp
from flint import arb

from osculant.cas.asymptotics.arc_displacement import KAPPA
from osculant.cas.asymptotics.end_corrections import end_correction
from osculant.cas.asymptotics.short_arcs import arc_error, rational_function
from osculant.cas.errors import DomainError
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.numbers.balls import PRECISION, precision
from osculant.cas.numbers.power_series import PowerSeries, power
from osculant.cas.numbers.quadrature import integral
from osculant.cas.zeros.isolate import taylor_form
from osculant.cas.zeros.plane import FORMS

#: an interval is halved so often before a form on it counts as 0 somewhere; terms of its Taylor forms
DEPTH, TERMS = 40, 8
#: what a zero of a form of `osculant.cas.zeros.plane` means
MEANING = {
    "cusp": "the curve is singular",
    "inflection": "the curvature is 0",
    "parabolic": "the affine curvature k is 0",
    "sextactic": "dk/dr is 0 (a sextactic point)",
}


def density_terms(order: int) -> tuple[Any, Any]:
    """(ρ₀, ρ₁) from hρ + h³ρ″/24 = 1 and hᵖ(e₀ + e₂h²) = ε, p = ``order``, by powers of ε^{1/p}.

    Sympy expressions in the function a(s) and the symbols e₀ and e₂, in which a = e₀^{−1/p} is not inserted.

    Raises DomainError for an order that is no positive integer.

    >>> density_terms(5)[1]
    -a(s)**2*Derivative(1/a(s), (s, 2))/24 + e2*a(s)/(5*e0)
    """
    if not isinstance(order, int) or order < 1:
        raise DomainError(f"The error of an arc has a positive whole order in its length, not {order!r}.")
    s, e0, e2 = sp.symbols("s e0 e2")
    a = sp.Function("a")(s)
    unit = sp.Integer(1)
    # h = ε^{1/p}·a·(1 + h₂ε^{2/p} + …); in δ = ε^{2/p} the error condition is (1 + h₂δ)ᵖ(1 + (e₂/e₀)a²δ) = 1
    error = PowerSeries([unit, e2 * a**2 / e0])
    length = power(error, Fraction(-1, order)) * a
    leading = 1 / length[0]
    # content: length·(ρ₀ + ρ₁δ) + length³·ρ₀″δ/24 = 1
    bend = sp.Derivative(leading, (s, 2))
    following = -(length[1] * leading + length[0] ** 3 * bend / 24) / length[0]
    return leading, sp.expand(following)


@cache
def density_factor(primitive: str) -> Any:
    """ρ₁/a as a rational function of κ, κ₁, … (`osculant.cas.asymptotics.arc_displacement.KAPPA`, κ > 0).

    >>> sorted(density_factor("parabola").free_symbols, key=str)
    [kappa0, kappa1, kappa2, kappa3, kappa4]
    """
    law = arc_error(primitive)
    _, following = density_terms(law.order)
    (a,) = following.atoms(sp.Function("a"))
    (s,) = a.args
    e0, e2 = sp.symbols("e0 e2")
    root = sp.Function("e")(s)
    power_of = root ** sp.Rational(1, law.order)
    inserted = following.subs(a, 1 / power_of).doit() * power_of
    # e₀ and its derivatives by s; the root of 5 and the sign of e₀ cancel from every ratio
    first = _along(law.leading)
    jet = {sp.Derivative(root, (s, 2)): _along(first), sp.Derivative(root, s): first, root: law.leading}
    powers = sp.powsimp(sp.expand(inserted), force=True).subs(jet)
    return sp.factor(powers.subs({e0: law.leading, e2: law.following}))


def _along(expression: Any) -> Any:
    """d/ds of a rational function of κ, κ₁ and so on."""
    return sp.Add(*(sp.diff(expression, k) * rate for k, rate in pairwise(KAPPA)))


@cache
def _compiled(primitive: str) -> Callable[..., Any]:
    order = arc_error(primitive).order
    return rational_function(density_factor(primitive), order + 1)


def next_density(primitive: str, kappa: list[Any]) -> Any:
    """ρ₁ at balls κ, κ₁, … up to κ₄ (parabola) or κ₅ (conic): pieces per unit of arc length, times ε^{1/p}.

    >>> with precision(64):
    ...     round(float(next_density("parabola", [arb(1), *[arb(0)] * 4])), 12)  # the unit circle
    0.070074701271
    """
    law = arc_error(primitive)
    leading, _ = law.at(kappa, lambda n: arb(n).sqrt())
    if kappa[0] < 0:
        kappa = [-k for k in kappa]
    return _compiled(primitive)(kappa[: law.order + 1]) / leading.root(law.order)


def next_constant(curve: CurveBalls, primitive: str, low: Any, high: Any) -> tuple[Any, float]:
    """(c₁, estimated error) over [low, high], where e₀ must be smooth and not 0, both ends included.

    Raises DomainError naming a place where it may not be: an inflection, a singular point, k = 0 (parabola)
    or dk/dr = 0 (conic); where that is an end and k or dk/dr is 0, the message tells the correction, a
    constant. Raises UndecidedError if the quadrature does not settle.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> spiral = CurveBalls(parse_tuple("t*cos(t), t*sin(t)"))
    >>> with precision(PRECISION):
    ...     low, high = arb.pi() / 6, 2 * arb.pi()
    >>> round(float(next_constant(spiral, "parabola", low, high)[0]), 4)
    0.3672
    """
    order = arc_error(primitive).order
    with precision(PRECISION):
        _require_smooth(curve, primitive, low, high)

        def density(t: Any) -> Any:
            kappa, speed = curvatures(curve, t, order + 1)
            return (next_density(primitive, kappa) * speed).mid()

        return integral(density, low, high)


def _require_smooth(curve: CurveBalls, primitive: str, low: Any, high: Any) -> None:
    special = "parabolic" if primitive == "parabola" else "sextactic"
    for kind in ("cusp", "inflection", special):
        form, order = FORMS[kind].form, FORMS[kind].order
        parts = [(low, high, 0)]
        while parts:
            a, b, depth = parts.pop()
            over, middle = arb(a).union(arb(b)), (a + b) / 2
            wide = curve.form_series(form, over, order, TERMS)
            centre = curve.form_series(form, middle, order, TERMS)
            if wide and centre and not taylor_form(centre, wide, over - middle).contains(0):
                continue
            if depth == DEPTH:
                raise DomainError(_refusal(kind, primitive, middle, (low, high), high - low))
            parts += [(middle, b, depth + 1), (a, middle, depth + 1)]


def _refusal(kind: str, primitive: str, found: Any, ends: tuple[Any, Any], length: Any) -> str:
    """Why there is no next term; the place is the end itself if it is within the last halving of it."""
    near = [end for end in ends if float(abs(found - end)) <= float(abs(length)) / 2**DEPTH]
    place = float(near[0]) if near else float(found)
    advice = "take a stretch that keeps away from it"
    if near and kind in ("parabolic", "sextactic"):
        cost = float(end_correction(primitive))
        law = f"C*tolerance^(-1/{arc_error(primitive).order})"
        advice += f"; if the zero is simple, this end costs {cost:.6f} pieces more than {law}"
    where = "at" if near else "at or near"
    return (
        f"The next term needs an integrand that is smooth and not 0, but {MEANING[kind]} {where} "
        f"t = {place:.10g}: {advice}."
    )


def curvatures(curve: CurveBalls, t: Any, count: int) -> tuple[list[Any], Any]:
    """([κ, dκ/ds, …], |α̇|) at a ball t, ``count`` of them; not finite where the curve is singular.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> with precision(64):
    ...     kappa, speed = curvatures(CurveBalls(parse_tuple("2*cos(t), 2*sin(t)")), arb(1), 3)
    >>> [abs(float(k)) < 1e-9 for k in kappa[1:]], float(speed)
    ([True, True], 2.0)
    """
    x, y = (PowerSeries(row).derivative() for row in curve.coefficients(t, count + 1))
    squared = x * x + y * y
    speed = power(squared, Fraction(1, 2), squared[0].sqrt())
    turning = x.cut(count) * y.derivative() - y.cut(count) * x.derivative()
    form, found = turning / (squared * speed).cut(count), []
    rate = 1 / speed
    for remaining in range(count - 1, -1, -1):
        found.append(form[0])
        if remaining:
            form = form.derivative() * rate.cut(remaining)
    return found, speed[0]
