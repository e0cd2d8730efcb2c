"""Divided differences of a generic polynomial at symbolic nodes."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.numbers.division import newton_of_polynomial

x, u, xi, h = sp.symbols("x u xi h")
nodes = sp.symbols("x0:5")
#: degree of the polynomials with symbolic coefficients on which integral formulas are proved
DEGREE = 5
coefficients = sp.symbols(f"c0:{DEGREE + 1}")


def bracket(count: int, *more: Any) -> Any:
    """[x₀, …]f of the polynomial with symbolic coefficients, at that many nodes and some more."""
    return newton_of_polynomial(coefficients, (*nodes[:count], *more)).coefficients[-1]
