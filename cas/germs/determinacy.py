"""Finite determinacy: the least degree k proved, the unipotent group that proves it, and whether it is sharp.

Criterion (du Plessis; Bruce, du Plessis and Wall): if M^lθ ⊂ T K_e f and M^{k+1}θ ⊂ T U f + M^{k+l+1}θ for a
unipotent subgroup U of G, then f is k-determined for G. For R, C and K, whose tangent spaces are modules over
the source functions, l = 1 will do. Where weights give T G₁ f as a whole, M^{k+1}θ ⊂ T U f is read off it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any, Literal

from osculant.cas.errors import UndecidedError
from osculant.cas.formulas.expression import to_text
from osculant.cas.germs.adapted import Frame, adapted, given, unit
from osculant.cas.germs.codimension import Codimension, codimension, tangent_of_contact
from osculant.cas.germs.geometry import Degeneration
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version, group
from osculant.cas.germs.modular_choices import SeenChoices
from osculant.cas.germs.modular_tangent import is_dense, modular_tangent
from osculant.cas.germs.search import COLUMNS, GRADED, Patience
from osculant.cas.germs.sharpness import Sharpness, sharpness
from osculant.cas.germs.symmetries import telling_orders
from osculant.cas.germs.tangent import JetSpace
from osculant.cas.germs.tangent_space import Tangent, annihilator_certificate, tangent
from osculant.cas.germs.unipotent import Choices, ExactChoices, Fields
from osculant.cas.germs.weights import graded_by, weights


@dataclass(frozen=True)
class Determinacy:
    """``degree`` k: the germ is k-determined; "infinite" if it is not finitely determined.

    ``fields`` are the nilpotent linear fields added to G₁, ``bound`` is l, ``order`` the order k + l of the
    jets of the proof (counted with the weights of the variables where the fields of all weights are known at
    once). ``sharp`` is True if (k − 1)-determinacy is refuted, with ``reason``; None if it is not known.
    """

    degree: int | Literal["infinite"]
    bound: int
    order: int
    fields: tuple[str, ...]
    sharp: bool | None
    reason: str
    coordinates: tuple[str, ...] = ()
    proof: Degeneration | None = None
    evidence: Evidence | None = field(default=None, repr=False)

    def certificate(self) -> dict[str, Any]:
        """What an independent checker needs.

        "matrices" are the nilpotent fields in the coordinates given: entry (a, b) is the coefficient of
        x_a ∂/∂x_b or y_a ∂/∂y_b; "annihilator" that of T U f in the jets of the order, "contact" that of T
        K_e f; where the jets count weights, "first" is the annihilator of T G₁ f. "other" is a germ with the
        same (k − 1)-jet that is not equivalent, with "functional", one that vanishes on its tangent space but
        not on M^k.
        """
        if self.proof is not None:
            return self.proof.certificate()
        told: dict[str, Any] = {
            "kind": "criterion",
            "bound": self.bound,
            "order": self.order,
            "fields": list(self.fields),
            "coordinates": list(self.coordinates),
        }
        assert self.evidence is not None
        return {**told, **self.evidence.certificate()}


@dataclass(frozen=True)
class Evidence:
    """What proves a degree of determinacy: the tangent space T G₁ f, fields with their frame, and T K_e f."""

    choices: Choices
    frame: Frame
    fields: Fields
    contact: Tangent | None
    sharp: Sharpness

    def certificate(self) -> dict[str, Any]:
        """As plain data."""
        told: dict[str, Any] = {
            "matrices": [
                {"side": f.side, "matrix": [[str(v) for v in row] for row in self.frame.field(f)]}
                for f in self.fields
            ],
            **self.choices.certificate(self.frame, self.fields),
        }
        if self.contact is not None:
            told["contact"] = annihilator_certificate(self.contact)
        if self.sharp.other is not None and self.sharp.tangent is not None:
            t = self.sharp.tangent
            told["other"] = list(map(to_text, self.sharp.other.components))
            witness = next(
                f for f in t.annihilator.functionals if any(t.space.degree(c) == t.space.order for c in f)
            )
            told["functional"] = {"order": t.space.order, "values": {c: str(v) for c, v in witness.items()}}
        return told


def determinacy(germ: Germ, name: str | Group, patience: Patience | None = None) -> Determinacy:
    """The least degree of determinacy that the criterion proves, with the proof and the test of sharpness.

    Args:
        germ: the germ.
        name: the group.
        patience: the time that it may take; `search.SECONDS` by default.

    Raises UndecidedError if no degree is proved in that time and the germ is not proved to be infinite.

    >>> found = determinacy(Germ("x**3 + y**4", "x y"), "R")
    >>> found.degree, found.sharp
    (4, True)
    """
    g, patience = group(name), patience or Patience()
    whole = codimension(germ, g, patience=patience)
    if whole.proof is not None:
        return Determinacy("infinite", 0, 0, (), True, f"not finite: {whole.proof}", (), whole.proof)
    return _Question(germ, g, whole, patience).answer()


class _Question:
    """The search for the least degree."""

    def __init__(self, germ: Germ, g: Group, whole: Codimension, patience: Patience) -> None:
        assert whole.tangent is not None  # the codimension is finite
        self.germ, self.group, self.patience = germ, g, patience
        self.depth = whole.tangent.plain_depth
        # M^{k+1}θ ⊂ T G f is necessary
        self.least = max(1, self.depth)
        self.contact = whole.contact
        self.contact_by_weight: Tangent | None = None
        if whole.contact is not None and whole.contact.space.weights:  # its l counts weights
            self.contact = tangent_of_contact(germ, g, patience)
        self.bound = 1 if self.contact is None else max(self.contact.depth + 1, 1)

    def answer(self) -> Determinacy:
        k, known = self.least, None
        while True:
            beyond = sharpness(self.germ, self.group, k + 1, self.depth, quick=True)
            if not beyond.sharp:  # it may be k-determined
                choices = self.choices(k)
                if choices is None or (k > self.least and self.patience.left() < 0):
                    raise UndecidedError(
                        f"No degree of {self.group.name} determinacy of {self.germ} below {k} is proved; "
                        f"{k} is out of reach within {self.patience.seconds:g} seconds."
                    )
                proof = choices.raising(self.plain, k) or choices.proof(self.frames(k), k)
                if proof is not None:
                    return self.told(k, choices, *proof, known)
            k, known = k + 1, beyond

    def choices(self, k: int) -> Choices | None:
        """The choices for a degree; None if they are too many."""
        order = k + self.bound
        if is_dense(self.germ, self.group, k + 1):
            seen = modular_tangent(self.germ, self.group, Version.UNIPOTENT, k + 1, self.bound)
            if seen is not None:
                return SeenChoices(self.germ, self.group, seen, order)
        columns = JetSpace(self.germ.n, self.germ.p, order).columns
        if columns > GRADED and (exact := self.exact) is not None:
            return exact
        if columns > COLUMNS:
            return None
        return ExactChoices(tangent(self.germ, self.group, Version.UNIPOTENT, order))

    @cached_property
    def exact(self) -> Choices | None:
        """T G₁ f as a whole, by weights."""
        return self._graded()

    def _graded(self) -> Choices | None:
        w = graded_by(self.germ) if self.group.source != "own" else None
        if w is None:
            return None
        light = 1
        if self.group.target == "left":
            contact = Group(self.group.name, self.group.source, "contact", self.group.fields)
            found = self._first(contact, Version.EXTENDED, w, 1)
            self.contact_by_weight, light = found, found.depth + 1
        return ExactChoices(self._first(self.group, Version.UNIPOTENT, w, light), True)

    def _first(self, g: Group, version: Version, w: tuple[int, ...], bound: int) -> Tangent:
        """The tangent space of the first order that settles it: it is finite."""
        order = 2 * max(w)
        while not (found := tangent(self.germ, g, version, order, w)).settled(bound):
            # below, it is not settled: the depth does not fall
            order = max(order + 1, found.least_order(bound))
            if self.patience.left() < 0:
                raise UndecidedError(f"The {g.name} tangent space of {self.germ} is not known in time.")
        return found

    def frames(self, k: int) -> Iterator[Frame]:
        """The coordinates given, with the weights of the germ if it has some, and those adapted to it."""
        yield self.plain
        yield from self.adapted(k + min(self.bound, 2))

    @property
    def plain(self) -> Frame:
        key = "frame", self.group
        if key not in self.germ.known:
            frame = given(unit(self.germ.n), unit(self.germ.p))
            found = weights(self.germ) if self.germ.polynomial(4095) is not None else None
            if found is not None:
                source, target = (tuple(map(Fraction, w)) for w in (found.source, found.target))
                frame = Frame(frame.source, frame.target, source, target, moved=False)
            self.germ.known[key] = frame
        made: Frame = self.germ.known[key]
        return made

    def adapted(self, order: int) -> Iterator[Frame]:
        """Coordinates adapted to the jet of that order, and to jets of lower orders that tell more apart."""
        key = "adapted", self.group
        if key not in self.germ.known:
            self.germ.known[key] = telling_orders(self.germ, self.group, order), list[Frame]()
        left, found = self.germ.known[key]
        yield from tuple(found)
        while left:
            frame = adapted(self.germ, self.group, left.pop(0))
            if frame is not None and all(frame.kinds > other.kinds for other in found):
                found.append(frame)
                yield frame

    def told(
        self, k: int, choices: Choices, frame: Frame, fields: Fields, known: Sharpness | None
    ) -> Determinacy:
        found = known if known is not None and known.sharp and known.tangent is not None else None
        found = found or sharpness(self.germ, self.group, k, self.depth)
        moved = frame.moved and bool(fields)
        contact = self.contact_by_weight if choices.exact else self.contact
        return Determinacy(
            k,
            1 if contact is None else max(contact.depth + 1, 1),
            choices.space.order,
            tuple(f.text(self.germ, moved) for f in fields),
            found.sharp,
            found.reason,
            frame.text(self.germ) if moved else (),
            None,
            Evidence(choices, frame, fields, contact, found),
        )
