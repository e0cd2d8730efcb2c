"""The classification for n = 4, p = 3: the 1-jets (6.1), Proposition 6.4.3 and its proof."""

from __future__ import annotations

import sympy as sp

from osculant.cas.claims.chapter_6.germ_signs import AH, VARIABLES, germs_of, number, real_class, reflected
from osculant.cas.claims.claim import Check, Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.expansion import expanded
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import GROUPS, Version, group
from osculant.cas.germs.reference import reference
from osculant.cas.germs.tangent_space import independent_columns, tangent
from osculant.cas.germs.transversal import transversal
from osculant.cas.germs.unfolding import is_stable


def orbit_codimension(germ: Germ, k: int, name: str = "A(H)") -> int:
    """The codimension of the orbit of the k-jet in the k-jets."""
    return tangent(germ, group(name), Version.ORDINARY, k).codimension


@claim(
    "(6.1)",
    "The orbits of 1-jets R⁴ → R³ of codimension at most 3 are those of (x₁,x₂,x₃), (x₁,x₂,u), (x₁,x₂,0).",
    method=Method.EXACT,
    form="x1, x2, x3; x1, x2, u; x1, x2, 0",
    wrong=("x1, x2, x3; x1, x2, u", "x1, x2, x3; x1, x2, u; x1, x2, 0; x1, u, 0", "x1, x2, x3; x1, u, 0"),
)
def one_jets(form: str) -> Evidence:
    """A 1-jet is Ax + bu; A(H) changes A to PAQ, b to c·Pb + Av with c > 0: classes (rank A, b ∈ im A).

    The codimension of each class is that of the tangent space of its representative.
    """
    wanted = {str(Germ(part, VARIABLES)) for part in form.split(";")}
    small, lines = set(), []
    for rank in range(4):
        for outside in (False, True) if rank < 3 else (False,):
            parts = [f"x{i + 1}" for i in range(rank)] + ["u"] * outside
            germ = Germ(", ".join([*parts, "0", "0", "0"][:3]), VARIABLES)
            cod = orbit_codimension(germ, 1)
            lines.append(f"{germ}: codimension {cod}")
            if cod <= 3:
                small.add(str(germ))
    return Evidence(small == wanted, tuple(lines))


PRINTED_LIST = (
    "x1, x2, x3; x1, x2, u ± x3**2; x1, x2, u + x1*x3 + x3**3; x1, x2, u + x1*x3 + x2*x3**2 ± x3**4; "
    "x1, x2, x3**2 + x1*u ± u**2; x1, x2, x3**2 + x1*u + u**3 + x2*u**2; "
    "x1, x2, x3*u + x1*x3 + x3**3 + x2*x3**2"
)
LIST = PRINTED_LIST.replace("+ u**3", "± u**3").replace("*x3 + x3**3 + x2", "*x3 ± x3**3 + x2")


@claim(
    "proposition 6.4.3",
    "The stable germs R⁴ → R³ are the seven of the list, with both signs of u³ and of x₃³.",
    method=Method.EXACT,
    form=LIST,
    printed=PRINTED_LIST,
    wrong=(LIST.replace("± u**3", "+ u**3"), LIST.replace("± u**2", "± x2*u**2"), LIST.rsplit(";", 1)[0]),
    erratum="The signs of u³ and of x₃³ are missing: over the real numbers the two signs differ.",
)
def stable_germs_to_space(form: str) -> Evidence:
    """Each is stable of codimension at most 3; with f also f(x, −u) has its real class in the list.

    The real classes of the rows of Table 6.2 with p = 3, told apart by codimension and invariants, must be in
    it too. That there are no others rests on the transversals and orbits below and on R6.4-9.
    """
    parts = form.split(";")
    germs = [germ for part in parts for germ in germs_of(part)]
    for germ in germs:
        if not is_stable(germ, AH):
            return Evidence(False, (f"{germ}: not stable",))
    cods = [codimension(germ, AH).value for germ in germs]
    lines = [f"{germ}: stable, codimension {cod}" for germ, cod in zip(germs, cods)]
    listed = {(cod, real_class(germ)) for germ, cod in zip(germs, cods)}
    mirrored = [germ for part in parts for germ in reflected(part)]  # u → −u keeps the codimension
    needed = [(cod, germ) for germ, cod in zip(mirrored, cods)]
    for entry in reference("table 6.2").entries:
        if entry.id.startswith("3"):
            needed += [(entry.value("cod"), germ) for germ in germs_of(entry.text)]
    missing = [germ for cod, germ in needed if (cod, real_class(germ)) not in listed]
    if missing:
        return Evidence(False, (*lines, f"missing: the real class of {missing[0]}"))
    return Evidence(
        True, (*lines, f"{len(listed)} real classes, closed under u → −u, all those of Table 6.2")
    )


def transversal_check(text: str, k: int) -> Check:
    """The check of a complete transversal over a k-jet, for a form that lists its terms."""

    def check(form: str) -> Evidence:
        """H^(k+1) ⊂ T + (L·f) ∩ H^(k+1), L the Lie algebra of A(H)₁, with no term of T too many.

        (L·f) ∩ H has as its annihilator the functionals that vanish on L·f, restricted to H: T is complete if
        they have the same rank on T as on all of H, and minimal if that is the number of its terms.
        """
        germ = Germ(text, VARIABLES)
        found = tangent(germ, AH, Version.UNIPOTENT, k + 1)
        columns = {
            found.space.term(c): c for c in range(found.space.columns) if found.space.degree(c) == k + 1
        }
        names = tuple(VARIABLES.split())
        terms = []
        for f in expanded(parse_tuple(form, names), names, k + 1):
            (m, *others) = f or (0,)
            if others or (m, germ.p - 1) not in columns:
                raise DomainError(f"{form!r} must list monomials of degree {k + 1}.")
            terms.append(columns[m, germ.p - 1])

        def rank(kept: set[int]) -> int:
            cut = [{c: v for c, v in f.items() if c in kept} for f in found.annihilator.functionals]
            return len(independent_columns(cut))

        whole, own = rank(set(columns.values())), rank(set(terms))
        computed = transversal(germ, k, AH)
        line = (
            f"over {germ}: {whole} dimensions of degree {k + 1} are left, {len(terms)} terms span {own}; the "
            f"transversal computed has {len(computed)} terms"
        )
        return Evidence(whole == own == len(set(terms)) == len(terms) == len(computed), (line,))

    return check


#: (the jet, its degree, the transversal in the last component, wrong ones)
TRANSVERSALS = (
    ("u", 1, "x3**2, x1*x3, x2*x3", ("x3**2, x1*x3", "x3**2, x1*x3, x1*x2", "x3**2, x1*x3, x2*x3, x3*u")),
    (
        "0",
        1,
        "x3**2, x1*x3, x2*x3, x3*u, x1*u, x2*u, u**2",
        ("x3**2, x1*x3, x2*x3, x3*u, x1*u, x2*u", "x3**2, x1*x3, x2*x3, x3*u, x1*u, x2*u, x1*x2"),
    ),
    ("u + x1*x3", 2, "x3**3, x2*x3**2", ("x3**3", "x3**3, x1*x3**2", "x3**3, x2**2*x3")),
    ("x3**2 + x1*u", 2, "u**3, x2*u**2", ("u**3", "u**3, x1*u**2", "u**3, x3*u**2")),
    ("x3*u + x1*x3", 2, "x3**3, x2*x3**2", ("x3**3", "x3**3, x1*x3**2", "x3**3, u*x3**2")),
)
#: (the degree of the jets, what they are, their last components, the codimensions, wrong ones)
ORBITS = (
    (2, "over (x₁, x₂, u)", ("u + x3**2", "u + x1*x3", "u"), "1, 2, 4", ("1, 2, 3", "0, 2, 4")),
    (3, "over u + x₁x₃", ("u + x1*x3 + x3**3", "u + x1*x3 + x2*x3**2", "u + x1*x3"), "2, 3, 4", ("2, 3, 3",)),
    (4, "over u + x₁x₃ + x₂x₃²", ("u + x1*x3 + x2*x3**2 + x3**4", "u + x1*x3 + x2*x3**2"), "3, 4", ("3, 3",)),
    (2, "over (x₁, x₂, 0)", ("x3**2 + x1*u + u**2", "x3**2 + x1*u", "x3*u + x1*x3"), "2, 3, 3", ("2, 2, 3",)),
)


def orbits_check(k: int, components: tuple[str, ...]) -> Check:
    """The check of the codimensions of orbits of k-jets (x₁, x₂, f₃), for a form that lists them."""

    def check(form: str) -> Evidence:
        """The rank of T A(H)f modulo M^(k+1), exactly."""
        found = [orbit_codimension(Germ(f"x1, x2, {f}", VARIABLES), k) for f in components]
        lines = tuple(f"{f}: codimension {c} in the {k}-jets" for f, c in zip(components, found))
        return Evidence([number(part) for part in form.split(",")] == found, lines)

    return check


for _i, (_f, _k, _form, _wrong) in enumerate(TRANSVERSALS, start=1):
    claim(
        f"proposition 6.4.3-{_i}",
        f"In its proof: over (x₁, x₂, {_f}) these terms of degree {_k + 1} are a complete transversal.",
        method=Method.EXACT,
        form=_form,
        wrong=_wrong,
    )(transversal_check(f"x1, x2, {_f}", _k))
for _i, (_k, _where, _components, _form, _wrong) in enumerate(ORBITS, start=len(TRANSVERSALS) + 1):
    claim(
        f"proposition 6.4.3-{_i}",
        f"In its proof: the orbits of {_k}-jets {_where} have codimension {_form}.",
        method=Method.EXACT,
        form=_form,
        wrong=_wrong,
    )(orbits_check(_k, _components))


@claim(
    "proposition 6.4.3-10",
    "In its proof: the other 1-jets are in the closure of the A(H)-orbit of (x₁, u, 0), of codimension 4.",
    method=Method.EXACT,
    form="A(H)",
    printed="A",
    wrong=("R(H)", "K"),
    erratum="The closure is printed as that of the orbit of (x₁, u, 0) under A, of codimension 2.",
)
def remaining_one_jets(form: str) -> Evidence:
    """The codimension of that orbit of 1-jets, under the group that the form names."""
    if form not in GROUPS:
        raise DomainError(f"{form!r} is no group: choose one of {', '.join(GROUPS)}.")
    found = orbit_codimension(Germ("x1, u, 0", VARIABLES), 1, form)
    return Evidence(found == 4, (f"(x1, u, 0) has codimension {found} for {form} in the 1-jets",))


@claim(
    "proposition 6.4.3-11",
    "In its proof: x₃ → x₃ − bu/2 makes x₃² + au² + bx₃u + cx₁u to x₃² + (a − b²/4)u² + cx₁u.",
    method=Method.PROOF,
    form="x3 - b*u/2",
    printed="x2 - b*u/2",
    wrong=("x3 - b*u", "x3 + b*u/2"),
    erratum="The substitution is printed as x₃ → x₂ − bu/2, and its result with x₃ for x₃².",
)
def completing_the_square(form: str) -> Evidence:
    """The quadratic form with the substitution, expanded."""
    a, b, c, x1, x2, x3, u = sp.symbols("a b c x1 x2 x3 u", real=True)
    new = read(form, {"x2": x2, "x3": x3, "b": b, "u": u})
    value = new**2 + a * u**2 + b * new * u + c * x1 * u
    return vanishes(value - (x3**2 + c * x1 * u + (a - b**2 / 4) * u**2), "the new quadratic form")


@claim(
    "proposition 6.4.3-12",
    "In its proof: (x₁, x₂, x₃² + x₁u ± u²) has codimension 2.",
    method=Method.EXACT,
    form="x3**2 + x1*u ± u**2",
    printed="x3 ± u**2",
    wrong=("x3**2 ± u**2", "x3**2 + x1*u ± u**3"),
    erratum="The orbits are printed as (x₁, x₂, x₃ ± u²), which is a submersion on H.",
)
def quadratic_orbits(form: str) -> Evidence:
    """The codimension of the orbits of 2-jets, and of the germs themselves where they are stable."""
    found = [
        (orbit_codimension(germ, 2), is_stable(germ, AH) and codimension(germ, AH).value)
        for germ in germs_of(f"x1, x2, {form}")
    ]
    lines = tuple(f"codimension {jet} in the 2-jets, of the germ {own or 'not finite'}" for jet, own in found)
    return Evidence(all(pair == (2, 2) for pair in found), lines)
