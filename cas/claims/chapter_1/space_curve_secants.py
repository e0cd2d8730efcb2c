"""Section 1.4: the cases of Proposition 1.4.5 on named curves."""

from __future__ import annotations

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import split
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.frenet import frenet
from osculant.cas.germs.immersions import Immersion
from osculant.cas.germs.secants import secant
from osculant.cas.germs.unfolding import is_stable

#: curves, each at t = 0
CURVES = {
    "twisted cubic": "t, t**2, t**3",
    "circular helix": "3*cos(t), 3*sin(t), 4*t",
    "quartic with τ = 0": "t, t**2 + t**3, t**4",
    "quintic with τ = τ′ = 0": "t, t**2, t**5",
    "symmetric quartic": "t, t**2, t**4",
}
#: it is symmetric at t = 0 by a reflection, as the last of those is
VIVIANI = "-cos(t), -sin(t), 2*cos(t/2)"


@claim(
    "X1.4-1",
    "The secant germs at t = 0 of the twisted cubic, the circular helix (3 cos t, 3 sin t, 4t), "
    "(t, t² + t³, t⁴), (t, t², t⁵) and (t, t², t⁴) have these A(H)-codimensions: fold, fold, pitchfork, and "
    "two that are neither.",
    method=Method.EXACT,
    form="0, 0, 1, 2, infinite",
    wrong=("0, 0, 1, 1, infinite", "0, 0, 0, 2, infinite", "0, 1, 1, 2, infinite", "0, 0, 1, 2, 2"),
)
def named_curves(form: str) -> Evidence:
    """The codimension of the secant germ, and the case by the Frenet data of the curve itself.

    The cases agree: fold is codimension 0, pitchfork is codimension 1 and stable, neither is unstable. On
    Viviani's curve, too, τ and 3κτ″ − κ′τ′ are 0 at the point, where a plane reflects it.
    """
    sizes, lines, agree = [], [], True
    for name, text in CURVES.items():
        found = secant(Immersion.of(text, "t"))
        size, data = codimension(found.germ, "A(H)").value, frenet(found.immersion.moved)
        case = {0: "fold", 1: "pitchfork"}.get(size if isinstance(size, int) else -1, "neither")
        agree &= found.settled and data.case == case and is_stable(found.germ, "A(H)") == (case != "neither")
        lines.append(f"{name}: {data.case}, τ = {data.torsion}, 3κτ″ − κ′τ′ = {data.condition}, {size}")
        sizes.append(str(size))
    viviani = frenet(Immersion.of(VIVIANI, "t").moved)
    lines.append(f"Viviani's curve: {viviani.case}, τ′ = {viviani.torsion_slope}")
    return Evidence(agree and viviani.case == "neither" and sizes == split(form, len(CURVES)), tuple(lines))
