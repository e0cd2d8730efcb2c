"""Analytic germs: infinite ones with several functions of one argument are proved so, finite ones never."""

from __future__ import annotations

import pytest

from osculant.cas.germs import geometry
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.geometry import prove
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import GROUPS
from osculant.cas.germs.model_reading import model_of
from osculant.cas.germs.polynomials import variable
from osculant.certificates.checker import check
from osculant.germs.map_germ import germ
from osculant.germs.report import certificate_file

INFINITE = [
    ("x, cos(y) - 1, y**2", "x y", "A"),
    ("x, cos(y) - 1, cos(2*y) - 1", "x y", "A"),
    ("x, exp(y) - 1 - y, y**2", "x y", "A"),
    ("x, cosh(y) - 1, y*sin(y)", "x y", "A"),
    ("x, sqrt(1 + y**2) - 1, cos(y) - 1", "x y", "A"),
    ("x, sin(y)**2/(1 + y), y**2", "x y", "A"),
    ("x, cos(y) - 1 + y**2/2, y**4", "x y", "A"),
    ("(sin(x*y) - x*y)*(1 + x)", "x y", "R"),
    ("sin(x*y), x*y**2", "x y", "C"),
    ("exp(x + y**2) - 1, (x + y**2)**2", "x y", "K"),
    ("sqrt(1 + x) - 1 - x/2, x**2", "x y", "K"),
    ("x*tan(u) - x*u", "x u", "R(H)"),
    ("sqrt(2 + x) - sqrt(2) - x*sqrt(2)/4, x**2", "x y", "K"),
]
#: with the extended codimension: names of the polynomial germs that they are equivalent to
FINITE = [
    ("x, cos(y) - 1, sin(y)**3 + x**2*sin(y)", "x y", "A", 1),  # S₁
    ("x, exp(y) - 1 - y, x*y", "x y", "A", 0),  # the cross-cap
    ("x, x*log(1 + y) + sin(y) - y", "x y", "A", 0),  # the pleat
    ("sin(x)**3 + (exp(y) - 1)**4", "x y", "R", 6),  # E₆
    ("sin(x) - x + tan(y)**2", "x y", "R", 2),  # A₂
    ("sqrt(1 + x**2) - cos(y) + x**2*y", "x y", "K", 1),  # A₁
    ("cos(x) - 1, x**3", "x", "A", 1),  # the cusp
    ("exp(x) - 1, sin(u)**2 + x*u", "x u", "A(H)", 0),
    ("cos(x) - cosh(y), sin(x*y)", "x y", "K", 4),  # I₂,₂: x² + y², xy
]


@pytest.mark.parametrize(("text", "source", "name"), INFINITE)
def test_infinite_analytic_germs(text, source, name):
    assert prove(Germ(text, source), GROUPS[name]) is not None
    data = certificate_file(germ(text, source), name)
    assert data["codimension"] == data["determinacy"] == "infinite"
    assert any("is infinite" in sentence for sentence in check(data))


@pytest.mark.parametrize(("text", "source", "name", "value"), FINITE)
def test_finite_analytic_germs_are_not_proved_infinite(text, source, name, value, monkeypatch):
    monkeypatch.setattr(geometry, "LONGEST", geometry.SLICE * 1.01)
    assert codimension(Germ(text, source), name, extended=True).value == value
    assert prove(Germ(text, source), GROUPS[name]) is None


@pytest.mark.parametrize(
    "text",
    ["sin(x + y**2)", "exp(2*x) - 1", "log(1 + x*y + x)", "sqrt(4 + x) - 2", "tanh(x/3)", "atan(exp(x) - 1)"],
)
def test_functions_are_their_arguments_times_units(text):
    # T = a (c + U): the terms of degree 1 of T are those of c a
    model = model_of(Germ(text, "x y"))
    assert model is not None and all(told is not None for told in model.arguments)
    for k, (argument, slope) in enumerate(model.arguments):
        divided = model.divided(model.variables[model.n + k])
        assert model.at_origin(divided) == 0
        for i in range(model.n):
            axis = tuple(int(i == j) for j in range(model.n))
            if model.extra == 1:
                assert model.at_origin(divided, axis) == model.at_origin(argument, axis) * model.at_origin(
                    slope
                )
    if text.startswith("sqrt"):  # √(4 + x) − 2 = x (1/4 + …)
        assert Germ(text, "x y").jet(1)[0][variable(0, 2)] == model.at_origin(model.arguments[0][1])


def test_a_divided_locus_needs_functions():
    data = certificate_file(germ("x, y**2, 0", "x y"), "A")
    data["certificate"]["codimension"]["locus"]["divided"] = True
    assert check(data)  # nothing to divide: the same ideal
    other = certificate_file(germ("x, cos(y) - 1, y**2", "x y"), "A")
    other["certificate"]["codimension"]["locus"].pop("divided")
    with pytest.raises(ValueError, match="not in the ideal"):
        check(other)
