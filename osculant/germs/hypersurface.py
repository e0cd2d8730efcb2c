"""Groups that preserve a user's hypersurface, at the front door."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError
from osculant.germs.reading import names_of

if TYPE_CHECKING:
    from osculant.cas.germs.groups import Group


def preserving(hypersurface: str, source: Any, group: str = "R", *, patience: float = 10.0) -> Group:
    """The group R(V), K(V) or A(V) of equivalences whose source changes preserve V = {h = 0}.

    Args:
        hypersurface: the formula of h, a polynomial that is 0 at the origin.
        source: the source variables, as for `osculant.germ`.
        group: "R", "K" or "A".
        patience: seconds that the vector fields tangent to V may take.

    Returns a group for `MapGerm`: its source fields are all that are tangent to V. Raises FormulaError for
    what is no formula, DomainError for another function or group, UndecidedError if time is over.

    >>> from osculant.germs.map_germ import germ
    >>> cusp = preserving("x^3 - y^2", "x y")
    >>> [germ(h, "x y").codimension(cusp, extended=True) for h in ("x + y", "y")]
    [1, 2]
    >>> cusp.fields
    ('2*y, 3*x**2', '2*x, 3*y')
    """
    from osculant.cas.germs.logarithmic import preserving as exact
    from osculant.cas.germs.search import Patience

    if not patience > 0:
        raise DomainError(f"patience: {patience} is no positive number of seconds.", argument="patience")
    return exact(group, hypersurface, names_of(source), Patience(patience))
