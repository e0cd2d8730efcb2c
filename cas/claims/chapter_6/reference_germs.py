"""Lists of germs in the literature: codimensions and degrees of determinacy, computed anew."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache

from osculant.cas.claims.claim import Check, Evidence, Method, claim
from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.parser import parse_constant
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.entry import Entry, Value, instance
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.reference import reference

#: name of the claim, list, value, what the numbers are, and wrong entries: (place, number)
CODIMENSIONS = (
    ("R6.4-1", "thom", "cod_e", "Thom's seven germs: codimensions for R_e", ((0, "1"), (6, "4"))),
    (
        "R6.4-2",
        "simple functions",
        "cod_e",
        "Arnold's A_k, D_k, E₆, E₇, E₈: for R_e",
        ((0, "k + 1"), (4, "7")),
    ),
    (
        "R6.4-3",
        "boundary functions",
        "cod_e",
        "Arnold's A_k, D_k, E, B_k, C_k, F₄ on a boundary: for R(H)_e",
        ((5, "k - 1"), (7, "3")),
    ),
    ("R6.4-4", "plane curves", "cod_e", "Bruce and Gaffney's curves: for A_e", ((0, "2*k"), (4, "2*k + p"))),
    ("R6.4-5", "rieger", "cod_e", "Rieger's germs of the plane to the plane: for A_e", ((2, "k"), (8, "5"))),
    ("R6.4-6", "mond", "cod_e", "Mond's germs of the plane to space: for A_e", ((0, "k + 1"), (4, "k + 1"))),
    ("R6.4-7", "klotz pop rieger", "cod", "Klotz, Pop and Rieger's to R⁴: for A", ((1, "2*k"), (3, "5"))),
    (
        "X6.4-1",
        "unimodal functions",
        "cod_e",
        "Arnold's unimodal functions: for R_e, the Milnor number",
        ((0, "7"), (3, "9 + k"), (11, "11")),
    ),
    (
        "X6.4-2",
        "unimodal functions",
        "tjurina",
        "Arnold's unimodal functions: for K_e, the Tjurina number",
        ((0, "7"), (3, "10 + k"), (11, "11"), (12, "12")),
    ),
    (
        "X6.4-3",
        "boundary functions",
        "tjurina",
        "Arnold's functions on a boundary: for K(H)_e",
        ((0, "k - 1"),),
    ),
    (
        "X6.4-4",
        "simple icis",
        "cod_e",
        "Giusti's simple points and curves: for K_e, of curves the Milnor number",
        ((0, "p + q - 1"), (2, "9"), (6, "k - 1")),
    ),
    (
        "X6.4-5",
        "space curves",
        "cod_e",
        "Gibson and Hobbs's space curves: for A_e",
        ((1, "2*k + 2*l"), (2, "k + 2*l + 1")),
    ),
    ("X6.4-6", "goryunov", "cod_e", "Rieger's germs with a square added: for A_e", ((2, "k"), (4, "1"))),
    (
        "X6.4-7",
        "marar tari",
        "cod_e",
        "Marar and Tari's germs of space to space: for A_e; of z³ + P(x, y)z the Milnor number of P",
        ((2, "k + 1"), (8, "k")),
    ),
    (
        "X6.4-8",
        "houston kirk",
        "cod_e",
        "Houston and Kirk's germs of three-space to four-space: for A_e",
        ((6, "k - 1"), (16, "j + k - 1")),
    ),
    (
        "X6.4-9",
        "cooper mond wik atique",
        "cod_e",
        "Cooper, Mond and Wik Atique's germs: for A_e",
        ((0, "0"), (19, "2")),
    ),
)
#: list, and wrong entries
DETERMINACY = (
    ("thom", ((0, "4"), (6, "5"))),
    ("simple functions", ((0, "k + 2"), (1, "k"))),
    ("unimodal functions", ((2, "5"), (3, "7 + k"))),
    ("boundary functions", ((0, "k"), (6, "k + 1"))),
    ("simple icis", ((0, "p"), (3, "k - 2"))),
    ("plane curves", ((3, "3*k + 1"), (8, "5"))),
    ("space curves", ((1, "3*k + 2"),)),
    ("rieger", ((5, "5"), (8, "11"))),
    ("goryunov", ((5, "5"),)),
    ("mond", ((0, "k + 1"), (1, "2*k"))),
    ("klotz pop rieger", ((1, "k + 2"),)),
    ("marar tari", ((7, "3"), (9, "2*k + 2"))),
    ("houston kirk", ((11, "3*k + 1"),)),
    ("cooper mond wik atique", ((0, "2"), (19, "6"))),
    ("table 6.1", ((3, "4"),)),
)
#: lists that take more than a few seconds
LONG = ("space curves", "goryunov", "marar tari", "houston kirk", "cooper mond wik atique")


@lru_cache(maxsize=64)
def _computed(name: str, key: str) -> tuple[tuple[tuple[dict[str, Value], str, int], ...], ...]:
    """Of every entry of a list: (parameters, the germ as text, its number), for all that is tried."""
    return tuple(
        tuple(
            (parameters, str(germ), _invariant(germ, entry, key))
            for signs, parameters in entry.tried()
            for germ in (entry.germ(signs, **parameters),)
        )
        for entry in reference(name).entries
    )


def _invariant(germ: Germ, entry: Entry, key: str) -> int:
    """A codimension, or a degree of determinacy that is proved to be the least."""
    if key == "determinacy":
        found = determinacy(germ, entry.group)
        if found.degree == "infinite" or not found.sharp:
            raise UndecidedError(f"No degree of determinacy of {germ} is proved to be the least.")
        return found.degree
    contact = "K(H)" if "(H)" in entry.group else "K"
    group = contact if key == "tjurina" else entry.group
    value = codimension(germ, group, extended=key != "cod").value
    if value == "infinite":
        raise DomainError(f"{germ} of {entry.list} has infinite codimension: correct the list.")
    return value


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
    """The check of one list, for a form that gives the number of each entry."""

    def check(form: str) -> Evidence:
        """T G f by exact linear algebra on jets, for every choice of signs and small parameters.

        Each codimension is certified for the germ itself, not only for a jet: the highest degree m of a
        functional that vanishes on T satisfies M^(m+1)θ ⊂ T by Nakayama's lemma or Malgrange's preparation
        theorem. Degrees of determinacy are proved by a unipotent group; that none is less is shown by a germ
        with the same jet of the degree before that is not equivalent.
        """
        found = reference(name)
        lines = []
        for entry, value in zip(found.entries, _values(form, found.entries)):
            count = 0
            for parameters, germ, computed in _computed(name, key)[found.entries.index(entry)]:
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
        slow=name in LONG,
    )(list_check(name, key))


for _list in CODIMENSIONS:
    _register_list(*_list)
for _place, (_name, _wrong) in enumerate(DETERMINACY, start=10):
    _title = reference(_name).title
    _register_list(f"X6.4-{_place}", _name, "determinacy", f"Degrees of determinacy. {_title}", _wrong)
