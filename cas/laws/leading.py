"""Leading error of one short arc approximated by a bitangent parabola or the best bitangent conic.

In the affine frame the curve is y = x²/2 + kx⁴/8 + (dk/dr)x⁵/40 + … (Lemma 2.2.2).  A parabola with the same
frame lacks the x⁴ term; a conic that has it lacks the x⁵ term.  Bitangent over an arc of affine length ρ,
the difference is that coefficient times the polynomial with the double zeros at the ends (and, for the
conic, a zero between, in the middle where both lobes are equal).  With ρ = κ^{1/3}σ and the factor κ^{1/3}
from affine to Euclidean normal its peak gives Theorem 3.6.1: |k|κ^{5/3}σ⁴/128 and |dk/dr|κ²σ⁵/(2000√5).
The integral of its absolute value gives Theorem 3.6.4, the areas |k|ρ⁵/240 and |dk/dr|ρ⁶/7680: areas are
the same in the affine frame.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from itertools import pairwise
from typing import Any

from flint import arb, fmpq, fmpq_poly

from osculant.cas.jets.canonical import affine_graph


@cache
def canonical_coefficients() -> tuple[Fraction, Fraction]:
    """The factors of k in x⁴ and of dk/dr in x⁵ of the affine canonical form.

    >>> canonical_coefficients()
    (Fraction(1, 8), Fraction(1, 40))
    """
    y, (k, slope, *_) = affine_graph(5)
    # both quotients are exact; what is left must be constant, or it does not read as a fraction
    return Fraction(str(y[4] / k)), Fraction(str(y[5] / slope))


def error_constant(primitive: str, metric: str = "hausdorff") -> Any:
    """c in the error c·|k|κ^{5/3}σᵖ (parabola) or c·|dk/dr|κ²σᵖ (conic): a ball at the current precision.

    p is 4 and 5 for the metric "hausdorff", one more for "area".

    >>> abs(128 * error_constant("parabola") - 1) < 1e-12
    True
    >>> abs(7680 * error_constant("conic", "area") - 1) < 1e-12
    True
    """
    if metric == "area":
        area = area_constant(primitive)
        return arb(area.numerator) / area.denominator
    coefficient, shape, _ = _leading_term(primitive)
    # the peaks are among the real zeros of the derivative; its zeros at the ends have height 0
    roots: list[Any] = shape.derivative().complex_roots()
    peaks = [root.real for root, _ in roots if root.imag == 0]
    heights = [abs(arb_value(shape, x)) for x in peaks]
    top = max(heights, key=float)
    return top * fmpq(coefficient.numerator, coefficient.denominator)


def area_constant(primitive: str) -> Fraction:
    """c in the area c·|k|ρ⁵ (parabola) or c·|dk/dr|ρ⁶ (conic) between a short arc and its approximation.

    The lobes' areas add; that of the conic is crossed in the middle, where both are equal and their sum
    is least.

    >>> area_constant("parabola"), area_constant("conic")
    (Fraction(1, 240), Fraction(1, 7680))
    """
    coefficient, shape, zeros = _leading_term(primitive)
    whole = shape.integral()
    lobes = [abs(whole(high) - whole(low)) for low, high in pairwise(zeros)]
    return coefficient * sum(Fraction(int(lobe.p), int(lobe.q)) for lobe in lobes)


def _leading_term(primitive: str) -> tuple[Fraction, fmpq_poly, list[fmpq]]:
    """The coefficient of the displacement, its shape on [0, 1], and the zeros there in order."""
    crossings = {"parabola": 0, "conic": 1}[primitive]
    x, middle = fmpq_poly([0, 1]), fmpq(1, 2)
    shape = x**2 * (1 - x) ** 2 * (x - middle) ** crossings
    return canonical_coefficients()[crossings], shape, [fmpq(0), *[middle] * crossings, fmpq(1)]


def arb_value(polynomial: fmpq_poly, x: Any) -> Any:
    """The value of a rational polynomial at a ball, by Horner's rule."""
    value = arb(0)
    for c in reversed(polynomial.coeffs()):
        value = value * x + arb(c)
    return value
