"""The kernels' own libraries do what numba's machine code does, to the last bit, and without numba."""

import json
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest

import osculant as osc
from osculant.compiled import faces
from osculant.compiled import prebuilt as building
from osculant.kernels import jit, prebuilt
from osculant.kernels.bihelices.records import VARIANTS, Bihelix
from osculant.kernels.conics.records import Conic
from osculant.kernels.curves.jets import sample_many
from osculant.kernels.search import spline
from tests.front.compiled.fixed import needs_cc

pytestmark = needs_cc

FAMILIES = ["biarcs", "conics", "polygons", "curves", "enclosures"]
SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")

#: approximates without the compilers; a folder of libraries, then the curve, primitive and tolerance
SCRIPT = """
import sys
from pathlib import Path
from osculant.kernels import prebuilt
prebuilt.FOLDER = Path(sys.argv[1]) if sys.argv[1] else prebuilt.FOLDER
import osculant as osc
spline = osc.approximate(osc.curve(*sys.argv[2:5]), sys.argv[5], float(sys.argv[6]))
print(*[float.hex(knot) for knot in spline.knots])
print(spline.minimal, float.hex(spline.predicted))
print(sorted({"numba", "sympy", "numpy.ma"} & set(sys.modules)))
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder, told = tmp_path_factory.mktemp("libraries"), []
    building.build_all(folder, FAMILIES, told.append)
    assert [line.split(",")[0].split()[-1] for line in told] == FAMILIES
    building.build_all(folder, FAMILIES, told.append)
    assert len(told) == len(FAMILIES)  # nothing was missing
    return folder


@pytest.fixture
def libraries(folder, monkeypatch):
    """The libraries in the place of the package's."""
    monkeypatch.delenv(prebuilt.SWITCH, raising=False)
    monkeypatch.setattr(prebuilt, "FOLDER", folder)
    prebuilt.library.cache_clear()
    yield folder
    prebuilt.library.cache_clear()


def copied(arguments):
    """Arguments with arrays of their own."""
    return [
        type(part)(*copied(part))
        if hasattr(part, "_fields")
        else part.copy()
        if isinstance(part, np.ndarray)
        else part
        for part in arguments
    ]


def same(one, other):
    """Whether results, or arguments afterwards, are equal; numbers that are none are alike."""
    if isinstance(one, np.ndarray):
        return np.array_equal(one, other, equal_nan=one.dtype.kind == "f")
    if isinstance(one, tuple | list):
        return type(one) is type(other) and all(map(same, one, other))
    return one == other or (one != one and other != other)


CALLS = [
    ("t*cos(t), t*sin(t)", "conic", {"tolerance": 1e-6}),
    ("t, sin(t)", "parabola", {"tolerance": 1e-4}),
    ("t*cos(t), t*sin(t)", "conic", {"pieces": 7}),
    ("t, t^3 + exp(-t)", "conic", {"tolerance": 1e-4, "metric": "area"}),
    ("t, t^3", "polygon", {"tolerance": 1e-3}),
]


@pytest.mark.parametrize(("formula", "primitive", "wanted"), CALLS)
def test_every_call_has_the_same_bits(libraries, monkeypatch, formula, primitive, wanted):
    """All that Python asks of kernels is asked of both."""
    through, asked = jit.Kernel.__call__, []

    def both(kernel, *arguments):
        family = jit.family_of(kernel.__module__, type(arguments[0]).__module__)
        face = prebuilt.face_of(family, kernel, type(arguments[0]))
        assert face is not None, kernel.__name__
        mine = copied(arguments)
        for array in mine:  # what is not written is not compared
            if isinstance(array, np.ndarray) and array.dtype.kind == "f":
                array[~np.isfinite(array)] = 0.0
        theirs = copied(mine)
        found, known = face(*mine), compiled(kernel, type(arguments[0]), family)(*theirs)
        assert same(found, known) and same(mine, theirs), kernel.__name__
        asked.append(kernel.__name__)
        return through(kernel, *arguments)

    monkeypatch.setattr(jit.Kernel, "__call__", both)
    made = osc.approximate(osc.curve(formula, "pi/6", "2*pi"), primitive, **wanted)
    assert made.predicted > 0
    assert {"sample_many", "polynomial_parts", "isolate", "lay_out"} <= set(asked)
    assert {"spline", "fit_arcs"} & set(asked)


_COMPILED = {}


def compiled(kernel, first, family):
    """The machine code that numba makes, once for each."""
    if (kernel, first) not in _COMPILED:
        _COMPILED[kernel, first] = kernel._compiled(family)
    return _COMPILED[kernel, first]


def printed(*arguments, **environment):
    script = [sys.executable, "-P", "-c", SCRIPT, *map(str, arguments)]
    done = subprocess.run(script, env={**os.environ, **environment}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_a_process_needs_no_compiler(folder, tmp_path):
    knots, facts, loaded = printed(
        folder, *SPIRAL, "conic", 1e-6, OSCULANT_CACHE=str(tmp_path), OSCULANT_PREBUILT="yes"
    )
    assert loaded == "[]" and not list(tmp_path.iterdir())
    known = osc.approximate(osc.curve(*SPIRAL), "conic", 1e-6)
    assert [float.fromhex(knot) for knot in knots.split()] == list(known.knots)
    assert facts == f"{known.minimal} {float.hex(known.predicted)}"


def test_what_does_not_fit_is_left_to_numba(libraries, tmp_path, monkeypatch):
    assert prebuilt.library("conics") is not None
    assert prebuilt.library("bihelices") is None  # it was not built
    assert prebuilt.face_of("curves", sample_many, int) is not None
    assert prebuilt.face_of("curves", jit.Kernel(len), int) is None
    monkeypatch.setenv(prebuilt.SWITCH, "no")
    assert prebuilt.face_of("curves", sample_many, int) is None
    for name in ("curves.so", "curves.json"):
        shutil.copy(libraries / name, tmp_path)
    monkeypatch.setattr(prebuilt, "FOLDER", tmp_path)
    manifest = json.loads((tmp_path / "curves.json").read_text())

    def found(**changes):
        prebuilt.library.cache_clear()
        (tmp_path / "curves.json").write_text(json.dumps({**manifest, **changes}))
        return prebuilt.library("curves")

    assert found() is not None
    assert found(fingerprint="0" * 16) is None  # other sources
    assert found(needs=["a machine of tomorrow"]) is None
    assert found(library="gone.so") is None
    (tmp_path / "curves.json").write_text("{")
    prebuilt.library.cache_clear()
    assert prebuilt.library("curves") is None
    assert building.missing(tmp_path, ["curves"]) == ["curves"]


def test_arrays_that_kernels_do_not_take_are_refused(libraries):
    face = prebuilt.face_of("curves", sample_many, int)
    for times in (np.zeros(3, dtype=np.float32), np.zeros(6)[::2], np.zeros((3, 1)), np.zeros(3, dtype=int)):
        with pytest.raises(TypeError):
            face(0, times, np.empty((3, 6)))
    with pytest.raises(TypeError):
        face(0, np.zeros(3))
    assert prebuilt.face_of("conics", spline, Conic) is not None


def test_records_that_say_something_are_told_apart():
    kinds = {repr(entry.record) for entry in faces.entries("bihelices")}
    assert kinds == {repr(Bihelix(*values)) for values in VARIANTS} and len(kinds) == 4


def test_every_fit_of_the_table_has_its_kernels():
    from osculant.primitives.table import PRIMITIVES, Fit

    prebuilt_records = {repr(record) for family in faces.families()[:-2] for record in faces.records(family)}
    for table in PRIMITIVES.values():
        for primitive in table.values():
            for metric, rules in primitive.methods.items():
                for rule in rules:
                    fit = Fit(primitive, metric, rule)
                    assert repr(fit.record(fit.order)) in prebuilt_records


@pytest.mark.slow
def test_a_wheel_has_libraries_and_needs_no_compiler(tmp_path):
    root = Path(__file__).parents[3]
    source = tmp_path / "source"
    skipped = shutil.ignore_patterns("__pycache__", "libraries", "build", "*.egg-info")
    for name in ("cas", "codegen", "kernels", "osculant"):
        shutil.copytree(root / name, source / name, symlinks=True, ignore=skipped)
    for name in ("pyproject.toml", "setup.py", "README.md", "LICENSE"):
        shutil.copy(root / name, source)
    command = [sys.executable, "-m", "pip", "wheel", "--no-deps", "-w", tmp_path, source]
    done = subprocess.run(command, capture_output=True, text=True)
    if "No matching distribution" in done.stderr:
        pytest.skip("setuptools and numpy for the build are not to be had")
    assert done.returncode == 0, done.stderr
    [wheel] = tmp_path.glob("*.whl")
    assert "-py3-none-" in wheel.name and "any" not in wheel.name
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path / "installed")
    environment = {"PYTHONPATH": str(tmp_path / "installed"), "OSCULANT_CACHE": str(tmp_path / "cache")}
    for primitive, tolerance in (("conic", 1e-6), ("biarc", 1e-4), ("cubic", 1e-5)):
        knots, _, loaded = printed("", *SPIRAL, primitive, tolerance, OSCULANT_PREBUILT="yes", **environment)
        known = osc.approximate(osc.curve(*SPIRAL), primitive, tolerance)
        assert [float.fromhex(knot) for knot in knots.split()] == list(known.knots)
        assert "numba" not in loaded
    assert not (tmp_path / "cache").exists()


@pytest.mark.parametrize(
    ("arguments", "says"), [(["conics"], "The folder comes first"), (["made", "conix"], "no family 'conix'")]
)
def test_arguments_that_make_no_sense_are_told(tmp_path, monkeypatch, capsys, arguments, says):
    monkeypatch.chdir(tmp_path)
    assert building.main(arguments) == 2
    assert says in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("primitive", ["biarc", "conic"])
def test_for_one_processor_the_bits_are_those_for_any(libraries, tmp_path, primitive):
    """Fused operations, which the first has, would change them."""
    made = osc.compile_approximator(SPIRAL[0], primitive, *SPIRAL[1:], folder=tmp_path).load()
    pieces = osc.approximate(osc.curve(*SPIRAL), primitive, 1e-5).pieces
    own = [(piece.start, piece.end, piece.error) for piece in pieces]
    found = made.approximate(1e-5)
    names = ("x0", "y0", "x2", "y2", "error")
    assert [((a, b), (c, d), error) for a, b, c, d, error in found[list(names)].tolist()] == own
    if primitive == "biarc":
        assert found[["x1", "y1"]].tolist() == [piece.junction for piece in pieces]


@pytest.mark.parametrize("family", faces.families())
def test_every_family_is_translated(family):
    text, functions = building.source(family)
    assert functions and all(f"{function['name']}(" in text for function in functions)
