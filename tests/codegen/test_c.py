"""The translator: small functions in C and in Python do the same, to the last bit."""

import ctypes
import math
import shutil
import subprocess
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.formulas.parser import parse
from osculant.codegen.c.jets import jet_function
from osculant.codegen.c.program import Translation
from osculant.codegen.c.types import DOUBLE, INTEGER, ROW, Known, TranslationError
from osculant.codegen.jets import compile_jet

needs_cc = pytest.mark.skipif(shutil.which("cc") is None, reason="there is no C compiler cc")
HEADERS = ("math", "stdbool", "stdint", "stdlib")
HEAD = "".join(f"#include <{name}.h>\n" for name in HEADERS) + "#define INLINE static inline\n"
FLAGS = ["-std=c11", "-O2", "-Wall", "-Werror", "-shared", "-fPIC", "-ffp-contract=off", "-fno-math-errno"]

STEPS = (0.5, -2.0, 3.25)
TABLE_OF_INTEGERS = (3, 7, 14)
GRID = np.arange(6.0).reshape(2, 3) / 7


class Pair(NamedTuple):
    """Two numbers, one of which has a name that is a word of C."""

    signed: float
    rest: float


def arithmetic(x, out):
    a, b = x[0], x[1]
    out[0], out[1], out[2] = a - (b - a) - b, a / b / (a * b), -a - -b
    out[3], out[4], out[5] = a**2, a**3 * b**4, (a + b) ** 5
    out[6], out[7] = abs(a) ** 0.25, a - b * (a + b) / (a - (b + a))
    out[8] = 2 * a + 1 / 2 - 7 // 2 + 7 % 3


def integers(x, out):
    i, j = int(x[0]), int(x[1])
    if j == 0:
        j = 3
    out[0], out[1], out[2] = i // j, i % j, i / j
    out[3], out[4] = max(i, j, 2), min(i, 2.5)
    out[5], out[6] = math.ceil(x[0]), math.floor(x[1])
    out[7] = (i > j) + (i == j) * 2
    k = 2
    out[8] = x[0] ** k + 1.5**k


def extremes(x, out):
    out[0], out[1] = min(x[0], x[1]), max(x[0], x[1])
    out[2], out[3] = min(x[1], x[0], x[2]), max(x[1], x[0], x[2])
    out[4] = 1.0 if x[0] < x[1] <= x[2] else 0.0
    out[5] = 1.0 if not x[0] > 0.0 and (x[1] > 0.0 or x[2] > 0.0) else 0.0
    out[6] = 1.0 if (x[0] > 0.0) == (x[1] > 0.0) != (x[2] > 0.0) else 0.0
    out[7] = math.copysign(x[0], x[1]) if math.isfinite(x[2]) else math.nan
    out[8] = math.inf if math.isnan(x[0]) else -math.inf


def halves(x: float) -> tuple[float, int]:
    half = 0.5 * x
    return half, int(min(9.0, max(-9.0, half)))


def lazily(x, out):
    n = int(min(4.0, max(0.0, abs(x[0]))))
    known = n < 3 and x[n] > x[2] * halves(x[n])[0]
    out[0] = 1.0 if known else 0.0
    last = x[n] if n < 3 else halves(x[0])[0]
    out[1] = last
    first, second = x[0], x[1]
    first, second = second, first + second
    out[2], out[3] = first, second
    a = b = second * 2.0
    out[4] = a + b
    half, whole = halves(x[1])
    out[5], out[6] = half, whole
    n -= 1
    out[7] = n
    pair = Pair(*halves(x[2]))
    out[8] = pair.signed + pair.rest + pair[0]


def loops(x, out):
    total = 0.0
    for i in range(2, -1, -1):
        if x[i] < 0.0:
            continue
        total = total * 0.5 + x[i]
    out[0], out[1] = total, i
    for j, value in enumerate((x[2], x[0], 4.0)):
        out[2] = out[2] * 0.25 + j * value
        if j == 1 and value > 3.0:
            break
    for step in STEPS:
        out[3] = out[3] + step * x[1]
    count = 0
    while count < 5 and not abs(x[0]) > count:
        count += 1
    out[4] = count
    out[5] = x[-1] + x[len(STEPS) - 2]
    for k in range(3):
        size = TABLE_OF_INTEGERS[k]
        out[6] = out[6] + size * GRID[k % 2, k]
    room = np.zeros((4, 3))
    rows = room[:3]
    for i in range(rows.shape[0]):
        row = rows[i]
        for j in range(rows.shape[1]):
            row[j] = x[i] * (j + 1)
    column = room[:, 1]
    out[7] = column[0] + column[1] * column[2] + column[3] + rows[2, -1]
    part = x[1:3]
    out[8] = part[0] - part[1] + part.shape[0]


FUNCTIONS = [arithmetic, integers, extremes, lazily, loops]


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    translation = Translation({}, {})
    entries = []
    for function in FUNCTIONS:
        made = translation.function(function, [ROW, ROW])
        room = f"double room[{made.room}]; " if made.room else ""
        first = "room, " if made.room else ""
        entries.append(
            f"void call_{function.__name__}(double *x, double *out) "
            f"{{ {room}{made.name}({first}(row){{x, 3}}, (row){{out, 9}}); }}\n"
        )
    folder = tmp_path_factory.mktemp("c")
    (folder / "all.c").write_text(HEAD + translation.text() + "".join(entries))
    subprocess.run(["cc", *FLAGS, "-o", "all.so", "all.c", "-lm"], cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "all.so"))


def bits(array):
    """Bytes, all that are no numbers being alike."""
    return np.where(np.isnan(array), np.nan, array).tobytes()


NUMBERS = st.one_of(
    st.sampled_from([0.0, -0.0, 1.0, -1.0, 2.0, 0.5, -3.5, math.nan, 1e-300, 7.0]), st.floats(-50, 50)
)


@needs_cc
@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: function.__name__)
@settings(max_examples=200, deadline=None)
@given(values=st.tuples(NUMBERS, NUMBERS, NUMBERS))
def test_c_does_what_python_does(library, function, values):
    x = np.array(values)
    if function is not extremes and not np.isfinite(x).all():
        x = np.nan_to_num(x, nan=2.5)
    expected, found = np.zeros(9), np.zeros(9)
    with np.errstate(all="ignore"):
        function(x, expected)
    pointer = ctypes.POINTER(ctypes.c_double)
    getattr(library, f"call_{function.__name__}")(x.ctypes.data_as(pointer), found.ctypes.data_as(pointer))
    powers = [3, 4, 5, 6] if function is arithmetic else [8] if function is integers else []
    for place in powers:  # Python takes libm's pow where C has products
        assert found[place] == pytest.approx(expected[place], rel=1e-14, nan_ok=True)
        found[place] = expected[place]
    assert bits(found) == bits(expected)


def comprehension(x):
    return sum(value for value in (x, x))


def unknown_room(x, n):
    return np.empty(n)[0] + x


def two_kinds(x):
    y = x
    if x > 0.0:
        y = (x, x)
    return y


def printing(x):
    print(x)
    return x


@pytest.mark.parametrize(
    ("function", "kinds", "says"),
    [
        (comprehension, [DOUBLE], "Not translated"),
        (unknown_room, [DOUBLE, INTEGER], "no room"),
        (two_kinds, [DOUBLE], "A variable is"),
        (printing, [DOUBLE], "print"),
    ],
)
def test_what_has_no_translation_is_told_with_its_kernel(function, kinds, says):
    with pytest.raises(TranslationError, match=says) as caught:
        Translation({}, {}).function(function, kinds)
    assert f"In {function.__module__}.{function.__name__}: " in str(caught.value)


def choosing(fit, x):
    return x * fit.rest if fit.signed == 1.0 else x


def test_records_are_known_and_not_passed():
    translation = Translation({}, {})
    one = translation.function(choosing, [Known(Pair(1.0, 3.0)), DOUBLE])
    other = translation.function(choosing, [Known(Pair(2.0, 3.0)), DOUBLE])
    assert one.name != other.name
    text = translation.text()
    assert f"{one.name}(double x) {{\n    return x * 3.0" in text
    assert f"{other.name}(double x) {{\n    return x;" in text


def scratch(x, n):
    table = np.empty((4, 5))
    row = np.zeros(6)
    table[0, 0] = x + row[n]
    return table[0, 0]


def both(x, n):
    return scratch(x, n) + scratch(x, n + 1)


def test_room_is_counted_and_shared():
    translation = Translation({}, {})
    assert translation.function(scratch, [DOUBLE, INTEGER]).room == 26
    assert translation.function(both, [DOUBLE, INTEGER]).room == 26


@needs_cc
@pytest.mark.parametrize(
    "formula",
    [
        "t*cos(t)",
        "exp(sin(t))/(1+t^2)",
        "abs(t)^(1/3)",
        "2^(1/3)*sqrt(t)",
        "log(1+t)*cbrt(t)",
        "atan(tanh(t))",
        "pi",
    ],
)
def test_jets_are_those_of_the_jet_compiler(tmp_path, formula):
    node = parse(formula)
    text = HEAD + jet_function("jet", [node], 5) + "\nvoid call(double t, double *out) { jet(t, 0, out); }\n"
    (tmp_path / "jet.c").write_text(text)
    subprocess.run(["cc", *FLAGS, "-o", "jet.so", "jet.c", "-lm"], cwd=tmp_path, check=True)
    call = ctypes.CDLL(str(tmp_path / "jet.so")).call
    call.argtypes = [ctypes.c_double, ctypes.c_void_p]
    known, out = compile_jet([node], 5), np.empty(6)
    for t in np.random.default_rng(2).uniform(0.1, 6.0, 300):
        call(t, out.ctypes.data)
        assert out.tolist() == known(t)[0].tolist()
