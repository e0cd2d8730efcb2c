"""Section 2.2: the affine canonical form, from series with generic k and all its derivatives."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import all_of, order, read_tuple, vanishes
from osculant.cas.jets.canonical import affine_arc, affine_graph
from osculant.cas.numbers.power_series import PowerSeries

#: the orders to which remainders are examined
ORDER = 8


def generators(count: int) -> tuple[Any, ...]:
    """k and its derivatives by r as generators k0, k1, … of a sympy ring."""
    return tuple(sp.ring(f"k:{count}", sp.QQ)[1:])


def names(k: tuple[Any, ...]) -> dict[str, Any]:
    """The same as symbols by name."""
    return {str(g): g.as_expr() for g in k}


def truncated(series: PowerSeries, form: Any, variable: Any, length: int, what: str) -> Evidence:
    """Whether a series over a sympy ring is the polynomial stated, up to O(variable^length)."""
    stated = sp.Poly(form, variable)
    return all_of(
        vanishes(series[i].as_expr() - stated.coeff_monomial(variable**i), f"{what}, order {i}")
        for i in range(length)
    )


@claim(
    "(2.11)",
    "α′ = t, α″ = n, α‴ = −kt, α⁗ = −k′t − kn, α⁽⁵⁾ = (k² − k″)t − 2k′n by affine arc length.",
    method=Method.PROOF,
    form="t, n, -k0*t, -k1*t - k0*n, (k0**2 - k2)*t - 2*k1*n",
    wrong=(
        "t, n, -k0*t, -k1*t - k0*n, (k0**2 - k2)*t - k1*n",
        "t, n, -k0*t, -k1*t - k0*n, (k0**2 + k2)*t - 2*k1*n",
        "t, n, -k0*t, k1*t - k0*n, (k0**2 - k2)*t - 2*k1*n",
        "t, n, -k0*t, -k1*t - k0*n, 0*t",
    ),
)
def higher_derivatives(form: str) -> Evidence:
    """The coefficients of the arc's series in its frame, from t′ = n, n′ = −kt, times factorials."""
    X, Y, k = affine_arc(ORDER, generators(ORDER))
    found = []
    for name, series, basis in (("t", X, {"t": 1, "n": 0}), ("n", Y, {"t": 0, "n": 1})):
        stated = read_tuple(form, names(k) | basis, 5)
        for i, value in enumerate(stated, start=1):
            derived = series[i].as_expr() * sp.factorial(i)
            found.append(vanishes(value - derived, f"derivative {i} along {name}"))
    return all_of(found)


@claim(
    "lemma 2.2.2.1",
    "α(r) − α(0) = (r − k₀r³/3! − k₀′r⁴/4! + O(r⁵)) t₀ + (r²/2 − k₀r⁴/4! − 2k₀′r⁵/5! + O(r⁶)) n₀.",
    method=Method.PROOF,
    form="r - k0*r**3/6 - k1*r**4/24, r**2/2 - k0*r**4/24 - 2*k1*r**5/120, 5, 6",
    printed="r - k0*r**3/6 - k1*r**4/24, r**2/2 - k0*r**4/24 - 2*k1*r**5/120, 6, 6",
    erratum="The remainder along t is O(r⁵), not O(r⁶): the coefficient of r⁵ is (k₀² − k₀″)/120.",
    wrong=(
        "r - k0*r**3/6 - k1*r**4/24, r**2/2 - k0*r**4/24 - k1*r**5/120, 5, 6",
        "r - k0*r**3/6 + k1*r**4/24, r**2/2 - k0*r**4/24 - 2*k1*r**5/120, 5, 6",
        "r - k0*r**3/6 - k1*r**4/24, r**2/2 - k0*r**4/24 - 2*k1*r**5/120, 5, 7",
    ),
)
def arc_in_its_frame(form: str) -> Evidence:
    """The series of the arc in its affine frame with generic k, k′, k″, … by (2.7), order by order.

    The form ends with the orders of both remainders.
    """
    X, Y, k = affine_arc(ORDER, generators(ORDER))
    r = sp.Symbol("r", real=True)
    along_t, along_n, first, second = read_tuple(form, names(k) | {"r": r}, 4)
    return truncated(X, along_t, r, order(first), "along t₀") & truncated(
        Y, along_n, r, order(second), "along n₀"
    )


@claim(
    "lemma 2.2.2.2",
    "In its affine frame the curve is the graph y(x) = x²/2 + k₀x⁴/8 + k₀′x⁵/40 + O(x⁶).",
    method=Method.PROOF,
    form="x**2/2 + k0*x**4/8 + k1*x**5/40, 6",
    wrong=(
        "x**2/2 + k0*x**4/24 + k1*x**5/40, 6",
        "x**2/2 + k0*x**4/8 + k1*x**5/120, 6",
        "x**2/2 + k0*x**4/8 + k1*x**5/40, 7",
    ),
)
def canonical_form(form: str) -> Evidence:
    """The arc's first coordinate is reverted, and r(x) put into the second."""
    graph, k = affine_graph(ORDER, generators(ORDER))
    variable = sp.Symbol("x", real=True)
    stated, last = read_tuple(form, names(k) | {"x": variable}, 2)
    return truncated(graph, stated, variable, order(last), "y(x)")


@claim(
    "section 2.2-1",
    "In the proof of Lemma 2.2.2, r = x + k₀x³/3! + k₀′x⁴/4! + O(x⁵).",
    method=Method.PROOF,
    form="x + k0*x**3/6 + k1*x**4/24, 5",
    printed="x + k0*x**3/6 + k1*x**4/24, 6",
    erratum="The remainder of the inverse is O(x⁵), not O(x⁶): the coefficient of x⁵ is (9k₀² + k₀″)/120.",
    wrong=("x - k0*x**3/6 + k1*x**4/24, 5", "x + k0*x**3/6 - k1*x**4/24, 5"),
)
def inverse_of_the_first_coordinate(form: str) -> Evidence:
    """The first coordinate x(r) of the arc in its frame, reverted. The form ends with the remainder's order.

    The graph y(x) of Lemma 2.2.2 stays right: y begins with r²/2, so an error O(x⁵) of r makes one O(x⁶).
    """
    X, _, k = affine_arc(ORDER, generators(ORDER))
    variable = sp.Symbol("x", real=True)
    stated, last = read_tuple(form, names(k) | {"x": variable}, 2)
    return truncated(X.reversion(), stated, variable, order(last), "r(x)")
