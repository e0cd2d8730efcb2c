"""Exact invariants of a plane curve given by formulas: simplified expressions, as text and as LaTeX.

The curve's derivatives and the forms of `osculant.cas.invariants` are computed in a differential field
(`osculant.cas.elementary`), so that what cancels is cancelled and what vanishes identically is seen to
vanish. Where a formula is beyond the field's caps, an invariant is given over the jet: in the symbols
x1 … x5, y1 … y5 of the coordinates' derivatives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from typing import Any, TypeAlias

import sympy
from sympy.printing.str import StrPrinter

from osculant.cas.antiderivatives import antiderivative
from osculant.cas.differential_field import Element
from osculant.cas.elementary import embed
from osculant.cas.errors import UndecidedError
from osculant.cas.expression import Node, to_sympy
from osculant.cas.field_forms import expression, root
from osculant.cas.invariants import INVARIANTS, Invariant, PlaneJet

ORDER = 5
#: operations of an expression beyond which the form over the jet says more
OPERATIONS = 400
#: arc lengths, which are integrals and so no part of a jet: the Invariant to print and the integrand's name
LENGTHS = (
    (Invariant("arc_length", "arc length", "s", "s", "everywhere"), "speed"),
    (Invariant("affine_arc_length", "affine arc length", "r", "r", "everywhere"), "affine_speed"),
)

Value: TypeAlias = "sympy.Expr | tuple[sympy.Expr, sympy.Expr] | None"


def jet_symbols() -> PlaneJet:
    """The generic jet, in sympy symbols x, x1 … x5, y, y1 … y5.

    >>> jet_symbols().inflection_form
    x1*y2 - x2*y1
    """
    x, y = (
        [sympy.Symbol(f"{letter}{order or ''}", real=True) for order in range(ORDER + 1)] for letter in "xy"
    )
    return PlaneJet(x, y)


class ExactInvariants(Mapping[str, Value]):
    r"""The invariants of the curve (x(t), y(t)) by name, in the order of `INVARIANTS`, then the arc lengths.

    Args:
        x, y: the coordinates' expressions.
        variable: name of the parameter.
        start, end: constants between which the arc lengths are taken; without them they are indefinite.

    Values are sympy expressions in the real symbol of the parameter, pairs for vectors, None for what does
    not exist anywhere (the affine invariants of a straight line). ``over_jets`` names the invariants that
    were too large to be written out and stand in the symbols x1 … y5 of the derivatives instead. The arc
    lengths are unevaluated integrals unless an antiderivative is evident.

    Raises DomainError for a formula that is nowhere defined.

    >>> from osculant.cas.formula import parse_tuple
    >>> sextic = ExactInvariants(*parse_tuple("4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)"))
    >>> print(sextic.text("curvature"), "|", sextic.text("arc_length"))
    1/(3*cos(t/3)**2) | 2*t + 3*sin(2*t/3)
    >>> print(sextic.latex("speed"))
    4 \cos^{2}{\left(\frac{t}{3} \right)}
    """

    def __init__(
        self, x: Node, y: Node, variable: str = "t", start: Node | None = None, end: Node | None = None
    ) -> None:
        self._values: dict[str, Value] = {}
        self.over_jets: frozenset[str] = frozenset()
        self._jet: PlaneJet | None = None
        self._derive(x, y, variable)
        symbol = sympy.Symbol(variable, real=True)
        bounds = None if start is None or end is None else (to_sympy(start), to_sympy(end))
        for length, speed in LENGTHS:
            over_jet = speed in self.over_jets
            self._values[length.name] = _integral(self._values[speed], symbol, bounds, over_jet)
            if over_jet:
                self.over_jets |= {length.name}

    def _derive(self, x: Node, y: Node, variable: str) -> None:
        generic = jet_symbols()
        swollen = set()
        with suppress(UndecidedError, RecursionError):
            self._jet = _jet(x, y, variable)
        for invariant in INVARIANTS:
            value = None
            try:
                if self._jet is None:
                    raise UndecidedError("The derivatives are too large to be written out.")
                value = _expressions(invariant.of(self._jet))
            except (UndecidedError, RecursionError):
                swollen.add(invariant.name)
                value = invariant.of(generic)
            self._values[invariant.name] = value
        self.over_jets = frozenset(swollen)

    def __getitem__(self, name: str) -> Value:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    @property
    def straight(self) -> bool | None:
        """Whether the curve lies on a line (D vanishes identically); None if undecided."""
        return self._vanishes("inflection_form")

    @property
    def parabola(self) -> bool | None:
        """Whether the curve is of parabolic arcs (k vanishes identically); None if undecided."""
        return self._curved_and("parabolic_form")

    @property
    def conic(self) -> bool | None:
        """Whether the curve is of conic arcs (dk/dr vanishes identically); None if undecided.

        One conic between points where the formula is smooth: t*abs(t) is of two.
        """
        return self._curved_and("sextactic_form")

    def _curved_and(self, form: str) -> bool | None:
        return False if self.straight else self._vanishes(form)

    def _vanishes(self, form: str) -> bool | None:
        """Whether a form of the jet is identically 0. True is proved by the field's relations."""
        if self._jet is None:
            return None
        try:
            return bool(getattr(self._jet, form) == 0)
        except UndecidedError:
            return None

    def text(self, name: str) -> str:
        """An invariant as text in the grammar of formulas (an integral as sympy writes it).

        Vectors are "(…, …)"; "undefined" stands for what does not exist.
        """
        return self._written(name, _text, "({}, {})")

    def latex(self, name: str) -> str:
        """An invariant as LaTeX, in the manner of `text`."""
        return self._written(name, sympy.latex, r"\left({}, {}\right)")

    def _written(self, name: str, write: Callable[[sympy.Expr], str], pair: str) -> str:
        value = self[name]
        if value is None:
            return "undefined"
        return pair.format(*map(write, value)) if isinstance(value, tuple) else write(value)


def _jet(x: Node, y: Node, variable: str) -> PlaneJet:
    """The jet of order 5 in the differential field of the formulas."""
    columns: list[list[Element]] = [[element] for element in embed((x, y), variable)]
    for column in columns:
        for _ in range(ORDER):
            column.append(column[-1].derivative())
    return PlaneJet(columns[0], columns[1], root)


def _expressions(value: Any) -> Value:
    """The expressions of elements; UndecidedError for what nobody would read."""
    if value is None:
        return None
    parts = tuple(expression(part) for part in (value if isinstance(value, tuple) else (value,)))
    if any(part.count_ops() > OPERATIONS for part in parts):
        raise UndecidedError(f"The invariant has more than {OPERATIONS} operations.")
    return (parts[0], parts[1]) if isinstance(value, tuple) else parts[0]


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
