"""All that is computed of a secant germ, as plain data.

Of a germ at the diagonal: ``kind`` "secant" and ``version`` 1; ``immersion`` (components), ``source``,
``at``, ``direction``; ``source_frame`` B and ``target_frame`` C, matrices by rows of the linear changes: the
immersion in normal position is p ↦ C·(X(a + B·p) − X(a)); ``order``: that of the jets in which the germ is
known, null if it is whole, and ``settled``: whether it is whole or determined for A(H) by these jets;
``germ``: the answers about f for A(H), ``projection``: those about the projection along the direction for A,
both as `osculant.germs.report` has them, with ``name`` and ``table``: the class in the lists of the
literature and the list, null without one; ``linked``: the degree up to which Remark 6.2.3, which links the
two, was checked; if it is asked for, ``variety``: the answers about the germ of the secant variety for A(H);
for a curve in space ``frenet``: the exact ``curvature``, ``torsion``, ``curvature_slope``, ``torsion_slope``,
``torsion_second``, the ``condition`` 3κτ″ − κ′τ′ and the ``case`` of Proposition 1.4.5, by arc length; null
where the curvature is 0.

Where jets do not settle a germ, its answers are null, and ``reason`` says so.

Of a germ at two points: ``kind`` "secant apart" and ``version`` 1; ``immersion``, ``source``, ``at``, ``to``;
``parameters``: the names of the coordinates p of the first point; ``germ``: the answers about S for A;
``versality``: ``components`` and ``source`` of q ↦ S(0, q), its ``extended_codimension``, ``versal``,
``reached`` and ``missing`` as of an unfolding with the parameters p, or null; ``bigerm``: ``branches`` and
``extended_codimension``. ``reason`` has a sentence for what is null.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.expression import to_text
from osculant.germs.even import even_data
from osculant.germs.report import report
from osculant.germs.secants import UNSETTLED

if TYPE_CHECKING:
    from osculant.germs.map_germ import MapGerm
    from osculant.germs.secants import Secant, SecantApart

#: what a report has as null where jets do not settle the germ
ANSWERS = ("codimension", "extended_codimension", "determinacy", "stable")


def secant_report(
    secant: Secant, variety: bool = False, progress: Callable[[float], None] | None = None
) -> dict[str, Any]:
    """All answers about a secant germ (module text).

    Args:
        secant: the germ.
        variety: whether the secant variety is asked for, too.
        progress: called now and then with the part that is done, 0…1.

    >>> from osculant.germs.secants import secant
    >>> found = secant_report(secant("t, t^2, t^3", "t"))
    >>> found["germ"]["components"], found["germ"]["codimension"], found["frenet"]["case"]
    (['t', '1/4*u + 3/4*t**2'], 0, 'fold')
    """
    immersion = secant.exact.immersion
    parts = 3 if variety else 2

    def within(k: int) -> Callable[[float], None]:
        return lambda part: progress((k + part) / parts) if progress is not None else None

    source_frame, target_frame = secant.frames
    data: dict[str, Any] = {
        "kind": "secant",
        "version": 1,
        "immersion": list(map(to_text, immersion.components)),
        "source": list(immersion.source),
        "at": list(map(to_text, immersion.point)),
        "direction": list(map(to_text, immersion.direction)),
        "source_frame": source_frame,
        "target_frame": target_frame,
        "order": secant.order,
        "settled": secant.settled,
        "germ": {**report(secant.germ, "A(H)", within(0)), **_named(secant.germ, "A(H)")}
        if secant.settled
        else {**_unsettled(secant.germ, UNSETTLED.format(order=secant.order)), "name": None, "table": None},
        "projection": {**report(secant.projection, "A", within(1)), **_named(secant.projection, "A")},
        "linked": secant.linked(),
    }
    if variety:
        found = secant.variety()
        whole = secant.order is None
        data["variety"] = (
            report(found, "A(H)", within(2))
            if whole
            else _unsettled(
                found,
                f"Jets of order {secant.order} alone are known of the variety's germ.",
            )
        )
    if (immersion.n, immersion.germ.p) == (1, 3):
        data["frenet"] = _frenet(secant)
    return data


def _named(germ: MapGerm, group: str) -> dict[str, str | None]:
    """The class of a germ in the lists: its name and the list, both null without one."""
    found = germ.recognise(group)
    return {"name": found.name, "table": found.table}


def _unsettled(germ: MapGerm, reason: str) -> dict[str, Any]:
    """The report of a germ of which jets alone are known, and do not tell its answers."""
    told = {
        "source": list(germ.source),
        "target": germ.target,
        "components": list(germ.components),
        "boundary": germ.boundary,
        "group": "A(H)",
        "rank": germ.rank,
        **dict.fromkeys(ANSWERS),
        "reason": dict.fromkeys(ANSWERS, reason),
        "undecided": list(ANSWERS),
    }
    return told if germ.even is None else {**told, "even": even_data(germ, germ.group("A(H)"))}


def _frenet(secant: Secant) -> dict[str, str] | None:
    try:
        found = secant.frenet()
    except DomainError:
        return None
    names = ("curvature", "torsion", "curvature_slope", "torsion_slope", "torsion_second", "condition")
    return {**{name: to_text(getattr(found, name)) for name in names}, "case": found.case}


def apart_report(secant: SecantApart, progress: Callable[[float], None] | None = None) -> dict[str, Any]:
    """All answers about a secant germ at two points (module text); ``progress`` as for `secant_report`.

    >>> from osculant.germs.secants import secant_apart
    >>> found = apart_report(secant_apart("t, t^2, t^3", "t", 0, 1))
    >>> found["germ"]["stable"], found["versality"]["versal"], found["bigerm"]["extended_codimension"]
    (True, True, 0)
    """
    exact = secant.exact
    at, to = exact.points
    reasons: dict[str, str] = {}
    data: dict[str, Any] = {
        "kind": "secant apart",
        "version": 1,
        "immersion": list(map(to_text, exact.immersion)),
        "source": list(exact.given),
        "at": list(map(to_text, at)),
        "to": list(map(to_text, to)),
        "parameters": list(secant.parameters),
        "germ": report(secant.germ, "A", progress),
        "versality": None,
        "bigerm": {
            "branches": [list(map(to_text, branch.components)) for branch in (exact.germ, exact.back)]
        },
    }
    try:
        f, found = secant.versality()
        data["versality"] = {
            "components": list(f.components),
            "source": list(f.source),
            "extended_codimension": found.codimension,
            "versal": found.versal,
            "reached": found.reached,
            "missing": [f.term(term) for term in found.missing],
        }
    except (DomainError, UndecidedError) as error:
        reasons["versality"] = str(error)
    try:
        data["bigerm"]["extended_codimension"] = secant.bigerm_codimension()
    except (DomainError, UndecidedError) as error:
        data["bigerm"]["extended_codimension"] = None
        reasons["bigerm"] = str(error)
    return {**data, "reason": reasons}
