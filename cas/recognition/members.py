"""Germs that stand for a row of a list when keys are compared, and germs arranged as the row is."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.linear import rank
from osculant.cas.recognition.forms import Form

#: numbers that stand for moduli, besides those that a list tries
GENERAL = (Fraction(3, 7), Fraction(-5, 11), Fraction(8, 13), Fraction(-17, 10))


def special_members(form: Form) -> bool:
    """Whether members of a family may have different keys: not if scalings with a factor make them one.

    >>> from osculant.cas.germs.reference import reference
    >>> from osculant.cas.recognition.forms import form
    >>> rows = reference("unimodal functions")
    >>> special_members(form(rows["X_9"])), special_members(form(rows["E_12"]))
    (True, False)
    """
    if not form.moduli or form.p > 1:
        return bool(form.moduli)
    rows = [[Fraction(e) for e in (*t.monomial, 1)] for t in form.terms if t.modulus is None]
    more = [[Fraction(e) for e in (*t.monomial, 1)] for t in form.terms if t.modulus is not None]
    size = form.n + 1
    return rank([*rows, *more], size) < rank(rows, size) + len(more)


def members(form: Form) -> Iterator[Germ]:
    """Germs of the row that stand for all in the comparison of keys; kept."""
    known: Mapping[Any, list[Germ]] = _MEMBERS
    if form not in known:
        _MEMBERS[form] = [_member(form, moduli) for moduli in _tried(form)]
    yield from _MEMBERS[form]


_MEMBERS: dict[Form, list[Germ]] = {}


def _tried(form: Form) -> Iterator[dict[str, Any]]:
    """Values of the moduli: general ones, and those that the list tries."""
    if not form.moduli:
        yield {}
        return
    for shift in range(len(GENERAL)):
        yield {name: GENERAL[(shift + i) % len(GENERAL)] for i, name in enumerate(form.moduli)}
    given = {p.name: p.tried for p in form.entry.moduli}
    for i in range(max(map(len, given.values()))):
        yield {name: Fraction(values[i % len(values)]) for name, values in given.items()}


def _member(form: Form, moduli: Mapping[str, Any]) -> Germ:
    components: list[poly.Polynomial] = [{} for _ in range(form.p)]
    for term in form.terms:
        value = term.coefficient * (1 if term.modulus is None else moduli[term.modulus])
        if value:
            components[term.component][poly.monomial(term.monomial)] = value
    boundary = None if form.boundary is None else form.variables[form.boundary]
    return Germ([as_node(f, form.variables) for f in components], form.variables, boundary)


def arranged(germ: Germ, form: Form) -> Germ:
    """The germ with its boundary variable in the place where the form has it.

    >>> from osculant.cas.germs.reference import reference
    >>> from osculant.cas.recognition.forms import form
    >>> arranged(Germ("u, y, z, x", "u x y z"), form(reference("table 6.2")["4a"])).source
    ('x', 'y', 'z', 'u')
    """
    if form.boundary is None or germ.boundary_index == form.boundary:
        return germ
    names = [name for name in germ.source if name != germ.boundary]
    names.insert(form.boundary, str(germ.boundary))
    return Germ(germ.components, names, germ.boundary, germ.field)
