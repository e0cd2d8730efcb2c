"""Claims on biarcs and triarcs: chapter 5 as reconstructed, local part; Meek and Walton (thesis 1.3.3)."""

from __future__ import annotations

import mpmath as mp
import sympy as sp
from flint import arb

from osculant.cas.asymptotics.arc_splines import KAPPA, biarc, v, vertex_biarc, x
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import SEXTIC, SPIRAL
from osculant.cas.claims.proof import agrees, read, read_tuple, vanishes
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry.biarcs import equioscillating, member
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.laws.arcs import arc_law
from osculant.cas.laws.complexity import complexity_constant
from osculant.cas.numbers.balls import PRECISION, precision

_k1, _k2 = KAPPA[1], KAPPA[2]
_sigma = sp.Symbol("sigma", positive=True)

#: digits, length and samples of the true biarcs on Archimedes' spiral
DIGITS, LENGTH, SAMPLES = 40, "1e-6", 24


@claim(
    "R5.2-1",
    "On a short arc the normal displacement f of a bitangent biarc has f″ = aᵢ − κ′x on each of its "
    "arcs, with "
    "a₁ = −2κ′/(3(1 + v)), a₂ = 2κ′/(3(1 − v)) for the junction v (lengths in units of half the arc).",
    method=Method.PROOF,
    form="-2*kappa1/(3*(1 + v)) - kappa1*x, 2*kappa1/(3*(1 - v)) - kappa1*x",
    wrong=(
        "-2*kappa1/(3*(1 + v)) + kappa1*x, 2*kappa1/(3*(1 - v)) + kappa1*x",
        "-kappa1/(3*(1 + v)) - kappa1*x, kappa1/(3*(1 - v)) - kappa1*x",
        "-2*kappa1/(3*(1 - v)) - kappa1*x, 2*kappa1/(3*(1 + v)) - kappa1*x",
    ),
)
def curvature_difference(form: str) -> Evidence:
    """Two circular arcs as series in h, from the left end, must arrive at the right end with its tangent.

    Turning and both coordinates determine both curvatures and the second length, coefficient by coefficient.
    Inserting the curve into the circles' equations gives f·h³; the second derivative is taken at the end.
    """
    claimed = read_tuple(form, {"kappa1": _k1, "v": v, "x": x}, 2)
    evidence = Evidence(True)
    for side, found, stated in zip(("left", "right"), biarc().curvature_difference(), claimed, strict=True):
        evidence &= vanishes(stated - found, f"{side} arc, f″")
    return evidence


@claim(
    "R5.2-2",
    "The displacement's peak is (2/81)|κ′|h³(1 + 2|u|/(h + |u|))³ for a junction at distance u from "
    "the middle.",
    method=Method.PROOF,
    form="2/81*kappa1*(1 + 2*u/(1 + u))**3",
    wrong=(
        "2/81*kappa1*(1 + u/(1 + u))**3",
        "2/81*kappa1*(1 + 2*u/(1 + u))**2",
        "1/81*kappa1*(1 + 2*u/(1 + u))**3",
    ),
)
def peak_by_offset(form: str) -> Evidence:
    """For 0 ≤ u = v < 1 the longer, left arc has its only inner extremum at x = (3v − 1)/(3(1 + v)).

    Against its height stand |f(v)| at the junction, and for v < 1/3 the right arc's extremum (for v ≥ 1/3 it
    lies outside): both are less, since the differences are polynomials without zeros for 0 < v < 1.
    """
    heights = []
    for (_, _, f), end in zip(biarc().pieces, (-1, 1), strict=True):
        inner = [r for r in sp.solve(sp.diff(f, x), x) if sp.simplify(r - end) != 0]
        heights.append(sp.factor(f.subs(x, inner[0])))
    left, right = (h.subs(_k1, 1) for h in heights)
    junction = biarc().pieces[0][2].subs({x: v, _k1: 1})
    claimed = read(form, {"kappa1": _k1, "u": v})
    evidence = vanishes(claimed - heights[0], "height of the left peak")
    for what, other, high in (("junction", junction, 1), ("right peak", right, sp.Rational(1, 3))):
        for sign in (1, -1):
            gap = sp.Poly(sp.numer(sp.together(left + sign * other)), v)
            while gap.eval(0) == 0:  # both are equal for the junction in the middle
                gap = gap.quo(sp.Poly(v, v))
            zeros, inside = gap.count_roots(0, high), (left - abs(other)).subs(v, high / sp.Integer(2))
            line = f"left peak {'+-'[sign < 0]} {what}: {zeros} zeros for 0 < v < {high}"
            evidence &= Evidence(bool(zeros == 0 and inside > 0), (line,))
    return evidence


@claim(
    "R5.2-3",
    "The Hausdorff distance of the best bitangent biarc is |κ′|σ³/324 + O(σ⁴); the best junction is "
    "in the middle.",
    method=Method.PROOF,
    form="kappa1*sigma**3/324",
    wrong=("kappa1*sigma**3/162", "kappa1*sigma**2/324", "kappa1*sigma**3/384"),
)
def best_biarc(form: str) -> Evidence:
    """The peak of R5.2-2 grows with |u|: its derivative has no zero for 0 < v < 1.

    At v = 0 the displacement −κ′x(1 − |x|)²h³/6 is odd, so that both peaks, at x = ±1/3, are equal; h = σ/2.
    """
    law = arc_law("biarc")
    f = biarc().pieces[0][2].subs(_k1, 1)
    height = f.subs(x, (3 * v - 1) / (3 * (1 + v)))
    slope = sp.Poly(sp.numer(sp.together(sp.diff(height, v))), v)
    zeros = slope.count_roots(0, 1)
    grows = Evidence(bool(zeros == 0 and slope.eval(0) > 0), (f"derivative of the peak by v: {zeros} zeros",))
    claimed = read(form, {"kappa1": _k1, "sigma": _sigma})
    return grows & vanishes(claimed - law.constant * _k1 * _sigma**law.order, "error of the best biarc")


@claim(
    "R5.2-4",
    "At the junction the biarc's tangent is turned against the curve's by f′(u) = −κ′(h²/6 + u²/2).",
    method=Method.PROOF,
    form="-kappa1*(1/6 + v**2/2)",
    wrong=("-kappa1*(1/6 + v**2)", "-kappa1/6", "kappa1*(1/6 + v**2/2)", "-kappa1*(1/24 + v**2/2)"),
)
def junction_tangent(form: str) -> Evidence:
    """f′ of the displacement of R5.2-1 at the junction, from both sides; in units of h².

    For u = 0 this is the −κ′σ²/24 of the near-optimal junction tangent.
    """
    claimed = read(form, {"kappa1": _k1, "v": v})
    evidence = Evidence(True)
    for side, (_, _, f) in zip(("left", "right"), biarc().pieces, strict=True):
        evidence &= vanishes(claimed - sp.diff(f, x).subs(x, v), f"tangent from the {side}")
    return evidence


@claim(
    "R5.2-5",
    "At a vertex, κ′ = 0, the error is |κ″|σ⁴/384, and both arcs lie on one circle up to that order.",
    method=Method.PROOF,
    form="kappa2*sigma**4/384",
    wrong=("kappa2*sigma**4/192", "kappa2*sigma**3/384", "kappa2*sigma**4/324"),
)
def vertex(form: str) -> Evidence:
    """The contact conditions at κ₁ = 0.

    With κ₁ = 0 the contact conditions give K₁ = K₂ = κ + κ₂h²/6, whatever the junction, and the displacement
    −κ″(1 − x²)²h⁴/24, whose peak is in the middle.
    """
    left, right = (f for _, _, f in vertex_biarc().pieces)
    law = arc_law("vertex biarc")
    claimed = read(form, {"kappa2": _k2, "sigma": _sigma})
    return vanishes(left - right, "left and right arc's displacement") & vanishes(
        claimed - law.constant * _k2 * _sigma**law.order, "error at a vertex"
    )


@claim(
    "R5.2-6",
    "A curve takes 324^(−1/3) ∫|κ′|^(1/3) ds · ε^(−1/3) biarcs, to leading order.",
    method=Method.PROOF,
    given=("X3.1-4",),
    form="324**(-1/3)*I",
    wrong=("324**(-1/2)*I", "162**(-1/3)*I", "324**(1/3)*I"),
)
def complexity(form: str) -> Evidence:
    """Equal errors κ′σ³/324 = ε: σ = (324ε/|κ′|)^{1/3}, and the number of pieces is ∫ds/σ.

    That this is the limit of the least number is X3.1-4. I is the integral.
    """
    integral = sp.Symbol("I", positive=True)
    return vanishes(
        read(form, {"I": integral}) - arc_law("biarc").count_constant(integral), "pieces times ε^{1/3}"
    )


@claim(
    "R5.2-7",
    "The constant is 0.909416 for Archimedes' spiral on [π/6, 2π] and 0.342232 for half of Cayley's sextic.",
    method=Method.NUMERICAL,
    reason="double exponential quadrature in balls; the error of the quadrature itself is estimated, not "
    "enclosed",
    form="0.909416, 0.342232",
    wrong=("0.909416, 0.342332", "0.909426, 0.342232"),
)
def complexity_values(form: str) -> Evidence:
    """∫(|κ′|/324)^{1/3} ds of both curves, κ′ from their jets."""
    spiral, sextic = read_tuple(form, {}, 2)
    with precision(PRECISION):
        ends = {
            SPIRAL: (arb.pi() / 6, 2 * arb.pi()),
            SEXTIC: (arb(0), 3 * arb.pi() / 4),
        }
    evidence = Evidence(True)
    for (text, (low, high)), stated in zip(ends.items(), (spiral, sextic), strict=True):
        value = complexity_constant(CurveBalls(parse_tuple(text)), "biarc", low, high)[0]
        evidence &= agrees(float(stated), float(value), 6, text)
    return evidence


@claim(
    "section 1.3.3-3",
    "Meek and Walton's error of a biarc, (1/324)κ′h³, is that of the best biarc: on Archimedes' "
    "spiral at t = 2.",
    method=Method.NUMERICAL,
    reason="R5.2-3 proves the constant; here true biarcs with 40 digits are measured against it",
    form="1/324",
    wrong=("1/323", "1/384", "1/162"),
)
def true_biarc(form: str) -> Evidence:
    """The equioscillating member of the true family over a length of 1e-6.

    The equioscillating member of the true family over a length of 1e-6, its largest displacement over κ′σ³.
    """
    with mp.workdps(DIGITS):
        t0, length = mp.mpf(2), mp.mpf(LENGTH)
        t1 = mp.findroot(lambda t: mp.quad(lambda s: mp.sqrt(1 + s * s), [t0, t]) - length, t0 + length / 2)

        def curve(t: mp.mpf) -> tuple[mp.mpc, mp.mpc]:
            velocity = mp.expj(t) * (1 + 1j * t)
            return t * mp.expj(t), velocity / abs(velocity)

        (p, T), (q, S) = curve(t0), curve(t1)
        parameters = [t0 + (t1 - t0) * i / SAMPLES for i in range(1, SAMPLES)]
        _, error = equioscillating(lambda mu: member(p, T, q, mp.arg(S / T), mu), curve, parameters)

        def curvature(t: mp.mpf) -> mp.mpf:
            return (2 + t * t) / mp.root(1 + t * t, 2) ** 3

        middle = (t0 + t1) / 2
        slope = abs(mp.diff(curvature, middle)) / mp.sqrt(1 + middle**2)
        claimed = mp.mpf(1) * read(form, {}).p / read(form, {}).q
        return agrees(error / (slope * length**3), claimed, 5, "largest displacement over κ′σ³")


@claim(
    "section 1.3.3-4",
    "Meek and Walton's triarc has the error (1/24)((2√3 − 3)/3)^(3/2) κ′h³.",
    method=Method.PROOF,
    form="((2*sqrt(3) - 3)/3)**(3/2)/24",
    wrong=("((2*sqrt(3) - 3)/3)**(1/2)/24", "(2*sqrt(3) - 3)**(3/2)/24", "((2*sqrt(3) - 3)/3)**(3/2)/12"),
)
def triarc_constant(form: str) -> Evidence:
    """Three arcs, the outer ones on the osculating circles at the ends.

    The contact conditions leave one parameter, the place v where the curve has the middle arc's curvature;
    at v = 0 the displacement is odd. Then the junctions are ±h/√3, and the displacement of the middle arc
    peaks between them.
    """
    law = arc_law("triarc")
    return vanishes(read(form, {}) - law.constant, f"error over κ′σ^{law.order}")
