"""Generated from cas/jets/plane.py by codegen.generate; do not edit.

Made with sympy 1.14.0, mpmath 1.3.0: `make generate`.
"""


from __future__ import annotations

import math

import numpy as np

from osculant.kernels.jit import kernel


@kernel
def invariants(x1: float, x2: float, x3: float, x4: float, x5: float, y1: float, y2: float, y3: float, y4: float, y5: float) -> tuple[float, float, float, float, float, float]:
    """Speed, κ, dκ/ds, φ = dr/dt, k and dk/dr from the derivatives 1…5 of both coordinates."""
    _v0 = (x1 * x1) + (y1 * y1)
    _v1 = x1*y2
    _v2 = x2*y1
    _v3 = _v1 - _v2
    _v4 = x1*y3 - x3*y1
    _v5 = 3.0*_v1 - 3.0*_v2
    _v6 = np.cbrt(_v3)
    _v7 = (_v4 * _v4)
    _v8 = x1*y4
    _v9 = x3*y2
    _v10 = _v5*(_v8 - 4.0*_v9 + 4.0*x2*y3 - x4*y1)
    return math.sqrt(_v0), _v3/_v0**((3.0 / 2.0)), (_v0*_v4 - _v5*(x1*x2 + y1*y2))/(_v0 * _v0 * _v0), _v6, ((1.0 / 9.0))*(_v10 - 5.0*_v7)/((_v3 * _v3)*(_v6 * _v6)), ((1.0 / 27.0))*(_v3*(3.0*_v4*(-7.0*_v8 - 2.0*_v9 + 2.0*x2*y3 + 7.0*x4*y1) + 3.0*_v5*(x1*y5 + 5.0*x2*y4 - 5.0*x4*y2 - x5*y1)) - _v4*(8.0*_v10 - 40.0*_v7))/(_v3 * _v3 * _v3 * _v3)
