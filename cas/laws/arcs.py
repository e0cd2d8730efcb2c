"""Error laws c·|κ⁽ⁱ⁾|·σᵖ of polygons, biarcs and triarcs, and the number of pieces that follows from them.

The laws are read off the displacements that `osculant.cas.asymptotics.arc_splines` derives from the contact
conditions. Hausdorff metric: all n pieces have the same error ε, so N(ε) = ∫ (c|κ⁽ⁱ⁾|)^{1/p} ds · ε^{−1/p}.
Area, that of all moons together: with ν pieces per unit of arc length the total is ∫ c|κ⁽ⁱ⁾| ν^{1−p} ds; for
∫ ν ds = n its minimum has ν proportional to (c|κ⁽ⁱ⁾|)^{1/p}, so that ε = (∫ (c|κ⁽ⁱ⁾|)^{1/p} ds)ᵖ n^{1−p}.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Any

import sympy as sp

from osculant.cas.asymptotics.arc_splines import (
    KAPPA,
    Displacement,
    biarc,
    chord,
    tangent,
    triarc,
    v,
    vertex_biarc,
    x,
)
from osculant.cas.errors import DomainError

_SHAPES: dict[str, Callable[[], Displacement]] = {
    "polygon": chord,
    "circumscribed polygon": tangent,
    "biarc": biarc,
    "vertex biarc": vertex_biarc,
    "triarc": triarc,
}


@dataclass(frozen=True)
class ArcLaw:
    """The error of one short arc of length σ: ``constant``·|κ⁽ⁱ⁾|·σ^``order``, i = ``derivative``.

    Args:
        constant: an exact sympy number, for the best junction.
        order: p.
        derivative: how often κ is differentiated by arc length.
        metric: "hausdorff" or "area".
    """

    constant: Any
    order: int
    derivative: int
    metric: str

    @property
    def rate(self) -> Any:
        """The q in N(ε) = C·ε^{−q}: 1/p for the Hausdorff metric, 1/(p − 1) for the area.

        >>> arc_law("biarc").rate, arc_law("polygon", "area").rate
        (1/3, 1/2)
        """
        return sp.Rational(1, self.order if self.metric == "hausdorff" else self.order - 1)

    def count_constant(self, integral: Any) -> Any:
        """C in N(ε) = C·ε^{−q}, given ∫|κ⁽ⁱ⁾|^{1/p} ds.

        >>> arc_law("polygon").count_constant(1)
        sqrt(2)/4
        """
        return sp.root(self.constant, self.order) ** (self.order * self.rate) * integral ** (
            self.order * self.rate
        )


@cache
def arc_law(primitive: str, metric: str = "hausdorff") -> ArcLaw:
    """The law of a primitive: "polygon", "circumscribed polygon", "biarc", "vertex biarc" or "triarc".

    The area of a biarc is that of the junction in the middle, least there among all junctions and the only
    one whose moons are equal; both to leading order, so the biarcs of equal moons and of least area have
    junctions O(h²) apart and areas that differ by a relative O(h²).  The triarc is the symmetric one.

    Raises DomainError for another primitive or metric.

    >>> arc_law("biarc")
    ArcLaw(constant=1/324, order=3, derivative=1, metric='hausdorff')
    >>> arc_law("polygon", "area").constant, arc_law("vertex biarc").constant
    (1/12, 1/384)
    >>> arc_law("biarc", "area").constant
    1/576
    """
    if primitive not in _SHAPES or metric not in {"hausdorff", "area"}:
        raise DomainError(
            f"No error law for {primitive!r} and {metric!r}: choose one of {', '.join(_SHAPES)}."
        )
    shape = at_junction(_SHAPES[primitive](), sp.Integer(0))
    scaled = [sp.Poly(f, *KAPPA) for _, _, f in shape.pieces]
    derivative = next(i for i in range(len(KAPPA)) if scaled[0].degree(KAPPA[i]) > 0)
    unit = Displacement(
        shape.order, tuple((low, high, f.subs(KAPPA[derivative], 1)) for low, high, f in shape.pieces)
    )
    size = moons(unit) if metric == "area" else peak(unit)
    order = shape.order + (metric == "area")
    return ArcLaw(sp.sqrtdenest(sp.radsimp(size / 2**order)), order, derivative, metric)


def at_junction(shape: Displacement, offset: Any) -> Displacement:
    """The displacement for the junction at that offset from the middle, over h, between −1 and 1.

    Raises DomainError if the junction does not lie inside the arc.

    >>> at_junction(biarc(), sp.Rational(1, 2)).pieces[0][:2]
    (-1, 1/2)
    """
    if not -1 < offset < 1:
        raise DomainError(
            f"The junction at {offset} of half the length lies outside: choose one inside (-1, 1)."
        )
    return Displacement(
        shape.order,
        tuple(
            (sp.sympify(low).subs(v, offset), sp.sympify(high).subs(v, offset), sp.sympify(f).subs(v, offset))
            for low, high, f in shape.pieces
        ),
    )


def peak(shape: Displacement) -> Any:
    """sup |f| over all pieces, exact: f has rational or quadratic critical points and no free symbol but x.

    >>> peak(Displacement(2, ((-1, 1, x**2 - x),)))
    2
    """
    heights = []
    for low, high, f in shape.pieces:
        critical = [r for r in sp.roots(sp.diff(f, x), x) if r.is_real and low < r < high]
        heights += [abs(f.subs(x, place)) for place in (low, high, *critical)]
    return max(heights, key=lambda value: sp.N(value, 50))


def moons(shape: Displacement) -> Any:
    """∫|f| over all pieces, exact: the zeros of f are rational or quadratic, no free symbol but x.

    >>> moons(Displacement(2, ((-1, 1, x**3 - x),)))
    1/2
    """
    total = sp.Integer(0)
    for low, high, f in shape.pieces:
        zeros = sorted({r for r in sp.roots(f, x) if r.is_real and low < r < high}, key=lambda r: sp.N(r, 50))
        whole = sp.integrate(sp.expand(f), x)
        heights = [whole.subs(x, place) for place in (low, *zeros, high)]
        total += sum(abs(sp.expand(after - before)) for before, after in pairwise(heights))
    return total
