"""The jet compiler: a Taylor program → machine code in milliseconds (design, step 3b).

`compile_jet` prints the straight-line program as LLVM IR and hands it to llvmlite.  What comes back
is a `CompiledJet`, which owns its code and gives kernels a plain address of type
``void(double t, double *out)``; ``out`` receives the derivatives of the first formula, then those of
the second, and so on.  Where doubles overflow on the way to a moderate number, as 1/cosh(1000·t) does, the
code asks balls.
"""

from __future__ import annotations

import ctypes
import math
import threading
from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from typing import Any

import llvmlite.binding as llvm
import numpy as np
from llvmlite import ir

from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.rationals import as_double
from osculant.cas.numbers.taylor import Program, program

_DOUBLE = ir.DoubleType()
#: operations by which a value may be moderate though another on the way is beyond doubles
_OVERFLOWING = {"exp", "sinh", "cosh", "power", "div"}
#: bits of the balls that are asked then
_BITS = 128
#: what is asked: ``void(double t, double *out)``
_CALLBACK = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.POINTER(ctypes.c_double))
_LOCK = threading.Lock()


@cache
def target() -> tuple[Any, str, str]:
    """The host's target, processor and features, found once per process."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    return llvm.Target.from_default_triple(), llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()


def _target_machine() -> Any:
    """A new target machine: the engine that is given one owns it and frees it.

    A program is a straight line in which nothing is written twice: LLVM's passes leave its code as fast as it
    was, to the bit, and take longer than all else.
    """
    host, processor, features = target()
    return host.create_target_machine(cpu=processor, features=features, opt=1)


def libm_function(module: ir.Module, name: str, arguments: int) -> ir.Function:
    """A function of libm's in a module, declared there once."""
    function = module.globals.get(name)
    if function is None:
        function = ir.Function(module, ir.FunctionType(_DOUBLE, [_DOUBLE] * arguments), name=name)
        function.attributes.add("nounwind")
        function.attributes.add("readnone")
    return function


class _Printer:
    """Prints one program as the body of an LLVM function.

    Args:
        compiled: the program.
        instead: the address of a function that is called where a value is not finite, if there is one.
    """

    def __init__(self, compiled: Program, instead: int | None) -> None:
        self.module = ir.Module(name="jet")
        signature = ir.FunctionType(ir.VoidType(), (_DOUBLE, _DOUBLE.as_pointer()))
        function = ir.Function(self.module, signature, name="jet")
        self.builder = ir.IRBuilder(function.append_basic_block("entry"))
        t, out = function.args
        values: list[Any] = []
        for step in compiled.instructions:
            values.append(
                t
                if step.op == "variable"
                else self.value(step.op, step.value, [values[a] for a in step.args])
            )
        place = 0
        for output in compiled.outputs:
            for index in output:
                slot = self.builder.gep(out, [ir.Constant(ir.IntType(64), place)])
                self.builder.store(values[index], slot)
                place += 1
        if instead is not None:
            total = values[compiled.outputs[0][0]]
            for index in [index for output in compiled.outputs for index in output][1:]:
                total = self.builder.fadd(total, values[index])
            nothing = self.builder.fsub(total, total)  # NaN unless all are finite
            with self.builder.if_then(self.builder.fcmp_unordered("uno", nothing, nothing), likely=False):
                address = ir.Constant(ir.IntType(64), instead)
                self.builder.call(self.builder.inttoptr(address, function.type), [t, out])
        self.builder.ret_void()

    def value(self, op: str, value: Fraction | str | None, args: list[Any]) -> Any:
        """The LLVM value of one instruction."""
        b = self.builder
        if op == "number":
            assert isinstance(value, Fraction)
            return ir.Constant(_DOUBLE, as_double(value))
        if op == "constant":
            return ir.Constant(_DOUBLE, math.pi if value == "pi" else math.e)
        if op == "power":
            assert isinstance(value, Fraction)
            return self.call("pow", [args[0], ir.Constant(_DOUBLE, as_double(value))])
        if op == "call":
            return self.sign(args[0]) if value == "sign" else self.call(str(value), args)
        return {"add": b.fadd, "sub": b.fsub, "mul": b.fmul, "div": b.fdiv, "neg": b.fneg}[op](*args)

    def call(self, name: str, args: list[Any]) -> Any:
        """A call of libm; square roots are an instruction of the machine."""
        if name == "sqrt":
            return self.builder.call(self.module.declare_intrinsic("llvm.sqrt", [_DOUBLE]), args)
        return self.builder.call(libm_function(self.module, name, len(args)), args)

    def sign(self, x: Any) -> Any:
        """±1, and NaN at 0, where the absolute value has no derivative."""
        zero, one = ir.Constant(_DOUBLE, 0.0), ir.Constant(_DOUBLE, 1.0)
        minus, nan = ir.Constant(_DOUBLE, -1.0), ir.Constant(_DOUBLE, math.nan)
        positive = self.builder.fcmp_ordered(">", x, zero)
        negative = self.builder.fcmp_ordered("<", x, zero)
        return self.builder.select(positive, one, self.builder.select(negative, minus, nan))


def _bind_libm(module: Any) -> None:
    """Tell LLVM where the functions of libm are that a module names, however the process was linked."""
    names = [f.name for f in module.functions if f.is_declaration and not f.name.startswith("llvm.")]
    libm = ctypes.CDLL(None)
    library = libm if hasattr(libm, "cbrt") else ctypes.CDLL("libm.so.6")
    for name in names:
        llvm.add_symbol(name, ctypes.cast(getattr(library, name), ctypes.c_void_p).value)


def engine_of(printed: ir.Module) -> Any:
    """What owns the machine code of a module, and knows the addresses of its functions."""
    with _LOCK:
        machine = _target_machine()
        module = llvm.parse_assembly(str(printed))
        module.verify()
        _bind_libm(module)
        engine = llvm.create_mcjit_compiler(module, machine)
        engine.finalize_object()
        return engine


def _in_balls(compiled: Program) -> Any:
    """A C function that evaluates a program in balls; NaN where they are not finite."""
    from flint import arb

    from osculant.cas.numbers.balls import precision
    from osculant.cas.numbers.fields import Balls

    field = Balls()

    def evaluate(t: float, out: Any) -> None:
        with precision(_BITS):
            values = [value for row in compiled.run(arb(t), field) for value in row]
        for place, value in enumerate(values):
            out[place] = float(value.mid()) if value.is_finite() else math.nan

    return _CALLBACK(evaluate)


class CompiledJet:
    """Machine code for the derivatives 0…order of some formulas; the code lives as long as this.

    ``address`` is the address of ``void(double t, double *out)``; ``size`` the number of doubles it
    writes.  Calling the object evaluates once: shape (formulas, order + 1).
    """

    def __init__(self, formulas: Sequence[Node], order: int, variable: str = "t") -> None:
        compiled = program(formulas, order, variable)
        overflowing = any(_OVERFLOWING & {step.op, step.value} for step in compiled.instructions)
        #: kept as long as the code that calls it
        self._instead = _in_balls(compiled) if overflowing else None
        printer = _Printer(compiled, self._instead and ctypes.cast(self._instead, ctypes.c_void_p).value)
        self.order = order
        self.formulas = len(formulas)
        self.size = self.formulas * (order + 1)
        self._engine = engine_of(printer.module)
        self.address: int = self._engine.get_function_address("jet")
        self._call = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_void_p)(self.address)

    def __call__(self, t: float) -> np.ndarray[Any, np.dtype[np.float64]]:
        """The derivatives at t, shape (formulas, order + 1)."""
        out = np.empty(self.size)
        self._call(t, out.ctypes.data)
        return out.reshape(self.formulas, self.order + 1)


def compile_jet(formulas: Sequence[Node], order: int, variable: str = "t") -> CompiledJet:
    """Machine code for the derivatives 0…order of the formulas in one variable.

    Points outside a formula's domain give NaN or infinities, as libm does.

    >>> from osculant.cas.formulas.parser import parse
    >>> compile_jet([parse("t**3")], 2)(2.0)
    array([[ 8., 12., 12.]])
    """
    return CompiledJet(formulas, order, variable)
