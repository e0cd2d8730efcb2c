"""Steps of Theorem A beyond section 3.2: the chart in which a convex arc and a conic are graphs."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes

X, Y, X1, Y1, X2, Y2, k, k1, k2 = sp.symbols("X Y X1 Y1 X2 Y2 k k1 k2", real=True)
#: rates by affine arc length: γ‴ = −kγ′
RATES = ((X, X1), (X1, X2), (X2, -k * X1), (Y, Y1), (Y1, Y2), (Y2, -k * Y1), (k, k1), (k1, k2))
#: [γ′, γ″] = 1, as a relation for Y″
UNIT = (X1 * Y2 - X2 * Y1 - 1, Y2)
#: [γ, γ′], and the chart about the origin
W = X * Y1 - Y * X1
ABSCISSA, ORDINATE = -X / Y, -1 / Y


def _rate(expression: Any) -> Any:
    return sum(sp.diff(expression, symbol) * rate for symbol, rate in RATES)


def _along(expression: Any) -> Any:
    """d/dx in the chart."""
    return sp.together(_rate(expression) / _rate(ABSCISSA))


@claim(
    "X3.2-4",
    "In the chart x = −X/Y, y = −1/Y about a point P to the left of all tangents of an arc, which lies in Y "
    "< 0, the arc is a graph over x: dx/dr = w/Y² with w = [γ, γ′] > 0, and it is convex: y″ = −(Y/w)³ > 0.",
    method=Method.PROOF,
    form="w/Y^2, -(Y/w)^3",
    wrong=("-w/Y^2, -(Y/w)^3", "w/Y^2, (Y/w)^3", "w/Y, -(Y/w)^3", "w/Y^2, -(Y/w)^2", "w/Y^2, -2*(Y/w)^3"),
)
def chart_of_the_arc(form: str) -> Evidence:
    """By affine arc length r, with γ‴ = −kγ′ and [γ′, γ″] = 1.

    P is the origin and to the left of the tangent at γ: [γ′, −γ] = w > 0. Such a P exists near the middle M
    of the chord of a strictly convex arc: [γ′, γᵢ − γ] ≥ 0 for both ends γᵢ and not 0 for both, so M is to
    the left of all tangents, and by compactness so is a point near M on the other side of the chord. The line
    Y = 0 through it is parallel to the chord.
    """
    slope, bend = read_tuple(form, {"w": W, "Y": Y}, 2)
    second = _along(_along(ORDINATE))
    return vanishes(slope - _rate(ABSCISSA), "dx/dr") & vanishes(bend - second, "y″", [UNIT])


@claim(
    "X3.2-5",
    "In that chart the third derivative of y″^(−2/3) = w²/Y² by x is −2 (dk/dr) Y⁴/w: of one sign on an "
    "affine spiral.",
    method=Method.PROOF,
    form="-2*dk_dr*Y^4/w",
    wrong=("2*dk_dr*Y^4/w", "-2*k*Y^4/w", "-dk_dr*Y^4/w", "-2*dk_dr*Y^3/w"),
)
def third_derivative(form: str) -> Evidence:
    """y″ = −(Y/w)³ by X3.2-4, so y″^(−2/3) = w²/Y², which is differentiated three times by d/dx."""
    third = _along(_along(_along(W**2 / Y**2)))
    claimed = read(form, {"dk_dr": k1, "k": k, "Y": Y, "w": W})
    return vanishes(claimed - third, "(y″^(−2/3))‴", [UNIT])


@claim(
    "X3.2-6",
    "In that chart a conic aX² + 2bXY + cY² + 2dX + 2eY + f = 0 about a point P inside it is y = A(x) ± "
    "√B(x), A linear and B quadratic with the leading coefficient (d² − af)/f² > 0 and without real zeros.",
    method=Method.PROOF,
    form="(d^2 - a*f)/f^2",
    wrong=("(d^2 + a*f)/f^2", "(a*f - d^2)/f^2", "(d^2 - a*f)/f", "(d^2 - a*c)/f^2"),
)
def chart_of_the_conic(form: str) -> Evidence:
    """X = x/y, Y = −1/y are put into the equation, times y²: it is quadratic in y, with the leading term f.

    f ≠ 0 as P is not on the conic. Every line through P meets it in two points of the projective plane, as P
    is inside: the lines x = const, so B > 0 for all x, and the line Y = 0, so d² − af > 0. This line cuts the
    conic into two components, and these are the graphs A + √B and A − √B.
    """
    a, b, c, d, e, f = names = sp.symbols("a b c d e f", real=True)
    x, y = sp.symbols("x y", real=True)
    point = {X: x / y, Y: -1 / y}
    conic = a * X**2 + 2 * b * X * Y + c * Y**2 + 2 * d * X + 2 * e * Y + f
    image = sp.Poly(sp.expand(sp.expand(conic.subs(point, simultaneous=True)) * y**2), y)
    second, first, rest = (image.coeff_monomial(y**n) for n in (2, 1, 0))
    under = sp.Poly(sp.expand(first**2 / 4 - second * rest), x)
    linear = sp.degree(sp.expand(first), x) == 1 and under.degree() == 2 and image.degree() == 2
    claimed = read(form, {s.name: s for s in names if s != e})
    found = Evidence(bool(linear), ("the middle of the two y is linear in x, B is quadratic",))
    return (
        found
        & vanishes(second - f, "the coefficient of y²")
        & vanishes(claimed - under.coeff_monomial(x**2) / f**2, "leading coefficient of B")
    )


@claim(
    "X3.2-7",
    "For u = A + √B, A linear and B = b₀ + b₁x + b₂x² > 0, u″ = Δ/(4B^(3/2)) with Δ = 4b₀b₂ − b₁²: so "
    "u″^(−2/3) is a constant times B, quadratic; A − √B is concave.",
    method=Method.PROOF,
    form="(4*b0*b2 - b1^2)/(4*B^(3/2))",
    wrong=(
        "(b1^2 - 4*b0*b2)/(4*B^(3/2))",
        "(4*b0*b2 - b1^2)/(2*B^(3/2))",
        "(4*b0*b2 - b1^2)/(4*B^(1/2))",
        "(b0*b2 - b1^2)/(4*B^(3/2))",
    ),
)
def branch_of_the_conic(form: str) -> Evidence:
    """√B is differentiated twice. Δ > 0 since B has no real zero and b₂ > 0 (X3.2-6)."""
    x, b0, b1, b2 = sp.symbols("x b0 b1 b2", positive=True)
    under = b0 + b1 * x + b2 * x**2
    claimed = read(form, {"b0": b0, "b1": b1, "b2": b2, "B": under})
    cube = sp.simplify((claimed * 4 / (4 * b0 * b2 - b1**2)) ** 2 * under**3)
    return vanishes(claimed - sp.diff(sp.sqrt(under), x, 2), "(√B)″") & vanishes(
        cube - 1, "u″^(−2/3)/B, cubed"
    )
