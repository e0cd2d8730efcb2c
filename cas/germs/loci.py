"""Where a germ is degenerate: ideals whose zeros at the origin, if too large, prove a codimension infinite.

If T G_e f had finite codimension, the germ would be G-stable at all points near the origin but itself, and
also at several points with one image. A `Locus` is an ideal with a bound: zeros of that dimension at the
origin, over ℂ, prove "infinite". R, C, K (and with a boundary): the points where the generators do not span,
by minors. A:

* rank: {rank df ≤ r} has dimension n − (n − r)(p − r) where a germ is stable, and is smooth at rank r;
* folds (n ≥ p): the critical set Σ is mapped as an immersion but on a set of dimension p − 2;
* multiple (corank 1, n ≤ p): the schemes of `osculant.cas.germs.schemes` are smooth of their dimension;
* double: pairs of different points with one image, with non-transverse tangent images (none where the germ is
  stable), critical ones (n ≥ p, dimension p − 2), any (n < p, dimension 2n − p). They are sought off the
  diagonal in the coordinates x, x − x′ of which the last is a linear form ℓ: off ℓ = 0.

With a boundary H also: the same of f restricted to H (stable where f is), {rank df ≤ r} ∩ H, of one dimension
less, and pairs with a point on H, where only the derivatives along H count. L: double points at all.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import combinations
from math import comb
from typing import Any

from osculant.cas.germs.linear import rank
from osculant.cas.germs.model import Model, polynomial, ring, split
from osculant.cas.germs.normal_form import NormalForm, normal_form
from osculant.cas.germs.schemes import divided_differences, expected, partitions

#: minors of one ideal at most
MINORS = 400
#: the coefficients of the linear form ℓ of a difference
FORM = (1, 2, -3, 5, -7, 11, 13, -17)


@dataclass(frozen=True)
class Locus:
    """An ideal, and the dimension of its zeros at the origin from which on the codimension is infinite.

    Attributes:
        kind: what it is, as plain data from which a checker makes the ideal again.
        least: that dimension.
        make: the ring and the generators, made when they are wanted.
        apart: zeros count off the hyperplane where the last variable is 0.
        functions: how many variables stand for functions of the germ: zeros with them have so much more.
    """

    kind: dict[str, Any]
    least: int
    make: Callable[[], tuple[Any, list[Any]]] = field(compare=False)
    apart: bool = False
    functions: int = 0


def loci(
    model: Model, source: str, target: str, boundary: int | None, fields: Sequence[Any]
) -> Iterator[Locus]:
    """The loci for a group, the simple ones first; where functions are variables, also divided by arguments.

    Args:
        model: the germ.
        source: of the group: "all", "boundary", "none" or "own".
        target: of the group: "none", "left" or "contact".
        boundary: the number of the variable u, for "boundary".
        fields: the generators of the module of source fields, as polynomials of this room.
    """
    for locus in _loci(model, source, target, boundary, fields):
        yield locus
        if locus.functions and any(told is not None for told in model.arguments):
            make = partial(_divided, model, locus.make)
            yield Locus({**locus.kind, "divided": True}, locus.least, make, functions=locus.functions)


def _divided(model: Model, make: Callable[[], tuple[Any, list[Any]]]) -> tuple[Any, list[Any]]:
    context, generators = make()
    return context, [model.divided(f) for f in generators]


def _loci(
    model: Model, source: str, target: str, boundary: int | None, fields: Sequence[Any]
) -> Iterator[Locus]:
    if target != "left":
        yield _module(model, target, fields)
        return
    yield _module(model, "contact", fields)
    if source == "none":
        yield from _immersion(model)
        return
    if source == "own":
        return
    yield from _stability(model, {})
    if source != "boundary" or boundary is None or model.rules:
        return
    yield from _on_boundary(model, boundary)
    if model.n > 1:
        yield from _stability(model.restricted(boundary), {"restricted": True})


def _module(model: Model, target: str, fields: Sequence[Any]) -> Locus:
    def make() -> tuple[Any, list[Any]]:
        p = len(model.components)
        own = [[polynomial(c, model.context, model.n) for c in vector] for vector in fields]
        gradients = [model.gradient(j) for j in range(p)]
        rows = [[sum((c * g for c, g in zip(vector, d)), model.zero) for vector in own] for d in gradients]
        found = [above for above, _ in model.components] if target == "contact" else []
        return model.context, found + minors(rows, p, model)

    return Locus({"kind": "module", "target": target}, 1, make, functions=model.extra)


def _immersion(model: Model) -> Iterator[Locus]:
    n = model.n
    yield Locus(
        {"kind": "rank", "rank": n - 1},
        1,
        partial(_ranked, model, n - 1),
        functions=model.extra,
    )
    if not model.rules:
        yield Locus({"kind": "double", "of": "any"}, 1, partial(_double, model, "any", None), True)


def _stability(model: Model, where: dict[str, Any]) -> Iterator[Locus]:
    n, p = model.n, len(model.components)
    top, more = min(n, p) - 1, model.extra
    corank = min(n, p) - _rank_at_origin(model)
    for r in range(top, max(top - corank, -1), -1):
        e = n - (n - r) * (p - r)
        yield Locus(
            {"kind": "rank", "rank": r, **where}, max(e, 0) + 1, partial(_ranked, model, r), functions=more
        )
    smooth, deeper = n - (n - top) * (p - top), n - (n - top + 1) * (p - top + 1)
    if smooth >= 1 and corank and (corank == 1 or deeper <= 0):
        make = partial(_singular, model, n - smooth)
        yield Locus({"kind": "singular", **where}, 1, make, functions=more)
    if n >= p > 1 and corank:
        yield Locus({"kind": "folds", **where}, max(p - 2, 0) + 1, partial(_folds, model), functions=more)
    if model.rules or not corank:
        return
    form = normal_form(model) if corank == 1 and n <= p else None
    if form is not None:
        yield from _multiple(model, form, where)
        return
    tangent = partial(_double, model, "tangent", None)
    yield Locus({"kind": "double", "of": "tangent", **where}, 1, tangent, True)
    kind, expected_ = ("critical", p - 2) if n >= p else ("any", 2 * n - p)
    make = partial(_double, model, kind, None)
    yield Locus({"kind": "double", "of": kind, **where}, max(expected_, 0) + 1, make, True)


def _on_boundary(model: Model, u: int) -> Iterator[Locus]:
    n, p = model.n, len(model.components)
    for r in range(min(n, p) - 1, -1, -1):
        e = n - 1 - (n - r) * (p - r)
        here = {"kind": "rank", "rank": r, "boundary": True}
        yield Locus(here, max(e, 0) + 1, partial(_ranked, model, r, u))
    here = {"kind": "double", "of": "tangent", "boundary": True}
    yield Locus(here, 1, partial(_double, model, "tangent", u), True)


def _multiple(model: Model, form: NormalForm, where: dict[str, Any]) -> Iterator[Locus]:
    n, p = model.n, len(model.components)
    told = {
        "kind": "multiple",
        "source": [terms(f, model) for f in form.source],
        "target": [[str(v) for v in row] for row in form.target],
        **where,
    }
    for parts in partitions(n, p):
        e, here = expected(n, p, parts), {**told, "parts": list(parts)}
        yield Locus(here, max(e, 0) + 1, partial(_scheme, model, form, parts, 0))
        if e > 0:
            equations = (p - n + 1) * (sum(parts) - 1)
            yield Locus({**here, "singular": True}, 1, partial(_scheme, model, form, parts, equations))


def _scheme(model: Model, form: NormalForm, parts: tuple[int, ...], equations: int) -> tuple[Any, list[Any]]:
    """A multiple-point scheme; with the number of its equations its singular points."""
    context, found = divided_differences(form.functions, model.context.names()[: model.n], parts, model.field)
    if equations:
        width = context.nvars() - len(model.constants)
        rows = [[f.derivative(i) for i in range(width)] for f in found]
        found = found + minors(rows, equations, Model(context, width, (), ()))
    return context, found


def minors(rows: Sequence[Sequence[Any]], size: int, model: Model) -> list[Any]:
    """The minors of that size of a matrix that are not 0; raises ValueError if they are too many."""
    height, width = len(rows), len(rows[0]) if rows else 0
    if size > min(height, width):
        return []
    if comb(height, size) * comb(width, size) > MINORS:
        raise ValueError("too many minors")
    found = []
    for chosen in combinations(range(height), size):
        known = {0: model.one}
        for i in chosen:
            larger: dict[int, Any] = {}
            for columns, minor in known.items():
                for j, entry in enumerate(rows[i]):
                    if not columns >> j & 1 and not entry.is_zero():
                        term = minor * entry * (-1) ** (columns >> j).bit_count()
                        both = columns | 1 << j
                        larger[both] = larger[both] + term if both in larger else term
            known = {columns: minor for columns, minor in larger.items() if not minor.is_zero()}
        found += list(known.values())
    return found


def terms(f: Any, model: Model) -> list[list[Any]]:
    """A polynomial as plain data: [exponents…, coefficient as text] for every term."""
    found = f.to_dict() if model.field is None else split(f, model.field)
    return [[*map(int, e), str(c)] for e, c in found.items()]


def _gradients(model: Model) -> list[list[Any]]:
    return [model.gradient(j) for j in range(len(model.components))]


def _ranked(model: Model, r: int, boundary: int | None = None) -> tuple[Any, list[Any]]:
    """The points where df has that rank or less, on the boundary if one is given."""
    more = [] if boundary is None else [model.variables[boundary]]
    return model.context, [*_rank(model, r), *more]


def _rank(model: Model, r: int) -> list[Any]:
    return minors(_gradients(model), r + 1, model)


def _rank_at_origin(model: Model) -> int:
    return rank([[model.at_origin(g) for g in row] for row in _gradients(model)], model.n)


def _singular(model: Model, codimension: int) -> tuple[Any, list[Any]]:
    critical = _rank(model, min(model.n, len(model.components)) - 1)
    rows = [model.derivatives(f) for f in critical]
    return model.context, critical + minors(rows, codimension, model)


def _folds(model: Model) -> tuple[Any, list[Any]]:
    critical = _rank(model, len(model.components) - 1)
    rows = [*_gradients(model), *(model.derivatives(f) for f in critical)]
    return model.context, critical + minors(rows, model.n, model)


def _double(model: Model, of: str, boundary: int | None) -> tuple[Any, list[Any]]:
    """Pairs x, x′ in the unknowns x, dᵢ = xᵢ − x′ᵢ (i ≥ 2) and ℓ = Σ cᵢdᵢ; c₁ = 1."""
    n, p = model.n, len(model.components)
    names = model.context.names()[:n]
    context = ring([*names, *(f"d{i + 1}" for i in range(1, n)), "l"], model.field)
    gens, constants = list(context.gens())[: 2 * n], list(context.gens())[2 * n :]
    here = gens[:n]
    differences = [gens[-1] - sum((c * d for c, d in zip(FORM[1:n], gens[n:-1])), context.constant(0))]
    differences += gens[n:-1]
    there = [a - d for a, d in zip(here, differences)]

    def at(f: Any, point: list[Any]) -> Any:
        return f.compose(*point, *constants, ctx=context)

    found = [at(a, here) * at(b, there) - at(a, there) * at(b, here) for a, b in model.components]
    double = Model(context, n, (), ())
    rows = [
        [
            [at(g, point) for i, g in enumerate(row) if point is there or i != boundary]
            for row in _gradients(model)
        ]
        for point in (here, there)
    ]
    if boundary is not None:
        found.append(here[boundary])
    if of == "tangent":
        units = [(at(b, here) ** 2, at(b, there) ** 2) for _, b in model.components]
        both = [[*(g * v for g in a), *(g * u for g in b)] for a, b, (u, v) in zip(rows[0], rows[1], units)]
        found += minors(both, p, double)
    elif of == "critical":
        found += minors(rows[0], p, double) + minors(rows[1], p, double)
    return context, [f for f in found if not f.is_zero()]
