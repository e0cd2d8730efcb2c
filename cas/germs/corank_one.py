"""A germ of corank 1 as (x, g(x, y)) with polynomials g, for invariants of A-equivalence.

Where `normal_form` has no polynomial change, the jet that determines the germ is taken: it is equivalent to
the germ, in coordinates that are power series, and these may be cut above its order again.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.model import Model
from osculant.cas.germs.model_reading import model_of
from osculant.cas.germs.normal_form import normal_form, truncated_form
from osculant.cas.germs.schemes import divided_differences, expected
from osculant.cas.germs.search import Patience


@dataclass(frozen=True)
class CorankOne:
    """(x₁, …, x_{n−1}, g(x, y)): the names of x, y and the functions g in their ring."""

    names: tuple[str, ...]
    p: int
    functions: tuple[Any, ...]

    @property
    def n(self) -> int:
        """The source dimension."""
        return len(self.names)

    def scheme(self, parts: tuple[int, ...]) -> tuple[Any, list[Any]]:
        """(ring, equations) of the multiple points of that type, by divided differences.

        >>> form = corank_one(Germ("x, x*y + y**3", "x y"))
        >>> [str(f) for f in form.scheme((3,))[1]]
        ['3*y1^2 + x', '3*y1']
        """
        one = self.functions[0].context().constant(1)
        return divided_differences([(g, one) for g in self.functions], self.names, parts)

    def expected(self, parts: tuple[int, ...]) -> int:
        """The dimension that the multiple points of that type have for a stable germ."""
        return expected(self.n, self.p, parts)


def corank_one(germ: Germ, patience: Patience | None = None) -> CorankOne:
    """The normal form of a germ of rank n − 1, n ≤ p.

    Raises DomainError for another rank or n > p; UndecidedError for a germ that has no polynomial normal form
    and is not finitely determined, or whose determinacy is not decided in time.

    >>> [str(g) for g in corank_one(Germ("sin(x), x*y + y**3", "x y")).functions]
    ['y^3 + x*y']
    """
    n, p = germ.n, germ.p
    if germ.rank != n - 1 or n > p:
        raise DomainError(f"{germ} is no germ of corank 1 with n ≤ p: its rank is {germ.rank}.")
    if germ.polynomial(poly.LARGEST) is not None:
        model = model_of(germ)
        assert model is not None
        found = normal_form(model)
        if found is not None and all(b.is_constant() for _, b in found.functions):
            functions = tuple(a / b.leading_coefficient() for a, b in found.functions)
            return CorankOne(model.context.names(), p, functions)
    degree = determinacy(germ, "A", patience).degree
    if degree == "infinite":
        raise UndecidedError(
            f"{germ} is not finitely determined, and has no normal form of polynomials here."
        )
    jet = model_of(germ.truncated(degree))
    assert isinstance(jet, Model)
    return CorankOne(jet.context.names(), p, truncated_form(jet, degree))
