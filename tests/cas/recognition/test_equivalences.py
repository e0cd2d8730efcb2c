"""Explicit equivalences: all rows of the lists in dense coordinates, checked by substitution of lines."""

from __future__ import annotations

from fractions import Fraction

import pytest

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.reference import reference
from osculant.cas.recognition.equivalence import NotEquivalent, equivalence
from osculant.cas.recognition.forms import form
from tests.cas.recognition.disguise import check, disguised, members

#: degrees of determinacy up to which lists are tried, in the ordinary tests and in the slow ones
LISTS = {
    "table 6.2": (3, 4),
    "rieger": (5, 9),
    "mond": (4, 8),
    "klotz pop rieger": (3, 7),
    "plane curves": (9, 16),
    "space curves": (7, 11),
    "goryunov": (3, 5),
    "table 6.1": (2, 4),
}
#: forms that take more than is built
BEYOND = {"3-7", "4-P_3"}


def told(found):
    shown = [found.entry.id, *(f"{k}={v}" for k, v in found.integers)]
    return " ".join(shown)


def tried(name, seeds, most):
    for found, germ, signs, moduli in members(name, most):
        if found.entry.id in BEYOND:
            continue
        plain = equivalence(germ, found)
        for seed in range(seeds):
            moved = disguised(germ, found, f"{name} {told(found)} {signs} {moduli} {seed}")
            made = equivalence(moved, found)
            check(made, moved, seed)
            assert (made.signs, made.moduli) == (plain.signs, plain.moduli), told(found)
            assert {k: abs(Fraction(v)) for k, v in made.moduli.items()} == {
                k: abs(v) for k, v in moduli.items()
            }


@pytest.mark.parametrize("name", LISTS)
def test_every_row_in_dense_coordinates(name):
    tried(name, 1, LISTS[name][0])


@pytest.mark.slow
@pytest.mark.parametrize("name", LISTS)
def test_many_coordinates(name):
    tried(name, 2, LISTS[name][1])


def test_table_6_2_has_33_real_classes():
    spellings = set()
    for found, germ, _, _ in members("table 6.2"):
        spellings.add((found.entry.id, equivalence(germ, found).signs))
    for entry in reference("table 6.2").entries:
        classes = sum(identifier == entry.id for identifier, _ in spellings)
        assert classes == entry.value("classes"), entry.id
    assert len([s for s in spellings if s[0] != "7a"]) == 33


def strangers(name, most):
    """(germ, form of another row of the list with as many components)."""
    known = [row for row in members(name, most) if row[0].entry.id not in BEYOND]
    forms = list(dict.fromkeys(row[0] for row in known))
    for own, germ, _, _ in known:
        for other in forms:
            if other != own and other.p == own.p:
                yield own, germ, other


@pytest.mark.parametrize(
    ("name", "most"),
    [
        ("table 6.2", 4),
        ("mond", 6),
        ("rieger", 7),
        ("klotz pop rieger", 5),
        ("goryunov", 4),
        ("plane curves", 10),
        ("space curves", 8),
    ],
)
def test_other_rows_are_refused(name, most):
    for own, germ, other in strangers(name, most):
        with pytest.raises(NotEquivalent):
            found = equivalence(germ, other)
            pytest.fail(f"{told(own)} is {told(other)} with signs {found.signs}")


@pytest.mark.slow
@pytest.mark.parametrize(("name", "most"), [("table 6.2", 4), ("mond", 5), ("rieger", 6)])
def test_other_rows_are_refused_in_dense_coordinates(name, most):
    for seed, (own, germ, other) in enumerate(strangers(name, most)):
        with pytest.raises(NotEquivalent):
            found = equivalence(disguised(germ, other, seed), other)
            pytest.fail(f"{told(own)} is {told(other)} with signs {found.signs}")


@pytest.mark.parametrize(
    "text",
    [
        "x1, u + x1*x2 + x2**4 + x3**2",
        "x1, u**3 + x1*u + x2**2 + x3**2",
        "x1, u*x2 + x1*x2 + x2**3 + x3**2",
        "x1, x2, u + x1*x3 + x2*x3**2 + x3**5",
        "x1, x2, x3**2 + x1*u + x2*u**2 + u**4",
        "x1, x2, x3*u + x1*x3 + x2*x3**2 + x3**4",
        "x1, x2, x3, u**5 + x1*u + x2*u**2 + x3*u**3",
        "x1, x2, u + x1*x3, x3**3 + x2*x3**2",
        "x1, x2, x3, u**3 + x1*u, x2*u",
        "x1, x2, x3**2, u + x1*x3, x2*x3, 0",
    ],
)
def test_germs_beyond_table_6_2_are_in_no_row(text):
    germ = Germ(text, "x1 x2 x3 u")
    for found in dict.fromkeys(row[0] for row in members("table 6.2") if row[0].p == germ.p):
        with pytest.raises(NotEquivalent):
            equivalence(disguised(germ, found, text), found)


def test_moduli_are_what_scaling_leaves():
    eight = form(reference("rieger")["8"])
    made = equivalence(Germ("x, x*y + 2*y**6 + 3*y**8 + y**9", "x y"), eight)
    assert made.signs == (1,)
    # αy⁹: α = c₉s³/c₆ with s² = c₆/c₈
    assert float(made.moduli["alpha"]) == pytest.approx(0.5 * (2 / 3) ** 1.5, rel=1e-13)
    with pytest.raises(NotEquivalent, match="degenerates"):
        equivalence(Germ("x, x*y + y**3, x*y**2 + y**4", "x y"), form(reference("mond")["P_3"]))


def test_what_is_refused():
    fold = form(reference("rieger")["2"])
    with pytest.raises(NotEquivalent, match="rank"):
        equivalence(Germ("x, y", "x y"), fold)
    with pytest.raises(DomainError, match="2 variables and 2 components"):
        equivalence(Germ("x, y, 0", "x y"), fold)
    with pytest.raises(UndecidedError, match="not rational"):
        equivalence(Germ("x, sqrt(2)*y**2", "x y"), fold)
    with pytest.raises(DomainError, match="u in place 4"):
        equivalence(Germ("x1, x2", "u x1 x2 x3"), form(reference("table 6.2")["2a"]))
    with pytest.raises(NotEquivalent) as refused:
        equivalence(Germ("x, x*y + y**4", "x y"), fold)
    assert (refused.value.column, refused.value.value) == (((1, 1), 1), 1)


def test_beyond_the_determinacy_degree():
    whitney = form(reference("mond")["S_k"], k=0)
    made = equivalence(Germ("x, y**2 + x**3, y**3 + x*y + y**5", "x y"), whitney, 6)
    check(made, Germ("x, y**2 + x**3, y**3 + x*y + y**5", "x y"))


def test_squares_of_a_pencil_that_are_conjugate():
    rieger = reference("rieger")
    conjugate = Germ("x**2 + 2*y**2 + x**3, x*y + y**5", "x y")  # x ± √2·y are the lines of the squares
    with pytest.raises(UndecidedError, match="not rational"):
        equivalence(conjugate, form(rieger["I_2,2^l,m"], l=1, m=1))
    with pytest.raises(NotEquivalent, match="conjugate"):
        equivalence(conjugate, form(rieger["I_2,2^l,m"], l=1, m=2))
    with pytest.raises(NotEquivalent, match="other real type"):
        equivalence(conjugate, form(rieger["II_2,2^l"], l=1))
    turned = Germ("x**2 - 3*y**2 + x**3, x*y + 7*x**3", "x y")
    with pytest.raises(UndecidedError, match="root of index 5"):
        equivalence(turned, form(rieger["II_2,2^l"], l=1))


def test_cubes_of_a_pencil():
    x4 = form(reference("mond")["X_4"])
    two = Germ("x, y**3 + 3*x**2*y + y**4, x*y**2 - y**4", "x y")
    check(equivalence(two, x4), two)
    with pytest.raises(UndecidedError, match="cubes"):
        equivalence(Germ("x, y**3 + 6*x**2*y + y**4, x*y**2 - y**4", "x y"), x4)
    with pytest.raises(NotEquivalent, match="no two real cubes"):
        equivalence(Germ("x, y**3 - 3*x**2*y + y**4, x*y**2 - y**4", "x y"), x4)


def test_a_failure_that_proves_nothing_is_undecided():
    found = form(reference("marar tari")["3_A_k"], k=2)
    assert equivalence(Germ("x, y, z**3 + x**2*z - y**3*z", "x y z"), found).signs == (1, 1)
    with pytest.raises(UndecidedError, match="is not decided"):
        equivalence(Germ("x, y, z**3 + (x**2 + 4*x*y + 4*y**2 - y**3)*z", "x y z"), found)
