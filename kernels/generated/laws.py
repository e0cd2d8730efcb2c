"""Generated from cas/laws/table.py by codegen.generate; do not edit.

Made with sympy 1.14.0, mpmath 1.3.0: `make generate`.
"""


from __future__ import annotations

import math

import numpy as np

from osculant.kernels.jit import kernel


PARABOLA_ORDER = 4
CONIC_ORDER = 5
BIARC_ORDER = 3
BIHELIX_ORDER = 3
LEVEL_BIHELIX_ORDER = 4
POLYGON_ORDER = 2
CUBIC_ORDER = 6
PARABOLA_AREA_ORDER = 5
CONIC_AREA_ORDER = 6
BIARC_AREA_ORDER = 4
POLYGON_AREA_ORDER = 3
CUBIC_AREA_ORDER = 7
BIHELIX_CONSTANT = 0.0030864197530864196  # 1/324
LEVEL_BIHELIX_CONSTANT = 0.00017361111111111112  # 1/5760
CUBIC_CONSTANT = 0.0016545709847659018  # CRootOf(262144*x**3 - 12288*x**2 + 624*x - 1, 0)
CUBIC_AREA_CONSTANT = 0.00098036570770986  # CRootOf(75278149632*x**5 + 3734035200*x**4 + 66734080*x**3 - 2822400*x**2 + 30240*x - 27, 0)


@kernel
def parabola_density(x1: float, x2: float, x3: float, x4: float, x5: float, y1: float, y2: float, y3: float, y4: float, y5: float) -> float:
    """Pieces of a parabola spline per unit of the parameter, times ε^(1/4)."""
    _v0 = (x1 * x1) + (y1 * y1)
    _v1 = x1*y2
    _v2 = x2*y1
    _v3 = _v1 - _v2
    _v4 = (_v3 * _v3)
    return ((1.0 / 12.0))*2.0**((1.0 / 4.0))*math.sqrt(3.0)*math.sqrt(_v0)*(np.cbrt(_v4/(_v0 * _v0 * _v0))/_v0**((3.0 / 2.0)))**((1.0 / 4.0))*abs(_v3)**((1.0 / 4.0))*abs(((3.0*_v1 - 3.0*_v2)*(x1*y4 + 4.0*x2*y3 - 4.0*x3*y2 - x4*y1) - 5.0*((x1*y3 - x3*y1) * (x1*y3 - x3*y1)))/(_v4*((np.cbrt(_v3)) * (np.cbrt(_v3)))))**((1.0 / 4.0))


@kernel
def conic_density(x1: float, x2: float, x3: float, x4: float, x5: float, y1: float, y2: float, y3: float, y4: float, y5: float) -> float:
    """Pieces of a conic spline per unit of the parameter, times ε^(1/5)."""
    _v0 = x1*y2
    _v1 = x2*y1
    _v2 = _v0 - _v1
    _v3 = x1*y3 - x3*y1
    _v4 = x4*y1
    _v5 = x2*y3
    _v6 = x3*y2
    _v7 = x1*y4
    _v8 = 3.0*_v0 - 3.0*_v1
    return ((1.0 / 30.0))*18.0**((1.0 / 5.0))*5.0**((3.0 / 10.0))*abs(_v2)**((2.0 / 5.0))*abs((_v2*(3.0*_v3*(-7.0*_v4 - 2.0*_v5 + 2.0*_v6 + 7.0*_v7) - 3.0*_v8*(x1*y5 + 5.0*x2*y4 - 5.0*x4*y2 - x5*y1)) - _v3*(40.0*(_v3 * _v3) - 8.0*_v8*(-_v4 + 4.0*_v5 - 4.0*_v6 + _v7)))/(_v2 * _v2 * _v2 * _v2))**((1.0 / 5.0))/((x1 * x1) + (y1 * y1))**((1.0 / 10.0))


@kernel
def biarc_density(x1: float, x2: float, x3: float, x4: float, x5: float, y1: float, y2: float, y3: float, y4: float, y5: float) -> float:
    """Pieces of a biarc spline per unit of the parameter, times ε^(1/3)."""
    _v0 = (x1 * x1) + (y1 * y1)
    return ((1.0 / 18.0))*18.0**((1.0 / 3.0))*abs(_v0*(x1*y3 - x3*y1) - (x1*x2 + y1*y2)*(3.0*x1*y2 - 3.0*x2*y1))**((1.0 / 3.0))/math.sqrt(_v0)


@kernel
def polygon_density(x1: float, x2: float, x3: float, x4: float, x5: float, y1: float, y2: float, y3: float, y4: float, y5: float) -> float:
    """Pieces of a polygon spline per unit of the parameter, times ε^(1/2)."""
    return ((1.0 / 4.0))*math.sqrt(2.0)*math.sqrt(abs(x1*y2 - x2*y1))/((x1 * x1) + (y1 * y1))**((1.0 / 4.0))


@kernel
def parabola_area_density(x1: float, x2: float, x3: float, x4: float, x5: float, y1: float, y2: float, y3: float, y4: float, y5: float) -> float:
    """Pieces of a parabola spline per unit of the parameter, times a piece's area^(1/5)."""
    _v0 = (x1 * x1) + (y1 * y1)
    _v1 = x1*y2
    _v2 = x2*y1
    _v3 = _v1 - _v2
    _v4 = (_v3 * _v3)
    return ((1.0 / 30.0))*11250.0**((1.0 / 5.0))*math.sqrt(_v0)*(np.cbrt(_v4/(_v0 * _v0 * _v0))/_v0**((3.0 / 2.0)))**((1.0 / 5.0))*abs(_v3)**((1.0 / 5.0))*abs(((3.0*_v1 - 3.0*_v2)*(x1*y4 + 4.0*x2*y3 - 4.0*x3*y2 - x4*y1) - 5.0*((x1*y3 - x3*y1) * (x1*y3 - x3*y1)))/(_v4*((np.cbrt(_v3)) * (np.cbrt(_v3)))))**((1.0 / 5.0))


@kernel
def conic_area_density(x1: float, x2: float, x3: float, x4: float, x5: float, y1: float, y2: float, y3: float, y4: float, y5: float) -> float:
    """Pieces of a conic spline per unit of the parameter, times a piece's area^(1/6)."""
    _v0 = x1*y2
    _v1 = x2*y1
    _v2 = _v0 - _v1
    _v3 = x1*y3 - x3*y1
    _v4 = x4*y1
    _v5 = x2*y3
    _v6 = x3*y2
    _v7 = x1*y4
    _v8 = 3.0*_v0 - 3.0*_v1
    return ((1.0 / 60.0))*math.sqrt(2.0)*3.0**((1.0 / 3.0))*5.0**((5.0 / 6.0))*abs(_v2)**((1.0 / 3.0))*abs((_v2*(3.0*_v3*(-7.0*_v4 - 2.0*_v5 + 2.0*_v6 + 7.0*_v7) - 3.0*_v8*(x1*y5 + 5.0*x2*y4 - 5.0*x4*y2 - x5*y1)) - _v3*(40.0*(_v3 * _v3) - 8.0*_v8*(-_v4 + 4.0*_v5 - 4.0*_v6 + _v7)))/(_v2 * _v2 * _v2 * _v2))**((1.0 / 6.0))


@kernel
def biarc_area_density(x1: float, x2: float, x3: float, x4: float, x5: float, y1: float, y2: float, y3: float, y4: float, y5: float) -> float:
    """Pieces of a biarc spline per unit of the parameter, times a piece's area^(1/4)."""
    _v0 = (x1 * x1) + (y1 * y1)
    return ((1.0 / 12.0))*math.sqrt(6.0)*abs(_v0*(x1*y3 - x3*y1) - (x1*x2 + y1*y2)*(3.0*x1*y2 - 3.0*x2*y1))**((1.0 / 4.0))/_v0**((1.0 / 4.0))


@kernel
def polygon_area_density(x1: float, x2: float, x3: float, x4: float, x5: float, y1: float, y2: float, y3: float, y4: float, y5: float) -> float:
    """Pieces of a polygon spline per unit of the parameter, times a piece's area^(1/3)."""
    return ((1.0 / 6.0))*18.0**((1.0 / 3.0))*abs(x1*y2 - x2*y1)**((1.0 / 3.0))
