"""Curvature and torsion of a space curve at a point, with the derivatives that its secants ask for, exactly.

With w = |X′|², k = |X′ × X″|²/w³ and τ = det(X′, X″, X‴)/|X′ × X″|², by the curve's own parameter, the
derivatives by arc length are κ = √k, κ′ = k̇/(2√(kw)), τ′ = τ̇/√w and τ″ = τ̈/w − τ̇ẇ/(2w²). So
3κτ″ − κ′τ′ = (3kτ″ − k̇τ̇/(2w))/√k, and nothing but square roots of two numbers is irrational.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import Node, number, power
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import NumberField, exact
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.polynomials import Polynomial

#: derivatives of the curve that are needed; series are kept up to the last that matters of them
ORDER, KEPT = 5, 2


@dataclass(frozen=True)
class Frenet:
    """Frenet data at a point, by arc length: exact constants; a right-handed helix has τ > 0.

    Attributes:
        curvature: κ > 0.
        torsion: τ.
        curvature_slope: κ′.
        torsion_slope: τ′.
        torsion_second: τ″.
        condition: 3κτ″ − κ′τ′.
        case: that of Proposition 1.4.5: "fold" if τ ≠ 0, "pitchfork" if τ = 0, τ′ ≠ 0 and 3κτ″ − κ′τ′ ≠ 0,
            "neither" else.
    """

    curvature: Node
    torsion: Node
    curvature_slope: Node
    torsion_slope: Node
    torsion_second: Node
    condition: Node
    case: str


def frenet(curve: Germ) -> Frenet:
    """The Frenet data of a regular germ R → R³ at 0.

    Raises DomainError for other dimensions, and where the curve is singular or the curvature is 0.

    >>> helix = frenet(Germ("3*cos(t) - 3, 3*sin(t), 4*t", "t"))
    >>> print(helix.curvature, helix.torsion, helix.torsion_slope, helix.condition, helix.case)
    3/25 4/25 0 0 fold
    """
    if (curve.n, curve.p) != (1, 3):
        raise DomainError(
            f"Frenet data are those of a curve in space, not of a map from {curve.n} to {curve.p}."
        )
    jet = curve.jet(ORDER)
    first, second, third = (
        [_cut(_derivative(f, order)) for f in jet] for order in (1, 2, 3)
    )  # fmt: skip
    normal = _cross(first, second)
    w, c = _dot(first, first), _dot(normal, normal)
    if not w.get(0) or not c.get(0):
        raise DomainError(
            "The curvature is 0 at the point, or the curve is singular: its torsion does not exist there."
        )
    k = _ratio(c, _times(_times(w, w), w))
    tau = _ratio(_dot(normal, third), c)
    (w0, w1, _), (k0, k1, _), (t0, t1, t2) = map(_derivatives, (w, k, tau))
    second_slope = exact(t2 / w0 - t1 * w1 / (2 * w0 * w0))
    condition = exact(3 * k0 * second_slope - k1 * t1 / (2 * w0))
    field = curve.field
    case = "fold" if t0 else "pitchfork" if t1 and condition else "neither"
    return Frenet(
        _over_root(k0, k0, field),
        _node(t0, field),
        _over_root(k1 / 2, exact(k0 * w0), field),
        _over_root(t1, w0, field),
        _node(second_slope, field),
        _over_root(condition, k0, field),
        case,
    )


def _derivative(f: Polynomial, order: int) -> Polynomial:
    for _ in range(order):
        f = poly.derivative(f, 0, 1)
    return f


def _cut(f: Polynomial) -> Polynomial:
    return poly.cut(f, 1, KEPT)


def _times(a: Polynomial, b: Polynomial) -> Polynomial:
    return poly.times(a, b, 1, KEPT)


def _ratio(a: Polynomial, b: Polynomial) -> Polynomial:
    """The series a/b, for b(0) ≠ 0."""
    inverse = exact(1 / exact(b[0]))
    rest = poly.plus({0: 1}, {m: c * inverse for m, c in b.items()}, -1)
    found: Polynomial = {}
    for _ in range(KEPT + 1):
        found = poly.plus({m: c * inverse for m, c in a.items()}, _times(found, rest))
    return _cut(found)


def _dot(a: Sequence[Polynomial], b: Sequence[Polynomial]) -> Polynomial:
    total: Polynomial = {}
    for f, g in zip(a, b):
        total = poly.plus(total, _times(f, g))
    return total


def _cross(a: Sequence[Polynomial], b: Sequence[Polynomial]) -> list[Polynomial]:
    return [
        poly.plus(_times(a[i - 2], b[i - 1]), _times(a[i - 1], b[i - 2]), -1) for i in range(3)
    ]  # fmt: skip


def _derivatives(f: Polynomial) -> tuple[Any, Any, Any]:
    """The value and two derivatives at 0."""
    c0, c1, c2 = (exact(f.get(poly.monomial((i,)), 0)) for i in range(3))
    return c0, c1, 2 * c2


def _node(value: Any, field: NumberField | None) -> Node:
    return number(value) if field is None else field.expression(value)


def _over_root(value: Any, of: Any, field: NumberField | None) -> Node:
    """value/√of as an expression; √of itself if both are the same."""
    if not value:
        return number(0)
    root = power(_node(of, field), number(Fraction(1, 2)))
    return root if value == of else _node(value, field) / root
