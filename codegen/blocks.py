"""Derivatives at many parameters: a Taylor program → machine code that takes several parameters at once.

`compile_blocks` prints the program of `osculant.codegen.jets` on vectors, as many doubles as the processor's
registers hold, with elementary functions of `osculant.codegen.vectors`.  Results are in columns, one for each
derivative.  Where a function does not take its argument, the jet that calls libm is asked.
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np
from llvmlite import ir

from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.rationals import as_double
from osculant.cas.numbers.taylor import Program, program
from osculant.codegen.jets import CompiledJet, compile_jet, engine_of, libm_function, target
from osculant.codegen.vectors import DOUBLE, INTEGER, Vectors

#: functions that vectors have; others are libm's, lane by lane
OWN = ("sin", "cos", "exp", "log", "cbrt", "sqrt")


def lanes() -> int:
    """How many doubles a register of this machine holds."""
    has = set(target()[2].split(","))
    return 8 if "+avx512f" in has else 4 if "+avx2" in has else 2


class _Printer:
    """Prints one program as a loop over blocks of parameters, which returns 0 if no result is NaN."""

    def __init__(self, compiled: Program, width: int) -> None:
        self.module = ir.Module(name="blocks")
        signature = ir.FunctionType(INTEGER, (INTEGER, DOUBLE.as_pointer(), DOUBLE.as_pointer()))
        function = ir.Function(self.module, signature, name="blocks")
        count, times, out = function.args
        entry, loop, leave = map(function.append_basic_block, ("entry", "loop", "leave"))
        self.builder = b = ir.IRBuilder(entry)
        zero, step = ir.Constant(INTEGER, 0), ir.Constant(INTEGER, width)
        b.cbranch(b.icmp_signed("<", zero, count), loop, leave)
        b.position_at_end(loop)
        self.vectors = Vectors(self.module, b, width)
        place, undefined = b.phi(INTEGER), b.phi(ir.VectorType(ir.IntType(1), width))
        place.add_incoming(zero, entry)
        undefined.add_incoming(ir.Constant(undefined.type, [0] * width), entry)
        many = self.vectors.kind.as_pointer()
        t = b.load(b.bitcast(b.gep(times, [place]), many))
        t.align = 8
        values: list[Any] = []
        for instruction in compiled.instructions:
            known = [values[a] for a in instruction.args]
            values.append(
                t if instruction.op == "variable" else self.value(instruction.op, instruction.value, known)
            )
        column, missing = place, undefined
        for output in compiled.outputs:
            for index in output:
                stored = b.store(values[index], b.bitcast(b.gep(out, [column]), many))
                stored.align = 8
                column = b.add(column, count)
                missing = b.or_(missing, b.fcmp_unordered("uno", values[index], values[index]))
        following = b.add(place, step)
        place.add_incoming(following, loop)
        undefined.add_incoming(missing, loop)
        b.cbranch(b.icmp_signed("<", following, count), loop, leave)
        b.position_at_end(leave)
        told = b.phi(undefined.type)
        told.add_incoming(ir.Constant(undefined.type, [0] * width), entry)
        told.add_incoming(missing, loop)
        b.ret(b.zext(b.bitcast(told, ir.IntType(width)), INTEGER))

    def value(self, op: str, value: Fraction | str | None, args: list[Any]) -> Any:
        """The vector of one instruction."""
        b, vectors = self.builder, self.vectors
        if op == "number":
            assert isinstance(value, Fraction)
            return vectors.of(as_double(value))
        if op == "constant":
            return vectors.of(math.pi if value == "pi" else math.e)
        if op == "power":
            assert isinstance(value, Fraction)
            return self.one_by_one("pow", args[0], [ir.Constant(DOUBLE, as_double(value))])
        if op == "call" and value == "sign":
            return self.sign(args[0])
        if op == "call" and value in ("sqrt", "abs"):
            return vectors.root(args[0]) if value == "sqrt" else vectors.size(args[0])
        if op == "call" and value in OWN:
            return getattr(vectors, str(value))(args[0])
        if op == "call":
            return self.one_by_one(str(value), args[0], [])
        return {"add": b.fadd, "sub": b.fsub, "mul": b.fmul, "div": b.fdiv, "neg": b.fneg}[op](*args)

    def sign(self, x: Any) -> Any:
        """±1, and NaN at 0, where the absolute value has no derivative."""
        b, zero = self.builder, self.vectors.of(0.0)
        below = b.select(b.fcmp_ordered("<", x, zero), self.vectors.of(-1.0), self.vectors.of(math.nan))
        return b.select(b.fcmp_ordered(">", x, zero), self.vectors.of(1.0), below)

    def one_by_one(self, name: str, x: Any, more: list[Any]) -> Any:
        """libm's function of each lane."""
        function = libm_function(self.module, name, 1 + len(more))
        found = self.vectors.of(0.0)
        for i in range(self.vectors.lanes):
            lane = ir.Constant(ir.IntType(32), i)
            value = self.builder.call(function, [self.builder.extract_element(x, lane), *more])
            found = self.builder.insert_element(found, value, lane)
        return found


class Blocks:
    """Machine code for the derivatives 0…order of some formulas at many parameters.

    Calling it with parameters (m,) gives an array (formulas, order + 1, m), every derivative in a row of its
    own.  Each elementary function is within 2 units in the last place, as libm is, but its bits are its own.
    """

    def __init__(self, formulas: Sequence[Node], order: int, variable: str = "t") -> None:
        self.formulas, self.order, self.variable, self.lanes = tuple(formulas), order, variable, lanes()
        printer = _Printer(program(formulas, order, variable), self.lanes)
        self._engine = engine_of(printer.module)
        address = self._engine.get_function_address("blocks")
        kinds = (ctypes.c_int64, ctypes.c_void_p, ctypes.c_void_p)
        self._call = ctypes.CFUNCTYPE(ctypes.c_int64, *kinds)(address)

    def __call__(self, times: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        """The derivatives at ``times`` (m,)."""
        count = times.size
        if not count:
            return np.empty((len(self.formulas), self.order + 1, 0))
        whole = -(-count // self.lanes) * self.lanes
        padded = np.empty(whole)
        padded[:count], padded[count:] = times, times[-1:]
        out = np.empty((len(self.formulas), self.order + 1, whole))
        undefined = self._call(whole, padded.ctypes.data, out.ctypes.data)
        out = out[..., :count]
        if undefined:
            for i in np.flatnonzero(np.isnan(out).any(axis=(0, 1))):
                out[..., i] = self._jet(float(times[i]))
        return out

    @cached_property
    def _jet(self) -> CompiledJet:
        """What calls libm, made when it is first needed."""
        return compile_jet(self.formulas, self.order, self.variable)


def compile_blocks(formulas: Sequence[Node], order: int, variable: str = "t") -> Blocks:
    """Machine code for the derivatives 0…order of the formulas at many values of one variable.

    >>> from osculant.cas.formulas.parser import parse
    >>> compile_blocks([parse("t**3")], 2)(np.array([2.0, 3.0])).tolist()
    [[[8.0, 27.0], [12.0, 27.0], [12.0, 18.0]]]
    """
    return Blocks(formulas, order, variable)
