"""Table 6.2: the stable germs R⁴ → Rᵖ for A(H), row by row, and how many real classes they are."""

from __future__ import annotations

from osculant.cas.claims.chapter_6.germ_signs import germs_of, real_class, reflected, up_to_signs
from osculant.cas.claims.claim import Check, Evidence, Method, claim
from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs.codimension import codimension, contact_bound
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.entry import Entry
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import group
from osculant.cas.germs.reference import reference
from osculant.cas.germs.unfolding import is_stable

AH = group("A(H)")
#: the targets of the table that are counted
TARGETS = range(2, 7)
#: what is wrong in print, by row
ERRATA = {
    "3a": "The third component of the first row for n = 3 is printed as x₂ instead of x₃.",
    "3f": "The sign of x₃³ is missing: over the real numbers the two signs differ.",
    "3g": "The last row for n = 3 prints x₃² + x₁u ± u², which is 3d of codimension 2, instead of 3g.",
}
#: germs near those of the table that are not what a row claims
NEAR_MISSES = {
    "2a": ("x1, x1", "x1, x2**2", "x1, u"),
    "2b": ("x1, u ± x2**2 + x3**3", "x1, u + x2**2 + x3**2", "x1, u**2 ± x2**2 ± x3**2"),
    "2c": ("x1, u ± x3**2 + x2**3", "x1, u + x1*x2 + x3**2 + x2**3", "x1, u + x1*x2 ± x3**2 + x2**4"),
    "2d": ("x1, u**2 ± x2**2 ± x3**2", "x1, u**2 + x1*u + x2**2 ± x3**2", "x1, u**3 + x1*u ± x2**2 ± x3**2"),
    "3a": ("x1, x2, u", "x1, x2, x3**2"),
    "3b": ("x1, x2, u - x3**2", "x1, x2, u ± x3**3", "x1, x2, u ± x3"),
    "3c": ("x1, x2, u + x3**3", "x1, x2, u + x1*x3 + x3**2"),
    "3d": ("x1, x2, u**2 + x1*u + x3**2", "x1, x2, u**2 + x1*u", "x1, x2, u**2 + x1*u ± x3"),
    "3e": ("x1, x2, u + x1*x3 + x2*x3**2 + x3**4", "x1, x2, u + x1*x3 + x2*x3**2 ± x3**3"),
    "3f": ("x1, x2, x3*u + x1*x3 + x2*x3 ± x3**3", "x1, x2, x3*u + x1*x3 + x2*x3**2 ± x3**2"),
    "3g": ("x1, x2, x3**2 + x1*u + x2*u**2 + u**3", "x1, x2, x3**2 + x1*u ± u**3"),
    "4a": ("x1, x2, x3, u**2", "x1, x2, x3, u*x1"),
    "4b": ("x1, x2, x3, u**2", "x1, x2, x3, x1*u"),
    "4c": ("x1, x2, x3, u**3 + x1*u + x2*u", "x1, x2, x3, u**2 + x1*u + x2*u**2"),
    "4d": ("x1, x2, u + x1*x3, x3**3", "x1, x2, u, x3**2"),
    "4e": ("x1, x2, x3, u**3 + x1*u + x2*u**2 + x3*u**3", "x1, x2, x3, u**4 + x1*u + x2*u**2 + x3*u"),
    "4f": ("x1, x2, u + x3**2, x1*x3 + x3**3 + x2*x3**2", "x1, x2, u ± x3**2, x1*x3 + x3**3"),
    "5a": ("x1, x2, x3, u**2, 0", "x1, x2, x3, 0, 0"),
    "5b": ("x1, x2, x3, u**2 + x1*u, x1*u", "x1, x2, x3, u**2, x1*u"),
    "5c": ("x1, x2, x3**2, u + x1*x3, x1*x3", "x1, x2, x3**2, u, x2*x3"),
    "6a": ("x1, x2, x3, u**2, 0, 0",),
    "6b": ("x1, x2, x3, u**2 + x1*u, x2*u, x1*u", "x1, x2, x3, u**2, x2*u, x3*u"),
    "7a": ("x1, x2, x3, u**2, 0, 0, 0",),
}


def _same_as_the_table(germ: Germ, entry: Entry) -> Evidence:
    """Codimensions, stability, l and the sharp degree of one germ against those of a row."""
    wanted = [entry.value(name) for name in ("cod", "cod_e", "bound", "determinacy")]
    if not is_stable(germ, AH):  # first, since it is quick
        return Evidence(False, (f"{germ}: not stable, T K(H)_e f + constants is not everything",))
    bound = contact_bound(germ, AH)
    found = [codimension(germ, AH).value, codimension(germ, AH, extended=True).value, bound]
    degree = determinacy(germ, AH)
    found.append(degree.degree)
    fields = ", ".join(degree.fields) or "none"
    line = (
        f"{germ}: codimension {found[0]}, extended {found[1]}, stable, "
        f"M^{bound}θ ⊂ T K(H)_e, {degree.degree}-determined (nilpotent fields used: {fields}), "
        f"{'sharp: ' if degree.sharp else ''}{degree.reason}"
    )
    return Evidence(found == wanted and bool(degree.sharp), (line,))


def check_of(entry: Entry) -> Check:
    """The check of a row of the table, for a formula of its germs."""

    def check(form: str) -> Evidence:
        """T A(H)f by exact linear algebra on jets, for every choice of the signs.

        The codimension is exact since M^(m+1)θ ⊂ T + M^(K+1)θ with K ≥ m + l, where M^lθ ⊂ T K(H)_e f.
        Stable: θ = T K(H)_e f + constants (Mather). k-determined: M^(k+1)θ ⊂ T Uf + M^(k+l+1)θ for a
        unipotent U; sharp since the (k − 1)-jet has another codimension. The signs must make as many real
        classes as the row has, and f(x, −u), which is equivalent over the complex numbers, must be among
        them.
        """
        germs = germs_of(form)
        evidence = Evidence(True)
        for germ in germs:
            evidence &= _same_as_the_table(germ, entry)
            if not evidence:
                return evidence
        classes = {real_class(germ) for germ in germs}
        missing = [str(germ) for germ in reflected(form) if real_class(germ) not in classes]
        counted = f"{len(classes)} real class{'es' * (len(classes) > 1)}"
        line = f"{counted}; {f'missing: that of {missing[0]}' if missing else 'closed under u → −u'}"
        right = len(classes) == entry.value("classes") and not missing
        return evidence & Evidence(right, (line,))

    return check


def _register(entry: Entry) -> None:
    cod, degree = entry.value("cod"), entry.value("determinacy")
    target = " for p ≥ 7" if entry.id == "7a" else ""
    claim(
        f"table 6.2-{entry.id}",
        f"({entry.text}) is A(H)-stable{target}, of codimension {cod}, and exactly {degree}-determined.",
        method=Method.EXACT,
        form=entry.text,
        printed=entry.printed,
        wrong=NEAR_MISSES[entry.id],
        erratum=ERRATA.get(entry.id, ""),
    )(check_of(entry))


for _entry in reference("table 6.2").entries:
    _register(_entry)


@claim(
    "theorem 6.4.2",
    "The rows of Table 6.2 for p = 2, …, 6 are 33 real classes: 9 + 12 + 7 + 3 + 2.",
    method=Method.EXACT,
    form="9, 12, 7, 3, 2",
    wrong=("10, 12, 7, 3, 2", "9, 10, 7, 3, 2", "9, 12, 6, 3, 2", "9, 12, 7, 3, 3"),
)
def real_classes(form: str) -> Evidence:
    """For each row an upper and a lower bound of the number of classes of its signs, which agree.

    Upper: sign choices that become the same under x_i → ±x_j and y_i → ±y_j. Lower: invariants of the
    genotype g under K(H) with u → uk, k > 0 (signatures of its second derivatives, half-branches of g = 0 in
    u > 0 and u < 0, the sign of u in the local algebra). Rows for the same p differ by codimension, l, degree
    of determinacy, rank or one of these invariants.
    """
    try:
        claimed = [int(part) for part in form.split(",")]
    except ValueError:
        raise DomainError(f"{form!r} is no list of numbers: write one for each p from 2 to 6.") from None
    counts, lines = [], []
    for p in TARGETS:
        rows = [entry for entry in reference("table 6.2").entries if entry.id[0] == str(p)]
        total, seen = 0, set()
        for entry in rows:
            germs = germs_of(entry.text)
            lower = {(_row_key(entry, germ), real_class(germ)) for germ in germs}
            if len(lower) != len({up_to_signs(germ) for germ in germs}):
                raise UndecidedError(f"The signs of row {entry.id} are not all told apart.")
            total += len(lower)
            seen |= lower
        if len(seen) != total:
            raise UndecidedError(f"Two rows for p = {p} are not told apart.")
        counts.append(total)
        lines.append(f"p = {p}: {total} classes in {len(rows)} rows")
    return Evidence(counts == claimed, (*lines, f"{sum(counts)} classes in all"))


def _row_key(entry: Entry, germ: Germ) -> tuple[int, ...]:
    return (germ.rank, *(entry.value(name) for name in ("cod", "bound", "determinacy")))


@claim(
    "theorem 6.4.2.1",
    "For two signs ε₁, ε₂ (2b and 2d) only (+1, −1) and (−1, +1) are equivalent.",
    method=Method.EXACT,
    form="(+-) ~ (-+)",
    wrong=("(++) ~ (--)", "(++) ~ (+-)", "(--) ~ (-+)"),
)
def equivalent_signs(form: str) -> Evidence:
    """Exchanging x₂ and x₃ identifies the mixed signs; the invariants of the other pairs differ.

    A form names one pair of sign choices; it must be the only pair with the same normal form under sign
    changes and permutations, and the only one with the same invariants.
    """
    names = ("++", "+-", "-+", "--")
    sides = [part.strip().strip("()") for part in form.split("~")]
    if len(sides) != 2 or not set(sides) <= set(names):
        raise DomainError(f"{form!r} is no pair of signs: write for instance (+-) ~ (-+).")
    holds, lines = True, []
    for row in ("2b", "2d"):
        germs = dict(zip(names, germs_of(reference("table 6.2")[row].text)))
        pairs = [(a, b) for i, a in enumerate(names) for b in names[i + 1 :]]
        same = {(a, b) for a, b in pairs if up_to_signs(germs[a]) == up_to_signs(germs[b])}
        alike = {(a, b) for a, b in pairs if real_class(germs[a]) == real_class(germs[b])}
        holds = holds and same == alike == {(sides[0], sides[1])}
        found = ", ".join(f"({a}) ~ ({b})" for a, b in sorted(same))
        lines.append(f"{row}: {found}; the other pairs differ in an invariant" * (same == alike))
    return Evidence(holds, tuple(lines))
