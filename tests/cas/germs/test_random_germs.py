"""Random dense changes of coordinates of every germ of the lists: the record, a sample, and others."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.germ import Germ
from tests.random_germs import DEGREE, Change, cases, difference, moved, recorded, summary, terms, tried

RECORD = Path(__file__).parents[2] / "data" / "random-germs.txt"
COUNT = len(cases())
#: terms of the jets of a germ that takes a tenth of a second
FEW = 100
#: terms of the jets of a germ that takes some seconds
LARGE = 500
#: changes that the record has not: of some germs with few terms, and of every third that is not larger
SAMPLE = [COUNT + place for place, case in enumerate(cases()) if terms(case) <= FEW][::10]
MANY = [2 * COUNT + place for place, case in enumerate(cases()) if terms(case) <= LARGE][::3]


def test_the_germs_of_the_lists_stand_in_the_record_with_their_numbers():
    rows = recorded(RECORD)
    seeds = [int(row[0]) for row in rows]
    assert Counter(row[1] for row in rows) == {"same": len(rows)}
    for seed, row in zip(seeds, rows):
        case = cases()[seed]
        assert row[3] == case.name(Change(seed, 1).signs(case))
    assert summary(RECORD).startswith(f"{len(rows)} germs: {len(rows)} same; ")
    assert seeds == list(range(COUNT))


@pytest.mark.parametrize("seed", SAMPLE)
def test_a_sample(seed):
    line = tried(seed)
    assert line.split()[1] == "same", line


@pytest.mark.slow
@pytest.mark.parametrize("seed", MANY)
def test_many(seed):
    line = tried(seed)
    assert line.split()[1] == "same", line


@pytest.mark.parametrize(
    ("text", "source", "group"), [("x**2*y + y**4, x", "x y", "A"), ("x + u**2", "x u", "R(H)")]
)
def test_changes_are_dense_invertible_and_keep_the_boundary(text, source, group):
    germ, change = Germ(text, source), Change(5, 9)
    images = change.source(germ, "(H)" in group)
    everything = {m for m in poly.monomials(2, DEGREE) if m}
    for i, (name, image) in enumerate(zip(germ.source, images)):
        kept = {m for m in everything if name != "u" or poly.exponents_of(m, 2)[i]}
        assert set(image) <= kept and {m for m in kept if poly.degree_of(m, 2) > 1} <= set(image)
    x, y = poly.variable(0, 2), poly.variable(1, 2)
    rows = [[f.get(m, 0) for m in (x, y)] for f in images]
    assert rows[0][0] * rows[1][1] != rows[0][1] * rows[1][0]
    denominators = {c.denominator for f in images for m, c in f.items() if poly.degree_of(m, 2) > 1}
    assert denominators == {1, 2, 3}


def test_another_germ_is_told():
    case, _, germ = moved(next(s for s, c in enumerate(cases()) if c.entry.list == "mond"))
    assert difference(case, germ) == ""
    other = next(c for c in cases() if c.entry.list == "mond" and c.value("cod_e") == 3)
    assert difference(other, germ).startswith("cod ")
