"""Claims beyond section 3.3: what displacement is on long arcs, lower bounds by witnesses, sub-arcs."""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from typing import Any

import sympy as sp
from mpmath import mp

from osculant.cas.claims.chapter_3.displacement import displacement_by_q
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import AFFINE_SPIRALS, SEXTIC, SPIRAL
from osculant.cas.claims.proof import integers, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.cas.geometry.moons import least_area, moons
from osculant.cas.jets.plane import PlaneJet

#: a strictly convex arc of Archimedes' spiral that turns by 4.29, members in parts of the largest proper Q,
#: and two places between which the smaller root of F(α + dN) = 0 jumps
LONG, MEMBERS, PLACES = (SPIRAL, "0.2", "3.4"), ("0.381", "0.6119"), ("1.184", "1.1844")
SAMPLES = 160
#: nested sub-arcs in parts of an arc; arcs of the sextic across its sextactic point, one inside the other
NESTED = (("0.3", "0.7"), ("0.3", "0.8"), ("0.1", "0.8"))
ACROSS = (SEXTIC, ("-1", "0.85"), ("-1", "1"))


def _first_hit(pencil: BitangentPencil, t: Any, q: Any) -> Any:
    """Where the normal first meets the member's arc, on the side where it lies; None if it does not."""
    frame, s = pencil.frame(t), pencil.side
    (l0, l1, l2), (n0, n1, n2) = (
        pencil.lines(frame.point),
        pencil.lines((pencil.first.point[0] + frame.normal[0], pencil.first.point[1] + frame.normal[1])),
    )
    # l₀ vanishes at the last point, so its value along a direction is a difference
    n0 -= pencil.lines(pencil.first.point)[0]
    a, b, c = n1**2 - 4 * q * n0 * n2, l1 * n1 - 2 * q * (l0 * n2 + l2 * n0), l1**2 - 4 * q * l0 * l2
    if b * b < a * c:
        return None
    root = mp.sqrt(b * b - a * c)
    hits = []
    for d in ((-b + root) / a, (-b - root) / a):
        inside = s * (l0 + d * n0) > 0 and s * (l2 + d * n2) > 0 and s * (l1 + d * n1) < 0
        if inside and s * d * c > 0:
            hits.append(d)
    return min(hits, key=abs, default=None)


def _long_pencil() -> tuple[BitangentPencil, Any]:
    """The members of the long arc, and the Q of the largest proper one, w = −1."""
    pencil = BitangentPencil(ReferenceCurve(LONG[0]), *LONG[1:])
    return pencil, pencil.sin_a * pencil.sin_b / pencil.sin_psi**2


@cache
def _long_arc() -> tuple[Any, tuple[Any, ...]]:
    """The largest first hit of one member, and the smaller roots of the other at the two places."""
    with mp.workdps(20):
        pencil, largest = _long_pencil()
        fair, jumping = (largest * mp.mpf(part) for part in MEMBERS)
        steps = [pencil.a + (pencil.b - pencil.a) * mp.mpf(i) / SAMPLES for i in range(1, SAMPLES)]
        hits = [_first_hit(pencil, t, fair) for t in steps]
        error = mp.inf if None in hits else max(abs(d) for d in hits)
        roots = tuple(pencil.displacement(mp.mpf(t), jumping).d for t in PLACES)
    return error, roots


@claim(
    "X3.3-2",
    "On long arcs the displacement is the first hit of the normal on the side where the conic lies, not the "
    "smaller root of F(α + dN) = 0: that jumps where ∂F/∂N changes its sign. On Archimedes' spiral over "
    "[0.2, 3.4] a member has first hits below 1.9, while the smaller root of another jumps from 4.2 to −4.2.",
    method=Method.NUMERICAL,
    reason="an example, computed to 20 digits at samples of the arc.",
    form="first hit",
    printed="smaller root",
    wrong=("larger root",),
    erratum="An earlier version took the smaller root for the displacement on every arc: where the foot "
    "passes the evolute, on arcs that turn by more than 3.6 or so, it is the first hit of the "
    "normal on the side where the conic lies.",
    own=True,
)
def first_hit(form: str) -> Evidence:
    """The member with 0.381 of the largest proper Q has first hits below 1.9 at all samples.

    The smaller root of the member with 0.6119 of it is +4.2146 at t = 1.1840 and −4.2141 at 1.1844: it jumps.
    With the first hit d is monotone in Q, as F is at every point, and the old conic of X3.4-4 is met before
    the new one: F changes its sign on the segment up to it.
    """
    error, roots = _long_arc()
    if form not in {"first hit", "smaller root", "larger root"}:
        raise DomainError(f"The reading {form!r} is unknown: use 'first hit' or 'smaller root'.")
    jumps = roots[0] * roots[1] < 0 and min(abs(d) for d in roots) > 4
    line = (
        f"first hits of a member up to {mp.nstr(error, 6)}; smaller roots of another {mp.nstr(roots[0], 6)} "
        f"at t = {PLACES[0]} and {mp.nstr(roots[1], 6)} at {PLACES[1]}"
    )
    good = bool(error < mp.mpf("1.9")) and bool(jumps)
    return Evidence(good if form == "first hit" else not good, (line,))


@claim(
    "X3.3-3",
    "Two witnesses: if F for one member Q₀ has opposite signs on the normal segments |d| ≤ ε at two points "
    "of an arc, and l₀l₂ > 0 there, then every bitangent conic has an error greater than ε.",
    method=Method.PROOF,
    form="opposite signs of F",
    wrong=("opposite signs of d", "equal signs of F"),
)
def two_witnesses(form: str) -> Evidence:
    """∂F/∂Q = −4l₀l₂ < 0 on both segments, so F there is monotone in Q, in one direction.

    Where F > 0 for Q₀ it is so for all Q ≤ Q₀, and where F < 0 for all Q ≥ Q₀: no member meets both segments.
    Neither strict convexity nor an affine spiral is needed. That bounds max|d|; a bound for the Hausdorff
    distance needs common normals. Signs of d do not suffice (X3.3-2), nor do equal signs of F: small Q have F
    > 0 on all segments as short as the best error.
    """
    l0, l1, l2 = sp.symbols("l0 l1 l2", positive=True)
    q = sp.Symbol("Q", positive=True)
    monotone = vanishes(sp.diff(l1**2 - 4 * q * l0 * l2, q) + 4 * l0 * l2, "∂F/∂Q against −4l₀l₂")
    if form == "opposite signs of F":
        return monotone & displacement_by_q("4*f0*f2/root")
    if form == "opposite signs of d":
        error, roots = _long_arc()
        witnesses = roots[0] > 4 and roots[1] < -4
        line = f"d = {mp.nstr(roots[0], 6)} and {mp.nstr(roots[1], 6)}, yet a member has {mp.nstr(error, 6)}"
        return monotone & Evidence(not (witnesses and error < 4), (line,))
    if form == "equal signs of F":
        return monotone & _equal_signs()
    raise DomainError(f"The witnesses {form!r} are unknown: use 'opposite signs of F'.")


def _equal_signs() -> Evidence:
    """A member with F > 0 on two segments, longer than the error of another member."""
    with mp.workdps(15):
        pencil = BitangentPencil(ReferenceCurve(SPIRAL), 1, 2)
        best = pencil.best()
        error, small = pencil.hausdorff(best), best / 2
        signs = set()
        for t in (mp.mpf("1.3"), mp.mpf("1.7")):
            frame = pencil.frame(t)
            for part in range(-4, 5):
                d = error * part / 2
                x, y = (p + d * n for p, n in zip(frame.point, frame.normal))
                l0, l1, l2 = pencil.lines((x, y))
                signs.add(bool(l1**2 - 4 * small * l0 * l2 > 0))
    line = f"Q/2: F of one sign for |d| ≤ {mp.nstr(2 * error, 4)}; the best member has {mp.nstr(error, 4)}"
    return Evidence(len(signs) != 1, (line,))


@claim(
    "X3.3-4",
    "Six witnesses: if F₀ of a conic has alternating signs on the normal segments |d| ≤ ε at six points of "
    "an arc, no conic arc that runs along it within ε, tangent or not, exists; for circles four witnesses "
    "do.",
    method=Method.PROOF,
    form="6, 4",
    wrong=("5, 4", "6, 3", "7, 4", "6, 5"),
)
def six_witnesses(form: str) -> Evidence:
    """A conic arc within ε meets the segments in order, at points where F₀ alternates: one zero in each gap.

    By Bézout's theorem two conics have at most four common points unless they share a component, two circles
    two in the real plane. More zeros make them share one; F₀ ≠ 0 on the segments excludes that for a conic
    that is no pair of lines. The least numbers of witnesses are computed from these bounds: one zero more, in
    one gap less than there are segments. Needs ε below the reach of the curve. No monotone curvature is used,
    and no knots.
    """
    x, y = sp.symbols("x y")
    degrees = [sp.Poly(c, x, y).total_degree() for c in (x**2 + 3 * y**2 - x * y - 1, y**2 - x)]
    common = degrees[0] * degrees[1]
    circles = len(sp.solve([x**2 + y**2 - 1, (x - 1) ** 2 + y**2 - 1], [x, y]))
    needed = common + 2, circles + 2
    line = f"common points at most {common} of conics and {circles} of circles: witnesses {needed}"
    return Evidence(integers(form, 2) == needed, (line,))


@claim(
    "X3.3-5",
    "Reversing an arc keeps its members and k, and changes the sign of dk/dr only: what holds for the "
    "moving end of an affine spiral holds for the moving start.",
    method=Method.PROOF,
    form="1, -1",
    wrong=("-1, -1", "1, 1", "-1, 1"),
)
def reversal(form: str) -> Evidence:
    """k and dk/dr of γ(−t), mirrored so that it turns left again, over those of γ: from a generic jet.

    The mirror image (x, −y) of γ(−t) has [γ′, γ″] of the same sign, as both changes of sign cancel.
    """
    first, second = (sp.symbols(f"{name}1:6", real=True) for name in "xy")
    root = sp.Symbol("phi", positive=True)  # [γ′, γ″]^(1/3)
    jet = PlaneJet((0, *first), (0, *second), lambda *_: root)
    turned = PlaneJet(
        (0, *[(-1) ** (i + 1) * v for i, v in enumerate(first)]),
        (0, *[-((-1) ** (i + 1)) * v for i, v in enumerate(second)]),
        lambda *_: root,
    )
    found = vanishes(turned.inflection_form - jet.inflection_form, "[γ′, γ″]")
    pairs = ((turned.parabolic_form, jet.parabolic_form), (turned.sextactic_form, jet.sextactic_form))
    for sign, (one, other), name in zip(integers(form, 2), pairs, ("k", "dk/dr"), strict=True):
        found &= vanishes(one - sign * other, f"{name} of the reversed arc")
    return found


@claim(
    "X3.3-6",
    "The least distance of a bitangent conic from a strictly convex affine spiral arc, and the least area, "
    "are less for every proper sub-arc, whichever end is moved: so greedy conic splines over such arcs are "
    "minimal.",
    method=Method.PROOF,
    given=("proposition 3.3.4", "X3.4-5", "X3.1-1"),
    form="k monotone",
    wrong=("k != 0",),
)
def sub_arcs(form: str) -> Evidence:
    """E(a′, b′) ≤ E(a, b′) ≤ E(a, b) for [a′, b′] inside [a, b], with one < if the arcs differ.

    The second step is Proposition 3.3.4 (X3.4-5 for areas); the first one is the same for the reversed arc
    (X3.3-5, proved again here). At the ends dk/dr = 0 without six-fold contact, an inflection or a cusp is
    allowed (R3.2-2). Nested sub-arcs of affine spirals agree; across a sextactic point a longer arc is
    better.
    """
    if form not in {"k monotone", "k != 0"}:
        raise DomainError(f"The hypothesis {form!r} is unknown: use 'k monotone' or 'k != 0'.")
    found = reversal("1, -1")
    with mp.workdps(15):
        if form == "k != 0":
            text, *arcs = ACROSS
            errors = [_least(text, low, high)[0] for low, high in arcs]
            line = f"{text} over {arcs[0]} and {arcs[1]}: {', '.join(mp.nstr(e, 5) for e in errors)}"
            return found & Evidence(bool(errors[0] < errors[1]), (line,))
        for text, low, high in AFFINE_SPIRALS:
            a, width = mp.mpf(low), mp.mpf(high) - mp.mpf(low)
            least = [_least(text, *(a + width * mp.mpf(end) for end in ends)) for ends in NESTED]
            grows = all(x < y for one, two in pairwise(least) for x, y in zip(one, two, strict=True))
            line = f"{text}, nested sub-arcs: distances {', '.join(mp.nstr(e, 5) for e, _ in least)}"
            found &= Evidence(grows, (line,))
    return found


def _least(text: str, low: Any, high: Any) -> tuple[Any, Any]:
    """The least distance and the least area."""
    pencil = BitangentPencil(ReferenceCurve(text), low, high)
    area = sum(moons(pencil, pencil.through(least_area(pencil))))
    return pencil.hausdorff(pencil.best()), area
