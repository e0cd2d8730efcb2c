"""The linear stage for A and A(H): linear maps after which the lowest terms of a map are those of its form.

Source and target are made to fit df first. In the target there is a flag then that depends on nothing
chosen: a function η of the target with η(0) = 0, η modulo those of order two, goes as high as the weight of
the pull-back η∘f can be made by terms of order two of η. A basis along that flag is found by elimination.
Quadratic forms in the kernel of df are diagonalised.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from flint import fmpq, fmpq_mat

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.jets_of_maps import MapJet, Parts
from osculant.cas.recognition.cubes import cube_starts, has_cube
from osculant.cas.recognition.elimination import Combination, Vector, echelon, swept
from osculant.cas.recognition.forms import Form
from osculant.cas.recognition.jets import identity, matrix_of
from osculant.cas.recognition.levels import Weights, monomials
from osculant.cas.recognition.moves import Moved
from osculant.cas.recognition.obstruction import NotEquivalent
from osculant.cas.recognition.pencils import is_pencil, pencil_starts
from osculant.cas.recognition.quadratic import diagonalised
from osculant.cas.recognition.reduction import Start
from osculant.cas.recognition.shapes import Shape, shape


def map_starts(moved: Moved, form: Form) -> Iterator[Start]:
    """The starts of the reduction of a map of the shape of the form, for A or A(H); mostly one.

    Raises NotEquivalent if the rank of df or of a quadratic form differs, UndecidedError if the form is not
    in the coordinates that its lowest terms give, or if those of the germ are not rational.
    """
    if is_pencil(form):
        yield from pencil_starts(moved, form)
        return
    found = shape(form)
    moved = _linear(moved, form, found)
    if has_cube(form):
        yield from cube_starts(moved, form, lambda m, weights: _along_flag(m, form, found, weights))
        return
    moved = _squares(_along_flag(moved, form, found, found.weights), form, found)
    base = {t.column: fmpq(1) for t in form.core if sum(t.monomial) == 1}
    yield Start(
        moved,
        found.weights,
        base,
        frozenset(form.columns),
        found.families(form),
        form.boundary,
    )


def _linear(moved: Moved, form: Form, found: Shape) -> Moved:
    """Fits source and target to df: the linear part becomes that of the form."""
    n, p, u = moved.n, moved.p, found.u
    own = [i for i in range(n) if i != u]
    rows = moved.f.linear_part().tolist()
    both = [
        [*(row[i] for i in own), *([] if u is None else [row[u]]), *(fmpq(int(i == j)) for j in range(p))]
        for i, row in enumerate(rows)
    ]
    reduced, _ = fmpq_mat(p, n + p, [v for row in both for v in row]).rref()
    lines = [[reduced[i, j] for j in range(n + p)] for i in range(p)]
    leading = [next(j for j in range(n + p) if line[j] != 0) for line in lines]
    r = sum(lead < len(own) for lead in leading)
    boundary = sum(len(own) <= lead < n for lead in leading)
    if (r, boundary) != (len(found.x), int(found.linear is not None)):
        raise NotEquivalent(f"The rank of the derivative is not that of {form}.")
    # targets: the components of the form in the order of the rows
    places = [*found.x.values(), *([] if found.linear is None else [found.linear])]
    places += [j for j in range(p) if j not in places]
    target = [[fmpq(0)] * p for _ in range(p)]
    for line, j in zip(lines, places):
        target[j] = line[n:]
    # the new coordinates in the old ones
    forms = [[fmpq(0)] * n for _ in range(n)]
    for i, line in zip(found.x, lines):
        for j, old in enumerate(own):
            forms[i][old] = line[j]
        if u is not None:
            forms[i][u] = line[n - 1]
    rest = [old for j, old in enumerate(own) if j not in leading[:r]]
    for i, old in zip(found.z, rest):
        forms[i][old] = fmpq(1)
    if u is not None:
        forms[u][u] = fmpq(1)
    return moved.changed(matrix_of(forms).inv(), matrix_of(target))


def _along_flag(moved: Moved, form: Form, found: Shape, weights: Weights) -> Moved:
    """A basis of the target along the flag that the weights of the source make."""
    if len(found.h) < 2:
        return moved
    n = moved.n
    degrees = [min((sum(t.monomial) for t in form.core if t.component == j), default=0) for j in found.h]
    order = max(degrees)
    place = {m: i for i, m in enumerate(sorted(monomials(n, order), key=lambda m: (weights.of(m), m)))}
    low = MapJet(order, tuple(parts[: order + 1] for parts in moved.f.components))

    def vector(parts: Parts) -> Vector:
        return {place[tuple(map(int, m))]: c for part in parts for m, c in part.to_dict().items()}

    # a coordinate that is a component lies below all h: it may be subtracted, as what is of order two
    products = [
        (beta, vector(f)) for beta, f in low.powers() if sum(beta) > 1 or beta.index(1) in found.x.values()
    ]
    rows = echelon(products)
    lines: list[tuple[int, list[Any]]] = []
    for j in found.h:
        made: Combination = {("h", j): fmpq(1)}
        rest = vector(low.components[j])
        lead = swept(rest, rows, made)
        if lead is not None:
            inverse = 1 / rest[lead]
            rows[lead] = (
                {i: v * inverse for i, v in rest.items()},
                {key: v * inverse for key, v in made.items()},
            )
        line = [made.get(("h", i), fmpq(0)) for i in range(moved.p)]
        lines.append((len(place) if lead is None else lead, line))
    target = identity(moved.p).tolist()
    for j, (_, line) in zip(found.h, sorted(lines, key=lambda pair: pair[0])):
        target[j] = line
    return moved.changed(None, matrix_of(target))


def _squares(moved: Moved, form: Form, found: Shape) -> Moved:
    """Diagonalises the quadratic form in the kernel of df, if the form has it in one component."""
    z, n = found.z, moved.n
    squares = [t for t in form.core if sum(t.monomial) == 2 and sum(t.monomial[i] for i in z) == 2]
    components = {t.component for t in squares}
    if any(max(t.monomial) == 1 for t in squares):
        raise UndecidedError(f"The quadratic form in the kernel of the derivative of {form} is not diagonal.")
    if len(z) < 2 or len(components) != 1:
        return moved
    part = moved.f.components[components.pop()][2].to_dict()

    def entry(i: int, j: int) -> Any:
        m = tuple(int(k == i) + int(k == j) for k in range(n))
        return part.get(m, fmpq(0)) / (1 if i == j else 2)

    matrix = [[entry(i, j) for j in z] for i in z]
    change, values = diagonalised(matrix)
    if sum(v != 0 for v in values) != len(squares):
        raise NotEquivalent(f"The quadratic form in the kernel of the derivative is not that of {form}.")
    squared = [i for i in z if any(t.monomial[i] for t in squares)]
    full = iter(squared)
    kernel = iter([i for i in z if i not in squared])
    names = [next(full) if v != 0 else next(kernel) for v in values]
    source = identity(n)
    for i, row in zip(z, change):
        for k in z:
            source[i, k] = fmpq(0)
        for k, v in zip(names, row):
            source[i, k] = v
    return moved.changed(source)
