"""Elementary functions of several doubles at once, as branch-free LLVM IR, for `osculant.codegen.blocks`.

Arguments are reduced by parts of π/2 and log 2 in fused operations, and series are summed as far as a
double's last bit goes: their coefficients are 1/k! and 1/(2k + 1), rounded.  Errors are below 2 units in the
last place (the tests measure less than 1.2) where a function takes its argument; elsewhere, for huge, tiny
or undefined arguments, the result is NaN, and whoever calls computes such places otherwise.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from typing import Any

from llvmlite import ir

from osculant.cas.formulas.expression import PI, call, div, number

#: what is taken: |x| up to this by sine and cosine, [−LARGEST, LARGEST] by the exponential, normal doubles by
#: the logarithm and the cube root
FARTHEST, LARGEST, LEAST, MOST = 2.0**20, 707.0, 2.0**-1021, 2.0**1023
#: terms of the series of sine, cosine, exponential and logarithm
SINE, COSINE, EXPONENTIAL, LOGARITHM = 8, 8, 12, 12
#: added and subtracted, it rounds; its last bits are then those of the integer
ROUNDER = 1.5 * 2.0**52
#: bits of the first part of log 2, which times an exponent is exact
UPPER = 32
DOUBLE, INTEGER = ir.DoubleType(), ir.IntType(64)


@cache
def parts(name: str, upper: int = 53, count: int = 3) -> tuple[float, ...]:
    """A number as a sum of doubles, the first with so many bits: "pi/2", "2/pi", "log 2" or "1/log 2".

    >>> parts("log 2", 53, 2)
    (0.6931471805599453, 2.3190468138462996e-17)
    """
    from osculant.cas.numbers.balls import PRECISION, constant, precision

    two = number(2)
    node = {"pi/2": div(PI, two), "log 2": call("log", two), "2/pi": div(two, PI)}
    node["1/log 2"] = div(number(1), node["log 2"])
    found = []
    with precision(PRECISION):
        rest = constant(node[name])
        for i in range(count):
            part = float(rest.mid())
            if i == 0 and upper < 53:
                scale = 2.0 ** (upper - math.frexp(part)[1])
                part = math.floor(part * scale) / scale
            found.append(part)
            rest = rest - part
    return tuple(found)


class Vectors:
    """Writes operations on vectors of ``lanes`` doubles at the end of a block."""

    def __init__(self, module: Any, builder: Any, lanes: int) -> None:
        self.module, self.builder, self.lanes = module, builder, lanes
        self.kind, self.integers = ir.VectorType(DOUBLE, lanes), ir.VectorType(INTEGER, lanes)
        self._turned: dict[Any, tuple[Any, Any]] = {}

    def of(self, value: float) -> Any:
        """The same double in all lanes."""
        return ir.Constant(self.kind, [ir.Constant(DOUBLE, value)] * self.lanes)

    def whole(self, value: int) -> Any:
        """The same integer in all lanes."""
        return ir.Constant(self.integers, [ir.Constant(INTEGER, value)] * self.lanes)

    def intrinsic(self, name: str, *args: Any) -> Any:
        """An instruction of the machine."""
        full = f"llvm.{name}.v{self.lanes}f64"
        function = self.module.globals.get(full)
        if function is None:
            kind = ir.FunctionType(self.kind, [self.kind] * len(args))
            function = ir.Function(self.module, kind, name=full)
        return self.builder.call(function, args)

    def fused(self, a: Any, b: Any, c: Any) -> Any:
        """ab + c, rounded once."""
        return self.intrinsic("fma", a, b, c)

    def root(self, x: Any) -> Any:
        """√x."""
        return self.intrinsic("sqrt", x)

    def size(self, x: Any) -> Any:
        """|x|."""
        return self.intrinsic("fabs", x)

    def bits(self, x: Any) -> Any:
        """The bits of doubles."""
        return self.builder.bitcast(x, self.integers)

    def double(self, bits: Any) -> Any:
        """The doubles with such bits."""
        return self.builder.bitcast(bits, self.kind)

    def series(self, x: Any, coefficients: Sequence[Fraction]) -> Any:
        """Σ cₖxᵏ."""
        total = self.of(float(coefficients[-1]))
        for coefficient in reversed(coefficients[:-1]):
            total = self.fused(total, x, self.of(float(coefficient)))
        return total

    def where(self, taken: Any, value: Any) -> Any:
        """The value where it is right, NaN elsewhere."""
        return self.builder.select(taken, value, self.of(math.nan))

    def rounded(self, x: Any) -> tuple[Any, Any]:
        """(the nearest integer as a double, its bits, of which the last are those of an integer)."""
        moved = self.builder.fadd(x, self.of(ROUNDER))
        return self.builder.fsub(moved, self.of(ROUNDER)), self.bits(moved)

    def turned(self, x: Any) -> tuple[Any, Any]:
        """(sin x, cos x), one reduction for both; made once for each argument."""
        if x in self._turned:
            return self._turned[x]
        b, (first, second, third) = self.builder, parts("pi/2")
        turns, bits = self.rounded(b.fmul(x, self.of(parts("2/pi")[0])))
        back = b.fneg(turns)
        near = self.fused(back, self.of(first), x)
        part = b.fmul(back, self.of(second))
        left = b.fadd(near, part)
        moved = b.fsub(left, near)
        lost = b.fadd(b.fsub(near, b.fsub(left, moved)), b.fsub(part, moved))  # by left, exactly
        lost = b.fadd(lost, self.fused(back, self.of(second), b.fneg(part)))
        lost = self.fused(back, self.of(third), lost)
        r = b.fadd(left, lost)
        lost = b.fadd(b.fsub(left, r), lost)
        z, one = b.fmul(r, r), self.of(1.0)
        sines = [Fraction((-1) ** k, math.factorial(2 * k + 1)) for k in range(1, SINE + 1)]
        cosines = [Fraction((-1) ** k, math.factorial(2 * k)) for k in range(2, COSINE + 2)]
        half = b.fmul(z, self.of(0.5))
        upper = b.fsub(one, half)
        below = b.fsub(b.fsub(one, upper), half)
        below = b.fadd(below, self.fused(b.fmul(z, z), self.series(z, cosines), b.fneg(b.fmul(r, lost))))
        cosine = b.fadd(upper, below)
        below = self.fused(b.fmul(r, z), self.series(z, sines), b.fmul(lost, upper))
        sine = b.fadd(r, below)
        odd = b.icmp_signed("!=", b.and_(bits, self.whole(1)), self.whole(0))
        taken = b.fcmp_ordered("<=", self.size(x), self.of(FARTHEST))
        places = ((sine, cosine, bits), (cosine, sine, b.add(bits, self.whole(1))))
        found = []
        for even_value, odd_value, quarter in places:
            flips = b.shl(b.and_(quarter, self.whole(2)), self.whole(62))
            value = b.select(odd, odd_value, even_value)
            found.append(self.where(taken, self.double(b.xor(self.bits(value), flips))))
        self._turned[x] = found[0], found[1]
        return self._turned[x]

    def sin(self, x: Any) -> Any:
        """The sine."""
        return self.turned(x)[0]

    def cos(self, x: Any) -> Any:
        """The cosine."""
        return self.turned(x)[1]

    def exp(self, x: Any) -> Any:
        """The exponential."""
        b, (first, second, _) = self.builder, parts("log 2")
        powers, bits = self.rounded(b.fmul(x, self.of(parts("1/log 2")[0])))
        back = b.fneg(powers)
        r = self.fused(back, self.of(second), self.fused(back, self.of(first), x))
        terms = [Fraction(1, math.factorial(k)) for k in range(2, EXPONENTIAL + 2)]
        value = b.fadd(self.of(1.0), self.fused(b.fmul(r, r), self.series(r, terms), r))
        scale = self.double(b.shl(b.add(bits, self.whole(1023)), self.whole(52)))
        taken = b.fcmp_ordered("<=", self.size(x), self.of(LARGEST))
        return self.where(taken, b.fmul(value, scale))

    def log(self, x: Any) -> Any:
        """The natural logarithm."""
        b, (first, second, _) = self.builder, parts("log 2", UPPER)
        start = int.from_bytes(_bytes_of(math.sqrt(0.5)), "little")
        exponent = b.ashr(b.sub(self.bits(x), self.whole(start)), self.whole(52))
        mantissa = self.double(b.sub(self.bits(x), b.shl(exponent, self.whole(52))))
        rounder = self.bits(self.of(ROUNDER))
        k = b.fsub(self.double(b.add(exponent, rounder)), self.of(ROUNDER))
        f = b.fsub(mantissa, self.of(1.0))
        s = b.fdiv(f, b.fadd(self.of(2.0), f))
        z = b.fmul(s, s)
        rest = b.fmul(z, self.series(z, [Fraction(2, 2 * j + 1) for j in range(1, LOGARITHM)]))
        half = b.fmul(b.fmul(self.of(0.5), f), f)
        lower = self.fused(s, b.fadd(half, rest), b.fmul(k, self.of(second)))
        value = self.fused(k, self.of(first), b.fsub(f, b.fsub(half, lower)))
        return self.where(self._between(x), value)

    def cbrt(self, x: Any) -> Any:
        """The real cube root: a third of the logarithm, and one step of Newton's method."""
        b, size = self.builder, self.size(x)
        y = self.exp(b.fmul(self.log(size), self.of(1 / 3)))
        square = b.fmul(y, y)
        lost = self.fused(y, y, b.fneg(square))
        cube = b.fmul(square, y)
        lost = self.fused(lost, y, self.fused(square, y, b.fneg(cube)))
        off = b.fadd(b.fsub(cube, size), lost)
        y = b.fsub(y, b.fdiv(off, b.fmul(self.of(3.0), square)))
        sign = b.and_(self.bits(x), self.whole(-(2**63)))
        return self.where(self._between(size), self.double(b.or_(self.bits(y), sign)))

    def _between(self, x: Any) -> Any:
        b = self.builder
        low, high = b.fcmp_ordered(">=", x, self.of(LEAST)), b.fcmp_ordered("<=", x, self.of(MOST))
        return b.and_(low, high)


def _bytes_of(value: float) -> bytes:
    import struct

    return struct.pack("<d", value)
