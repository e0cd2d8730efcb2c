"""Explicit equivalences: diffeomorphisms of source and target that take a germ to a normal form, exactly."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from osculant.cas.germs.germ import Germ
from osculant.cas.germs.jets_of_maps import MapJet
from osculant.cas.recognition.forms import Column, Form
from osculant.cas.recognition.roots import Root


class NotEquivalent(Exception):  # noqa: N818  (an answer, not an error)
    """A germ that is not of the form asked about: what stands in the way.

    Attributes:
        column: the monomial with its component, if one is in the way.
        level: its level, if so.
        value: its coefficient.
    """

    def __init__(
        self, sentence: str, column: Column | None = None, level: int | None = None, value: Any = None
    ) -> None:
        super().__init__(sentence)
        self.column, self.level, self.value = column, level, value


@dataclass(frozen=True)
class Scales:
    """xᵢ ↦ sᵢxᵢ after the source change and Yⱼ ↦ tⱼYⱼ after that of the target: roots of rationals."""

    source: tuple[Root, ...]
    target: tuple[Root, ...]


@dataclass(frozen=True)
class Equivalence:
    """ψ∘f∘φ = Σ c·(monomials of the form) mod M^{k+1}, and the scales that make the printed form of it.

    Attributes:
        form: the form.
        signs: the signs of the form, one spelling for each real class.
        moduli: the values of the moduli, by name, where the stabiliser acts the representative that
            `osculant.cas.recognition.scaling` states.
        source: φ.
        target: ψ, the identity for R; for K a jet of matrices.
        coefficients: c, for every monomial of the form that is there.
        scales: s and t with tⱼ·c·s^α = the printed coefficient of every monomial x^α of component j.
        order: k.
    """

    form: Form
    signs: tuple[int, ...]
    moduli: Mapping[str, Fraction | Root]
    source: MapJet
    target: Any
    coefficients: Mapping[Column, Fraction]
    scales: Scales
    order: int


def equivalence(f: Germ, form: Form, order: int | None = None) -> Equivalence:
    """An equivalence of a germ with a form, for the group of the form, on jets of the order.

    Args:
        f: the germ.
        form: a form with as many variables and components, whose signs and moduli are open.
        order: k; by default the degree of determinacy of the form.

    Raises NotEquivalent if the jet of f is not in the orbit of any member of the form, DomainError for other
    numbers of variables or components, and UndecidedError beyond what is built.
    """
    raise NotImplementedError
