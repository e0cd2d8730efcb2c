"""Claims of section 3.7: the constants of both examples, and what theory puts into the tables."""

from __future__ import annotations

from typing import Any

from flint import arb

from osculant.cas.claims.chapter_3.enclosures import BITS, enclosed_constant
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import HALF_SEXTIC, SPIRAL_ARC
from osculant.cas.claims.proof import integers, rounding
from osculant.cas.numbers.balls import precision

#: tolerances 1e-1 … 1e-8 of the tables
TOLERANCES = range(1, 9)


def _rounds(value: Any, form: str) -> Evidence:
    shown, half_unit = (arb(q.numerator) / q.denominator for q in rounding(form, 6))
    return Evidence(bool(abs(value - shown) < half_unit), (f"the constant is {value.str(15)}",))


def _counts(form: str, arc: tuple[str, str, str], primitive: str, copies: int) -> Evidence:
    """copies·⌈C ε^(−1/p)⌉ in balls for the tables' tolerances, against the row claimed."""
    value, order = enclosed_constant(*arc, primitive), 4 if primitive == "parabola" else 5
    with precision(BITS):
        real = [value * arb(10**n).root(order) for n in TOLERANCES]
        counts = [copies * z.ceil().unique_fmpz() for z in real]
    line = f"{copies} × " + ", ".join(z.str(8, radius=False) for z in real)
    claimed = list(integers(form, len(TOLERANCES)))
    return Evidence(None not in counts and [int(n) for n in counts] == claimed, (line,))


@claim(
    "section 3.7.1-1",
    "The constant of (3.17) is 2.5667741 on the Archimedean spiral (t cos t, t sin t), π/6 ≤ t ≤ 2π.",
    method=Method.ENCLOSURE,
    form="2.5667741",
    wrong=("2.5667742", "2.5667740"),
)
def spiral_parabola(form: str) -> Evidence:
    """Rigorous quadrature of complex balls, rounded to the digits given."""
    return _rounds(enclosed_constant(*SPIRAL_ARC, "parabola"), form)


@claim(
    "section 3.7.1-2",
    "The constant of (3.18) is 1.269590 on the spiral.",
    method=Method.ENCLOSURE,
    form="1.269590",
    wrong=("1.269591", "1.269589"),
)
def spiral_conic(form: str) -> Evidence:
    """Rigorous quadrature of complex balls, rounded to the digits given."""
    return _rounds(enclosed_constant(*SPIRAL_ARC, "conic"), form)


@claim(
    "section 3.7.2-1",
    "The constant of (3.17) is 1.181870 on the half 0 ≤ t ≤ 3π/4 of Cayley's sextic.",
    method=Method.ENCLOSURE,
    form="1.181870",
    wrong=("1.181871", "1.181869"),
)
def cayley_parabola(form: str) -> Evidence:
    """Rigorous quadrature of complex balls, rounded to the digits given."""
    return _rounds(enclosed_constant(*HALF_SEXTIC, "parabola"), form)


@claim(
    "section 3.7.2-2",
    "The constant of (3.18) is 0.529301 on the half of Cayley's sextic.",
    method=Method.ENCLOSURE,
    form="0.529301",
    wrong=("0.529302", "0.529300"),
)
def cayley_conic(form: str) -> Evidence:
    """The same; the integrand vanishes like t^(1/5) at the sextactic point t = 0."""
    return _rounds(enclosed_constant(*HALF_SEXTIC, "conic"), form)


@claim(
    "table 3.1.1",
    "Theory's numbers of parabolas on the spiral for ε = 1e-1 … 1e-8 are as printed.",
    method=Method.ENCLOSURE,
    form="5, 9, 15, 26, 46, 82, 145, 257",
    wrong=("5, 9, 15, 26, 46, 82, 145, 256", "4, 9, 15, 26, 46, 82, 145, 257"),
)
def table_spiral_parabola(form: str) -> Evidence:
    """⌈C ε^(−1/4)⌉ with the enclosed constant."""
    return _counts(form, SPIRAL_ARC, "parabola", 1)


@claim(
    "table 3.1.2",
    "Theory's numbers of conics on the spiral for ε = 1e-1 … 1e-8 are as printed.",
    method=Method.ENCLOSURE,
    form="3, 4, 6, 9, 13, 21, 32, 51",
    wrong=("2, 4, 6, 9, 13, 21, 32, 51", "3, 4, 6, 9, 13, 21, 32, 50"),
)
def table_spiral_conic(form: str) -> Evidence:
    """⌈C ε^(−1/5)⌉ with the enclosed constant."""
    return _counts(form, SPIRAL_ARC, "conic", 1)


@claim(
    "table 3.3.1",
    "Theory's numbers of parabolas on Cayley's sextic, split at t = 0, are as printed.",
    method=Method.ENCLOSURE,
    form="6, 8, 14, 24, 44, 76, 134, 238",
    wrong=("5, 8, 14, 24, 43, 75, 133, 237",),
)
def table_cayley_parabola(form: str) -> Evidence:
    """2⌈C ε^(−1/4)⌉ with the constant of one half: the halves are mirror images."""
    return _counts(form, HALF_SEXTIC, "parabola", 2)


@claim(
    "table 3.3.2",
    "Theory's numbers of conics on Cayley's sextic, split at t = 0, are as printed.",
    method=Method.ENCLOSURE,
    form="2, 4, 6, 8, 12, 18, 28, 44",
    wrong=("4, 4, 6, 8, 12, 18, 28, 44", "2, 3, 5, 7, 11, 17, 27, 43"),
)
def table_cayley_conic(form: str) -> Evidence:
    """2⌈C ε^(−1/5)⌉ with the constant of one half."""
    return _counts(form, HALF_SEXTIC, "conic", 2)
