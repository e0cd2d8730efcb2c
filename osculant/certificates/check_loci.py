"""Loci of degenerate points, for the checker: their ideals made anew, and the dimension of their zeros.

What a locus proves is told in `osculant.cas.germs.loci`. Imports nothing of osculant but the checker's own
algebra.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

from osculant.certificates.check_algebra import (
    Polynomial,
    composed,
    constant,
    derivative,
    number,
    pivots,
    plus,
    times,
)
from osculant.certificates.check_model import Model
from osculant.certificates.check_tangents import Problem
from osculant.certificates.check_text import require
from osculant.certificates.check_zeros import check_zeros, polynomial, units

#: the coefficients of the linear form of a difference of points
FORM = (1, 2, -3, 5, -7, 11, 13, -17)


def check_locus(problem: Problem, told: Mapping[str, Any]) -> None:
    """Check a proof that a codimension is infinite; raises RejectedError.

    Args:
        problem: the germ and the group.
        told: "locus" (what it is), "dimension" and "zeros" (the proof that its zeros have it at the origin).
    """
    locus, zeros = told["locus"], told["zeros"]
    functions = locus.get("functions", 0)
    require(isinstance(functions, int) and 0 <= functions <= 12, "a wrong number of functions")
    model = Model(problem.components, problem.source, functions)
    if locus.get("restricted"):
        require(problem.fixed is not None, "there is no boundary to restrict to")
        model = model.restricted(problem.fixed or 0)
    width, generators, least, apart = ideal(problem, model, locus)
    require(told["dimension"] == least, f"the dimension must be {least}")
    if locus.get("divided"):
        require(width == model.width and not apart, "the locus has no functions to divide")
        generators = [model.divided(f) for f in generators]
    check_zeros(width, generators, least + functions, apart, zeros)


def ideal(
    problem: Problem, model: Model, locus: Mapping[str, Any]
) -> tuple[int, list[Polynomial], int, bool]:
    """(variables, generators, the dimension that proves "infinite", whether off the last's zeros)."""
    kind, (source, target) = locus["kind"], problem.parts
    n, p = model.n, len(model.components)
    if kind == "module":
        part = "contact" if target == "left" else target
        require(locus["target"] == part, "the locus is of another group")
        rows = model.gradients()
        if problem.fixed is not None:
            u = model.variable(problem.fixed)
            rows = [[times(g, u) if i == problem.fixed else g for i, g in enumerate(row)] for row in rows]
        found = [a for a, _ in model.components] if part == "contact" else []
        return model.width, found + (minors(rows, p, model.width) if source != "none" else []), 1, False
    require(target == "left", "the locus is none of this group")
    if source == "none":
        require(kind in {"rank", "double"}, "the locus is none of this group")
        if kind == "rank":
            require(locus["rank"] == n - 1, "the rank must be n − 1")
            return model.width, minors(model.gradients(), n, model.width), 1, False
        require(locus["of"] == "any" and not locus.get("boundary"), "the locus is none of this group")
        return (2 * n, _double(model, "any", None), 1, True)
    on = problem.fixed if locus.get("boundary") else None
    require(
        not locus.get("boundary") or (on is not None and not locus.get("restricted")), "there is no boundary"
    )
    if kind == "rank":
        r, less = locus["rank"], int(on is not None)
        require(0 <= r < min(n, p), "no such rank")
        e = n - less - (n - r) * (p - r)
        found = minors(model.gradients(), r + 1, model.width)
        return model.width, found + ([] if on is None else [model.variable(on)]), max(e, 0) + 1, False
    if kind == "double":
        of = locus["of"]
        if of == "tangent":
            return 2 * n, _double(model, of, on), 1, True
        require(on is None and of == ("critical" if n >= p else "any"), "no such pairs")
        return 2 * n, _double(model, of, None), max(p - 2 if n >= p else 2 * n - p, 0) + 1, True
    require(on is None, "the locus is none of this group")
    if kind == "folds":
        require(n >= p > 1, "no such locus")
        critical = minors(model.gradients(), p, model.width)
        rows = [*model.gradients(), *(model.total(f) for f in critical)]
        return model.width, critical + minors(rows, n, model.width), max(p - 2, 0) + 1, False
    if kind == "singular":
        return model.width, _singular(model), 1, False
    require(kind == "multiple", f"no locus {kind!r}")
    return _multiple(model, locus)


def _singular(model: Model) -> list[Polynomial]:
    n, p = model.n, len(model.components)
    top = min(n, p) - 1
    e, deeper = n - (n - top) * (p - top), n - (n - top + 1) * (p - top + 1)
    corank = min(n, p) - _rank_at_origin(model)
    require(e >= 1 and (corank == 1 or deeper <= 0), "singular points there may be of lower rank")
    critical = minors(model.gradients(), top + 1, model.width)
    return critical + minors([model.total(f) for f in critical], n - e, model.width)


def _rank_at_origin(model: Model) -> int:
    zero = (0,) * model.width
    rows = [{i: g[zero] for i, g in enumerate(row) if zero in g} for row in model.gradients()]
    return len(pivots(row for row in rows if row))


def _multiple(model: Model, locus: Mapping[str, Any]) -> tuple[int, list[Polynomial], int, bool]:
    n, p, parts = model.n, len(model.components), list(locus["parts"])
    fit = bool(parts) and min(parts) >= 1 and 2 <= sum(parts) <= 8
    require(not model.rules and n <= p and fit, "no such points")
    change = [polynomial(f, n) for f in locus["source"]]
    matrix = [[number(v) for v in row] for row in locus["target"]]
    zero = (0,) * n
    linear = [{j: f[e] for j, e in enumerate(units(n)) if e in f} for f in change]
    require(len(change) == n and not any(zero in f for f in change), "the change does not keep the origin")
    require(len(pivots(linear)) == n, "the change is not invertible")
    require(
        len(matrix) == p and all(len(row) == p for row in matrix), "the change of the target has a wrong size"
    )
    rows = [{j: v for j, v in enumerate(row) if v} for row in matrix]
    require(len(pivots(row for row in rows if row)) == p, "the change of the target is not invertible")
    moved = []
    for row in matrix:
        above: Polynomial = {}
        below = constant(1, n)
        for v, (a, b) in zip(row, model.components):
            above, below = plus(times(above, b), times(a, below), v), times(below, b)
        moved.append((composed(above, change, n), composed(below, change, n)))
    for i, (a, b) in enumerate(moved[: n - 1]):
        require(a == times(b, model.variable(i)), "the change does not bring the germ to the form (x, g)")
    width, found = _differences([*moved[n - 1 :]], n, parts)
    size = (p - n + 1) * (sum(parts) - 1)
    e = n - 1 + len(parts) - size
    if not locus.get("singular"):
        return width, found, max(e, 0) + 1, False
    require(e > 0, "points that need not be smooth")
    rows_ = [[derivative(f, i) for i in range(width)] for f in found]
    return width, found + minors(rows_, size, width), 1, False


def _differences(
    functions: Sequence[tuple[Polynomial, Polynomial]], n: int, parts: Sequence[int]
) -> tuple[int, list[Polynomial]]:
    """The divided differences at y₁, …, y_s, each so often as its part says."""
    size, m = sum(parts), n - 1
    wide, width = m + size, m + len(parts)

    def gen(i: int, of: int) -> Polynomial:
        return {tuple(int(i == j) for j in range(of)): Fraction(1)}

    merged = [gen(m + i, width) for i, k in enumerate(parts) for _ in range(k)]
    found = []
    for above, below in functions:
        nodes = [[*(gen(i, wide) for i in range(m)), gen(m + k, wide)] for k in range(size)]
        values = [(composed(above, at, wide), composed(below, at, wide)) for at in nodes]
        for order in range(1, size):
            values = [
                (_divided(plus(times(b, c), times(a, d), -1), m + i + order, m + i, wide), times(c, d))
                for i, ((a, c), (b, d)) in enumerate(pairwise(values))
            ]
            equation = composed(values[0][0], [*(gen(i, width) for i in range(m)), *merged], width)
            if equation:
                found.append(equation)
    return width, found


def _divided(f: Polynomial, i: int, j: int, width: int) -> Polynomial:
    """f/(x_i − x_j): by the powers of x_i, from the highest."""
    rest = dict(f)
    found: Polynomial = {}
    while rest:
        m = max(rest, key=lambda e: e[i])
        require(m[i] > 0, "a difference that cannot be divided")
        c = rest[m]
        low = tuple(e - 1 if k == i else e for k, e in enumerate(m))
        found[low] = found.get(low, Fraction(0)) + c
        other = tuple(e + 1 if k == j else e for k, e in enumerate(low))
        rest = plus(plus(rest, {m: c}, -1), {other: c})
    return {m: c for m, c in found.items() if c}


def _double(model: Model, of: str, boundary: int | None) -> list[Polynomial]:
    """Pairs of points x, x′ in the variables x, dᵢ = xᵢ − x′ᵢ (i ≥ 2) and ℓ = Σ cᵢdᵢ, c₁ = 1."""
    require(not model.rules, "pairs of points of a germ that is not rational")
    n, p = model.n, len(model.components)
    gens = [{tuple(int(i == j) for j in range(2 * n)): Fraction(1)} for i in range(2 * n)]
    first = gens[-1]
    for c, d in zip(FORM[1:n], gens[n:-1]):
        first = plus(first, d, -c)
    here = gens[:n]
    there = [plus(a, d, -1) for a, d in zip(here, [first, *gens[n:-1]])]

    def at(f: Polynomial, point: Sequence[Polynomial]) -> Polynomial:
        return composed(f, point, 2 * n)

    found = [
        plus(times(at(a, here), at(b, there)), times(at(a, there), at(b, here)), -1)
        for a, b in model.components
    ]
    one = [[at(g, here) for i, g in enumerate(row) if i != boundary] for row in model.gradients()]
    two = [[at(g, there) for g in row] for row in model.gradients()]
    if boundary is not None:
        found.append(here[boundary])
    if of == "tangent":
        both = []
        for a, b, (_, unit) in zip(one, two, model.components):
            u, v = at(times(unit, unit), here), at(times(unit, unit), there)
            both.append([*(times(g, v) for g in a), *(times(g, u) for g in b)])
        found += minors(both, p, 2 * n)
    elif of == "critical":
        found += minors(one, p, 2 * n) + minors(two, p, 2 * n)
    return [f for f in found if f]


def minors(rows: Sequence[Sequence[Polynomial]], size: int, width: int) -> list[Polynomial]:
    """The minors of that size that are not 0."""
    if not rows or size > min(len(rows), len(rows[0])):
        return []
    found = []
    for chosen in combinations(range(len(rows)), size):
        known = {0: constant(1, width)}
        for i in chosen:
            larger: dict[int, Polynomial] = {}
            for columns, minor in known.items():
                for j, entry in enumerate(rows[i]):
                    if entry and not columns >> j & 1:
                        sign = (-1) ** (columns >> j).bit_count()
                        both = columns | 1 << j
                        larger[both] = plus(larger.get(both, {}), times(minor, entry), sign)
            known = {columns: minor for columns, minor in larger.items() if minor}
        found += list(known.values())
    return found
