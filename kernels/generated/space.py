"""Generated from cas/jets/space.py by codegen.generate; do not edit.

Made with sympy 1.14.0, mpmath 1.3.0: `make generate`.
"""


from __future__ import annotations

import math

from osculant.kernels.jit import kernel


@kernel
def frenet(x1: float, x2: float, x3: float, y1: float, y2: float, y3: float, z1: float, z2: float, z3: float) -> tuple[float, float, float, float, float, float, float, float, float, float]:
    """Speed, κ, dκ/ds, τ (usual sign), T and N from the derivatives 1…3 of the three coordinates."""
    _v0 = (x1 * x1) + (y1 * y1) + (z1 * z1)
    _v1 = math.sqrt(_v0)
    _v2 = x1*y2 - x2*y1
    _v3 = (_v2 * _v2)
    _v4 = -x1*z2 + x2*z1
    _v5 = (_v4 * _v4)
    _v6 = y1*z2 - y2*z1
    _v7 = (_v6 * _v6)
    _v8 = _v3 + _v5 + _v7
    _v9 = math.sqrt(_v8)
    _v10 = (1.0 / _v9)
    _v11 = (1.0 / _v1)
    _v12 = _v10*_v11
    return _v1, _v9/_v0**((3.0 / 2.0)), _v10*(_v0*(_v2*(x1*y3 - x3*y1) + _v4*(-x1*z3 + x3*z1) + _v6*(y1*z3 - y3*z1)) - (3.0*_v3 + 3.0*_v5 + 3.0*_v7)*(x1*x2 + y1*y2 + z1*z2))/(_v0 * _v0 * _v0), (_v2*z3 + _v4*y3 + _v6*x3)/_v8, _v11*x1, _v11*y1, _v11*z1, _v12*(-_v2*y1 + _v4*z1), _v12*(_v2*x1 - _v6*z1), _v12*(-_v4*x1 + _v6*y1)
