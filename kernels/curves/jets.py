"""Calling a compiled jet: machine code ``void(double t, double *out)`` at an address."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from osculant.kernels.jit import kernel


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
def sample_many(address: int, times: np.ndarray[Any, Any], out: np.ndarray[Any, Any]) -> None:
    """Jets at all ``times`` (m,) into rows of ``out`` (m, doubles of a jet), in the user's coordinates."""
    for i in range(times.shape[0]):
        call_jet(address, times[i], out[i])
