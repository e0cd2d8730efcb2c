"""Section 3.2.1: conics are the curves of constant affine curvature, and what linear maps do to it."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_2.plane_frames import GENERIC
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import all_of, read, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.jets.canonical import affine_arc
from osculant.cas.jets.derivations.plane import Vector, bracket, phi, x, y
from osculant.cas.jets.plane import PlaneJet

X, Y = sp.symbols("x y", real=True)
a, b, c, d, e, f = COEFFICIENTS = sp.symbols("a b c d e f", real=True)
#: the two determinants of a x² + 2b xy + c y² + 2d x + 2e y + f
S = a * c - b**2
T = sp.Matrix([[a, b, d], [b, c, e], [d, e, f]]).det()
EQUATION = a * X**2 + 2 * b * X * Y + c * Y**2 + 2 * d * X + 2 * e * Y + f
#: terms of the series of a curve with constant k that are put into its equation
TERMS = 16


def _flow(order: int) -> list[Vector]:
    """α̇, α̈, … along the conics by the linear flow ẋ = ∂F/∂y, ẏ = −∂F/∂x, in terms of the point."""
    velocity = (sp.diff(EQUATION, Y), -sp.diff(EQUATION, X))
    vectors = [velocity]
    while len(vectors) < order:
        last = vectors[-1]
        vectors.append(
            tuple(sp.expand(sp.diff(u, X) * velocity[0] + sp.diff(u, Y) * velocity[1]) for u in last)
        )
    return vectors


def _conic_jet() -> PlaneJet:
    flow = [(X, Y), *_flow(5)]
    return PlaneJet([p[0] for p in flow], [p[1] for p in flow])


@claim(
    "proposition 3.2.1",
    "The conic ax² + 2bxy + cy² + 2dx + 2ey + f = 0 has affine curvature k = S·(T²)^(-1/3), S = ac − b², T "
    "the 3×3 determinant; that is the printed S·T^(-2/3) with the real cube root of T (its principal power "
    "is not real where T < 0).",
    method=Method.PROOF,
    form="S*(T**2)**(-1/3)",
    wrong=("S*(T**2)**(-2/3)", "-S*(T**2)**(-1/3)", "4*S*(T**2)**(-1/3)", "S*T"),
)
def conic_curvature(form: str) -> Evidence:
    """Along ẋ = ∂F/∂y, ẏ = −∂F/∂x a conic is a linear flow with α⃛ = −4Sα̇, and [α̇, α̈] = 8T on F = 0.

    So n = 3[12](4[23] + [14]) − 5[13]² = 9φ⁸k is 36S[12]² on the jet of that flow, and φ = 2T^(1/3), which
    gives k = n/(9[12]²φ²). T is written τ³ with τ of either sign.
    """
    jet = _conic_jet()
    relation = [(EQUATION, f)]
    tau, s = sp.symbols("tau S", real=True)
    bracket_is = vanishes(jet.inflection_form - 8 * T, "[α̇, α̈] − 8T on the conic", relation)
    numerator = vanishes(jet.parabolic_form - 36 * S * jet.inflection_form**2, "n − 36S[12]²", relation)
    derived = 36 * s / (9 * (2 * tau) ** 2)
    stated = read(form, {"S": s, "T": tau**3})
    return bracket_is & numerator & vanishes(stated - derived, "k")


@claim(
    "section 3.2-1",
    "A curve of constant affine curvature k is a conic: x² + ky² = 2y in its affine frame.",
    method=Method.PROOF,
    form="x**2 + k*y**2 - 2*y",
    wrong=(
        "x**2 - k*y**2 - 2*y",
        "x**2 + k*y**2 - y",
        "x**2 + y**2 - 2*y",
        "0",
        "(x**2 + k*y**2 - 2*y)**2",
    ),
)
def constant_curvature(form: str) -> Evidence:
    """(2.5), γ‴ = −kγ′, gives along t₀ and n₀ x′ = 1 − ky, y′ = x from the start x = y = 0.

    Both equations are seen in the arc's series; the derivative of the stated left side along them is 0, as is
    its value at the start, so it is 0 throughout.
    """
    ring, k = sp.ring("k", sp.QQ)
    along, across, _ = affine_arc(TERMS, [k, *[ring.zero] * (TERMS - 3)])
    residues = (along.derivative() + across * k - 1, across.derivative() - along)
    solved = all(c == 0 for series in residues for c in series.coefficients)
    line = f"x′ = 1 − ky and y′ = x hold for the series of the arc up to order {TERMS - 2}"
    stated = read(form, {"x": X, "y": Y, "k": k.as_expr()})
    degree = sp.Poly(stated, X, Y).total_degree()  # of the equation 0 = 0 it is −∞
    conic = Evidence(degree == 2, (f"the equation is of degree {degree}",))
    rate = sp.diff(stated, X) * (1 - k.as_expr() * Y) + sp.diff(stated, Y) * X
    return (
        Evidence(solved, (line,))
        & conic
        & vanishes(rate, "the left side's derivative along the curve")
        & vanishes(stated.subs({X: 0, Y: 0}), "its value at the start")
    )


@claim(
    "section 3.2-2",
    "A curve of constant affine curvature is an ellipse, a parabola or a hyperbola as k is positive, zero or "
    "negative.",
    method=Method.PROOF,
    form="ellipse, parabola, hyperbola",
    wrong=("hyperbola, parabola, ellipse", "ellipse, hyperbola, parabola"),
)
def type_by_sign(form: str) -> Evidence:
    """The sign of k at a generic point of x²/p² + y²/q² = 1, of y = x²/(2p) and of x²/p² − y²/q² = 1.

    Affine maps keep the type and scale k by a positive factor (Lemma 3.2.2): these three stand for all.
    """
    u, p, q = sp.symbols("u p q", positive=True)
    curves = {
        "ellipse": (p * sp.cos(u), q * sp.sin(u)),
        "parabola": (u, u**2 / (2 * p)),
        "hyperbola": (p * sp.cosh(u), q * sp.sinh(u)),
    }
    stated = [word.strip() for word in form.split(",")]
    if sorted(stated) != sorted(curves):
        raise DomainError(f"The types of conics are {', '.join(curves)}, each once, not {form!r}.")
    found = []
    for kind, wanted in zip(stated, (1, 0, -1), strict=True):
        first, second = ([sp.diff(w, u, i) for i in range(5)] for w in curves[kind])
        jet = PlaneJet(first, second)
        scaled = sp.simplify(jet.parabolic_form)  # 9φ⁸k, of the same sign as k
        line = f"{kind}: 9φ⁸k = {scaled}, of which the sign should be {wanted}"
        found.append(Evidence(bool(sp.sign(scaled) == wanted), (line,)))
    return all_of(found)


@claim(
    "section 3.2-3",
    "An equation and its multiple by λ ≠ 0 have the same S·(T²)^(-1/3), also for λ < 0.",
    method=Method.PROOF,
    form="S*(T**2)**(-1/3)",
    wrong=(
        "S*(T**2)**(-1/2)",
        "S*(T**2)**(-1/3)*T",
        "0",
        "7",
        "2*S*(T**2)**(-1/3)",
        "-S*(T**2)**(-1/3)",
        "S**3*T**(-2)",
    ),
)
def homogeneous(form: str) -> Evidence:
    """S and T of the multiplied equation are computed as λ²S and λ³T, and put into the form with T = τ³.

    That the form is k at all is seen on the circles x² + y² = w⁶ of any radius w³: k from their jet, φ = w².
    """
    factor, tau, s = sp.symbols("lambda tau S", real=True)
    scaled = {g: factor * g for g in COEFFICIENTS}
    degrees = [(S, factor**2, "S"), (T, factor**3, "T")]
    found = [
        vanishes(q.subs(scaled, simultaneous=True) - power * q, f"{name} of the multiple")
        for q, power, name in degrees
    ]
    multiple = read(form, {"S": factor**2 * s, "T": (factor * tau) ** 3})
    found.append(vanishes(multiple - read(form, {"S": s, "T": tau**3}), "k of the multiple"))
    w, u = sp.Symbol("w", positive=True), sp.Symbol("u", real=True)
    circle = {a: 1, b: 0, c: 1, d: 0, e: 0, f: -(w**6)}
    first, second = ([sp.diff(w**3 * g(u), u, i) for i in range(5)] for g in (sp.cos, sp.sin))
    jet = PlaneJet(first, second, lambda *_: w**2)
    found.append(vanishes(jet.inflection_form - w**6, "[α̇, α̈] of the circle"))
    stated = read(form, {"S": S.subs(circle), "T": T.subs(circle)})
    return all_of([*found, vanishes(stated - jet.affine_curvature, "k of the circle")])


def _image() -> tuple[PlaneJet, Any]:
    """The jet of Aα with det A = w³ for a generic A, and w; φ of the image is wφ."""
    w, a11, a12, a21 = sp.symbols("w a11 a12 a21", real=True)
    a22 = (w**3 + a12 * a21) / a11
    first = [a11 * p + a12 * q for p, q in zip(x, y, strict=True)]
    second = [a21 * p + a22 * q for p, q in zip(x, y, strict=True)]
    return PlaneJet(first, second, lambda *_: w * phi), w


@claim(
    "lemma 3.2.2",
    "A linear map A changes affine curvature to (det A)^(-2/3) times that of the preimage (real cube root).",
    method=Method.PROOF,
    form="(det**2)**(-1/3)*k",
    wrong=("(det**2)**(1/3)*k", "(det**2)**(-1/2)*k", "k", "-(det**2)**(-1/3)*k"),
)
def linear_image(form: str) -> Evidence:
    """Brackets of the image are det A times those of the curve: put into k over a generic jet, det A = w³."""
    image, w = _image()
    cube = vanishes(image.inflection_form - w**3 * GENERIC.inflection_form, "[Aα̇, Aα̈] − det A·[α̇, α̈]")
    stated = read(form, {"det": w**3, "k": GENERIC.affine_curvature})
    return cube & vanishes(image.affine_curvature - stated, "k of the image")


@claim(
    "lemma 3.2.2-1",
    "In its proof, for α = Aβ with β by affine arc length, k = (det A)^(-5/3) [Aβ̈, Aβ⃛].",
    method=Method.PROOF,
    form="b23*root**-5",
    wrong=("b23*root**-2", "b23*root**-3"),
)
def linear_image_by_affine_arc_length(form: str) -> Evidence:
    """β̇ = t, β̈ = n, β⃛ = −kt in the frame, mapped by a generic A with det A = w³.

    Affine arc length of the image is r̃ = wr, as [γ′, γ″] = 1 then shows; its k is [γ″, γ‴] by (2.5).
    """
    w, k = sp.symbols("w k", real=True)
    a11, a12, a21 = sp.symbols("a11 a12 a21", real=True)
    matrix = sp.Matrix([[a11, a12], [a21, (w**3 + a12 * a21) / a11]])
    frame = [sp.Matrix([1, 0]), sp.Matrix([0, 1]), sp.Matrix([-k, 0])]  # t, n, −kt
    images = [tuple(matrix * column) for column in frame]
    derived = bracket(tuple(u / w**2 for u in images[1]), tuple(u / w**3 for u in images[2]))
    unit = vanishes(bracket(images[0], images[1]) / w**3 - 1, "[γ′, γ″] with dr̃ = w dr")
    stated = read(form, {"b23": bracket(images[1], images[2]), "root": w})
    return unit & vanishes(stated - derived, "k of the image")
