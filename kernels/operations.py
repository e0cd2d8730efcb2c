"""What every kind of piece can do, by the type of its record.

A record is a `NamedTuple` that stands for a fit: a primitive, its metric and rule.  Generic kernels
(`search`, `given_knots`, `counting`, `quadrature`, `course`) take one as first argument, and its type chooses
the functions of its family when numba compiles: nothing is asked at run time, and each fit is compiled alone.
A family registers its records in its ``records`` module; generic kernels import no family.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple, TypeVar, cast, get_type_hints

from osculant.kernels.jit import BARE, when_numba_is_there

Function = TypeVar("Function", bound=Callable[..., Any])

#: the operations by name, and what each record does for them
_OPERATIONS: dict[str, Callable[..., Any]] = {}
_RECORDS: dict[type, dict[str, Any]] = {}
_COLUMNS: dict[type, int] = {}
_PIECES: dict[type, Any] = {}


def operation(stub: Function) -> Function:
    """Make a function of a record, and whatever else it takes, one that records implement.

    Its body is what records do that implement nothing of their own, if it has any.
    """

    def choose(fit: Any, *args: Any) -> Callable[..., Any]:
        chosen = _RECORDS[fit.instance_class].get(stub.__name__, stub)
        if not callable(chosen):
            return lambda fit: chosen
        return cast(Callable[..., Any], getattr(chosen, "__wrapped__", chosen))  # of a kernel the function

    def attach() -> None:
        from numba.extending import overload

        overload(stub, strict=False, jit_options=BARE)(choose)

    when_numba_is_there(attach)
    _OPERATIONS[stub.__name__] = stub
    return stub


def register(record: type, columns: int, /, **functions: Any) -> None:
    """Register what a fit does for each operation.

    Args:
        record: a `NamedTuple` class of its own, importable: numba's cache names it.
        columns: of the family's rows.
        functions: by the name of the operation a kernel with its arguments, or a constant that it returns.

    Raises ValueError for a record that is registered already.
    """
    if record in _RECORDS:
        raise ValueError(f"The fit {record.__name__} is registered already.")
    _RECORDS[record], _COLUMNS[record] = functions, columns


def columns(record: type) -> int:
    """How many columns the rows of a fit have."""
    return _COLUMNS[record]


def piece_type(record: type) -> Any:
    """The `NamedTuple` of numbers that `shape` makes for a fit, by the class of its record."""
    if record not in _PIECES:
        made = _RECORDS[record]["shape"]
        _PIECES[record] = get_type_hints(getattr(made, "__wrapped__", made))["return"]
    return _PIECES[record]


def operations() -> Mapping[str, Callable[..., Any]]:
    """All operations by name."""
    return MappingProxyType(_OPERATIONS)


def registered() -> Mapping[type, Mapping[str, Any]]:
    """What every record does."""
    return MappingProxyType(_RECORDS)


#: samples cannot tell a whole turn from none; less what a course may be wrong by
TURNING = 2.0 * math.pi - 0.05


#: what fast steps have to come to for smooth errors: a correction that Newton's method squares, or the error
#: of an area itself
SETTLED, EXACT = 1e-9, 1e-12


class Rules(NamedTuple):
    """How arcs are searched for.

    Attributes:
        order: the error of a short arc is of this order in its length.
        settled: what fast steps have to come to for errors that are smooth in the ends of an arc.
        aim: the secant aims here in the window of admissible errors, 0 being its upper end.
        stride: an arc changes its length at most by this factor in one fast step.
        short: if less than this part of an arc would be left to the end of the stretch, doubles can hardly
            carry it, and the arc ends early.
        checked: equidistant samples of the measurement that decides, at least,
        careful: and of a careful search.
        turning: no piece is sought for an arc that turns by more than this.
    """

    order: float
    settled: float
    aim: float = 0.3
    stride: float = 3.0
    short: float = 1e-6
    checked: int = 8
    careful: int = 40
    turning: float = TURNING


# The ends of arcs are frames, points with tangents, in the kernel's coordinates.  ``source`` is what samples
# the curve, ``space`` the family's scratch space.  A *state* is what the fast steps of one arc leave for
# those of the next; a *choice* tells one member of the family of pieces that are tangent at both ends, and a
# *piece* all that is recorded of it.


@operation
def rules(fit: Any) -> Any:
    """The `Rules` of the search."""


@operation
def source(fit: Any, address: Any, place: Any, course: Any) -> Any:
    """What samples the curve whose compiled jet is at the address, in the coordinates of the place.

    The course (`osculant.kernels.course`) is that of the stretch.
    """


@operation
def workspace(fit: Any) -> Any:
    """Scratch space, made once per spline."""


@operation
def frame(fit: Any, source: Any, t: Any) -> Any:
    """The frame of the curve at t."""


@operation
def pace(fit: Any, source: Any, t: Any) -> Any:
    """(speed, turning of the tangent per unit of the parameter) at t."""


@operation
def begin(fit: Any) -> Any:
    """The state before anything is known."""


@operation
def renew(fit: Any, state: Any) -> Any:
    """The state for another arc, from that of the arc before."""
    return state


@operation
def step(
    fit: Any, source: Any, a: Any, start: Any, b: Any, end: Any, state: Any, calm: Any, space: Any
) -> Any:
    """(error, choice, settled, state) of one fast evaluation of the arc [a, b].

    The error is NaN if nothing was found; settled, it would change no more than by the part ``calm``.
    """


@operation
def confirm(
    fit: Any, choice: Any, source: Any, a: Any, start: Any, b: Any, end: Any, points: Any, space: Any
) -> Any:
    """(error, piece) of the choice, measured from ``points`` samples or more; infinite if there is none."""


@operation
def best(fit: Any, source: Any, a: Any, start: Any, b: Any, end: Any, points: Any, space: Any) -> Any:
    """(error, piece) of the best piece of the arc, sought with care; an infinite error if there is none."""


@operation
def resume(fit: Any, piece: Any, source: Any, a: Any, b: Any, space: Any) -> Any:
    """The state after a careful search."""
    return begin(fit)


@operation
def record(fit: Any, row: Any, piece: Any, start: Any, end: Any, source: Any) -> Any:
    """Write a piece into a row of the table, from `SHAPE` on; the columns before are written already."""


@operation
def shape(fit: Any, row: Any, place: Any, error: Any) -> Any:
    """The piece in a row of the table, in the user's coordinates: a `NamedTuple` of numbers only."""


# What compiled approximators do besides: they take a curve's size and frames as numbers in the user's
# coordinates (`osculant.kernels.standalone`).


@operation
def dimension(fit: Any) -> Any:
    """The number of coordinates."""


@operation
def place_in(fit: Any, size: Any, side: Any) -> Any:
    """The kernels' place of a curve from the numbers of its size (`SCALE` …), bending to a side."""


@operation
def frame_in(fit: Any, place: Any, row: Any, first: Any) -> Any:
    """The frame whose point and tangent, in the user's coordinates, are in a row from ``first`` on."""


#: the numbers of a curve's size: the kernels' scale and noise, the floor of tolerances, the share of one that
#: is kept for rounding and the least of it, the resolution over the tolerance, and the origin's coordinates
SCALE, NOISE, FLOOR, SHARE, LEAST_SHARE, RESOLUTION, ORIGIN = 0, 1, 2, 3, 4, 5, 6


#: columns of every row: the interval of the parameter, the error and why the arc ends; then its shape
A, B, ERROR, REASON, SHAPE = 0, 1, 2, 3, 4
