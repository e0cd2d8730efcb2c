"""The algebra of jets in sympy: derivatives of a generic curve as symbols, and d/dt as a derivation on them.

Beside the jet x₁ … y₇ there are the speed v with v² = ⟨11⟩ and φ with φ³ = [12]. Both relations are used in
the derivation (v̇ = ⟨12⟩/v, φ̇ = [13]/(3φ²)) and by `equal`, which decides equality of rational expressions.
"""

from __future__ import annotations

from itertools import pairwise

import sympy as sp

ORDER = 7
x = sp.symbols(f"x:{ORDER + 1}", real=True)
y = sp.symbols(f"y:{ORDER + 1}", real=True)
v = sp.Symbol("v", positive=True)
phi = sp.Symbol("phi", real=True)

Vector = tuple[sp.Expr, sp.Expr]


def bracket(a: Vector, b: Vector) -> sp.Expr:
    """The determinant [a, b].

    >>> bracket((x[1], y[1]), (x[2], y[2]))
    x1*y2 - x2*y1
    """
    return a[0] * b[1] - a[1] * b[0]


def derivative(expression: sp.Expr) -> sp.Expr:
    """d/dt of an expression in the jet up to order 6, in v and φ.

    >>> derivative(x[1] * y[2]), derivative(v)
    (x1*y3 + x2*y2, (x1*x2 + y1*y2)/v)
    """
    rates = {v: (x[1] * x[2] + y[1] * y[2]) / v, phi: (x[1] * y[3] - y[1] * x[3]) / (3 * phi**2)}
    for column in (x, y):
        rates |= dict(pairwise(column))
    return sp.Add(*(sp.diff(expression, s) * rates[s] for s in expression.free_symbols if s in rates))


def along(vector: Vector, rate: sp.Expr) -> Vector:
    """The derivative of a vector by a parameter whose derivative by t is the rate: v for s, φ for r."""
    return derivative(vector[0]) / rate, derivative(vector[1]) / rate


def equal(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether two rational expressions in jet, v and φ agree on all jets.

    φ³ = [12] is solved for y₂, which leaves v² = ⟨11⟩ as the only relation; it is divided out.

    >>> equal(phi**3, x[1] * y[2] - y[1] * x[2]), equal(v**2, x[1] ** 2 + y[1] ** 2), equal(v, phi)
    (True, True, False)
    """
    difference = sp.together(a - b).subs(y[2], (phi**3 + y[1] * x[2]) / x[1])
    numerator = sp.expand(sp.numer(sp.together(difference)))
    return bool(sp.rem(numerator, v**2 - x[1] ** 2 - y[1] ** 2, v) == 0)
