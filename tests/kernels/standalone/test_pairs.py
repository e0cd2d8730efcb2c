"""Pairs of doubles in C against many digits."""

import ctypes
import shutil
import subprocess

import mpmath
import numpy as np
import pytest

from osculant.codegen.c.program import Translation
from osculant.codegen.c.types import DOUBLE, Struct
from osculant.kernels.standalone import pair_functions, pairs

pytestmark = pytest.mark.skipif(shutil.which("cc") is None, reason="there is no C compiler cc")

HEAD = "".join(f"#include <{name}.h>\n" for name in ("math", "stdbool", "stdint", "stdlib"))
FLAGS = ["-std=c11", "-O2", "-shared", "-fPIC", "-ffp-contract=off", "-fno-math-errno"]
PAIR = Struct((DOUBLE, DOUBLE), pairs.Pair)

#: function, mpmath's, least and largest argument
FUNCTIONS = [
    (pair_functions.sine, mpmath.sin, -50, 50),
    (pair_functions.cosine, mpmath.cos, -50, 50),
    (pair_functions.tangent, mpmath.tan, -9, 9),
    (pair_functions.exponential, mpmath.exp, -600, 600),
    (pair_functions.logarithm, mpmath.log, 1e-9, 50),
    (pair_functions.hyperbolic_sine, mpmath.sinh, -3, 3),
    (pair_functions.hyperbolic_cosine, mpmath.cosh, -30, 30),
    (pair_functions.hyperbolic_tangent, mpmath.tanh, -50, 50),
    (pair_functions.inverse_sine, mpmath.asin, -1, 1),
    (pair_functions.inverse_cosine, mpmath.acos, -1, 1),
    (pair_functions.inverse_tangent, mpmath.atan, -9, 9),
    (pair_functions.inverse_hyperbolic_sine, mpmath.asinh, -9, 9),
    (pair_functions.inverse_hyperbolic_cosine, mpmath.acosh, 1, 9),
    (pair_functions.inverse_hyperbolic_tangent, mpmath.atanh, -1, 1),
    (pair_functions.cube_root, lambda x: mpmath.sign(x) * mpmath.cbrt(abs(x)), -9, 9),
    (pairs.root, mpmath.sqrt, 0, 9),
]
#: of two arguments
OPERATIONS = [
    (pairs.add, lambda x, y: x + y),
    (pairs.subtract, lambda x, y: x - y),
    (pairs.multiply, lambda x, y: x * y),
    (pairs.divide, lambda x, y: x / y),
    (pair_functions.power, lambda x, y: abs(x) ** y),
]


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    translation, entries = Translation({}, {}), []
    for count, table in ((1, FUNCTIONS), (2, OPERATIONS)):
        for function, *_ in table:
            made = translation.function(function, [PAIR] * count)
            kind = translation.c_type(PAIR)
            passed = ", ".join(f"({kind}){{x[{2 * i}], x[{2 * i + 1}]}}" for i in range(count))
            entries.append(
                f"void {function.__name__}(const double *x, double *out) "
                f"{{ {kind} y = {made.name}({passed}); out[0] = y.high; out[1] = y.low; }}\n"
            )
    folder = tmp_path_factory.mktemp("pairs")
    head = HEAD + "#define INLINE static inline\n"
    (folder / "all.c").write_text(head + translation.text() + "".join(entries))
    subprocess.run(["cc", *FLAGS, "-o", "all.so", "all.c", "-lm"], cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "all.so"))


def called(library, function, numbers):
    x, out = np.array(numbers), np.empty(2)
    pointer = ctypes.POINTER(ctypes.c_double)
    getattr(library, function.__name__)(x.ctypes.data_as(pointer), out.ctypes.data_as(pointer))
    return mpmath.mpf(out[0]) + mpmath.mpf(out[1])


def numbers(low, high, count):
    rng = np.random.default_rng(7)
    for high_part in rng.uniform(low, high, count):
        yield float(high_part), float(high_part * rng.uniform(-1, 1) * 2.0**-54)


@pytest.mark.parametrize(("function", "known", "low", "high"), FUNCTIONS)
def test_functions_have_thirty_digits(library, function, known, low, high):
    with mpmath.workprec(240):
        for high_part, low_part in numbers(low, high, 300):
            exact = known(mpmath.mpf(high_part) + low_part)
            found = called(library, function, [high_part, low_part])
            slack = 2.0**-94 if known is mpmath.exp else 2.0**-97
            assert abs(found - exact) <= slack * max(abs(exact), 2.0**-6), (high_part, low_part)


@pytest.mark.parametrize(("function", "known"), OPERATIONS)
def test_operations_have_thirty_digits(library, function, known):
    with mpmath.workprec(240):
        for x, y in zip(numbers(-5, 5, 300), numbers(-7, 7, 300)):
            if function is pair_functions.power:
                x = (abs(x[0]), x[1])
            exact = known(mpmath.mpf(x[0]) + x[1], mpmath.mpf(y[0]) + y[1])
            size = max(abs(exact), 1.0 if function in (pairs.add, pairs.subtract) else 0.0)
            assert abs(called(library, function, [*x, *y]) - exact) <= 2.0**-96 * size
