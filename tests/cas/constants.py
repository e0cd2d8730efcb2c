"""Two curves of the thesis, and their leading constants as numbers of mpmath."""

from __future__ import annotations

import mpmath

from osculant.cas.formulas.parser import parse_constant, parse_tuple
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.laws.complexity import complexity_constant
from osculant.cas.numbers.balls import PRECISION, constant, precision

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
SEXTIC = ("4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)", "0", "3*pi/4")


def complexity(primitive, text, low, high, metric="hausdorff"):
    """C in mpmath, to 50 digits of which some are right."""
    with precision(PRECISION):
        ends = [constant(parse_constant(end)) for end in (low, high)]
    value, error = complexity_constant(CurveBalls(parse_tuple(text)), primitive, *ends, metric)
    assert 0 <= error < 1e-15 * abs(float(value))
    with mpmath.workdps(50):
        return mpmath.mpf(value.mid().str(50, radius=False))


def close(x, y, digits):
    return abs(x - y) < mpmath.mpf(10) ** -digits * abs(y)
