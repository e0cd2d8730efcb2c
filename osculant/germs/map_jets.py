"""Jets of maps that keep the origin: composition, inverses, flows of vector fields, exactly over ℚ."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import to_text
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.jets_of_maps import MapJet
from osculant.cas.germs.jets_of_maps import map_jet as exact_jet
from osculant.germs.reading import components_of, names_of

#: the highest order of a jet
HIGHEST = 200


def map_jet(formulas: Any, source: Any, order: int) -> JetOfMap:
    """The jet of a map that keeps the origin, or of a vector field that vanishes there, in these coordinates.

    Args:
        formulas: the components, as for `osculant.germ`; analytic ones are expanded.
        source: the names of the variables, as for `osculant.germ`.
        order: terms of a higher degree do not count; from 1 to 200.

    Raises DomainError for an order that is none and for coefficients that are not rational, and the errors of
    `osculant.germ`.

    >>> shear = map_jet("x + y**2, y", "x y", 3)
    >>> shear.inverse().components
    ('x - y**2', 'y')
    >>> field = map_jet("y**2, 0", "x y", 3)
    >>> field.flow(map_jet("x, y", "x y", 3)) == shear
    True
    """
    if isinstance(order, bool) or not isinstance(order, int) or not 1 <= order <= HIGHEST:
        raise DomainError(f"order: {order!r} is no order of jets from 1 to {HIGHEST}.")
    names = names_of(source)
    f = Germ(components_of(formulas, names), names, None)
    if f.field is not None:
        raise DomainError(f"The jet of {f} has irrational coefficients: jets of maps have rational ones.")
    return JetOfMap(exact_jet(f.jet(order), f.n, order), names)


@dataclass(frozen=True)
class JetOfMap:
    """The jet of a map; `map_jet` makes it.

    Attributes:
        exact: the jet as the exact room `osculant.cas.germs` has it.
        source: the names of the variables.
    """

    exact: MapJet
    source: tuple[str, ...]

    @property
    def order(self) -> int:
        """Up to which degree the terms are known."""
        return self.exact.order

    @property
    def components(self) -> tuple[str, ...]:
        """The components as formulas.

        >>> map_jet("sin(x)", "x", 4).components
        ('x - 1/6*x**3',)
        """
        return tuple(to_text(as_node(_sorted(f), self.source)) for f in self.exact.polynomials())

    def compose(self, inner: JetOfMap) -> JetOfMap:
        """This map after another one; its variables are those of the other.

        Raises DomainError if dimensions or orders do not fit.

        >>> map_jet("x**2", "x", 4).compose(map_jet("s + s*t", "s t", 4)).components
        ('s**2 + 2*(s**2*t) + s**2*t**2',)
        """
        return JetOfMap(self.exact.compose(inner.exact), inner.source)

    def inverse(self) -> JetOfMap:
        """The inverse map, in the same names; DomainError if the derivative at 0 is not invertible.

        >>> map_jet("tan(x)", "x", 5).inverse() == map_jet("atan(x)", "x", 5)
        True
        """
        return JetOfMap(self.exact.inverse(), self.source)

    def flow(self, f: JetOfMap) -> JetOfMap:
        """f after the flow at time 1 of this jet, read as a vector field.

        Its linear part must be nilpotent, since the flow is not rational else: DomainError, as for other
        dimensions, orders or names.

        >>> map_jet("x**2", "x", 4).flow(map_jet("x", "x", 4)).components  # x/(1 - x)
        ('x + x**2 + x**3 + x**4',)
        """
        if f.source != self.source:
            raise DomainError(
                f"A field in {' '.join(self.source)} does not move a map of {' '.join(f.source)}: use the "
                "same names in the same order."
            )
        return JetOfMap(self.exact.flow(f.exact), self.source)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, JetOfMap)
            and (self.source, self.order) == (other.source, other.order)
            and self.exact.polynomials() == other.exact.polynomials()
        )

    def __hash__(self) -> int:
        return hash((self.source, self.order, self.components))

    def __repr__(self) -> str:
        return f"<JetOfMap {', '.join(self.components)} in {' '.join(self.source)} to order {self.order}>"


def _sorted(f: dict[int, Any]) -> dict[int, Any]:
    """The terms by degree, and as in a dictionary within one."""
    return dict(sorted(f.items(), key=lambda term: term[0]))
