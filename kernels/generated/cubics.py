"""Generated from cas/asymptotics/free_cubics.py and cas/geometry/cubic_moments.py by codegen.generate; do not edit.

Made with sympy 1.14.0, mpmath 1.3.0: `make generate`.
"""


from __future__ import annotations

from osculant.kernels.jit import kernel


FIRST = 0.18222320647320764  # 0.18222320647320764556
LAST = 0.8177767935267923  # 0.81777679352679235444
MIDDLE_SHARPNESS = 91.54828481274602  # 91.548284812746016656
OUTER_SHARPNESS = 109.1386721657943  # 109.13867216579431095
CROSSING = 0.3594361647896471  # 0.35943616478964708813


@kernel
def condition(Y2: float, Y3: float, Y4: float, Y5: float) -> tuple[float, float, float, float]:
    """The coefficients of a³ … a⁰ in (C)."""
    return 2.0*(Y2 * Y2), 3.0*Y2*Y3, -6.0*Y2*Y4 + 9.0*(Y3 * Y3), -2.0*Y2*Y5 + 3.0*Y3*Y4


@kernel
def thirds(a: float, Y2: float, Y3: float, Y4: float, Y5: float) -> tuple[float, float, float, float]:
    """b of a root a of (C), as two fractions: numerator, denominator, numerator, denominator."""
    _v0 = (a * a)
    _v1 = 3.0*Y3
    _v2 = 2.0*Y2
    return -Y2*_v0 - Y4 - _v1*a, _v2, -4.0*Y4*a - Y5 - _v0*_v1, _v1 + _v2*a


@kernel
def residual(a: float, b: float, Y2: float, Y3: float, Y4: float, Y5: float, Y6: float) -> float:
    """D."""
    return Y2*(b * b) + Y3*(a * a * a) + 6.0*Y3*a*b + 6.0*Y4*(a * a) + 4.0*Y4*b + 5.0*Y5*a + Y6


@kernel
def quartic(c: float, tx0: float, ty0: float, tx3: float, ty3: float, area: float, moment: float) -> tuple[float, float, float, float, float]:
    """The coefficients of a₀⁴ … a₀⁰ that area and moment leave."""
    _v0 = tx0*ty3
    _v1 = tx3*ty0
    _v2 = _v0 - _v1
    _v3 = c*tx0
    _v4 = (c * c)
    _v5 = (ty0 * ty0)
    _v6 = _v5*tx3
    _v7 = area*ty3
    _v8 = (tx0 * tx0)
    _v9 = 15.0*_v8
    _v10 = (ty3 * ty3)
    _v11 = 70.0*moment
    _v12 = (tx3 * tx3)
    _v13 = _v12*_v5
    _v14 = (c * c * c)
    _v15 = area*c
    _v16 = (area * area)
    _v17 = _v16*tx3
    _v18 = _v4*_v7
    _v19 = c*ty3
    _v20 = _v19*moment
    return -(27.0 / 112000.0)*(_v2 * _v2)*_v3*ty0, -(9.0 / 28000.0)*_v2*(2.0*_v0*_v4*ty0 + 15.0*_v1*area*tx0 + _v4*_v6 - _v7*_v9), -(9.0 / 28000.0)*_v10*_v11*_v8 + ((27.0 / 5600.0))*_v10*_v14*tx0*ty0 - (9.0 / 28000.0)*_v10*_v15*_v9 - (9.0 / 28000.0)*_v11*_v13 - (9.0 / 5600.0)*_v13*_v15 - (81.0 / 28000.0)*_v14*_v6*ty3 + ((9.0 / 1400.0))*area*c*tx0*tx3*ty0*ty3 + ((9.0 / 200.0))*moment*tx0*tx3*ty0*ty3, -(9.0 / 280.0)*_v0*_v17 + ((3.0 / 100.0))*_v1*_v18 - (9.0 / 100.0)*_v1*_v20 + ((9.0 / 100.0))*_v10*_v3*moment - (51.0 / 1400.0)*_v10*_v4*area*tx0 - (9.0 / 1750.0)*_v10*(c * c * c * c)*ty0 + ((9.0 / 280.0))*_v12*_v16*ty0, ((3.0 / 1400.0))*_v19*(25.0*_v17 + 25.0*_v18 - 42.0*_v20)


@kernel
def other_arm(a0: float, c: float, tx0: float, ty0: float, tx3: float, ty3: float, area: float) -> tuple[float, float]:
    """Numerator and denominator of a₃."""
    _v0 = a0*ty0
    return -(3.0 / 10.0)*_v0*c + area, -(3.0 / 20.0)*_v0*tx3 + ((3.0 / 20.0))*a0*tx0*ty3 - (3.0 / 10.0)*c*ty3
