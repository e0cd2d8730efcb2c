"""Claims of section 3.3 on the conics tangent to an arc at both ends: their pencil, weights and types."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import positive, read, vanishes

#: square roots of sin A, sin B and Q (A, B the angles of the end tangents with the chord), the chord's length
#: and the Bézier parameter: with them all that follows is rational
p, q, g, c, u = sp.symbols("p q g c u", positive=True)
cos_a, cos_b, x, y = sp.symbols("cos_a cos_b x y", real=True)
Q, SIN_A, SIN_B = g**2, p**2, q**2
#: the names that forms may use; ψ = A + B is the turning of the arc
NAMES = {"sin_A": SIN_A, "sin_B": SIN_B, "sin_psi": SIN_A * cos_b + cos_a * SIN_B, "Q": Q, "c": c}
WEIGHT = "sin_psi*sqrt(Q/(sin_A*sin_B))"


def _conic(px: Any, py: Any) -> Any:
    """F at a point, the arc turning left from the origin along a chord of length c on the x-axis."""
    l0 = cos_b * py - SIN_B * (px - c)
    l2 = cos_a * py + SIN_A * px
    return py**2 - 4 * Q * l0 * l2


def _arc(weight: Any, reach: Any) -> tuple[Any, Any]:
    """The rational Bézier arc with that weight and wP₁ = reach·T₀."""
    b0, b1, b2 = (1 - u) ** 2, 2 * u * (1 - u), u**2
    below = b0 + weight * b1 + b2
    return (b1 * reach * cos_a + b2 * c) / below, -b1 * reach * SIN_A / below


def _along(weight: Any, reach: Any) -> Any:
    """F along that arc."""
    return sp.cancel(_conic(*_arc(weight, reach)))


@claim(
    "R3.3-1",
    "The conics tangent to an arc at both ends are the members F = l₁² − 4Q l₀l₂ of a pencil (and the pair "
    "of lines l₀l₂ = 0), where l₀, l₂ vanish on the tangents at the last and first point, l₁ on the chord, "
    "and Q gives the weight of R3.3-2.",
    method=Method.PROOF,
    form="l1**2 - 4*Q*l0*l2",
    wrong=(
        "l1**2 - 4*Q*l0*l1",
        "l0*l1 - 4*Q*l2**2",
        "l1**2 - 400*Q*l0*l2",
        "l1**2 + 4*Q*l0*l2",
    ),
)
def pencil(form: str) -> Evidence:
    """A conic with unknown coefficients vanishes at both ends and has no slope along the end tangents.

    These are four linear equations for six coefficients. Their solutions are a space of dimension 2, and the
    form must lie in it for every Q and not be the same conic for all Q. Which Q is which member is tested on
    the Bézier arc of the weight of R3.3-2, with the distances from the lines for l₀, l₁, l₂.
    """
    p1, p2, q1, q2 = sp.symbols("p1 p2 q1 q2", positive=True)
    ratio = sp.Symbol("Q", positive=True)
    names = sp.symbols("a b c d e f")
    basis = (x**2, x * y, y**2, x, y, sp.Integer(1))
    conic = sum(k * m for k, m in zip(names, basis))
    conditions = []
    for at, direction in (((0, 0), (p1, -p2)), ((c, 0), (q1, q2))):
        slope = sum(sp.diff(conic, v) * along for v, along in zip((x, y), direction))
        conditions += [expression.subs({x: at[0], y: at[1]}) for expression in (conic, slope)]
    matrix = sp.Matrix([[sp.expand(g).coeff(k) for k in names] for g in conditions])
    space = len(names) - matrix.rank()
    lines = {"l0": q1 * y - q2 * (x - c), "l1": y, "l2": p1 * y + p2 * x, "Q": ratio}
    member = sp.Poly(sp.expand(read(form, lines)), x, y)
    vector = sp.Matrix([member.coeff_monomial(m) for m in basis])
    moving = sp.Matrix.hstack(vector, sp.diff(vector, ratio)).rank() == 2
    found = Evidence(
        space == 2 and moving, (f"conics tangent at both ends: a linear space of dimension {space}",)
    )
    for row in matrix * vector:
        found &= vanishes(row, "a condition of tangency on the form")
    weight = read(WEIGHT, NAMES)
    px, py = _arc(weight, weight * c * SIN_B / NAMES["sin_psi"])
    distances = {"l0": cos_b * py - SIN_B * (px - c), "l1": py, "l2": cos_a * py + SIN_A * px, "Q": Q}
    return found & vanishes(sp.cancel(read(form, distances)), "the form along the arc of weight w")


@claim(
    "R3.3-2",
    "The member Q is a rational Bézier arc of weight w = sin ψ √(Q/(sin A sin B)), where A and B are the "
    "angles "
    "of the end tangents with the chord and ψ = A + B is the turning.",
    method=Method.PROOF,
    form="sin_psi*sqrt(Q/(sin_A*sin_B))",
    wrong=(
        "sin_psi*sqrt(Q*sin_A*sin_B)",
        "2*sin_psi*sqrt(Q/(sin_A*sin_B))",
        "sqrt(Q/(sin_A*sin_B))",
        "-sin_psi*sqrt(Q/(sin_A*sin_B))",
    ),
)
def weight(form: str) -> Evidence:
    """P₁ is where the end tangents meet; F vanishes along the Bézier arc with weight w exactly for ±w.

    The weight −w gives the rest of the conic; w has the sign of sin ψ, for the arc to be inside P₀P₁P₂ where
    ψ < π.
    """
    value = read(form, NAMES)
    # P₁ = P₀ + (c sin B/ sin ψ)T₀ by the law of sines in the triangle of the end points and P₁
    reach = value * c * NAMES["sin_B"] / NAMES["sin_psi"]
    sign = positive(sp.cancel(value / NAMES["sin_psi"]), "w/sin ψ")
    return sign & vanishes(_along(value, reach), "F along the Bézier arc")


@claim(
    "R3.3-3",
    "Its middle control vector is wP₁ = wP₀ + V with V = T₀ c √(Q sin B/ sin A), c the chord: finite also "
    "for "
    "parallel end tangents (w = 0) and for arcs that turn by more than π (w < 0).",
    method=Method.PROOF,
    form="c*sqrt(Q*sin_B/sin_A)",
    wrong=("c*sqrt(Q*sin_A/sin_B)", "c*sqrt(Q*sin_B/(4*sin_A))"),
)
def control_vector(form: str) -> Evidence:
    """F along the arc (b₁V + b₂c)/(b₀ + w b₁ + b₂) vanishes with w of R3.3-2, whatever the sign of sin ψ.

    No division by w or sin ψ occurs. The case A + B = π, w = 0 is checked once more by itself.
    """
    reach, w = read(form, NAMES), read(WEIGHT, NAMES)
    general = vanishes(_along(w, reach), "F along the arc with wP₁ = wP₀ + V")
    opposite = {cos_b: -cos_a, q: p}  # B = π − A
    parallel = vanishes(_along(0, reach).subs(opposite), "the same for ψ = π, w = 0")
    return general & parallel & vanishes(w.subs(opposite), "w for ψ = π")


@claim(
    "R3.3-4",
    "The member is an ellipse, a parabola or a hyperbola according as w < 1, w = 1 or w > 1: its quadratic "
    "part "
    "has the determinant 4Q sin A sin B (1 − w²).",
    method=Method.PROOF,
    form="4*Q*sin_A*sin_B*(1 - w**2)",
    wrong=("4*Q*sin_A*sin_B*(1 - w)", "4*Q*sin_A*sin_B*(w**2 - 1)"),
)
def kind(form: str) -> Evidence:
    """The determinant of the second derivatives of F/2 is > 0 for ellipses and < 0 for hyperbolas."""
    determinant = sp.hessian(sp.expand(_conic(x, y)), (x, y)).det() / 4
    claimed = read(form, {**NAMES, "w": read(WEIGHT, NAMES)})
    # cos² = 1 − sin² enters only here
    relations = [(cos_a**2 + SIN_A**2 - 1, cos_a), (cos_b**2 + SIN_B**2 - 1, cos_b)]
    return vanishes(determinant - claimed, "determinant of the quadratic part", relations)


@claim(
    "R3.3-5",
    "The arc of the member between the end points is bounded exactly if w > −1: the least value of its "
    "denominator (1−u)² + 2wu(1−u) + u² is (1 + w)/2 for w < 1, taken in the middle.",
    method=Method.PROOF,
    form="(1 + w)/2",
    wrong=("1 + w", "(1 - w)/2", "w"),
)
def bounded(form: str) -> Evidence:
    """The denominator minus its value in the middle is (1 − w)(2u − 1)²/2.

    That is ≥ 0 for w ≤ 1; for w > 1 the denominator is a sum of non-negative terms that do not vanish
    together.
    """
    w = sp.Symbol("w", real=True)
    below = sp.expand((1 - u) ** 2 + 2 * w * u * (1 - u) + u**2)
    least = read(form, {"w": w})
    square = sp.factor(below - least)
    rest = sp.cancel(square / ((1 - w) * (2 * u - 1) ** 2))
    positive = rest.is_number and rest > 0
    line = f"denominator − least value = {square}"
    return Evidence(bool(positive), (line,)) & vanishes(least - below.subs(u, sp.Rational(1, 2)), "middle")


@claim(
    "R3.3-6",
    "Along the normal F = A d² + B d + C, and the displacement, the root that tends to 0 with C, is "
    "d = −2C/(B + sign(B)√(B² − 4AC)).",
    method=Method.PROOF,
    form="-2*C/(B + sign_B*sqrt(B**2 - 4*A*C))",
    wrong=("-2*C/(B - sign_B*sqrt(B**2 - 4*A*C))", "-2*C/(B + sqrt(B**2 - 4*A*C))"),
)
def displacement_root(form: str) -> Evidence:
    """Both signs of B: the form solves the quadratic equation, and d/C → −1/B as C → 0."""
    a, rest = sp.symbols("a rest", real=True)
    size = sp.Symbol("size", positive=True)
    found = Evidence(True)
    for b in (size, -size):
        d = read(form, {"A": a, "B": b, "C": rest, "sign_B": sp.sign(b)})
        found &= vanishes(a * d**2 + b * d + rest, f"the quadratic equation, B {'>' if b == size else '<'} 0")
        slope = sp.limit(sp.simplify(d.subs(a, 1) / rest), rest, 0)
        agrees = slope.is_finite is not False and sp.simplify(slope + 1 / b) == 0
        found &= Evidence(bool(agrees), (f"d/C → {slope} as C → 0 (A = 1)",))
    return found
