"""Vector fields that move a germ in a given direction: X·f = h modulo terms above an order, exactly."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError
from osculant.cas.germs.algebraic import Algebraic, exact
from osculant.cas.germs.groups import Version
from osculant.germs.reading import components_of

if TYPE_CHECKING:
    from osculant.cas.germs.solving import TangentField
    from osculant.germs.map_germ import GroupName, MapGerm

#: the fields of a group by the name of its version: from which order on they vanish at 0
VERSIONS = {"extended": Version.EXTENDED, "ordinary": Version.ORDINARY, "unipotent": Version.UNIPOTENT}
#: the highest order of jets
HIGHEST = 60


@dataclass(frozen=True)
class FieldTerm:
    """A vector field of a group with its coefficient.

    Attributes:
        coefficient: a Fraction, or a number of the germ's number field.
        side: "source" for x^α ξ, "target" for y^β ∂/∂y_j, "contact" for x^α f_i e_j.
        multiplier: the exponents α or β.
        field: the field as text, such as "x**2 ∂/∂x", "y1*y2 ∂/∂y1" or "x f1 e2".
    """

    coefficient: Any
    side: str
    multiplier: tuple[int, ...]
    field: str

    def __str__(self) -> str:
        c = self.coefficient
        shown = f"({c})" if isinstance(c, Algebraic) or c.denominator > 1 or c < 0 else str(c)
        return self.field if c == 1 else f"{shown} {self.field}"


@dataclass(frozen=True)
class Combination:
    """X = Σ cᵢXᵢ with X·f = h modulo terms above the ``order``; added up anew in exact arithmetic.

    >>> from osculant.germs.map_germ import germ
    >>> print(germ("x**3", "x").solve("x**4", order=6))
    (1/3) x**2 ∂/∂x
    """

    terms: tuple[FieldTerm, ...]
    order: int

    def __str__(self) -> str:
        return " + ".join(map(str, self.terms)) or "0"


def solve(
    germ: MapGerm, target: Any, order: int, group: GroupName = None, version: str = "ordinary"
) -> Combination | None:
    """A vector field X of a group with X·f = h in the jets of an order; None if there is none.

    For A, X is a pair of fields in source and target: X·f = df(ξ) + η(f). That there is none is proved by a
    functional that vanishes on the tangent space and not on h.

    Args:
        germ: f.
        target: h, as the formulas of `osculant.germ` are given, with as many components as f.
        order: terms of a higher degree do not count; at most 60.
        group: as for the methods of `MapGerm`.
        version: "ordinary" fields vanish at 0 (those of the group), "extended" ones need not, "unipotent"
            ones have no linear part.

    Raises DomainError for another number of components, a version or an order that is none, and the errors of
    `osculant.germ`.

    >>> from osculant.germs.map_germ import germ
    >>> whitney = germ("x, y**2, x*y", "x y")
    >>> print(solve(whitney, "0, 0, y**3", 3, "A"))
    y**2 ∂/∂x + (-1) y2 ∂/∂y1
    >>> solve(whitney, "0, 0, y", 3, "A") is None
    True
    """
    from osculant.cas.germs import solving

    if version not in VERSIONS:
        raise DomainError(f"version: {version!r} is none: choose one of {', '.join(VERSIONS)}.")
    if isinstance(order, bool) or not isinstance(order, int) or not 1 <= order <= HIGHEST:
        raise DomainError(f"order: {order!r} is no order of jets from 1 to {HIGHEST}.")
    f, acting = germ.exact, germ.group(group)
    nodes = components_of(target, germ.source, f.field)
    if len(nodes) != f.p:
        raise DomainError(f"The target has {len(nodes)} components, the germ {f.p}: give one for each.")
    wanted = f.expanded(nodes, order)
    found = solving.solve(f, acting, VERSIONS[version], order, wanted)
    if found is None:
        return None
    generators = [_field(c, germ) for c in acting.generators(f)]
    terms = [
        FieldTerm(exact(c), field.side, field.multiplier, _text(field, germ, generators))
        for field, c in found.items()
    ]
    return Combination(tuple(terms), order)


def _field(components: Sequence[Any], germ: MapGerm) -> str:
    """A generator of the source fields: ∂/∂x, u ∂/∂u, or its components."""
    from osculant.cas.germs.expansion import as_node

    nodes = [str(as_node(c, germ.source, germ.exact.field)) for c in components]
    moving = [i for i, text in enumerate(nodes) if text != "0"]
    if len(moving) != 1:
        return f"({', '.join(nodes)})"
    name, factor = germ.source[moving[0]], nodes[moving[0]]
    return f"∂/∂{name}" if factor == "1" else f"{factor} ∂/∂{name}"


def _text(field: TangentField, germ: MapGerm, generators: Sequence[str]) -> str:
    targets = [f"y{j + 1}" for j in range(germ.target)]
    names = targets if field.side == "target" else germ.source
    powers = [name if e == 1 else f"{name}**{e}" for name, e in zip(names, field.multiplier) if e]
    if isinstance(field.generator, tuple):
        i, j = field.generator
        kind = f"f{i + 1} e{j + 1}"
    else:
        kind = f"∂/∂{targets[field.generator]}" if field.side == "target" else generators[field.generator]
    return " ".join(filter(None, ["*".join(powers), kind]))
