"""All that is computed of a map-germ, as plain data.

Keys: ``source`` (names), ``target`` (p), ``components``, ``boundary`` (a name or null), ``group``, ``rank``;
``codimension``, ``extended_codimension`` and ``determinacy``: a number or "infinite"; ``sharp``: true if one
degree less is refuted, null if that is not known, and ``sharpness``: why; ``stable``; ``unfolding``: the
terms of a miniversal one, and ``unfolding_germ``: it as a germ (t, F(t, x)), which can be read again, with
``components``, ``source`` and ``parameters``; ``tjurina``, ``multiplicity``, ``ramification``: dimensions, or
"infinite";
``hilbert``: the Hilbert function of the Q-algebra; for a function also ``milnor``; ``at``: the point, if one
was moved to the origin; ``field``: the number field of coefficients that are not rational, by the
``polynomial`` of a number that generates it (coefficients, the constant first), its ``name`` if it was
stated, else the ends of an ``interval`` around it, and the ``roots`` of numbers in it (``degree``, ``of``
what, ``value``: coefficients of the powers of that number); ``even``: what it is as an even germ, if it was
read from one (`osculant.germs.even.even_data`).
What is undecided or has no meaning for the germ is null, and ``reason`` has a sentence under the same key;
``undecided`` lists the keys of the first kind.

``certificate`` has under "codimension", "extended_codimension" and "determinacy" what an independent checker
needs, null where there is no answer. A finite codimension has the functionals that vanish on the tangent
space in the jets of an order, each by its values on the terms where it is not 0 (with weights, the order
counts the variables with them), and under "contact" the same of T K_e f; infinity has a locus of bad points
and the proof that it has so many dimensions at the origin (a Gröbner basis as in
`osculant.cas.germs.local_dimension`, or the count of equations); a degree of determinacy has the bound l with
M^lθ ⊂ T K_e f, the order of jets k + l, the nilpotent linear fields added to G₁ and the functionals that
vanish on what they span together.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError, UndecidedError
from osculant.germs.even import even_data

if TYPE_CHECKING:
    from osculant.cas.germs.codimension import Codimension
    from osculant.cas.germs.determinacy import Determinacy
    from osculant.cas.germs.groups import Group
    from osculant.germs.map_germ import GroupName, MapGerm


def report(
    germ: MapGerm, group: GroupName = None, progress: Callable[[float], None] | None = None
) -> dict[str, Any]:
    """All answers about a germ (module text). If its codimension is undecided, only stability is asked too.

    Args:
        germ: the germ.
        group: as for the methods of `MapGerm`.
        progress: called now and then with the part that is done, 0…1.

    Raises DomainError for an (H) group without a boundary variable.

    >>> from osculant.germs.map_germ import germ
    >>> found = report(germ("x, y**2", "x y"), "A")
    >>> found["codimension"], found["tjurina"], found["hilbert"], found["reason"]
    (1, 1, [1, 1], {})
    >>> report(germ("x**3", "x"))["unfolding_germ"]["components"]
    ['t1', 't2', 'x**3 + t1 + t2*x']
    """
    acting = germ.group(group)
    acting.generators(germ.exact)
    told = {
        "source": list(germ.source),
        "target": germ.target,
        "components": list(germ.components),
        "boundary": germ.boundary,
        "group": acting.name,
        "rank": germ.rank,
    }
    if germ.at is not None:
        told["at"] = list(germ.at)
    if germ.exact.field is not None:
        told["field"] = germ.exact.field.told()
    from osculant.cas.germs.search import Patience

    germ.clock = Patience(germ.seconds)
    try:
        questions = _Questions(germ, acting)
        told |= questions.answers(progress or (lambda part: None))
        if germ.even is not None:
            told["even"] = even_data(germ, acting, questions.unfolded)
        return told
    finally:
        germ.clock = None


def certificate(germ: MapGerm, group: GroupName = None) -> dict[str, Any]:
    """What an independent checker needs, as plain data (module text); errors as for `report`.

    >>> from osculant.germs.map_germ import germ
    >>> found = certificate(germ("x**3", "x"), "R")["extended_codimension"]
    >>> found["order"], found["depth"], found["functionals"]
    (2, 1, [{'1': '1'}, {'x': '1'}])
    """
    return dict(report(germ, group)["certificate"])


def codimension_certificate(germ: MapGerm, found: Codimension) -> dict[str, Any]:
    """The certificate of a codimension, with terms as text.

    >>> from osculant.germs.map_germ import germ
    >>> g = germ("x, y**2, 0", "x y")
    >>> found = codimension_certificate(g, g.proved_codimension("A"))
    >>> found["kind"], found["locus"]["kind"], found["dimension"]
    ('locus', 'rank', 1)
    """
    return _with_terms(germ, found.certificate())


def determinacy_certificate(germ: MapGerm, found: Determinacy) -> dict[str, Any]:
    """The certificate of a degree of determinacy, with terms as text.

    >>> from osculant.germs.map_germ import germ
    >>> g = germ("x**3", "x")
    >>> determinacy_certificate(g, g.determinacy())["kind"]
    'criterion'
    """
    return _with_terms(germ, found.certificate())


def certificate_file(germ: MapGerm, group: GroupName = None) -> dict[str, Any]:
    """All answers about a germ as a certificate file, which `osculant.certificates.checker.check` checks.

    >>> from osculant.germs.map_germ import germ
    >>> found = certificate_file(germ("x**2", "x"))
    >>> found["kind"], found["version"], found["codimension"]
    ('germ', 1, 1)
    """
    return {"kind": "germ", "version": 1, **report(germ, group)}


def tells_ramification(data: dict[str, Any]) -> bool:
    """Whether the ramification of such a germ is a question: it is always infinite for a singular n = p, say.

    >>> from osculant.germs.map_germ import germ
    >>> tells_ramification(report(germ("x, y**2", "x y")))
    False
    """
    n, p = len(data["source"]), data["target"]
    return bool(data["rank"] == min(n, p) or n <= abs(n - p) + 1)


def _with_terms(germ: MapGerm, told: dict[str, Any]) -> dict[str, Any]:
    """A certificate of the exact room with terms as text in place of the numbers of columns."""
    from osculant.cas.germs.tangent import JetSpace

    found: dict[str, Any] = {}
    space = JetSpace(len(germ.source), germ.target, told.get("order", 0), tuple(told.get("weights", ())))

    def named(values: dict[int, str]) -> dict[str, str]:
        return {germ.term(space.term(c)): value for c, value in sorted(values.items())}

    for key, value in told.items():
        if key == "functionals":
            found[key] = [named(functional) for functional in value]
        elif key == "values":
            found[key] = named(value)
        elif key in {"contact", "annihilator", "first", "functional"}:
            found[key] = _with_terms(germ, value)
        else:
            found[key] = value
    return found


class _MeaninglessError(DomainError):
    """What is asked has no answer for this germ and group."""


class _Questions:
    """The questions about one germ, in order; each answers the keys after its name."""

    ORDER = (
        ("codimension", ("codimension",)),
        ("extended", ("extended_codimension",)),
        ("determinacy", ("determinacy", "sharp", "sharpness")),
        ("stable", ("stable",)),
        ("unfolding", ("unfolding", "unfolding_germ")),
        ("tjurina", ("tjurina",)),
        ("q_algebra", ("multiplicity", "hilbert")),
        ("ramification", ("ramification",)),
        ("milnor", ("milnor",)),
    )

    #: questions that would only reach the caps that the codimension has reached
    CAPPED = frozenset({"extended", "determinacy", "unfolding"})

    def __init__(self, germ: MapGerm, group: Group) -> None:
        self.germ, self.group = germ, group
        self.certificates: dict[str, Any] = dict.fromkeys(
            ("codimension", "extended_codimension", "determinacy")
        )
        self.reasons: dict[str, str] = {}
        self.undecided: list[str] = []
        self.unfolded: MapGerm | None = None

    def answers(self, progress: Callable[[float], None]) -> dict[str, Any]:
        data: dict[str, Any] = {}
        for number, (question, keys) in enumerate(self.ORDER):
            progress(number / len(self.ORDER))
            if question == "milnor" and self.germ.target > 1:
                continue
            try:
                if question in self.CAPPED and "codimension" in self.reasons:
                    raise UndecidedError(self.reasons["codimension"])
                data |= dict(zip(keys, getattr(self, question)()))
            except (DomainError, UndecidedError) as error:
                data |= dict.fromkeys(keys)
                self.reasons |= dict.fromkeys(keys, str(error))
                if not isinstance(error, _MeaninglessError):
                    self.undecided += keys
        return data | {
            "certificate": self.certificates,
            "reason": self.reasons,
            "undecided": self.undecided,
        }

    def found(self, extended: bool = False) -> Codimension:
        return self.germ.proved_codimension(self.group, extended=extended)

    def codimension(self) -> tuple[Any]:
        self.certificates["codimension"] = codimension_certificate(self.germ, self.found())
        return (self.found().value,)

    def extended(self) -> tuple[Any]:
        self.certificates["extended_codimension"] = codimension_certificate(self.germ, self.found(True))
        return (self.found(True).value,)

    def determinacy(self) -> tuple[Any, bool | None, str]:
        if not self.found().finite:  # then no degree is enough
            self.certificates["determinacy"] = self.certificates["codimension"]
            return "infinite", None, f"not finitely determined: {self.found().proof}"
        found = self.germ.determinacy(self.group)
        self.certificates["determinacy"] = determinacy_certificate(self.germ, found)
        return found.degree, found.sharp, found.reason

    def stable(self) -> tuple[bool]:
        if self.group.target != "left":
            raise _MeaninglessError(f"Stability is asked of A or A(H), not of {self.group.name}.")
        return (self.germ.is_stable(self.group),)

    def unfolding(self) -> tuple[list[str], dict[str, Any]]:
        if not self.found().finite:
            raise _MeaninglessError("A germ of infinite codimension has no versal unfolding.")
        found = self.germ.unfolding(self.group, _letter(self.germ.names))
        self.unfolded = whole = found.germ
        return list(found.terms), {
            "components": list(whole.components),
            "source": list(whole.source),
            "parameters": list(whole.source[: len(found.terms)]),
        }

    def tjurina(self) -> tuple[Any]:
        return (self.germ.tjurina,)

    def q_algebra(self) -> tuple[Any, list[int] | None]:
        found = self.germ.q_algebra
        if found == "infinite":
            self.reasons["hilbert"] = "The Q-algebra is infinite."
            return found, None
        return found.dimension, list(found.hilbert)

    def ramification(self) -> tuple[Any]:
        found = self.germ.ramification
        return (found if found == "infinite" else found.dimension,)

    def milnor(self) -> tuple[Any]:
        return (self.germ.milnor,)


def _letter(source: Sequence[str]) -> str:
    """The letter of parameters: none of the variables is that letter and digits."""
    letters: tuple[str, ...] = ("t", "s", "a", "b", "c", "tt")
    while any(re.fullmatch(f"{letters[0]}[0-9]+", name) for name in source):
        letters = letters[1:] if len(letters) > 1 else (letters[0] + "t",)
    return letters[0]
