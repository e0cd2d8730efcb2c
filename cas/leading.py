"""Leading error of one short arc approximated by a bitangent parabola or the best bitangent conic.

In the affine frame the curve is y = x²/2 + kx⁴/8 + (dk/dr)x⁵/40 + … (Lemma 2.2.2).  A parabola with the same
frame lacks the x⁴ term; a conic that has it lacks the x⁵ term.  Bitangent over an arc of affine length ρ,
the difference is that coefficient times the polynomial with the double zeros at the ends (and, for the
conic, a zero between, in the middle where both lobes are equal).  With ρ = κ^{1/3}σ and the factor κ^{1/3} from
affine to Euclidean normal this gives Theorem 3.6.1: |k|κ^{5/3}σ⁴/128 and |dk/dr|κ²σ⁵/(2000√5).
"""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy as sp

from osculant.cas.pencil import lobe_shape, lobes


def canonical_coefficients() -> tuple[sp.Expr, sp.Expr]:
    """The factors of k in x⁴ and of dk/dr in x⁵ of the canonical form, by reversion of x(r).

    >>> canonical_coefficients()
    (1/8, 1/40)
    """
    r, x, k, slope = sp.symbols("r x k slope")
    # α‴ = −kα′, so α⁽⁴⁾ = −k′t − kn and α⁽⁵⁾ = … − 2k′n: the components along t and n (2.11)
    along = r - k * r**3 / 6 - slope * r**4 / 24
    across = r**2 / 2 - k * r**4 / 24 - 2 * slope * r**5 / 120
    inverse = x
    for _ in range(3):
        inverse = _truncated(x - (along - r).subs(r, inverse), x, 5)
    graph = sp.Poly(_truncated(across.subs(r, inverse), x, 6), x)
    return graph.coeff_monomial(x**4) / k, graph.coeff_monomial(x**5) / slope


def _truncated(expr: sp.Expr, x: sp.Symbol, order: int) -> sp.Expr:
    return sum(c * x**n for (n,), c in sp.Poly(sp.expand(expr), x).terms() if n < order)


@cache
def exact_error_constant(primitive: str) -> sp.Expr:
    """c in the error c·|k|κ^{5/3}σ⁴ (parabola) or c·|dk/dr|κ²σ⁵ (conic), exactly.

    >>> exact_error_constant("parabola"), exact_error_constant("conic")
    (1/128, sqrt(5)/10000)
    """
    crossings = {"parabola": 0, "conic": 1}[primitive]
    shape, x = lobe_shape(crossings)
    peak = sp.Abs(shape.subs(x, lobes(crossings)["first"]))
    return sp.simplify(canonical_coefficients()[crossings] * peak)


def error_constant(primitive: str) -> Any:
    """The same as a ball at the current precision."""
    from flint import arb, ctx

    return arb(str(sp.N(exact_error_constant(primitive), int(ctx.prec * 0.302) + 10)))
