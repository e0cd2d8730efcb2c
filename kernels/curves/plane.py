"""Sampling the user's curve inside kernels.

The compiled jet arrives as the address of ``void(double t, double *out)`` writing
x, x′, x″, y, y′, y″.  Coordinates are taken relative to an origin, scaled by a power of two and, where the
curve bends to the right, mirrored, so that every kernel sees a curve of size about 1 that bends to
the left.  ``place`` = (origin x, origin y, scale, ±1, noise) says so, noise being what rounding does to them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, cast

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from osculant.kernels.jit import kernel

#: doubles a jet of order 2 of a plane curve fills
JET_SIZE = 6

#: (origin x, origin y, scale, ±1, absolute error of the scaled coordinates)
Place = tuple[float, float, float, float, float]
#: (address of the compiled jet, place, scratch space for one jet: `JET_SIZE` doubles)
Source = tuple[int, Place, np.ndarray[Any, Any]]
#: (x, y, unit tangent x, unit tangent y) in the kernel's coordinates
Frame = tuple[float, float, float, float]


@intrinsic
def _call_address(typing: Any, address: Any, t: Any, out: Any) -> Any:
    """Call the machine code at ``address`` with (t, pointer to the data of ``out``)."""

    def emit(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        double = ir.DoubleType()
        function = ir.FunctionType(ir.VoidType(), [double, double.as_pointer()])
        pointer = builder.inttoptr(args[0], function.as_pointer())
        array = context.make_array(signature.args[2])(context, builder, args[2])
        builder.call(pointer, [args[1], array.data])
        return context.get_dummy_value()

    return types.void(types.int64, types.float64, out), emit


#: (address, t, out): evaluate a compiled jet; numba supplies the intrinsic's first argument
call_jet = cast(Callable[[int, float, np.ndarray[Any, Any]], None], _call_address)


@kernel
def sample(source: Source, t: float) -> tuple[float, float, float, float, float, float]:
    """Position, unit tangent, speed |α′| and curvature at t, in the kernel's coordinates."""
    address, place, jet = source
    call_jet(address, t, jet)
    scale = place[2]
    rise = scale * place[3]
    x, y = (jet[0] - place[0]) * scale, (jet[3] - place[1]) * rise
    dx, dy = jet[1] * scale, jet[4] * rise
    speed = math.sqrt(dx * dx + dy * dy)
    curvature = (dx * jet[5] * rise - dy * jet[2] * scale) / (speed * speed * speed)
    return x, y, dx / speed, dy / speed, speed, curvature


@kernel
def sample_many(address: int, times: np.ndarray[Any, Any], out: np.ndarray[Any, Any]) -> None:
    """Jets at all ``times`` (m,) into the rows of ``out`` (m, `JET_SIZE`), in the user's coordinates."""
    for i in range(times.shape[0]):
        call_jet(address, times[i], out[i])
