"""The linear stage of Mond's X₄: where a cube stands in a pencil of cubic forms.

For f = (x, h₁, h₂) of the plane with h₁, h₂ of order 3 modulo x² the cubic parts span a plane among those of
y³, xy², x²y modulo x³. The form has y³ in it: the cubes (y − ax)³ that the plane contains are the roots of a
quadratic equation.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from flint import fmpq, fmpz

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.jets_of_maps import MapJet
from osculant.cas.recognition.forms import Column, Form
from osculant.cas.recognition.jets import matrix_of
from osculant.cas.recognition.levels import Weights, flagged
from osculant.cas.recognition.moves import Moved
from osculant.cas.recognition.obstruction import NotEquivalent
from osculant.cas.recognition.reduction import Start, reduced
from osculant.cas.recognition.targets import unmoved

CUBIC = ((0, 3), (1, 2), (2, 1))


def has_cube(form: Form) -> bool:
    """Whether a form is (x, y³, x²y + xy² + …) up to coefficients."""
    first = {(t.monomial, t.component) for t in form.core if sum(t.monomial) <= 3}
    return (form.n, form.p) == (2, 3) and first == {
        ((1, 0), 0),
        ((0, 3), 1),
        ((1, 2), 2),
        ((2, 1), 2),
    }


def cube_starts(moved: Moved, form: Form, along: Callable[[Moved, Weights], Moved]) -> Iterator[Start]:
    """The starts of the reduction of a germ whose linear part is x, one for each cube.

    Args:
        moved: the germ.
        form: the form.
        along: changes the target so that it fits the flag of these weights.

    Raises NotEquivalent if there are no two real cubes, UndecidedError if they are not rational.
    """
    p, q, r = _annihilator(moved, form)
    if r == 0 or 3 * q * q <= 4 * p * r:
        raise NotEquivalent(f"The cubic forms of the components have no two real cubes, unlike {form}.")
    root = square_root(9 * q * q - 12 * p * r)
    if root is None:
        raise UndecidedError(f"The cubes in the pencil of a germ as {form} are not rational.")
    weights = flagged((2, 2), (2, 3, 4))
    base: dict[Column, Any] = {((1, 0), 0): fmpq(1)}
    for a in ((3 * q + root) / (6 * r), (3 * q - root) / (6 * r)):
        shifted = moved.changed(matrix_of([[fmpq(1), fmpq(0)], [a, fmpq(1)]]))
        yield Start(along(shifted, weights), weights, base, frozenset(form.columns))


def _annihilator(moved: Moved, form: Form) -> tuple[Any, Any, Any]:
    """The functional on the coefficients of y³, xy², x²y that vanishes on the plane."""
    cut = MapJet(3, tuple(parts[:4] for parts in moved.f.components))
    start = unmoved(cut, form.group)
    allowed = frozenset((m, j) for m in CUBIC for j in (1, 2))
    base: dict[Column, Any] = {((1, 0), 0): fmpq(1)}
    _, terms = reduced(Start(start, flagged((2, 2), (2, 3, 3)), base, allowed))
    (a, b, c), (d, e, f) = ([terms.get((m, j), fmpq(0)) for m in CUBIC] for j in (1, 2))
    found = b * f - c * e, c * d - a * f, a * e - b * d
    if not any(found):
        raise NotEquivalent(f"The cubic forms of the components are dependent, unlike those of {form}.")
    return found


def square_root(value: Any) -> Any:
    """The rational square root of a positive number of flint's; None if it has none.

    >>> square_root(fmpq(4, 9)), square_root(fmpq(2))
    (2/3, None)
    """
    found = fmpq(*(int(fmpz(part).isqrt()) for part in (value.p, value.q)))
    return found if found * found == value else None
