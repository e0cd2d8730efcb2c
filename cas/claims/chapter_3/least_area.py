"""Beyond section 3.4: a bitangent conic with a fixed crossing, and the least area, as the arc grows."""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from typing import Any

import sympy as sp
from flint import arb
from mpmath import mp

from osculant.cas.claims.chapter_3.parabolas import det
from osculant.cas.claims.chapter_3.sample_arcs import has_no_zero
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import AFFINE_SPIRALS, SEXTIC
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.cas.geometry.moons import least_area, moons
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.numbers.balls import precision

H, LAM, T, TAU = sp.symbols("h lam t tau", positive=True)
M, S, X, Y = sp.symbols("m s x y", real=True)
VELOCITY = "2*h/lam*F_uu*t^2*(1 - t)*(t - tau)/((1 - tau)*B^2)"
#: ends tried on arcs of affine spirals, in parts of the whole arc
ENDS = ("0.5", "0.75", "1")
#: fixed crossings, in parts of the shortest arc; members tried on arcs that conics may cross more often
CROSSINGS, MEMBERS = ("0.4", "0.7"), 12
#: arcs from −1 across a sextactic point, by the hypothesis they satisfy
ACROSS = {"k != 0": SEXTIC, "k has an extremum": "t, t^2/2 + t^6/400"}
#: two ends of theirs: from the first to the second the moon before t = −0.5, or the least area, falls
FALLS = {"moon": ("0.85", "1"), "least": ("0.75", "0.9")}


def _on_conic(t: Any) -> tuple[tuple[Any, Any], Any]:
    """β(t) = (t², 2ht(1−t))/B on y² = 4h²x(1 − x − my), and B."""
    below = (1 - t) ** 2 + 2 * M * H * t * (1 - t) + t**2
    return (t**2 / below, 2 * H * t * (1 - t) / below), below


@claim(
    "X3.4-3",
    "Let the bitangent conic F = 0 of an arc be y² = 4h²x(1 − x − my), by an affine map, with the points "
    "β(t) = (t², 2ht(1−t))/B, B = (1−t)² + 2mht(1−t) + t². If the end β(1) moves along the curve with "
    "velocity λ(m, −1) and the conic goes on through β(τ), then ∂F/∂s = (2h/λ) F_uu t²(1−t)(t−τ)/((1−τ)B²) "
    "at β(t), with F_uu along the curve at the end.",
    method=Method.PROOF,
    form=VELOCITY,
    wrong=(
        "-2*h/lam*F_uu*t^2*(1 - t)*(t - tau)/((1 - tau)*B^2)",
        "2*h/lam*F_uu*t*(1 - t)^2*(t - tau)/((1 - tau)*B^2)",
        "2*h/lam*F_uu*t^2*(1 - t)*(t - tau)/((1 - tau)*B^3)",
        "2*h/lam*F_uu*t^2*(1 - t)/B^2",
    ),
)
def fixed_crossing(form: str) -> Evidence:
    """F = l₁²·(l₀l₂)(c) − l₀l₂·l₁²(c), c = β(τ), with the lines of the moving arc; any second derivative.

    The sign of m is that of π less the turning, so end tangents may be parallel (m = 0) or turn by more. Any
    other family of equations differs by a factor that depends on s only, which changes both sides alike.
    """
    bend = sp.symbols("w1 w2", real=True)
    end = (1 + LAM * M * S + bend[0] * S**2 / 2, -LAM * S + bend[1] * S**2 / 2)
    direction = tuple(sp.diff(z, S) for z in end)
    (crossing, _), (place, below) = _on_conic(TAU), _on_conic(T)

    def lines(p: tuple[Any, Any]) -> tuple[Any, Any, Any]:
        return det(direction, (p[0] - end[0], p[1] - end[1])), det(end, p), det((0, 1), p)

    l0, l1, l2 = lines((X, Y))
    c0, c1, c2 = lines(crossing)
    equation = l1**2 * c0 * c2 - c1**2 * l0 * l2
    at_first = equation.subs(S, 0)
    velocity = sp.diff(equation, S).subs(S, 0).subs({X: place[0], Y: place[1]})
    at_end = sp.diff(at_first.subs({X: end[0], Y: end[1]}), S, 2).subs(S, 0)
    names = {"h": H, "lam": LAM, "t": T, "tau": TAU, "B": below, "F_uu": at_end}
    itself = vanishes(at_first.subs({X: place[0], Y: place[1]}), "F at β(t)")
    return itself & vanishes(read(form, names) - velocity, "∂F/∂s at β(t)")


def _hypothesis(form: str) -> bool:
    """Whether arcs with monotone k are meant; raises DomainError for an unknown hypothesis."""
    if form != "k monotone" and form not in ACROSS:
        known = " or ".join(repr(name) for name in ("k monotone", *ACROSS))
        raise DomainError(f"The hypothesis {form!r} is unknown: use {known}.")
    return form == "k monotone"


def _certain(form: str) -> Evidence:
    """That the arc across a sextactic point is what the form says, in balls.

    Raises UndecidedError if that is not certain: it then refutes nothing.
    """
    text, last = ACROSS[form], FALLS["least"][0]
    with precision(64):
        curve = CurveBalls(parse_tuple(text))
        first, then = (curve.jet(arb(t), 5).sextactic_form for t in ("-1", last))
    if not first * then < 0 or (form == "k != 0" and not has_no_zero(text, "-1", "1", "parabolic_form")):
        raise UndecidedError(f"It is not certain that {form} and dk/dr changes its sign on {text}.")
    return Evidence(True, (f"{text}: {form}, and dk/dr changes its sign between −1 and {last}",))


@cache
def _pencils(text: str, low: str, high: str) -> tuple[BitangentPencil, ...]:
    """The conics of the sub-arcs tried, at 15 digits; they keep the curve's frames."""
    curve, a, b = ReferenceCurve(text), mp.mpf(low), mp.mpf(high)
    return tuple(BitangentPencil(curve, a, a + (b - a) * mp.mpf(part)) for part in ENDS)


@claim(
    "X3.4-4",
    "On a strictly convex affine spiral arc a bitangent conic that keeps its crossing moves away from the "
    "curve everywhere else inside as the sub-arc that starts at a fixed point grows: displacement and both "
    "moons grow strictly.",
    method=Method.PROOF,
    given=("R3.2-2",),
    form="k monotone",
    wrong=("k != 0", "k has an extremum"),
)
def moons_grow(form: str) -> Evidence:
    """Conic and arc meet twice at either end and at the crossing: five times, so not once more (R3.2-2).

    Hence F changes its sign along the curve at the crossing only, and F_uu ≠ 0 at the moving end has the sign
    of F on the curve after the crossing. By X3.4-3, proved again here, ∂F/∂s has the sign of F_uu on the
    conic after the crossing and the opposite one before: on both sides that of F on the curve. So the old
    conic is on the side of the next one where the curve is: it lies between them, on each normal as well, and
    the old moons lie inside the new ones. Arcs of affine spirals then agree, and arcs across a sextactic
    point show that k must be monotone.
    """
    monotone, found = _hypothesis(form), fixed_crossing(VELOCITY)
    with mp.workdps(15):
        if not monotone:
            text = ACROSS[form]
            before = []
            for end in FALLS["moon"]:
                pencil = BitangentPencil(ReferenceCurve(text), "-1", end)
                before.append(moons(pencil, pencil.through("-0.5"))[0])
            line = f"{text} from −1 to {' and '.join(FALLS['moon'])}: moon before t = −0.5 {_row(before)}"
            return found & _certain(form) & Evidence(before[0] < before[1], (line,))
        for arc in AFFINE_SPIRALS:
            found &= Evidence(has_no_zero(*arc, "sextactic_form"), (f"{arc[0]}: dk/dr has no zero",))
            found &= _fixed_crossings_grow(arc)
    return found


def _fixed_crossings_grow(arc: tuple[str, str, str]) -> Evidence:
    """The moons, two of them, and |d| at fixed points, for fixed crossings and growing ends."""
    found, pencils = Evidence(True), _pencils(*arc)
    a, width = pencils[0].a, pencils[0].b - pencils[0].a
    for part in CROSSINGS:
        crossing, seen = a + width * mp.mpf(part), []
        for pencil in pencils:
            q = pencil.through(crossing)
            gaps = [abs(pencil.displacement(a + width * i / 8, q).d) for i in range(1, 8)]
            seen.append((moons(pencil, q), gaps))
        two = all(len(areas) == 2 for areas, _ in seen)
        grow = all(x < y for one, next_ in pairwise(seen) for i in (0, 1) for x, y in zip(one[i], next_[i]))
        rows = "; ".join(_row([areas[i] for areas, _ in seen]) for i in (0, -1))
        line = (
            f"{arc[0]} from t = {arc[1]}, crossing at {mp.nstr(crossing, 5)}: moons {rows}; these and |d| at "
            f"{len(seen[0][1])} points {'grow' if two and grow else 'do not all grow'}"
        )
        found &= Evidence(two and grow, (line,))
    return found


@claim(
    "X3.4-5",
    "The least area between a sub-arc of a strictly convex affine spiral arc that starts at a fixed point "
    "and its bitangent conics grows strictly with the sub-arc.",
    method=Method.PROOF,
    given=("R3.2-2",),
    form="k monotone",
    wrong=("k != 0", "k has an extremum"),
)
def least_grows(form: str) -> Evidence:
    """For the crossing c let A(s; c) be the area at the end s: by X3.4-4 it grows strictly with s > c.

    Five points of the spiral, even confluent ones, determine one conic (R3.2-2), so the conics depend
    continuously on s and c, up to c at an end of the arc, and the least area L(s) is attained and continuous.
    It is not attained with c at an end: there the arc is on one side of the conic, and the area changes to
    first order with Q (R3.3-7). Members that do not cross the arc are farther out still, and the area tends
    to ∞ towards unbounded ones (turnings beyond π). So L(s) = A(s; c) with c < s.
    If L did not grow strictly, L(s) ≥ L(s′) for some s < s′, then L would have its least value on [s, s′] at
    some z > s, with a crossing c < z. For y < z with y > c and y ≥ s the conic through c then gives
    L(y) ≤ A(y; c) < A(z; c) = L(z): a contradiction. That c is unique (conjecture 3.1.2) is not used; going
    from z down to y a bounded member stays bounded, as it moves towards the arc. With
    the largest |d| or the larger moon for the area this proves Propositions 3.3.4 and 3.4.2 as well.

    X3.4-3 is proved again here; on arcs of affine spirals all inequalities of the chain are computed. Across
    a sextactic point a member of a longer arc beats all members tried of a shorter one.
    """
    monotone, found = _hypothesis(form), fixed_crossing(VELOCITY)
    with mp.workdps(15):
        if not monotone:
            text = ACROSS[form]
            least = [_least_tried(BitangentPencil(ReferenceCurve(text), "-1", end)) for end in FALLS["least"]]
            line = f"{text} from −1 to {' and '.join(FALLS['least'])}: least areas {_row(least)}"
            return found & _certain(form) & Evidence(least[0] < least[1], (line,))
        for arc in AFFINE_SPIRALS:
            found &= Evidence(has_no_zero(*arc, "sextactic_form"), (f"{arc[0]}: dk/dr has no zero",))
            found &= _chain(arc)
    return found


def _least_tried(pencil: BitangentPencil) -> Any:
    """The least area of the members through some points of the arc."""
    step = (pencil.b - pencil.a) / MEMBERS
    return min(sum(moons(pencil, pencil.through(pencil.a + step * i))) for i in range(1, MEMBERS))


def _chain(arc: tuple[str, str, str]) -> Evidence:
    """L(y) ≤ A(y; c) < A(z; c) = L(z) for the ends y < z tried and the crossing c of z."""
    pencils = _pencils(*arc)
    best = [(c, sum(moons(pencil, pencil.through(c)))) for pencil in pencils for c in (least_area(pencil),)]
    holds, between = True, []
    for pencil, (_, least), (c, next_) in zip(pencils, best, best[1:]):
        between.append(sum(moons(pencil, pencil.through(c))))
        holds &= bool(c < pencil.b and least <= between[-1] < next_)
    line = (
        f"{arc[0]} from t = {arc[1]}: least areas {_row([area for _, area in best])}; with the next arc's "
        f"crossing {_row(between)}"
    )
    return Evidence(holds, (line,))


def _row(areas: list[Any]) -> str:
    return ", ".join(mp.nstr(area, 6) for area in areas)
