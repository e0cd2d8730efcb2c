"""What curves given by formulas have in common, in the plane and in space."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas.expression import Node, number, to_text
from osculant.cas.formulas.parser import parse, parse_constant, parse_tuple
from osculant.curves.kept import kept

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import ArrayLike, NDArray

    from osculant.cas.invariants.values import ExactValues
    from osculant.cas.jets.jet import Invariant
    from osculant.cas.laws.law import Law
    from osculant.cas.zeros.form_zeros import FormZeros
    from osculant.cas.zeros.points import SpecialPoint
    from osculant.codegen.blocks import Blocks
    from osculant.codegen.jets import CompiledJet

#: characters of a constant shown in messages
LONGEST_SHOWN = 40
#: intervals shorter than this part of their ends are beyond doubles
RESOLVED = 1e-13
#: digits of values if nothing else is asked for
DIGITS = 15
#: derivatives that `FormulaCurve.derivatives` gives at most
MOST_DERIVATIVES = 30


def as_constant(value: Any, argument: str) -> Node:
    """An end of an interval or another constant, exactly: a formula as text, a number, or sympy's.

    Floats are read as the decimal they print as.  Raises FormulaError, naming the ``argument``.

    >>> to_text(as_constant("2*pi", "high"))
    '2*pi'
    """
    if isinstance(value, Node):
        return value
    if isinstance(value, str):
        try:
            return parse_constant(value)
        except FormulaError as error:
            raise FormulaError(f"{argument}: {error}", argument=argument) from None
    if isinstance(value, float):
        if not math.isfinite(value):
            raise FormulaError(
                f"{argument} is {value}: give a finite number or a formula such as 2*pi.", argument=argument
            )
        return number(Fraction(repr(value)))
    if isinstance(value, (int, Fraction)):
        return number(Fraction(value))
    from osculant.cas.formulas.sympy_bridge import from_sympy

    return from_sympy(value)


class FormulaCurve(ABC):
    """A curve t ↦ (x(t), …) on a closed interval; `dimension` tells how many coordinates it has.

    Args:
        coordinates: text such as ``"t, t^2"``, or sympy or symengine expressions in t.
        low, high: the ends of the interval, as text, numbers or sympy constants; without them the curve
            has its invariants, but nothing can be approximated.

    Raises FormulaError for text that is no formula or has another number of coordinates, DomainError for an
    interval that is empty or reversed. Singular points are found when they matter, not here.
    """

    #: number of coordinates, what such a curve is called, and an example
    dimension: ClassVar[int]
    called: ClassVar[str]
    example: ClassVar[str]
    #: order of the jets that kernels sample, and of those that `tabulate` takes
    sampled_order: ClassVar[int]
    tabulated_order: ClassVar[int]
    law_order: ClassVar[int]
    #: of the forms whose zeros split splines, the one that takes the most derivatives
    highest_form: ClassVar[str]

    def __init__(self, coordinates: Any, low: Any = None, high: Any = None) -> None:
        self.coordinates = coordinates_of(coordinates)
        if len(self.coordinates) != self.dimension:
            raise FormulaError(
                f"A {self.called} curve has {_NUMBERS[self.dimension]} coordinates, such as "
                f"{self.example!r}; this formula has {len(self.coordinates)}."
            )
        self.text = ", ".join(to_text(c) for c in self.coordinates)
        if (low is None) != (high is None):
            raise DomainError("A curve needs both ends of its interval, or neither.")
        self._ends = None if low is None else (as_constant(low, "low"), as_constant(high, "high"))
        if self._ends is not None:
            self._check_interval(*self._ends)

    def _check_interval(self, low: Node, high: Node) -> None:
        from osculant.cas.numbers.balls import PRECISION, constant, precision

        with precision(PRECISION):
            a, b = constant(low), constant(high)
            for name, value, node in (("low", a, low), ("high", b, high)):
                if not value.is_finite():
                    raise FormulaError(
                        f"{name} {to_text(node)} has no finite real value: give another number.",
                        argument=name,
                    )
            if not a < b:
                raise DomainError(
                    f"The interval from {_shown(low)} to {_shown(high)} is empty or reversed: "
                    "the first end must be smaller than the second."
                )
            if not (
                math.isfinite(float(a))
                and math.isfinite(float(b))
                and float(b) - float(a) > RESOLVED * max(abs(float(a)), abs(float(b)))
            ):
                raise DomainError(
                    f"The interval from {_shown(low)} to {_shown(high)} is too short or too far out for "
                    "double numbers: scale the parameter."
                )

    @property
    def ends(self) -> tuple[Node, Node]:
        """The ends of the interval as exact constants; raises DomainError if the curve has none."""
        if self._ends is None:
            raise DomainError(f"The curve {self.text} has no interval: give both ends, such as 0 and 2*pi.")
        return self._ends

    @cached_property
    def interval(self) -> tuple[float, float]:
        """The ends of the interval as the nearest doubles."""
        from osculant.cas.numbers.balls import PRECISION, constant, precision

        with precision(PRECISION):
            low, high = (float(constant(end).mid()) for end in self.ends)
        return low, high

    @property
    @abstractmethod
    def balls(self) -> Any:
        """The curve in ball arithmetic, a `FormulaBalls` of jets of its dimension."""

    @property
    @abstractmethod
    def exact(self) -> ExactValues[Any]:
        """The invariants as simplified expressions."""

    @property
    @abstractmethod
    def zeros(self) -> FormZeros[Any]:
        """The zeros of its forms: of what splits a spline."""

    @abstractmethod
    def bend(self, t: Any) -> float:
        """The sign of the curvature at a ball t, at the current precision; 1 in space, where it has none."""

    @abstractmethod
    def _listed(self) -> tuple[Sequence[Invariant], Sequence[Invariant], int]:
        """The invariants of its jets, its lengths, and the order of the jets that they take."""

    @abstractmethod
    def _table(self, jet: CompiledJet, times: NDArray[float64]) -> dict[str, NDArray[float64]]:
        """What `tabulate` returns, from a jet of order `tabulated_order`; ``times`` of shape (m,)."""

    @cached_property
    def compiled(self) -> CompiledJet:
        """Machine code for position and the first `sampled_order` derivatives."""
        return self.compiled_to(self.sampled_order)

    @kept
    def compiled_to(self, order: int) -> CompiledJet:
        """Machine code for position and so many derivatives, made once."""
        from osculant.codegen.jets import compile_jet

        return compile_jet(self.coordinates, order)

    @property
    def jet_for_laws(self) -> CompiledJet:
        """Machine code for the derivatives that densities of laws take, `law_order` of them."""
        return self.compiled_to(self.law_order)

    def jet_for(self, law: Law) -> CompiledJet:
        """The machine code that the density of a law takes."""
        return self.jet_for_laws

    def jets(self, times: ArrayLike) -> NDArray[float64]:
        """Coordinates and their first `sampled_order` derivatives at ``times`` (m,), as doubles.

        Returns an array of shape (m, `dimension`, `sampled_order` + 1); NaN or infinite where undefined.

        >>> from osculant.curves.plane import PlaneCurve
        >>> PlaneCurve("t, t^3").jets([2.0]).tolist()
        [[[2.0, 1.0, 0.0], [8.0, 12.0, 12.0]]]
        """
        import numpy as np

        from osculant.kernels.curves.jets import sample_many

        flat = np.ascontiguousarray(times, dtype=np.float64).ravel()
        out = np.empty((flat.size, self.compiled.size))
        sample_many(self.compiled.address, flat, out)
        return out.reshape(flat.size, self.dimension, self.sampled_order + 1)

    def derivatives(self, times: ArrayLike, order: int = 1) -> NDArray[float64]:
        """Coordinates and their derivatives up to an order, 0 to 30, at ``times`` (m,), several at once.

        Returns an array of shape (`dimension`, order + 1, m); NaN or infinite where undefined.  Doubles from
        machine code that is made once for each order, with sin, cos, exp, log and cbrt of its own, each right
        to 2 units in the last place (`osculant.codegen.vectors`): what `jets` gives but for the last bits.
        Raises DomainError for another order.

        >>> from osculant.curves.plane import PlaneCurve
        >>> PlaneCurve("t, t^3").derivatives([1.0, 2.0], 2)[1].tolist()
        [[1.0, 8.0], [3.0, 12.0], [6.0, 12.0]]
        """
        import numpy as np

        if not (isinstance(order, int) and 0 <= order <= MOST_DERIVATIVES):
            raise DomainError(f"The order is {order!r}: give a whole number from 0 to {MOST_DERIVATIVES}.")
        return self._blocks(order)(np.asarray(times, dtype=np.float64).ravel())

    @kept
    def _blocks(self, order: int) -> Blocks:
        from osculant.codegen.blocks import compile_blocks

        return compile_blocks(self.coordinates, order)

    def invariants(self) -> dict[str, Any]:
        """All exact invariants by name: sympy expressions, tuples of them for vectors, None if undefined."""
        return dict(self.exact)

    def __getattr__(self, name: str) -> Any:
        # the invariants are attributes under their names: curvature, affine_curvature, torsion, arc_length, …
        if not name.startswith("_"):
            invariants, lengths, _ = self._listed()
            if name in {invariant.name for invariant in (*invariants, *lengths)}:
                return self.exact[name]
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def at(self, t: Any, digits: int = DIGITS) -> dict[str, Any]:
        """The invariants at one parameter value, as mpmath numbers correct to ``digits`` digits.

        Evaluated in ball arithmetic at growing precision until every digit is certain. Tuples for vectors,
        None where an invariant does not exist. Raises DomainError where the curve is not smooth.

        >>> from osculant.curves.plane import PlaneCurve
        >>> PlaneCurve("t, t^2").at("0", 5)["curvature"]
        mpf('2.0')
        """
        from osculant.curves.values import invariants_to_digits

        invariants, _, order = self._listed()
        return invariants_to_digits(self.balls, as_constant(t, "t"), digits, invariants, order)

    def tabulate(self, times: ArrayLike) -> dict[str, NDArray[float64]]:
        """The scalar invariants at many parameter values, by name, each an array as long as ``times``.

        Doubles from machine code, not certified; infinite or NaN where undefined. In the plane speed,
        curvature, curvature_slope (by arc length), affine_speed, affine_curvature, affine_curvature_slope; in
        space speed, curvature, torsion, curvature_slope, torsion_slope.

        >>> from osculant.curves.plane import PlaneCurve
        >>> PlaneCurve("t, t^2").tabulate([0.0, 1.0])["curvature"].round(6).tolist()
        [2.0, 0.178885]
        """
        import numpy as np

        jet = self.compiled_to(self.tabulated_order)
        return self._table(jet, np.ascontiguousarray(times, dtype=np.float64).ravel())

    @kept
    def check_finite(self) -> None:
        """Raises DomainError, naming the parameter value, where the curve is undefined or not smooth.

        >>> from osculant.curves.plane import PlaneCurve
        >>> PlaneCurve("t, 1/t", -1, 1).check_finite()
        Traceback (most recent call last):
        ...
        osculant.cas.errors.DomainError: The curve is undefined or infinite at t = 0 (a division by zero):
        take an interval without it.
        """
        self.zeros.require_finite(*self.ends, [self.highest_form])

    @kept
    def vanishes(self, form: str) -> bool:
        """Whether a form seems to vanish identically on the interval, to 600 digits; False is a proof.

        >>> from osculant.curves.plane import PlaneCurve
        >>> [PlaneCurve("t, t^2", 0, 1).vanishes(form) for form in ("inflection", "parabolic")]
        [False, True]
        """
        from osculant.cas.numbers.balls import PRECISION, constant, precision

        with precision(PRECISION):
            return self.zeros.vanishes(form, *map(constant, self.ends))

    def special_points(self, forms: Sequence[str]) -> list[SpecialPoint]:
        """The zeros of the named forms on the interval, in order, also at its ends.

        Simple ones are known to 2^-96 of the interval, more than doubles can tell.
        The curve has to be finite (`check_finite`), and no form to vanish identically.

        >>> from osculant.curves.plane import PlaneCurve
        >>> [sorted(point.kinds) for point in PlaneCurve("t, t^3", -1, 2).special_points(["inflection"])]
        [['inflection']]
        """
        return list(self._special_points(tuple(forms)))

    @kept
    def _special_points(self, forms: tuple[str, ...]) -> list[SpecialPoint]:
        from osculant.curves.special import together

        return together(self, forms, self._special_points_of_jets)

    def _special_points_of_jets(self, forms: Sequence[str], limit: int | None = None) -> list[SpecialPoint]:
        """The same by the forms over jets, balls looking at so many boxes only."""
        from osculant.curves.special import BITS

        return self.zeros.within(*self.ends, forms, limit, BITS)

    def __repr__(self) -> str:
        where = "" if self._ends is None else f", t from {to_text(self._ends[0])} to {to_text(self._ends[1])}"
        return f"<{type(self).__name__} {self.text}{where}>"


_NUMBERS = {2: "two", 3: "three"}


def _shown(constant: Node) -> str:
    """A constant in a message: its formula, unless that is long."""
    text = to_text(constant)
    return text if len(text) <= LONGEST_SHOWN else text[: LONGEST_SHOWN - 1] + "…"


def coordinates_of(given: Any) -> tuple[Node, ...]:
    """The coordinates' expressions, from text or a sequence of formulas, as many as there are.

    >>> len(coordinates_of("t, t^2, t^3")), len(coordinates_of(["t", "t^2"]))
    (3, 2)
    """
    if isinstance(given, str):
        return parse_tuple(given)
    if isinstance(given, Sequence):
        return tuple(part if isinstance(part, Node) else _coordinate(part) for part in given)
    raise FormulaError(f"A curve is given by two or three formulas, such as 't, t^2'; {given!r} is not.")


def _coordinate(given: Any) -> Node:
    if isinstance(given, str):
        return parse(given)
    from osculant.cas.formulas.sympy_bridge import from_sympy

    return from_sympy(given)
