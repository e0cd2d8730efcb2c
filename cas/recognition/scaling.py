"""Scaling of coordinates: the coefficients of a normal form made the printed ones, signs and moduli read off.

xᵢ ↦ sᵢxᵢ, Yⱼ ↦ tⱼYⱼ multiply the coefficient of x^α in component j by tⱼs^α. The Smith normal form of the
exponents says which roots that takes: only those of elementary divisors above 1. A modulus is what its term
has when the others are scaled, a monomial of the coefficients that no scaling changes. Modulo 2 the same
matrix, without u, decides which signs are different real classes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import prod
from typing import Any

from osculant.cas.recognition.forms import Column, Form, Term
from osculant.cas.recognition.obstruction import NotEquivalent
from osculant.cas.recognition.real_fields import sign, size
from osculant.cas.recognition.roots import Root, root
from osculant.cas.recognition.smith import smith, solutions_mod_2

#: rational, or in one real number field
Coefficients = Mapping[Column, Any]


@dataclass(frozen=True)
class Scaled:
    """Scales, the signs and the moduli of the form that they make."""

    source: tuple[Root, ...]
    target: tuple[Root, ...]
    signs: tuple[int, ...]
    moduli: dict[str, Fraction | Root]


def scaled(form: Form, found: Coefficients, target: bool) -> Scaled:
    """The scales that make coefficients those of a member of the form.

    The signs are the first, in the order of `Entry.signs`, that signs of the coordinates (not of u) can make;
    of the moduli those that can be made positive are, from the first on.

    Args:
        form: the form.
        found: the coefficients, none of them 0; all terms without a modulus must be there.
        target: whether target coordinates may be scaled.

    Raises NotEquivalent if a term is not there, or no scaling makes them, or a modulus is one of those
    where the form degenerates.
    """
    fixed = [term for term in form.core if term.modulus is None]
    for term in fixed:
        if not found.get(term.column):
            raise NotEquivalent(f"The term {term.monomial} of component {term.component + 1} is not there.")
    sizes = _sizes(form, fixed, found, target)
    signs, flips = _signs(form, fixed, found, target)
    scales = [Root(r.base, r.index, -1 if flip else 1) for r, flip in zip(sizes, flips)]
    source, theirs = scales[: form.n], scales[form.n :] or [root(1)] * form.p
    moduli = {}
    for term in form.core:
        if term.modulus is not None:
            value = found.get(term.column, Fraction(0)) / term.coefficient
            moduli[term.modulus] = (_made(term, source, theirs) * _root(value)).value if value else value
    for parameter in form.entry.parameters:
        if moduli.get(parameter.name) in parameter.degenerate(signs):
            raise NotEquivalent(f"{parameter.name} = {moduli[parameter.name]}, where {form} degenerates.")
    return Scaled(tuple(source), tuple(theirs), signs, moduli)


def agree(form: Form, found: Coefficients, made: Scaled) -> bool:
    """Whether the scales make exactly the member of the form with those signs and moduli."""
    for term in form.core:
        value = found.get(term.column, Fraction(0))
        wanted = _root(term.coefficient * (1 if term.sign is None else made.signs[term.sign]))
        if term.modulus is not None:
            modulus = made.moduli[term.modulus]
            if not modulus or not value:
                if modulus or value:
                    return False
                continue
            wanted = wanted * (modulus if isinstance(modulus, Root) else _root(modulus))
        if not value or not (_made(term, made.source, made.target) * _root(value)).same(wanted):
            return False
    return set(found) <= set(form.columns)


def exchanges(form: Form) -> Iterator[tuple[tuple[int, ...], tuple[int, ...]]]:
    """Permutations of variables and components that keep the terms of a form, signs and moduli aside.

    Variable i becomes variable σ(i), component j becomes τ(j); the identity comes first.

    >>> from osculant.cas.germs.reference import reference
    >>> from osculant.cas.recognition.forms import form
    >>> list(exchanges(form(reference("table 6.2")["2b"])))
    [((0, 1, 2, 3), (0, 1)), ((0, 2, 1, 3), (0, 1))]
    """
    rows = [
        frozenset((t.monomial, t.coefficient) for t in form.core if t.component == j) for j in range(form.p)
    ]
    for order in _permutations(form):
        moved = [
            frozenset((tuple(m[order.index(i)] for i in range(form.n)), c) for m, c in row) for row in rows
        ]
        if sorted(map(sorted, moved), key=str) == sorted(map(sorted, rows), key=str):
            free, theirs = list(range(form.p)), []
            for row in moved:
                theirs.append(next(j for j in free if rows[j] == row))
                free.remove(theirs[-1])
            yield order, tuple(theirs)


def _permutations(form: Form) -> Iterator[tuple[int, ...]]:
    from itertools import permutations

    for order in permutations(range(form.n)):
        if form.boundary is None or order[form.boundary] == form.boundary:
            yield order


def _row(form: Form, term: Term, target: bool) -> list[int]:
    units = [int(j == term.component) for j in range(form.p)] if target else []
    return [*term.monomial, *units]


def _sizes(form: Form, fixed: Sequence[Term], found: Coefficients, target: bool) -> list[Root]:
    """The sizes of the scales."""
    u, divisors, v = smith([_row(form, term, target) for term in fixed])
    ratios = [size(term.coefficient / found[term.column]) for term in fixed]
    powers = [prod((r**e for r, e in zip(ratios, row) if e), start=Fraction(1)) for row in u]
    for power in powers[len(divisors) :]:
        if power != 1:
            raise NotEquivalent(f"An invariant of the coefficients of {form} is {power}, not 1.")
    parts = [root(power, d) for power, d in zip(powers, divisors)]
    sizes = []
    for row in v:
        value = root(1)
        for part, e in zip(parts, row):
            value = value * part**e if e else value
        sizes.append(value)
    return sizes


def _signs(
    form: Form, fixed: Sequence[Term], found: Coefficients, target: bool
) -> tuple[tuple[int, ...], list[int]]:
    """(the signs of the form, which scales are negative)."""
    rows = [_row(form, term, target) for term in fixed]
    size = len(rows[0])
    if form.boundary is not None:
        unit = [int(i == form.boundary) for i in range(size)]
        rows.append(unit)
    for signs in product((1, -1), repeat=form.signs):
        if any(s < 0 for i, s in enumerate(signs) if all(t.sign != i for t in form.core)):
            continue  # a sign of a square that was dropped
        right = []
        for term in fixed:
            wanted = 1 if term.sign is None else signs[term.sign]
            right.append(int(sign(found[term.column]) * term.coefficient * wanted < 0))
        solved = solutions_mod_2(rows, [*right, 0][: len(rows)], size)
        if solved is not None:
            return signs, _positive(form, found, solved, target)
    raise NotEquivalent(f"The signs of the coefficients are those of no member of {form}.")


def _positive(form: Form, found: Coefficients, solved: list[list[int]], target: bool) -> list[int]:
    """Signs of the scales with which as many moduli as possible are positive, from the first on."""
    best, *kernel = solved
    for name in form.moduli:
        terms = [t for t in form.core if t.modulus == name and found.get(t.column)]
        if not terms:
            continue
        row = _row(form, terms[0], target)

        def flips(vector: list[int], row: list[int] = row) -> int:
            return sum(a * b for a, b in zip(row, vector)) % 2

        turning = next((vector for vector in kernel if flips(vector)), None)
        if turning is not None:
            if int(sign(found[terms[0].column]) * terms[0].coefficient < 0) != flips(best):
                best = [a ^ b for a, b in zip(best, turning)]
            kernel = [
                [a ^ b for a, b in zip(vector, turning)] if flips(vector) else vector
                for vector in kernel
                if vector is not turning
            ]
    return best


def _made(term: Term, source: Sequence[Root], target: Sequence[Root]) -> Root:
    """tⱼs^α."""
    value = target[term.component]
    for s, e in zip(source, term.monomial):
        value = value * s**e if e else value
    return value


def _root(value: Any) -> Root:
    return root(size(value), 1, sign(value))
