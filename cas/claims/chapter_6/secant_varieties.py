"""Section 6.2: parametrisations of secant varieties are unstable at the diagonal, but for plane curves."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from itertools import product
from random import Random

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integers, read
from osculant.cas.formulas.expression import ZERO, number
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Version, group
from osculant.cas.germs.immersions import Immersion
from osculant.cas.germs.secants import chord, middle, variety
from osculant.cas.germs.tangent_space import tangent
from osculant.cas.germs.unfolding import is_stable

#: dimensions n and codimensions c of the immersions tried
LARGEST_N, LARGEST_C = 3, 4
#: curves with κ ≠ 0: two with torsion, one without at the point
CURVES = ("t, t**2, t**3", "t, t**2 + t**3, t**3 - 2*t**4", "t, t**2, t**4 + t**5")
#: samples of immersions by (n, c)
SAMPLES = {
    (1, 1): ("t, t**2", "t, t**2 + t**3"),
    (1, 2): CURVES[:2],
    (1, 3): ("t, t**2, t**3, t**4", "t, t**2, t**3 + t**4, t**5"),
    (2, 1): ("x, y, x**2 + y**2", "x, y, x*y", "x, y, x**2 + y**3 + x*y"),
    (2, 2): ("x, y, x**2, x*y + y**3", "x, y, x**2 - y**2, x*y + y**3"),
    (2, 3): ("x, y, x**2 + y**3, x*y, y**2",),
}


def _immersion(n: int, c: int, bent: bool) -> Immersion:
    """The graph of random quadratic forms over Rⁿ; without x₁² if it is not ``bent``."""
    chance = Random(f"{n} {c}")
    names = tuple(f"x{i + 1}" for i in range(n))
    square = poly.monomial((2, *[0] * (n - 1)))
    graph = []
    for _ in range(c):
        terms = [m for m in poly.monomials(n, 2) if poly.degree_of(m, n) > 1]
        g = {m: chance.choice((-3, -2, -1, 1, 2, 3)) for m in terms if bent or m != square}
        graph.append(as_node(g, names))
    plane = [as_node({poly.variable(i, n): 1}, names) for i in range(n)]
    axis = [number(int(i == 0)) for i in range(n)]
    return Immersion([*plane, *graph], names, [ZERO] * n, axis)


def _orbit(germ: Germ) -> int:
    """The A(H)-codimension of the 1-jet among the 1-jets of germs."""
    jet = germ.truncated(1)
    return tangent(jet, group("A(H)"), Version.ORDINARY, 1).annihilator.codimension - germ.p


@claim(
    "proposition 6.2.5",
    "The 1-jets of germs of secant varieties of immersions Rⁿ → R^{n+c} have at least this A(H)-codimension; "
    "a stable germ of 2n + 1 variables has at most 2n (lemma 6.4.1), so those for c > 2 are unstable.",
    method=Method.EXACT,
    form="c*n",
    wrong=("c*n + 1", "c*(n + 1)", "2*n", "(c + 1)*n"),
)
def orbits(form: str) -> Evidence:
    """For n ≤ 3 and c ≤ 4, of a bent graph over the tangent space; of one without x₁² it is larger.

    The 1-jet knows of the graph the coefficients of x₁² only: of other monomials the mean (X(p) + X(q))/2 and
    t times the chord have no terms of degree 1 in (p̄, u, v, t).
    """
    n, c = sp.symbols("n c")
    claimed = read(form, {"n": n, "c": c})
    evidence = Evidence(True)
    for k, codim in product(range(1, LARGEST_N + 1), range(1, LARGEST_C + 1)):
        size, flat = (_orbit(variety(_immersion(k, codim, bent))) for bent in (True, False))
        wanted = claimed.subs({n: k, c: codim})
        right = size == wanted and flat > size and (size > 2 * k) == (codim > 2)
        evidence &= Evidence(bool(right), (f"n = {k}, c = {codim}: {size}; {flat} without x₁²",))
    higher = [(k, m) for k in (1, 2, 3) for m in poly.monomials(k, 5) if poly.degree_of(m, k) > 1]
    silent = all(not any(_first_order(m, k)) for k, m in higher if m != poly.monomial((2, *[0] * (k - 1))))
    return evidence & Evidence(
        silent, (f"{len(higher)} monomials of degrees 2 to 5: x₁² alone is in the 1-jet",)
    )


def _first_order(m: int, n: int) -> Iterator[int]:
    """The monomials of (p̄, λ, v) in the mean and the chord that give terms of degree 1 in (p̄, u, v, t)."""
    for f, most in ((middle({m: 1}, n), 1), (chord({m: 1}, n), 0)):
        for term in f:
            exponents = poly.exponents_of(term, 2 * n)
            if sum(exponents) - exponents[n] + exponents[n] // 2 <= most:
                yield term


@claim(
    "X6.2-1",
    "Of samples of immersions Rⁿ → R^{n+c}, n ≤ 2, c ≤ 3, the secant variety is stable for these n, c alone.",
    method=Method.EXACT,
    form="1, 1",
    wrong=("1, 2", "2, 1", "1, 1, 1, 2", "1, 1, 2, 1"),
)
def stable_varieties(form: str) -> Evidence:
    """Stability for A(H), decided for one to three immersions of each pair of dimensions."""
    counts = _stable_samples()
    found = [size for dimensions, count in counts.items() if count for size in dimensions]
    lines = [f"n = {n}, c = {c}: {count} of {len(SAMPLES[n, c])} stable" for (n, c), count in counts.items()]
    return Evidence(tuple(found) == integers(form), tuple(lines))


@cache
def _stable_samples() -> dict[tuple[int, int], int]:
    """By (n, c), how many of the samples are stable."""

    def stable(text: str, n: int) -> bool:
        return is_stable(variety(Immersion.of(text, "t" if n == 1 else "x y")), "A(H)")

    return {(n, c): sum(stable(text, n) for text in samples) for (n, c), samples in SAMPLES.items()}


@claim(
    "remark 6.2.6",
    "For curves in R³ the germ of the secant variety has this A(H)-codimension.",
    method=Method.EXACT,
    form="infinite",
    wrong=("2", "3", "4"),
)
def curves_in_space(form: str) -> Evidence:
    """Proved for three curves with κ ≠ 0, one of them with τ = 0, by the locus of degenerate points."""
    evidence = Evidence(True)
    for text in CURVES:
        found = codimension(variety(Immersion.of(text, "t")), "A(H)")
        lines = (f"({text}): {found.value}, {found.proof}",)
        evidence &= Evidence(str(found.value) == form.strip(), lines)
    return evidence
