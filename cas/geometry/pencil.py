"""The pencil of conics tangent to an arc at both ends (thesis 3.3, reconstructed).

An arc with end points P₀, P₂, unit end tangents T₀, T₂ and chord direction ĉ has the bitangent
conics F = l₁² − 4Q l₀l₂ = 0, one for each Q > 0, where l₀ = [T₂, x−P₂], l₂ = [T₀, x−P₀] and
l₁ = [ĉ, x−P₀].  Everything the kernels need to know about them is derived here, once:

* `displacement` – the signed distance d from the curve along its normal N, and how it moves with
  Q and along the curve;
* `weights` – the rational Bézier form of the member Q;
* `lobes` – where the error of a short arc peaks and how sharply, which starts the fast iteration.

All functions return sympy expressions; `codegen.generate` prints them as numba source.
"""

from __future__ import annotations

import sympy as sp

l0, l1, l2 = sp.symbols("l0 l1 l2", real=True)
#: derivatives of l₀, l₁, l₂ along the normal N and along the tangent T of the curve
n0, n1, n2 = sp.symbols("n0 n1 n2", real=True)
t0, t1, t2 = sp.symbols("t0 t1 t2", real=True)
Q = sp.Symbol("Q", positive=True)
d, speed, curvature = sp.symbols("d speed curvature", real=True)
#: sines of the angles T₀→ĉ, ĉ→T₂ (positive on the bent side) and T₀→T₂
sin_a, sin_b, chord = sp.symbols("sin_a sin_b chord", positive=True)
sin_psi = sp.Symbol("sin_psi", real=True)


def implicit(along: tuple[sp.Expr, sp.Expr, sp.Expr]) -> sp.Expr:
    """F = l₁² − 4Q l₀l₂ for given values of the three lines.

    >>> implicit((l0, l1, l2))
    -4*Q*l0*l2 + l1**2
    """
    return along[1] ** 2 - 4 * Q * along[0] * along[2]


def displacement() -> dict[str, sp.Expr]:
    """The displacement at one curve point, its derivative by Q and its slope along the curve.

    F(α + dN) = A d² + B d + C is solved for the root where F falls along the normal, ∂F/∂d = 2Ad + B < 0,
    as it does at both ends of an arc that bends to the left: so the feet move continuously along the conic,
    from one end of the arc to the other, and none of it is missed.  Returns ``d``, ``by_q`` = ∂d/∂Q,
    ``slope`` = d′ (per unit of the parameter) and the values ``foot0``, ``foot1``, ``foot2`` of the three
    lines at the foot.  d is NaN exactly where the normal misses the conic.

    >>> sorted(displacement())
    ['by_q', 'd', 'foot0', 'foot1', 'foot2', 'slope']
    """
    foot = (l0 + d * n0, l1 + d * n1, l2 + d * n2)
    coefficients = sp.Poly(sp.expand(implicit(foot)), d).all_coeffs()
    a, b, c = coefficients
    root = -sp.sqrt(b**2 - 4 * a * c)
    value = -2 * c / (b + root)
    # Implicit differentiation of F(α + dN, Q) = 0; ∂F/∂d = 2Ad + B equals the signed root.
    by_q = -sp.diff(implicit(foot), Q) / root
    # N′ = −κ|α′|T, so the foot moves by |α′|(1 − κd)T + d′N along the curve.
    along = sum(sp.diff(implicit((l0, l1, l2)), line) * t for line, t in ((l0, t0), (l1, t1), (l2, t2)))
    at_foot = along.subs({l0: foot[0], l1: foot[1], l2: foot[2]}, simultaneous=True)
    slope = -speed * (1 - curvature * d) * at_foot / root
    exact = {d: value}
    return {
        "d": value,
        "by_q": by_q.subs(exact),
        "slope": slope.subs(exact),
        "foot0": foot[0].subs(exact),
        "foot1": foot[1].subs(exact),
        "foot2": foot[2].subs(exact),
    }


def through() -> sp.Expr:
    """The Q of the conic through an inner point where the lines take the values l₀, l₁, l₂.

    >>> through()
    l1**2/(4*l0*l2)
    """
    return sp.solve(implicit((l0, l1, l2)), Q, dict=True, check=False)[0][Q]


def weights() -> dict[str, sp.Expr]:
    """The Bézier weight w of the member Q, the length of V, and the Q of the parabola (w = 1).

    The member is (b₀P₀ + b₁(wP₁) + b₂P₂)/(b₀ + w b₁ + b₂) with b = ((1−u)², 2u(1−u), u²), hence
    b₁² = 4b₀b₂, and wP₁ = wP₀ + V, V = ``reach``·T₀.  That P₁ lies on the tangent at P₂ gives w,
    and F = 0 along the curve gives the reach.

    >>> sorted(weights())
    ['parabola', 'reach', 'weight']
    """
    reach, b0, b1, b2 = sp.symbols("reach b0 b1 b2", positive=True)
    w = sp.Symbol("w", real=True)
    # Numerators of the lines along the curve: x − P₀ ~ b₁V + b₂c and x − P₂ ~ b₁(V − wc) − b₀c, c the chord.
    line2 = b2 * chord * sin_a
    line1 = -b1 * reach * sin_a
    line0 = b1 * (w * chord * sin_b - reach * sin_psi) + b0 * chord * sin_b
    weight = sp.solve(line0.coeff(b1), w)[0]
    on_curve = sp.expand(implicit((line0.subs(w, weight), line1, line2)).subs(b1, 2 * sp.sqrt(b0 * b2)))
    length = sp.solve(on_curve, reach)[0]
    normal = sp.simplify(weight.subs(reach, length))
    return {"weight": normal, "reach": length, "parabola": sp.solve(normal**2 - 1, Q)[0]}


def lobe_shape(crossings: int) -> tuple[sp.Expr, sp.Symbol]:
    """The leading error of a short arc on [0, 1], up to a factor, and its variable.

    Double zeros at the ends; ``crossings`` = 1 adds the conic's zero in the middle, 0 is a parabola.

    >>> lobe_shape(0)
    (x**2*(1 - x)**2, x)
    """
    x = sp.Symbol("x", real=True)
    return x**2 * (1 - x) ** 2 * (x - sp.Rational(1, 2)) ** crossings, x


def lobes(crossings: int) -> dict[str, sp.Expr]:
    """Peaks of the leading error x²(1−x)² (parabola) or x²(1−x)²(x−1/2) (conic) on [0, 1].

    Returns the positions ``first`` and, if there are two, ``last`` of the peaks, and ``sharpness``, the value
    of −d″/d there (equal at all peaks).

    >>> lobes(1)["sharpness"], lobes(0)["sharpness"]
    (50, 16)
    """
    shape, x = lobe_shape(crossings)
    inner = sorted(root for root in sp.solve(sp.diff(shape, x), x) if shape.subs(x, root) != 0)
    sharp = {sp.simplify((-sp.diff(shape, x, 2) / shape).subs(x, root)) for root in inner}
    (sharpness,) = sharp
    places = dict(zip(("first", "last"), inner, strict=False))
    return {**places, "sharpness": sharpness}
