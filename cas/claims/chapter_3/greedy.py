"""Claims beyond section 3.1: splines that take the longest arc each time, and what makes them minimal."""

from __future__ import annotations

import random
from collections.abc import Iterator
from functools import cache
from itertools import combinations, pairwise, product
from typing import Any

import sympy as sp
from flint import arb

from osculant.cas.claims.chapter_3.spiral_chords import farther, longest, within
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integers, read_tuple, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.numbers.balls import precision

#: places of the finite models of curves on which all monotone errors are tried
PLACES = 6
#: an inscribed polygon of r = 1 − θ/50 on [0, 6π] with errors below 0.76; widths of the greedy knots' balls
KNOTS, TOLERANCE, WIDTH, GROWTH = ("1.005", "3.723", "6.550", "9.488"), "0.76", "1e-5", 8
#: two arcs from 0 of the same spiral, the longer with the smaller error
FALLS = ("6", "9.4")


@claim(
    "X3.1-1",
    "Let the least error E of an arc be not greater for its sub-arcs, and let a longest arc with E ≤ ε "
    "exist from each start. Then the knots of the spline that takes the longest arc each time are, one by "
    "one, not before those of any other spline with errors ≤ ε from the same start: it has the least number "
    "of pieces.",
    method=Method.PROOF,
    form="every sub-arc",
    wrong=("same start", "no hypothesis"),
)
def greedy(form: str) -> Evidence:
    """Theorem G, by induction: the form says for which sub-arcs E is not greater.

    If the k-th greedy knot g is not before the k-th knot h of another spline whose next knot is h′ > g, then
    E(g, h′) ≤ E(h, h′) ≤ ε as [g, h′] ⊂ [h, h′], so the next greedy knot is not before h′. Arcs without a
    member have E = ∞. Minimal is meant among splines with knots at the ends of the stretch whose pieces have
    their errors counted by E: for conics, biarcs and polygons those over strictly convex arcs.

    All arcs of a curve with six places that can be within ε are tried: the longest arcs of each start grow
    with the start exactly if the hypothesis holds for all sub-arcs. Sub-arcs with the same start are not
    enough.
    """
    models = _models(form)
    worst, tried = None, 0
    for reach in models:
        tried += 1
        if not _is_minimal(reach):
            worst = reach
            break
    line = f"{tried} models of {PLACES} places, E not greater for {form}: "
    if worst is None:
        return Evidence(True, (line + "the greedy knots are the last possible ones",))
    return Evidence(False, (line + f"not so if the places within ε of 0, 1, … are {worst}",))


def _models(form: str) -> Iterator[tuple[tuple[int, ...], ...]]:
    """The ends that are within ε for each start, for all errors that satisfy the hypothesis."""
    ends = [range(i + 1, PLACES) for i in range(PLACES - 1)]
    if form == "no hypothesis":
        choices: list[list[tuple[int, ...]]] = [
            [(i + 1, *more) for n in range(3) for more in combinations(range(i + 2, PLACES), n)]
            for i in range(PLACES - 1)
        ]
        yield from product(*choices)
    elif form in {"same start", "every sub-arc"}:
        for reach in product(*ends):
            if form == "same start" or list(reach) == sorted(reach):
                yield tuple(tuple(range(i + 1, last + 1)) for i, last in enumerate(reach))
    else:
        raise DomainError(
            f"The hypothesis {form!r} is unknown: use 'every sub-arc', 'same start' or 'no hypothesis'."
        )


def _is_minimal(within: tuple[tuple[int, ...], ...]) -> bool:
    """Whether after each number of pieces no spline is farther than the greedy one."""
    at, reached = 0, {0}
    while at < PLACES - 1:
        at = max(within[at])
        reached = {end for start in reached if start < PLACES - 1 for end in within[start]} | {
            place for place in reached if place == PLACES - 1
        }
        if max(reached) > at:
            return False
    return True


@claim(
    "X3.1-2",
    "The largest distance of a strictly convex arc from its chord is not greater for a sub-arc: so the "
    "inscribed polygon that takes the longest edge each time is minimal among those whose edges each span a "
    "strictly convex arc.",
    method=Method.PROOF,
    given=("X3.1-1", "X3.2-2"),
    form="strictly convex",
    wrong=("kappa > 0",),
)
def polygon_monotone(form: str) -> Evidence:
    """Theorem P. No condition on κ′ is needed.

    The line of the sub-arc's chord c′ meets the boundary of the arc's convex hull at the ends of c′ only, as
    both are corners of it (X3.2-2). It cuts the hull into that of the sub-arc and the rest, which contains
    the chord c. For a point p of the sub-arc the segment from p to its nearest point of c lies in the hull
    and ends in the rest, so it meets c′: p is not farther from c′ than from c.

    Exactly, for all sub-arcs of random points in convex position. With κ > 0 alone it fails: on r = 1 − θ/50
    the arc [0, 6] lies farther from its chord than [0, 9.4], in balls.
    """
    if form == "kappa > 0":
        with precision(64):
            start, short, long_ = arb(0), *(arb(t) for t in FALLS)
            bound = arb("1.5")
            refuted = farther(start, short, bound) and within(start, long_, bound)
        line = f"on [0, {FALLS[0]}] a point is farther than 1.5 from the chord, on [0, {FALLS[1]}] none is"
        return Evidence(not refuted, (line,))
    if form != "strictly convex":
        raise DomainError(f"The hypothesis {form!r} is unknown: use 'strictly convex' or 'kappa > 0'.")
    holds, count = _nested_chords()
    return Evidence(holds, (f"{count} pairs of nested chords of points in convex position, exactly",))


@cache
def _nested_chords() -> tuple[bool, int]:
    """Whether the largest distance is not greater for sub-arcs, on points of ellipses and parabolas."""
    source, count, holds = random.Random(7), 0, True
    for number in range(4):
        places = sorted(sp.Rational(source.randint(-60, 60), 17) for _ in range(8))
        points = []
        for t in dict.fromkeys(places):
            round_ = (2 * t / (1 + t * t) * 3, (1 - t * t) / (1 + t * t))
            points.append((t, t * t) if number % 2 else round_)
        spans = [(i, j) for i in range(len(points)) for j in range(i + 2, len(points))]
        error = {span: _farthest(points, *span) for span in spans}
        for (i, j), (a, b) in product(spans, spans):
            if a <= i and j <= b and (i, j) != (a, b):
                count += 1
                holds &= bool(error[i, j] <= error[a, b])
    return holds, count


def _farthest(points: list[tuple[Any, Any]], first: int, last: int) -> Any:
    """The square of the largest distance of the points between from the segment."""
    (ax, ay), (bx, by) = points[first], points[last]
    dx, dy = bx - ax, by - ay
    size, squares = dx * dx + dy * dy, []
    for x, y in points[first + 1 : last]:
        along = min(max((dx * (x - ax) + dy * (y - ay)) / size, 0), 1)
        squares.append((x - ax - along * dx) ** 2 + (y - ay - along * dy) ** 2)
    return max(squares)


@claim(
    "X3.1-3",
    "Beyond strict convexity the inscribed polygon with the longest edge each time need not be minimal: for "
    "r = 1 − θ/50 on [0, 6π] and the tolerance 0.76 it has 7 edges, and 5 suffice.",
    method=Method.ENCLOSURE,
    form="7, 5",
    printed="7, 7",
    wrong=("6, 5", "5, 5", "7, 6", "8, 5", "7, 4"),
    erratum="An earlier version called greedy inscribed polygons minimal between inflections: each edge must "
    "span a strictly convex arc. A spiral of three turns takes 7 edges in that way, while 5 suffice.",
    own=True,
)
def greedy_polygon(form: str) -> Evidence:
    """The form has the numbers of edges of the greedy polygon and of a better one, with four inner knots.

    The knots 1.005, 3.723, 6.550, 9.488 have errors below 0.76, in balls on parts of each arc. A greedy knot
    is enclosed: the arc to the lower end of the ball is within the tolerance, and for every end beyond its
    upper one, to the end of the curve, some point is farther.
    """
    found, better = integers(form, 2)
    edges, lines = _greedy_edges()
    with precision(96):
        end = 6 * arb.pi()
        knots = [arb(0), *(arb(t) for t in KNOTS), end]
        fine = all(within(a, b, arb(TOLERANCE)) for a, b in pairwise(knots))
    line = f"knots 0, {', '.join(KNOTS)}, 6π: {'all' if fine else 'not all'} errors are below {TOLERANCE}"
    return Evidence(found == edges and fine and better == len(knots) - 1, (*lines, line))


@cache
def _greedy_edges() -> tuple[int, tuple[str, ...]]:
    """The number of edges of the greedy polygon and its knots."""
    with precision(96):
        end, tolerance, width = 6 * arb.pi(), arb(TOLERANCE), arb(WIDTH)
        knots = [arb(0)]
        while knots[-1] is not end:
            knots.append(longest(knots[-1], end, tolerance, width))
            width *= GROWTH
        shown = ", ".join(f"{float(knot.mid()):.6g}" for knot in knots)
    return len(knots) - 1, (f"greedy knots, enclosed: {shown}",)


@claim(
    "X3.1-4",
    "If the least error of an arc of length σ from s is e₀(s)σᵖ(1 + O(σ)), uniformly, with e₀ > 0 "
    "continuous, the least number of arcs within ε is ∫e₀^(1/p) ds ε^(−1/p)(1 + o(1)), whether or not E is "
    "monotone.",
    method=Method.PROOF,
    form="e0^(1/p), -1/p",
    wrong=("e0^p, -1/p", "e0^(1/p), 1/p", "e0^(1/p), -p", "2*e0^(1/p), -1/p", "e0, -1/p"),
)
def least_number(form: str) -> Evidence:
    """The form is the integrand g and the power of ε.

    Below: in any spline within ε the arcs tend to length 0, and e₀σᵢᵖ(1 + O(σᵢ)) ≤ ε gives σᵢe₀^(1/p) ≤
    ε^(1/p)(1 + o(1)); the sum over all arcs tends to the integral, as a Riemann sum. Above: with the knots at
    equal parts of the integral all errors are ε(1 + o(1)), and a slightly larger number puts them below ε. In
    the model E = (∫g ds)ᵖ, for which equal parts are exactly the best, both are checked: N arcs have (∫g/N)ᵖ
    = ε, and E of a short arc is g(s)ᵖσᵖ + …, with the next term of order σᵖ⁺¹.
    """
    e0, eps, p, whole = sp.symbols("e0 epsilon p I", positive=True)
    integrand, power = read_tuple(form, {"e0": e0, "p": p}, 2)
    number = whole * eps ** (-1 / p)
    equal = vanishes(sp.powsimp((whole / number) ** p, force=True) - eps, "error of N equal parts against ε")
    scaling = vanishes(power - sp.simplify(sp.diff(sp.log(number), eps) * eps), "power of ε")
    sigma, g, g1 = sp.symbols("sigma g g1", positive=True)
    short = (g * sigma + g1 * sigma**2 / 2) ** p / sigma**p
    leading = sp.simplify(short.subs(g1, 0))
    return equal & scaling & vanishes(leading.subs(g, integrand) - e0, "e₀ of the model against e₀")
