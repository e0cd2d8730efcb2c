"""The generic plane curve and its frames: v is its speed, and φ³ = [α̇, α̈]."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence
from osculant.cas.claims.proof import all_of, read_tuple, vanishes
from osculant.cas.jets.derivations.plane import Vector, bracket, derivative, phi, v, x, y
from osculant.cas.jets.plane import PlaneJet

GENERIC = PlaneJet(x, y, lambda _, degree: v if degree == 2 else phi)
D = bracket((x[1], y[1]), (x[2], y[2]))
#: what is known of a generic curve's speed v and of φ
CURVE = ((phi**3 - D, phi), (v**2 - x[1] ** 2 - y[1] ** 2, v))
#: [α⁽ⁱ⁾, α⁽ʲ⁾] as bij
BRACKETS = {f"b{i}{j}": bracket((x[i], y[i]), (x[j], y[j])) for i, j in ((1, 2), (1, 3), (2, 3), (1, 4))}
#: κ^{1/3} and its derivatives by s
W = sp.symbols("w:4", positive=True)
PHI = {"phi": phi, "phi1": derivative(phi), "phi2": derivative(derivative(phi))}


def same_vectors(form: str, symbols: dict[str, Any], derived: list[Vector], what: list[str]) -> Evidence:
    """Whether a tuple of vectors, written in vectors and scalars, is what has been derived, on all jets."""
    found = []
    for i in range(2):
        values = {name: s[i] if isinstance(s, tuple) else s for name, s in symbols.items()}
        stated = read_tuple(form, values, len(derived))
        found += [
            vanishes(a - b[i], f"{name}, coordinate {i + 1}", CURVE)
            for a, b, name in zip(stated, derived, what, strict=True)
        ]
    return all_of(found)


def frenet_derivative(vector: Vector) -> Vector:
    """d/ds of aT + bN, given as (a, b), over w, w1, w2, … where w = κ^{1/3} and wᵢ its derivatives by s."""
    a, b = (sum((sp.diff(c, u) * u1 for u, u1 in pairwise(W)), sp.Integer(0)) for c in vector)
    kappa = W[0] ** 3
    return a - kappa * vector[1], b + kappa * vector[0]


def kappas() -> dict[str, Any]:
    """κ and its derivatives by s in terms of w = κ^{1/3}: then κ to the power 1/3 is rational."""
    column = [W[0] ** 3]
    for _ in range(2):
        column.append(sum(sp.diff(column[-1], u) * u1 for u, u1 in pairwise(W)))
    return {"kappa": column[0], "kappa1": column[1], "kappa2": column[2]}


def euclidean_frame() -> tuple[Vector, Vector]:
    """(t, n) by definition, t = dα/dr and n = dt/dr with dr/ds = w, in coordinates along T and N."""
    t = (1 / W[0], sp.Integer(0))
    rate = frenet_derivative(t)
    return t, (rate[0] / W[0], rate[1] / W[0])
