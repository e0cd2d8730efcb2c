"""A short checker of the certificates of finite germs, which shares no code with the engine.

Polynomials are dictionaries {exponents: Fraction}, elimination is Gauss's, jets come from sympy. A
certificate numbers its columns so: the monomials by degree, those of a degree in the order of
``combinations_with_replacement`` of the variables; component j of the i-th monomial has column p·i + j.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from itertools import combinations_with_replacement, product
from typing import Any

import sympy

from osculant.certificates import check_algebra, check_tangents
from osculant.certificates.check_loci import check_locus

Exponents = tuple[int, ...]
Polynomial = dict[Exponents, Fraction]
Vector = list[Polynomial]

EXTENDED, ORDINARY, UNIPOTENT = 0, 1, 2
#: group: (source fields, target part)
GROUPS = {
    "R": ("all", "none"),
    "L": ("none", "left"),
    "C": ("none", "contact"),
    "K": ("all", "contact"),
    "A": ("all", "left"),
    "R(H)": ("boundary", "none"),
    "K(H)": ("boundary", "contact"),
    "A(H)": ("boundary", "left"),
}


class RejectedError(Exception):
    """A certificate that does not prove what it should."""


def require(condition: bool, complaint: str) -> None:
    if not condition:
        raise RejectedError(complaint)


@dataclass(frozen=True)
class Problem:
    """A germ, as texts, with a group; u is the boundary variable."""

    components: str
    source: str
    group: str

    @cached_property
    def symbols(self) -> list[sympy.Symbol]:
        return list(sympy.symbols(self.source.split()))

    @cached_property
    def formulas(self) -> list[sympy.Expr]:
        names = dict(zip(self.source.split(), self.symbols))
        found = sympy.sympify(f"[{self.components}]".replace("^", "**"), locals=names, rational=True)
        return [sympy.sympify(f) for f in found]

    @property
    def n(self) -> int:
        return len(self.symbols)

    @property
    def p(self) -> int:
        return len(self.formulas)

    def jet(self, order: int) -> Vector:
        s = sympy.Symbol("_s")
        found = []
        for f in self.formulas:
            if not f.is_polynomial(*self.symbols):
                scaled = f.subs({x: s * x for x in self.symbols}, simultaneous=True)
                f = sympy.series(scaled, s, 0, order + 1).removeO().subs(s, 1)
            terms = sympy.Poly(sympy.expand(f), *self.symbols).terms()
            found.append({e: Fraction(int(c.p), int(c.q)) for e, c in terms if c and sum(e) <= order})
        return found

    def fields(self, version: int) -> list[tuple[int, Exponents]]:
        """(i, α): the fields x^α ∂ᵢ with the least α of each; all others are multiples."""
        kind, boundary = GROUPS[self.group][0], GROUPS[self.group][0] == "boundary"
        found = []
        for i, x in enumerate(self.symbols if kind != "none" else []):
            unit = tuple(int(j == i) for j in range(self.n))
            alone = boundary and str(x) == "u"
            multiples = [e for e in monomials(self.n, 2) if sum(e) == max(0, version - alone)]
            found += [(i, plus(e, unit) if alone else e) for e in multiples]
        return found


@cache
def monomials(n: int, order: int) -> list[Exponents]:
    return [
        tuple(chosen.count(i) for i in range(n))
        for d in range(order + 1)
        for chosen in combinations_with_replacement(range(n), d)
    ]


def plus(a: Exponents, b: Exponents) -> Exponents:
    return tuple(x + y for x, y in zip(a, b))


def times(a: Polynomial, b: Polynomial, order: int) -> Polynomial:
    total: Polynomial = {}
    for (e, c), (g, d) in product(a.items(), b.items()):
        if sum(e) + sum(g) <= order:
            total[plus(e, g)] = total.get(plus(e, g), Fraction(0)) + c * d
    return total


def shifted(f: Polynomial, e: Exponents, order: int) -> Polynomial:
    return {plus(e, g): c for g, c in f.items() if sum(e) + sum(g) <= order}


def derivative(f: Polynomial, i: int) -> Polynomial:
    return {(*e[:i], e[i] - 1, *e[i + 1 :]): c * e[i] for e, c in f.items() if e[i]}


def spanning(problem: Problem, version: int, order: int, target: str | None = None) -> Iterator[Vector]:
    """Vectors that span the tangent space, modulo terms above the order."""
    n, p, every = problem.n, problem.p, monomials(problem.n, order)
    target = target or GROUPS[problem.group][1]
    jet = problem.jet(order + 1)
    done = set()
    for i, least in problem.fields(version):
        image = [derivative(f, i) for f in jet]
        for e in every:
            if (i, plus(least, e)) not in done:
                done.add((i, plus(least, e)))
                yield [shifted(f, plus(least, e), order) for f in image]
    multipliers: list[Polynomial] = []
    if target == "left":
        multipliers = [f for d in range(version, order + 1) for f in products(jet, d, n, order)]
    elif target == "contact":
        multipliers = [shifted(f, e, order) for f in jet for e in every if sum(e) >= version - 1]
    for f, j in product(multipliers, range(p)):
        yield [f if i == j else {} for i in range(p)]


def products(jet: Vector, degree: int, n: int, order: int) -> Iterator[Polynomial]:
    if degree == 0:
        yield {(0,) * n: Fraction(1)}
    for i in range(len(jet)) if degree else ():
        for rest in products(jet[i:], degree - 1, n, order - 1):
            yield times(rest, jet[i], order)


def as_rows(vectors: Iterator[Vector], problem: Problem, order: int) -> list[dict[int, Fraction]]:
    place = {e: i for i, e in enumerate(monomials(problem.n, order))}
    rows = [
        {problem.p * place[e] + j: c for j, f in enumerate(v) for e, c in f.items() if c and sum(e) <= order}
        for v in vectors
    ]
    return [row for row in rows if row]


def pivots(rows: list[dict[int, Any]], prime: int | None = None) -> set[int]:
    """The leading columns of an echelon form, over ℚ or modulo a prime."""
    found: dict[int, dict[int, Any]] = {}
    for row in rows:
        row = dict(row)
        if prime is not None:
            row = {c: v.numerator * pow(v.denominator, -1, prime) % prime for c, v in row.items()}
            row = {c: v for c, v in row.items() if v}
        while row:
            lead = min(row)
            if lead not in found:
                inverse = 1 / row[lead] if prime is None else pow(row[lead], -1, prime)
                found[lead] = {
                    c: v * inverse if prime is None else v * inverse % prime for c, v in row.items()
                }
                break
            factor = row[lead]
            for c, v in found[lead].items():
                value = row.get(c, 0) - factor * v
                row[c] = value if prime is None else value % prime
                if not row[c]:
                    del row[c]
    return set(found)


def contains(rows: list[dict[int, Fraction]], problem: Problem, order: int, least: int) -> bool:
    """Whether every jet with terms of degree ``least`` and more only is in the span, over ℚ."""
    # columns are sorted by degree: rows that lead in the high degrees span the intersection with them
    degrees = [sum(e) for e in monomials(problem.n, order) for _ in range(problem.p)]
    return {c for c, d in enumerate(degrees) if d >= least} <= pivots(rows)


def check_bound(problem: Problem, bound: int) -> None:
    """M^lθ ⊂ T K_e f + M^{l+1}θ, hence M^lθ ⊂ T K_e f."""
    contact = as_rows(spanning(problem, EXTENDED, bound, "contact"), problem, bound)
    require(contains(contact, problem, bound, bound), f"M^{bound}θ is not in T K_e f")


def check_codimension(problem: Problem, extended: bool, value: Any, certificate: dict[str, Any]) -> None:
    """Raises RejectedError unless the certificate proves that the codimension has this value."""
    if certificate["kind"] == "locus":
        require(value == "infinite", "a locus proves only that a codimension is infinite")
        check_infinite(problem, certificate)
        return
    order, prime = certificate["order"], certificate["prime"]
    require(sympy.isprime(prime), f"{prime} is no prime")
    rows = as_rows(spanning(problem, EXTENDED if extended else ORDINARY, order), problem, order)
    columns = problem.p * len(monomials(problem.n, order))
    functionals = [{int(c): Fraction(v) for c, v in f.items()} for f in certificate["functionals"]]
    for f, row in product(functionals, rows):
        require(
            sum((v * f.get(c, 0) for c, v in row.items()), Fraction(0)) == 0, "a functional is not 0 on T"
        )
    require(len(pivots(functionals)) == len(functionals), "the functionals depend on each other")
    rank = len(pivots(rows, prime))
    require(certificate["columns"] == columns, "the number of columns is wrong")
    require(certificate["rank"] == rank, f"the rank modulo {prime} is {rank}, not {certificate['rank']}")
    require(len(functionals) == columns - rank, "there are too few functionals, or too many")
    require(value == len(functionals) - (0 if extended else problem.p), "the codimension is another")
    degrees = [sum(e) for e in monomials(problem.n, order) for _ in range(problem.p)]
    depth = max((degrees[c] for f in functionals for c, v in f.items() if v), default=-1)
    require(certificate["depth"] == depth, f"the functionals live up to degree {depth}")
    bound = certificate["bound"]
    require(depth + max(bound, 1) <= order, "the order of the jets is too small")
    if GROUPS[problem.group][1] == "left":
        check_bound(problem, bound)


def check_determinacy(problem: Problem, degree: Any, certificate: dict[str, Any]) -> None:
    """Raises RejectedError unless the certificate proves the germ to be determined to this degree."""
    if certificate["kind"] == "locus":
        require(degree == "infinite", "a locus proves only that a germ is not finitely determined")
        check_infinite(problem, certificate)
        return
    order, bound = certificate["order"], certificate["bound"]
    require(degree >= 1 and bound >= 1 and degree + bound <= order, "the order of the jets is too small")
    if GROUPS[problem.group][1] == "left":
        check_bound(problem, bound)
    vectors = list(spanning(problem, UNIPOTENT, order))
    vectors += [linear(problem, text, order) for text in certificate["fields"]]
    check_triangular(certificate["fields"])
    rows = as_rows(iter(vectors), problem, order)
    require(contains(rows, problem, order, degree + 1), f"M^{degree + 1}θ is not in the tangent space")


def linear(problem: Problem, text: str, order: int) -> Vector:
    """What a field a∂/∂b, with coordinates of the source or y1, y2, … of the target, adds."""
    a, b = text.split("∂/∂")
    jet, names = problem.jet(order), problem.source.split()
    kind, target = GROUPS[problem.group]
    if a in names:
        require(kind != "none" and not (kind == "boundary" and b == "u"), f"{text} is no field of the group")
        x = tuple(int(i == names.index(a)) for i in range(problem.n))
        return [shifted(derivative(f, names.index(b)), x, order) for f in jet]
    require(target != "none", f"{text} is no field of the group")
    i, j = int(a.removeprefix("y")) - 1, int(b.removeprefix("y")) - 1
    return [jet[i] if c == j else {} for c in range(problem.p)]


def check_triangular(fields: list[str]) -> None:
    """Some order of the coordinates makes all fields strictly triangular: no way leads in a circle."""
    edges = {tuple(text.split("∂/∂")) for text in fields}
    while edges:
        last = {edge for edge in edges if edge[1] not in {a for a, _ in edges}}
        require(bool(last), "the fields are not nilpotent together")
        edges -= last


def check_infinite(problem: Problem, certificate: dict[str, Any]) -> None:
    """Left to osculant's own checker, which shares no code with the engine either."""
    names = problem.source.split()
    given = check_tangents.Problem(
        tuple(map(str, problem.formulas)), tuple(names), "u" if "u" in names else None, problem.group
    )
    try:
        check_locus(given, certificate)
    except check_algebra.RejectedError as error:
        raise RejectedError(str(error)) from error
