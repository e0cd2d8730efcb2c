"""Loci: no finite germ has too large ones, infinite germs have; local dimensions against known ones."""

from __future__ import annotations

import time

import pytest

from osculant.cas.germs import geometry
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.geometry import Geometry, prove
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import GROUPS, group
from osculant.cas.germs.local_dimension import isolated, large_zeros
from osculant.cas.germs.model import ring
from osculant.cas.germs.model_reading import model_of
from osculant.cas.germs.normal_form import normal_form
from osculant.cas.germs.reference import NAMES, reference
from osculant.cas.germs.schemes import expected, partitions


def germs(name):
    for entry in reference(name).entries:
        for signs, parameters in entry.tried():
            yield entry.germ(signs, **parameters), entry.group


@pytest.mark.parametrize(
    "name",
    [
        "mond",
        "plane curves",
        "boundary functions",
        "klotz pop rieger",
        *(pytest.param(name, marks=pytest.mark.slow) for name in NAMES),
    ],
)
def test_no_germ_of_a_list_is_proved_infinite(name, monkeypatch):
    monkeypatch.setattr(geometry, "LONGEST", geometry.SLICE * 1.01)  # one round
    for germ, acting in germs(name):
        assert prove(germ, group(acting)) is None, str(germ)


@pytest.mark.parametrize(
    ("text", "source", "name"),
    [
        ("x**2 - y**2, x*y + x**5", "x y", "A"),  # f|Σ is 1-1
        ("x*y, x**5 + y**7", "x y", "A"),
        ("x, y, z**2, z*(z**2 + x**2*y + y**4)", "x y z", "A"),
        ("a, b, c, d, z**6 + a*z + b*z**2 + c*z**3 + d*z**4", "a b c d z", "A"),
        ("a, b, c, x**2 + y**2 + a*x, x*y + b*x + c*y", "a b c x y", "A"),
        ("x**2 + y**2 + z**2, x*y*z", "x y z", "K"),
        ("exp(x) - 1, (exp(u) - 1)**2 + x*u", "x u", "A(H)"),
        ("x*u + x**3, u - x**2", "x u", "A(H)"),
        ("x, x*y + y**6 + y**9/10**9", "x y", "A"),
    ],
)
def test_finite_germs_are_not_proved_infinite(text, source, name, monkeypatch):
    monkeypatch.setattr(geometry, "LONGEST", geometry.SLICE * 1.01)
    assert prove(Germ(text, source), GROUPS[name]) is None


@pytest.mark.parametrize(
    ("text", "source", "name", "kind"),
    [
        ("x, x*y, y**3", "x y", "A", "multiple"),
        ("t**3, t**6", "t", "A", "multiple"),
        ("x**2 - y**2, x*y", "x y", "A", "double"),
        ("x**2, y**2, z**2", "x y z", "A", "rank"),
        ("(x - y + x**2)**4, x", "x y", "A", "singular"),
        ("x, y, z**2 + w**2*(w - x)**2", "x y z w", "A", "singular"),
        ("x, (y**2 - x - x**2)**2", "x y", "A", "multiple"),
        ("t**2, t**4", "t", "L", "double"),
        ("x, y**4*exp(x*y)", "x y", "A", "singular"),
        ("sin(x) - x, y", "x y", "A", "singular"),
        ("(x - sin(y))**2", "x y", "R", "module"),
        ("x, u*y", "x y u", "A(H)", "module"),
        ("x*u**2", "x u", "K(H)", "module"),
    ],
)
def test_infinite_germs_are_proved_so(text, source, name, kind):
    begun = time.monotonic()
    found = prove(Germ(text, source), GROUPS[name])
    assert found is not None
    assert found.locus["kind"] == kind
    assert str(found).endswith("or more")
    assert codimension(Germ(text, source), name).value == "infinite"
    assert time.monotonic() - begun < 20


def test_a_search_can_be_stopped():
    hard = Geometry(Germ("(x**2 + x*y + y*z + z**2 - x**3)**2 + x**7 + y**6*z", "x y z"), GROUPS["R"])
    begun = time.monotonic()
    hard.start()
    hard.result(0.05)
    hard.stop()
    hard.stop()
    assert time.monotonic() - begun < 5
    unknown = Geometry(Germ("asin(x)**2, 0", "x"), GROUPS["A"])
    assert unknown.result(20) is None and unknown.over


@pytest.mark.parametrize(
    ("texts", "dimension"),
    [
        (["x*y", "x*z"], 2),
        (["x*y", "x*z", "y*z"], 1),
        (["x**2 + y**3", "y**2 + z**5", "z**2"], 0),
        (["x + x**2", "y - z**2", "x*z"], 1),
        (["x*(1 - y)", "x*(1 + z)"], 2),
        (["x - y**2", "x - y**2 + z - y**3", "z*(1 + x) - y**3 + x*z"], 0),
        (["1 + x", "y"], -1),
        (["x*(y - 1)", "z*(y - 1)", "x*z"], 1),
    ],
)
def test_local_dimensions(texts, dimension):
    context = ring(["x", "y", "z"])
    found = [polynomial(text, context) for text in texts]
    for least in (1, 2, 3):
        assert (large_zeros(context, found, least, False) is not None) == (dimension >= least)


def polynomial(text, context):
    from osculant.cas.germs.model import polynomial as made

    shift = {"1 + x": "x"}.get(text)
    f = made(Germ(shift or text, "x y z").jet(8)[0], context, 3)
    return f + 1 if shift else f


def test_zeros_off_a_hyperplane():
    context = ring(["x", "y", "l"])
    x, y, last = context.gens()
    assert large_zeros(context, [x * last], 2, True) is not None
    assert large_zeros(context, [last * (x - y), last * x], 2, True) is None  # off l = 0 only a line
    assert large_zeros(context, [last * (x - y), last * x], 1, True) is not None
    assert large_zeros(context, [last**2], 1, True) is None
    assert large_zeros(context, [last * (1 - x)], 1, True) is None


def test_isolated_zeros():
    assert isolated([{(1, 0): 1}, {(0, 3): 1}], 2) == 3
    assert isolated([{(1, 1): 1}], 2, 6) is None


@pytest.mark.parametrize(
    ("text", "inner"),
    [
        ("x*exp(x*y)", "exp(x*y) - 1"),
        ("x*log(1 + x)/(2 - y)", "log(1 + x)"),
        ("y + x*atan(x + y**2)", "atan(x + y**2)"),
        ("x*sqrt(4 + x/(1 + y))", "sqrt(4 + x/(1 + y)) - 2"),
        ("tan(x*y/(3 + y)) + x", "tan(x*y/(3 + y)/2)"),
        ("(2 + y)*tanh(x) + y*cosh(x)", "tanh(x/2)"),
        ("x*cos(y) + sin(y)**2", "tan(y/2)"),
    ],
)
def test_models_differentiate_like_sympy(text, inner):
    """Both partial derivatives are those of sympy times one factor, with the function's value put in."""
    import sympy

    model = model_of(Germ(text, "x y"))
    assert model.extra == 1
    x, y = sympy.symbols("x y")
    point = {x: sympy.Rational(1, 5), y: sympy.Rational(-1, 7)}
    at = {**point, sympy.Symbol(model.context.names()[2]): sympy.sympify(inner).subs(point)}
    found = [sympy.sympify(str(g).replace("^", "**")).subs(at) for g in model.gradient(0)]
    truth = [sympy.diff(sympy.sympify(text), v).subs(point) for v in (x, y)]
    assert abs((found[0] * truth[1] - found[1] * truth[0]).evalf(40)) < 1e-30
    assert abs(found[0].evalf(30)) > 1e-6


def test_normal_forms_and_partitions():
    germ = Germ("x + y**2, z - x*y + y**3, x**3 + y*z", "x y z")
    found = normal_form(model_of(germ))
    moved = [f.compose(*found.source, ctx=f.context()) for f, _ in model_of(germ).components]
    gens = list(moved[0].context().gens())
    for row, wanted in zip(found.target, [*gens[:2], found.functions[0][0]]):
        assert sum((c * f for c, f in zip(row, moved)), moved[0] * 0) == wanted
    assert normal_form(model_of(Germ("x**2, y**2", "x y"))) is None  # corank 2
    assert normal_form(model_of(Germ("x/(1 + y), y**2", "x y"))) is None
    for n, p in ((1, 2), (2, 2), (2, 3), (3, 3), (3, 4), (2, 4)):
        chosen = list(partitions(n, p))
        assert chosen and any(expected(n, p, parts) <= 0 for parts in chosen)
