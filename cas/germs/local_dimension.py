"""The dimension at the origin of the zeros of polynomials, over ℂ, from below, with a certificate.

In order: fewer generators than unknowns (Krull); a common factor that vanishes at 0; Lazard's homogenisation:
with a variable t that is larger than the others, a degree-lexicographic Gröbner basis of the homogenised
generators has, at t = 1, the leading monomials of the ideal in the local ring. To look off a hyperplane ℓ = 0
the ideal is divided by the powers of ℓ first (Bayer and Stillman: degrevlex with ℓ last).

A certificate is such a basis with a set S of unknowns, none of whose powers alone is a leading monomial: the
ideal of the generators lies in that of the basis, whose zeros have dimension |S| at least.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations, combinations_with_replacement
from math import lcm
from typing import Any

from flint import Ordering, fmpz, fmpz_mpoly_ctx, fmpz_mpoly_vec

from osculant.cas.germs.algebraic import Algebraic, NumberField
from osculant.cas.germs.model import split

#: whole numbers, or numbers of a number field, by exponents
Terms = dict[tuple[int, ...], Any]


def large_zeros(
    context: Any, generators: Sequence[Any], least: int, apart: bool, field: NumberField | None = None
) -> dict[str, Any] | None:
    """A certificate that the zeros have that dimension at the origin, or None if they have not.

    Args:
        context: the ring of the generators.
        generators: polynomials over ℚ.
        least: the dimension.
        apart: zeros on the hyperplane where the last variable is 0 do not count.
        field: the number field whose generator is one more variable behind, if there is one.

    It may take for ever: run it where it can be stopped.

    >>> from osculant.cas.germs.model import ring
    >>> R = ring(["x", "y"])
    >>> x, y = R.gens()
    >>> large_zeros(R, [x*(x + y), x*y], 1, False)["basis"]
    [[[0, 1, 0, '1']]]
    >>> large_zeros(R, [x**2, y**2 + x*y**2], 1, False) is None
    True
    """
    n = context.nvars() - (field is not None)
    given = [g for f in generators if (g := _integral(f) if field is None else split(f, field))]
    if any((0,) * n in f for f in given):
        return None
    if not apart:
        if n - len(given) >= least:
            return {"proof": "count"}
        if field is None and n - 1 >= least and (found := _common_factor(context, generators)) is not None:
            return _certificate([_homogeneous(found)], n, least)
        if given and n - 1 < least:
            return None
        return _certificate(_basis([_homogeneous(f) for f in given], field), n, least)
    divided = _divided(given, field)
    if any((0,) * n in f for f in divided):
        return None
    basis = _basis([_homogeneous(f) for f in (*given, *divided)], field)
    found_ = _certificate(basis, n, least)
    if found_ is None:
        return None
    # the zeros on ℓ = 0 must be smaller: forms that, with ℓ, leave the origin alone
    forms = [[int(j == i) + (j + 2) * k % 5 for j in range(n)] for k, i in enumerate(range(1, least))]
    at_one = [{m[1:]: c for m, c in f.items()} for f in basis]
    every = at_one + [_form([0] * (n - 1) + [1])] + [_form(f) for f in forms]
    order = isolated(every, n) if field is None else isolated(_residues(every), n, prime=field.split[0])
    return None if order is None else {**found_, "apart": {"forms": forms, "order": order}}


def _form(coefficients: Sequence[int]) -> Terms:
    n = len(coefficients)
    return {tuple(int(j == i) for j in range(n)): c for i, c in enumerate(coefficients) if c}


def _integral(f: Any) -> Terms:
    found = {tuple(map(int, m)): c for m, c in f.to_dict().items()}
    common = lcm(*(int(c.q) for c in found.values()))
    return {m: int(c.p) * (common // int(c.q)) for m, c in found.items()}


def _homogeneous(f: Terms) -> Terms:
    degree = max(map(sum, f))
    return {(degree - sum(m), *m): c for m, c in f.items()}


def _common_factor(context: Any, generators: Sequence[Any]) -> Terms | None:
    """An irreducible common factor through the origin."""
    common = context.constant(0)
    for f in generators:
        common = common.gcd(f)
        if common.is_constant() and not common.is_zero():
            return None
    if common.is_zero() or (0,) * context.nvars() in common.to_dict():
        return None
    factors = [_integral(f) for f, _ in common.factor()[1]]
    return min((f for f in factors if (0,) * context.nvars() not in f), key=len)


def _residues(generators: Sequence[Terms]) -> list[Terms]:
    return [
        {m: c.residue() if isinstance(c, Algebraic) else c.numerator for m, c in _whole(f).items()}
        for f in generators
    ]


def _whole(f: Terms) -> Terms:
    """A multiple whose numbers have no denominators."""
    common = lcm(*(c.denominator for c in f.values()))
    return {m: c * common for m, c in f.items()}


def _basis(forms: Sequence[Terms], field: NumberField | None = None) -> list[Terms]:
    """A Gröbner basis of homogeneous forms: of terms of one degree that with higher first exponents leads."""
    if field is None:
        return _groebner(forms, Ordering.deglex)
    # the generator of the field comes last in a lexicographic order
    return _of_field(
        _groebner([*map(_spread, forms), _minimal(field, len(next(iter(forms[0]))))], Ordering.lex), field
    )


def _spread(f: Terms) -> Terms:
    """A form over a field as one over ℤ with the generator as one more variable, the last."""
    found: Terms = {}
    for m, c in _whole(f).items():
        parts = c.coefficients() if isinstance(c, Algebraic) else (c,)
        found |= {(*m, i): int(v) for i, v in enumerate(parts) if v}
    return found


def _minimal(field: NumberField, width: int) -> Terms:
    """The polynomial of the generator of a field, behind so many other variables."""
    coefficients = field.polynomial.coeffs()
    common = lcm(*(int(c.q) for c in coefficients))
    return {(*([0] * width), i): int((c * common).p) for i, c in enumerate(coefficients) if c != 0}


def _of_field(basis: Sequence[Terms], field: NumberField) -> list[Terms]:
    """Polynomials with the generator as the last variable over the field; those that are 0 are left out."""
    found = []
    for f in basis:
        parts: dict[tuple[int, ...], Any] = {}
        for m, c in f.items():
            parts[m[:-1]] = parts.get(m[:-1], Fraction(0)) + field.generator ** m[-1] * Fraction(c)
        if kept := {m: c for m, c in parts.items() if c}:
            found.append(kept)
    return found


def _groebner(forms: Sequence[Terms], ordering: Any) -> list[Terms]:
    size = len(next(iter(forms[0])))
    context = fmpz_mpoly_ctx.get([f"v{i}" for i in range(size)], ordering)
    given = fmpz_mpoly_vec([context.from_dict({m: fmpz(c) for m, c in f.items()}) for f in forms], context)
    found = given.buchberger_naive().autoreduction()
    return [{tuple(map(int, m)): int(c) for m, c in b.to_dict().items()} for b in found if not b.is_zero()]


def _divided(generators: Sequence[Terms], field: NumberField | None) -> list[Terms]:
    """Generators of the ideal divided by the powers of the last variable."""
    if field is not None:
        return _divided_over(generators, field)
    forms = _groebner([_homogeneous(f) for f in generators], Ordering.degrevlex)
    found = []
    for f in forms:
        power = min(m[-1] for m in f)
        at_one: Terms = {}
        for m, c in f.items():
            at_one[(*m[1:-1], m[-1] - power)] = c
        found.append(at_one)
    return found


def _divided_over(generators: Sequence[Terms], field: NumberField) -> list[Terms]:
    """The same over a field: its generator a is a variable; b makes polynomials homogeneous in a, b."""
    width = len(next(iter(generators[0])))
    forms = []
    for f in [*map(_spread, generators), _minimal(field, width)]:
        top, high = max(sum(m[:-1]) for m in f), max(m[-1] for m in f)
        forms.append(
            {(m[-1], high - m[-1], top - sum(m[:-1]), *m[:-1]): c for m, c in f.items()}
        )  # a, b, t, x, the last variable behind
    divided = []
    for f in _groebner(forms, Ordering.degrevlex):
        power = min(m[-1] for m in f)
        at_one: Terms = {}
        for m, c in f.items():
            key = (*m[3:-1], m[-1] - power, m[0])
            at_one[key] = at_one.get(key, 0) + c
        divided.append(at_one)
    return _of_field(divided, field)


def _certificate(basis: list[Terms], n: int, least: int) -> dict[str, Any] | None:
    leading = [max(f, key=lambda m: (sum(m), m))[1:] for f in basis]
    for chosen in combinations(range(n), least):
        if all(any(e for i, e in enumerate(m) if i not in chosen) for m in leading):
            told = [[[*m, str(c)] for m, c in f.items()] for f in basis]
            return {"proof": "basis", "basis": told, "free": list(chosen)}
    return None


def isolated(generators: Sequence[Terms], n: int, highest: int = 20, prime: int = 2**31 - 1) -> int | None:
    """A k with M^k ⊂ I + M^{k+1} modulo a prime, and hence over ℚ: the origin is an isolated zero.

    >>> isolated([{(2, 0): 1}, {(0, 1): 3, (1, 1): 1}], 2)
    2
    """
    for k in range(1, highest + 1):
        columns = {m: i for i, m in enumerate(_monomials(n, k))}
        if len(columns) > 3000:
            return None
        rows = []
        for f in generators:
            for m in columns:
                row: dict[int, int] = {}
                for e, c in f.items():
                    place = columns.get(tuple(a + b for a, b in zip(m, e)))
                    if place is not None and c % prime:
                        row[place] = c % prime
                if row:
                    rows.append(row)
        pivots = _pivots(rows, prime)
        if all(i in pivots for m, i in columns.items() if sum(m) == k):
            return k
    return None


def _pivots(rows: Sequence[dict[int, int]], prime: int) -> set[int]:
    found: dict[int, dict[int, int]] = {}
    for row in rows:
        while row:
            lead = min(row)
            if lead not in found:
                inverse = pow(row[lead], -1, prime)
                found[lead] = {c: v * inverse % prime for c, v in row.items()}
                break
            factor = row[lead]
            for c, v in found[lead].items():
                value = (row.get(c, 0) - factor * v) % prime
                if value:
                    row[c] = value
                else:
                    row.pop(c, None)
    return set(found)


def _monomials(n: int, order: int) -> list[tuple[int, ...]]:
    """The exponents of degree at most ``order``, by degree."""
    return [
        tuple(chosen.count(i) for i in range(n))
        for d in range(order + 1)
        for chosen in combinations_with_replacement(range(n), d)
    ]
