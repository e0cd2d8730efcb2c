"""Families of germs at the front door: the codimension by the values of parameters."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import expanded
from osculant.cas.germs.groups import Group
from osculant.cas.germs.groups import group as group_of
from osculant.germs.reading import names_of, text_of

if TYPE_CHECKING:
    from osculant.cas.germs.family import Family
    from osculant.cas.germs.strata import Stratification, Stratum


def germ_family(
    formulas: Any, source: Any, parameters: Any, boundary: Any = None, *, patience: float = 10.0
) -> GermFamily:
    """A family of germs that depends on parameters, polynomial in them and in the source variables.

    Args:
        formulas: text such as ``"x, x*y + y^3, x*y^2 + c*y^4"``, a `pathlib.Path` of a file with such text,
            or a sequence of texts, one a component.
        source: the source variables, as for `osculant.germ`.
        parameters: the parameters, in the same way.
        boundary: as for `osculant.germ`.
        patience: seconds of processor time for a question.

    Raises FormulaError for text that is no formula, DomainError for a family that is not polynomial or does
    not vanish at 0 for all parameters, for names used twice, for none, and for a patience that is not
    positive.

    >>> found = germ_family("x, x*y + y^3, x*y^2 + c*y^4", "x y", "c").codimension(extended=True)
    >>> found.value, [s.conditions[0] for s in found.exceptional]
    (4, ['2*c - 3', 'c - 1', '2*c - 1', 'c'])
    """
    from osculant.cas.germs.family import Family

    if not patience > 0:
        raise DomainError(f"patience: {patience} is no positive number of seconds.", argument="patience")
    if isinstance(formulas, Path):
        formulas = text_of(formulas)
    text = formulas if isinstance(formulas, str) else ", ".join(map(str, formulas))
    u = None if boundary is None else str(boundary)
    return GermFamily(Family(text, names_of(source), names_of(parameters), u), patience)


class GermFamily:
    """A family; `germ_family` makes it.

    Attributes:
        exact: the family as the exact room has it.
        source: the names of the source variables.
        parameters: the names of the parameters.
        seconds: of processor time for one question.

    >>> germ_family("x^3 + a*x*y^2 + b*y^3", "x y", "a b").parameters
    ('a', 'b')
    """

    def __init__(self, exact: Family, patience: float = 10.0) -> None:
        self.exact, self.seconds = exact, patience
        self.source, self.parameters = exact.source, exact.parameters

    def group(self, name: str | Group | None = None) -> Group:
        """The group of that name; by default A, for functions R, with (H) if there is a boundary variable.

        >>> germ_family("a*x^2", "x", "a").group().name
        'R'
        """
        if name is None:
            name = "R" if len(self.exact.coefficients) == 1 else "A"
            name += "" if self.exact.boundary is None else "(H)"
        return group_of(name)

    def codimension(self, group: str | Group | None = None, *, extended: bool = False) -> Stratification:
        """The codimension of general members, and all strata of parameters where it is or may be larger.

        Strata are complete over ℂ: off them the codimension is ``value``. UndecidedError if that is not
        found.

        >>> print(germ_family("x^3 + a*x*y^2 + b*y^3", "x y", "a b").codimension(extended=True))
        4; 4*a**3 + 27*b**2 = 0: infinite; a = 0, b = 0: infinite
        """
        from osculant.cas.germs.search import Patience
        from osculant.cas.germs.strata import stratification

        return stratification(self.exact, self.group(group), extended, Patience(self.seconds))

    def report(self, group: str | Group | None = None) -> dict[str, Any]:
        """The codimensions of the members as plain data.

        Keys: ``source``, ``parameters``, ``components`` (text), ``boundary``, ``group``; ``codimension`` and
        ``extended_codimension``, of general members; ``exceptional`` and ``extended_exceptional``: a list of
        strata, each with ``conditions`` (formulas that are 0), ``codimension`` (null if it is not known),
        ``at_least``, ``real`` (how many real points, "infinite", or null if not known) and ``values`` (of
        the parameters that the first conditions fix). null with ``reason`` and ``undecided`` where there is
        no answer.

        >>> germ_family("a*x^2 + x^3", "x", "a").report()["exceptional"]
        [{'conditions': ['a'], 'codimension': 2, 'at_least': 2, 'real': 1, 'values': {'a': '0'}}]
        """
        acting = self.group(group)
        data: dict[str, Any] = {
            "source": list(self.source),
            "parameters": list(self.parameters),
            "components": str(self.exact)[1:-1],
            "boundary": self.exact.boundary,
            "group": acting.name,
        }
        reasons: dict[str, str] = {}
        undecided: list[str] = []
        for prefix, extended in (("", False), ("extended_", True)):
            keys = f"{prefix}codimension", f"{prefix}exceptional"
            try:
                found = self.codimension(acting, extended=extended)
                data |= dict(zip(keys, (found.value, [self._told(s) for s in found.exceptional])))
            except UndecidedError as error:
                data |= dict.fromkeys(keys)
                reasons |= dict.fromkeys(keys, str(error))
                undecided += keys
        return {**data, "reason": reasons, "undecided": undecided}

    def _told(self, stratum: Stratum) -> dict[str, Any]:
        fixed = {c: found for c in stratum.conditions if (found := self._value(c)) is not None}
        conditions = [*fixed, *(c for c in stratum.conditions if c not in fixed)]
        return {**vars(stratum), "conditions": conditions, "values": dict(fixed.values())}

    def _value(self, condition: str) -> tuple[str, str] | None:
        """(parameter, its value) for a condition that is linear in a parameter alone."""
        (f,) = expanded(parse_tuple(condition, self.parameters), self.parameters, poly.LARGEST)
        (first, *rest), m = [term for term in f if term], len(self.parameters)
        if rest or poly.degree_of(first, m) != 1:
            return None
        name = self.parameters[poly.exponents_of(first, m).index(1)]
        return name, str(Fraction(-f.get(0, 0)) / f[first])

    def __repr__(self) -> str:
        return f"<GermFamily {str(self.exact)[1:-1]} with {' '.join(self.parameters)}>"
