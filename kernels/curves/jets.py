"""Calling a compiled jet: machine code ``void(double t, double *out)`` at an address."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

import numpy as np

from osculant.kernels.jit import kernel, when_numba_is_there


class _JetCall:
    """What calls the machine code at an address: an intrinsic of numba's, made when that is there."""

    __name__ = "call_jet"

    def __init__(self) -> None:
        self._intrinsic: Any = None
        when_numba_is_there(self._attach)

    def _attach(self) -> None:
        from numba.extending import intrinsic

        self._intrinsic = intrinsic(_call)

    @property
    def _numba_type_(self) -> Any:
        """What numba takes it for inside a kernel."""
        from numba.core.registry import cpu_target

        return cpu_target.typing_context.resolve_value_type(self._intrinsic)


def _call(typing: Any, address: Any, t: Any, out: Any) -> Any:
    """Call ``void(double t, double *out)`` at the address with the data of an array."""
    from llvmlite import ir
    from numba import types

    def emit(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        double = ir.DoubleType()
        function = ir.FunctionType(ir.VoidType(), [double, double.as_pointer()])
        pointer = builder.inttoptr(args[0], function.as_pointer())
        array = context.make_array(signature.args[2])(context, builder, args[2])
        builder.call(pointer, [args[1], array.data])
        return context.get_dummy_value()

    return types.void(types.int64, types.float64, out), emit


#: (address, t, out): evaluate a compiled jet; inside kernels only
call_jet = cast(Callable[[int, float, np.ndarray[Any, Any]], None], _JetCall())


@kernel
def sample_many(address: int, times: np.ndarray[Any, Any], out: np.ndarray[Any, Any]) -> None:
    """Jets at all ``times`` (m,) into rows of ``out`` (m, doubles of a jet), in the user's coordinates."""
    for i in range(times.shape[0]):
        call_jet(address, times[i], out[i])
