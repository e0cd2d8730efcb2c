"""The class of a germ from its formulas, at the front door: `recognise`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from osculant.germs.map_germ import GroupName, germ

if TYPE_CHECKING:
    from osculant.germs.recognition import Recognised


def recognise(
    formulas: Any,
    source: Any,
    boundary: Any = None,
    *,
    group: GroupName = None,
    tolerance: float | None = None,
    **options: Any,
) -> Recognised:
    """The class of a germ in the lists of the literature.

    Args:
        formulas: the components, as for `osculant.germ`.
        source: the source variables in order.
        boundary: the variable u of H = {u = 0}, if there is one; by default the variable called ``u``.
        group: of the equivalences; by default A, for a function R, with (H) if there is a boundary variable.
        tolerance: to which coefficients that are not integers are known. Then the germ nearby with the
            simplest fractions is recognised, and ranks must be the same for all germs within the tolerance,
            with a margin (`osculant.germs.rounded`); else it is undecided.
        **options: ``at``, ``patience``, ``root`` and ``even`` of `osculant.germ`.

    Errors are those of `osculant.germ`; DomainError too for a group that does not exist, and for an (H) group
    without a boundary variable. What is not decided in time is told to be undecided.

    >>> found = recognise("x, y^2 + x*y, y^3 - 2*x^2*y + x^4", "x y")
    >>> found.name, found.complex, found.table, found.codimension
    ('S1-', 'S1', 'mond', 3)
    >>> recognise("x1, x2, x3^2 + x1*u + x2*u^2 - u^3", "x1 x2 x3 u").name
    '3g-'
    >>> found = recognise("x, y^3", "x y")
    >>> found.name, found.undecided, found.codimension
    (None, False, 'infinite')
    >>> recognise("0.3333333333*x^3 + 0.7142857143*x*y^2", "x y", tolerance=1e-8).name
    'D4+'
    """
    return germ(formulas, source, boundary, **options).recognise(group, tolerance)
