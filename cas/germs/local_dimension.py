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
from itertools import combinations, combinations_with_replacement
from math import lcm
from typing import Any

from flint import Ordering, fmpz, fmpz_mpoly_ctx, fmpz_mpoly_vec

Terms = dict[tuple[int, ...], int]


def large_zeros(context: Any, generators: Sequence[Any], least: int, apart: bool) -> dict[str, Any] | None:
    """A certificate that the zeros have that dimension at the origin, or None if they have not.

    Args:
        context: the ring of the generators.
        generators: polynomials over ℚ.
        least: the dimension.
        apart: zeros on the hyperplane where the last variable is 0 do not count.

    It may take for ever: run it where it can be stopped.

    >>> from osculant.cas.germs.model import ring
    >>> R = ring(["x", "y"])
    >>> x, y = R.gens()
    >>> large_zeros(R, [x*(x + y), x*y], 1, False)["basis"]
    [[[0, 1, 0, '1']]]
    >>> large_zeros(R, [x**2, y**2 + x*y**2], 1, False) is None
    True
    """
    n = context.nvars()
    given = [_integral(f) for f in generators if not f.is_zero()]
    if any((0,) * n in f for f in given):
        return None
    if not apart:
        if n - len(given) >= least:
            return {"proof": "count"}
        if n - 1 >= least and (found := _common_factor(context, generators)) is not None:
            return _certificate([_homogeneous(found)], n, least)
        if given and n - 1 < least:
            return None
        return _certificate(_basis([_homogeneous(f) for f in given]), n, least)
    divided = _divided(given)
    if any((0,) * n in f for f in divided):
        return None
    basis = _basis([_homogeneous(f) for f in (*given, *divided)])
    found_ = _certificate(basis, n, least)
    if found_ is None:
        return None
    # the zeros on ℓ = 0 must be smaller: forms that, with ℓ, leave the origin alone
    forms = [[int(j == i) + (j + 2) * k % 5 for j in range(n)] for k, i in enumerate(range(1, least))]
    at_one = [{m[1:]: c for m, c in f.items()} for f in basis]
    order = isolated(at_one + [_form([0] * (n - 1) + [1])] + [_form(f) for f in forms], n)
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


def _basis(forms: Sequence[Terms], ordering: Any = Ordering.deglex) -> list[Terms]:
    size = len(next(iter(forms[0])))
    context = fmpz_mpoly_ctx.get([f"v{i}" for i in range(size)], ordering)
    given = fmpz_mpoly_vec([context.from_dict({m: fmpz(c) for m, c in f.items()}) for f in forms], context)
    found = given.buchberger_naive().autoreduction()
    return [{tuple(map(int, m)): int(c) for m, c in b.to_dict().items()} for b in found if not b.is_zero()]


def _divided(generators: Sequence[Terms]) -> list[Terms]:
    """Generators of the ideal divided by the powers of the last variable."""
    forms = _basis([_homogeneous(f) for f in generators], Ordering.degrevlex)
    found = []
    for f in forms:
        power = min(m[-1] for m in f)
        at_one: Terms = {}
        for m, c in f.items():
            at_one[(*m[1:-1], m[-1] - power)] = c
        found.append(at_one)
    return found


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
