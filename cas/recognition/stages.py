"""The linear stages of the groups: how a germ is brought to where the reduction of its form starts.

A stage takes a germ that was not moved and a form, and gives one or several starts; the form is reached from
the first that can be reduced. A new stage is a line of `STAGES`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from osculant.cas.errors import UndecidedError
from osculant.cas.recognition.boundary_functions import boundary_starts
from osculant.cas.recognition.complete_intersections import intersection_starts
from osculant.cas.recognition.forms import Form
from osculant.cas.recognition.functions import function_starts
from osculant.cas.recognition.linear_maps import map_starts
from osculant.cas.recognition.moves import Moved
from osculant.cas.recognition.reduction import Start

Stage = Callable[[Moved, Form], Iterator[Start]]


def _contact_starts(moved: Moved, form: Form) -> Iterator[Start]:
    """Complete intersections, and simple functions, which are quasi-homogeneous: prepared as for R or R(H).

    Raises UndecidedError for functions with moduli.
    """
    if form.p > 1:
        return intersection_starts(moved, form)
    if form.moduli or form.entry.list == "unimodal functions":
        raise UndecidedError(f"No equivalences with {form} for {form.group.name} are built.")
    return function_starts(moved, form) if form.boundary is None else boundary_starts(moved, form)


#: by the name of the group
STAGES: dict[str, Stage] = {
    "A": map_starts,
    "A(H)": map_starts,
    "R": function_starts,
    "R(H)": boundary_starts,
    "K": _contact_starts,
    "K(H)": _contact_starts,
}


def starts(moved: Moved, form: Form) -> Iterator[Start]:
    """The starts of the reduction of a germ to a form.

    Raises UndecidedError for a group without a stage, NotEquivalent if the lowest terms are not those of the
    form.
    """
    if form.group.name not in STAGES:
        raise UndecidedError(f"No equivalences for the group {form.group.name} are built.")
    return STAGES[form.group.name](moved, form)
