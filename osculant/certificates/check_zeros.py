"""The dimension of the zeros of polynomials at the origin, for the checker, from below.

The proof is a Gröbner basis of homogeneous polynomials with one variable t more, the first: the generators,
homogenised by it, are in its ideal. Imports nothing of osculant but the checker's own algebra.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import combinations
from typing import Any

from osculant.certificates.check_algebra import Polynomial, monomials, number, pivots, plus
from osculant.certificates.check_text import require

#: products of terms that a check may take
WORK = 20_000_000


def units(n: int) -> list[tuple[int, ...]]:
    """The exponents of the variables."""
    return [tuple(int(i == j) for i in range(n)) for j in range(n)]


def polynomial(told: Any, n: int) -> Polynomial:
    """A polynomial from plain data: [exponents…, coefficient as text] for every term."""
    found: Polynomial = {}
    for term in told:
        m = tuple(term[:-1])
        require(len(m) == n and all(isinstance(e, int) and e >= 0 for e in m), "a term of the wrong size")
        found = plus(found, {m: number(term[-1])})
    return found


def check_zeros(
    width: int, generators: list[Polynomial], least: int, apart: bool, told: Mapping[str, Any]
) -> None:
    """Check that the zeros have that dimension at the origin (``apart``: off the last variable's zeros)."""
    zero = (0,) * width
    require(not any(zero in f for f in generators), "the origin is no zero")
    if told["proof"] == "count":
        require(
            not apart and width - len([f for f in generators if f]) >= least, "there are too many equations"
        )
        return
    require(told["proof"] == "basis", "no such proof")
    basis = [polynomial(f, width + 1) for f in told["basis"]]
    require(all(f and len({sum(m) for m in f}) == 1 for f in basis), "the basis is not homogeneous")
    division = Division(basis)
    for f, m in zip(basis, division.leading):
        require(1 / f[m] != 0, "a leading coefficient is 0")  # of a number field: it has an inverse
    for f in generators:
        if f:
            degree = max(map(sum, f))
            homogeneous = {(degree - sum(m), *m): c for m, c in f.items()}
            require(not division.rest(homogeneous), "a generator is not in the ideal of the basis")
    require(division.complete(), "the basis is no Gröbner basis")
    free = set(told["free"])
    require(len(free) >= least and free <= set(range(width)), "there are too few free variables")
    for m in division.leading:
        require(
            any(e for i, e in enumerate(m[1:]) if i not in free), "a power product of free variables leads"
        )
    if apart:
        _check_apart(basis, width, least, told["apart"])


def _check_apart(basis: list[Polynomial], width: int, least: int, told: Mapping[str, Any]) -> None:
    """Check that the zeros of the basis with ℓ = 0 are of lower dimension: forms leave the origin alone."""
    forms = [[number(v) for v in form] for form in told["forms"]]
    require(
        len(forms) == least - 1 and all(len(form) == width for form in forms), "the number of forms is wrong"
    )
    last = [Fraction(int(i == width - 1)) for i in range(width)]
    axes = units(width)
    given = [{e: v for e, v in zip(axes, form) if v} for form in (*forms, last)]
    for f in basis:
        at_one: Polynomial = {}
        for m, c in f.items():
            at_one = plus(at_one, {m[1:]: c})
        given.append(at_one)
    order = told["order"]
    place = {m: i for i, m in enumerate(monomials(width, order))}
    rows = []
    for f in given:
        for e in place:
            row = {place[k]: c for m, c in f.items() if (k := tuple(a + b for a, b in zip(m, e))) in place}
            if row:
                rows.append(row)
    found = pivots(rows)
    require(
        all(i in found for m, i in place.items() if sum(m) == order), "zeros on the hyperplane are too large"
    )


class Division:
    """Division by homogeneous polynomials; of terms of one degree that with higher first exponents leads."""

    def __init__(self, basis: list[Polynomial]) -> None:
        self.basis = basis
        self.leading = [max(f, key=lambda m: (sum(m), m)) for f in basis]
        self.work = 0

    def rest(self, f: Polynomial) -> Polynomial:
        """What is left of f: {} if it is in the ideal, as far as division tells."""
        f = dict(f)
        while f:
            m = max(f, key=lambda e: (sum(e), e))
            found = next(
                (i for i, lead in enumerate(self.leading) if all(a <= b for a, b in zip(lead, m))), None
            )
            if found is None:
                return f
            shift = tuple(b - a for a, b in zip(self.leading[found], m))
            factor = f[m] / self.basis[found][self.leading[found]]
            self.work += len(self.basis[found])
            require(self.work < WORK, "the check takes too long")
            for e, c in self.basis[found].items():
                k = tuple(a + b for a, b in zip(e, shift))
                value = f.get(k, Fraction(0)) - factor * c
                if value:
                    f[k] = value
                else:
                    f.pop(k, None)
        return f

    def complete(self) -> bool:
        """Whether all S-polynomials are divided without rest (Buchberger)."""
        for (f, a), (g, b) in combinations(list(zip(self.basis, self.leading)), 2):
            if not any(min(x, y) for x, y in zip(a, b)):
                continue
            top = tuple(map(max, a, b))
            s: Polynomial = {}
            for h, lead, sign in ((f, a, 1), (g, b, -1)):
                shift = tuple(x - y for x, y in zip(top, lead))
                moved = {tuple(x + y for x, y in zip(m, shift)): c for m, c in h.items()}
                s = plus(s, moved, Fraction(sign) / h[lead])
            if self.rest(s):
                return False
        return True
