"""Families of several parameters: their members over ℚ[a], restrictions to zeros, scalings of parameters."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from flint import fmpq, fmpq_poly

from osculant.cas.formulas.expression import to_text
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.family import Family
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.model import ring
from osculant.cas.germs.tangent import JetSpace, Vector


class ManyGerm(Germ):
    """The member of a family for parameters indeterminate: its jets have coefficients in ℚ[a₁, …, a_m].

    For `vectors` of the tangent spaces, which only add and multiply coefficients.
    """

    def __init__(self, family: Family) -> None:
        self.parameters = ring(family.parameters)
        #: by source monomial, polynomials in the parameters
        self.coefficients = tuple(
            {
                m: self.parameters.from_dict({e: _rational(c) for e, c in terms.items()})
                for m, terms in f.items()
            }
            for f in family.coefficients
        )
        super().__init__(
            family.at(**dict.fromkeys(family.parameters, 1)).components, family.source, family.boundary
        )

    def jet(self, order: int) -> tuple[poly.Polynomial, ...]:
        """The components up to that degree, with coefficients in ℚ[a]."""
        return tuple(poly.cut(f, self.n, order) for f in self.coefficients)

    def rows(self, vectors_: Iterable[Vector], order: int) -> list[dict[int, Any]]:
        """Vectors as rows of polynomials in the parameters, in the columns of `JetSpace`."""
        place, p = JetSpace(self.n, self.p, order).place(), self.p
        one = self.parameters.constant(1)
        return [
            row
            for v in vectors_
            if (row := {p * place[m] + j: one * c for j, f in enumerate(v) for m, c in f.items()})
        ]


def _rational(c: int | Fraction) -> fmpq:
    q = Fraction(c)
    return fmpq(q.numerator, q.denominator)


def text(q: Any) -> str:
    """A polynomial, with integers without a common factor as coefficients, as a formula."""
    coefficients = q.coeffs()
    common = lcm(*(int(c.q) for c in coefficients))
    content = gcd(*(int(c.p) * (common // int(c.q)) for c in coefficients))
    factor = Fraction(common, content) * (-1 if q.leading_coefficient() < 0 else 1)
    return str(q * _rational(factor)).replace("^", "**")


def linear(q: Any) -> tuple[int, Any, Any] | None:
    """(i, u, v) with q = u·aᵢ + v, u of the least degree; None if q is linear in no parameter."""
    gens, found = q.context().gens(), []
    for i, degree in enumerate(q.degrees()):
        if degree == 1:
            u = q.derivative(i)
            found.append((u.total_degree(), i, u, q - u * gens[i]))
    return min(found, key=lambda f: f[:2])[1:] if found else None


def restricted(family: Family, q: Any, rest: Sequence[Any]) -> tuple[Family | Germ, list[Any]]:
    """(the family on q = u·aᵢ + v = 0 where u is not 0, in the other parameters; the rest there).

    Components are multiplied by powers of u, where it is no constant; a germ if no parameter is left.

    >>> a, b = ring(["a", "b"]).gens()
    >>> family = Family("a*x**2 + b*x**3", "x", "a b")
    >>> print(restricted(family, a - b**2, [a * b])[0])
    (x**2*b**2 + x**3*b)
    """
    found = linear(q)
    assert found is not None
    i, u, v = found
    names = family.parameters
    left = tuple(name for k, name in enumerate(names) if k != i)
    context = ring(left)
    gens = list(context.gens())
    images = [*gens[:i], context.constant(0), *gens[i:]]
    unit, other = u.compose(*images, ctx=context), v.compose(*images, ctx=context)
    components = []
    for f in ManyGerm(family).coefficients:
        degree = max((c.degrees()[i] for c in f.values()), default=0)
        components.append({m: _substituted(c, i, unit, other, degree, images) for m, c in f.items()})
    moved = [_substituted(r, i, unit, other, r.degrees()[i], images) for r in rest]
    return _family(components, family, left), moved


def _substituted(q: Any, i: int, unit: Any, other: Any, degree: int, images: Sequence[Any]) -> Any:
    """unit^degree · q at aᵢ = −other/unit."""
    context = unit.context()
    total = context.constant(0)
    for k in range(q.degrees()[i] + 1 if not q.is_zero() else 0):
        terms = {m: c for m, c in q.to_dict().items() if int(m[i]) == k}
        if terms:
            flat = {tuple(0 if j == i else int(e) for j, e in enumerate(m)): c for m, c in terms.items()}
            part = q.context().from_dict(flat).compose(*images, ctx=context)
            total = total + part * (-other) ** k * unit ** (degree - k)
    return total


def _family(components: Sequence[dict[int, Any]], old: Family, names: tuple[str, ...]) -> Family | Germ:
    """The family with these coefficients; a germ if there is no parameter."""
    source, n = old.source, len(old.source)
    whole = (*source, *names)
    nodes = []
    for f in components:
        terms: poly.Polynomial = {}
        for m, c in f.items():
            for e, value in c.to_dict().items():
                powers = (*poly.exponents_of(m, n), *map(int, e))
                terms[poly.monomial(powers)] = Fraction(int(value.p), int(value.q))
        nodes.append(as_node(terms, whole))
    if not names:
        return Germ(nodes, source, old.boundary)
    return Family(", ".join(map(to_text, nodes)), source, names, old.boundary)


def without_idle(family: Family) -> Family | Germ:
    """The family without the parameters on which it does not depend; a germ if it depends on none.

    >>> print(without_idle(Family("a*x**2 + x**3", "x", "a b")).parameters)
    ('a',)
    """
    used = {
        k for f in family.coefficients for terms in f.values() for e in terms for k, v in enumerate(e) if v
    }
    idle = {name: 0 for k, name in enumerate(family.parameters) if k not in used}
    if not idle:
        return family
    return family.restricted(**idle) if used else family.at(**idle)


def scalings(family: Family) -> list[list[Fraction]]:
    """A basis of the weights of the parameters for which a scaling of source and target scales them so.

    A member at parameters λ^ω·a is equivalent to that at a then, up to a scaling of the target.

    >>> scalings(Family("x**3 + a*x*y**2 + b*y**3", "x y", "a b"))
    [[Fraction(2, 3), Fraction(1, 1)]]
    """
    n, m, p = len(family.source), len(family.parameters), len(family.coefficients)
    conditions = []
    for j, f in enumerate(family.coefficients):
        for monomial, terms in f.items():
            for e in terms:
                row = [Fraction(v) for v in (*poly.exponents_of(monomial, n), *e)]
                conditions.append([*row, *(Fraction(-int(k == j)) for k in range(p))])
    moved = [vector[n : n + m] for vector in null_space(conditions, n + m + p)]
    basis: list[list[Fraction]] = []
    for vector in moved:
        if len(independent([*basis, vector])) > len(basis):
            basis.append(vector)
    return basis


def independent(rows: Sequence[Sequence[Fraction]]) -> list[int]:
    """Columns on which rows are independent, as many as their rank, the last ones first.

    >>> independent([[Fraction(0), Fraction(2), Fraction(0)]])
    [1]
    """
    left = [list(row) for row in rows]
    found = []
    for column in reversed(range(len(rows[0]) if rows else 0)):
        pivot = next((row for row in left if row[column]), None)
        if pivot is None:
            continue
        found.append(column)
        left = [
            [v - row[column] / pivot[column] * w for v, w in zip(row, pivot)]
            for row in left
            if row is not pivot
        ]
    return found


def factors_at(q: Any, fixed: Mapping[str, int], name: str) -> list[tuple[int, ...]]:
    """The irreducible factors, by integer coefficients, the constant first, of q in one parameter left.

    >>> a, b = ring(["a", "b"]).gens()
    >>> factors_at(a**2 - b, {"b": 4}, "a")
    [(-2, 1), (2, 1)]
    """
    context = ring([name])
    (gen,) = context.gens()
    images = [gen if k == name else context.constant(fixed[k]) for k in q.context().names()]
    moved = q.compose(*images, ctx=context)
    if moved.is_constant():
        return []
    dense = {int(m[0]): c for m, c in moved.to_dict().items()}
    whole = fmpq_poly([dense.get(k, fmpq(0)) for k in range(max(dense) + 1)])
    return [tuple(int(c) for c in w.coeffs()) for w, _ in whole.numer().factor()[1]]
