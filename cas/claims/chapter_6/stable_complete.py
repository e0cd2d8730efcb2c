"""Theorem 6.4.2 as a statement of completeness: there are no other stable germs than those of Table 6.2."""

from __future__ import annotations

from functools import lru_cache

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.classification.classify import classified
from osculant.cas.errors import DomainError
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.reference import reference
from osculant.cas.recognition.equivalence import NotEquivalent, equivalence
from osculant.cas.recognition.forms import Form, form

#: the dimensions of the targets in the table; for more the genotype is that of the immersion
TARGETS = range(2, 8)
#: a germ of four variables is stable if and only if its orbit has at most this codimension (lemma 6.4.1)
LARGEST = 3


@claim(
    "theorem 6.4.2.2",
    "A stable germ R⁴ → Rᵖ, p = 2, …, 7, is A(H)-equivalent to a germ of one row of Table 6.2.",
    method=Method.EXACT,
    form="2a 2b 2c 2d, 3a 3b 3c 3d 3e 3f 3g, 4a 4b 4c 4d 4e 4f, 5a 5b 5c, 6a 6b, 7a",
    wrong=(
        "2a 2b 2c 2d, 3a 3b 3c 3d 3e 3f, 4a 4b 4c 4d 4e 4f, 5a 5b 5c, 6a 6b, 7a",
        "2a 2b 2c, 3a 3b 3c 3d 3e 3f 3g, 4a 4b 4c 4d 4e 4f, 5a 5b 5c, 6a 6b, 7a",
        "2a 2b 2c 2d, 3a 3b 3c 3d 3e 3f 3g, 4a 4b 4c 4d 4e 4f 3g, 5a 5b 5c, 6a 6b, 7a",
        "2a 2b 2c 2d, 3a 3b 3c 3d 3e 3f 3g, 4a 4b 4c 4d 4e 4f, 5a 5b, 6a 6b, 7a",
    ),
)
def complete(text: str) -> Evidence:
    """All orbits of codimension at most 3, classified from nothing, each in a row by an explicit equivalence.

    The tree of complete transversals over every 1-jet is complete over ℂ, and its real forms over ℝ
    (`osculant.cas.classification`); no list is read for it. A germ of R⁴ is stable if and only if its orbit
    has at most codimension 3. Each real form of an orbit is taken to a germ of exactly one row by changes of
    coordinates, verified by substitution, and the rows that are met are those of the form, for each p.
    """
    claimed = [sorted(part.split()) for part in text.split(",")]
    if len(claimed) != len(TARGETS):
        raise DomainError(f"{text!r} has {len(claimed)} parts: write the rows for each p from 2 to 7.")
    holds, lines = True, []
    for p, rows in zip(TARGETS, claimed):
        orbits, met = _met(p)
        found = sorted({row for few in met for row in few})
        holds = holds and all(len(few) == 1 for few in met) and found == rows
        lines.append(f"p = {p}: orbits {orbits}, real forms {len(met)}, in the rows {' '.join(found)}")
    return Evidence(holds, tuple(lines))


@lru_cache(maxsize=len(TARGETS))
def _met(p: int) -> tuple[int, list[tuple[str, ...]]]:
    """How many orbits there are, and for each real form of one the rows that have it."""
    forms = [form(entry) for entry in reference("table 6.2").entries if entry.id.startswith(str(p))]
    orbits = classified(4, p, "A(H)", LARGEST).orbits
    germs = [orbit.text(signs) for orbit in orbits for signs in orbit.forms]
    return len(orbits), [_rows(Germ(germ, "x1 x2 x3 u"), forms) for germ in germs]


def _rows(germ: Germ, forms: list[Form]) -> tuple[str, ...]:
    """The rows that have a germ equivalent to this one."""
    found = []
    for row in forms:
        try:
            equivalence(germ, row)
        except NotEquivalent:
            continue
        found.append(row.entry.id)
    return tuple(found)
