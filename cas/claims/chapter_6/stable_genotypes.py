"""Lemma 6.4.1, and the codimension of a stable germ from its genotype, in Table 6.2 and just beyond."""

from __future__ import annotations

from osculant.cas.claims.chapter_6.germ_signs import AH, number
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.errors import DomainError
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.entry import instance
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.reference import reference

#: unstable germs of finite codimension, in several dimensions n and p
UNSTABLE = (
    ("u**2", "u"),
    ("u**2, u**3", "u"),
    ("x**2 + u**3", "x u"),
    ("x*u + x**2*u + x**3", "x u"),
    ("x, u**2 + x**2*u", "x u"),
    ("x, u**3 + x*u", "x u"),
    ("x, u**2, x**2*u + u**3", "x u"),
    ("x**2, u + x**3, x*u", "x u"),
    ("x**2 + y**3 + u", "x y u"),
    ("x, u + x*y + y**4", "x y u"),
    ("x, y**2 + u**2 + x**2*u", "x y u"),
    ("x, y, u**2 + (x**2 + y**2)*u", "x y u"),
    ("x, y, u**2 + y**2*u, x*u", "x y u"),
    ("x1**2 + x2**2 + x3**2 + u**2", "x1 x2 x3 u"),
    ("x1, x2, x3**2 + u**2 + (x1**2 + x2**2)*u", "x1 x2 x3 u"),
    ("x1, x2, u + (x1**2 + x2**2)*x3 + x3**3", "x1 x2 x3 u"),
    ("x1, x2, x3, u**2 + (x1**2 + x2**2 + x3**2)*u", "x1 x2 x3 u"),
)
#: genotypes of the rows of Table 6.2 that are no submersions on H, and the first ones beyond the table
GENOTYPES = (
    *(("u ± z**2 ± w**2", "z w u", 2), ("u ± z**2 + w**3", "z w u", 3), ("u**2 ± z**2 ± w**2", "z w u", 3)),
    *(("u ± z**2", "z u", 1), ("u + z**3", "z u", 2), ("u**2 ± z**2", "z u", 2), ("u ± z**4", "z u", 3)),
    *(("z*u ± z**3", "z u", 3), ("z**2 ± u**3", "z u", 3), ("u**2", "u", 1), ("u**3", "u", 2)),
    *(("u, z**2", "z u", 2), ("u**4", "u", 3), ("u ± z**2, z**3", "z u", 3), ("u**2, 0", "u", 2)),
    *(("u, z**2, 0", "z u", 3), ("u**2, 0, 0", "u", 3)),
)
BEYOND = (
    *(("u ± z**4 ± w**2", "z w u"), ("u**3 ± z**2 ± w**2", "z w u"), ("z*u ± z**3 ± w**2", "z w u")),
    *(("u + z**5", "z u"), ("u**4 ± z**2", "z u"), ("z*u + z**4", "z u"), ("z**3 + u**2", "z u")),
    *(("u ± (z**2 + w**2), z*w", "z w u"), ("u + z**2 - w**2, z*w", "z w u")),
    *(
        ("u + z**2 - w**2, z**2 + w**2", "z w u"),
        ("u**5", "u"),
        ("u, z**3", "z u"),
        ("u ± z**2, z**4", "z u"),
    ),
    *(("z*u, z**2 ± u**2", "z u"), ("u**3, 0", "u"), ("u, z**2, 0, 0", "z u"), ("u**2, 0, 0, 0", "u")),
)


@claim(
    "lemma 6.4.1",
    "cod(A(H)_e, f) = max(0, c − n + 1) with c = cod(A(H), f) finite; the form leaves out the max.",
    method=Method.EXACT,
    form="c - n + 1",
    wrong=("c - n", "c - n + 2", "c - p + 1"),
)
def extended_codimension(form: str) -> Evidence:
    """Both codimensions, each certified on its own: unstable germs with n, p ≤ 4 and all of Table 6.2."""
    germs = [Germ(text, names) for text, names in UNSTABLE]
    germs += [entry.germ() for entry in reference("table 6.2").entries]
    lines = []
    for germ in germs:
        c, e = codimension(germ, AH).value, codimension(germ, AH, extended=True).value
        line = f"{germ}, n = {germ.n}, p = {germ.p}: codimension {c}, extended {e}"
        lines.append(line)
        if c == "infinite" or e != max(0, number(form, c=c, n=germ.n, p=germ.p)):
            return Evidence(False, (line,))
    return Evidence(True, tuple(lines))


def _genotypes(text: str, names: str) -> list[Germ]:
    signs: list[tuple[int, ...]] = [()]
    for _ in range(text.count("±")):
        signs = [(*chosen, s) for chosen in signs for s in (1, -1)]
    return [Germ(instance(text, chosen, {}), names) for chosen in signs]


def _contact(germ: Germ) -> tuple[int, int]:
    """(m, d) of a genotype: its variables, and dim θ/T K(H)_e − q."""
    found = codimension(germ, "K(H)", extended=True).value
    if found == "infinite":
        raise DomainError(f"{germ} is not K(H)-finite.")
    return germ.n, found - germ.p


@claim(
    "R6.4-8",
    "A stable germ with genotype g of m variables and d = dim θ_g/T K(H)_e g − q has codimension d + m − 1.",
    method=Method.EXACT,
    form="d + m - 1",
    wrong=("d + m", "d + m - 2", "d"),
)
def codimension_of_a_genotype(form: str) -> Evidence:
    """The genotypes of Table 6.2 by the formula, against the codimensions of the rows, which are claims."""
    lines = []
    for text, names, cod in GENOTYPES:
        for germ in _genotypes(text, names):
            m, d = _contact(germ)
            line = f"{germ}: m = {m}, d = {d}, row of codimension {cod}"
            lines.append(line)
            if number(form, d=d, m=m) != cod:
                return Evidence(False, (line,))
    return Evidence(True, tuple(lines))


@claim(
    "R6.4-9",
    "The first genotypes beyond Table 6.2 (A₃ B₃ C₃; A₄ B₄ C₄ F₄, pencils; p ≥ 4) all have codimension 4.",
    method=Method.EXACT,
    form="4",
    wrong=("3", "5"),
)
def first_genotypes_beyond(form: str) -> Evidence:
    """d + m − 1 of each, which is above n − 1 = 3: by Lemma 6.4.1 they are not stable in dimension 4."""
    lines = []
    for text, names in BEYOND:
        for germ in _genotypes(text, names):
            m, d = _contact(germ)
            lines.append(f"{germ}: m = {m}, d = {d}, codimension {d + m - 1}")
            if d + m - 1 != number(form):
                return Evidence(False, (lines[-1],))
    return Evidence(True, tuple(lines))
