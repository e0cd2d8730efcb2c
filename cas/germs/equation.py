"""The equation of the image of a germ with p = n + 1, or of the discriminant of one with n = p.

Quasi-homogeneous germs: `Pushforward`. Germs of corank 1 in coordinates (x, g(x, y)): a resultant in y. Its
roots y near 0 give the equation of the germ, a polynomial of known degree in one target coordinate for X = 0;
if the resultant has that order there, the other roots give a unit, and the resultant is the equation.
"""

from __future__ import annotations

from typing import Any

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.logarithmic import fields_of
from osculant.cas.germs.model import ring
from osculant.cas.germs.model_reading import model_of
from osculant.cas.germs.normal_form import NormalForm, normal_form
from osculant.cas.germs.pushforward import Pushforward, known_weights, primitive
from osculant.cas.germs.search import Patience

#: degree of a germ whose resultant is taken
DEGREE = 100


def equation(germ: Germ, patience: Patience | None = None) -> Any:
    """The equation, a polynomial in y1, …, yp that is 0 on the image or discriminant, exact up to a unit.

    A germ that covers its image several times has a power of it.

    Raises DomainError for other dimensions and where there is no discriminant, UndecidedError where the
    equation is no polynomial known here.

    >>> print(equation(Germ("x, y**2, y**3 + x**2*y + x**3*y", "x y")))
    y1^6*y2 + 2*y1^5*y2 + y1^4*y2 + 2*y1^3*y2^2 + 2*y1^2*y2^2 + y2^3 - y3^2
    """
    n, p = germ.n, germ.p
    if p not in (n, n + 1) or p == 1:
        raise DomainError(f"An image or discriminant has an equation for p = n or n + 1, p ≥ 2, not p = {p}.")
    if n == p and germ.rank == n:
        raise DomainError("The germ has no critical points, and no discriminant.")
    if germ.field is not None:
        raise UndecidedError(f"The equation of {germ} is not known: its coefficients are not rational.")
    model = model_of(germ) if germ.polynomial(DEGREE) is not None else None
    if model is not None and n == 1:  # whatever the rank, the resultant is in t
        return primitive(_resultant([a for a, _ in model.components], n, p))
    form = normal_form(model) if model is not None and germ.rank == n - 1 else None
    if form is not None and all(b.is_constant() for _, b in form.functions):
        return _moved(form, n, p)
    if known_weights(germ) is not None:
        return Pushforward(germ, patience).equation()
    raise UndecidedError(
        f"The equation is known for quasi-homogeneous germs, and for polynomials of degree at most {DEGREE} "
        "with a polynomial normal form of corank 1."
    )


def _moved(form: NormalForm, n: int, p: int) -> Any:
    """The equation of (x, g(x, y)) in the target coordinates that are given."""
    found = _resultant([a / b.leading_coefficient() for a, b in form.functions], n, p)
    gens = found.context().gens()
    moved = [sum((c * y for c, y in zip(row, gens)), 0 * gens[0]) for row in form.target]
    return primitive(found.compose(*moved, ctx=found.context()))


def _resultant(functions: list[Any], n: int, p: int) -> Any:
    """The equation of (x, g(x, y)) in the ring of y1, …, yp."""
    names = [f"y{j + 1}" for j in range(p)]
    both = ring(["_y", *names])
    y, *target = both.gens()
    moved = [g.compose(*target[: n - 1], y, ctx=both) for g in functions]
    orders = [_order(g.compose(*[both.constant(0)] * (n - 1), y, ctx=both)) for g in functions]
    i = min(range(len(orders)), key=orders.__getitem__)
    last = p - 1 if p == n else n - 1 + (1 - i)
    other = moved[i].derivative(0) if p == n else moved[1 - i] - target[last]
    first = moved[i] - target[n - 1 + i]
    found = first.resultant(other, "_y")
    context = ring(names)
    result = found.compose(context.constant(0), *context.gens(), ctx=context)
    only = [context.gens()[j] if j == last else context.constant(0) for j in range(p)]
    expected = orders[i] - (1 if p == n else 0)
    if _order(result.compose(*only, ctx=context)) != expected:
        raise UndecidedError("Other points over the origin meet the image: its equation is no resultant.")
    return result


def _order(f: Any) -> int:
    """The least degree of a term."""
    return min((sum(map(int, m)) for m in f.monoms()), default=poly.LARGEST)


def liftable_fields(germ: Germ, patience: Patience | None = None) -> tuple[tuple[str, ...], ...]:
    """Generators of the liftable fields of a finitely determined germ with p = n or n + 1, as text in y1, ….

    They are the logarithmic fields of its discriminant or image. Raises the errors of `equation`.

    >>> liftable_fields(Germ("x, x*y + y**3", "x y"))
    (('9*y2', '-2*y1**2'), ('2*y1', '3*y2'))
    """
    return fields_of(equation(germ, patience), patience)
