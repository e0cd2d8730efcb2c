"""Finite determinacy: the least degree k proved, the unipotent group that proves it, and whether it is sharp.

Criterion (du Plessis; Bruce, du Plessis and Wall): if M^lθ ⊂ T K_e f and M^{k+1}θ ⊂ T U f + M^{k+l+1}θ for a
unipotent subgroup U of G, then f is k-determined for G. For R, C and K, whose tangent spaces are modules over
the source functions, l = 1 will do.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.adapted import Adapted, adapted
from osculant.cas.germs.codimension import codimension, last_order, tangent
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version, group
from osculant.cas.germs.infinite import Curve
from osculant.cas.germs.unipotent import LinearField, choices

#: sets of nilpotent fields tried for one k
SETS = 2000
#: orders above k in which the (k − 1)-jet is looked at
FURTHER = 8


@dataclass(frozen=True)
class Determinacy:
    """``degree`` k: the germ is k-determined; "infinite" if it is not finitely determined.

    ``fields`` are the nilpotent linear fields added to G₁, ``bound`` is l, ``order`` the order k + l of the
    jets of the proof. ``sharp`` is True if (k − 1)-determinacy is refuted, with ``reason``; None if it is
    not known.
    """

    degree: int | Literal["infinite"]
    bound: int
    order: int
    fields: tuple[str, ...]
    sharp: bool | None
    reason: str
    coordinates: tuple[str, ...] = ()
    curve: Curve | None = None

    def certificate(self) -> dict[str, Any]:
        """What an independent checker needs."""
        if self.curve is not None:
            return {"kind": "curve", "curve": str(self.curve)}
        return {
            "kind": "criterion",
            "bound": self.bound,
            "order": self.order,
            "fields": list(self.fields),
            "coordinates": list(self.coordinates),
        }


def determinacy(germ: Germ, name: str | Group) -> Determinacy:
    """The least degree of determinacy that the criterion proves, with the proof and the test of sharpness.

    Raises UndecidedError if no degree within the caps on jets is proved and no curve shows that there is
    none.

    >>> found = determinacy(Germ("x**3 + y**4", "x y"), "R")
    >>> found.degree, found.sharp
    (4, True)
    """
    g = group(name)
    whole = codimension(germ, g)
    if whole.curve is not None:
        return Determinacy("infinite", 0, 0, (), True, f"not finite along {whole.curve}", (), whole.curve)
    assert whole.tangent is not None  # the codimension is finite
    bound = max(whole.bound, 1)
    # M^{k+1}θ ⊂ T G f is necessary
    least = max(1, whole.tangent.depth)
    coordinates = _Coordinates(germ, g, least + bound)
    for k in range(least, last_order(germ) - bound + 1):
        for tried in coordinates:
            fields = _proof(tried.germ if tried else germ, g, k, bound)
            if fields is not None:
                sharp, reason = _sharpness(germ, g, k, whole.tangent.depth, whole.tangent.codimension)
                texts = tuple(f.text(tried.germ if tried else germ) for f in fields)
                where = tried.text(germ) if tried and fields else ()
                return Determinacy(k, bound, k + bound, texts, sharp, reason, where)
    raise UndecidedError(
        f"No degree of {g.name} determinacy of {germ} is proved by jets of order {last_order(germ)}."
    )


class _Coordinates:
    """The coordinates given (None), then those adapted to the jet of that order or else of a lower one."""

    def __init__(self, germ: Germ, g: Group, order: int) -> None:
        self.germ, self.group, self.order = germ, g, order

    def __iter__(self) -> Iterator[Adapted | None]:
        yield None
        if self._moved is not None:
            yield self._moved

    @cached_property
    def _moved(self) -> Adapted | None:
        orders = range(self.order, 1, -1)
        return next(filter(None, (adapted(self.germ, self.group, k) for k in orders)), None)


def _proof(germ: Germ, g: Group, k: int, bound: int) -> tuple[LinearField, ...] | None:
    """Nilpotent fields with which the criterion holds for k, few of them; None if none were found."""
    tried = choices(germ, g, k + bound)
    if tried.depth(()) <= k:
        return ()
    if not tried.settles(tuple(tried.useful), k):
        return None
    for number, fields in enumerate(tried.triangular()):
        if number == SETS:
            return None
        if tried.settles(fields, k) and tried.depth(fields) <= k:
            for field in fields:  # leave out what is not needed
                fewer = tuple(f for f in fields if f != field)
                if tried.settles(fewer, k) and tried.depth(fewer) <= k:
                    fields = fewer
            return fields
    return None


def _sharpness(germ: Germ, g: Group, k: int, depth: int, value: int) -> tuple[bool | None, str]:
    if k == 1:
        return True, "degrees of determinacy are at least 1"
    if depth >= k:
        return True, f"M^{k}θ is not in the tangent space"
    smaller = germ.truncated(k - 1)
    for order in range(k, min(k + FURTHER, last_order(germ)) + 1):
        found = tangent(smaller, g, Version.ORDINARY, order)
        if found.codimension > value:  # that of the jet's orbit can only be larger still
            return True, f"the {k - 1}-jet has a codimension of at least {found.codimension}, not {value}"
    return None, f"whether the germ is {k - 1}-determined is not decided"
