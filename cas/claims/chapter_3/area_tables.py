"""Tables 3.2 and 3.4: what theory says of the number of pieces for the symmetric difference distance."""

from __future__ import annotations

from flint import arb

from osculant.cas.claims.chapter_3.areas import ORDERS, constant_of
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import HALF_SEXTIC, SPIRAL_ARC
from osculant.cas.claims.proof import integers
from osculant.cas.numbers.balls import PRECISION, precision

#: tolerances 1e-1 … 1e-6 of the tables
TOLERANCES = range(1, 7)
REASON = "the constants come from a quadrature whose error is estimated; no count is within 1e-3 of changing."


def _counts(form: str, example: tuple[str, str, str], primitive: str, copies: int) -> Evidence:
    """copies·⌈C ε^(−1/(p − 1))⌉ with ε for each copy, against the row claimed."""
    claimed = integers(form, len(TOLERANCES))
    with precision(PRECISION):
        value = constant_of(example, primitive)
        real = [value * (arb(10) ** n).root(ORDERS[primitive] - 1) for n in TOLERANCES]
        counts = tuple(copies * int(z.ceil().unique_fmpz()) for z in real)
    line = f"{copies} × " + ", ".join(z.str(8, radius=False) for z in real)
    return Evidence(counts == claimed, (line,))


@claim(
    "table 3.2.1",
    "Theory's numbers of parabolas on the spiral for areas ε = 1e-1 … 1e-6 are as printed.",
    method=Method.NUMERICAL,
    reason=REASON,
    form="9, 15, 26, 46, 82, 146",
    wrong=("9, 15, 26, 46, 82, 145", "8, 15, 26, 46, 82, 146"),
)
def spiral_parabolas(form: str) -> Evidence:
    """⌈C ε^(−1/4)⌉ with the constant of (3.25)."""
    return _counts(form, SPIRAL_ARC, "parabola", 1)


@claim(
    "table 3.2.2",
    "Theory's numbers of conics on the spiral for areas ε = 1e-1 … 1e-6 are as printed.",
    method=Method.NUMERICAL,
    reason=REASON,
    form="4, 6, 9, 13, 21, 33",
    wrong=("4, 6, 9, 13, 21, 32", "3, 6, 9, 13, 21, 33"),
)
def spiral_conics(form: str) -> Evidence:
    """⌈C ε^(−1/5)⌉ with the constant of (3.26)."""
    return _counts(form, SPIRAL_ARC, "conic", 1)


@claim(
    "table 3.4.2",
    "Theory's numbers of parabolas on Cayley's sextic are as printed if the area ε is granted to each half.",
    method=Method.NUMERICAL,
    reason=REASON,
    form="6, 12, 20, 34, 60, 108",
    wrong=("8, 14, 24, 40, 72, 128", "6, 12, 20, 34, 60, 107"),
)
def sextic_parabolas(form: str) -> Evidence:
    """2⌈C ε^(−1/4)⌉ with the constant of one half. With ε/2 for each half it were 8, 14, 24, 40, 72, 128."""
    return _counts(form, HALF_SEXTIC, "parabola", 2)


@claim(
    "table 3.4.3",
    "Theory's numbers of conics on Cayley's sextic are as printed if the area ε is granted to each half.",
    method=Method.NUMERICAL,
    reason=REASON,
    form="4, 4, 6, 10, 16, 24",
    wrong=("4, 6, 8, 12, 18, 26", "4, 4, 6, 10, 16, 22"),
)
def sextic_conics(form: str) -> Evidence:
    """2⌈C ε^(−1/5)⌉ with the constant of one half."""
    return _counts(form, HALF_SEXTIC, "conic", 2)
