"""What an end with a simple zero of the integrand costs: the model, its limit, and real curves."""

from __future__ import annotations

from itertools import pairwise

import mpmath
import pytest
import sympy as sp
from flint import arb

from osculant.cas.asymptotics.end_corrections import end_correction, greedy_contents, model
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry.bitangent import ReferenceCurve
from osculant.cas.geometry.greedy import greedy_knots
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.laws.complexity import complexity_constant
from osculant.cas.numbers.balls import PRECISION, precision


@pytest.mark.parametrize(("primitive", "known"), [("parabola", "0.0550"), ("conic", "0.0484")])
def test_known_values(primitive, known):
    assert abs(end_correction(primitive) - mpmath.mpf(known)) < 5e-5


def test_model_is_hermite_interpolation():
    """f − d interpolates f = uⁿ/n! doubly at both ends: checked by its values and slopes and its degree."""
    for primitive, degree in (("parabola", 5), ("conic", 6)):
        d, (m, e, q, x) = model(primitive)
        u = sp.Symbol("u")
        rest = sp.expand(u**degree / sp.factorial(degree) - d.subs(x, (u - m) / e))
        for end in (m - e, m + e):
            assert sp.expand(rest.subs(u, end) - end**degree / sp.factorial(degree)) == 0
            assert (
                sp.expand(sp.diff(rest, u).subs(u, end) - end ** (degree - 1) / sp.factorial(degree - 1)) == 0
            )
        assert sp.degree(rest, u) == (3 if primitive == "parabola" else 4)
        assert d.has(q) == (primitive == "conic")


@pytest.mark.parametrize("primitive", ["parabola", "conic"])
def test_contents_grow_by_one(primitive):
    """Far from the end an arc has the content 1, and the sum lags by the correction."""
    with mpmath.workdps(30):
        contents = greedy_contents(primitive, 30)
        correction = end_correction(primitive)
        lags = [n - x for n, x in enumerate(contents, 1)]
        assert all(a < b < correction for a, b in pairwise(lags))
        assert abs((correction - lags[-1]) * 30 - (correction - lags[14]) * 15) < 1e-4  # a multiple of 1/n


@pytest.mark.parametrize(
    ("primitive", "text"),
    [
        ("conic", "4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)"),  # Cayley's sextic from its sextactic point
        ("parabola", "t, t^2/2 + t^5"),  # k = 0 at t = 0
    ],
)
def test_real_curves(primitive, text):
    """n − Cε^{−1/p} at the n-th knot from such an end tends to the model's value as ε → 0."""
    order = {"parabola": 4, "conic": 5}[primitive]
    with mpmath.workdps(30):
        contents, gaps = greedy_contents(primitive, 3), []
        for tolerance in ("1e-10", "1e-14"):
            eps = mpmath.mpf(tolerance)
            knots = greedy_knots(ReferenceCurve(text), primitive, 0, eps, mpmath.mpf("0.02"), 3)
            with precision(PRECISION):
                end = arb(mpmath.nstr(knots[-1], 30))
            leading, _ = complexity_constant(CurveBalls(parse_tuple(text)), primitive, arb(0), end)
            found = mpmath.mpf(leading.str(25, radius=False)) / mpmath.root(eps, order)
            gaps.append(abs(found - contents[2]))
        assert gaps[1] < gaps[0] / 2 < 1e-3


def test_bad_input():
    with pytest.raises(DomainError, match="'biarc'"):
        model("biarc")
    with pytest.raises(DomainError, match="not to 40"):
        end_correction("conic", 40)
    for attempt in (lambda: end_correction("cubic"), lambda: greedy_contents("cubic", 3)):
        with pytest.raises(DomainError, match="'cubic'"):
            attempt()
    for count in (-1, 0, 2.5):
        with pytest.raises(DomainError, match=f"1 or more arcs, not over {count}"):
            greedy_contents("conic", count)
