"""Where a reduction that fails proves that the germ is not of the form.

It does if the linear stage leaves nothing but a torus and a unipotent group: then f, fitted, is in N·t·g for
a member g of the form, and the reduction meets the same terms for f as for g. So g itself must come through,
and the coordinates must be fixed up to triangular maps by what the stage looked at.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from flint import fmpq

from osculant.cas.errors import UndecidedError
from osculant.cas.recognition.forms import Form
from osculant.cas.recognition.jets import jet_of
from osculant.cas.recognition.obstruction import NotEquivalent
from osculant.cas.recognition.pencils import is_pencil
from osculant.cas.recognition.reduction import reduced
from osculant.cas.recognition.shapes import Shape, shape
from osculant.cas.recognition.stages import starts
from osculant.cas.recognition.targets import unmoved


@lru_cache(maxsize=256)
def proves(form: Form) -> bool:
    """Whether a germ from which the reduction does not reach a form is not of the form.

    For the groups without L their linear stages answer for themselves.
    """
    if form.group.target != "left":
        return True
    return fixed_by_shape(form) and reaches_itself(form)


def reaches_itself(form: Form) -> bool:
    """Whether the reduction of a member of a form finds all its terms."""
    moduli = {name: Fraction(value) for name, value in form.entry.usual.items()}
    values = ((t.column, t.coefficient * moduli.get(t.modulus or "", 1)) for t in form.core)
    start = jet_of(((c, fmpq(v.numerator, v.denominator)) for c, v in values), form.n, form.p, form.order)
    for begun in starts(unmoved(start, form.group), form):
        try:
            _, terms = reduced(begun)
        except (NotEquivalent, UndecidedError):
            continue
        if all(terms.get(t.column) for t in form.core if t.modulus is None):
            return True
    return False


def fixed_by_shape(form: Form) -> bool:
    """Whether the linear stage of maps leaves only triangular linear maps.

    It does for one coordinate that is a component. With more of them each must stand in one family only, and
    two components that begin with the same family must have nothing else.

    >>> from osculant.cas.germs.reference import reference
    >>> from osculant.cas.recognition.forms import form
    >>> fixed_by_shape(form(reference("table 6.2")["6b"]))
    True
    >>> fixed_by_shape(form(reference("marar tari")["3_A_k"], k=2))
    False
    """
    if is_pencil(form):
        return True
    found = shape(form)
    if len(found.x) < 2:
        return len(found.z) < 2 or _one_form(form, found)
    families = found.families(form)
    mains = {family.main for family in families}
    for term in form.core:
        own = sum(term.monomial[i] for i in found.x)
        if own and sum(term.monomial) > 1 and term.column not in mains:
            return False
    slots = [family.slot for family in families]
    if len(set(slots)) < len(slots):
        return False
    begun: dict[tuple[int, ...], int] = {}
    for j in found.h:
        terms = [t for t in form.core if t.component == j]
        if not terms:
            continue
        lowest = min(terms, key=lambda t: found.weights.of(t.monomial))
        if lowest.column in mains:
            rest = tuple(0 if i in found.x else e for i, e in enumerate(lowest.monomial))
            if rest in begun and not len(terms) == begun[rest] == 1:
                return False
            begun[rest] = len(terms)
    return len(found.z) < 2 or _one_form(form, found)


def _one_form(form: Form, found: Shape) -> bool:
    """Whether the kernel of df is fixed by one quadratic form, as far as the other terms depend on it.

    At most one variable is left over by the form then, and those of several squares stand nowhere else.
    """
    squares = [t for t in form.core if sum(t.monomial) == 2 and max(t.monomial[i] for i in found.z) == 2]
    squared = [i for i in found.z if any(t.monomial[i] for t in squares)]
    elsewhere = any(t.monomial[i] for t in form.core if t not in squares for i in squared)
    one = len({t.component for t in squares}) == len(found.h) == 1
    return one and len(squared) >= len(found.z) - 1 and (len(squared) < 2 or not elsewhere)
