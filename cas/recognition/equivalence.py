"""Explicit equivalences: diffeomorphisms of source and target that take a germ to a normal form, exactly."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import fmpq_mat

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.jets_of_maps import MapJet, map_jet
from osculant.cas.recognition.finishing import Finish, substituted
from osculant.cas.recognition.forms import Column, Form
from osculant.cas.recognition.jets import terms_of
from osculant.cas.recognition.moves import Moved
from osculant.cas.recognition.obstruction import NotEquivalent as NotEquivalent
from osculant.cas.recognition.real_fields import sign
from osculant.cas.recognition.reduction import Start, reduced
from osculant.cas.recognition.refusals import proves
from osculant.cas.recognition.roots import Root, root
from osculant.cas.recognition.scaling import Scaled, agree, exchanges, scaled
from osculant.cas.recognition.stages import starts
from osculant.cas.recognition.targets import TARGETS, unmoved


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
        finish: a change of the source over a real number field after φ, if the form needs one; c are what
            they are after it.
        printed: whether it is an equivalence with the form of the list; if not, c are the coefficients of a
            rational normal form, the scales are 1, and the signs and moduli are known by invariants.
    """

    form: Form
    signs: tuple[int, ...]
    moduli: Mapping[str, Fraction | Root]
    source: MapJet
    target: Any
    coefficients: Mapping[Column, Any]
    scales: Scales
    order: int
    finish: Finish | None = None
    printed: bool = True


def equivalence(f: Germ, form: Form, order: int | None = None) -> Equivalence:
    """An equivalence of a germ with a form, for the group of the form, on jets of the order.

    Args:
        f: the germ.
        form: a form with as many variables and components, whose signs and moduli are open.
        order: k; by default the degree of determinacy of the form.

    Raises NotEquivalent if the jet of f is not in the orbit of any member of the form, DomainError for other
    numbers of variables or components or a smaller order, and UndecidedError beyond what is built, and where
    a failure proves nothing.

    >>> from osculant.cas.germs.reference import reference
    >>> from osculant.cas.recognition.forms import form
    >>> found = equivalence(Germ("x, y**3 - 3*x**2*y + x*y**2", "x y"), form(reference("rieger")["4_k"], k=2))
    >>> found.signs, [str(s) for s in found.scales.source]
    ((-1,), ['(3/10)**(1/2)', '1'])
    """
    if (f.n, f.p) != (form.n, form.p):
        raise DomainError(
            f"{form} has {form.n} variables and {form.p} components; the germ has {f.n} and {f.p}."
        )
    if f.field is not None:
        raise UndecidedError("Equivalences of germs whose coefficients are not rational are not built.")
    k = form.order if order is None else order
    if k < form.order:
        raise DomainError(
            f"order: {form} is seen in jets of order {form.order} on, not {k}.", argument="order"
        )
    start = map_jet(f.jet(k), f.n, k)
    if form.boundary is not None and f.boundary_index != form.boundary:
        raise DomainError(f"{form} has u in place {form.boundary + 1}, the germ in {f.boundary_index + 1}.")
    refused: NotEquivalent | None = None
    for begun in starts(unmoved(start, form.group), form):
        try:
            moved, terms = reduced(begun)
            found = _finished(
                form, {column: _fraction(c) for column, c in terms.items() if c != 0}, moved, begun
            )
        except NotEquivalent as obstruction:
            refused = refused or obstruction
            continue
        verify(found, start)
        return found
    assert refused is not None
    if not proves(form):
        raise UndecidedError(f"Whether the germ is {form} is not decided: {refused}") from refused
    raise refused


def _finished(form: Form, terms: Mapping[Column, Fraction], moved: Moved, begun: Start) -> Equivalence:
    """The equivalence from the terms that remain, after a last step over a number field if there is one."""
    if begun.finish is None:
        return best(form, terms, moved)
    refused: NotEquivalent | None = None
    for made in begun.finish(terms):
        try:
            if made.moduli is not None:
                return _rational(form, made.terms, moved, made.moduli)
            for column in set(made.terms) - set(form.columns):
                raise NotEquivalent(f"The term {column[0]} remains.", column, value=made.terms[column])
            if (over := made.field) is None:
                rational = moved.substituted(map_jet(made.images, form.n, moved.order))
                return best(form, made.terms, rational)
            return best(form, made.terms, moved, Finish(over, made.images))
        except NotEquivalent as obstruction:
            refused = refused or obstruction
    assert refused is not None
    raise refused


def _rational(
    form: Form, terms: Mapping[Column, Any], moved: Moved, moduli: Mapping[str, Fraction | Root]
) -> Equivalence:
    """The equivalence with a rational normal form, of which the moduli and signs of the form are known."""
    signs = [1] * form.signs
    for term in form.terms:
        if term.sign is not None and term.column in terms:
            signs[term.sign] = sign(terms[term.column] * term.coefficient)
    scales = Scales((root(1),) * form.n, (root(1),) * form.p)
    target = moved.part.change(moved)
    return Equivalence(
        form, tuple(signs), moduli, moved.source, target, terms, scales, moved.order, printed=False
    )


def best(form: Form, terms: Mapping[Column, Any], moved: Moved, finish: Finish | None = None) -> Equivalence:
    """The equivalence with the first spelling of the signs, coordinates exchanged where that makes it.

    Raises NotEquivalent if no scales make a member of the form.
    """
    found, refused = None, None
    for variables, components in exchanges(form):
        turned = {
            (tuple(m[variables.index(i)] for i in range(form.n)), components[j]): c
            for (m, j), c in terms.items()
        }
        try:
            made = scaled(form, turned, moved.part.scales)
        except NotEquivalent as obstruction:
            refused = refused or obstruction
            continue
        if found is None or made.signs > found[0].signs:
            found = made, turned, variables, components
    if found is None:
        assert refused is not None
        raise refused
    made, turned, variables, components = found
    if variables != tuple(range(form.n)) or components != tuple(range(form.p)):
        if finish is None:
            theirs = None if components == tuple(range(form.p)) else _permutation(components)
            moved = moved.changed(_permutation(variables).transpose(), theirs)
        else:
            finish = finish.exchanged(variables)
    scales = Scales(made.source, made.target)
    target = moved.part.change(moved)
    return Equivalence(
        form, made.signs, made.moduli, moved.source, target, turned, scales, moved.order, finish
    )


def verify(found: Equivalence, f: MapJet) -> None:
    """Checks an equivalence by substitution; raises ArithmeticError if it is none: a mistake of this room."""
    form, part = found.form, TARGETS[found.form.group.target]
    image = part.applied(found.target, f.compose(found.source))
    terms = {column: _fraction(c) for column, c in terms_of(image).items()}
    if found.finish is not None:
        terms = substituted(terms, found.finish.images, form.n, found.order)
    same = terms == dict(found.coefficients)
    linear = found.source.linear_part()
    made = Scaled(found.scales.source, found.scales.target, found.signs, dict(found.moduli))
    u = form.boundary
    kept = u is None or (all(m[u] for (m, j) in terms_of(found.source) if j == u) and linear[u, u] > 0)
    scaled_right = not found.printed or agree(form, found.coefficients, made)
    if not (same and linear.det() != 0 and kept and scaled_right):
        raise ArithmeticError(f"An equivalence with {form} that substitution refutes.")


def _permutation(order: Sequence[int]) -> fmpq_mat:
    """The matrix that puts coordinate i in place order[i]."""
    n = len(order)
    return fmpq_mat(n, n, [int(order[j] == i) for i in range(n) for j in range(n)])


def _fraction(value: Any) -> Fraction:
    return Fraction(int(value.p), int(value.q))
