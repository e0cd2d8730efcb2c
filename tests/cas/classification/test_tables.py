"""Lists derived from nothing, held against the lists in print and against random germs."""

from __future__ import annotations

import random
import subprocess
import sys

import pytest

from osculant.cas.classification.classify import classified
from osculant.cas.classification.keys import Sorted, jet_codimension
from osculant.cas.classification.outline import outline
from osculant.cas.classification.texts import germ_of, germ_text
from osculant.cas.errors import DomainError
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import group
from osculant.cas.germs.reference import reference
from osculant.cas.recognition.equivalence import NotEquivalent, equivalence
from osculant.cas.recognition.forms import form

#: p: (ids of the rows of Table 6.2, real classes in all)
ROWS = {
    2: (("2a", "2b", "2c", "2d"), 9),
    3: (("3a", "3b", "3c", "3d", "3e", "3f", "3g"), 12),
    4: (("4a", "4b", "4c", "4d", "4e", "4f"), 7),
    5: (("5a", "5b", "5c"), 3),
    6: (("6a", "6b"), 2),
}

_KNOWN = {}


def found(n, p, codimension):
    if (n, p, codimension) not in _KNOWN:
        _KNOWN[n, p, codimension] = classified(n, p, "A(H)", codimension)
    return _KNOWN[n, p, codimension]


@pytest.mark.parametrize("p", ROWS)
def test_rows_of_the_table(p):
    """Each real form is equivalent, explicitly, to one member of one row, and each member is met once."""
    ids, forms = ROWS[p]
    made, table, met = found(4, p, 3), reference("table 6.2"), set()
    for orbit in made.orbits:
        names = set()
        for signs in orbit.forms:
            germ = Germ(orbit.text(signs), "x1 x2 x3 u")
            for entry in (table[i] for i in ids):
                row = form(entry)
                try:
                    same = equivalence(germ, row)
                except NotEquivalent:
                    continue
                names.add(entry.id)
                assert (entry.id, same.signs) not in met
                met.add((entry.id, same.signs))
                assert entry.value("cod") == orbit.codimension
                assert entry.value("determinacy") == orbit.determinacy.degree
                assert entry.value("classes") == len(orbit.forms)
        assert len(names) == 1
        assert orbit.apart
    assert {i for i, _ in met} == set(ids)
    assert len(met) == forms


#: (n, p, bound): by codimension, the rows of the lists in print, and the largest degree of determinacy
CLASSICAL = {
    ("bruce gaffney", 1, 2, 5): {0: [1], 2: [3], 3: [5], 4: [4, 7], 5: [5, 9]},
    ("gibson hobbs", 1, 3, 5): {0: [1], 3: [3], 5: [5]},
    ("rieger", 2, 2, 3): {0: [1], 1: [2], 2: [3], 3: [3, 4]},
    ("mond", 2, 3, 4): {0: [1], 2: [2], 3: [3], 4: [4, 5, 5]},
}


@pytest.mark.parametrize(("source", "n", "p", "bound"), CLASSICAL)
def test_classical_lists(source, n, p, bound):
    """Codimensions and degrees of determinacy of Bruce and Gaffney, Gibson and Hobbs, Rieger, and Mond."""
    made = classified(n, p, "A", bound)
    found = {}
    for orbit in made.orbits:
        found.setdefault(orbit.codimension, []).append(orbit.determinacy.degree)
    assert {c: sorted(degrees) for c, degrees in found.items()} == CLASSICAL[source, n, p, bound]
    assert made.second is None
    assert not any(f.strata for f in made.found)


@pytest.mark.parametrize("p", [*ROWS, 7])
def test_routes_agree(p):
    made = found(4, p, 3)
    second = made.second
    assert second.agrees
    assert second.classes == len(made.orbits)
    assert second.forms == sum(len(o.forms) for o in made.orbits)


@pytest.mark.parametrize(
    ("n", "p", "codimension", "classes", "strata"),
    [(2, 2, 3, 8, 2), (2, 3, 3, 3, 1), (3, 2, 3, 9, 0), (3, 4, 3, 4, 0), (5, 3, 2, 2, 0), (6, 4, 2, 2, 0)],
)
def test_other_dimensions(n, p, codimension, classes, strata):
    """Counts, the two routes as far as germs are stable, and strata less codimensional than their orbits."""
    made = found(n, p, codimension)
    assert len(made.orbits) == classes
    assert made.second.agrees
    assert made.second.codimension == min(codimension, n - 1)
    families = [s for f in made.found for s in f.strata]
    assert len(families) == strata
    assert all(s.codimension == codimension and s.moduli == 1 for s in families)


def test_boundary_singularities_adjacencies():
    """For p = 3 the genotypes are A₁ A₂ B₂ A₃ B₃ C₃; Arnold's adjacencies of functions on a boundary."""
    made = found(4, 3, 3)
    labels = {name: _kind(orbit) for name, orbit in zip(made.names, made.orbits)}
    pairs = {(labels[b], labels[a]) for b, a in made.adjacencies}
    assert pairs == {
        ("A1", "A0"),
        ("A2", "A1"),
        ("B2", "A1"),
        ("A3", "A2"),
        ("B3", "B2"),
        ("C3", "B2"),
        ("C3", "A2"),
    }


def _kind(orbit):
    """The boundary singularity by the genotype's restriction to H and its order in u."""
    r, terms = orbit.leaf.jet.rank, orbit.terms
    own = [m[r:] for m, j in terms if j >= r and not any(m[:r])]
    if not own:
        return "A0"
    on_h = min(m[0] for m in own if not m[1])
    if (0, 1) in own:
        return f"A{on_h - 1}"
    return f"C{on_h}" if (1, 1) in own else f"B{next(m[1] for m in own if not m[0])}"


@pytest.mark.parametrize(("n", "real"), [(1, 13), (2, 33), (3, 42)])
def test_simple_functions(n, real):
    """A_k, D_k, E₆, E₇: the codimension is μ + n − 1, degrees of determinacy are Arnold's."""
    made = classified(n, 1, "R", 8)
    most = 9 - n  # μ
    expected = [(0, 1), *((k + n - 1, k + 1) for k in range(1, most + 1))]
    if n > 1:
        expected += [(k + n - 1, k - 1) for k in range(4, most + 1)]  # D_k
        expected += [(k + n - 1, 4) for k in (6, 7) if k <= most]  # E_k
    assert sorted((o.codimension, o.determinacy.degree) for o in made.orbits) == sorted(expected)
    # signatures of the squares, for A_k with odd k and D_k, E₆ a sign besides; A_1 has squares only
    a = sum(n * (2 if k % 2 else 1) for k in range(2, most + 1)) + n + 1
    d = max(n - 1, 0) * 2 * len(range(4, most + 1))
    e = (n - 1) * sum(2 if k == 6 else 1 for k in (6, 7) if k <= most)
    assert sum(len(o.forms) for o in made.orbits) == 1 + a + d + e == real
    assert all(o.apart for o in made.orbits)


@pytest.mark.parametrize(
    ("name", "n", "p", "codimension"),
    [
        ("A(H)", 4, 3, 3),
        ("A(H)", 3, 2, 3),
        ("A(H)", 2, 2, 3),
        ("A(H)", 4, 4, 2),
        ("A", 2, 2, 3),
        ("A", 2, 3, 4),
        ("R", 2, 1, 8),
        ("R", 3, 1, 8),
    ],
)
def test_random_germs_are_in_the_list(name, n, p, codimension):
    """Random germs over the starts: whatever has an orbit of small codimension is found in the list."""
    draw, made = random.Random(4), classified(n, p, name, codimension)
    g, met = group(name), set()
    for f in made.found:
        lists = Sorted([(o.codimension, o, o.germ) for o in f.orbits], f.jet, f.order)
        columns = [c for c in f.jet.columns(f.order).order_of if not f.jet.fixed(c)]
        for _ in range(12):
            few = draw.sample(columns, min(len(columns), draw.randint(2, 9)))
            low = [c for c in columns if sum(c[0]) <= 3 and draw.random() < 0.3]
            chosen = {c: draw.choice((-2, -1, 1, 3)) for c in (*few, *low)}
            germ = germ_of(f.jet, [*f.jet.terms, *chosen], chosen)
            size = jet_codimension(germ, g, f.order)
            if size <= codimension:
                met.add(lists.of(size, germ).codimension)  # KeyError if there is no such class
    assert len(met) > 1


def test_every_branch_has_a_fate():
    made = found(4, 3, 3)
    lines = outline(made)
    for line, following in zip(lines, [*lines[1:], lines[0]]):
        assert (line.kind == "branch") == (following.depth == line.depth + 1)
        if line.kind == "closed":
            assert line.codimension == 4
        if line.kind == "merged":
            assert "special position" in line.fate
    assert sum(line.kind == "class" for line in lines) == len(made.orbits)


def test_no_list_is_read():
    """With the lists out of reach the answer is the same."""
    program = """
import sys, tomllib
def refuse(*args, **kwargs): raise AssertionError("a list is read")
tomllib.load = tomllib.loads = refuse
sys.modules["osculant.cas.germs.reference"] = None
import osculant
found = osculant.classify(source=4, target=5, group="A(H)", codimension=3)
print(*(", ".join(c.germ) for c in found.classes), sep="; ")
"""
    told = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    expected = [germ_text(o.leaf.jet, o.terms) for o in found(4, 5, 3).orbits]
    assert told.stdout.strip() == "; ".join(expected)


@pytest.mark.parametrize(
    ("asked", "argument"),
    [
        ((4, 3, "A(H)", 4), "codimension"),
        ((4, 3, "A(H)", -1), "codimension"),
        ((7, 3, "A(H)", 2), "source"),
        ((1, 3, "A(H)", 1), "source"),
        ((4, 8, "A(H)", 3), "target"),
        ((4, 3, "K(H)", 3), "group"),
        ((2, 1, "R", 9), "codimension"),
        ((2, 2, "R", 2), "target"),
        ((2, 2, "A", 4), "codimension"),
        ((3, 3, "A", 1), "source"),
        ((1, 4, "A", 1), "target"),
    ],
)
def test_beyond_the_reach(asked, argument):
    with pytest.raises(DomainError) as refused:
        classified(*asked)
    assert refused.value.argument == argument
    assert str(refused.value).startswith(f"{argument}: ")
