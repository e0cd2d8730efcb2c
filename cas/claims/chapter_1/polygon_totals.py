"""Errors of polygons with n chords or tangents, from the law of one short arc."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.laws.arcs import arc_law

n, J, L, K = sp.symbols("n I lambda K", positive=True)


def total(primitive: str, metric: str) -> Any:
    """ε for n pieces, given the integral I of (|κ|)^{1/p} ds."""
    law = arc_law(primitive, metric)
    # ε = (c^{1/p} J)ᵖ n^{−1/rate}
    return law.constant * J**law.order / n ** (1 / law.rate)
