"""Table 6.1, row by row: a secant germ and the projection that belongs to it, bound to each other."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from osculant.cas.claims.chapter_6.secant_rows import DIMENSION, generic_secant, key, rows_of
from osculant.cas.claims.claim import Check, Evidence, Method, claim
from osculant.cas.errors import DomainError
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.entry import Entry
from osculant.cas.germs.reference import reference
from osculant.cas.germs.unfolding import is_stable


def _written(rows: list[Entry]) -> str:
    return " | ".join(f"{row.text}; {row.projection}" for row in rows)


@cache
def _checked(text: str, projection_text: str) -> tuple[int, int, str]:
    """(A(H)-codimension of S, A-codimension of π, what is wrong) of a row, for all its signs."""
    row = replace(reference("table 6.1").entries[0], text=text, projection=projection_text)
    if text.count("±") < projection_text.count("±"):
        return 0, 0, "π has more signs than S"
    found = set()
    for signs, parameters in row.tried():
        germ, projection = row.germ(signs, **parameters), row.projected(signs, **parameters)
        size, other = codimension(germ, "A(H)").value, codimension(projection, "A").value
        if size == "infinite" or other == "infinite":
            return 0, 0, f"the codimensions are {size} and {other}"
        found.add((size, other))
        if not is_stable(germ, "A(H)"):
            return size, other, "S is not stable"
        own = codimension(row.projected_secant(signs, **parameters), "A").value
        if own != other:
            return size, other, f"the projection that S gives has codimension {own}, and π {other}"
        order = determinacy(germ, "A(H)").degree
        assert order != "infinite"
        made = generic_secant(projection, order)
        if made is None:
            return size, other, "surfaces over π have no stable secant germ of that order"
        if key(made.germ) != key(germ):
            return size, other, "secant germs of surfaces over π are of another class"
    if len(found) > 1:
        return *found.pop(), f"its signs have the codimensions {sorted(found)}"
    return *found.pop(), ""


def _check(n: int) -> Check:
    def check(form: str) -> Evidence:
        """For each row S; π and every sign: S = f(x̄, ȳ, λ², v) is stable, and of the class of π's surfaces.

        The secant germ of X = (x, Φ∘π), Φ a random diffeomorphism, has the invariants of f: the codimensions
        of the orbits of its jets for A(H) and A, and of f|H, which tell the classes of Table 6.2 apart over
        the complex numbers, and signatures of second derivatives. The projection that S itself gives has the
        codimension of π. And the rule of the strata holds: cod S + cod π − (the least cod π in the orbit of
        S) = cod π − (n − 2) ≤ 3, the dimension of the pairs (p, w).
        """
        texts = [part.partition(";") for part in form.split("|")]
        rows = rows_of(n)
        if len(texts) != len(rows):
            raise DomainError(
                f"The form has {len(texts)} rows: give {len(rows)}, each S; π, with | between them."
            )
        evidence = Evidence(True)
        least = 0
        for (secant, _, projection), row in zip(texts, rows):
            size, other, wrong = _checked(secant.strip(), projection.strip())
            least = least if "further stratum" in row.note else other
            stratum = size + other - least
            rule = stratum == other - (n - 2) <= DIMENSION
            told = wrong or ("" if rule else "the rule of the strata fails")
            line = f"S = ({secant.strip()}): codimension {size}; π = ({projection.strip()}): {other}"
            evidence &= Evidence(not told, (f"{line}; {told or f'stratum {stratum}'}",))
        return evidence

    return check


def _exchanged(rows: list[Entry], i: int, j: int) -> str:
    """The rows with the projections of two of them exchanged."""
    pair = {i: rows[j].projection, j: rows[i].projection}
    return _written([replace(row, projection=pair.get(k, row.projection)) for k, row in enumerate(rows)])


def _with_secant(rows: list[Entry], i: int, text: str) -> str:
    """The rows with another S in one of them."""
    return _written([replace(row, text=text) if k == i else row for k, row in enumerate(rows)])


#: wrong forms by n: pairs of rows whose projections are exchanged, and (row, another S)
EXCHANGED = {
    3: ((0, 1), (5, 6)),
    4: ((1, 5), (2, 3), (6, 7)),
    5: ((1, 2), (2, 3)),
    6: ((0, 1), (1, 2)),
    7: ((0, 1),),
}
REPLACED = {
    3: ((4, "v, lambda**2 - x**2 ± y**2"), (6, "v, lambda**4 + v*lambda**2 + x**2 + y**2")),
    4: ((1, "v, x, lambda**2 + v*y + y**3"),),
    6: ((2, "v, x, y, lambda**4 + x*lambda**2, v*lambda**2"),),
    8: ((0, "v, x, y, lambda**4 + v*lambda**2, 0, 0, 0"),),
}

for _n in range(3, 9):
    claim(
        f"table 6.1-n{_n}",
        f"n = {_n}: secant germs S and projections π, row by row; every secant germ is stable.",
        method=Method.EXACT,
        form=_written(rows_of(_n)),
        wrong=(
            *(_exchanged(rows_of(_n), i, j) for i, j in EXCHANGED.get(_n, ())),
            *(_with_secant(rows_of(_n), i, text) for i, text in REPLACED.get(_n, ())),
        ),
    )(_check(_n))
