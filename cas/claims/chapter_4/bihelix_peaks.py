"""Leading errors of the bihelix whose junction lies at vh, and their peaks."""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy as sp

from osculant.cas.asymptotics.bihelix_series import BihelixSeries, bihelix_series

#: the curve at the midpoint (torsion with the usual sign), the torsions of both helices, the offset u = vh of
#: the junction, and the position s = hx; the left helix has the torsion τ + twist·h where that is wanted
_, K, K1, K2, TAU, TAU1, TAU_L, TAU_R, TWIST, V, X = sp.field(
    "kappa, kappa1, kappa2, tau, tau1, tau_L, tau_R, twist, v, x", sp.QQ
)
kappa, kappa1, kappa2, tau, tau1, v, x = (e.as_expr() for e in (K, K1, K2, TAU, TAU1, V, X))
h, sigma = sp.symbols("h sigma", positive=True)


@cache
def spiral() -> BihelixSeries:
    """The generic bihelix: any offset and any two torsions."""
    return bihelix_series([K, K1], [TAU], ([TAU_L], [TAU_R]), [V])


@cache
def normal_part(side: str) -> Any:
    """The leading coefficient, of h³, of the normal component: free of κ, τ and both torsions."""
    return sp.factor(spiral().displacement(side, X)[0][3].as_expr())


def left_peak() -> tuple[Any, Any]:
    """The position and the height of the left lobe's peak for κ′ > 0, as functions of v."""
    left = normal_part("left")
    (peak,) = [root for root in sp.solve(sp.diff(left, x), x) if sp.simplify(root + 1) != 0]
    return peak, sp.factor(left.subs(x, peak))
