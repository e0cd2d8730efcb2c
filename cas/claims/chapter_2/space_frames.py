"""The Darboux frame in components along T, N, B, and the derivatives of a curve by arc length."""

from __future__ import annotations

import sympy as sp

from osculant.cas.jets.derivations.space import (
    N,
    beta,
    kappa,
    moved,
    tau,
)
from osculant.cas.numbers.vectors import Vector3, cross, dot

V: Vector3 = (tau / beta, sp.S.Zero, -kappa / beta)
W: Vector3 = cross(V, N)
GAMMA = dot(moved(V), W)
