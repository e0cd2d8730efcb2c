"""Segments of circular helices: end tangents and what joins them, in half angles."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.proof import read
from osculant.cas.numbers.vectors import Vector3, add, cross, scale, subtract

E: Vector3 = (sp.S.One, sp.S.Zero, sp.S.Zero)
F: Vector3 = (sp.S.Zero, sp.S.One, sp.S.Zero)
G: Vector3 = (sp.S.Zero, sp.S.Zero, sp.S.One)
a, b, phi = sp.symbols("a b phi", positive=True)
tau = sp.Symbol("tau", real=True)
c, h = (1 - a**2) / (1 + a**2), 2 * a / (1 + a**2)
k, s = (1 - b**2) / (1 + b**2), 2 * b / (1 + b**2)
t0 = c**2 - h**2
T0, T1 = subtract(scale(c, E), scale(h, G)), add(scale(c, E), scale(h, G))
T1xT0 = cross(T1, T0)
RELATION = (sp.numer(sp.together(tau**2 * s**2 - c**2 + k**2)), tau)
SCALARS = {"t0": t0, "taub": tau, "phi": phi, "c": c, "h": h}
#: (4.11), with R for √(t₀ − cos φ)
H = "(phi*cos(phi/2) - 2*sin(phi/2))*R/(phi*(t0 - cos(phi)) + (1 - t0)*sin(phi))"
VECTORS = {"E": E, "F": F, "G": G, "T0": T0, "T1": T1, "T1xT0": T1xT0}


def half_angles(expression: Any) -> Any:
    """cos φ, sin φ, … of an expression in φ as rational functions."""
    values = {
        sp.cos(phi): k**2 - s**2,
        sp.sin(phi): 2 * k * s,
        sp.cos(phi / 2): k,
        sp.sin(phi / 2): s,
        sp.tan(phi / 2): s / k,
    }
    return sp.sympify(expression).subs(values)


def evaluated(form: str, **more: Any) -> Any:
    """The form in t₀, τ̄, φ and more."""
    return half_angles(read(form, {**SCALARS, **more}))


def segment(c: Any, h: Any, k: Any, s: Any, tau: Any) -> tuple[Vector3, Vector3]:
    """V of lemma 4.3.3 and βS± of corollary 4.2.2 at arc length φ/β, for any c² + h² = k² + s² = 1."""
    first, second = subtract(scale(c, E), scale(h, G)), add(scale(c, E), scale(h, G))
    axis = scale(1 / (2 * c**2), add(scale(tau, add(first, second)), scale(k / s, cross(second, first))))
    span = add(
        scale(tau * phi, axis),
        scale(2 * k * s, subtract(first, scale(tau, axis))),
        scale(2 * s**2, cross(first, axis)),
    )
    return axis, span


V, SPAN = segment(c, h, k, s, tau)
