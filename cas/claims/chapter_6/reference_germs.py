"""Lists of germs in the literature: their codimensions, computed for small parameters and all signs."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from osculant.cas.claims.claim import Check, Evidence, Method, claim
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_constant
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.reference import Entry, instance, reference

#: name of the claim, list, value, what the numbers are, and wrong entries: (place, number)
LISTS = (
    ("R6.4-1", "thom", "cod_e", "Thom's seven germs: codimensions for R_e", ((0, "1"), (6, "4"))),
    (
        "R6.4-2",
        "simple functions",
        "cod_e",
        "Arnold's A_k, D_k, E₆, E₇, E₈: for R_e",
        ((0, "k + 1"), (4, "7")),
    ),
    ("R6.4-3", "boundary functions", "cod_e", "Arnold's B_k, C_k, F₄: for R(H)_e", ((0, "k - 1"), (2, "3"))),
    ("R6.4-4", "plane curves", "cod_e", "Bruce and Gaffney's curves: for A_e", ((0, "2*k"), (9, "8"))),
    ("R6.4-5", "rieger", "cod_e", "Rieger's germs of the plane to the plane: for A_e", ((2, "k"), (8, "5"))),
    ("R6.4-6", "mond", "cod_e", "Mond's germs of the plane to space: for A_e", ((0, "k + 1"), (4, "k + 1"))),
    ("R6.4-7", "klotz pop rieger", "cod", "Klotz, Pop and Rieger's to R⁴: for A", ((1, "6"), (3, "5"))),
)


def _values(form: str, entries: Sequence[Entry]) -> list[str]:
    values = [part.strip() for part in form.split(",")]
    if len(values) != len(entries):
        raise DomainError(f"{form!r} has {len(values)} numbers: write {len(entries)}, one for each germ.")
    return values


def _number(value: str, parameters: dict[str, object]) -> Fraction:
    """A value for these parameters, or for none if it is a number."""
    texts = {name: f"({text})" for name, text in parameters.items()}
    return Fraction(parse_constant(instance(value, None, texts)).value)


def list_check(name: str, key: str) -> Check:
    """The check of one list, for a form that gives the codimension of each entry."""

    def check(form: str) -> Evidence:
        """T G f by exact linear algebra on jets, for every choice of signs and small parameters.

        Each number is certified for the germ itself, not only for a jet: the highest degree m of a functional
        that vanishes on T satisfies M^(m+1)θ ⊂ T by Nakayama's lemma or Malgrange's preparation theorem.
        """
        found = reference(name)
        lines = []
        for entry, value in zip(found.entries, _values(form, found.entries)):
            count = 0
            for signs, parameters in entry.tried():
                germ = entry.germ(signs, **parameters)
                computed = codimension(germ, entry.group, extended=key == "cod_e").value
                if computed != _number(value, dict(parameters)):
                    return Evidence(False, (f"{entry.id}, {germ}: {computed} instead of {value}",))
                count += 1
            lines.append(f"{entry.id}, {entry.text}: {value} ({count} germs)")
        return Evidence(True, (*lines, found.source))

    return check


def _replaced(values: Sequence[str], place: int, value: str) -> str:
    return ", ".join(value if i == place else v for i, v in enumerate(values))


def _register_list(number: str, name: str, key: str, what: str, wrong: Sequence[tuple[int, str]]) -> None:
    values = [entry.values[key] for entry in reference(name).entries]
    claim(
        number,
        f"{what}.",
        method=Method.EXACT,
        form=", ".join(values),
        wrong=[_replaced(values, *one) for one in wrong],
    )(list_check(name, key))


for _list in LISTS:
    _register_list(*_list)
