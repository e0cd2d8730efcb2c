"""Plane and space curves in ball arithmetic: formulas whose jets carry the invariants."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

from osculant.cas.formulas.expression import Node
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.jets.space import SpaceJet
from osculant.cas.numbers.balls import FormulaBalls


class CurveBalls(FormulaBalls[PlaneJet]):
    """A plane curve: enclosures of the Taylor series of two coordinates."""

    def __init__(self, coordinates: Sequence[Node], variable: str = "t") -> None:
        super().__init__(coordinates, PlaneJet, variable)


class SpaceBalls(FormulaBalls[SpaceJet]):
    """A space curve: enclosures of the Taylor series of three coordinates.

    Of a ball around 0 that stands for a sum of squares, such as |α̇ × α̈|² where κ = 0, the root is finite.

    >>> from flint import arb
    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> SpaceBalls(parse_tuple("cos(t), sin(t), 0")).jet(arb(0), 3).curvature
    1.00000000000000
    """

    def __init__(self, coordinates: Sequence[Node], variable: str = "t") -> None:
        super().__init__(coordinates, partial(SpaceJet, root=_root_of_squares), variable)


def _root_of_squares(value: Any, _degree: int) -> Any:
    """The square root of what is known not to be negative."""
    return value.nonnegative_part().sqrt()
