"""Where points of several branches have one image: too many of them prove a codimension infinite.

At the other points near the origin a multigerm of finite codimension is stable. Then points of the branches
with one image, each counted with a type (k₁, …, k_s) in its branch, are smooth of the dimension e that the
dimensions allow, and there are none but the origin if e < 0 (as for a single germ, `schemes`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import combinations, product
from typing import Any

from osculant.cas.germs.geometry import Geometry, bounded, germ_of, in_rounds, print_proof, told
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import group
from osculant.cas.germs.loci import Locus, minors
from osculant.cas.germs.model import Model, ring
from osculant.cas.germs.model_reading import model_of
from osculant.cas.germs.normal_form import NormalForm, normal_form
from osculant.cas.germs.processes import question
from osculant.cas.germs.schemes import POINTS, UNKNOWNS, cycles, divided_differences

Types = tuple[tuple[int, ...], ...]


class MultiGeometry(Geometry):
    """The search for a proof that a multigerm is of infinite codimension, in a process of its own."""

    module = "osculant.cas.germs.multiple_loci"

    def __init__(self, branches: Sequence[Germ]) -> None:
        super().__init__(branches[0], group("A"))
        self.branches = tuple(branches)

    def told(self) -> dict[str, Any] | None:
        """The branches as plain data."""
        found = [told(branch, self.group, ()) for branch in self.branches]
        return None if None in found else {"branches": found}


def multiple_loci(models: Sequence[Model]) -> Iterator[Locus]:
    """The loci of several branches, those of few unknowns first.

    >>> planes = [model_of(Germ("x, y, 0", "x y")), model_of(Germ("x, y, x**2*y", "x y"))]
    >>> [(locus.kind["parts"], locus.least) for locus in multiple_loci(planes)]
    [([[1], [1]], 2), ([[1], [1]], 1)]
    """
    n, p = models[0].n, len(models[0].components)
    if any(model.rules for model in models) or n > p:
        return
    forms = [normal_form(model) for model in models]
    found = []
    for size in range(2, len(models) + 1):
        for chosen in combinations(range(len(models)), size):
            for types in product(*(_types(n, p, forms[i]) for i in chosen)):
                unknowns = sum(_unknowns(n, parts) for parts in types)
                if sum(map(sum, types)) <= POINTS and unknowns <= UNKNOWNS and not _follows(n, p, types):
                    found.append((unknowns, chosen, types))
    for unknowns, chosen, types in sorted(found):
        e = _expected(n, p, types)
        kind = {"kind": "together", "branches": [i + 1 for i in chosen], "parts": [list(t) for t in types]}
        some = [(models[i], forms[i]) for i in chosen]
        yield Locus(kind, max(e, 0) + 1, partial(_scheme, some, types, 0))
        if e > 0:
            yield Locus({**kind, "singular": True}, 1, partial(_scheme, some, types, unknowns - e))


def _types(n: int, p: int, form: NormalForm | None) -> list[tuple[int, ...]]:
    """The types of points in one branch: single ones (n < p), and multiple ones of a germ of corank 1."""
    single: list[tuple[int, ...]] = [(1,)] if n < p else []
    if form is None:
        return single
    least = 2 if n == p else 1
    return single + [t for size in range(2, POINTS) for t in cycles(size) if min(t) >= least]


def _unknowns(n: int, parts: tuple[int, ...]) -> int:
    return n - 1 + len(parts)


def _expected(n: int, p: int, types: Types) -> int:
    inner = sum(_unknowns(n, parts) - (p - n + 1) * (sum(parts) - 1) for parts in types)
    return inner - p * (len(types) - 1)


def _follows(n: int, p: int, types: Types) -> bool:
    """Whether the same with a point less is isolated already."""
    least = 2 if n == p else 1
    for i, parts in enumerate(types):
        if sum(parts) == least:
            smaller = [types[:i] + types[i + 1 :]]
        else:
            smaller = [
                (*types[:i], less, *types[i + 1 :])
                for j, k in enumerate(parts)
                if k > least or len(parts) > 1
                for less in [
                    tuple(
                        sorted((*parts[:j], *((k - 1,) if k > least else ()), *parts[j + 1 :]), reverse=True)
                    )
                ]
            ]
        if any(_expected(n, p, fewer) <= 0 for fewer in smaller if sum(map(sum, fewer)) >= 2):
            return True
    return False


def _scheme(
    branches: Sequence[tuple[Model, NormalForm | None]], types: Types, equations: int
) -> tuple[Any, list[Any]]:
    """The points of these types with one image; with the number of equations their singular points."""
    n = branches[0][0].n
    context = ring([f"z{i}" for i in range(sum(_unknowns(n, parts) for parts in types))])
    gens, start = list(context.gens()), 0
    found: list[Any] = []
    images = []
    for (model, form), parts in zip(branches, types):
        own = gens[start : start + _unknowns(n, parts)]
        start += len(own)
        if sum(parts) == 1:
            images.append(
                [(a.compose(*own, ctx=context), b.compose(*own, ctx=context)) for a, b in model.components]
            )
            continue
        assert form is not None
        names = model.context.names()[:n]
        _, differences = divided_differences(form.functions, names, parts)
        found += [f.compose(*own, ctx=context) for f in differences]
        point = own[:n]
        at = [f.compose(*point, ctx=context) for f in form.source]
        images.append(
            [(a.compose(*at, ctx=context), b.compose(*at, ctx=context)) for a, b in model.components]
        )
    for other in images[1:]:
        found += [a * d - c * b for (a, b), (c, d) in zip(images[0], other)]
    if equations:
        rows = [[f.derivative(i) for i in range(context.nvars())] for f in found]
        found = found + minors(rows, equations, Model(context, n, (), ()))
    return context, [f for f in found if not f.is_zero()]


def main() -> None:
    """Read the branches from standard input, print the proof or null."""
    bounded()
    read = question()
    models = [model_of(germ_of(branch)) for branch in read["branches"]]
    known = [model for model in models if model is not None]
    loci = list(multiple_loci(known)) if len(known) == len(models) else []
    print_proof(in_rounds(loci, None))


if __name__ == "__main__":
    main()
