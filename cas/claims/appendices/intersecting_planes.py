"""Claims of appendix B.2: the line in which two planes meet."""

from __future__ import annotations

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes
from osculant.cas.claims.vectors import read_vectors
from osculant.cas.numbers.vectors import Vector3, add, cross, dot, scale, subtract


def _generic(name: str) -> Vector3:
    x, y, z = sp.symbols(f"{name}_x {name}_y {name}_z", real=True)
    return x, y, z


P0, P1, U0, U1 = (_generic(name) for name in ("p0", "p1", "U0", "U1"))
PRODUCTS = {
    "u00": dot(U0, U0),
    "u01": dot(U0, U1),
    "u11": dot(U1, U1),
    "delta": dot(cross(U0, U1), cross(U0, U1)),
    "g": dot(subtract(P1, P0), U1),
}


@claim(
    "lemma B.2.1",
    "The planes ⟨p − p₀, U₀⟩ = 0 and ⟨p − p₁, U₁⟩ = 0 meet in the line through "
    "p₀ + γ(−⟨U₀, U₁⟩U₀ + |U₀|²U₁)/|U₀×U₁|², γ = ⟨p₁ − p₀, U₁⟩, with direction U₀×U₁.",
    method=Method.PROOF,
    form="p0 + g/delta*(-u01*U0 + u00*U1), U0xU1",
    wrong=(
        "p0 + g/delta*(u01*U0 + u00*U1), U0xU1",
        "p0 + g/delta*(-u01*U0 + u11*U1), U0xU1",
        "p0 + g/delta*(-u01*U0 + u00*U1), U0 + U1",
        "p0 - g/delta*(-u01*U0 + u00*U1), U0xU1",
    ),
)
def line_of_two_planes(form: str) -> Evidence:
    """A generic point of the line put into (B.1), for generic points and normals.

    (B.1) are the equations of the two planes.
    """
    names = {"p0": P0, "p1": P1, "U0": U0, "U1": U1, "U0xU1": cross(U0, U1)}
    size = sp.Symbol("delta", positive=True)  # |U₀×U₁|², multiplied out
    point, direction = read_vectors(form, {**PRODUCTS, "delta": size}, names, 2)
    on_line = add(point, scale(sp.Symbol("lambda", real=True), direction))
    evidence = Evidence(any(part != 0 for part in direction), ("the direction is not 0 for generic normals",))
    for through, normal, what in ((P0, U0, "|U₀×U₁|²⟨p − p₀, U₀⟩"), (P1, U1, "|U₀×U₁|²⟨p − p₁, U₁⟩")):
        residual = sp.expand(size * dot(subtract(on_line, through), normal))
        evidence &= vanishes(sp.expand(residual.subs(size, PRODUCTS["delta"])), what)
    return evidence


@claim(
    "(B.3)",
    "In p = p₀ + aU₀ + bU₁ + λU₀×U₁ the coefficients are a = −γ⟨U₀, U₁⟩/Δ, b = γ|U₀|²/Δ, "
    "Δ = |U₀|²|U₁|² − ⟨U₀, U₁⟩² = |U₀×U₁|².",
    method=Method.PROOF,
    form="-g*u01/delta, g*u00/delta, u00*u11 - u01**2",
    wrong=(
        "g*u01/delta, g*u00/delta, u00*u11 - u01**2",
        "-g*u01/delta, g*u11/delta, u00*u11 - u01**2",
        "-g*u01/delta, g*u00/delta, u00*u11 + u01**2",
    ),
)
def coefficients(form: str) -> Evidence:
    """Cramer's rule for the linear system that (B.1) gives; Lagrange's identity for Δ."""
    u00, u01, u11, gamma = sp.symbols("u00 u01 u11 g", real=True)
    system = sp.Matrix([[u00, u01], [u01, u11]])
    solution = system.LUsolve(sp.Matrix([0, gamma]))
    names = {"u00": u00, "u01": u01, "u11": u11, "g": gamma, "delta": system.det()}
    first, second, size = read_tuple(form, names, 3)
    evidence = vanishes(first - solution[0], "a") & vanishes(second - solution[1], "b")
    inserted = {a: PRODUCTS[str(a)] for a in (u00, u01, u11)}
    return evidence & vanishes(size.subs(inserted) - PRODUCTS["delta"], "Δ = |U₀×U₁|²")


@claim(
    "(B.2)",
    "U₀, U₁ and U₀×U₁ form a basis if U₀×U₁ ≠ 0: their determinant is |U₀×U₁|².",
    method=Method.PROOF,
    form="delta",
    wrong=("-delta", "u00*u11"),
)
def basis(form: str) -> Evidence:
    """det(U₀, U₁, U₀×U₁) for generic vectors."""
    determinant = sp.Matrix([U0, U1, cross(U0, U1)]).det()
    return vanishes(determinant - read(form, PRODUCTS), "det(U₀, U₁, U₀×U₁)")


@claim(
    "(B.1)",
    "The planes through p₀, p₁ with normals U₀, U₁ have the equations ⟨p − p₀, U₀⟩ = 0, ⟨p − p₁, U₁⟩ = 0.",
    method=Method.PROOF,
    form="p - p0, p - p1",
    wrong=("p + p0, p - p1", "p - p1, p - p0", "p - p0, p", "0*p, p - p1"),
)
def equations_of_planes(form: str) -> Evidence:
    """A generic point of the plane satisfies the equation, and one off it by the normal U does not.

    The points of a plane are q + U×w for any w; the equation takes the value |U|² at q + U.
    """
    w = _generic("w")
    evidence = Evidence(True)
    for i, (q, normal) in enumerate(((P0, U0), (P1, U1))):
        for aside, expected, where in ((cross(normal, w), 0, "in"), (normal, dot(normal, normal), "off")):
            stated = read_vectors(form, {}, {"p": add(q, aside), "p0": P0, "p1": P1}, 2)[i]
            evidence &= vanishes(sp.expand(dot(stated, normal) - expected), f"a point {where} plane {i}")
    return evidence
