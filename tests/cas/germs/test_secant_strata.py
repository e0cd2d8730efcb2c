"""Secant germs of surfaces X = (x, Φ∘π) over every row π of table 6.1, Φ a random diffeomorphism."""

from __future__ import annotations

from itertools import combinations

import pytest

from osculant.cas.claims.chapter_6.secant_rows import key, signs, surface
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.reference import reference
from osculant.cas.germs.secants import secant
from osculant.cas.germs.unfolding import is_stable
from osculant.cas.recognition.recognise import recognise

ROWS = [(entry, *chosen) for entry in reference("table 6.1").entries for chosen in entry.tried()]
#: seeds for each row, and how many of them at least give generic surfaces
SEEDS, GENERIC = range(4), 3


def in_class(row, seed: int) -> bool:
    """Whether the secant germ is stable; then it is of the class of the row, by its numbers and its key.

    It is not stable where the surface is not generic: where some coefficients of Φ satisfy an equation.
    """
    entry, chosen, parameters = row
    order = entry.value("determinacy", **parameters)
    projection = entry.projected(chosen, **parameters)
    found = secant(surface(projection, 2 * order + 1, f"{entry.id} {chosen} {seed}"), order)
    if not found.settled or not is_stable(found.germ, "A(H)"):
        return False
    assert codimension(found.germ, "A(H)").value == entry.value("cod", **parameters)
    assert determinacy(found.germ, "A(H)").degree == order
    assert key(found.germ) == key(entry.germ(chosen, **parameters))
    name = recognise(entry.germ(chosen, **parameters), "A(H)").name
    assert name is not None and recognise(found.germ, "A(H)").name == name
    return True


@pytest.mark.slow
@pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row[0].called(row[1], **row[2])}")
def test_secant_germs_over_a_row_have_its_class(row):
    assert sum(in_class(row, seed) for seed in SEEDS) >= GENERIC


@pytest.mark.parametrize(
    "row", [r for r in ROWS if r[0].id in {"3-5", "4-2", "6-2"}], ids=lambda row: row[0].id
)
def test_secant_germs_over_some_rows_have_their_class(row):
    assert in_class(row, 0)


def test_the_key_tells_stable_germs_apart():
    """All rows of Table 6.2 over the complex numbers, and the real classes of quadratic forms."""
    germs = [
        (entry, entry.germ(chosen, **parameters))
        for entry in reference("table 6.2").entries
        for chosen, parameters in entry.tried()
    ]
    orbits = {germ: (germ.p, key(germ)[0]) for _, germ in germs}
    for (a, f), (b, g) in combinations(germs, 2):
        assert (orbits[f] == orbits[g]) == (a.id == b.id)
    for row, count in (("2b", 3), ("2c", 2), ("2d", 3), ("3b", 2), ("3d", 2)):
        entry = reference("table 6.2")[row]
        assert len({signs(entry.germ(chosen)) for chosen in entry.signs}) == count


def test_signs_stay_under_changes_of_coordinates():
    def sign(text: str):
        return signs(Germ(text, "x y u"))

    assert sign("x, u - y**2") == sign("x + y**2, -3*u + 2*(y + x)**2 + x*y**2") == (0, 1)
    assert sign("x, u + y**2") == sign("-x, -2*u*(1 + y) - (y - 2*x)**2 + x**2 + 5*x") == (1, 0)
    same, other = sign("x, u**2 + x*u + y**2"), sign("x, u**2 + x*u - y**2")
    assert sign("x, -4*u**2 + x*u - (y + u)**2 + 2*u*y + u**2") == same != other
    assert sign("x, y") is None is sign("x, x*y, u*y")
