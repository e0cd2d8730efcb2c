"""Linear stages of functions on a manifold with boundary, for R(H): Arnold's simple ones.

With f = g on H = {u = 0}: where u has a coefficient in the linear part, f is u and the function g, which is
prepared as for R; else g is split with u as a parameter, and what is left is u alone, or u and one variable.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.jets_of_maps import map_jet
from osculant.cas.recognition.forms import Form
from osculant.cas.recognition.function_kinds import function_kind
from osculant.cas.recognition.functions import started
from osculant.cas.recognition.levels import UNIT, Weights
from osculant.cas.recognition.moves import Moved
from osculant.cas.recognition.obstruction import NotEquivalent
from osculant.cas.recognition.reduction import Start
from osculant.cas.recognition.splitting import splitting


def boundary_starts(moved: Moved, form: Form) -> Iterator[Start]:
    """The starts of the reduction of a function for R(H).

    Raises NotEquivalent for another linear part or another corank on the boundary, UndecidedError as
    `function_starts` does.
    """
    u, n = form.boundary, moved.n
    assert u is not None
    (f,) = moved.f.polynomials()
    linear = {m for m in f if poly.degree_of(m, n) == 1}
    if linear - {poly.variable(u, n)}:
        raise NotEquivalent("The function has no critical point on the boundary.")
    found = splitting(f, n, moved.order, u)
    rest = [i for i in range(n) if i != u][: found.corank]
    name = form.entry.id
    if name[0] in "ADE":
        if not linear:
            raise NotEquivalent("The function has a critical point.")
        kind, corank = function_kind(form)
        if found.corank != corank:
            raise NotEquivalent(f"The Hessian on the boundary has corank {found.corank}, not {corank}.")
        yield from started(moved, form, kind, found, tuple(rest), u)
        return
    if linear:
        raise NotEquivalent("The function has no critical point.")
    if found.corank != int(name != "B_k"):
        raise NotEquivalent(f"The Hessian on the boundary has corank {found.corank}.")
    split, k = moved.substituted(found.change), dict(form.integers).get("k", 0)
    weights = [UNIT * (k if name != "F_4" else 3)] * n  # of the squares, half the weight of the function
    if name == "B_k":
        weights[u] = 2 * UNIT
    else:
        (y,) = rest
        weights[u], weights[y] = (3 * UNIT, 2 * UNIT) if name == "F_4" else (2 * (k - 1) * UNIT, 2 * UNIT)
        both, square = poly.variable(u, n) + poly.variable(y, n), 2 * poly.variable(u, n)
        if name == "C_k" and (mixed := Fraction(found.rest.get(both, 0))):
            images = [{poly.variable(i, n): Fraction(1)} for i in range(n)]
            images[y][poly.variable(u, n)] = -Fraction(found.rest.get(square, 0)) / mixed
            images[y] = {m: c for m, c in images[y].items() if c}
            split = split.substituted(map_jet(images, n, moved.order))
    yield Start(split, Weights(tuple(weights), (UNIT,)), {}, frozenset(form.columns), boundary=u)
