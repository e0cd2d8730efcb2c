"""Forms over a curve's jets as products: their factors are formulas in which everything has cancelled."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import sympy

from osculant.cas.errors import OsculantError
from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.sympy_bridge import from_sympy
from osculant.cas.invariants.differential_field import Field
from osculant.cas.invariants.field_forms import _factors, _is_positive, _plain
from osculant.cas.invariants.values import _field_jet

#: operations of a factor beyond which the form over balls is no worse
OPERATIONS = 120


def factored(
    coordinates: Sequence[Node], jet_type: Callable[..., Any], order: int, form: str, variable: str = "t"
) -> tuple[list[Node], list[Node]] | None:
    """Factors above and below the line of a form, but for those that are evidently positive.

    The form vanishes exactly where one of the first does, as long as none of the second does.  None where the
    formula is beyond the differential field, or has abs in it, or the factors are too large.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> from osculant.cas.jets.plane import PlaneJet
    >>> above, below = factored(parse_tuple("t*cos(t), t*sin(t)"), PlaneJet, 5, "sextactic_form")
    >>> [str(factor) for factor in above], below
    (['t'], [])
    """
    try:
        element = getattr(_field_jet(coordinates, jet_type, order, variable), form)
        above, below = (_formulas(element.field, part) for part in (element.above, element.below))
    except (OsculantError, RecursionError, ZeroDivisionError):
        return None
    return None if above is None or below is None else (above, below)


def _formulas(field: Field, polynomial: Any) -> list[Node] | None:
    """The factors of a polynomial that may vanish; None if one is not for balls."""
    found = []
    for factor, _ in _factors(field, polynomial)[1]:
        if _is_positive(field, factor):
            continue
        written = _plain(field, factor)
        if written.has(sympy.Abs, sympy.sign) or written.count_ops() > OPERATIONS:
            return None
        found.append(from_sympy(written))
    return found
