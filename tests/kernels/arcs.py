"""Arcs of curves as kernels take them, and what fits do as Python can call it.

Generic kernels with a record as first argument: the cache of their machine code knows its sources by it.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.cas.formulas.parser import parse_tuple
from osculant.codegen.jets import CompiledJet, compile_jet
from osculant.kernels import operations, search
from osculant.kernels.biarcs.records import Biarc, EquisymmetricBiarc
from osculant.kernels.conics.records import (
    Conic,
    EquisymmetricConic,
    LeastAreaConic,
    Parabola,
    ParabolaArea,
)
from osculant.kernels.course import lay_out
from osculant.kernels.cubics.records import Cubic, CubicArea
from osculant.kernels.curves import plane, space
from osculant.kernels.jit import kernel
from osculant.kernels.polygons.records import Chord, ChordArea

#: what rounding does to coordinates of about 1
NOISE = 4 * math.ulp(1.0)
#: places where the kernel's coordinates are the user's, or y is mirrored
HERE = plane.Place(0.0, 0.0, 1.0, 1.0, NOISE)
MIRRORED = HERE._replace(side=-1.0)
SPACE = space.Place(0.0, 0.0, 0.0, 1.0, NOISE / 2)

#: panels of courses at first
PANELS = 16

#: all fits in the plane; as tuples they are equal, and told apart by their types or by `is`
PLANE = (
    Parabola(),
    Conic(),
    Biarc(),
    Chord(),
    Cubic(),
    ParabolaArea(),
    EquisymmetricConic(),
    LeastAreaConic(),
    EquisymmetricBiarc(),
    ChordArea(),
    CubicArea(),
)


def name_of(fit: Any) -> str:
    """For the names of parametrised tests."""
    return type(fit).__name__


def jet_of(text: str, order: int = 2) -> CompiledJet:
    """The compiled jet of a curve."""
    return compile_jet(parse_tuple(text), order)


class Arc(NamedTuple):
    """An arc with its end frames; the jet is kept, as the source knows only its address."""

    jet: CompiledJet
    source: Any
    a: float
    start: Any
    b: float
    end: Any

    @property
    def given(self) -> tuple[Any, float, Any, float, Any]:
        """(source, a, start, b, end), as operations take them."""
        return self.source, self.a, self.start, self.b, self.end


def source_at(jet: CompiledJet, place: Any = HERE) -> Any:
    """What samples a curve of the plane or of space."""
    module = plane if isinstance(place, plane.Place) else space
    return module.alone(jet.address, place)


def frame_at(jet: CompiledJet, t: float, place: Any = HERE) -> Any:
    """The frame of a curve, in the kernel's coordinates."""
    module = plane if isinstance(place, plane.Place) else space
    return module.frame(source_at(jet, place), t)


def arc(jet: CompiledJet, a: float, b: float, place: Any = HERE) -> Arc:
    """The arc of a curve over [a, b]."""
    return Arc(jet, source_at(jet, place), a, frame_at(jet, a, place), b, frame_at(jet, b, place))


@kernel
def _best(fit: Any, source: Any, a: float, start: Any, b: float, end: Any, points: int) -> Any:
    return operations.best(fit, source, a, start, b, end, points, operations.workspace(fit))


@kernel
def _confirm(
    fit: Any, choice: Any, source: Any, a: float, start: Any, b: float, end: Any, points: int
) -> Any:
    return operations.confirm(fit, choice, source, a, start, b, end, points, operations.workspace(fit))


@kernel
def begin(fit: Any) -> Any:
    """The state before anything is known."""
    return operations.begin(fit)


@kernel
def _visit(
    fit: Any, source: Any, a: float, start: Any, b: float, end: Any, state: Any, calm: float, rounds: int
) -> Any:
    room = operations.workspace(fit)
    error, choice, settled, state = operations.step(fit, source, a, start, b, end, state, calm, room)
    for _ in range(rounds - 1):
        error, choice, settled, state = operations.step(fit, source, a, start, b, end, state, calm, room)
    return error, choice, settled, state


def best(fit: Any, on: Arc, points: int = 40) -> Any:
    """(error, piece) of the best piece of an arc, sought with care."""
    return _best(fit, *on.given, points)


def confirm(fit: Any, choice: Any, on: Arc, points: int = 8) -> Any:
    """(error, piece) of a choice, measured."""
    return _confirm(fit, choice, *on.given, points)


def visit(fit: Any, on: Arc, calm: float, rounds: int = 8, state: Any = None) -> Any:
    """(error, choice, settled, state) after some fast steps on one arc."""
    return _visit(fit, *on.given, begin(fit) if state is None else state, calm, rounds)


def course_of(fit: Any, jet: CompiledJet, a: float, b: float, place: Any = HERE, rows: int = 4096) -> Any:
    """The course of a stretch."""
    course = np.empty((rows, 3))
    count = lay_out(fit, jet.address, place, np.linspace(a, b, PANELS + 1), course)
    assert count > 0
    return course[:count].copy()


def stretch(
    fit: Any, jet: CompiledJet, a: float, b: float, place: Any = HERE
) -> tuple[Any, int, Any, float, Any, float, Any]:
    """The arguments with which the search, and the count, begin."""
    return fit, jet.address, place, a, frame_at(jet, a, place), b, frame_at(jet, b, place)


def spline(
    fit: Any,
    jet: CompiledJet,
    a: float,
    b: float,
    window: tuple[float, float],
    place: Any = HERE,
    capacity: int = 4096,
    length: float | None = None,
) -> tuple[Any, float, int]:
    """(rows, where the last piece ends, careful searches) of the greedy spline of a stretch.

    The window of admissible errors, as the errors in the rows, is in the kernel's units.
    """
    table = np.empty((capacity, operations.columns(type(fit))))
    course = course_of(fit, jet, a, b, place)
    first = (b - a) / 8 if length is None else length
    call = (*stretch(fit, jet, a, b, place), *window, first, course)
    count, reached, careful = search.spline(*call, table)
    return table[:count], reached, careful
