"""Remark 3.3.5 with the proof that the thesis omits: a bitangent parabola's error grows with the arc."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import sympy as sp
from flint import arb, fmpq, fmpq_poly

from osculant.cas.claims.chapter_3.parabola_contact import axis, four_points
from osculant.cas.claims.chapter_3.parabolas import CHANGING, E1, E2, PARABOLA, U, X, bitangent_parabola, det
from osculant.cas.claims.chapter_3.sample_arcs import PARTS, growth, monotone_curvature
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import SEXTIC, SPIRAL
from osculant.cas.claims.proof import integers, read, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.numbers.balls import ball, precision

#: the shorter arc's end, and a point where its error is large
SHORTER = (sp.Rational(1, 2), fmpq(-1, 4))


@claim(
    "R3.3-13",
    "If P₂ moves along the curve with velocity λe₂, the bitangent parabola moves with [β′, ∂β/∂s] = 2λ(1 − "
    "κ/κ_P) E "
    "u²(1 − u), κ and κ_P the curvatures of curve and parabola at P₂: inside in one direction everywhere.",
    method=Method.PROOF,
    form="2*lam*(1 - kappa/kappa_P)*E*u**2*(1 - u)",
    wrong=("2*lam*(1 - kappa_P/kappa)*E*u**2*(1 - u)", "2*lam*(1 - kappa/kappa_P)*E*u*(1 - u)**2",
           "2*lam*(1 + kappa/kappa_P)*E*u**2*(1 - u)"),
)  # fmt: skip
def parabola_motion(form: str) -> Evidence:
    """P₁ = P₀ + τe₁ stays on the first tangent and on the tangent [γ − P₁, γ′] = 0 at the moving end γ(s).

    That gives dτ/ds from γ′ = λe₂ and any γ″. By R3.3-11 κ ≠ κ_P where k ≠ 0.
    """
    lam, length = sp.symbols("lam length", positive=True)
    s, tau = sp.symbols("s tau", real=True)
    bend = sp.symbols("w1 w2", real=True)
    end = [w + lam * w * s + z * s**2 / 2 for w, z in zip(E2, bend)]
    velocity = [sp.diff(z, s) for z in end]
    first = [-v for v in E1]
    corner = [p + tau * v for p, v in zip(first, E1)]
    (position,) = sp.solve(det([a - b for a, b in zip(end, corner)], velocity), tau)
    moving = [
        (1 - U) ** 2 * p + 2 * U * (1 - U) * m.subs(tau, position) + U**2 * e
        for p, m, e in zip(first, corner, end)
    ]
    speed = [sp.together(sp.diff(z, s).subs(s, 0)) for z in moving]
    normal = det([sp.diff(z, U) for z in PARABOLA], speed)
    own = [[sp.diff(z, U, n).subs(U, 1) for z in PARABOLA] for n in (1, 2)]
    names = {
        "lam": lam,
        "kappa": det([lam * w for w in E2], bend) / (lam * length) ** 3,
        "kappa_P": det(*own) / (2 * length) ** 3,
        "E": det(E1, E2),
        "u": U,
    }
    relation = (length**2 - E2[0] ** 2 - E2[1] ** 2, length)
    return vanishes(read(form, names) - normal, "[β′, ∂β/∂s]", [relation])


@claim(
    "R3.3-14",
    "Where a parabola moves through parabolas its normal velocity has at most 3 zeros on it, where a conic "
    "moves "
    "through conics at most 4, with multiplicity, unless it is 0 everywhere.",
    method=Method.PROOF,
    form="3, 4",
    wrong=("2, 4", "3, 5", "4, 4"),
)
def velocity_zeros(form: str) -> Evidence:
    """A parabola is an affine image of (t, t²/2), so its velocity is Aα + b; a conic's is ∂F/∂s, quadratic.

    In the parameter of (t, t²/2) and of a rational conic both are polynomials; their degrees are counted.
    """
    t = sp.Symbol("t")
    a = sp.symbols("a0:6")
    point = (t, t**2 / 2)
    moved = [a[2 * i] * point[0] + a[2 * i + 1] * point[1] + a[4 + i] for i in range(2)]
    parabola = sp.Poly(det([sp.diff(z, t) for z in point], moved), t).degree()
    controls = sp.Matrix(3, 3, sp.symbols("c0:9"))
    place = controls * sp.Matrix([(1 - t) ** 2, t * (1 - t), t**2])
    quadratic = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"f{min(i, j)}{max(i, j)}"))
    conic = sp.Poly(sp.expand((place.T * quadratic * place)[0]), t).degree()
    line = f"degrees: {parabola} for the parabola, {conic} for the conic"
    return Evidence((parabola, conic) == integers(form, 2), (line,))


@claim(
    "remark 3.3.5",
    "If k ≠ 0 on the arc, the Hausdorff distance between a sub-arc that starts at a fixed point and its "
    "bitangent "
    "parabola grows strictly with the sub-arc (for turnings below π).",
    method=Method.PROOF,
    form="k != 0",
    printed="k monotone",
    wrong=("kappa != 0",),
    erratum="Remark 3.3.5 states this for affine spirals; it fails where k changes sign inside the arc, and "
    "needs no "
    "monotone k: it holds between the zeros of k.",
)
def parabola_monotone(form: str) -> Evidence:
    """The infinitesimal motion has one sign, so the displacement at every point grows.

    By R3.3-12 the arc is a graph over the axis of each of its bitangent parabolas; by R3.3-11 the parabola
    then has another curvature than the curve at the moving end, and stays on one side of the arc; by
    R3.3-13, in line with R3.3-14 (double zero at the fixed end, simple zero at the moving one), its normal
    velocity vanishes nowhere inside. So at a fixed u the displacement d(u) is strictly monotone in the end
    s, and from d(u) → 0 as s → u it grows in size. The largest |d| grows with it. All four steps are proved
    again here.

    The hypothesis "k monotone" is refuted by a graph with k of both signs: with one end fixed the error of a
    shorter arc exceeds that of a longer one, both in balls.
    """
    if form not in {"k != 0", "k monotone", "kappa != 0"}:
        raise DomainError(f"The hypothesis {form!r} is unknown: use 'k != 0', 'k monotone' or 'kappa != 0'.")
    if form != "k != 0":
        return _shrinking(form)
    found = four_points("k != 0") & axis("-(a + b)*E") & velocity_zeros("3, 4")
    found &= parabola_motion("2*lam*(1 - kappa/kappa_P)*E*u**2*(1 - u)")
    for text, low, high in ((SEXTIC, "-1", "1"), (SPIRAL, "1", "3"), ("t, exp(t)", "-1", "1")):
        found &= growth(text, low, high, "parabolic_form", lambda pencil: pencil.parabola)
    return found


def _shrinking(form: str) -> Evidence:
    """Arcs of the graph `CHANGING` from −1: the longer has the smaller error."""
    graph = read(CHANGING, {"x": X})
    if not monotone_curvature(graph, X, -1, 1):
        return Evidence(False, ("k is not monotone on the example",))
    with precision(64):
        longer, shorter = _error(graph, 1, None), _error(graph, *SHORTER)
    line = (
        f"{form} holds for y = {CHANGING} on [−1, 1], but the parabola's error is ≥ {float(shorter):.6g} on "
        f"[−1, {SHORTER[0]}] and ≤ {float(longer):.6g} on [−1, 1]"
    )
    return Evidence(not shorter > longer, (line,))


def _error(graph: Any, high: Any, at: Any) -> Any:
    """|d| of the bitangent parabola over [−1, high]: a lower bound at a point, or an upper one."""
    low, high = sp.Integer(-1), sp.sympify(high)
    along = sp.Poly(bitangent_parabola(graph, low, high), X)
    # the double zeros at the ends are divided out, so that balls around them are narrow
    ends = sp.Poly((X - low) ** 2 * (X - high) ** 2, X)
    inner, rest = sp.div(along, ends)
    height, up = sp.Symbol("d"), sp.Symbol("y")
    conic = bitangent_parabola(graph, low, high, (X, up))
    slope = sp.diff(graph, X)
    shifted = sp.Poly(
        sp.expand(conic.subs({X: X - slope * height, up: graph + height}, simultaneous=True)), height
    )
    if not rest.is_zero or shifted.degree() != 2:
        raise DomainError(f"The graph y = {graph} has no bitangent parabola over [{low}, {high}].")
    second, first = (_polynomial(shifted.coeff_monomial(height**n)) for n in (2, 1))
    parts = {"ends": _polynomial(ends), "inner": _polynomial(inner), "slope": _polynomial(slope)}

    def size(x: Any) -> Any:
        c, b = _at(parts["ends"], x) * _at(parts["inner"], x), _at(first, x)
        root = (b * b - 4 * _at(second, x) * c).sqrt()
        tilt = _at(parts["slope"], x)
        return abs(2 * c / (abs(b) + root)) * (1 + tilt * tilt).sqrt()

    if at is not None:
        return size(arb(at)).lower()
    knots = [arb(low.p) + (arb(high.p) / high.q - low.p) * i / (32 * PARTS) for i in range(32 * PARTS + 1)]
    return max((size(ball(one, two)).upper() for one, two in pairwise(knots)), key=float)


def _at(polynomial: Any, x: Any) -> Any:
    """The value of a rational polynomial of flint's at a ball, by Horner's rule."""
    value = arb(0)
    for c in reversed(polynomial.coeffs()):
        value = value * x + arb(c)
    return value


def _polynomial(expression: Any) -> Any:
    """A rational polynomial in x as flint's."""
    found = sp.Poly(expression.as_expr() if isinstance(expression, sp.Poly) else expression, X).all_coeffs()
    return fmpq_poly([fmpq(int(k.p), int(k.q)) for k in reversed(found)])
