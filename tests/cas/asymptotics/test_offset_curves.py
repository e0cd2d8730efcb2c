"""Curves beside a curve: places of contact with names of their own."""

from __future__ import annotations

import pytest

from osculant.cas.asymptotics.offset_curves import OffsetCurve, both_ends
from osculant.cas.errors import DomainError


@pytest.mark.parametrize("name", ["u", "k0", "k5", "P0", "Q0", "Pu", "Qrho", ""])
def test_names_of_symbols_are_taken(name):
    with pytest.raises(DomainError, match=f"cannot be called '{name}'"):
        both_ends((name,))


def test_other_names_make_no_difference():
    curves = [both_ends((name,), terms=1) for name in ("sigma", "k", "kappa0", "P")]
    values = [curve.expression(curve.affine_curvature[0]) for curve in curves]
    first, *others = curves[0].symbols
    assert first == "u" and len(others) == len(curves[1].symbols) - 1
    for curve, name, value in zip(curves, ("sigma", "k", "kappa0", "P"), values):
        assert value.subs(curve.symbols[name], curves[0].symbols["sigma"]).expand() == values[0].expand()


def test_too_few_contacts():
    with pytest.raises(DomainError, match="at least four contacts"):
        OffsetCurve(("0", "0", "rho"))
    with pytest.raises(DomainError, match="one order"):
        OffsetCurve(("0", "0", "rho", "rho"), terms=0)
