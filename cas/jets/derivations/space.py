"""Differentiation of space curves, in jets and in the moving Frenet frame of the thesis.

Two rings with a derivation: the jet x₁ … z₅ of a generic curve by any parameter, and, by arc length, the
functions κ, τ (the **thesis's** sign), their derivatives and β = √(κ² + τ²), over which vectors have
components along T, N, B. Identities in the second ring hold for every curve with κ > 0.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import sympy as sp

from osculant.cas.errors import DomainError
from osculant.cas.jets.space import SpaceJet
from osculant.cas.numbers.vectors import Vector3, add, scale

ORDER = 5
x = sp.symbols(f"x:{ORDER + 1}", real=True)
y = sp.symbols(f"y:{ORDER + 1}", real=True)
z = sp.symbols(f"z:{ORDER + 1}", real=True)
speed, bend = sp.symbols("v w", positive=True)  #: |α̇| and |α̇ × α̈|

_ROOTS = {
    SpaceJet(x, y, z).speed_squared: speed,
    SpaceJet(x, y, z).inflection_form: bend,
}


def _root(value: Any, degree: int) -> Any:
    return _ROOTS.get(value) or sp.root(value, degree)


#: the jet of a generic curve; its roots are the symbols `speed` and `bend`
GENERIC = SpaceJet(x, y, z, _root)


def derivative(expression: Any) -> Any:
    """d/dt of an expression in the jet up to order 4, in |α̇| and |α̇ × α̈|.

    >>> derivative(x[1] * y[2]), derivative(speed)
    (x1*y3 + x2*y2, (x1*x2 + y1*y2 + z1*z2)/v)
    """
    rates: dict[Any, Any] = {}
    for column in (x, y, z):
        rates |= dict(pairwise(column))
    c = GENERIC.cross(1, 2)
    rates[speed] = GENERIC.dot(1, 2) / speed
    rates[bend] = sum(a * b for a, b in zip(c, GENERIC.cross(1, 3))) / bend
    expression = sp.sympify(expression)
    return sum((sp.diff(expression, s) * rates[s] for s in expression.free_symbols if s in rates), sp.S.Zero)


def turned(expression: Any) -> Any:
    """The expression in coordinates in which α̇ = (v, 0, 0) and α̈ lies in the upper half of the xy-plane.

    Every regular jet with κ ≠ 0 can be turned so; then |α̇ × α̈| = v·y₂, and all relations are used up. What
    vanishes there and does not depend on the coordinates vanishes everywhere. Differentiate before.

    >>> turned(GENERIC.curvature)
    y2/v**2
    """
    up = sp.Symbol("y2", positive=True)
    values = {x[1]: speed, y[1]: 0, z[1]: 0, z[2]: 0, y[2]: up, bend: speed * up}
    return sp.sympify(expression).subs(values, simultaneous=True)


def turned_vector(vector: Vector3) -> Vector3:
    """Each component `turned`.

    >>> turned_vector(GENERIC.normal)
    (0, 1, 0)
    """
    a, b, c = vector
    return turned(a), turned(b), turned(c)


def turned_rate(vector: Vector3) -> Vector3:
    """d/ds of a vector given in the jet, by any parameter, `turned`.

    >>> turned_rate(GENERIC.tangent)
    (0, y2/v**2, 0)
    """
    a, b, c = (derivative(component) / speed for component in vector)
    return turned(a), turned(b), turned(c)


# By arc length, along the Frenet frame; the torsion has the thesis's sign.

kappas = (sp.Symbol("kappa", positive=True), *sp.symbols("kappa1:5", real=True))
taus = (sp.Symbol("tau", real=True), *sp.symbols("tau1:5", real=True))
kappa, tau = kappas[0], taus[0]
beta = sp.Symbol("beta", positive=True)
#: β² = κ² + τ², for `osculant.cas.claims.proof.vanishes`
RELATION = (beta**2 - kappa**2 - tau**2, beta)

T: Vector3 = (sp.S.One, sp.S.Zero, sp.S.Zero)
N: Vector3 = (sp.S.Zero, sp.S.One, sp.S.Zero)
B: Vector3 = (sp.S.Zero, sp.S.Zero, sp.S.One)


def by_arc_length(function: Any) -> Any:
    """d/ds of a function of κ, τ, their derivatives and β.

    >>> by_arc_length(kappa**2), by_arc_length(beta)
    (2*kappa*kappa1, (kappa*kappa1 + tau*tau1)/beta)
    """
    rates = dict(pairwise(kappas)) | dict(pairwise(taus))
    rates[beta] = (kappa * kappas[1] + tau * taus[1]) / beta
    function = sp.sympify(function)
    return sum((sp.diff(function, s) * rates[s] for s in function.free_symbols if s in rates), sp.S.Zero)


def moved(vector: Vector3) -> Vector3:
    """d/ds of a vector with components along T, N, B, by T′ = κN, N′ = −κT − τB, B′ = τN (2.13).

    >>> moved(N)
    (-kappa, 0, -tau)
    """
    rates = ((0, kappa, 0), (-kappa, 0, -tau), (0, tau, 0))
    components: Vector3 = tuple(by_arc_length(a) for a in vector)
    return add(components, *(scale(a, rate) for a, rate in zip(vector, rates)))


def combine(expression: Any, vectors: dict[Any, Vector3]) -> Vector3:
    """The vector a linear combination stands for, written in symbols for the vectors.

    Raises DomainError for an expression that is not linear in them, or has a term without a vector.

    >>> t, n = sp.symbols("T N")
    >>> combine(2 * t - kappa * n, {t: T, n: N})
    (2, -kappa, 0)
    """
    zero = dict.fromkeys(vectors, 0)
    expression, linear = sp.expand(expression), sum(s * sp.diff(expression, s).subs(zero) for s in vectors)
    if sp.expand(expression - linear) != 0:
        raise DomainError(f"{expression} is not a linear combination of {', '.join(map(str, vectors))}.")
    return add(*(scale(sp.diff(expression, s), vector) for s, vector in vectors.items()))
