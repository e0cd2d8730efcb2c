"""Keys separate the lists, and no change of coordinates alters them."""

from __future__ import annotations

import random
from collections import defaultdict
from itertools import combinations

import pytest

from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import group
from osculant.cas.germs.jets_of_maps import map_jet
from osculant.cas.recognition.catalogue import catalogue
from osculant.cas.recognition.forms import form
from osculant.cas.recognition.keys import key, part, parts
from osculant.cas.recognition.names import called
from tests.cas.recognition.disguise import diffeomorphism

#: a group with dimensions of germs, for every list
PLACES = [
    ("R", 3, 1),
    ("K", 2, 1),
    ("R(H)", 3, 1),
    ("K(H)", 3, 1),
    ("K", 2, 2),
    ("K", 3, 2),
    ("A", 1, 2),
    ("A", 1, 3),
    ("A", 2, 2),
    ("A", 2, 3),
    ("A", 2, 4),
    ("A", 2, 5),
    ("A", 2, 6),
    ("A", 3, 2),
    ("A", 3, 3),
    ("A", 3, 4),
    ("A", 1, 1),
    ("A", 4, 4),
    ("A", 4, 3),
    *(("A(H)", 4, p) for p in range(2, 8)),
]


def rows(name, n, p):
    """(listing, form, member, codimension in its key) for small integers and some moduli."""
    for listing in catalogue(name, n, p):
        for entry in listing.entries:
            moduli = {q.name for q in entry.parameters if q.least is None}
            for signs, values in entry.tried():
                if -1 not in signs:
                    integers = {k: v for k, v in values.items() if k not in moduli}
                    germ = entry.germ(signs, **values)
                    yield listing, form(entry, **integers), germ, entry.value(listing.size, **values)


def settled(germ, g, size):
    """The first order in which the codimension is that."""
    order = 2
    while part(germ, g, "orbit", order)[-1] < size or part(germ, g, "orbit", order)[-2] < size:
        order += 1
        assert order < 30
    assert part(germ, g, "orbit", order)[-1] == size
    return order


@pytest.mark.parametrize(("name", "n", "p"), PLACES)
def test_classes_with_one_codimension_have_different_keys(name, n, p):
    g, by_size = group(name), defaultdict(list)
    for _, row, germ, size in rows(name, n, p):
        by_size[size].append((row, germ, settled(germ, g, size)))
    assert by_size
    for some in by_size.values():
        for (row, germ, order), (other, member, longer) in combinations(some, 2):
            if called(row, None, None) == called(other, None, None):
                continue  # one class over ℂ, or one family
            k = max(order, longer)
            assert any(part(germ, g, t, k) != part(member, g, t, k) for t in parts(germ, g)), (row, other)


def changed(germ, name, order, seed):
    draw = random.Random(seed)
    u = germ.boundary_index if germ.boundary is not None else None
    f = map_jet(germ.jet(order), germ.n, order).compose(diffeomorphism(draw, germ.n, order, u))
    if name.startswith("A"):
        f = diffeomorphism(draw, germ.p, order).compose(f)
    return Germ([as_node(c, germ.source) for c in f.polynomials()], germ.source, germ.boundary)


@pytest.mark.parametrize(
    ("text", "source", "name"),
    [
        ("x, y**2, y**3 + x**2*y", "x y", "A"),
        ("x, x*y + y**3, x*y**2 + 2*y**4", "x y", "A"),
        ("x**2 + y**3, y**2 + x**3", "x y", "A"),
        ("t**3, t**4", "t", "A"),
        ("x**3 + x*y**3", "x y", "R"),
        ("x*y + u**2 + y**3", "x y u", "R(H)"),
        ("x*u + x**3", "x u", "K(H)"),
        ("x**2 + y*z, x*y + z**3", "x y z", "K"),
        ("x1, x2, x3**2 + x1*u + x2*u**2 + u**3", "x1 x2 x3 u", "A(H)"),
        ("x, x*y + y**2*z + y**4, z", "x y z", "A"),
    ],
)
@pytest.mark.parametrize("seed", [1, 2])
def test_no_change_of_coordinates_alters_a_key(text, source, name, seed):
    germ, order = Germ(text, source), 4
    other = changed(germ, name, order + 2, seed)
    mine, theirs = key(germ, name, order), key(other, name, order)
    assert mine.parts["orbit"][-1] > 0
    counted = {"double points"}  # of a germ, not of its jet
    assert {k: v for k, v in mine.parts.items() if k not in counted} == {
        k: v for k, v in theirs.parts.items() if k not in counted
    }


def test_squares_do_not_alter_the_key_of_a_function():
    for text in ("x**3 + y**4", "x**3 + x**2*y**2 + 2*y**7", "x**4 + y**5"):
        one, more = Germ(text, "x y"), Germ(f"{text} - z**2 + x*w + w**2", "x y z w")
        assert key(one, "R", 6) != key(Germ("x**3 + y**5", "x y"), "R", 6)
        plain = Germ(f"{text} - z**2 + w**2", "x y z w")
        assert key(one, "R", 6) == key(plain, "R", 6)
        assert key(more, "R", 6) == key(changed(more, "R", 8, 3), "R", 6)


def test_a_key_is_told_with_group_and_order():
    found = key(Germ("x, y**2", "x y"), "a", 3)
    assert (found.group, found.order, found.parts["algebra"]) == ("A", 3, (1, 2, 2, 2))
    assert len({found, key(Germ("x, y**2 + x**2", "x y"), "A", 3)}) == 1
