"""Exact invariants against the jets evaluated to 40 digits, their simplified forms, and the bound on work."""

from __future__ import annotations

import time

import mpmath
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse, parse_constant, parse_tuple
from osculant.cas.formulas.sympy_bridge import from_sympy, to_sympy
from osculant.cas.invariants.plane import ExactInvariants
from osculant.cas.jets.plane import INVARIANTS
from osculant.cas.numbers.fields import Multiprecision
from osculant.cas.numbers.taylor import program
from tests.cas.jets.all_invariants import invariants_at

T = sympy.Symbol("t", real=True)


def exact(text):
    return ExactInvariants(*parse_tuple(text))


def assert_agrees(text, at, invariants=None):
    """Every expression equals the invariant of the numerical jet."""
    formulas = parse_tuple(text)
    invariants = invariants or ExactInvariants(*formulas)
    with mpmath.workdps(50):
        t = mpmath.mpf(at)
        numbers = invariants_at(*program(formulas, 5).run(t, Multiprecision()))
        for invariant in INVARIANTS:
            if invariant.name in invariants.over_jets:
                continue
            value, number = invariants[invariant.name], numbers[invariant.name]
            pairs = zip(value, number) if isinstance(value, tuple) else [(value, number)]
            for expression, expected in pairs:
                got = sympy.N(expression.subs(T, sympy.Float(at, 50)), 40)
                assert abs(mpmath.mpf(got) - expected) <= 1e-30 * (1 + abs(expected)), invariant.name


@pytest.mark.parametrize(
    "text",
    [
        "4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)",
        "t*cos(t), t*sin(t)",
        "cos(t), sin(t + pi/3)",
        "cos(t)**3, sin(t)**3",
        "t - sin(t), 1 - cos(t)",
        "t, log(t)*abs(t - 2)",
        "t, tan(t) + atan(t)",
        "exp(t/5)*cos(2*t), exp(-t/3)*sin(t/2)",
        "sqrt(t), cbrt(t - 2) + pi*t",
        "t, sinh(2*t)*tanh(t)",
        "asin(t/3) + acos(t/4), asinh(t) + atanh(t/3)",
        "acosh(t + 1), t**t",
        "sqrt(2)*t + cos(1)*t**2, (1 + t**2)**(2/3) + e",
        "1/(1 + t**2), t/(2 - t)",
        "exp(t + 1)*sin(2), sqrt(1 + sqrt(1 + t**2))",
    ],
)
@pytest.mark.parametrize("at", ["0.7", "1.3"])
def test_agrees_with_the_jet(text, at):
    assert_agrees(text, at)


coefficient = st.integers(-5, 5)


@st.composite
def curves(draw):
    def coordinate():
        a, b, c, d = (draw(coefficient) for _ in range(4))
        m, n = draw(st.integers(1, 4)), draw(st.integers(1, 3))
        kind = draw(st.sampled_from(["trigonometric", "rational"]))
        if kind == "trigonometric":
            return f"{a}*cos({m}*t) + {b}*sin({n}*t/2) + {c}*t"
        return f"({a}*t**{m} + {b}*t + {c})/(1 + {abs(d)}*t**2)"

    return f"{coordinate()} + t, {coordinate()} + t**3"


@given(curves(), st.sampled_from(["0.3", "1.1", "-0.7"]))
@settings(max_examples=15, deadline=None)
def test_agrees_on_random_curves(text, at):
    invariants = exact(text)
    if not invariants.straight:
        assert_agrees(text, at, invariants)


# What the printed forms look like.


@pytest.mark.parametrize(
    ("text", "name", "form"),
    [
        ("4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)", "speed", "4*cos(t/3)**2"),
        ("4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)", "curvature", "1/(3*cos(t/3)**2)"),
        ("4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)", "arc_length", "2*t + 3*sin(2*t/3)"),
        ("t*cos(t), t*sin(t)", "affine_curvature", "(9*t**4 + 58*t**2 + 120)/(9*(t**2 + 2)**(8/3))"),
        ("t*cos(t), t*sin(t)", "curvature", "(t**2 + 2)/(t**2 + 1)**(3/2)"),
        ("t*cos(t), t*sin(t)", "arc_length", "t*sqrt(t**2 + 1)/2 + asinh(t)/2"),
        ("3*cos(t), 2*sin(t)", "evolute", "(5*cos(t)**3/3, -5*sin(t)**3/2)"),
        ("3*cos(t), 2*sin(t)", "affine_curvature", "6**(1/3)/6"),
        ("t, t^2", "affine_normal", "(0, 2**(1/3))"),
        ("t, t^3", "affine_curvature_slope", "20/(81*t**4)"),
        ("t, cosh(t)", "curvature", "cosh(t)**(-2)"),
        ("cos(t)^3, sin(t)^3", "speed", "3*abs(sin(t))*abs(cos(t))"),
        ("(1-t^2)/(1+t^2), 2*t/(1+t^2)", "curvature", "1"),
        ("t, 2*t", "affine_curvature", "undefined"),
        ("t, t^4", "arc_length", "Integral(sqrt(16*t**6 + 1), t)"),
    ],
)
def test_printed_forms(text, name, form):
    assert exact(text).text(name) == form


def test_text_is_a_formula_again():
    invariants = exact("abs(t - 2)*t, cbrt(t) + e*exp(-pi*t)")
    assert "cbrt" in invariants.text("speed") and "e*exp" in invariants.text("evolute")
    for name in ("speed", "curvature", "affine_curvature"):
        value = to_sympy(parse(invariants.text(name)))
        assert abs(sympy.N((invariants[name] - value).subs(T, sympy.Rational(7, 5)), 30)) < 1e-25


def test_latex():
    invariants = exact("t*cos(t), t*sin(t)")
    assert invariants.latex("speed") == r"\sqrt{t^{2} + 1}"
    assert invariants.latex("affine_tangent").startswith(r"\left(- \frac{")


def test_arc_lengths_between_bounds():
    x, y = parse_tuple("cos(t), sin(t)")
    invariants = ExactInvariants(x, y, ends=(parse_constant("0"), parse_constant("pi/3")))
    assert invariants["arc_length"] == invariants["affine_arc_length"] == sympy.pi / 3
    ellipse = ExactInvariants(
        *parse_tuple("2*cos(t), sin(t)"), ends=(parse_constant("0"), parse_constant("1"))
    )
    assert ellipse["arc_length"].limits[0][1:] == (0, 1)


# What vanishes identically.


@pytest.mark.parametrize(
    ("text", "straight", "parabola", "conic"),
    [
        ("2*t + 1, t", True, False, False),
        ("sin(t)**2, 1 + cos(t)**2", True, False, False),
        ("t, t**2 + 3*t", False, True, True),
        ("t + t**2, t - t**2", False, True, True),
        ("cos(t)**4, sin(t)**4", False, True, True),
        ("3*cos(t), 2*sin(t + pi/6)", False, False, True),
        ("cosh(t), sinh(t) + exp(t)", False, False, True),
        ("t, sqrt(1 + t**2)", False, False, True),
        ("tan(t), 1/cos(t)", False, False, True),
        ("t, t**3", False, False, False),
        ("cos(t), sin(t) + t/1000000", False, False, False),
    ],
)
def test_identities_are_seen(text, straight, parabola, conic):
    invariants = exact(text)
    assert (invariants.straight, invariants.parabola, invariants.conic) == (straight, parabola, conic)


def test_a_division_by_zero_is_a_domain_error():
    with pytest.raises(DomainError, match="zero everywhere"):
        exact("t, 1/(sin(t)**2 + cos(t)**2 - 1)")


# Bounded work.


def nested(depth):
    return "t, " + "sin(" * depth + "t" + ")" * depth


@pytest.mark.parametrize(
    "text",
    [
        nested(5),
        nested(30),
        "t, (1 + t)**1000",
        "t, t**100000",
        "t**7 - 3*t + sin(t)*exp(t), t**5*cos(t)/(1 + t**4)",
        "log(1 + t**2)*sin(3*t), atan(t)*sqrt(2 + cos(t))",
        "(1 + t + sin(t) + exp(t) + log(t))**9, t",
    ],
)
def test_large_formulas_are_answered_over_the_jet(text):
    start = time.process_time()
    invariants = exact(text)
    assert time.process_time() - start < 5  # a generous bound on what would take minutes or for ever
    assert "curvature_bend" in invariants.over_jets
    assert invariants.text("curvature_bend").count("x1") > 0
    assert_agrees(text, "0.7", invariants)


def test_sympy_expressions_are_formulas_too():
    invariants = ExactInvariants(from_sympy(T), from_sympy(T**2))
    assert invariants["curvature"] == 2 / (1 + 4 * T**2) ** sympy.Rational(3, 2)
