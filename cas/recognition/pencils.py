"""The linear stage of germs of the plane into itself with df = 0: pencils of binary quadratic forms.

The quadratic forms of both components span a plane; one tensor Σ M_ij ∂i∂j annihilates it. If det M < 0 the
span has two squares, ℓ₁² and ℓ₂² (type I), if det M > 0 it is that of z² with z = x + y√−δ, δ > 0, up to
linear maps (type II). In type I two starts are left, which are exchanged. In type II the maps z ↦ λz are
left, a torus that is not split: with z² + a·z̄^{2l+1} the first term that remains, λ must make a·λ̄^{2l+1}/λ²
real; such λ in ℚ(√−δ) are the rational roots of a polynomial.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from flint import fmpq, fmpq_mat, fmpq_poly

from osculant.cas.errors import UndecidedError
from osculant.cas.recognition.cubes import square_root
from osculant.cas.recognition.forms import Column, Form
from osculant.cas.recognition.jets import matrix_of
from osculant.cas.recognition.levels import flagged
from osculant.cas.recognition.moves import Moved
from osculant.cas.recognition.obstruction import NotEquivalent
from osculant.cas.recognition.quadratic import diagonalised
from osculant.cas.recognition.reduction import Start, reduced
from osculant.cas.recognition.scaling import exchanges

QUADRATIC = ((2, 0), (1, 1), (0, 2))


def is_pencil(form: Form) -> bool:
    """Whether a form is a map of the plane into itself with df = 0 and two independent quadratic forms."""
    return form.n == form.p == 2 and all(sum(t.monomial) > 1 for t in form.core)


def pencil_starts(moved: Moved, form: Form) -> Iterator[Start]:
    """The starts of the reduction of a germ to a form of type I or II.

    Raises NotEquivalent if the pencil is not that of the form, UndecidedError if its two squares, or λ, are
    not rational over the field where they should be.
    """
    if moved.f.linear_part().rank():
        raise NotEquivalent(f"The rank of the derivative is not that of {form}.")
    a, b, c = _annihilator(_quadratics(moved))
    change, (first, second) = diagonalised([[a, b], [b, c]])
    if first * second == 0:
        raise NotEquivalent("The quadratic forms of the components have a common factor, or are dependent.")
    circular = ((1, 1), 1) in form.columns
    if circular != (first * second > 0):
        raise NotEquivalent(f"The pencil of quadratic forms is of the other real type than that of {form}.")
    source = matrix_of(change).transpose().inv()
    if circular:
        yield from _circular(_fitted(moved.changed(source), first / second), form, first / second)
        return
    slope = square_root(-second / first)
    if slope is None:
        if len(list(exchanges(form))) == 1:
            raise NotEquivalent(f"The squares in the pencil are conjugate, those of {form} are different.")
        raise UndecidedError(f"The squares in the pencil of a germ as {form} are not rational.")
    for signs in ((1, -1), (-1, 1)):
        squares = matrix_of([[fmpq(1), fmpq(1)], [slope * signs[0], slope * signs[1]]])
        start = _fitted(moved.changed(source * squares), None)
        base: dict[Column, Any] = {((2, 0), 0): fmpq(1), ((0, 2), 1): fmpq(1)}
        yield Start(start, flagged((0, 0), (0, 0)), base, frozenset(form.columns))


def _circular(moved: Moved, form: Form, delta: Any) -> Iterator[Start]:
    """The starts for type II; the components of the germ begin with x² − δy² and xy."""
    weights = flagged((0, 0), (0, 0))
    base: dict[Column, Any] = {((2, 0), 0): fmpq(1), ((0, 2), 0): -delta, ((1, 1), 1): fmpq(1)}
    top = max(sum(t.monomial) for t in form.core)
    real, imaginary = ((top, 0), 0), ((top, 0), 1)
    _, terms = reduced(Start(moved, weights, base, frozenset({*form.columns, imaginary})))
    a, b = terms.get(real, fmpq(0)), 2 * terms.get(imaginary, fmpq(0))
    if not a and not b:
        raise NotEquivalent(f"The term {real[0]} of component 1 is not there.", real)
    turns = list(_turns(a, b, delta, top + 2))
    if not turns:
        raise UndecidedError(
            f"An equivalence with {form} takes the root of index {top + 2} of a number that has none in "
            f"the field of the root of -{delta}."
        )
    for p, q in turns:
        turned = moved.changed(matrix_of([[p, -delta * q], [q, p]]))
        yield Start(_fitted(turned, delta), weights, base, frozenset(form.columns))


def _turns(a: Any, b: Any, delta: Any, index: int) -> Iterator[tuple[Any, Any]]:
    """(p, q) with λ^index/(a + b√−δ) real for λ = p + q√−δ, up to real factors."""
    real, imaginary = fmpq_poly([1]), fmpq_poly([0])
    t = fmpq_poly([0, 1])
    for _ in range(index):  # (1 + t√−δ)^index
        real, imaginary = real - delta * t * imaginary, imaginary + t * real
    condition = a * imaginary - b * real
    if condition.degree() < index:
        yield fmpq(0), fmpq(1)
    for factor, _ in condition.factor()[1]:
        if factor.degree() == 1:
            yield fmpq(1), -factor[0] / factor[1]


def _quadratics(moved: Moved) -> list[list[Any]]:
    """The coefficients of x², xy, y² in both components."""
    parts = [f[2].to_dict() for f in moved.f.components]
    return [[part.get(m, fmpq(0)) for m in QUADRATIC] for part in parts]


def _annihilator(rows: list[list[Any]]) -> tuple[Any, Any, Any]:
    """The entries M₁₁, M₁₂, M₂₂ of the tensor that annihilates two quadratic forms."""
    (a, b, c), (d, e, f) = rows
    return b * f - c * e, c * d - a * f, a * e - b * d


def _fitted(moved: Moved, delta: Any) -> Moved:
    """The target changed so that the components begin with x² and y², or with x² − δy² and xy."""
    rows = _quadratics(moved)
    second = 1 if delta is not None else 2
    minor = fmpq_mat(2, 2, [row[i] for row in rows for i in (0, second)])
    return moved.changed(None, minor.inv())
