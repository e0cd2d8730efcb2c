"""Germs read from even ones, and what is told of them as even germs again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from osculant.cas.formulas.expression import to_text, variable
from osculant.cas.formulas.graph import substitute

if TYPE_CHECKING:
    from osculant.cas.germs.groups import Group
    from osculant.germs.map_germ import MapGerm


def even_data(germ: MapGerm, group: Group, unfolding: MapGerm | None = None) -> dict[str, Any]:
    """What a germ is as an even one, as plain data.

    Args:
        germ: f, read from S(…, λ) = f(…, λ²).
        group: the group that acts on f.
        unfolding: a miniversal unfolding of f, if it is known.

    Returns ``variable`` λ, ``components`` and ``source`` of S, ``group``, such as "A^Z2" for A(H), and with
    an unfolding ``unfolding``: its components as an even germ.

    >>> from osculant.germs.map_germ import germ
    >>> f = germ("x, x*lam^2 + lam^6", "x lam", even="lam")
    >>> found = even_data(f, f.group(), f.unfolding().germ)
    >>> found["components"], found["group"], found["unfolding"]
    (['x', 'x*lam**2 + lam**6'], 'A^Z2', ['t1', 'x + t1*lam**2', 'x*lam**2 + lam**6'])
    """
    s, u = germ.even, germ.boundary
    assert s is not None and u is not None
    name = next(iter(set(s.source) - set(germ.source)), u)  # λ itself may be called u
    told: dict[str, Any] = {
        "variable": name,
        "components": list(map(to_text, s.components)),
        "source": list(s.source),
        "group": group.name.replace("(H)", "^Z2"),
    }
    if unfolding is not None:
        nodes = substitute(unfolding.exact.components, {u: variable(name) ** 2})
        told["unfolding"] = list(map(to_text, nodes))
    return told
