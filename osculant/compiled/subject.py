"""What is to be compiled: a curve or a place for one, and what is to be known of it at run time."""

from __future__ import annotations

import keyword
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError, FormulaError, OsculantError
from osculant.cas.formulas.expression import Node, to_text
from osculant.cas.formulas.graph import variables
from osculant.cas.formulas.parser import parse_tuple
from osculant.curves.curve import as_constant, coordinates_of

if TYPE_CHECKING:
    from osculant.curves.curve import FormulaCurve

#: names that a library, a parameter, may have
NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,39}")
#: names in the emitted functions, which no parameter may have
TAKEN = frozenset({
    "t", "e", "pi", "low", "high", "tolerance", "pieces", "number", "capacity", "count", "splits",
    "split_count", "jet", "evaluate", "parameters", "error",
})  # fmt: skip


@dataclass(frozen=True)
class Subject:
    """A curve to be compiled.

    Attributes:
        name: what the emitted functions and files are called after.
        coordinates: formulas in t and the parameters; None if the caller has a function for the curve.
        dimension: 2 or 3.
        parameters: names of the constants that are given at run time.
        ends: of the interval, exact constants; None if they are given at run time.
    """

    name: str
    coordinates: tuple[Node, ...] | None
    dimension: int
    parameters: tuple[str, ...] = ()
    ends: tuple[Node, Node] | None = None

    @property
    def fixed(self) -> bool:
        """Whether everything is known before run time."""
        return self.coordinates is not None and self.ends is not None and not self.parameters

    @property
    def text(self) -> str:
        """The formula, for people."""
        if self.coordinates is None:
            return "the caller's jet"
        return ", ".join(map(to_text, self.coordinates))

    @property
    def curve(self) -> FormulaCurve:
        """The curve, if it is `fixed` or only its interval is free."""
        from osculant.curves.plane import PlaneCurve
        from osculant.curves.space import SpaceCurve

        kind = PlaneCurve if self.dimension == 2 else SpaceCurve
        return kind(self.coordinates, *(self.ends or (None, None)))


def subject(
    formulas: Any, low: Any = None, high: Any = None, parameters: Any = (), name: str = "curve", jet: int = 0
) -> Subject:
    """The subject of what a user asks for.

    Args:
        formulas: text, or two or three formulas; None with ``jet``.
        low: one end of the interval, a constant; None if the interval is given at run time.
        high: the other end.
        parameters: names, as text with blanks or commas between, or a sequence.
        name: a name in C.
        jet: 2 or 3, the dimension, if the caller has a function for the curve.

    Raises FormulaError or DomainError for what makes no sense.

    >>> subject("a*cos(t), b*sin(t)", 0, "2*pi", "a b", "ellipse").parameters
    ('a', 'b')
    >>> subject("a*cos(t), sin(t)")
    Traceback (most recent call last):
    ...
    osculant.cas.errors.FormulaError: The name 'a' is unknown (variable allowed: t).
      a*cos(t), sin(t)
      ^
    """
    names = _names(parameters)
    _check_name(name)
    if (low is None) != (high is None):
        raise DomainError("An interval has two ends: give both, or neither to have them at run time.")
    ends = None if low is None else (as_constant(low, "low"), as_constant(high, "high"))
    if formulas is None:
        if jet not in (2, 3):
            raise DomainError("There is no formula: give one, or the dimension of your own jet, 2 or 3.")
        return Subject(name, None, jet, names, ends)
    if jet:
        raise DomainError("Both a formula and a jet of your own are wanted: leave one out.")
    coordinates = _parsed(formulas, names)
    if len(coordinates) not in (2, 3):
        raise FormulaError(f"A curve has two or three coordinates; this formula has {len(coordinates)}.")
    unused = [each for each in names if each not in variables(coordinates)]
    if unused:
        raise DomainError(f"The formula has no parameter {unused[0]!r}: leave it out.")
    return Subject(name, coordinates, len(coordinates), names, ends)


def _parsed(formulas: Any, names: Sequence[str]) -> tuple[Node, ...]:
    if isinstance(formulas, str):
        return parse_tuple(formulas, ("t", *names))
    coordinates = coordinates_of(formulas)
    free = sorted(variables(coordinates) - {"t", *names})
    if free:
        raise FormulaError(
            f"The formula contains the variable {free[0]!r}: name it among the parameters, or leave it out."
        )
    return coordinates


def _names(parameters: Any) -> tuple[str, ...]:
    names = (
        re.split(r"[\s,]+", parameters.strip()) if isinstance(parameters, str) else list(map(str, parameters))
    )
    names = [name for name in names if name]
    for name in names:
        if not NAME.fullmatch(name) or name in TAKEN or keyword.iskeyword(name) or name.startswith("_"):
            raise DomainError(f"{name!r} cannot be the name of a parameter: choose another, such as a or r0.")
    if len(set(names)) < len(names):
        raise DomainError(f"A parameter is named twice in {' '.join(names)}: name each once.")
    return tuple(names)


def _check_name(name: str) -> None:
    if not NAME.fullmatch(name) or keyword.iskeyword(name):
        raise OsculantError(
            f"{name!r} cannot be the name of a library: take up to 40 letters, digits and _, a letter first."
        )
