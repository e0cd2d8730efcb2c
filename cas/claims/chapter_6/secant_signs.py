"""Remark 6.3.2 (2): real classes of stable germs R⁴ → R² that no secant germ of a surface in R³ has."""

from __future__ import annotations

from typing import Any

from osculant.cas.claims.chapter_6.secant_rows import key, rows_of, signs
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.even import halve
from osculant.cas.germs.reference import reference
from osculant.cas.germs.secants import chord

#: the monomials of a surface z = g(x, y) that the 2-jets of its secants know: where f|H has rank 1, x² and xy
#: are not among them
CUBIC = {(3, 0), (2, 1), (1, 2), (0, 3)}


def _quadratic() -> dict[tuple[int, ...], set[tuple[int, ...]]]:
    """For u, and for each monomial of degree 2 in x̄, ȳ alone, the cubic monomials x^i y^j that give it."""
    found: dict[tuple[int, ...], set[tuple[int, ...]]] = {}
    for m in sorted(CUBIC):
        for term in halve(chord({poly.monomial(m): 1}, 2), 2, 4):
            exponents = poly.exponents_of(term, 4)
            if exponents == (0, 0, 1, 0) or (sum(exponents) == 2 == exponents[0] + exponents[1]):
                found.setdefault(exponents, set()).add(m)
    return found


def _possible(found: Any) -> bool:
    """Whether a secant germ may have these signatures; see the check below."""
    if isinstance(found, tuple):
        return bool(found[0] > 0)
    return all(on_boundary not in {(2, 0), (0, 2)} for _, on_boundary in found)


@claim(
    "remark 6.3.2.2",
    "For n = 3 these real classes of Table 6.2 are those of no secant germ; all others are.",
    method=Method.EXACT,
    form="2b--, 2c-, 2d++, 2d--",
    wrong=("2b--, 2c-, 2d++", "2b++, 2c-, 2d++, 2d--", "2b--, 2c+, 2d++, 2d--", "2b--, 2c-, 2d+-, 2d--"),
)
def impossible_signs(form: str) -> Evidence:
    """Signatures of second derivatives, which f = (v, S) must have where f|H has rank 1, against the list's.

    Then x² and xy do not occur in g, and a x³ is all that gives u and x̄²: a(u + 3x̄²)/4. For a ≠ 0 the form
    on H divided by the u-coefficient has 3 at x̄² and a positive eigenvalue; for a = 0 it is 0 at x̄², so not
    definite. The other classes have rows in Table 6.1, those that surfaces make.
    """
    chords = _quadratic()
    alone = chords[0, 0, 1, 0] == chords[2, 0, 0, 0] == {(3, 0)}
    cube = halve(chord({poly.monomial((3, 0)): 4}, 2), 2, 4)
    ratio = {poly.monomial((0, 0, 1, 0)): 1, poly.monomial((2, 0, 0, 0)): 3} == cube
    lines = [f"x³ gives (u + 3x̄²)/4: {ratio}; no other cubic monomial gives u or x̄²: {alone}"]
    made = set()
    for row in rows_of(3):
        for chosen, parameters in row.tried():
            made.add(key(row.germ(chosen, **parameters)))
    impossible, realised = [], True
    for entry in reference("table 6.2").entries:
        for chosen in entry.signs if entry.id.startswith("2") else ():
            germ = entry.germ(chosen)
            name = entry.id + "".join("+" if s > 0 else "-" for s in chosen)
            found = signs(germ)
            if found is not None and not _possible(found):
                impossible.append(name)
                lines.append(f"{name}: signatures {_told(found)}")
            else:
                realised &= key(germ) in made
    claimed = [part.strip() for part in form.split(",")]
    return Evidence(alone and ratio and realised and impossible == claimed, tuple(lines))


def _told(found: Any) -> str:
    if isinstance(found, tuple):
        return f"{found} on H"
    return " or ".join(f"{whole}, {on_boundary} on H" for whole, on_boundary in sorted(found))
