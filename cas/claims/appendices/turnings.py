"""Functions of an angle of turning whose signs appendix B decides."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence
from osculant.cas.claims.proof import read
from osculant.cas.numbers.signs import sign_between

phi = sp.Symbol("phi", real=True)
#: H' = (1 + t₀) sin(φ/2)(t₀K₀ + K₁)/(2D²R)
K0 = "4 - phi**2 - 4*cos(phi) - phi*sin(phi)"
K1 = "-1 + cos(2*phi) + phi*sin(phi) + phi**2*cos(phi)"


def of_turning(form: str) -> Any:
    """The form as a function of φ."""
    return read(form, {"phi": phi})


def negative(function: Any, low: Any, high: Any, what: str) -> Evidence:
    """Proof in balls that a function of φ is negative between two numbers."""
    sign = sign_between(function, phi, sp.sympify(low), sp.sympify(high))
    return Evidence(sign == -1, (f"sign of {what} on ({low}, {high}), in balls: {sign}",))
