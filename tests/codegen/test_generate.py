"""Generated files are what the derivations give today, and say what sympy says."""

from __future__ import annotations

import importlib.util
import math

import mpmath
import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from osculant.cas import pencil
from osculant.cas.functions import copysign
from osculant.cas.invariants import invariants_at
from osculant.cas.sympy_bridge import cbrt
from osculant.codegen import generate
from osculant.codegen.closed_forms import ClosedForm, function_source, module_source

a, b, c = sp.symbols("a b c", real=True)


def load(text, folder):
    """A printed module, imported."""
    path = folder / "printed.py"
    path.write_text(text, encoding="utf-8")
    spec = importlib.util.spec_from_file_location("printed", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def exactly(expr, values):
    """The value of an expression at exactly those doubles, to 50 digits."""
    plain = expr.replace(copysign, lambda x, y: sp.Abs(x) * sp.sign(y))
    return sp.N(plain.subs({symbol: sp.Rational(value) for symbol, value in values.items()}), 50)


def agrees(function, form, values):
    """Whether the printed function, interpreted, is within 1e-12 of the expressions."""
    got = function.py_func(*[values[symbol] for symbol in form.arguments])
    got = got if isinstance(got, tuple) else (got,)
    exact = [exactly(expr, values) for expr in form.results.values()]
    return all(abs(x - y) <= 1e-12 * (1e-3 + abs(y)) for x, y in zip(got, exact, strict=True))


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


signed = st.floats(0.1, 3).flatmap(lambda x: st.sampled_from([x, -x]))


@given(st.lists(signed, min_size=10, max_size=10), st.floats(0.05, 2))
@settings(max_examples=25, deadline=None)
def test_printed_displacement(numbers, q):
    from osculant.kernels.generated import pencil as printed

    names = ("l0", "l1", "l2", "n0", "n1", "n2", "t0", "t1", "t2", "speed", "curvature")
    values = dict(zip((getattr(pencil, name) for name in names), [*numbers, 0.3], strict=True)) | {
        pencil.Q: q
    }
    form = ClosedForm("d", "", (pencil.Q, *values), pencil.displacement())
    square = (
        (2 * values[pencil.l1] * values[pencil.n1])
        - 4 * q * (values[pencil.l0] * values[pencil.n2] + values[pencil.l2] * values[pencil.n0])
    ) ** 2 - 4 * (values[pencil.n1] ** 2 - 4 * q * values[pencil.n0] * values[pencil.n2]) * (
        values[pencil.l1] ** 2 - 4 * q * values[pencil.l0] * values[pencil.l2]
    )
    if square > 0.1:  # the normal meets the conic, and not just so
        assert agrees(printed.displacement, form, values)
    elif square < -0.1:
        assert math.isnan(printed.displacement(*[values[symbol] for symbol in form.arguments])[0])


@given(st.lists(st.floats(0.1, 1.5), min_size=4, max_size=4), st.floats(0.1, 30))
@settings(max_examples=20, deadline=None)
def test_printed_weight_and_parabola(numbers, q):
    from osculant.kernels.generated import pencil as printed

    names = ("chord", "sin_a", "sin_b", "sin_psi")
    values = dict(zip((getattr(pencil, name) for name in names), numbers, strict=True)) | {pencil.Q: q}
    bezier = pencil.weights()
    parabola = ClosedForm("", "", (pencil.sin_a, pencil.sin_b, pencil.sin_psi), {"Q": bezier.pop("parabola")})
    weight = ClosedForm("", "", (pencil.Q, *list(values)[:4]), bezier)
    through = ClosedForm("", "", (pencil.l0, pencil.l1, pencil.l2), {"Q": pencil.through()})
    lines = dict(zip(through.arguments, numbers, strict=False))
    assert agrees(printed.parabola, parabola, values)
    assert agrees(printed.weight, weight, values)
    assert agrees(printed.through, through, lines)
    assert not agrees(printed.weight, weight, values | {pencil.sin_b: q + 2}) or q + 2 == numbers[2]


@given(st.lists(signed, min_size=10, max_size=10))
@settings(max_examples=25, deadline=None)
def test_printed_invariants(numbers):
    from osculant.kernels.generated.invariants import invariants

    exact = invariants_at([0, *map(sp.Rational, numbers[:5])], [0, *map(sp.Rational, numbers[5:])])
    got = invariants.py_func(*numbers)
    names = ("speed", "curvature", "curvature_slope", "affine_speed", "affine_curvature")
    bend = abs(numbers[0] * numbers[6] - numbers[1] * numbers[5])
    for name, x in zip((*names, "affine_curvature_slope"), got, strict=True):
        assert abs(x - sp.N(exact[name], 50)) <= 1e-10 * (1 + bend**-4), name


# What the printer makes of an expression.

EXPRESSIONS = [
    a**2 - b**3 + c**4 - a**5,
    -(a**2) / b**3,
    1 / (a - b) / c,
    (a + b) ** -2 * sp.Rational(-3, 7),
    sp.sqrt(a**2 + b**2) / sp.sqrt(c**2 + 2),
    (a**2 + 1) ** sp.Rational(1, 3) - (b**2 + 1) ** sp.Rational(-5, 2),
    sp.pi * a - sp.sqrt(2) * b + sp.E * c,
    copysign(a, b * c) + copysign(sp.sqrt(a**2 + 1), -c),
    cbrt(a * b) - cbrt(a - 3),
    (a - (b - c)) - (c - (a - b) ** 2) ** 2,
    a / (b / (c / (a + 4))),
    sp.sin(a) ** 2 * sp.exp(-b) - sp.atan(c),
    sp.Integer(3) + 0 * a,
]


@given(st.lists(signed, min_size=3, max_size=3))
@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_printed_expressions(tmp_path, numbers):
    form = ClosedForm("f", "A test.", (a, b, c), {f"r{i}": expr for i, expr in enumerate(EXPRESSIONS)})
    values = dict(zip((a, b, c), numbers, strict=True))
    if min(abs(numbers[0] - numbers[1]), abs(numbers[0] + numbers[1])) > 0.05:
        module = load(module_source("a test", [form], {}), tmp_path)
        assert agrees(module.f, form, values)
        wrong = ClosedForm("f", "", (a, b, c), form.results | {"r0": EXPRESSIONS[0] + a / 10**9})
        assert not agrees(module.f, wrong, values)


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
