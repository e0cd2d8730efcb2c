"""Germs in random dense coordinates get their names; what is on no list gets none."""

from __future__ import annotations

import pytest

from osculant.cas.errors import DomainError
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.reference import NAMES, reference
from osculant.cas.germs.search import Patience
from osculant.cas.recognition.catalogue import catalogue, listed
from osculant.cas.recognition.forms import form
from osculant.cas.recognition.names import called, printed, visible
from osculant.cas.recognition.recognise import recognise
from osculant.cas.recognition.secant_rows import secant_rows
from tests.cas.recognition.test_keys import PLACES, changed

#: degree of determinacy of the rows whose dense germs are quick, by the number of variables
SMALL = {1: 11, 2: 5, 3: 3, 4: 4, 5: 3, 6: 3}


def known(name):
    """(entry, signs, parameters) of the rows of a list for which equivalences are built, dense ones quick."""
    for entry in listed(name):
        for signs, values in entry.tried():
            if entry.value("determinacy", **values) <= SMALL[len(entry.variables)]:
                yield entry, signs, values


ROWS = [
    pytest.param(entry, signs, values, id=f"{entry.list} {entry.id} {signs} {values}")
    for name in NAMES
    if name not in {"thom", "table 6.1"}
    for entry, signs, values in known(name)
]


@pytest.mark.parametrize(("entry", "signs", "values"), ROWS[::6])
def test_some_germs_in_dense_coordinates_get_their_names(entry, signs, values):
    in_dense_coordinates(entry, signs, values)


@pytest.mark.slow
@pytest.mark.parametrize(("entry", "signs", "values"), ROWS)
def test_all_germs_in_dense_coordinates_get_their_names(entry, signs, values):
    in_dense_coordinates(entry, signs, values)


def in_dense_coordinates(entry, signs, values):
    """Asserts that the changed germ has the name of the list's."""
    germ, order = entry.germ(signs, **values), entry.value("determinacy", **values)
    other = changed(germ, entry.group, order + 1 if germ.n < 4 else order, 7 + order)
    found = recognise(other, entry.group)
    assert found.form is not None and found.equivalence is not None, found.reason
    moduli = {p.name for p in entry.parameters if p.least is None}
    row = form(entry, **{k: v for k, v in values.items() if k not in moduli})
    shared = entry.list != found.form.entry.list == catalogue(entry.group, germ.n, germ.p)[0].name
    assert (
        shared
        or found.complex.split("(")[0] == called(row, None, {k: values[k] for k in moduli}).split("(")[0]
    )
    mine = recognise(germ, entry.group)
    assert (found.name, found.equivalence.signs) == (mine.name, mine.equivalence.signs)
    assert found.equivalence.moduli == mine.equivalence.moduli


@pytest.mark.parametrize(
    ("text", "source", "name"),
    [
        ("x, y**2, y**3 - x**2*y", "x y", "S1-"),
        ("x, y**2, y**3 - x**3*y", "x y", "S2"),
        ("x, y**3 - x**3*y", "x y", "4_3"),
        ("x, y**3 - x**4*y", "x y", "4_4-"),
        ("x, x*y + y**3, x*y**2 + 5*y**4/2", "x y", "P3(5/2)"),
        ("x**4", "x", "A3"),
        ("x*y + z**2 + w**4", "x y z w", "A3"),
        ("x**2*y + y**3", "x y", "D4+"),
        ("x**3 - 3*x*y**2", "x y", "D4-"),
        ("x1, u - x2**2 - x3**2", "x1 x2 x3 u", "2b--"),
        ("x1, u - x2**2 + x3**2", "x1 x2 x3 u", "2b+-"),
        ("x, y, u**2 + x*u - z**2", "u x y z", "3d-"),
        ("x**2 - y**2 + x**3, x*y", "x y", "II2,2(1)"),
        ("y, x**2, x*y**2, x**3, 0", "x y", "6-3"),
        ("t**4, t**5 - t**7, t**11", "t", "4,5-7,11"),
        ("x**3 + y**3 + z**3 + 2*x*y*z + x**4", "x y z", "P8(2)"),
        ("(x**2 + y**2)**2 + 3*x**5", "x y", "Y5+(3)"),
        ("x, y, z**3 + (x**2 - y**2)*z", "x y z", "3(A1)+-"),
    ],
)
def test_names(text, source, name):
    found = recognise(Germ(text, source))
    assert found.name == name, found.reason


@pytest.mark.parametrize(
    ("text", "source", "group", "size"),
    [
        ("x**5 + y**5", "x y", "R", 17),  # N_16, bimodal
        ("x**3 + y**9", "x y", "R", 17),
        ("x**3 + y**10", "x y", "R", 19),
        ("x**4 + y**6", "x y", "R", 16),
        ("x**3 + u**3 + x*u**2", "x u", "R(H)", None),
        ("x**2 + y**2, z**4 + y**3", "x y z", "K", None),
        ("x**3, y**3", "x y", "K", None),
        ("x, y**2, x**4*y + y**7", "x y", "A", None),
        ("x, y**4, x*y + y**5 + y**3*x", "x y", "A", None),
        ("x, x*y + y**8 + y**10", "x y", "A", None),
        ("t**5, t**6", "t", "A", None),
        ("x1, x2, u + x3**5 + x1*x3 + x2*x3**2", "x1 x2 x3 u", "A(H)", None),
        ("x1, x2, u**4 + x3**2 + x1*u + x2*u**2", "x1 x2 x3 u", "A(H)", None),
    ],
)
def test_what_is_beyond_the_lists_has_no_name(text, source, group, size):
    found = recognise(Germ(text, source), group)
    assert (found.name, found.undecided) == (None, False), found.reason
    if size is not None:
        assert found.codimension == size == codimension(Germ(text, source), group).value
    elif found.codimension is not None:
        assert found.codimension == codimension(Germ(text, source), group).value


@pytest.mark.parametrize(
    ("text", "source", "group"),
    [
        ("x, y**3", "x y", "A"),
        ("x, y**2, 0", "x y", "A"),
        ("x**2 + y**2, x**2 + y**2", "x y", "K"),
        ("x**2*y", "x y", "R"),
        ("t**4, t**6", "t", "A"),
    ],
)
def test_infinite_codimension_is_told(text, source, group):
    found = recognise(Germ(text, source), group)
    assert (found.name, found.undecided, found.codimension) == (None, False, "infinite")
    assert found.reason.startswith("Its codimension is infinite: ")


def test_regular_germs_and_other_dimensions_have_no_list():
    assert "a diffeomorphism" in recognise(Germ("x + y, y", "x y")).reason
    assert "an immersion" in recognise(Germ("x, y, x*y", "x y")).reason
    assert "no critical point" in recognise(Germ("x + y**2", "x y")).reason
    assert "no critical point on H" in recognise(Germ("x + u**2", "x u")).reason
    assert "no list for A of germs of 5 variables" in recognise(Germ("a, b + c*d, w**2", "a b c d w")).reason
    with pytest.raises(DomainError, match=r"needs the boundary variable u of H = \{u = 0\}"):
        recognise(Germ("x, y**2", "x y"), "A(H)")


def test_without_time_it_is_undecided_and_never_a_name():
    found = recognise(Germ("x, y**2 + x**2, x**4*y + y**7 + x*y**3", "x y"), "A", Patience(0.0))
    assert (found.name, found.undecided) == (None, True)


def test_degrees_out_of_reach_are_undecided():
    found = recognise(Germ("x**100 + y**2", "x y"))
    assert (found.name, found.undecided) == (None, True) and "degree 100 is out of reach" in found.reason
    assert recognise(Germ("x**41 + y**2", "x y")).name == "A40"


def test_functions_without_an_equivalence_are_named_over_the_complex_numbers():
    found = recognise(Germ("x**3 + sqrt(2)*x*y**2", "x y"))
    assert (found.name, found.complex, found.equivalence, found.codimension) == ("D4", "D4", None, 5)
    assert found.reason.startswith("No equivalence is known: ")
    found = recognise(Germ("x**4 + sqrt(2)*x**2*y**2 + y**4 + x**5", "x y"))
    assert (found.name, found.complex) == ("X9(a)", "X9(a)")
    # a map is not named by its key alone
    found = recognise(Germ("x, y**2, y**3 + sqrt(2)*x**2*y", "x y"))
    assert (found.name, found.undecided, found.alike) == (None, True, ("S1",))


def test_the_rows_with_a_codimension_are_those_of_the_list():
    for name, n, p in PLACES:
        for listing in catalogue(name, n, p):
            for entry in listing.entries:
                for values in {tuple(v.items()): v for _, v in entry.tried()}.values():
                    size = entry.value(listing.size, **values)
                    assert any(
                        f.entry.id == entry.id and all(values[k] == v for k, v in f.integers)
                        for f in listing.forms(size, max(n, len(entry.variables)))
                    ), (entry.id, values)


def test_every_list_serves_but_those_of_other_names():
    served = {listing.name for place in PLACES for listing in catalogue(*place)}
    served |= {listing.name for listing in catalogue("A", 2, 5)}
    assert set(NAMES) - served == {"thom"}  # simple functions by other names


def test_signs_that_no_list_prints_are_seen_by_parity():
    mond = reference("mond")
    assert [visible(form(mond["C_k"], k=k)) for k in (3, 4)] == [(True,), (False,)]
    assert visible(form(reference("table 6.2")["2b"])) == (True, True)
    assert visible(form(reference("goryunov")["3"])) == (False,)
    assert printed(form(reference("unimodal functions")["X_9"]), (1, -1), {"a": "1/2"}) == (
        "x**4 - y**4 + (1/2)*x**2*y**2",
    )


def test_projections_of_table_6_1_are_determined_by_their_degree():
    for entry in listed("table 6.1"):
        germ = entry.germ()
        assert determinacy(germ, "A").degree == entry.value("determinacy")
        assert codimension(germ, "A").value == entry.value("cod")


def test_table_6_1_is_read_by_the_classes_of_table_6_2():
    rows = {p: secant_rows(p) for p in range(2, 8)}
    entries = reference("table 6.1").entries
    seen = {row for found in rows.values() for names in found.values() for row in names}
    assert len(seen) == sum(1 if e.parameters else len(e.signs) for e in entries)
    classes = {entry.id for entry in reference("table 6.2").entries}
    for found in rows.values():
        assert {name.rstrip("+-") for name in found} <= classes
    # real classes that no secant germ of a surface in space has
    assert {"2b--", "2c-", "2d++", "2d--"} & set(rows[2]) == set()
    assert "4-P3(c)" in rows[3]["3f+"] and "4-P3(c)" in rows[3]["3f-"]
