"""Explicit equivalences as certificate files, which `osculant.certificates.checker.check` checks.

Keys: ``kind`` "equivalence", ``version``, ``group``; the germ by ``components``, ``source``, ``boundary``
and ``field`` (as in files of germs; the field is the one that the changes need); ``order``; ``form``: the
normal form by ``components``, ``variables``, ``boundary``, values of its ``moduli``, and its ``list``, ``id``
and ``integers``, which nothing is proved of; ``phi``, ``psi`` with the names ``target``, ``matrix`` and
``scales`` as `osculant.certificates.check_equivalence` says; and ``determinacy``: a ``degree`` not above the
order and the ``proof`` that the germ is determined to it, as in files of germs, or null.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.expression import to_text, variable
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import Algebraic, NumberField, height
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.jets_of_maps import MapJet
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition.equivalence import Equivalence
from osculant.cas.recognition.finishing import substituted
from osculant.cas.recognition.roots import Root

if TYPE_CHECKING:
    from osculant.germs.map_germ import MapGerm


def equivalence_file(germ: MapGerm, found: Equivalence, determined: bool = True) -> dict[str, Any]:
    """An equivalence as plain data (module text).

    Args:
        germ: the germ that the equivalence is of.
        found: the equivalence.
        determined: whether to ask for a proof that the germ is determined to the order, or to less: without
            one only jets are proved to be equivalent. What is undecided is left out.

    >>> from osculant.cas.germs.reference import reference
    >>> from osculant.cas.recognition.equivalence import equivalence
    >>> from osculant.cas.recognition.forms import form
    >>> from osculant.certificates.checker import check
    >>> from osculant.germs.map_germ import germ
    >>> f = germ("x**2 + x*y + y**3", "x y")
    >>> found = equivalence(f.exact, form(reference("simple functions")["A_k"], k=1))
    >>> for sentence in check(equivalence_file(f, found)):
    ...     print(sentence)
    The jets of order 2 of (x**2 + x*y + y**3) and (x**2 - y**2) are R-equivalent over the real numbers.
    (x**2 + x*y + y**3) is 2-determined for R.
    So the germs (x**2 + x*y + y**3) and (x**2 - y**2) are R-equivalent over the real numbers.
    """
    form, names = found.form, found.form.variables
    field = germ.exact.field if found.finish is None else _named(found.finish.field, (*germ.source, *names))
    phi = found.source.polynomials()
    if found.finish is not None:
        phi = tuple(_composed(f, found.finish.images, form.n, found.order) for f in phi)
    target, psi, matrix = [f"Y{j + 1}" for j in range(form.p)], None, None
    if form.group.target == "left":
        psi = _texts(found.target.polynomials(), target, field)
    if form.group.target == "contact":
        matrix = _rows(found.target, names, form.p)
    return {
        "kind": "equivalence",
        "version": 1,
        "group": form.group.name,
        "source": list(germ.source),
        "boundary": germ.boundary if form.boundary is not None else None,
        "components": list(germ.components),
        "field": None if field is None else field.told(_bits(found)),
        "order": found.order,
        "form": _form(found, field),
        "phi": _texts(phi, names, field),
        "target": target if psi is not None else [],
        "psi": psi,
        "matrix": matrix,
        "scales": {
            "source": [_number(s, field) for s in found.scales.source],
            "target": [_number(t, field) for t in found.scales.target],
        },
        "determinacy": _determinacy(germ, found) if determined else None,
    }


def _form(found: Equivalence, field: NumberField | None) -> dict[str, Any]:
    """The member of the form that it is: terms whose modulus is 0 are left out."""
    form = found.form
    if not found.printed:
        return _rational_form(found)
    components: list[list[str]] = [[] for _ in range(form.p)]
    for term in sorted(form.terms, key=lambda t: (sum(t.monomial), [-e for e in t.monomial])):
        if term.modulus is not None and not found.moduli[term.modulus]:
            continue
        c = term.coefficient * (1 if term.sign is None else found.signs[term.sign])
        powers = [n if e == 1 else f"{n}**{e}" for n, e in zip(form.variables, term.monomial) if e]
        factors = [*([] if term.modulus is None else [term.modulus]), *powers]
        shown = "*".join(factors if abs(c) == 1 else [f"{abs(c)}", *factors])
        components[term.component].append(("- " if c < 0 else "+ ") + shown)
    texts = [" ".join(terms) or "0" for terms in components]
    integers = dict(form.integers)
    return {
        "components": [f"-{t[2:]}" if t.startswith("- ") else t.removeprefix("+ ") for t in texts],
        "variables": list(form.variables),
        "boundary": None if form.boundary is None else form.variables[form.boundary],
        "moduli": {name: _number(value, field) for name, value in found.moduli.items() if value},
        "list": form.entry.list,
        "id": form.entry.id,
        "integers": integers,
    }


def _rational_form(found: Equivalence) -> dict[str, Any]:
    """The rational normal form that it is, where the one of the list is not reached."""
    form = found.form
    components: list[Polynomial] = [{} for _ in range(form.p)]
    for (m, j), c in found.coefficients.items():
        components[j][poly.monomial(m)] = c
    return {
        "components": _texts(components, form.variables, None),
        "variables": list(form.variables),
        "boundary": None if form.boundary is None else form.variables[form.boundary],
        "moduli": {},
        "list": form.entry.list,
        "id": form.entry.id,
        "integers": dict(form.integers),
    }


def _determinacy(germ: MapGerm, found: Equivalence) -> dict[str, Any] | None:
    from osculant.germs.report import determinacy_certificate

    try:
        known = germ.determinacy(found.form.group)
    except (DomainError, UndecidedError):
        return None
    if known.degree == "infinite" or known.degree > found.order:
        return None
    return {"degree": known.degree, "proof": determinacy_certificate(germ, known)}


def _bits(found: Equivalence) -> int:
    """How narrow the interval around a root must be for bounds to show which numbers are positive."""
    roots = [*found.scales.source, *found.scales.target, *found.moduli.values()]
    sizes = [height(r.base).bit_length() for r in roots if isinstance(r, Root)]
    return 80 + 2 * max(sizes, default=0)


def _named(field: NumberField, taken: Sequence[str]) -> NumberField:
    """The field with a name of its generator that is none of these."""
    name = str(field.name)
    while name in taken:
        name += "_"
    return field if name == field.name else NumberField(field.polynomial, variable(name), field.real)


def _in(value: Any, field: NumberField | None) -> Any:
    """A number in the field as it is named."""
    return field.number(value.value) if isinstance(value, Algebraic) and field is not None else value


def _texts(components: Sequence[Polynomial], names: Sequence[str], field: NumberField | None) -> list[str]:
    return [
        to_text(as_node({m: _in(c, field) for m, c in f.items()}, tuple(names), field)) for f in components
    ]


def _rows(matrix: MapJet, names: Sequence[str], p: int) -> list[list[str]]:
    entries = _texts(matrix.polynomials(), names, None)
    return [entries[i * p : (i + 1) * p] for i in range(p)]


def _number(value: Fraction | Root, field: NumberField | None) -> Any:
    if not isinstance(value, Root):
        return str(_in(value, field))
    base = str(_in(value.base, field))
    if value.index == 1 and not isinstance(value.base, Algebraic):
        return str(value.sign * value.base)
    return {"factor": str(value.sign), "powers": [[base, str(Fraction(1, value.index))]]}


def _composed(f: Polynomial, images: Sequence[Polynomial], n: int, order: int) -> Polynomial:
    terms = substituted({(poly.exponents_of(m, n), 0): c for m, c in f.items()}, images, n, order)
    return {poly.monomial(m): c for (m, _), c in terms.items()}
