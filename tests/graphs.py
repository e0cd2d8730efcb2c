"""Random expression graphs in t, for hypothesis."""

from __future__ import annotations

from hypothesis import strategies as st

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas.expression import FUNCTIONS, Node, call, number, power, variable
from osculant.cas.formulas.parser import parse

t = variable("t")

rationals = st.fractions(-5, 5, max_denominator=8)
leaves = st.one_of(st.just(t), st.just(t), rationals.map(number), st.sampled_from([parse("pi"), parse("e")]))
exponents = st.one_of(st.integers(-3, 5), st.fractions(-2, 2, max_denominator=3)).map(number)


def built(rule, *args):
    """Return the node, or t where folding refuses it, as it does log(-1)."""
    try:
        return rule(*args)
    except (DomainError, FormulaError):
        return t


def grown(parts):
    binary = st.sampled_from([Node.__add__, Node.__sub__, Node.__mul__, Node.__truediv__])
    return st.one_of(
        st.builds(built, binary, parts, parts),
        st.builds(built, st.just(power), parts, exponents),
        st.builds(built, st.just(call), st.sampled_from(sorted(FUNCTIONS)), parts),
    )


formulas = st.recursive(leaves, grown, max_leaves=8)
