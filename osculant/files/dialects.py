"""What controllers of machines take: the words around the motions of a G-code program."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from osculant.cas.errors import DomainError
from osculant.files.writing import listed

LINE_LENGTH = 100  # of comments
UNITS = {"mm": "G21", "inch": "G20"}
#: feed rates if none is given, in units a minute; without units one that is slow in both
FEEDS = {"mm": 600.0, "inch": 24.0, None: 24.0}


@dataclass(frozen=True)
class Dialect:
    """G-code as a controller takes it.

    Attributes:
        comment: what a comment begins and ends with.
        modes: words before the motions: distances absolute, of centres relative, feeds in units a minute.
        end: the last line.
        mismatch: the difference of radii that is accepted, in millimetres.
        longest: the number of characters in a line that is not a comment.
        one_word: whether a line has one command only.
    """

    comment: tuple[str, str]
    modes: tuple[str, ...]
    end: str
    mismatch: Fraction
    longest: int
    one_word: bool = False


#: by the names of controllers; LinuxCNC's limit is 2√2/100 mm and grbl's 1/200 mm, Marlin has none
DIALECTS = {
    "linuxcnc": Dialect(("(", ")"), ("G17", "G90", "G91.1", "G94"), "M2", Fraction(28, 1000), 255),
    "grbl": Dialect(("(", ")"), ("G17", "G90", "G91.1", "G94"), "M2", Fraction(5, 1000), 79),
    "marlin": Dialect((";", ""), ("G90",), "M400", Fraction(5, 1000), 95, one_word=True),
}


def dialect_of(name: str) -> Dialect:
    """The dialect of that name; raises DomainError if there is none.

    >>> dialect_of("grbl").end
    'M2'
    """
    if name not in DIALECTS:
        raise DomainError(f"The dialect {name!r} of G-code is unknown: choose {listed([*DIALECTS], 'or')}.")
    return DIALECTS[name]


def mismatch_in_units(dialect: Dialect, units: str | None, decimals: int) -> Fraction:
    """The mismatch that the controller accepts, in last units; without units, of inches."""
    length = dialect.mismatch if units == "mm" else dialect.mismatch / Fraction(254, 10)
    return length * Fraction(10**decimals)


def program_text(
    dialect: Dialect, facts: Sequence[str], units: str | None, lines: Sequence[str], planes: bool
) -> str:
    """A whole program.

    Args:
        dialect: of the controller.
        facts: for comments at the head.
        units: "mm", "inch" or None.
        lines: the motions.
        planes: whether they have arcs in other planes than XY.

    Raises:
        DomainError: lines that are longer than the controller takes.
    """
    longest = max(map(len, lines))
    if longest > dialect.longest:
        raise DomainError(
            f"The controller takes lines of {dialect.longest} characters and the program has one of "
            f"{longest}: give fewer decimals."
        )
    words = [*dialect.modes, *([] if units is None else [UNITS[units]])]
    if planes and "G17" not in words:
        words.insert(0, "G17")
    modes = words if dialect.one_word else [" ".join(words)]
    comments = [line for fact in facts for line in _comment(fact, dialect)]
    return "\n".join([*comments, *modes, *lines, dialect.end, ""])


def _comment(fact: str, dialect: Dialect) -> list[str]:
    """A fact as comments; their text can hold neither parentheses nor semicolons nor what is not ASCII."""
    text = fact.replace("(", "[").replace(")", "]").replace(";", ",")
    text = re.sub(r"[^ -~]", "?", text)
    before, after = dialect.comment
    return [f"{before}{line}{after}" for line in textwrap.wrap(text, LINE_LENGTH)]
