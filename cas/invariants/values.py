"""Exact invariants of a curve given by formulas: simplified expressions, as text and as LaTeX.

The curve's derivatives and the forms over its jets are computed in a differential field
(`osculant.cas.invariants.elementary`), so that what cancels is cancelled and what vanishes identically is
seen to vanish. Where a formula is beyond the field's caps, an invariant is given over the jet: in the symbols
x1, x2 …, y1 … of the coordinates' derivatives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any, ClassVar, Generic, TypeAlias, TypeVar

import sympy
from sympy.printing.str import StrPrinter

from osculant.cas.errors import UndecidedError
from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.sympy_bridge import to_sympy
from osculant.cas.invariants.antiderivatives import antiderivative
from osculant.cas.invariants.differential_field import Element
from osculant.cas.invariants.elementary import embed
from osculant.cas.invariants.field_forms import expression, root
from osculant.cas.jets.jet import Invariant, Jet

#: operations of an expression beyond which the form over the jet says more
OPERATIONS = 400

#: a number, a vector, a frame of vectors; None where it does not exist
Value: TypeAlias = Any
JetType = TypeVar("JetType", bound=Jet)


def jet_symbols(jet_type: Callable[..., JetType], letters: str, order: int) -> JetType:
    """The generic jet, in real sympy symbols x, x1, x2 …, y, y1 ….

    >>> from osculant.cas.jets.plane import PlaneJet
    >>> jet_symbols(PlaneJet, "xy", 2).inflection_form
    x1*y2 - x2*y1
    """
    return jet_type(
        *([sympy.Symbol(f"{letter}{i or ''}", real=True) for i in range(order + 1)] for letter in letters)
    )


class ExactValues(Mapping[str, Value], Generic[JetType]):
    """The invariants of a curve by name, then its arc lengths; subclasses are for the plane and for space.

    Args:
        coordinates: the formulas, one for each dimension.
        variable: name of the parameter.
        ends: constants between which the arc lengths are taken; without them they are indefinite.

    Values are sympy expressions in the real symbol of the parameter, tuples for vectors, tuples of them for
    frames, None for what does not exist anywhere. ``over_jets`` names the invariants that were too large to
    be written out and stand in the symbols x1, y1 … of the derivatives instead. Arc lengths are unevaluated
    integrals unless an antiderivative is evident.

    Raises DomainError for a formula that is nowhere defined.
    """

    #: makes a jet of one sequence of derivatives per coordinate, and of a root
    jet_type: Callable[..., JetType]
    #: derivatives that the invariants need
    order: ClassVar[int]
    #: what is computed from a jet
    invariants: ClassVar[Sequence[Invariant]]
    #: integrals over the parameter, each as it is called and the name of its integrand
    lengths: ClassVar[Sequence[tuple[Invariant, str]]]

    def __init__(
        self, *coordinates: Node, variable: str = "t", ends: tuple[Node, Node] | None = None
    ) -> None:
        self._values: dict[str, Value] = {}
        self._jet: JetType | None = None
        with suppress(UndecidedError, RecursionError):
            self._jet = _field_jet(coordinates, self.jet_type, self.order, variable)
        generic = jet_symbols(self.jet_type, "xyz"[: len(coordinates)], self.order)
        swollen = set()
        for invariant in self.invariants:
            try:
                if self._jet is None:
                    raise UndecidedError("The derivatives are too large to be written out.")
                value = mapped(_expression, invariant.of(self._jet))
            except (UndecidedError, RecursionError):
                swollen.add(invariant.name)
                value = invariant.of(generic)
            self._values[invariant.name] = value
        symbol = sympy.Symbol(variable, real=True)
        bounds = None if ends is None else (to_sympy(ends[0]), to_sympy(ends[1]))
        for length, speed in self.lengths:
            self._values[length.name] = _integral(self._values[speed], symbol, bounds, speed in swollen)
            if speed in swollen:
                swollen.add(length.name)
        self.over_jets = frozenset(swollen)

    def __getitem__(self, name: str) -> Value:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def vanishes(self, form: str) -> bool | None:
        """Whether a form of the jet is identically 0; None if undecided. True is proved by the relations."""
        if self._jet is None:
            return None
        try:
            return bool(getattr(self._jet, form) == 0)
        except (UndecidedError, RecursionError):
            return None

    @property
    def straight(self) -> bool | None:
        """Whether the curve lies on a line; None if undecided."""
        return self.vanishes("inflection_form")

    def text(self, name: str) -> str:
        """An invariant as text in the grammar of formulas (an integral as sympy writes it).

        Vectors are "(…, …)"; "undefined" stands for what does not exist.
        """
        return _written(self[name], _text, "({})")

    def latex(self, name: str) -> str:
        """An invariant as LaTeX, in the manner of `text`."""
        return _written(self[name], sympy.latex, r"\left({}\right)")


def _field_jet(
    coordinates: Sequence[Node], jet_type: Callable[..., JetType], order: int, variable: str
) -> JetType:
    """The jet in the differential field of the formulas."""
    columns = [[element] for element in embed(coordinates, variable)]
    for column in columns:
        for _ in range(order):
            column.append(column[-1].derivative())
    return jet_type(*columns, root)


def mapped(function: Callable[[Any], Any], value: Any) -> Any:
    """A value, or a vector or frame of them, with a function applied to every number; None stays None.

    >>> mapped(abs, ((-1, 2), None))
    ((1, 2), None)
    """
    if isinstance(value, tuple):
        return tuple(mapped(function, part) for part in value)
    return None if value is None else function(value)


def _expression(element: Element) -> sympy.Expr:
    """The expression of an element; UndecidedError for what nobody would read."""
    found = expression(element)
    if found.count_ops() > OPERATIONS:
        raise UndecidedError(f"The invariant has more than {OPERATIONS} operations.")
    return found


def _written(value: Value, write: Callable[[sympy.Expr], str], vector: str) -> str:
    if value is None:
        return "undefined"
    if isinstance(value, tuple):
        return vector.format(", ".join(_written(part, write, vector) for part in value))
    return write(value)


def _integral(
    speed: Value, t: sympy.Symbol, bounds: tuple[sympy.Expr, sympy.Expr] | None, over_jet: bool
) -> sympy.Expr:
    primitive = None if over_jet else antiderivative(speed, t)
    if primitive is None:
        return sympy.Integral(speed, t if bounds is None else (t, *bounds))
    return primitive if bounds is None else primitive.subs(t, bounds[1]) - primitive.subs(t, bounds[0])


class _FormulaPrinter(StrPrinter):  # type: ignore[misc]  # sympy is untyped
    """sympy's text, with the names that formulas have here."""

    def _print_Abs(self, e: sympy.Expr) -> str:
        return f"abs({self._print(e.args[0])})"

    def _print_Exp1(self, _e: sympy.Expr) -> str:
        return "e"


_text = _FormulaPrinter().doprint
