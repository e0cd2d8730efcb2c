"""What splines can be made of: everything that the front door knows about a primitive, one entry each."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from osculant.cas.errors import DomainError
from osculant.cas.laws.law import Law
from osculant.cas.laws.table import law_of
from osculant.kernels import primitives as codes


@dataclass(frozen=True)
class Fit:
    """How the pieces are chosen from those tangent to the curve at both ends, and what their error is.

    Attributes:
        code: its number in the kernels.
        law: how the error of one short arc depends on its length: its order, and the error's dimension.
    """

    code: int
    law: Law

    @property
    def order(self) -> int:
        """The error of one short arc is of this order in its length."""
        return self.law.order

    @property
    def dimension(self) -> int:
        """1 if the error is a length, 2 if it is an area."""
        return self.law.dimension


@dataclass(frozen=True)
class Primitive:
    """A kind of pieces.

    Attributes:
        fits: by metric and rule; the first rule is the default.
        splits: the special points (`cas.zeros.plane.FORMS`) that split besides cusps and inflections.
        exact: the property of `osculant.cas.invariants.plane.ExactInvariants` that proves a curve to be one.
        turning: such a curve is cut into pieces that turn by less than this.
    """

    fits: Mapping[str, Mapping[str, Fit]]
    splits: str
    exact: str
    turning: float


PRIMITIVES = {
    "parabola": Primitive(
        {
            "hausdorff": {"bitangent": Fit(codes.PARABOLA, law_of("parabola"))},
            "area": {"bitangent": Fit(codes.AREA_PARABOLA, law_of("parabola", "area"))},
        },
        "parabolic",
        "parabola",
        math.pi,
    ),
    "conic": Primitive(
        {
            "hausdorff": {"equioscillating": Fit(codes.CONIC, law_of("conic"))},
            "area": {
                "equisymmetric": Fit(codes.EQUISYMMETRIC, law_of("conic", "area")),
                "minimal-area": Fit(codes.LEAST_AREA, law_of("conic", "area")),
            },
        },
        "sextactic",
        "conic",
        math.pi,
    ),
    "biarc": Primitive(
        {
            "hausdorff": {"equioscillating": Fit(codes.BIARC, law_of("biarc"))},
            "area": {"equisymmetric": Fit(codes.EQUISYMMETRIC_BIARC, law_of("biarc", "area"))},
        },
        "vertex",
        "circle",
        2 * math.pi,
    ),
}

#: the metrics, the default first
METRICS = ("hausdorff", "area")


def choose(primitive: str, metric: str, rule: str | None = None) -> Fit:
    """The fit for a primitive of the plane, a metric and a rule; the first rule if None.

    Raises DomainError for a name that is unknown, saying which there are.

    >>> choose("conic", "area") == choose("conic", "area", "equisymmetric")
    True
    """
    if primitive not in PRIMITIVES:
        raise DomainError(
            f"The primitive {primitive!r} is unknown: choose one of {', '.join(PRIMITIVES)} "
            "(or best, to approximate)."
        )
    if metric not in METRICS:
        raise DomainError(f"The metric {metric!r} is unknown: choose one of {', '.join(METRICS)}.")
    rules = PRIMITIVES[primitive].fits[metric]
    rule = first_rule(primitive, metric) if rule is None else rule
    if rule not in rules:
        raise DomainError(
            f"The rule {rule!r} is unknown for {primitive} and the metric {metric}: "
            f"choose {' or '.join(rules)}, or leave it out."
        )
    return rules[rule]


def first_rule(primitive: str, metric: str) -> str:
    """The rule of a primitive if none is asked for.

    >>> first_rule("conic", "area")
    'equisymmetric'
    """
    return next(iter(PRIMITIVES[primitive].fits[metric]))
