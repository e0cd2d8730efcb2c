"""What is written beside a library: C, C++ and Python, each built and run by itself."""

import os
import subprocess
import sys

import numpy as np
import pytest
import sympy

import osculant as osc
from osculant.cas.errors import DomainError, FormulaError, OsculantError
from osculant.primitives.table import PRIMITIVES
from tests.front.compiled.fixed import knots_of, needs_cc, needs_cxx, needs_libm_alone

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
STRICT = ["-Wall", "-Wextra", "-Werror"]
EVERY = [(dimension, name) for dimension, table in PRIMITIVES.items() for name in table]
FORMULAS = {2: ("t, exp(a*t)", 0, 1), 3: ("t, t^2, exp(a*t)", 0, 1)}


def run(folder, *command):
    """What a command prints, run with an empty environment."""
    done = subprocess.run(command, cwd=folder, env={}, capture_output=True, text=True, check=True)
    return done.stdout


def compiled(folder, *command):
    subprocess.run(command, cwd=folder, check=True, capture_output=True)


@needs_cc
def test_the_example_of_c_has_the_knots_of_osculant(tmp_path):
    osc.compile_approximator(SPIRAL[0], "conic", *SPIRAL[1:], folder=tmp_path, name="spiral", language="c")
    flags = ["-std=c99", "-O1", "-ffp-contract=off", *STRICT]
    compiled(tmp_path, "cc", *flags, "spiral_example.c", "spiral.c", "-lm", "-o", "example")
    rows = [line.split() for line in run(tmp_path, "./example").splitlines()]
    spline = osc.approximate(osc.curve(*SPIRAL), "conic", 1e-3)
    assert [float(row[0]) for row in rows] == list(spline.knots[:-1])
    assert [float(row[2]) for row in rows] == [piece.error for piece in spline.pieces]


@needs_cxx
@needs_cc
@pytest.mark.parametrize(("dimension", "primitive"), EVERY)
def test_every_primitive_is_called_from_c_and_cpp(tmp_path, dimension, primitive):
    formula, low, high = FORMULAS[dimension]
    made = osc.compile_approximator(
        formula, primitive, low, high, parameters="a", folder=tmp_path, name="made"
    )
    compiled(tmp_path, "cc", *STRICT, "made_example.c", "libmade.so", "-Wl,-rpath,.", "-o", "example")
    (tmp_path / "main.cpp").write_text(
        '#include "made.hpp"\n#include <cstdio>\n'
        "int main() {\n    const double a[1] = {1.0};\n"
        "    for (const made::piece &p : made::for_tolerance(a, 1e-3))\n"
        '        std::printf("%.17g %.17g %.17g\\n", p.a, p.b, p.error);\n'
        "    try { made::for_tolerance(a, 1e-30); } catch (const made::failure &f) { return f.status; }\n"
        "    return 0;\n}\n"
    )
    flags = ["-std=c++17", *STRICT]
    compiled(tmp_path, "c++", *flags, "main.cpp", "libmade.so", "-Wl,-rpath,.", "-o", "main")
    from_c = run(tmp_path, "./example")
    done = subprocess.run(["./main"], cwd=tmp_path, env={}, capture_output=True, text=True)
    assert done.returncode == 2  # below the floor
    assert done.stdout == from_c and from_c
    needs_libm_alone(made.library)
    pieces = made.load().approximate(1.0, 1e-3)
    assert [float(line.split()[1]) for line in from_c.splitlines()] == pieces["b"].tolist()
    curve = osc.curve(formula.replace("a*", ""), low, high)
    assert len(pieces) == pytest.approx(len(osc.approximate(curve, primitive, 1e-3)), abs=1)


@needs_cc
@pytest.mark.parametrize("jet", [0, 2, 3])
@pytest.mark.parametrize("what", ["pieces", "invariants", "distance"])
def test_examples_with_all_that_can_be_free(tmp_path, jet, what):
    formula, parameters = (None, ()) if jet else ("a*t, exp(t)", "a")
    common = {"jet": jet, "parameters": parameters, "folder": tmp_path, "name": "free", "language": "c"}
    if what == "pieces":
        osc.compile_approximator(formula, **common)
    else:
        osc.compile_evaluator(formula, what, **common)
    compiled(tmp_path, "cc", *STRICT, "free_example.c", "free.c", "-lm", "-o", "example")
    rows = [list(map(float, line.split())) for line in run(tmp_path, "./example").splitlines()]
    assert rows and np.isfinite(rows).all()


@needs_cxx
@needs_cc
def test_cpp_evaluates_vectors(tmp_path):
    formula = "cos(t), sin(t)"
    osc.compile_evaluator(formula, "invariants", folder=tmp_path, name="bends", language="c")
    osc.compile_evaluator(formula, "distance", 0, "pi", folder=tmp_path, name="feet", language="c")
    (tmp_path / "main.cpp").write_text(
        '#include "bends.hpp"\n#include "feet.hpp"\n#include <cstdio>\nint main() {\n'
        '    std::printf("%.17g\\n", bends::invariants({0.5, 1.5}).at(1).curvature);\n'
        '    std::printf("%.17g\\n", feet::distance({0.0, 3.0, 0.0, 0.5}).at(1).distance);\n'
        "    return 0;\n}\n"
    )
    libraries = ["libbends.so", "libfeet.so", "-Wl,-rpath,."]
    compiled(tmp_path, "c++", "-std=c++17", *STRICT, "main.cpp", *libraries, "-o", "main")
    assert [float(line) for line in run(tmp_path, "./main").split()] == pytest.approx([1.0, 0.5])


@needs_cc
def test_the_module_needs_numpy_alone(tmp_path):
    osc.compile_approximator(SPIRAL[0], "biarc", *SPIRAL[1:], folder=tmp_path, name="spiral")
    script = (
        "import sys\n"
        "sys.modules.update(dict.fromkeys(['osculant', 'numba', 'llvmlite', 'sympy', 'flint']))\n"
        f"sys.path.insert(0, {str(tmp_path)!r})\n"
        "import spiral\n"
        "print(*spiral.approximate(1e-4)['b'].tolist())\n"
        "print(sorted({name.split('.')[0] for name in sys.modules} & {'osculant', 'numba'}))\n"
    )
    environment = {"LD_LIBRARY_PATH": os.environ.get("LD_LIBRARY_PATH", "")}
    done = subprocess.run(
        [sys.executable, "-I", "-c", script], env=environment, cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    spline = osc.approximate(osc.curve(*SPIRAL), "biarc", 1e-4)
    assert [float(text) for text in done.stdout.splitlines()[0].split()] == list(spline.knots[1:])


@needs_cc
def test_invariants_are_those_of_the_front_door(tmp_path):
    times = np.linspace(0.6, 6.0, 100_000)
    plane = osc.compile_evaluator(SPIRAL[0], "invariants", folder=tmp_path, name="plane").load()
    found, known = plane.invariants(times), osc.curve(*SPIRAL).tabulate(times)
    for name, values in known.items():
        assert np.allclose(found[name], values, rtol=1e-13, atol=0)
    assert np.allclose(np.hypot(found["tx"], found["ty"]), 1.0)
    formula = "a*cos(t), a*sin(t), b*t"
    helix = osc.compile_evaluator(
        formula, "invariants", parameters="a b", folder=tmp_path, name="helix"
    ).load()
    found = helix.invariants(3.0, 4.0, times)
    assert np.allclose(found["curvature"], 0.12) and np.allclose(found["torsion"], 0.16)
    normal = np.stack([found["nx"], found["ny"], found["nz"]])
    assert np.allclose(normal, [-np.cos(times), -np.sin(times), 0 * times], atol=1e-12)


@needs_cc
def test_invariants_against_many_digits(tmp_path):
    module = osc.compile_evaluator("exp(t/3)*cos(t), exp(t/3)*sin(t)", "invariants", folder=tmp_path).load()
    curve = osc.curve("exp(t/3)*cos(t), exp(t/3)*sin(t)")
    for t in (0.25, 1.5, 3.0):
        [found] = module.invariants([t])
        for name in ("curvature", "curvature_slope", "affine_curvature"):
            assert found[name] == pytest.approx(float(curve.at(t)[name]), rel=1e-12)


@needs_cc
def test_distances_of_many_points(tmp_path):
    low, high = np.pi / 6, 2 * np.pi
    module = osc.compile_evaluator(SPIRAL[0], "distance", *SPIRAL[1:], folder=tmp_path).load()
    points = np.random.default_rng(3).uniform(-8, 8, (100_000, 2))
    found = module.distance(points)
    times = np.linspace(low, high, 4001)
    dense = np.stack([times * np.cos(times), times * np.sin(times)], axis=1)
    some = slice(None, None, 25)
    nearest = np.sqrt(((points[some, None] - dense) ** 2).sum(axis=2)).min(axis=1)
    step = 7 * (times[1] - times[0])
    assert (found["distance"][some] <= nearest + 1e-14).all()
    assert (found["distance"][some] >= nearest - step).all()
    feet = np.stack([found["x"], found["y"]], axis=1)
    assert np.allclose(np.hypot(*(points - feet).T), found["distance"], rtol=1e-12)
    t = found["t"]
    assert np.allclose(feet, np.stack([t * np.cos(t), t * np.sin(t)], axis=1), atol=1e-13)
    tangent = np.stack([np.cos(t) - t * np.sin(t), np.sin(t) + t * np.cos(t)], axis=1)
    inside = (t > low + 1e-9) & (t < high - 1e-9)
    slope = ((points - feet) * tangent).sum(axis=1) / np.linalg.norm(tangent, axis=1)
    assert np.quantile(np.abs(slope[inside]), 0.999) < 1e-12
    assert np.abs(slope[inside]).max() < 1e-7  # near the evolute


@needs_cc
def test_distances_in_space_with_an_interval_given_later(tmp_path):
    module = osc.compile_evaluator("t, t^2, a*t^3", "distance", parameters="a", folder=tmp_path).load()
    [found] = module.distance(0.0, 1.0, 1.0, [[2.0, 3.0, 4.0]])
    assert found["t"] == 1.0 and found["distance"] == pytest.approx(np.sqrt(1 + 4 + 9))


@needs_cc
def test_constants_need_values(tmp_path):
    module = osc.compile_approximator(
        "t, b*exp(a*t)", "conic", 0, 1, parameters="a b", folder=tmp_path
    ).load()
    assert len(module.approximate(1.0, 2.0, 1e-2)) >= 1
    with pytest.raises(TypeError, match="'b'"):
        module.approximate(1.0)
    with pytest.raises(ValueError, match="either a tolerance"):
        module.approximate(1.0, 2.0)
    with pytest.raises(FormulaError, match="'b' is unknown"):
        osc.approximate(osc.curve("t, b*exp(a*t)", 0, 1), "conic", 1e-2)


@needs_cc
def test_a_processor_can_be_named(tmp_path):
    made = osc.compile_approximator(SPIRAL[0], "polygon", *SPIRAL[1:], folder=tmp_path, cpu="native")
    assert "-march=native" in (tmp_path / "curve.c").read_text()
    generic = osc.compile_approximator(SPIRAL[0], "polygon", *SPIRAL[1:], folder=tmp_path, name="any")
    first, second = (each.load().approximate(1e-3) for each in (made, generic))
    assert np.abs(knots_of(first) - knots_of(second)).max() < 1e-12


BAD = [
    (("a*t, t",), {}, FormulaError, "'a' is unknown"),
    (("t, t^2", "conic", 0), {}, DomainError, "two ends"),
    (("t",), {}, FormulaError, "two or three coordinates"),
    (("t, a*t", "conic"), {"parameters": "a a"}, DomainError, "twice"),
    (("t, a*t", "conic"), {"parameters": "a b"}, DomainError, "no parameter 'b'"),
    (("t, t^2", "conic"), {"parameters": "1a"}, DomainError, "'1a'"),
    (("t, t^2", "spline", 0, 1), {}, DomainError, "unknown"),
    (("t, t^2, t^3", "conic", 0, 1), {}, DomainError, "in space"),
    (("t, 1/t", "conic", -1, 1), {}, DomainError, "undefined"),
    ((None, "conic"), {}, DomainError, "no formula"),
    (("t, t^2", "conic"), {"jet": 2}, DomainError, "leave one out"),
    (("t, t^2", "conic", 0, 1), {"name": "a-b"}, OsculantError, "'a-b'"),
    (("t, t^2", "conic", 0, 1), {"language": "rust"}, DomainError, "'rust'"),
    (("t, exp(t)", "conic"), {"split_at": [1]}, DomainError, "run time"),
    (("t, exp(t)", "conic", 0, 1), {"cpu": "-O3"}, OsculantError, "processor"),
    (((sympy.Symbol("t"), sympy.gamma(sympy.Symbol("t"))), "conic", 1, 2), {}, FormulaError, "gamma"),
    (("t, floor(t)", "conic", 1, 2), {}, FormulaError, "floor"),
]


@needs_cc
@pytest.mark.parametrize(("arguments", "options", "kind", "says"), BAD)
def test_bad_input_is_refused_and_nothing_is_written(tmp_path, arguments, options, kind, says):
    folder = tmp_path / "new"
    with pytest.raises(kind, match=says) as caught:
        osc.compile_approximator(*arguments, folder=folder, **options)
    assert len(str(caught.value).splitlines()[0]) < 160
    assert not folder.exists()


def test_no_compiler_and_no_folder(tmp_path, monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(OsculantError, match="no C compiler 'no-such-compiler'"):
        osc.compile_approximator("t, exp(t)", "conic", 0, 1, folder=tmp_path / "new")
    monkeypatch.setenv("CC", "false")
    with pytest.raises(OsculantError, match="false failed"):
        osc.compile_approximator("t, exp(t)", "conic", 0, 1, folder=tmp_path / "new")
    assert not list(tmp_path.iterdir())
    monkeypatch.setenv("CC", "cc")
    (tmp_path / "file").write_text("")
    with pytest.raises(OsculantError, match="Cannot write to the folder"):
        osc.compile_approximator("t, exp(t)", "conic", 0, 1, folder=tmp_path / "file")
    (tmp_path / "full" / "curve.h").mkdir(parents=True)
    with pytest.raises(OsculantError, match=r"curve\.h is a folder"):
        osc.compile_approximator("t, exp(t)", "conic", 0, 1, folder=tmp_path / "full")
    assert [path.name for path in (tmp_path / "full").iterdir()] == ["curve.h"]
    with pytest.raises(OsculantError, match="No such file"):
        osc.compile_approximator("t, exp(t)", "conic", 0, 1, folder=tmp_path / "no" / "such")
