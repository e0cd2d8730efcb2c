"""Map-germs that depend on parameters, and their jets over ℚ or, for one parameter a, over ℚ[a]."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import prod
from typing import Any, cast

from flint import fmpq, fmpq_poly

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import to_text
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.polynomials import LARGEST, Number, Polynomial

#: a monomial in the source variables: its coefficient, by the exponents of the parameters
Coefficients = dict[int, dict[tuple[int, ...], Number]]


class Family:
    """Germs f_a with f_a(0) = 0 for all a, polynomial in the source variables and in the parameters.

    Args:
        components: the formulas of f₁, …, fₚ, separated by commas, as for `Germ`.
        source: the names of the source variables, separated by spaces.
        parameters: the names of the parameters, separated by spaces; at least one.
        boundary: as for `Germ`.

    Raises DomainError for a family that is not polynomial (of degree at most 63 in all its variables
    together), does not vanish at 0 for all parameters, or has names used twice; else the errors of `Germ`.

    >>> family = Family("x**4 + a*x**2*y**2 + y**4", "x y", "a")
    >>> family.at(a=6).text(4)
    ('x**4 + 6*x**2*y**2 + y**4',)
    """

    def __init__(
        self,
        components: str,
        source: str | Sequence[str],
        parameters: str | Sequence[str],
        boundary: str | None = None,
    ) -> None:
        self.source, self.parameters = _names(source), _names(parameters)
        if not self.parameters:
            raise DomainError("A family needs a parameter: name one, or use a Germ.")
        if shared := set(self.source) & set(self.parameters):
            raise DomainError(f"{sorted(shared)[0]!r} is a source variable and a parameter: rename one.")
        whole = Germ(components, (*self.source, *self.parameters))
        jet = whole.polynomial(LARGEST)
        if whole.field is not None:
            raise DomainError(f"The family {components!r} has irrational coefficients: give rational ones.")
        if jet is None:
            raise DomainError(
                f"The family {components!r} is not a polynomial of degree at most {LARGEST}: replace its "
                "functions by their Taylor polynomials."
            )
        self.boundary = boundary if boundary is not None or "u" not in self.source else "u"
        self.coefficients = tuple(self._split(f) for f in jet)
        for i, f in enumerate(self.coefficients, start=1):
            if 0 in f:
                raise DomainError(f"Component {i} of the family is not 0 at the origin for all parameters.")
        self._text = f"({', '.join(to_text(node) for node in whole.components)})"
        self.at(**dict.fromkeys(self.parameters, 0))  # its errors are those of the family

    def _split(self, f: Polynomial) -> Coefficients:
        n, names = len(self.source), len(self.source) + len(self.parameters)
        found: Coefficients = {}
        for m, c in f.items():
            exponents = poly.exponents_of(m, names)
            found.setdefault(poly.monomial(exponents[:n]), {})[exponents[n:]] = c
        return found

    def at(self, **values: int | Fraction | str) -> Germ:
        """The germ for rational values of all parameters.

        Raises DomainError for a name that is no parameter, a parameter without value, or a value that is no
        rational number.
        """
        at = self._values(values)
        missing = [name for name, value in zip(self.parameters, at) if value is None]
        if missing:
            raise DomainError(f"The parameter {missing[0]!r} has no value: give one, or use `restricted`.")
        numbers = [cast(Fraction, value) for value in at]
        components = []
        for f in self.coefficients:
            values_of = {m: sum(c * _power(numbers, e) for e, c in terms.items()) for m, terms in f.items()}
            components.append(as_node({m: c for m, c in values_of.items() if c}, self.source))
        return Germ(components, self.source, self.boundary)

    def restricted(self, **values: int | Fraction | str) -> Family:
        """The family of the other parameters, for rational values of some.

        >>> Family("x**3 + a*b*x", "x", "a b").restricted(b="1/2").at(a=4).text(3)
        ('x**3 + 2*x',)
        """
        at = self._values(values)
        kept = [i for i, value in enumerate(at) if value is None]
        if not kept:
            raise DomainError("No parameter is left: use `at`.")
        names = (*self.source, *(self.parameters[i] for i in kept))
        components = []
        for f in self.coefficients:
            total: Polynomial = {}
            for m, terms in f.items():
                for e, c in terms.items():
                    left = (*poly.exponents_of(m, len(self.source)), *(e[i] for i in kept))
                    value = c * prod((v**k for v, k in zip(at, e) if v is not None), start=Fraction(1))
                    total = poly.plus(total, {poly.monomial(left): value})
            components.append(to_text(as_node(total, names)))
        return Family(", ".join(components), self.source, names[len(self.source) :], self.boundary)

    def _values(self, values: dict[str, int | Fraction | str]) -> list[Fraction | None]:
        for name in values:
            if name not in self.parameters:
                raise DomainError(
                    f"{name!r} is no parameter of the family: it has {', '.join(self.parameters)}."
                )
        try:
            return [Fraction(values[name]) if name in values else None for name in self.parameters]
        except (ValueError, ZeroDivisionError, TypeError) as error:
            raise DomainError(f"A parameter has the value {error}, not a rational number.") from error

    def velocity(self, parameter: str, order: int, **values: int | Fraction | str) -> tuple[Polynomial, ...]:
        """∂f/∂a at rational values of all parameters, up to that degree.

        >>> Family("x**3 + a**2*x**4", "x", "a").velocity("a", 4, a=3) == ({poly.monomial((4,)): 6},)
        True
        """
        self.at(**values)  # checks the values
        numbers = [Fraction(values[name]) for name in self.parameters]
        i, n = self.parameters.index(parameter), len(self.source)
        found = []
        for f in self.coefficients:
            total: Polynomial = {}
            for m, terms in f.items():
                c = sum(
                    c * e[i] * _power(numbers, (*e[:i], e[i] - 1, *e[i + 1 :]))
                    for e, c in terms.items()
                    if e[i]
                )
                if c and poly.degree_of(m, n) <= order:
                    total[m] = c
            found.append(total)
        return tuple(found)

    def __str__(self) -> str:
        return self._text


class GenericGerm(Germ):
    """The member of a family of one parameter a for a indeterminate: its jets have coefficients in ℚ[a].

    For `vectors` of the tangent spaces, which only add and multiply coefficients.
    """

    def __init__(self, family: Family) -> None:
        if len(family.parameters) != 1:
            raise DomainError(
                f"The family has {len(family.parameters)} parameters: `restricted` to one is needed here."
            )
        self._jet = tuple(
            {m: _polynomial({e[0]: c for e, c in terms.items()}) for m, terms in f.items()}
            for f in family.coefficients
        )
        some = family.at(**{family.parameters[0]: 1})
        super().__init__(some.components, family.source, family.boundary)

    def jet(self, order: int) -> tuple[Polynomial, ...]:
        """The components up to that degree, with coefficients in ℚ[a]."""
        return tuple(poly.cut(f, self.n, order) for f in self._jet)

    def velocity(self, order: int) -> tuple[Polynomial, ...]:
        """∂f/∂a up to that degree, with coefficients in ℚ[a]."""
        rates = ({m: c.derivative() for m, c in f.items() if c.degree() > 0} for f in self._jet)
        return tuple(poly.cut(f, self.n, order) for f in rates)


def _names(names: str | Sequence[str]) -> tuple[str, ...]:
    return tuple(names.replace(",", " ").split() if isinstance(names, str) else names)


def _power(values: Sequence[Fraction], exponents: Sequence[int]) -> Fraction:
    return prod((v**e for v, e in zip(values, exponents)), start=Fraction(1))


def _polynomial(terms: dict[int, Number]) -> Any:
    dense = [Fraction(terms.get(i, 0)) for i in range(max(terms) + 1)]
    return fmpq_poly([fmpq(c.numerator, c.denominator) for c in dense])
