"""Generated from cas/geometry/pencil.py by codegen.generate; do not edit.

Made with sympy 1.14.0, mpmath 1.3.0: `make generate`.
"""


from __future__ import annotations

import math

from osculant.kernels.jit import kernel


PARABOLA_FIRST = 0.5  # 1/2
PARABOLA_SHARPNESS = 16.0  # 16
CONIC_FIRST = 0.276393202250021  # 1/2 - sqrt(5)/10
CONIC_LAST = 0.7236067977499789  # sqrt(5)/10 + 1/2
CONIC_SHARPNESS = 50.0  # 50


@kernel
def displacement(Q: float, l0: float, l1: float, l2: float, n0: float, n1: float, n2: float, t0: float, t1: float, t2: float, speed: float, curvature: float) -> tuple[float, float, float, float, float, float]:
    """d, ∂d/∂Q, d′ and the lines l₀, l₁, l₂ at the foot; NaN where the normal misses the conic."""
    _v0 = 4.0*Q
    _v1 = _v0*l0
    _v2 = _v0*l2*n0 + _v1*n2 - 2.0*l1*n1
    _v3 = (l1 * l1)
    _v4 = math.sqrt((_v2 * _v2) - (-_v1*l2 + _v3)*(-16.0*Q*n0*n2 + 4.0*(n1 * n1)))
    _v5 = (8.0*Q*l0*l2 - 2.0*_v3)/(-_v2 - _v4)
    _v6 = (1.0 / _v4)
    _v7 = _v5*n0 + l0
    _v8 = _v5*n2 + l2
    _v9 = _v5*n1 + l1
    return _v5, -4.0*_v6*_v7*_v8, _v6*speed*(-_v5*curvature + 1.0)*(-_v0*_v7*t2 - _v0*_v8*t0 + 2.0*_v9*t1), _v7, _v9, _v8


@kernel
def through(l0: float, l1: float, l2: float) -> float:
    """Q of the conic through a point with these lines."""
    return ((1.0 / 4.0))*(l1 * l1)/(l0*l2)


@kernel
def parabola(sin_a: float, sin_b: float, sin_psi: float) -> float:
    """Q of the parabola."""
    return sin_a*sin_b/(sin_psi * sin_psi)


@kernel
def weight(Q: float, chord: float, sin_a: float, sin_b: float, sin_psi: float) -> tuple[float, float]:
    """Bézier weight w and the length of V = w(P₁ − P₀)."""
    _v0 = math.sqrt(sin_b)
    _v1 = math.sqrt(Q)/math.sqrt(sin_a)
    return _v1*sin_psi/_v0, _v0*_v1*chord
