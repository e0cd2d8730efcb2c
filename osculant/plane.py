"""Plane curves given by formulas."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.expression import Node, from_sympy, number
from osculant.cas.formula import parse_constant, parse_tuple
from osculant.cas.text import to_text

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from osculant.cas.balls import CurveBalls
    from osculant.cas.plane_exact import ExactInvariants
    from osculant.codegen.jets import CompiledJet

#: characters of a constant shown in messages
LONGEST_SHOWN = 40
#: intervals shorter than this part of their ends are beyond doubles
RESOLVED = 1e-13
#: digits of `PlaneCurve.at` if nothing else is asked for
DIGITS = 15


def as_constant(value: Any, what: str) -> Node:
    """An end of an interval or another constant, exactly: a formula as text, a number, or sympy's.

    Floats are read as the decimal they print as.  Raises FormulaError, naming ``what``.

    >>> to_text(as_constant("2*pi", "the end"))
    '2*pi'
    """
    if isinstance(value, Node):
        return value
    if isinstance(value, str):
        try:
            return parse_constant(value)
        except FormulaError as error:
            raise FormulaError(f"{what}: {error}") from None
    if isinstance(value, float):
        if not math.isfinite(value):
            raise FormulaError(f"{what} is {value}: give a finite number or a formula such as 2*pi.")
        return number(Fraction(repr(value)))
    if isinstance(value, (int, Fraction)):
        return number(Fraction(value))
    return from_sympy(value)


class PlaneCurve:
    """A plane curve t ↦ (x(t), y(t)) on a closed interval.

    Args:
        coordinates: text such as ``"t*cos(t), t*sin(t)"``, or two sympy or symengine expressions in t.
        low, high: the ends of the interval, as text, numbers or sympy constants; without them the curve
            has its invariants, but nothing can be approximated.

    Raises FormulaError for text that is no formula or has not two coordinates, DomainError for an
    interval that is empty or reversed.  Singular points are found when they matter, not here.

    >>> spiral = PlaneCurve("t*cos(t), t*sin(t)", "pi/6", "2*pi")
    >>> spiral.text, spiral.curvature
    ('t*cos(t), t*sin(t)', (t**2 + 2)/(t**2 + 1)**(3/2))
    """

    def __init__(self, coordinates: Any, low: Any = None, high: Any = None) -> None:
        self.coordinates = _coordinates(coordinates)
        self.text = ", ".join(to_text(c) for c in self.coordinates)
        if (low is None) != (high is None):
            raise DomainError("A curve needs both ends of its interval, or neither.")
        self._ends = None if low is None else (as_constant(low, "--from"), as_constant(high, "--to"))
        if self._ends is not None:
            self._check_interval(*self._ends)

    def _check_interval(self, low: Node, high: Node) -> None:
        from osculant.cas.balls import PRECISION, constant, precision

        with precision(PRECISION):
            a, b = constant(low), constant(high)
            for name, value, node in (("--from", a, low), ("--to", b, high)):
                if not value.is_finite():
                    raise FormulaError(
                        f"{name} {to_text(node)} has no finite real value: give another number."
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

    @property
    def interval(self) -> tuple[float, float]:
        """The ends of the interval as the nearest doubles."""
        from osculant.cas.balls import PRECISION, constant, precision

        with precision(PRECISION):
            low, high = (float(constant(end).mid()) for end in self.ends)
        return low, high

    @cached_property
    def balls(self) -> CurveBalls:
        """The curve in ball arithmetic."""
        from osculant.cas.balls import CurveBalls

        return CurveBalls(self.coordinates)

    @cached_property
    def compiled(self) -> CompiledJet:
        """Machine code for position, first and second derivative."""
        from osculant.codegen.jets import compile_jet

        return compile_jet(self.coordinates, 2)

    @cached_property
    def exact(self) -> ExactInvariants:
        """The invariants as simplified expressions."""
        from osculant.cas.plane_exact import ExactInvariants

        return ExactInvariants(*self.coordinates, "t", *(self._ends or ()))

    def invariants(self) -> dict[str, Any]:
        """All exact invariants by name: sympy expressions, pairs of them for vectors, None if undefined."""
        return dict(self.exact)

    def __getattr__(self, name: str) -> Any:
        # the invariants are attributes under their names: curvature, affine_curvature, arc_length, …
        from osculant.cas.invariants import INVARIANTS

        if name in {*(invariant.name for invariant in INVARIANTS), "arc_length", "affine_arc_length"}:
            return self.exact[name]
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def tabulate(self, times: ArrayLike) -> dict[str, NDArray[np.float64]]:
        """The scalar invariants at many parameter values, by name, each an array as long as ``times``.

        Doubles from machine code, not certified: speed, curvature, curvature_slope (by arc length),
        affine_speed, affine_curvature, affine_curvature_slope; infinite or NaN where undefined.

        >>> PlaneCurve("t, t^2").tabulate([0.0, 1.0])["curvature"].round(6).tolist()
        [2.0, 0.178885]
        """
        import numpy as np

        from osculant.codegen.jets import compile_jet
        from osculant.kernels.invariants import COLUMNS, invariants_at

        flat = np.ascontiguousarray(times, dtype=np.float64).ravel()
        out = np.empty((flat.size, len(COLUMNS)))
        jet = compile_jet(self.coordinates, 5)  # owns the code at its address
        invariants_at(jet.address, flat, out)
        return {name: out[:, i] for i, name in enumerate(COLUMNS)}

    def at(self, t: Any, digits: int = DIGITS) -> dict[str, Any]:
        """The invariants at one parameter value, as mpmath numbers correct to ``digits`` digits.

        Evaluated in ball arithmetic at growing precision until every digit is certain.  Pairs for vectors,
        None where an invariant does not exist.  Raises DomainError where the curve is not smooth.

        >>> PlaneCurve("t, t^2").at("0", 5)["curvature"]
        mpf('2.0')
        """
        from osculant.evaluation import invariants_to_digits

        return invariants_to_digits(self.balls, as_constant(t, "--at"), digits)

    def __repr__(self) -> str:
        where = "" if self._ends is None else f", t from {to_text(self._ends[0])} to {to_text(self._ends[1])}"
        return f"<PlaneCurve {self.text}{where}>"


def _shown(constant: Node) -> str:
    """A constant in a message: its formula, unless that is long."""
    text = to_text(constant)
    return text if len(text) <= LONGEST_SHOWN else text[: LONGEST_SHOWN - 1] + "…"


def _coordinates(given: Any) -> tuple[Node, Node]:
    if isinstance(given, str):
        nodes = parse_tuple(given)
    elif isinstance(given, Sequence):
        nodes = tuple(part if isinstance(part, Node) else _coordinate(part) for part in given)
    else:
        raise FormulaError(f"A curve is given by two formulas, such as 't, t^2'; {given!r} is not.")
    if len(nodes) != 2:
        raise FormulaError(
            f"A plane curve has two coordinates, such as 't, t^2'; this formula has {len(nodes)}."
        )
    return nodes[0], nodes[1]


def _coordinate(given: Any) -> Node:
    from osculant.cas.formula import parse

    return parse(given) if isinstance(given, str) else from_sympy(given)
