"""The table of laws: entries against the derivations they name, and that it refuses doubles."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module

import pytest
import sympy as sp

from osculant.cas.asymptotics.bihelix_series import leading_constant
from osculant.cas.asymptotics.short_arcs import arc_error
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_constant, parse_tuple
from osculant.cas.formulas.sympy_bridge import to_sympy
from osculant.cas.invariants.values import jet_symbols
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.jets.space import SpaceJet
from osculant.cas.laws.arcs import arc_law
from osculant.cas.laws.law import METRICS, table
from osculant.cas.laws.table import LAWS, law_of
from osculant.cas.numbers.balls import PRECISION, constant, precision


@pytest.mark.parametrize("law", LAWS.values(), ids=lambda law: f"{law.primitive} {law.metric}")
def test_every_entry_is_complete(law):
    """A positive constant, a module that derives it, and an invariant of jets of the order it names."""
    assert LAWS[law.primitive, law.metric] is law and law.metric in METRICS
    assert law.exact() > 0
    with precision(100):
        assert abs(float(law.ball()) - float(law.exact())) <= 1e-15 * float(law.ball())
    assert import_module(law.source).__doc__
    assert 0 < law.spline_order <= law.order and set(law.spaces) <= {2, 3} and law.spaces
    if law.branch is not None:  # the least of several values: no closed form
        with precision(PRECISION):
            balls, at = CurveBalls(parse_tuple("t, exp(t)")), constant(parse_constant("1/2"))
            assert law.invariant(balls.jet(at, law.jet)) > 0
            assert law.branch(balls.jet(at, law.jet)) == law.branch(balls.jet(at, law.jet))
            with pytest.raises(DomainError, match=f"order {law.jet}"):
                law.invariant(balls.jet(at, law.jet - 1))
        return
    for space in law.spaces:
        jet_type, letters = {2: (PlaneJet, "xy"), 3: (SpaceJet, "xyz")}[space]
        found = sp.sympify(law.invariant(jet_symbols(jet_type, letters, law.jet)))
        numbers = {int(symbol.name[1:] or 0) for symbol in found.free_symbols}
        assert max(numbers) == law.jet and 0 not in numbers


def test_orders_are_those_derived():
    for primitive in ("parabola", "conic"):
        assert law_of(primitive).order == arc_error(primitive).order
    for metric in METRICS:
        law, derived = law_of("biarc", metric), arc_law("biarc", metric)
        assert (law.order, law.metric) == (derived.order, derived.metric)
        assert to_sympy(law.constant()) == derived.constant
    assert law_of("bihelix").constant().value == leading_constant()


def test_areas_have_one_order_more():
    """The displacement is integrated along the arc; so splines lose none."""
    for (primitive, metric), law in LAWS.items():
        assert law.dimension == (2 if metric == "area" else 1)
        if metric == "area":
            assert law.order == law_of(primitive).order + 1
            assert law.spline_order == law_of(primitive).order


def test_doubles_and_unknown_names_are_refused():
    law = law_of("conic")
    assert table([law, replace(law, metric="area")])
    with pytest.raises(DomainError, match="Two laws are for 'conic' and 'hausdorff'"):
        table([law, replace(law, order=7)])
    for unknown in (("quartic", "hausdorff"), ("conic", "l2"), ("bihelix", "area")):
        with pytest.raises(DomainError, match=r"No error law for .*: choose one of .*conic \(area\)"):
            law_of(*unknown)
