"""The number of pieces that theory predicts for a curve."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from osculant.approximation.division import divide
from osculant.cas.errors import DomainError, UndecidedError
from osculant.primitives.table import choose
from osculant.spline import Prediction
from osculant.tolerances import checked_tolerance

if TYPE_CHECKING:
    from osculant.approximation.division import Division
    from osculant.approximation.stretches import Stretch
    from osculant.curves.curve import FormulaCurve
    from osculant.primitives.primitive import Fit

#: a predicted number above an integer by less than this part of it is that integer
ROUNDING = 1e-12


@dataclass(frozen=True)
class Complexity:
    """N(ε) = C ε^{−1/order} + c₁ ε^{1/order} + …, with C and c₁ of the whole curve.

    ``constants`` are the C of the stretches between split points to ``digits`` digits (estimates by
    quadrature that converges doubly exponentially); a stretch whose curve is the primitive itself has C = 0
    and takes ``least`` pieces.  ``next_constants`` are the c₁ of the stretches, estimates too, if they were
    asked for.

    In the metric "hausdorff" every piece has the error ε, ``order`` p is that of a short arc's error, and C
    is the sum (3.17), (3.18).  In "area" the pieces' areas add up to ε, each having the same; ``order`` is
    then q = p − 1, and C^{q/p}, the content, is the sum (3.25), (3.26).

    >>> law = Complexity("conic", "hausdorff", 5, ("1.5", "0"), (1, 2), 15)
    >>> law.constant, round(law.predicted(1e-5), 9), law.predicted_pieces(1e-5)
    (1.5, 15.0, 17)
    >>> halves = Complexity("conic", "area", 5, ("0.7", "0.7"), (1, 1), 15)
    >>> round(halves.constant / 0.7, 9) == round(2 ** (6 / 5), 9), halves.predicted_pieces(1e-5)
    (True, 18)
    """

    primitive: str
    metric: str
    order: int
    constants: tuple[str, ...]
    least: tuple[int, ...]
    digits: int
    next_constants: tuple[str, ...] | None = None

    @property
    def constant(self) -> float:
        """The leading constant C of the whole curve."""
        return float(math.fsum(self._contents) ** self._power)

    @property
    def _power(self) -> float:
        """p/q: the power of the content that C is."""
        return (self.order + 1) / self.order if self.metric == "area" else 1.0

    @property
    def _contents(self) -> list[float]:
        """What adds over stretches: pieces with the error ε each take content·ε^{−1/p} of them."""
        return [float(c) ** (1 / self._power) for c in self.constants]

    def predicted(self, tolerance: float) -> float:
        """The real number C ε^{−1/order}; raises ToleranceError unless ε is positive and finite."""
        return float(self.constant * checked_tolerance(tolerance) ** (-1.0 / self.order))

    def predicted_error(self, pieces: int) -> float:
        """The error of the best spline with that many pieces, to leading order: (C/N)^order.

        The Hausdorff distance, or the whole area: the asymptotic formulas of Fejes Tóth, of McClure and
        Vitale and of Ludwig for polygons and parabolas (thesis, section 1.3 and Corollary 3.6.5), with the
        pieces shared among all stretches by their contents.

        Raises DomainError for less than one piece.

        >>> law = Complexity("conic", "hausdorff", 5, ("1.5",), (1,), 15)
        >>> round(law.predicted_error(15), 12)
        1e-05
        """
        if not pieces >= 1:
            raise DomainError(f"A spline has at least one piece, not {pieces!r}.")
        return math.prod([self.constant / pieces] * self.order)  # ∞, not an error, where it overflows

    @property
    def next_constant(self) -> float | None:
        """c₁ of the whole curve, None if it was not asked for."""
        if self.next_constants is None:
            return None
        return math.fsum(float(c) for c in self.next_constants)

    def refined(self, tolerance: float) -> float | None:
        """C ε^{−1/order} + c₁ ε^{1/order}, None without c₁."""
        if self.next_constant is None:
            return None
        return self.predicted(tolerance) + self.next_constant * float(tolerance ** (1.0 / self.order))

    def predicted_pieces(self, tolerance: float) -> int:
        """The whole number: rounded up on every stretch, at least what the stretch needs.

        In the metric "area" the least n that n pieces of the area ε/n suffice for.
        """
        if self.metric != "area":
            return self._pieces(checked_tolerance(tolerance) ** (-1.0 / self.order))
        scale = checked_tolerance(tolerance) ** (-1.0 / (self.order + 1))
        needed, pieces = 1, 0
        while needed > pieces:  # the pieces needed grow with n, so this ends at the least n from below
            pieces = needed
            needed = self._pieces(float(scale * pieces ** (1.0 / (self.order + 1))))
        return pieces

    def _pieces(self, scale: float) -> int:
        """The pieces of all stretches, ``scale`` being ε^{−1/p} for the error ε of each."""
        return sum(
            max(n, math.ceil(content * scale * (1 - ROUNDING)))
            for content, n in zip(self._contents, self.least, strict=True)
        )

    count = predicted_pieces

    def to_json(self) -> dict[str, Any]:
        """Plain data: primitive, metric, order, constant (text, all digits), constants of the stretches.

        With c₁ also "next_constant" and "next_constants".
        """
        from decimal import Decimal, localcontext

        def total(constants: tuple[str, ...], order: int, degree: int) -> str:
            """(Σ c^{order/degree})^{degree/order}."""
            if order == degree:
                return str(sum((Decimal(c) for c in constants), Decimal(0)))
            with localcontext() as context:
                context.prec = self.digits + 10
                content = sum((Decimal(c) ** (Decimal(order) / degree) for c in constants), Decimal(0))
                whole = content ** (Decimal(degree) / order)
                context.prec = self.digits
                return str(+whole)

        data: dict[str, Any] = {
            "primitive": self.primitive,
            "metric": self.metric,
            "order": self.order,
            "constant": total(self.constants, self.order, self.order + (self.metric == "area")),
            "constants": list(self.constants),
        }
        if self.next_constants is not None:
            data["next_constant"] = total(self.next_constants, self.order, self.order)
            data["next_constants"] = list(self.next_constants)
        return data


#: digits of a constant by itself, of c₁, and of one that only predicts a spline's number of pieces
DIGITS, DIGITS_OF_NEXT, DIGITS_FOR_SPLINES = 20, 12, 9


def complexity_of_curve(
    curve: FormulaCurve, primitive: str, metric: str, split_at: Sequence[Any], next_term: bool
) -> Complexity:
    """What `osculant.complexity` says."""
    fit = choose(primitive, metric, dimension=curve.dimension, curve=curve.text)
    curve.check_finite()
    division = divide(curve, primitive, split_at)
    return complexity_of(curve, fit, division, _least(curve, fit, division), next_term)


def _least(curve: FormulaCurve, fit: Fit, division: Division) -> tuple[int, ...]:
    """How many pieces each stretch takes in any case: one, but helices turn by less than 2π each."""
    if curve.dimension == 2 or division.stretches[0].kind != "exact":
        return (1,) * len(division.stretches)
    from osculant.approximation.coordinates import Coordinates
    from osculant.approximation.exact_helices import Helices
    from osculant.curves.extent import extent

    coordinates = Coordinates(curve, extent(curve))
    return tuple(Helices(coordinates, fit, stretch).least for stretch in division.stretches)


def complexity_of(
    curve: FormulaCurve, fit: Fit, division: Division, least: tuple[int, ...], next_term: bool = False
) -> Complexity:
    """The complexity of a divided curve; ``least`` pieces are needed on each stretch in any case.

    Integrated in ball arithmetic; raises UndecidedError if that does not settle, and DomainError if c₁ is
    asked for in the metric "area" or in space, or its integral diverges at a special point.
    """
    if next_term and curve.dimension == 3:
        raise DomainError(f"The second term is not known for {fit.primitive.plural}: ask without next_term.")
    if next_term and fit.metric != "hausdorff":
        raise DomainError(
            f"The second term is not known for the metric {fit.metric!r}: ask without next_term."
        )
    constants = tuple(_constant(curve, fit, s).str(DIGITS, radius=False) for s in division.stretches)
    following = tuple(_next_constants(curve, fit, division)) if next_term else None
    return _complexity(fit, division, constants, least, DIGITS, following)


def _complexity(
    fit: Fit, division: Division, constants: tuple[str, ...], least: tuple[int, ...], digits: int,
    following: tuple[str, ...] | None = None,
) -> Complexity:  # fmt: skip
    order = fit.law(division.stretches[0].kind).spline_order  # a curve is level everywhere or nowhere
    return Complexity(fit.primitive.name, fit.metric, order, constants, least, digits, following)


def _constant(curve: FormulaCurve, fit: Fit, stretch: Stretch) -> Any:
    """C of one stretch, a ball; 0 where the curve is the primitive itself.

    Integrated from one point that is passed to the next, where the integrand is singular; contents add, but
    the constants of areas are powers of them.
    """
    from flint import arb

    from osculant.cas.laws.complexity import law_integral
    from osculant.cas.numbers.balls import PRECISION, precision

    if stretch.kind not in ("generic", "level"):
        return arb(0)
    law, passed = fit.law(stretch.kind), stretch.passed if fit.degree == 1 else ()
    with precision(PRECISION):
        ends = pairwise([stretch.low, *passed, stretch.high])
        return sum((law_integral(curve.balls, law, *pair)[0] for pair in ends), arb(0))


def _next_constants(curve: FormulaCurve, fit: Fit, division: Division) -> Iterator[str]:
    from osculant.cas.laws.next_term import next_constant

    for stretch in division.stretches:
        if stretch.kind != "generic":
            yield "0"
        else:
            value, _ = next_constant(curve.balls, fit.primitive.name, stretch.low, stretch.high)
            yield value.str(DIGITS_OF_NEXT, radius=False)


def quick_complexity(
    curve: FormulaCurve, fit: Fit, division: Division, least: tuple[int, ...], scale: float
) -> Complexity:
    """The same in doubles, to predict a spline's pieces; ``scale`` makes the curve's size about 1."""
    if curve.dimension == 3:  # there are no kernels for these densities
        return complexity_of(curve, fit, division, least)
    from osculant.kernels.quadrature import predicted, predicted_roughly

    order = fit.law().spline_order
    jet = curve.jet_for(fit.law())  # owns the code at its address
    constants = []
    for stretch in division.stretches:
        constant = 0.0
        if stretch.kind == "generic":
            power = fit.order / order  # of the content that C is
            arguments = fit.record(fit.order), jet.address, scale, stretch.a, stretch.b
            # beside cusps rounding hides which value is the least: nine digits would take balls minutes
            integral = predicted if fit.law().branch is None else predicted_roughly
            constant = integral(*arguments) ** power
            if math.isnan(constant) and fit.law().branch is not None:
                raise UndecidedError("The predicted number of pieces did not settle in doubles.")
        # N = C ε^{−1/order} has no unit: the constant of the scaled curve belongs to the scaled tolerance
        constant *= scale ** (-fit.degree / order)
        if math.isnan(constant):  # rounding beside a singular end: balls know better
            constant = float(_constant(curve, fit, stretch))
        constants.append(repr(constant))
    return _complexity(fit, division, tuple(constants), least, DIGITS_FOR_SPLINES)


def prediction(law: Complexity, tolerance: float, pieces: int) -> Prediction:
    """What a law says about one spline: at its tolerance, and at its number of pieces.

    >>> law = Complexity("conic", "hausdorff", 5, ("1.5",), (1,), 15)
    >>> prediction(law, 1e-5, 15).predicted_pieces
    15
    """
    return Prediction(law.predicted(tolerance), law.predicted_pieces(tolerance), law.predicted_error(pieces))
