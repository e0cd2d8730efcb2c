"""Chapter 6: secant germs of generic surfaces and their projections (Table 6.1), and what it leaves out."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_6.secant_rows import DIMENSION, rows_of
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integers, read, read_tuple, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.entry import Entry
from osculant.cas.germs.family import Family
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.immersions import Immersion
from osculant.cas.germs.local_algebra import multiplicity
from osculant.cas.germs.parameters import codimension_of_family, moduli
from osculant.cas.germs.reference import reference
from osculant.cas.germs.secants import secant
from osculant.cas.germs.unfolding import is_stable

#: the projection P₃(c), and the same without its first component: the graph of a surface in R⁴
P3, GRAPH = "y, x*y + x**3, x**2*y + c*x**4", "x*y + x**3, x**2*y + c*x**4"


def _codimensions(entry: Entry) -> tuple[int, int, bool]:
    """(A(H)-codimension of the secant germ, A-codimension of the projection, stability) for all signs."""
    found = set()
    for signs, parameters in entry.tried():
        germ, projection = entry.germ(signs, **parameters), entry.projected(signs, **parameters)
        pair = codimension(germ, "A(H)").value, codimension(projection, "A").value
        found.add((*pair, is_stable(germ, "A(H)")))
    if len(found) > 1 or "infinite" in next(iter(found)):
        raise DomainError(f"Row {entry.id} has the codimensions {sorted(map(str, found))}, not one pair.")
    a, b, stable = found.pop()
    return int(a), int(b), stable


@claim(
    "theorem 6.3.1-n5",
    "For n = 5 projections of these multiplicities occur on strata of codimension at most 3.",
    method=Method.EXACT,
    form="2, 3",
    printed="2",
    wrong=("3", "2, 4"),
    erratum=(
        "Theorem 6.3.1 and Remark 6.3.2 (1) leave out, for n = 5, π = (y, xy, x³, x²y + x⁴): it has "
        "A-codimension 6, and its secant germ is stable (orbit 4f of Table 6.2)."
    ),
)
def missing_projection(form: str) -> Evidence:
    """Multiplicities of all projections printed; and of π = (y, xy, x³, x²y + x⁴) if its stratum occurs.

    It occurs if the secant germ of the surface with this projection, and its normal form (v, ȳ, u + x̄²,
    x̄ȳ + x̄³ + vx̄²), are stable, with cod S + cod π − (least cod π) = cod S ≤ 3, and cod π − (n − 2) the same.
    """
    found = {multiplicity(entry.projected(*_first(entry))) for entry in rows_of(5)}
    lines = [f"the rows printed have multiplicities {sorted(found)}"]
    entry = reference("table 6.1")["5-7"]
    size, projection, stable = _codimensions(entry)
    own = secant(Immersion.of("x, y, x*y, x**3, x**2*y + x**4", "x y")).germ
    own_codimension = codimension(own, "A(H)").value
    normal, several = entry.germ(), multiplicity(entry.projected())
    occurs = stable and is_stable(own, "A(H)") and own_codimension == size == projection - 3 <= DIMENSION
    lines.append(
        f"S = {normal} and the secant germ {own}: codimensions {size} and {own_codimension}, stable; "
        f"π = ({entry.projection}): A-codimension {projection}, multiplicity {several}"
    )
    if occurs:
        found.add(several)
    return Evidence(sorted(found) == list(integers(form)), tuple(lines))


def _first(entry: Entry) -> tuple[Any, ...]:
    return (next(entry.tried())[0],)


@claim(
    "theorem 6.3.1-n4",
    "For n = 4 the strata of projections of multiplicity 3 that occur have these codimensions.",
    method=Method.EXACT,
    form="4, 5, 5",
    printed="4, 5",
    wrong=("4, 5, 6", "4, 5, 5, 5"),
    erratum=(
        "Theorem 6.3.1 leaves out, for n = 4, the stratum of π = (y, xy + x³, x²y + cx⁴): A-codimension 6 "
        "with the modulus c, so of codimension 5, which is 3 in the pairs (p, w)."
    ),
)
def missing_stratum(form: str) -> Evidence:
    """A-codimension of P₃(c) and whether c is a modulus, for c indeterminate: over ℚ(c), exactly.

    Its 2-jet (y, xy, 0) is that of the H_k, which the theorem lists; it occurs if secant germs of surfaces
    with this projection are stable.
    """
    printed = [_codimensions(e)[1] for e in rows_of(4) if multiplicity(e.projected(*_first(e))) == 3]
    family = Family(P3, "x y", "c")
    whole = moduli(family, "A")
    member = reference("table 6.1")["4-P_3"]
    size, projection, stable = _codimensions(member)
    several = multiplicity(family.at(c=2))
    lines = (
        f"H_k: codimensions {printed}",
        f"P₃(c): A-codimension {whole.codimension}, {whole.number} modulus, multiplicity {several}; secant "
        f"germ at c = {', '.join(str(v) for v in member.parameters[0].tried)}: codimension {size}, stable",
    )
    if stable and several == 3 and whole.codimension == projection:
        printed.append(whole.stratum)
    return Evidence(tuple(sorted(printed)) == integers(form), lines)


@claim(
    "X6.3-1",
    "P₃(c) = (y, xy + x³, x²y + cx⁴) has A-codimension 6 and is finite unless c is one of these.",
    method=Method.EXACT,
    form="0, 1/2, 1, 3/2",
    wrong=("0, 1/2, 1", "0, 1/2, 3/2", "1/2, 1, 3/2", "0, 1/2, 1, 3/2, 2"),
)
def exceptional_moduli(form: str) -> Evidence:
    """Zeros of the diagonal form over ℚ[c] of the tangent space; and, apart from it, multiple points.

    Pairs x₁ ≠ x₂ with the same image satisfy y = −(x₁² + x₁x₂ + x₂²) and D = 0, where
    D = (x₁ + x₂)((c − 1)(x₁² + x₂²) − x₁x₂); a third point x₃ = −x₁ − x₂ has (c − 1)(x₁² + x₁x₂ + x₂²) = 0
    besides. A germ of corank 1 is finitely determined exactly if the double point curve is reduced and the
    triple points are isolated (Marar and Mond): a discriminant and a resultant say for which c.
    """
    found = codimension_of_family(Family(P3, "x y", "c"), "A", curves=False)
    values = {e.value for e in found.exceptional}
    c, a, b, y = sp.symbols("c a b y")

    def difference(x1: Any, x2: Any) -> Any:
        return sp.cancel(((x1**2 * y + c * x1**4) - (x2**2 * y + c * x2**4)) / (x1 - x2))

    third = -a - b
    solved = -(a**2 + a * b + b**2)
    double = sp.Poly(sp.expand(difference(a, b).subs(y, solved).subs(b, 1)), a)  # homogeneous in a and b
    triple = sp.cancel((difference(a, b) - difference(a, third)) / (b - third)).subs(y, solved).subs(b, 1)
    conditions = sp.discriminant(double, a), sp.resultant(double.as_expr(), sp.expand(triple), a)
    degenerate = {Fraction(str(r)) for condition in conditions for r in sp.roots(sp.Poly(condition, c))}
    claimed = [Fraction(str(part)) for part in read_tuple(form, {})]
    lines = (
        f"A-codimension {found.value} for c indeterminate, in jets of order {found.order}",
        *(f"{e}" for e in found.exceptional),
        f"multiple points degenerate at c = {', '.join(map(str, sorted(degenerate)))}",
    )
    return Evidence(values == degenerate == set(claimed) and len(values) == len(claimed), lines)


@claim(
    "X6.3-2",
    "The secant germ of a surface with the projection P₃(c) has the genotype x((2c − 1)u + (2c − 3)x²)/4.",
    method=Method.EXACT,
    form="x*((2*c - 1)*u + (2*c - 3)*x**2)/4",
    wrong=("x*((2*c - 1)*u + (2*c + 3)*x**2)/4", "x*((2*c - 3)*u + (2*c - 1)*x**2)/4"),
)
def genotype(form: str) -> Evidence:
    """f = (v, f₃, f₄) on v = 0, f₃ = 0, which is solved for y; at as many values of c as its degree wants."""
    x, y, u, c = sp.symbols("x y u c")
    names = {"x": x, "y": y, "u": u}
    claimed = read(form, {"x": x, "u": u, "c": c})
    evidence = Evidence(True)
    for value in (2, -1, 5):
        surface = f"x, y, {GRAPH}".replace("c", f"({value})")
        germ = secant(Immersion.of(surface, "x y")).germ
        third, fourth = (read(text, {**names, "v": sp.Integer(0)}) for text in germ.text(6)[1:])
        (solution,) = sp.solve(third, y)
        evidence &= vanishes(
            sp.expand(fourth.subs(y, solution)) - claimed.subs(c, value), f"genotype at c = {value}"
        )
    return evidence


@claim(
    "remark 6.3.2.1",
    "For n = 4 the projections S_k = (y, x², x³ ± xy^(k+1)) occur for k up to this.",
    method=Method.EXACT,
    form="3",
    printed="4",
    wrong=("2", "5"),
    erratum="Remark 6.3.2 (1) names S₀, …, S₄: S₄ has A-codimension 6, and only S_k with k ≤ 3 are generic.",
)
def crosscaps(form: str) -> Evidence:
    """A-codimension of S_k, k = 0, …, 5, both signs; it occurs if that less n − 2 = 2 is at most 3."""
    largest, lines = -1, []
    for k in range(6):
        found = {codimension(Germ(f"y, x**2, x**3 {s} x*y**{k + 1}", "x y"), "A").value for s in "+-"}
        lines.append(f"S_{k}: A-codimension {', '.join(map(str, found))}")
        if all(size != "infinite" and size - 2 <= DIMENSION for size in found):
            largest = k
    return Evidence((largest,) == integers(form, 1), tuple(lines))
