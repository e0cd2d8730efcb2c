"""The table of primitives: what splines can be made of, in the plane and in space."""

from __future__ import annotations

from collections.abc import Iterable

from osculant.cas.errors import DomainError
from osculant.primitives.biarc import BIARC
from osculant.primitives.bihelix import BIHELIX
from osculant.primitives.conic import CONIC, PARABOLA
from osculant.primitives.cubic import CUBIC
from osculant.primitives.polygon import POLYGON, SPACE_POLYGON
from osculant.primitives.primitive import METRICS, Fit, Primitive

__all__ = [
    "METRICS",
    "PRIMITIVES",
    "USUAL",
    "Fit",
    "Primitive",
    "candidates",
    "choose",
    "may_become",
    "register",
    "usual_first",
]

#: by dimension of the curves and name
PRIMITIVES: dict[int, dict[str, Primitive]] = {2: {}, 3: {}}
#: by dimension, what is taken if nothing is said
USUAL = {2: "conic", 3: "bihelix"}


def register(primitive: Primitive) -> None:
    """Enter a primitive into the table; raises ValueError if its name is taken in its dimension."""
    table = PRIMITIVES[primitive.dimension]
    if primitive.name in table:
        raise ValueError(f"The primitive {primitive.name!r} is twice in the table: choose another name.")
    table[primitive.name] = primitive


for _primitive in (PARABOLA, CONIC, BIARC, CUBIC, BIHELIX, POLYGON, SPACE_POLYGON):
    register(_primitive)


def choose(
    primitive: str, metric: str, rule: str | None = None, *, dimension: int = 2, curve: str = "the curve"
) -> Fit:
    """The fit for a primitive, a metric and a rule; the first rule if None.

    Args:
        primitive: its name.
        metric: one of `METRICS`.
        rule: one of the primitive's.
        dimension: of the curve, 2 or 3.
        curve: how messages call it.

    Raises DomainError for a name that is unknown, or of the other dimension, saying which there are.

    >>> choose("conic", "area") == choose("conic", "area", "equisymmetric")
    True
    """
    found = PRIMITIVES[dimension].get(primitive)
    if found is None:
        raise DomainError(_no_primitive(primitive, dimension, curve))
    metrics = [name for name in METRICS if found.rules(name)]
    if metric in METRICS and metric not in metrics and dimension == 3:
        raise DomainError(
            f"The metric {metric!r} is one of plane curves, and {curve} has three coordinates: "
            f"choose {_one_of(metrics)}, or leave out the third coordinate."
        )
    if metric not in metrics:
        raise DomainError(f"The metric {metric!r} is unknown: choose {_one_of(metrics)}.")
    rules = found.rules(metric)
    rule = rules[0] if rule is None else rule
    if rule not in rules and len(metrics) == 1:
        raise DomainError(f"The rule {rule!r} is unknown: choose {_one_of(rules)}.")
    if rule not in rules:
        raise DomainError(
            f"The rule {rule!r} is unknown for {primitive} and the metric {metric}: "
            f"choose {' or '.join(rules)}, or leave it out."
        )
    return Fit(found, metric, rule)


def _no_primitive(name: str, dimension: int, curve: str) -> str:
    """The sentence for a name that the table does not have in this dimension."""
    names = list(PRIMITIVES[dimension])
    usual = usual_first(dimension)
    choices = " or ".join(filter(None, [", ".join(usual[:-1]), usual[-1]]))
    if dimension == 3:
        return (
            f"A curve in space is approximated with {choices}, not {name!r}: "
            f"choose {choices}, or leave out the third coordinate."
        )
    if name in PRIMITIVES[3]:
        return (
            f"{PRIMITIVES[3][name].plural.capitalize()} approximate curves in space and {curve} has two "
            f"coordinates: choose {choices}, or add a third coordinate such as 0."
        )
    return f"The primitive {name!r} is unknown: choose {_one_of(names)} (or best, to approximate)."


def _one_of(names: Iterable[str]) -> str:
    names = list(names)
    return names[0] if len(names) == 1 else f"one of {', '.join(names)}"


def usual_first(dimension: int) -> list[str]:
    """The names of the primitives for curves of a dimension, first what is taken if nothing is said.

    >>> usual_first(2), usual_first(3)
    (['conic', 'parabola', 'biarc', 'cubic', 'polygon'], ['bihelix', 'polygon'])
    """
    usual = USUAL[dimension]
    return [usual, *(name for name in PRIMITIVES[dimension] if name != usual)]


def may_become(primitive: str | None) -> list[Primitive]:
    """The entries that a spline may be of if this is asked for: several for "best", in the plane.

    >>> [entry.name for entry in may_become("best")], [entry.dimension for entry in may_become("bihelix")]
    (['parabola', 'conic', 'biarc', 'cubic'], [3])
    """
    if primitive == "best":
        return [PRIMITIVES[2][name] for name in candidates(2)]
    return [table[primitive] for table in PRIMITIVES.values() if primitive in table]


def candidates(dimension: int) -> list[str]:
    """The primitives among which "best" chooses: those whose pieces meet with a common tangent.

    >>> candidates(2)
    ['parabola', 'conic', 'biarc', 'cubic']
    """
    return [name for name, primitive in PRIMITIVES[dimension].items() if primitive.smooth]
