"""The cubic of de Boor, Höllig and Sabin: position, tangent and curvature at both ends of a short arc.

Two ways lead to its error, and they meet:

* In the limit of a short arc the six contacts come together, so the cubic has six-fold contact with the
  affine canonical form y = x²/2 + kx⁴/8 + k′x⁵/40 + Y₆x⁶. With x = t + at² + bt³, y = ct² + dt³ the orders
  t² … t⁵ determine c, d, b and leave one cubic equation for a; order t⁶ leaves the residual E(a).
* The quadratic system for the two tangent lengths δ₀ = h·ξ₀, δ₁ = h·ξ₁ has ξ₀ = ξ₁ = 1/3 as a triple root at
  h = 0. Blown up by ξ₀ = 1/3 + hz it leaves at h³ a cubic equation for z, the same one with a = −3z.

So E(a)u³(ℓ − u)³ is the leading displacement in affine arc length over an arc of affine length ℓ = κ^{1/3}σ,
and the error is |E|κ^{7/3}σ⁶/64, with one or three real values of a. E is reduced by the cubic equation, so
that solutions can be compared: E = (21/32)(ka² + k′a/5) + a part that does not depend on a.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp

from osculant.cas.asymptotics.contacts import CONTACTS
from osculant.cas.errors import DomainError
from osculant.cas.jets.canonical import affine_graph
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.numbers.power_series import PowerSeries

#: affine curvature and its derivatives by affine arc length; the free coefficient of t² in x
k, k1, k2, a = sp.symbols("k k1 k2 a", real=True)
#: the blown-up first tangent length
z = sp.Symbol("z", real=True)
#: two solutions whose discriminant is below this part of its terms are taken for a double one
SINGULAR = 1e-20


@dataclass(frozen=True)
class ContactCubic:
    """The cubics x = t + at² + bt³, y = ct² + dt³ with six-fold contact, and what is left at t⁶.

    ``condition`` is a monic cubic polynomial in a that vanishes; ``residual`` is E(a), of degree 2 in a.
    """

    b: Any
    c: Any
    d: Any
    condition: Any
    residual: Any


@cache
def contact_cubic() -> ContactCubic:
    """The six-fold contact, solved coefficient by coefficient.

    >>> contact_cubic().condition
    a**3 - 3*a*k/4 - k1/20
    >>> contact_cubic().residual.subs({a: 0, k: 1, k1: 0, k2: 0})  # a circle
    1/128
    """
    ring, ra, rb, rc, rd, *jet = sp.ring([a, *sp.symbols("b c d"), k, k1, k2], sp.QQ)
    graph, _ = affine_graph(CONTACTS, (*jet, ring.zero))
    along = PowerSeries([ring.zero, ring.one, ra, rb, *(ring.zero,) * (CONTACTS - 3)])
    across = PowerSeries([ring.zero, ring.zero, rc, rd, *(ring.zero,) * (CONTACTS - 3)])
    defect = [c.as_expr() for c in (graph.at(along) - across).coefficients]
    solution: dict[Any, Any] = {}
    for order, unknown in ((2, "c"), (3, "d"), (4, "b")):
        symbol = sp.Symbol(unknown)
        [value] = sp.solve(sp.expand(defect[order].subs(solution)), symbol)
        solution[symbol] = sp.expand(value)
    b, c, d = (solution[sp.Symbol(name)] for name in "bcd")
    condition = sp.Poly(defect[5].subs(solution), a).monic().as_expr()
    residual = sp.rem(sp.expand(defect[6].subs(solution)), condition, a)
    return ContactCubic(b, c, d, condition, sp.expand(residual))


@cache
def limit_system() -> Any:
    """The polynomial in ξ₀ that the two curvature conditions leave at h = 0, monic.

    >>> sp.factor(limit_system())
    (xi + 1)*(3*xi - 1)**3/27
    """
    first, _ = _tangent_lengths(sp.Symbol("xi"), shift=0)
    return sp.Poly(first[0].as_expr(), sp.Symbol("xi")).monic().as_expr()


@cache
def blown_up_system() -> Any:
    """The monic cubic polynomial in z that is left at h³ for ξ₀ = 1/3 + hz; h⁰ … h² vanish.

    Raises DomainError if they do not: then 1/3 is no triple root.

    >>> blown_up_system()
    -k*z/12 + k1/540 + z**3
    """
    final, _ = _tangent_lengths(z, shift=1)
    if any(final[n] != 0 for n in range(3)):
        raise DomainError(f"The contact system is not singular of order 3: it leaves {final}.")
    return sp.Poly(final[3].as_expr(), z).monic().as_expr()


def _tangent_lengths(symbol: Any, shift: int) -> tuple[PowerSeries, PowerSeries]:
    """(second curvature condition, ξ₁), after ξ₁ was taken from the first, for ξ₀ = symbol or 1/3 + h·symbol.

    With T = (1, y′) the curvature of a graph at an end is y″ if (2/3)[b₁ − b₀, b₂ − b₁] = y″δ³:
    [T₀,T₁]δ₁ = [T₀,d] − (3/2)y″₀δ₀², [T₀,T₁]δ₀ = [d,T₁] − (3/2)y″₁δ₁².
    """
    order = CONTACTS
    ring, unknown, *jet = sp.ring([symbol, k, k1, k2], sp.QQ)
    zero = ring.zero
    y, _ = affine_graph(order, (*jet, zero))
    slope, bend = y.derivative(), y.derivative().derivative()
    xi0 = (
        PowerSeries([unknown, *(zero,) * 3])
        if shift == 0
        else PowerSeries([ring.one / 3, unknown, zero, zero])
    )
    # divided by h and h²: the arc is [0, h], so y = h²(…), T₀ = (1, 0), [T₀,T₁] = y′, [d,T₁] = hy′ − y
    rise, fall = slope.shifted(-1).cut(4), (slope.shifted(1).cut(order) - y.cut(order)).shifted(-2).cut(4)
    xi1 = (y.shifted(-2).cut(4) - xi0 * xi0 * (ring.one * 3 / 2)) * rise.reciprocal()
    return rise * xi0 - fall + bend.cut(4) * xi1 * xi1 * (ring.one * 3 / 2), xi1


@cache
def discriminant() -> Any:
    """Of the cubic for a: three real solutions where it is positive, one where it is negative.

    >>> sp.factor(discriminant() * 400 / 27)
    25*k**3 - k1**2
    """
    return sp.expand(sp.discriminant(contact_cubic().condition, a))


@dataclass(frozen=True)
class Branch:
    """One real solution: a, and the signed E(a)."""

    a: Any
    residual: Any


def branches(affine_curvature: Any, slope: Any, bend: Any) -> tuple[Branch, ...]:
    """The real solutions at given k, k′, k″ (mpmath numbers), the one of least |E| first.

    Raises DomainError for what is no finite number, and where two solutions coincide, k′² = 25k³: there the
    contact condition is singular.

    >>> import mpmath as mp
    >>> [mp.nstr(branch.residual, 6) for branch in branches(mp.mpf(1), mp.mpf(0), mp.mpf(0))]
    ['0.0078125', '0.5', '0.5']
    """
    import mpmath as mp

    given = (affine_curvature, slope, bend)
    try:
        values = tuple(mp.mpf(c) for c in given)
    except (TypeError, ValueError):
        raise DomainError(f"A G2 cubic needs k, k′, k″ as real numbers, not {given}.") from None
    if not all(map(mp.isfinite, values)):
        shown = ", ".join(mp.nstr(c, 6) for c in values)
        raise DomainError(f"A G2 cubic needs finite numbers k, k′, k″, not {shown}.")
    condition, residual, terms = _compiled()
    cubed, squared = terms(*values)
    if abs(cubed + squared) <= SINGULAR * (abs(cubed) + abs(squared)):
        raise DomainError(
            f"Two G2 cubics coincide at affine curvature {mp.nstr(values[0], 6)} with slope "
            f"{mp.nstr(values[1], 6)}: choose another arc."
        )
    with mp.workdps(mp.mp.dps + 10):
        roots = mp.polyroots(condition(*values), maxsteps=200, extraprec=mp.mp.prec)
        count = 3 if cubed + squared > 0 else 1
        real = sorted(roots, key=lambda r: abs(mp.im(r)))[:count]
    found = [Branch(+mp.re(r), residual(mp.re(r), *values)) for r in real]
    return tuple(sorted(found, key=lambda branch: abs(branch.residual)))


@cache
def _compiled() -> tuple[Any, Any, Any]:
    found = contact_cubic()
    coefficients = sp.Poly(found.condition, a).all_coeffs()
    parts = sp.Add.make_args(discriminant())
    options = {"modules": "mpmath"}
    return (
        sp.lambdify((k, k1, k2), coefficients, **options),
        sp.lambdify((a, k, k1, k2), found.residual, **options),
        sp.lambdify((k, k1, k2), parts, **options),
    )


@cache
def middle_is_best() -> Any:
    """With three real solutions, the one of least |a| has the least |E| exactly where this is ≥ 0.

    With a the *largest* solution in absolute value, E grows from the middle solution m to the third one l to
    a; so m is best unless |E(m)| > |E(l)|, which is E(m) + E(l) < 0. That sum is symmetric in m and l, so it
    is a polynomial in a: m + l = −a and ml = a² + (coefficient of a).

    >>> middle_is_best().subs({k: 1, k1: 0, a: sp.sqrt(3) / 2})
    k2/120 + 65/128
    """
    condition = contact_cubic().condition
    quadratic, linear, constant = sp.Poly(contact_cubic().residual, a).all_coeffs()
    total, product = -a, a**2 + condition.coeff(a, 1)
    both = quadratic * (total**2 - 2 * product) + linear * total + 2 * constant
    return sp.expand(sp.rem(sp.expand(both), condition, a))


def affine_jet(x: Any, y: Any) -> tuple[Any, Any, Any]:
    """(k, k′, k″) from Taylor coefficients 0 … 6 (not multiplied by factorials) of a curve's coordinates.

    Args:
        x: at least seven coefficients, mpmath numbers or balls; the affine frame comes from the first four.
        y: as many of the other coordinate.

    Raises DomainError for too few coefficients, and at an inflection or a singular point.

    >>> circle = [0, 1, 0, -1 / 6, 0, 1 / 120, 0], [0, 0, 1 / 2, 0, -1 / 24, 0, 1 / 720]
    >>> import mpmath as mp
    >>> [round(float(c), 12) for c in affine_jet(*[[mp.mpf(c) for c in row] for row in circle])]
    [1.0, 0.0, 0.0]
    """
    if min(len(x), len(y)) < CONTACTS + 1:
        raise DomainError(
            f"The error of a G2 cubic needs derivatives up to order {CONTACTS}, {CONTACTS + 1} coefficients."
        )
    jet = PlaneJet([c * f for c, f in zip(x, (1, 1, 2, 6))], [c * f for c, f in zip(y, (1, 1, 2, 6))])
    if not (jet.inflection_form > 0 or jet.inflection_form < 0):
        raise DomainError(
            "The contact conditions of a G2 cubic are singular where the curvature is 0: split the "
            "curve there."
        )
    (t0, t1), (n0, n1) = jet.affine_tangent, jet.affine_normal
    rows, zero = list(zip(x, y))[1 : CONTACTS + 1], x[0] * 0
    along = PowerSeries([zero, *(p * n1 - q * n0 for p, q in rows)])
    across = PowerSeries([zero, *(t0 * q - t1 * p for p, q in rows)])
    k_, slope, bend = _from_graph()(*across.at(along.reversion()).coefficients[4:])
    return k_, slope, bend


@cache
def _from_graph() -> Any:
    """k, k′, k″ from the coefficients of x⁴, x⁵, x⁶ of the canonical form."""
    _, *jet = sp.ring([k, k1, k2], sp.QQ)
    graph, _ = affine_graph(CONTACTS, (*jet, jet[0] * 0))
    heights = sp.symbols("Y4:7")
    [found] = sp.solve([graph[4 + i].as_expr() - Y for i, Y in enumerate(heights)], [k, k1, k2])
    return sp.lambdify(heights, found, modules=[{}])
