"""Normal forms of the lists: all rows are read, and written out again they are the germs of the lists."""

from __future__ import annotations

from fractions import Fraction

import pytest

from osculant.cas.errors import DomainError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.reference import NAMES, reference
from osculant.cas.recognition.equivalence import equivalence
from osculant.cas.recognition.forms import form, stabilised, widened
from osculant.cas.recognition.roots import root
from tests.cas.recognition.disguise import check


def written(found, signs, moduli):
    """The components of a member of a form."""
    components = [{} for _ in range(found.p)]
    for t in found.terms:
        value = t.coefficient * (1 if t.sign is None else signs[t.sign])
        value *= 1 if t.modulus is None else Fraction(moduli[t.modulus])
        if value:
            components[t.component][poly.monomial(t.monomial)] = value
    return components


@pytest.mark.parametrize("name", NAMES)
def test_a_form_is_the_germ_of_its_row(name):
    for entry in reference(name).entries:
        for signs, parameters in entry.tried():
            moduli = {p.name for p in entry.parameters if p.least is None}
            found = form(entry, **{k: v for k, v in parameters.items() if k not in moduli})
            jet = entry.germ(signs, **parameters).jet(40)
            values = {k: Fraction(v) for k, v in parameters.items() if k in moduli}
            assert written(found, signs, values) == list(jet), entry.id
            assert found.order == entry.value("determinacy", **parameters)


def test_squares_are_added_and_dropped():
    cusp = form(reference("simple functions")["A_k"], k=3)
    more = stabilised(cusp, 4)
    assert (more.n, more.signs, len(more.terms)) == (4, 4, 4)
    assert {t.monomial: t.sign for t in more.terms} == {
        (4, 0, 0, 0): 0,
        (0, 2, 0, 0): 1,
        (0, 0, 2, 0): 2,
        (0, 0, 0, 2): 3,
    }
    assert stabilised(more, 2).terms == cusp.terms
    assert stabilised(more, 2).signs == 2
    with pytest.raises(DomainError, match="no superfluous square"):
        stabilised(form(reference("simple functions")["E_6"]), 1)
    with pytest.raises(DomainError, match="only functions"):
        stabilised(form(reference("mond")["F_4"]), 3)


def test_forms_are_equal_by_row_and_integers():
    rieger = reference("rieger")
    assert form(rieger["4_k"], k=3) == form(rieger["4_k"], k=3)
    assert len({form(rieger["4_k"], k=3), form(rieger["4_k"], k=3), form(rieger["4_k"], k=2)}) == 2
    with pytest.raises(DomainError):
        form(rieger["4_k"], k=1)


def test_roots_are_canonical():
    assert root(8, 6) == root(2, 2)
    assert root(Fraction(1, 8), 3).rational == Fraction(1, 2)
    assert (root(2, 2) * root(3, 3)) ** 6 == root(72)
    assert float(-root(2 * 10**400, 4)) == pytest.approx(-(2**0.25) * 1e100, rel=1e-12)
    assert (-root(5, 3)) ** -3 == root(Fraction(1, 5), 1, -1)
    with pytest.raises(DomainError):
        root(-2, 2)


def test_immersions_into_higher_dimensions():
    seven = form(reference("table 6.2")["7a"])
    nine = widened(seven, 9)
    assert (nine.p, nine.terms, nine == seven) == (9, seven.terms, False)
    germ = Germ("x2 + u, x1, x3 - x1**2, u, x1*u, x3*x2, x1 + x2, 0, u*x3", "x1 x2 x3 u")
    check(equivalence(germ, nine), germ)
    with pytest.raises(DomainError, match="no immersion"):
        widened(form(reference("table 6.2")["6b"]), 7)
