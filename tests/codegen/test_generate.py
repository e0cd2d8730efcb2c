"""Generated files are what the derivations give today, and say what sympy says."""

from __future__ import annotations

import importlib.util
import inspect
import math
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from osculant.cas.formulas.sympy_bridge import cbrt
from osculant.cas.geometry import pencil
from osculant.cas.jets.derivations import affine, plane
from osculant.codegen import generate
from osculant.codegen.closed_forms import ClosedForm, function_source, module_source
from osculant.kernels.generated import laws
from osculant.kernels.generated import pencil as printed
from osculant.kernels.generated.invariants import invariants

a, b, c = sp.symbols("a b c", real=True)


def load(text, folder):
    """A printed module, imported."""
    path = folder / "printed.py"
    path.write_text(text, encoding="utf-8")
    spec = importlib.util.spec_from_file_location("printed", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def in_50_digits(form):
    """The results of a closed form as a function of doubles."""
    functions = {
        "cbrt": lambda x: mpmath.sign(x) * mpmath.cbrt(abs(x)),
    }
    evaluate = sp.lambdify(form.arguments, list(form.results.values()), [functions, "mpmath"], cse=True)

    def exact(*numbers):
        with mpmath.workdps(50):
            return evaluate(*map(mpmath.mpf, numbers))

    return exact


def agrees(function, exact, numbers, tolerance=1e-12):
    """Whether the printed function, interpreted, is as near to the exact one as that."""
    got = function.__wrapped__(*map(np.float64, numbers))
    got = got if isinstance(got, tuple) else (got,)
    pairs = zip(map(float, got), exact(*numbers), strict=True)
    return all(abs(x - y) <= tolerance * (1e-3 + abs(y)) for x, y in pairs)


def altered(exact, place):
    """The same function with one result off by a billionth."""

    def wrong(*numbers):
        results = exact(*numbers)
        results[place] *= 1 + 1e-9
        return results

    return wrong


# The committed files.


def test_committed_files_are_current():
    assert generate.main(["--check"]) == 0
    assert generate.MODULES
    for name, make in generate.MODULES.items():
        assert (generate.FOLDER / name).read_text(encoding="utf-8") == make()


def test_nothing_else_lies_among_them():
    assert {path.name for path in generate.FOLDER.glob("*.py")} == {"__init__.py", *generate.MODULES}


@pytest.mark.parametrize("name", generate.MODULES)
def test_an_edited_file_is_noticed(name, tmp_path, monkeypatch, capsys):
    for module in generate.MODULES:
        (tmp_path / module).write_text(
            (generate.FOLDER / module).read_text(encoding="utf-8"), encoding="utf-8"
        )
    monkeypatch.setattr(generate, "FOLDER", tmp_path)
    path = tmp_path / name
    true_text = path.read_text(encoding="utf-8")
    path.write_text(true_text.replace("+", "-", 1), encoding="utf-8")
    assert generate.main(["--check"]) == 1
    assert name in capsys.readouterr().out
    path.unlink()
    assert generate.main(["--check"]) == 1
    assert generate.main([]) == 0
    assert path.read_text(encoding="utf-8") == true_text


def test_a_changed_derivation_is_noticed(monkeypatch, capsys):
    monkeypatch.setattr(pencil, "implicit", lambda along: along[1] ** 2 - 2 * pencil.Q * along[0] * along[2])
    assert generate.main(["--check"]) == 1
    assert "pencil.py" in capsys.readouterr().out


def test_changed_constants_are_noticed(monkeypatch):
    monkeypatch.setattr(
        pencil, "lobe_shape", lambda n: ((1 - a) ** 2 * a**2 * (a - sp.Rational(1, 3)) ** n, a)
    )
    monkeypatch.setattr(pencil, "lobes", lambda _: {"first": sp.Rational(1, 3)})
    assert generate.main(["--check"]) == 1


# Numbers.


def test_constants_are_the_nearest_doubles():
    printed = generate.pencil_module()
    for primitive, crossings in (("PARABOLA", 0), ("CONIC", 1)):
        for name, exact in pencil.lobes(crossings).items():
            [line] = [x for x in printed.splitlines() if x.startswith(f"{primitive}_{name.upper()} = ")]
            value = float(line.split("=")[1].split("#")[0])
            with mpmath.workdps(50):
                error = abs(mpmath.mpf(str(sp.N(exact, 50))) - value)
            assert error <= math.ulp(value) / 2


@cache
def pencil_forms():
    """The closed forms of the pencil in 50 digits, by name."""
    lines, angles = (pencil.l0, pencil.l1, pencil.l2), (pencil.sin_a, pencil.sin_b, pencil.sin_psi)
    slopes = (pencil.n0, pencil.n1, pencil.n2, pencil.t0, pencil.t1, pencil.t2)
    bezier = pencil.weights()
    every = [
        ClosedForm(
            "displacement",
            "",
            (pencil.Q, *lines, *slopes, pencil.speed, pencil.curvature),
            {name: pencil.displacement()[name] for name in ("d", "by_q", "slope", "foot0", "foot1", "foot2")},
        ),
        ClosedForm("through", "", lines, {"Q": pencil.through()}),
        ClosedForm("parabola", "", angles, {"Q": bezier["parabola"]}),
        ClosedForm(
            "weight", "", (pencil.Q, pencil.chord, *angles), {n: bezier[n] for n in ("weight", "reach")}
        ),
    ]
    return {form.name: in_50_digits(form) for form in every}


signed = st.floats(0.1, 3).flatmap(lambda x: st.sampled_from([x, -x]))


@given(st.floats(0.05, 2), st.lists(signed, min_size=11, max_size=11))
@settings(max_examples=60, deadline=None)
def test_printed_displacement(q, numbers):
    l0, l1, l2, n0, n1, n2 = numbers[:6]
    middle, last = 2 * l1 * n1 - 4 * q * (l0 * n2 + l2 * n0), l1**2 - 4 * q * l0 * l2
    square = middle**2 - 4 * (n1**2 - 4 * q * n0 * n2) * last
    if square > 0.1 and abs(middle) > 1e-6:  # the normal meets the conic, and not just so
        assert agrees(printed.displacement, pencil_forms()["displacement"], (q, *numbers), 1e-10)
    elif square < -0.1:
        assert math.isnan(printed.displacement(q, *numbers)[0])


@pytest.mark.parametrize("name", ["through", "parabola", "weight"])
@given(st.lists(st.floats(0.1, 1.5), min_size=5, max_size=5))
@settings(max_examples=20, deadline=None)
def test_printed_forms_of_the_pencil(name, numbers):
    function, exact = getattr(printed, name), pencil_forms()[name]
    numbers = numbers[: len(inspect.signature(function.__wrapped__).parameters)]
    assert agrees(function, exact, numbers)
    for place in range(len(exact(*numbers))):
        assert not agrees(function, altered(exact, place), numbers)


@given(st.lists(signed, min_size=10, max_size=10))
@settings(max_examples=40, deadline=None)
def test_printed_invariants(numbers):
    bend = abs(numbers[0] * numbers[6] - numbers[1] * numbers[5])
    if bend > 0.1:  # next to an inflection the numerators cancel
        assert agrees(invariants, exact_invariants(), numbers, 1e-9 / bend)
        got = exact_invariants()(*numbers)
        mirrored = exact_invariants()(*numbers[:5], *(-y for y in numbers[5:]))
        assert mirrored == pytest.approx([got[0], -got[1], -got[2], -got[3], got[4], -got[5]])
        assert not agrees(invariants, lambda *_: mirrored, numbers, 1e-9 / bend)


@cache
def exact_invariants():
    """κ, k and so on from the definitions' derivation, independent of the jets' forms that are printed."""
    arguments = dict(zip((*plane.x[1:6], *plane.y[1:6]), sp.symbols("x1:6 y1:6", real=True), strict=True))
    speed = sp.sqrt(plane.x[1] ** 2 + plane.y[1] ** 2)
    root = cbrt(plane.x[1] * plane.y[2] - plane.x[2] * plane.y[1])
    results = {
        "speed": plane.v,
        "curvature": affine.curvature(),
        "curvature_slope": affine.curvature(1),
        "affine_speed": plane.phi,
        "affine_curvature": affine.affine_curvature(),
        "affine_curvature_slope": affine.affine_curvature_slope(),
    }
    plain = {n: e.subs({plane.v: speed, plane.phi: root}).subs(arguments) for n, e in results.items()}
    return in_50_digits(ClosedForm("invariants", "", tuple(arguments.values()), plain))


@given(st.lists(signed, min_size=10, max_size=10))
@settings(max_examples=40, deadline=None)
def test_printed_laws(numbers):
    """Theorems 3.6.1 and 3.6.4, and biarcs, to the power 1/p, from the invariants' definitions."""
    if abs(numbers[0] * numbers[6] - numbers[1] * numbers[5]) > 0.1:
        speed, kappa, bend, _, k, slope = exact_invariants()(*numbers)
        with mpmath.workdps(50):
            parabola = (abs(k) * mpmath.cbrt(abs(kappa)) ** 5 / 128) ** (mpmath.mpf(1) / 4) * speed
            conic = mpmath.root(abs(slope) * kappa**2 / (2000 * mpmath.sqrt(5)), 5) * speed
            parabola_area = mpmath.root(abs(k) * mpmath.cbrt(abs(kappa)) ** 5 / 240, 5) * speed
            conic_area = mpmath.root(abs(slope) * kappa**2 / 7680, 6) * speed
            biarc, biarc_area = (mpmath.root(abs(bend) / c, p) * speed for c, p in ((324, 3), (576, 4)))
        for function, value in (
            (laws.parabola_density, parabola),
            (laws.conic_density, conic),
            (laws.biarc_density, biarc),
            (laws.parabola_area_density, parabola_area),
            (laws.conic_area_density, conic_area),
            (laws.biarc_area_density, biarc_area),
        ):
            if value > 1e-2:  # a root makes much of the rounding of what nearly vanishes
                assert agrees(function, lambda *_, x=value: [x], numbers, 1e-8)
                assert not agrees(function, lambda *_, x=value: [x * (1 + 1e-6)], numbers, 1e-8)


# What the printer makes of an expression.

EXPRESSIONS = [
    a**2 - b**3 + c**4 - a**5,
    -(a**2) / b**3,
    1 / (a - b) / c,
    (a + b) ** -2 * sp.Rational(-3, 7),
    sp.sqrt(a**2 + b**2) / sp.sqrt(c**2 + 2),
    (a**2 + 1) ** sp.Rational(1, 3) - (b**2 + 1) ** sp.Rational(-5, 2),
    sp.pi * a - sp.sqrt(2) * b + sp.E * c,
    cbrt(a * b) - cbrt(a - 3),
    (a - (b - c)) - (c - (a - b) ** 2) ** 2,
    a / (b / (c / (a + 4))),
    sp.sin(a) ** 2 * sp.exp(-b) - sp.atan(c),
    sp.Integer(3),
]


@given(st.lists(signed, min_size=3, max_size=3))
@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_printed_expressions(tmp_path, numbers):
    form = ClosedForm("f", "A test.", (a, b, c), {f"r{i}": expr for i, expr in enumerate(EXPRESSIONS)})
    if min(abs(numbers[0] - numbers[1]), abs(numbers[0] + numbers[1])) > 0.05:
        module = load(module_source("a test", [form], {}), tmp_path)
        assert agrees(module.f, in_50_digits(form), numbers, 1e-11)
        assert not agrees(module.f, altered(in_50_digits(form), -1), numbers, 1e-11)


def test_common_parts_are_shared():
    root = sp.sqrt(a**2 + b**2)
    source = function_source(ClosedForm("f", "A test.", (a, b), {"x": a / root, "y": b / root}))
    assert source.count("sqrt") == 1
    assert source.startswith("@kernel\ndef f(a: float, b: float) -> tuple[float, float]:\n")


def test_a_module_of_constants(tmp_path):
    module = load(
        module_source("a test", [], {"THIRD": sp.Rational(1, 3), "ROOT": sp.sqrt(5) / 10}), tmp_path
    )
    assert (module.THIRD, module.ROOT) == (1 / 3, 0.22360679774997896964)
    assert module.__doc__.startswith("Generated from a test by codegen.generate; do not edit.")
