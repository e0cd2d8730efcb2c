"""Section 6.2: secants through two points, versal where the first one moves as it must, and as bigerms."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import split
from osculant.cas.formulas.expression import ONE, ZERO, Node, number, variable
from osculant.cas.formulas.graph import substitute
from osculant.cas.formulas.parser import parse, parse_tuple
from osculant.cas.germs import multigerm
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.expansion import expanded
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.secants_apart import SecantApart, secant_apart
from osculant.cas.germs.versal import Family

#: coordinates of the velocities tried
VELOCITIES = (-1, 0, 2)


def _curve(velocity: tuple[int, ...]) -> list[Node]:
    """(t, t², t³) up to terms of degree 3 at 0, with the value (−1, 0, 0) and that velocity at 1."""
    t = variable("t")
    found = []
    for i, (value, slope) in enumerate(zip((-1, 0, 0), velocity), start=1):
        alpha = value - 1
        beta = slope - i - 4 * alpha
        found.append(t**i + t**4 * (number(alpha) + number(beta) * (t - 1)))
    return found


def _tangent(velocity: tuple[int, ...]) -> SecantApart:
    """The secants of that curve at 1 and at 0: the tangent at 0 goes through the point at 1."""
    return secant_apart(_curve(velocity), ("t",), [ONE], [ZERO])


@claim(
    "proposition 6.2.4-curves",
    "Let the tangent at q meet a space curve in p: the projection from p has a cusp at q, which the secant "
    "germ unfolds by this multiple of (0, s), if p has the velocity (a, b, c) and the curve is (s, s², s³) "
    "at q; it is versal where that is not 0: where p leaves the osculating plane of q.",
    method=Method.EXACT,
    form="c",
    wrong=("b", "a", "b + c", "c + 1/1000", "-c", "a*c"),
)
def cusps(form: str) -> Evidence:
    """For 26 curves with the distance 1 from p to q: the velocity of the family modulo T A_e of the cusp.

    That has codimension 1, spanned by (0, s), and contains M²θ, the constants and f′ = (2s, 0) + ….
    """
    names = ("a", "b", "c")
    node = parse(form, names)
    evidence = Evidence(True)
    versal = 0
    for velocity in product(VELOCITIES, repeat=3):
        if not any(velocity):
            continue
        found = _tangent(velocity)
        family = Family(found.germ, found.parameters)
        (moved,) = family.velocities(1)
        speed = moved[1].get(poly.variable(0, 1), 0)
        (at,) = substitute([node], {name: number(value) for name, value in zip(names, velocity)})
        claimed = expanded((at,), ("t",), 0)[0].get(0, 0)
        told = found.versality()
        versal += told.versal
        right = Fraction(speed) == claimed and told.codimension == 1 and told.versal == bool(claimed)
        if not right:
            line = f"(a, b, c) = {velocity}: the multiple is {speed}, {'' if told.versal else 'not '}versal"
            return Evidence(False, (line,))
    return evidence & Evidence(
        True, (f"26 velocities: {versal} versal unfoldings of the cusp, the others not",)
    )


@claim(
    "X6.2-2",
    "Secant germs at (p, q) and (q, p) as bigerms have these extended A-codimensions: of a secant that is "
    "tangent nowhere, a bitangent of a plane curve, and a tangent of a space curve that meets it again.",
    method=Method.EXACT,
    form="0, 1, infinite",
    wrong=("0, 0, infinite", "1, 1, infinite", "0, 1, 1", "0, infinite, infinite"),
)
def bigerms(form: str) -> Evidence:
    """Both branches are one germ S up to the exchange of p and q, so their images are equal.

    If S is a submersion the bigerm is stable. Of the third, S has A-codimension 1 and rank 1, so that it is a
    fold (x, y²), and two equal folds have infinite codimension; of the second, S is a Morse function.
    """
    secant = secant_apart(parse_tuple("t, t^2, t^3", ("t",)), ("t",), [ZERO], [ONE])
    bitangent = secant_apart(parse_tuple("t, (t^2 - 1)^2", ("t",)), ("t",), [number(-1)], [ONE])
    tangent = _tangent((-1, 2, 2))
    found = [multigerm.codimension(apart.bigerm, True).value for apart in (secant, bitangent)]
    fold = codimension(tangent.germ, "A").value == 1 == tangent.germ.rank
    one = Germ("x, y**2", "x y")
    twice = multigerm.codimension(multigerm.MultiGerm([one, one]), True)
    lines = (
        f"{secant.germ}: rank {secant.germ.rank}, {found[0]}",
        f"{bitangent.germ}: rank {bitangent.germ.rank}, {found[1]}",
        f"the tangent's germ is {'' if fold else 'not '}a fold; two of them: {twice.value}, {twice.reason}",
    )
    computed = [*map(str, found), str(twice.value)]
    own = [str(apart.bigerm_codimension()) for apart in (secant, bitangent, tangent)]
    return Evidence(fold and computed == own == split(form, 3), lines)
