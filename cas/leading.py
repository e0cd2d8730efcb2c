"""Leading error of one short arc approximated by a bitangent parabola or the best bitangent conic.

In the affine frame the curve is y = x²/2 + kx⁴/8 + (dk/dr)x⁵/40 + … (Lemma 2.2.2).  A parabola with the same
frame lacks the x⁴ term; a conic that has it lacks the x⁵ term.  Bitangent over an arc of affine length ρ,
the difference is that coefficient times the polynomial with the double zeros at the ends (and, for the
conic, a zero between, in the middle where both lobes are equal).  With ρ = κ^{1/3}σ and the factor κ^{1/3}
from affine to Euclidean normal this gives Theorem 3.6.1: |k|κ^{5/3}σ⁴/128 and |dk/dr|κ²σ⁵/(2000√5).
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any

from flint import arb, fmpq, fmpq_poly

from osculant.cas.canonical import affine_graph


@cache
def canonical_coefficients() -> tuple[Fraction, Fraction]:
    """The factors of k in x⁴ and of dk/dr in x⁵ of the affine canonical form.

    >>> canonical_coefficients()
    (Fraction(1, 8), Fraction(1, 40))
    """
    y, (k, slope, *_) = affine_graph(5)
    # both quotients are exact; what is left must be constant, or it does not read as a fraction
    return Fraction(str(y[4] / k)), Fraction(str(y[5] / slope))


def error_constant(primitive: str) -> Any:
    """c in the error c·|k|κ^{5/3}σ⁴ (parabola) or c·|dk/dr|κ²σ⁵ (conic): a ball at the current precision.

    >>> abs(128 * error_constant("parabola") - 1) < 1e-12
    True
    """
    crossings = {"parabola": 0, "conic": 1}[primitive]
    coefficient = canonical_coefficients()[crossings]
    x = fmpq_poly([0, 1])
    shape = x**2 * (1 - x) ** 2 * (x - fmpq(1, 2)) ** crossings
    # the peaks are among the real zeros of the derivative; its zeros 0 and 1 have height 0
    roots: list[Any] = shape.derivative().complex_roots()
    peaks = [root.real for root, _ in roots if root.imag == 0]
    heights = [abs(arb_value(shape, x)) for x in peaks]
    top = max(heights, key=float)
    return top * fmpq(coefficient.numerator, coefficient.denominator)


def arb_value(polynomial: fmpq_poly, x: Any) -> Any:
    """The value of a rational polynomial at a ball, by Horner's rule."""
    value = arb(0)
    for c in reversed(polynomial.coeffs()):
        value = value * x + arb(c)
    return value
