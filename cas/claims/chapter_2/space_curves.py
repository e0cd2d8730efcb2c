"""Claims of section 2.3.1: Frenet and Darboux frames; the torsion τ is the thesis's, minus the usual one."""

from __future__ import annotations

import sympy as sp

from osculant.cas.claims.chapter_2.space_frames import GAMMA, V, W
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes
from osculant.cas.claims.vectors import read_vectors, same
from osculant.cas.jets.derivations.space import (
    GENERIC,
    RELATION,
    B,
    N,
    T,
    beta,
    by_arc_length,
    kappa,
    kappas,
    moved,
    tau,
    taus,
    turned,
    turned_rate,
    turned_vector,
)
from osculant.cas.numbers.vectors import cross, det, dot, scale

FRENET = {"T": T, "N": N, "B": B}
DARBOUX = {"N": N, "W": W, "V": V}
SCALARS = {"kappa": kappa, "tau": tau, "beta": beta, "kappab": kappa / beta, "taub": tau / beta}

#: α″, α‴, α⁗ by arc length
DERIVATIVES = [scale(kappa, N)]
for _ in range(2):
    DERIVATIVES.append(moved(DERIVATIVES[-1]))

RATIO_SLOPE = by_arc_length(tau / kappa)
JETS = {f"kappa{i}": k for i, k in enumerate(kappas[1:], 1)} | {
    f"tau{i}": t for i, t in enumerate(taus[1:], 1)
}


@claim(
    "(2.13)",
    "Frenet–Serret in the thesis's sign: T' = κN, N' = −κT − τB, B' = τN; its τ is minus the usual torsion.",
    method=Method.PROOF,
    form="kappa*N, -kappa*T - tau*B, tau*N",
    wrong=(
        "kappa*N, -kappa*T + tau*B, -tau*N",
        "kappa*N, kappa*T - tau*B, tau*N",
        "kappa*N, -kappa*T - tau*B, kappa*N",
    ),
)
def frenet(form: str) -> Evidence:
    """T, N, B of a generic jet (any parameter), differentiated and divided by |α̇|.

    κ = |α̇ × α̈|/|α̇|³, τ = −det(α̇, α̈, α⃛)/|α̇ × α̈|². Compared after turning α̇, α̈ into the xy-plane.
    """
    frame = {name: turned_vector(v) for name, v in zip("TNB", GENERIC.frenet_frame)}
    scalars = {"kappa": turned(GENERIC.curvature), "tau": -turned(GENERIC.torsion)}
    return same(
        [turned_rate(v) for v in GENERIC.frenet_frame],
        read_vectors(form, scalars, frame, 3),
        "T', N', B'",
    )


@claim(
    "(2.14)",
    "The unit vector V = (τT − κB)/β, β = √(κ² + τ²), spans the kernel of the Frenet–Serret matrix.",
    method=Method.PROOF,
    form="(tau*T - kappa*B)/beta",
    wrong=("(tau*T + kappa*B)/beta", "(kappa*T - tau*B)/beta", "tau*T - kappa*B", "(kappa*B - tau*T)/beta"),
)
def kernel(form: str) -> Evidence:
    """The matrix with the rows T', N', B' in the frame, times the components of V; |V|²; ⟨V, T⟩ = τ̄."""
    (v,) = read_vectors(form, SCALARS, FRENET, 1)
    matrix = sp.Matrix([moved(T), moved(N), moved(B)])
    image = tuple(matrix * sp.Matrix(v))
    zero = (sp.S.Zero,) * 3
    unit = vanishes(dot(v, v) - 1, "|V|² = 1", [RELATION])
    unit &= vanishes(dot(v, T) - tau / beta, "⟨V, T⟩ = τ̄", [RELATION])
    only = Evidence(matrix.rank() == 2, (f"rank of the matrix: {matrix.rank()}",))
    return same([image], [zero], "matrix times V", [RELATION]) & unit & only


@claim(
    "(2.15)",
    "The third vector of the Darboux frame is W = V × N = κ̄T + τ̄B, κ̄ = κ/β, τ̄ = τ/β.",
    method=Method.PROOF,
    form="kappab*T + taub*B",
    wrong=("kappab*T - taub*B", "-kappab*T - taub*B", "taub*T + kappab*B"),
)
def companion(form: str) -> Evidence:
    """The cross product of V of (2.14) with N, in the positively oriented frame {T, N, B}."""
    return same([cross(V, N)], read_vectors(form, SCALARS, FRENET, 1), "V × N")


@claim(
    "(2.16)",
    "T = τ̄V + κ̄W and B = −κ̄V + τ̄W.",
    method=Method.PROOF,
    form="taub*V + kappab*W, -kappab*V + taub*W",
    wrong=("taub*V - kappab*W, -kappab*V + taub*W", "taub*V + kappab*W, kappab*V + taub*W"),
)
def inverse(form: str) -> Evidence:
    """V and W by (2.14), (2.15), put into the right-hand sides; β² = κ² + τ²."""
    return same([T, B], read_vectors(form, SCALARS, DARBOUX, 2), "T, B", [RELATION])


@claim(
    "section 2.3.1-1",
    "With the Darboux vector Ω = βV = τT − κB: T' = T × Ω, N' = N × Ω, B' = B × Ω.",
    method=Method.PROOF,
    form="tau*T - kappa*B",
    wrong=("kappa*B - tau*T", "tau*T + kappa*B", "kappa*T - tau*B"),
)
def darboux_vector(form: str) -> Evidence:
    """The cross products against the derivatives (2.13), and Ω against βV."""
    (omega,) = read_vectors(form, SCALARS, FRENET, 1)
    products = [cross(v, omega) for v in (T, N, B)]
    along = same([omega], [scale(beta, V)], "Ω = βV")
    return same(products, [moved(v) for v in (T, N, B)], "X × Ω against X'") & along


@claim(
    "lemma 2.3.1.1",
    "The system {N, W, V} is orthonormal and positively oriented: N × W = V.",
    method=Method.PROOF,
    form="V",
    wrong=("-V", "W"),
)
def orientation(form: str) -> Evidence:
    """N × W by components in {T, N, B}; the six inner products."""
    product = same([cross(N, W)], read_vectors(form, SCALARS, DARBOUX, 1), "N × W", [RELATION])
    frame = (N, W, V)
    for i in range(3):
        for j in range(i, 3):
            product &= vanishes(dot(frame[i], frame[j]) - int(i == j), f"⟨{i + 1}, {j + 1}⟩", [RELATION])
    return product


@claim(
    "(2.17)",
    "The Darboux frame moves by N' = −βW, W' = βN − γV, V' = γW, where γ = (τ/κ)'/(1 + (τ/κ)²).",
    method=Method.PROOF,
    form="-beta*W, beta*N - gamma*V, gamma*W",
    wrong=(
        "beta*W, -beta*N - gamma*V, gamma*W",
        "-beta*W, beta*N + gamma*V, gamma*W",
        "-beta*W, beta*N - gamma*V, -gamma*W",
    ),
)
def motion(form: str) -> Evidence:
    """N, W, V in components along {T, N, B}, differentiated by (2.13); κ, τ are generic functions."""
    gamma = RATIO_SLOPE / (1 + (tau / kappa) ** 2)
    stated = read_vectors(form, {**SCALARS, "gamma": gamma}, DARBOUX, 3)
    return same([moved(N), moved(W), moved(V)], stated, "N', W', V'", [RELATION])


@claim(
    "lemma 2.3.1.2",
    "The rate γ of V' = γW is γ = (τ/κ)'/(1 + (τ/κ)²).",
    method=Method.PROOF,
    form="slope/(1 + ratio**2)",
    wrong=("-slope/(1 + ratio**2)", "slope/(1 - ratio**2)", "slope/sqrt(1 + ratio**2)"),
)
def frame_rate(form: str) -> Evidence:
    """⟨V', W⟩ from (2.13) for generic functions κ, τ."""
    stated = read(form, {"slope": RATIO_SLOPE, "ratio": tau / kappa})
    return vanishes((GAMMA - stated).subs(beta, sp.sqrt(kappa**2 + tau**2)), "⟨V', W⟩ against γ")


@claim(
    "lemma 2.3.1.3",
    "The rate γ of V' = γW is also γ = τ̄'/κ̄, and −κ̄'/τ̄ where τ ≠ 0.",
    method=Method.PROOF,
    form="taub1/kappab, -kappab1/taub",
    wrong=("kappab1/taub, -kappab1/taub", "taub1/kappab, kappab1/taub", "taub1/taub, -kappab1/taub"),
)
def frame_rate_from_quotients(form: str) -> Evidence:
    """⟨V', W⟩ from (2.13) against quotients of τ̄' and κ̄'."""
    scalars = {**SCALARS, "taub1": by_arc_length(tau / beta), "kappab1": by_arc_length(kappa / beta)}
    evidence = Evidence(True)
    for stated, name in zip(read_tuple(form, scalars, 2), ("τ̄'/κ̄", "−κ̄'/τ̄"), strict=True):
        evidence &= vanishes(GAMMA - stated, f"⟨V', W⟩ against {name}", [RELATION])
    return evidence


@claim(
    "lemma 2.3.2",
    "(τ/κ)' = −det(α'', α''', α'''')/κ⁵ by arc length, so a curve with κ ≠ 0 is a generalised helix iff "
    "det(α'', α''', α'''') = 0.",
    method=Method.PROOF,
    form="-d/kappa**5",
    wrong=("d/kappa**5", "-d/kappa**6", "-d/kappa**4", "-d/(kappa**2 + tau**2)**(5/2)"),
)
def ratio_slope(form: str) -> Evidence:
    """α'' = κN differentiated twice by (2.13), and the determinant of the components, against (τ/κ)'."""
    stated = read(form, {"d": det(*DERIVATIVES), "kappa": kappa, "tau": tau})
    return vanishes(RATIO_SLOPE - stated, "(τ/κ)' against the determinant")


@claim(
    "lemma 2.3.2.1",
    "In its proof: α''' = κ'N − βκW.",
    method=Method.PROOF,
    form="kappa1*N - beta*kappa*W",
    wrong=("kappa1*N + beta*kappa*W", "kappa1*N - beta*W"),
)
def third_derivative(form: str) -> Evidence:
    """(κN)' by (2.13)."""
    return same([DERIVATIVES[1]], read_vectors(form, {**SCALARS, **JETS}, DARBOUX, 1), "α'''")


@claim(
    "lemma 2.3.2.2",
    "In its proof: α'' × α''' = −βκ²V.",
    method=Method.PROOF,
    form="-beta*kappa**2*V",
    wrong=("beta*kappa**2*V", "-beta*kappa*V", "-beta*kappa**2*W"),
)
def osculating_product(form: str) -> Evidence:
    """The cross product of the components of α'' and α'''."""
    product = cross(DERIVATIVES[0], DERIVATIVES[1])
    return same([product], read_vectors(form, SCALARS, DARBOUX, 1), "α'' × α'''")


@claim(
    "lemma 2.3.2.3",
    "In its proof: ⟨V, α'''⟩ = 0 and ⟨V, α''''⟩ = −⟨V', α'''⟩ = βκγ.",
    method=Method.PROOF,
    form="0, beta*kappa*gamma",
    wrong=("0, -beta*kappa*gamma", "0, beta*gamma", "1, beta*kappa*gamma"),
)
def fourth_derivative(form: str) -> Evidence:
    """Inner products of components; γ = ⟨V', W⟩."""
    third, fourth = read_tuple(form, {**SCALARS, "gamma": GAMMA}, 2)
    evidence = vanishes(dot(V, DERIVATIVES[1]) - third, "⟨V, α'''⟩", [RELATION])
    for value in (dot(V, DERIVATIVES[2]), -dot(moved(V), DERIVATIVES[1])):
        evidence &= vanishes(value - fourth, "⟨V, α''''⟩", [RELATION])
    return evidence


@claim(
    "lemma 2.3.2.4",
    "In its proof: det(α'', α''', α'''') = −β²κ³γ.",
    method=Method.PROOF,
    form="-beta**2*kappa**3*gamma",
    wrong=("beta**2*kappa**3*gamma", "-beta*kappa**3*gamma", "-beta**2*kappa**2*gamma"),
)
def determinant(form: str) -> Evidence:
    """The determinant of the components along {T, N, B}."""
    stated = read(form, {**SCALARS, "gamma": GAMMA})
    return vanishes(det(*DERIVATIVES) - stated, "the determinant", [RELATION])
