"""The name of a class: as the list spells it, with the signs that tell real classes apart and no others.

A sign that a change of signs of coordinates removes is left out: S1+ and S1− are two real classes, S2 is one.
Over ℂ all signs are left out. A sign between two exponents is + then.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from osculant.cas.formulas.expression import to_text
from osculant.cas.germs.germ import Germ
from osculant.cas.recognition.forms import Form, Term

_BRACES = re.compile(r"\{([^{}]*)\}")


def called(form: Form, signs: Sequence[int] | None, moduli: Mapping[str, Any] | None) -> str:
    """The name of a member of a form.

    Args:
        form: the row of its list.
        signs: those of the text, normalised so that a real class has one spelling; None for the name over ℂ.
        moduli: the values of the moduli, or None for their names.

    >>> from osculant.cas.germs.reference import reference
    >>> from osculant.cas.recognition.forms import form
    >>> mond, rieger = reference("mond"), reference("rieger")
    >>> [called(form(mond["S_k"], k=k), (1,), {}) for k in (1, 2)], called(form(mond["P_3"]), (), {"c": 2})
    (['S1+', 'S2'], 'P3(2)')
    >>> called(form(rieger["II_2,2^l"], l=2), None, None)
    'I2,2(2,2)'
    """
    entry = form.entry
    seen = visible(form)
    template = entry.complex if signs is None and entry.complex else entry.name
    first, *rest = template.split("±")
    text = first
    for i, part in enumerate(rest):
        if signs is not None and seen[i]:
            text += "+" if signs[i] > 0 else "-"
        elif part[:1].isdigit() or part.startswith("{"):
            text += "+"  # it parts two exponents
        text += part
    values: dict[str, Any] = dict(form.integers)
    values |= {name: name if moduli is None else moduli[name] for name in form.moduli}
    return _BRACES.sub(lambda found: _value(found[1], values), text)


def printed(
    form: Form, signs: Sequence[int] | None = None, moduli: Mapping[str, Any] | None = None
) -> tuple[str, ...]:
    """The components of a member of a form as text; without signs and moduli, ± and names stand there.

    >>> from osculant.cas.germs.reference import reference
    >>> from osculant.cas.recognition.forms import form
    >>> s1 = form(reference("mond")["S_k"], k=1)
    >>> printed(s1), printed(s1, (-1,), {})[2]
    (('x', 'y**2', 'y**3 ± x**2*y'), 'y**3 - x**2*y')
    """
    entry = form.entry
    named = form.variables == entry.variables and not entry.even
    if signs is not None and moduli is not None and named and all(map(_plain, moduli.values())):
        text = entry.formula(tuple(signs), **dict(form.integers), **moduli)
        return tuple(map(to_text, Germ(text, entry.variables, entry.boundary).components))
    components: list[str] = [""] * form.p
    for term in sorted(form.terms, key=_place):
        value = term.coefficient
        if term.modulus is not None and moduli is not None and not moduli[term.modulus]:
            continue
        sign = "+" if value > 0 else "-"
        if term.sign is not None:
            sign = "±" if signs is None else "+" if signs[term.sign] * value > 0 else "-"
        factors = [] if abs(value) == 1 else [str(abs(value))]
        if term.modulus is not None:
            shown = term.modulus if moduli is None else str(moduli[term.modulus])
            factors.append(f"({shown})" if re.search(r"[-/+]", shown) else shown)
        factors += [f"{x}**{e}" if e > 1 else x for x, e in zip(form.variables, term.monomial) if e]
        before = components[term.component]
        components[term.component] = (
            f"{before} {sign} {'*'.join(factors)}"
            if before
            else ("" if sign == "+" else sign) + "*".join(factors)
        )
    return tuple(text or "0" for text in components)


def _plain(value: Any) -> bool:
    return isinstance(value, Fraction) and value != 0


def _place(term: Term) -> tuple[bool, bool, list[int]]:
    return term.modulus is not None, term.sign is not None, [-e for e in term.monomial]


def sign_names(form: Form) -> dict[int, str]:
    """The first monomial that each ± governs, by the place of the ±.

    >>> from osculant.cas.germs.reference import reference
    >>> from osculant.cas.recognition.forms import form
    >>> sign_names(form(reference("table 6.2")["2b"]))
    {0: 'x2**2', 1: 'x3**2'}
    """
    found: dict[int, str] = {}
    for term in form.terms:
        if term.sign is not None and term.sign not in found:
            powers = [f"{x}**{e}" if e > 1 else x for x, e in zip(form.variables, term.monomial) if e]
            found[term.sign] = "*".join(powers)
    return dict(sorted(found.items()))


def _value(formula: str, values: Mapping[str, Any]) -> str:
    """A modulus as it is, or the value of a formula in the integers."""
    from osculant.cas.formulas.parser import parse_constant
    from osculant.cas.germs.entry import instance

    if formula in values:
        return str(values[formula])
    texts = {name: f"({value})" for name, value in values.items() if isinstance(value, int)}
    return str(parse_constant(instance(formula, None, texts)).value)


def visible(form: Form) -> tuple[bool, ...]:
    """For every ± of a form whether it tells real classes apart, once the first that can be + are.

    Changes of signs of coordinates, not of u, that keep the terms without a ± turn others; a term with a
    modulus may turn, its modulus turns too.

    >>> from osculant.cas.germs.reference import reference
    >>> from osculant.cas.recognition.forms import form
    >>> [visible(form(reference("rieger")["4_k"], k=k)) for k in (2, 3)]
    [(True,), (False,)]
    """
    size = form.n + form.p
    kept: list[int] = []  # vectors modulo 2 as the bits of a number
    turned: dict[int, int] = {}
    for term in form.terms:
        row = _row(form, term)
        if term.modulus is not None:
            continue
        if term.sign is None:
            kept.append(row)
        elif term.sign in turned:
            kept.append(row ^ turned[term.sign])
        else:
            turned[term.sign] = row
    if form.boundary is not None:
        kept.append(1 << form.boundary)
    if form.group.target == "none":
        kept += [1 << form.n + j for j in range(form.p)]
    flips = [
        sum(1 << i for i, row in turned.items() if (row & vector).bit_count() % 2)
        for vector in _kernel(kept, size)
    ]
    pinned = set(_leading(flips))
    return tuple(i in turned and i not in pinned for i in range(form.signs))


def _row(form: Form, term: Term) -> int:
    found = 1 << form.n + term.component
    for i, e in enumerate(term.monomial):
        found |= (e & 1) << i
    return found


def _kernel(rows: Sequence[int], size: int) -> list[int]:
    """A basis of the vectors orthogonal to all rows modulo 2."""
    basis = [1 << i for i in range(size)]
    for row in rows:
        odd = [v for v in basis if (row & v).bit_count() % 2]
        even = [v for v in basis if not (row & v).bit_count() % 2]
        basis = even + [v ^ odd[0] for v in odd[1:]]
    return basis


def _leading(vectors: Sequence[int]) -> list[int]:
    """The lowest bits of an echelon form."""
    found: dict[int, int] = {}
    for vector in vectors:
        while vector:
            low = (vector & -vector).bit_length() - 1
            if low not in found:
                found[low] = vector
                break
            vector ^= found[low]
    return list(found)
