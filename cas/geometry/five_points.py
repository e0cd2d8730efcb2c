"""The conic through five points of a curve, of which any may coincide (thesis 3.2.3).

A conic is a linear form on the Veronese image Ψ(x, y) of the plane, so five points of a curve α determine it
by five linear equations. Where points coincide, the divided differences of Ψ∘α take the place of its values
(Lemma 3.2.4): they span the same space while the points are apart, and still span one when they meet.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from fractions import Fraction
from math import factorial
from typing import Any, NamedTuple

import sympy as sp
from flint import fmpq

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.jets.jet import Root, real_root
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.numbers.divided_differences import exact, exact_nodes, is_zero, newton
from osculant.cas.numbers.power_series import PowerSeries, ratio

#: ``curve(s, order)``: the jet at the parameter s with the derivatives up to that order at least
CurveJets = Callable[[Any, int], PlaneJet]

POINTS = 5
#: a float counts as 0 if it is below this many units in the last place of the terms it is the sum of
ROUNDING_UNITS = 64


class Conic(NamedTuple):
    """The conic ax² + 2bxy + cy² + 2dx + 2ey + f = 0; all multiples of the six numbers are the same one.

    >>> circle = Conic(1, 0, 1, 0, 0, -4)
    >>> circle(2, 0), circle.S, circle.T
    (0, 1, -4)
    """

    a: Any
    b: Any
    c: Any
    d: Any
    e: Any
    f: Any

    def __call__(self, x: Any, y: Any) -> Any:
        """The left side of the equation at a point, for numbers or `PowerSeries`."""
        linear = x * (2 * self.d) + y * (2 * self.e) + self.f
        return x * x * self.a + x * y * (2 * self.b) + y * y * self.c + linear

    @property
    def S(self) -> Any:
        """ac − b²: positive, zero, negative for an ellipse, parabola, hyperbola."""
        return self.a * self.c - self.b * self.b

    @property
    def T(self) -> Any:
        """The 3 × 3 determinant: 0 exactly for a pair of lines."""
        a, b, c, d, e, f = self
        return a * (c * f - e * e) - b * (b * f - d * e) + d * (b * e - c * d)


def conic_affine_curvature(conic: Conic, root: Root = real_root) -> Any:
    """The constant affine curvature k = S·(T²)^(−1/3) of a conic (Proposition 3.2.1).

    Args:
        conic: with coefficients of any kind of number.
        root: ``root(value, 3)``, the real cube root of such numbers; integers and rationals give exact sympy
            numbers.

    Raises DomainError for a pair of lines, UndecidedError where balls leave that open.

    >>> conic_affine_curvature(Conic(1, 0, 1, 0, 0, -4))
    1/cbrt(16)
    """
    T = exact(conic.T)
    if is_zero(T, "The determinant of a conic"):
        raise DomainError(
            f"The conic {tuple(map(str, conic))} is a pair of lines: it has no affine curvature."
        )
    if isinstance(T, (Fraction, fmpq)):
        S, T = exact(conic.S), sp.Rational(int(T.numerator), int(T.denominator))
        return sp.Rational(int(S.numerator), int(S.denominator)) / root(T * T, 3)
    return conic.S / root(T * T, 3)


def veronese(x: Any, y: Any) -> tuple[Any, ...]:
    """Ψ(x, y) = (x², xy, y², x, y, 1), for numbers or `PowerSeries`.

    >>> veronese(2, 3)
    (4, 6, 9, 2, 3, 1)
    """
    return x * x, x * y, y * y, x, y, x * 0 + 1


def contact_rows(curve: CurveJets, parameters: Sequence[Any]) -> list[tuple[Any, ...]]:
    """The divided differences [s₁, …, sₖ](Ψ∘α) for k = 1, 2, …, one row of six each.

    A conic meets the curve at all the parameters, as often as each is given, exactly if it is orthogonal to
    these rows (its coefficients in the order of Ψ).

    Raises DomainError and UndecidedError as `osculant.cas.numbers.divided_differences.newton`.
    """
    images: dict[tuple[int, int], tuple[PowerSeries, ...]] = {}
    nodes = exact_nodes(parameters)

    def image(node: Any, order: int) -> tuple[PowerSeries, ...]:
        # the node as an object: balls cannot be hashed, and equal nodes are one object in `newton`
        if (id(node), order) not in images:
            images[id(node), order] = veronese(*_series(curve(node, order), order))
        return images[id(node), order]

    def coordinate(index: int) -> tuple[Any, ...]:
        return newton(lambda node, order: image(node, order)[index][order], nodes).coefficients

    return list(zip(*map(coordinate, range(POINTS + 1))))


def _series(jet: PlaneJet, order: int) -> tuple[PowerSeries, PowerSeries]:
    rows = []
    for derivatives in (jet.x, jet.y):
        if len(derivatives) <= order:
            raise DomainError(
                f"Contact at a point taken {order + 1} times needs the curve's derivatives up to order "
                f"{order}; its jet has them up to order {len(derivatives) - 1}."
            )
        terms = [exact(derivative) for derivative in derivatives[: order + 1]]
        rows.append(PowerSeries([c * ratio(1, factorial(i), c) for i, c in enumerate(terms)]))
    return rows[0], rows[1]


def orthogonal_conic(rows: Sequence[Sequence[Any]]) -> Conic:
    """The conic orthogonal to five rows, by the cofactors of det(Ψ(x), row₁, …, row₅) (3.2).

    Nothing is divided, so the entries may lie in any ring containing ℚ, such as that of `PowerSeries`. All
    coefficients are 0 if the rows are dependent: that is not checked here.

    >>> points = [veronese(x, y) for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1), (2, 1))]
    >>> orthogonal_conic(points)
    Conic(a=-16, b=16, c=-16, d=0, e=0, f=16)
    """
    xx, xy, yy, x, y, one = (c if i % 2 == 0 else c * -1 for i, c in enumerate(_minors(rows)))
    return Conic(xx * 2, xy, yy * 2, x, y, one * 2)


def _minors(rows: Sequence[Sequence[Any]], signed: bool = True) -> list[Any]:
    """The determinants of five rows without column 0, …, 5, by expansion along the last row.

    Not ``signed``: all terms with a plus.
    """
    known = {1 << column: entry for column, entry in enumerate(rows[0])}
    for height, row in enumerate(rows[1:], 1):
        above, known = known, {}
        for mask in range(1 << len(row)):
            columns = [column for column in range(len(row)) if mask >> column & 1]
            if len(columns) != height + 1:
                continue
            terms = [row[column] * above[mask ^ 1 << column] for column in columns]
            known[mask] = terms[-1]
            for place, term in enumerate(terms[:-1]):
                known[mask] = known[mask] + (term * -1 if signed and (height + place) % 2 else term)
    full = (1 << len(rows[0])) - 1
    return [known[full ^ 1 << column] for column in range(len(rows[0]))]


def five_point_conic(curve: CurveJets, parameters: Sequence[Any]) -> Conic:
    """The conic that meets a curve at five parameters, with the multiplicity with which each is given.

    Its coefficients are smooth in the parameters, also where these coincide; a curve Cᵐ gives Cᵐ⁻⁴
    (Lemma 3.2.4). In floats close parameters cost digits: give equal ones, or more digits.

    Args:
        curve: ``curve(s, order)`` with jets of any kind of number; at a parameter taken m times it is asked
            for orders up to m − 1.
        parameters: five, in any order.

    Raises:
        DomainError: for another number of parameters; for sympy symbols among them; if they cannot be
        compared; if the jets are too short;
            if the contact conditions are singular, so that more than one conic fulfils them.
        UndecidedError: if it stays open whether two parameters are equal or the conditions singular.

    >>> unit = lambda t, order: PlaneJet((t, 1, 0, 0, 0), (t * t * t, 3 * t * t, 6 * t, 6, 0))
    >>> conic = five_point_conic(unit, (-1, 0, 1, 2, 2))
    >>> [conic(t, t**3) for t in (-1, 0, 1, 2)] == [0] * 4
    True
    """
    if len(parameters) != POINTS:
        raise DomainError(f"A conic is determined by {POINTS} parameters, not by {len(parameters)}.")
    symbolic = [s for s in parameters if getattr(s, "free_symbols", None)]
    if symbolic:  # minors of sympy expressions grow without bound; elements of a field cancel as they go
        raise DomainError(
            f"The parameter {symbolic[0]} is symbolic: give such parameters as elements of sympy.field."
        )
    rows = contact_rows(curve, parameters)
    conic = orthogonal_conic(rows)
    if not _determined(conic, rows, parameters):
        shown = ", ".join(str(s) for s in parameters)
        raise DomainError(
            f"Singular contact conditions at the parameters {shown}: four of the points (coincident ones "
            "counted) lie on a line, or the curve is singular, so more than one conic passes through them."
        )
    return conic


def osculating_conic(jet: PlaneJet) -> Conic:
    """The conic that meets a curve in five coincident points, from the jet of order 4 there.

    Raises DomainError for a shorter jet, and for one of a cusp or of contact of order 3 with the tangent.

    >>> parabola = PlaneJet((0, 1, 0, 0, 0), (0, 0, 1, 0, 0))
    >>> conic_affine_curvature(osculating_conic(parabola))
    0
    """
    return five_point_conic(lambda _, order: jet, (0,) * POINTS)


def _determined(conic: Conic, rows: list[tuple[Any, ...]], parameters: Sequence[Any]) -> bool:
    """Whether some coefficient is not 0; for floats, not below what rounding leaves of a 0."""
    kind = type(conic.a)
    if kind is float or kind.__module__.startswith("mpmath"):
        unit = sys.float_info.epsilon if kind is float else kind.context.eps
        bounds = _rounding([tuple(abs(entry) for entry in row) for row in rows], parameters)
        return any(abs(c) > 2 * ROUNDING_UNITS * unit * bound for c, bound in zip(conic, bounds))
    undecided = None
    for c in conic:
        try:
            if not is_zero(c, "Contact conditions may be singular: a coefficient"):
                return True
        except UndecidedError as error:
            undecided = error
    if undecided is not None:
        raise undecided
    return False


def _rounding(sizes: list[tuple[Any, ...]], parameters: Sequence[Any]) -> list[Any]:
    """What an error of one unit in the values of Ψ∘α makes of the six determinants, to first order.

    Each further divided difference magnifies errors at most by 2/gap, the gap being the smallest distance of
    different parameters. Then one row at a time is in error, and the determinants have all terms positive.
    """
    gaps = [abs(a - b) for i, a in enumerate(parameters) for b in parameters[:i] if a != b]
    growth = 2 / min(gaps) if gaps else 1
    total, noise = [sizes[0][0] * 0] * (POINTS + 1), sizes[0]
    for i, size in enumerate(sizes):
        noise = tuple(max(growth * error, own) for error, own in zip(noise, size)) if i else size
        moved = _minors([*sizes[:i], noise, *sizes[i + 1 :]], signed=False)
        total = [sum_ + term for sum_, term in zip(total, moved)]
    return total
