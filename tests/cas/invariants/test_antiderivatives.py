from __future__ import annotations

import pytest
import sympy

from osculant.cas.invariants.antiderivatives import antiderivative

T = sympy.Symbol("t", real=True)


@pytest.mark.parametrize(
    "text",
    [
        "3*t**4 - 2*t + 1",
        "sqrt(2)",
        "sin(2*t)*cos(3*t)**2 - 1",
        "5*exp(-t/3) + cosh(2*t + 1) - sinh(t)",
        "sqrt(4*t**2 + 2*t + 3)",
        "7/sqrt(2*t**2 + 1)",
        "1/(t**2 - t + 5)",
    ],
)
def test_the_derivative_gives_the_integrand_back(text):
    f = sympy.sympify(text, locals={"t": T})
    primitive = antiderivative(f, T)
    for at in (sympy.Rational(-7, 3), sympy.Rational(5, 4)):
        assert abs(sympy.N((sympy.diff(primitive, T) - f).subs(T, at), 30)) < 1e-25


@pytest.mark.parametrize(
    "text", ["sqrt(1 - t**2)", "sqrt(t**4 + 1)", "1/t", "sin(t**2)", "Abs(sin(t))", "exp(Abs(t))", "t*sin(t)"]
)
def test_everything_else_is_left_alone(text):
    assert antiderivative(sympy.sympify(text, locals={"t": T}), T) is None
