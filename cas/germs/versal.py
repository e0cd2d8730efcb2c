"""Whether a family of germs is a versal unfolding of its germ at parameter 0, exactly.

F(t, x) unfolds f = F(0, ·). It is versal for a group G exactly if θ = T G_e f + span(∂F/∂tᵢ at t = 0): one
rank, that of the functionals which vanish on T G_e f on the derivatives by the parameters.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import ZERO
from osculant.cas.formulas.graph import substitute
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, group
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.search import Patience
from osculant.cas.germs.tangent import Vector
from osculant.cas.germs.tangent_space import independent_columns


@dataclass(frozen=True)
class Versality:
    """Whether an unfolding is versal.

    Attributes:
        codimension: the extended codimension of the germ.
        reached: the rank of the parameters in θ modulo T G_e f; versal if that is the codimension.
        missing: terms (monomial, component) that make it versal if they are added.
    """

    codimension: int
    reached: int
    missing: tuple[tuple[int, int], ...]

    @property
    def versal(self) -> bool:
        """Whether nothing is missing."""
        return not self.missing


class Family:
    """A germ read as a family: some of its source variables are parameters.

    Args:
        whole: the family as a germ F(t, x) or (t, F(t, x)): components that are nothing but a parameter are
            left out if there is one for each.
        parameters: the names of the parameters among the source variables of ``whole``.

    Raises DomainError for parameters that are no source variables, are named twice, are the boundary or leave
    no source variable or no component.

    >>> family = Family(Germ("a, x**3 + a*x", "a x"), ["a"])
    >>> str(family.germ), family.germ.source
    ('(x**3)', ('x',))
    """

    def __init__(self, whole: Germ, parameters: Sequence[str]) -> None:
        self.parameters = tuple(parameters)
        _check_parameters(whole, self.parameters)
        names = set(self.parameters)
        bare = [f.kind == "variable" and f.value in names for f in whole.components]
        if sorted(f.value for f, b in zip(whole.components, bare) if b) != sorted(names):
            bare = [False] * whole.p
        moving = [f for f, b in zip(whole.components, bare) if not b]
        if not moving:
            raise DomainError("The unfolding has no components but its parameters: add those of the germ.")
        rest = [name for name in whole.source if name not in names]
        self.whole = Germ(moving, (*self.parameters, *rest), whole.boundary, whole.field)
        #: the germ at parameter 0
        at_zero = substitute(moving, dict.fromkeys(names, ZERO))
        self.germ = Germ(at_zero, rest, whole.boundary, whole.field)

    def velocities(self, order: int) -> list[Vector]:
        """∂F/∂tᵢ at t = 0 up to that degree, for every parameter.

        >>> Family(Germ("x**3 + a*x", "a x"), ["a"]).velocities(2) == [({poly.monomial((1,)): 1},)]
        True
        """
        jet, d, n = self.whole.jet(order + 1), len(self.parameters), self.whole.n
        found: list[list[poly.Polynomial]] = [[{} for _ in jet] for _ in range(d)]
        for j, f in enumerate(jet):
            for m, c in f.items():
                exponents = poly.exponents_of(m, n)
                if sum(exponents[:d]) == 1:
                    found[exponents.index(1)][j][poly.monomial(exponents[d:])] = c
        return [tuple(velocity) for velocity in found]


def versality(family: Family, name: str | Group, patience: Patience | None = None) -> Versality:
    """Whether a family is a versal unfolding for a group, decided exactly.

    Raises DomainError if the germ's codimension is infinite (no unfolding is versal then), UndecidedError if
    that is not settled.

    >>> cusp = Germ("x**4 + a*x**2", "x a")
    >>> found = versality(Family(cusp, ["a"]), "R")
    >>> found.versal, found.codimension, found.reached, len(found.missing)
    (False, 3, 1, 2)
    """
    g, germ = group(name), family.germ
    found = codimension(germ, g, extended=True, patience=patience)
    if found.tangent is None:
        raise DomainError(f"{germ} has no versal unfolding: its {g.name} codimension is infinite.")
    t = found.tangent
    space, functionals = t.space, t.annihilator.functionals
    place = space.place()
    conditions = []
    for velocity in family.velocities(max(t.plain_depth, 0)):
        if space.weights:
            velocity = tuple(poly.weighted(f, germ.n, space.weights) for f in velocity)
        row = space.row(tuple(poly.cut(f, germ.n, space.order) for f in velocity), place)
        conditions.append(
            [sum((v * row[c] for c, v in f.items() if c in row), Fraction(0)) for f in functionals]
        )
    left = null_space(conditions, len(functionals)) if functionals else []
    combined = []
    for combination in left:
        total: dict[int, Fraction] = {}
        for factor, functional in zip(combination, functionals):
            if factor:
                for c, v in functional.items():
                    total[c] = total.get(c, Fraction(0)) + factor * v
        combined.append({c: v for c, v in total.items() if v})
    missing = tuple(space.term(c) for c in independent_columns(combined))
    return Versality(len(functionals), len(functionals) - len(left), missing)


def _check_parameters(whole: Germ, parameters: Sequence[str]) -> None:
    if not parameters or len(set(parameters)) < len(parameters):
        raise DomainError(f"The parameters {' '.join(parameters)!r} must be one or more, all different.")
    for name in parameters:
        if name not in whole.source:
            raise DomainError(
                f"The parameter {name!r} is not a source variable: choose among {', '.join(whole.source)}."
            )
        if name == whole.boundary:
            raise DomainError(f"The boundary variable {name!r} is no parameter: choose another one.")
    if len(parameters) == whole.n:
        raise DomainError("Every source variable is a parameter: leave at least one that is none.")
