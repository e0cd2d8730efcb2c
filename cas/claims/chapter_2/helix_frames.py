"""The frames of a generalised helix at the start, and what varies along it."""

from __future__ import annotations

import sympy as sp

from osculant.cas.numbers.vectors import Vector3, add, scale

N0: Vector3 = (sp.S.One, sp.S.Zero, sp.S.Zero)
W0: Vector3 = (sp.S.Zero, sp.S.One, sp.S.Zero)
V0: Vector3 = (sp.S.Zero, sp.S.Zero, sp.S.One)
s, C, S = sp.symbols("s C S", real=True)
phis = sp.symbols("phi:4", real=True)  # φ, φ' = β, φ'', φ'''
m = sp.Symbol("m", positive=True)
KAPPAB, TAUB = 2 * m / (1 + m**2), (1 - m**2) / (1 + m**2)
PHI, BETA = phis[0], sp.Symbol("beta", positive=True)
T0 = add(scale(TAUB, V0), scale(KAPPAB, W0))
