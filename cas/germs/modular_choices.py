"""Unipotent groups for dense germs: chosen modulo a prime, confirmed in the jets of the degree itself."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.adapted import Frame
from osculant.cas.germs.annihilator import Functional, annihilator
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.linear_fields import LinearField, linear_fields
from osculant.cas.germs.modular_tangent import ModularTangent
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.germs.tangent import JetSpace, Vector, rows, vectors
from osculant.cas.germs.tangent_space import functionals_told
from osculant.cas.germs.unipotent import Choices, Fields, Residues, modular_rank, residue


class SeenChoices(Choices):
    """By the annihilator of T G₁ f modulo a prime.

    With fields added let T have codimension c modulo the prime and contain M^{k+1}θ. If c rational
    functionals in the jets of order k vanish on it, it contains M^{k+1}θ over ℚ, as for `modular_first`.

    Args:
        germ: the germ.
        group: the group.
        seen: T G₁ f modulo the prime.
        order: the order of jets that the certificate speaks of.
    """

    def __init__(self, germ: Germ, group: Group, seen: ModularTangent, order: int) -> None:
        super().__init__()
        self.germ, self.group, self.seen, self.prime = germ, group, seen, seen.prime
        self.space = JetSpace(germ.n, germ.p, order)
        self._values = seen.pairings(germ, group)
        self._functionals: tuple[Fields, tuple[Functional, ...]] = (), ()

    def residues(self, frame: Frame) -> Residues:
        """See `Choices`."""
        found = {}
        for field in linear_fields(self.germ, self.group):
            total = [0] * self.seen.codimension
            for part, entry in frame.parts(field):
                factor = residue(entry, self.prime)
                total = [(a + factor * b) % self.prime for a, b in zip(total, self._values[part])]
            if any(total):
                found[field] = total
        return found

    def beyond(self, k: int) -> list[list[int]]:
        """See `Choices`."""
        found: list[list[int]] = self.seen.values[self.seen.degrees > k].tolist()
        return found

    def confirmed(self, frame: Frame, fields: Fields, k: int) -> bool:
        """See `Choices`."""
        moving = [frame.parts(field) for field in fields]
        if any(entry.denominator % self.prime == 0 for parts in moving for _, entry in parts):
            return False
        residues = self.residues(frame)
        gained = modular_rank([residues[f] for f in fields], self.prime)
        space = JetSpace(self.germ.n, self.germ.p, k)
        spanning = list(vectors(self.germ, self.group, Version.UNIPOTENT, k))
        spanning += [self._image(parts, k) for parts in moving]
        found = annihilator(rows(spanning, space), space.columns)
        self._functionals = fields, found.functionals
        return found.codimension == self.seen.codimension - gained

    def _image(self, parts: list[tuple[LinearField, Any]], order: int) -> Vector:
        total: list[Polynomial] = [{} for _ in range(self.germ.p)]
        for field, entry in parts:
            image = field.image(self.germ, order)
            total = [poly.plus(a, b, Fraction(entry)) for a, b in zip(total, image)]
        return tuple(total)

    def certificate(self, frame: Frame, fields: Fields) -> dict[str, Any]:
        """See `Choices`."""
        assert self._functionals[0] == fields, "only what was confirmed last is certified"
        return {
            "annihilator": {
                "order": self.space.order,
                "columns": self.space.columns,
                "prime": self.prime,
                "functionals": functionals_told(self._functionals[1]),
            }
        }
