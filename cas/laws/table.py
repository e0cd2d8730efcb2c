"""The one table of laws: what is known of the error of a short arc, for every primitive and metric.

The order of an error, its dimension, its constant and its density stand here and nowhere else: the predicted
number of pieces integrates the density, the front door plans with the order, and `osculant.codegen` prints
both for the kernels. A new primitive's law is one more entry, in a file of its family.
"""

from __future__ import annotations

from osculant.cas.errors import DomainError
from osculant.cas.laws import biarcs, bihelices, conics, cubics, polygons
from osculant.cas.laws.law import Law, table

#: by primitive and metric
LAWS = table((*conics.LAWS, *biarcs.LAWS, *bihelices.LAWS, *polygons.LAWS, *cubics.LAWS))


def law_of(primitive: str, metric: str = "hausdorff") -> Law:
    """The law of a primitive in a metric.

    Raises DomainError if there is none, saying which there are.

    >>> law_of("conic").order, law_of("conic", "area").order, law_of("conic", "area").dimension
    (5, 6, 2)
    """
    if (primitive, metric) not in LAWS:
        known = ", ".join(f"{name} ({metric})" for name, metric in LAWS)
        raise DomainError(f"No error law for {primitive!r} and {metric!r}: choose one of {known}.")
    return LAWS[primitive, metric]
