"""Claims of section 3.7: the constants of both examples, and what theory puts into the tables."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any

from flint import acb, arb

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integers, rounding
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.laws.table import law_of
from osculant.cas.numbers.balls import ball, constant, precision
from osculant.cas.numbers.taylor import program

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
CAYLEY = "4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)"
HALF = (CAYLEY, "0", "3/4*pi")
#: closed forms of the invariants of Cayley's sextic, proved by claims of section 3.7.2; narrow in balls
CLOSED = {
    CAYLEY: {
        "parabolic_form": "20480/81*cos(t/3)^6*(16 + 14*cos(2*t/3))",
        "sextactic_form": "36700160/729*sin(t/3)*cos(t/3)^9*(5 + 4*cos(2*t/3))",
        "inflection_form": "64/3*cos(t/3)^4",
        "speed_squared": "16*cos(t/3)^4",
    }
}
#: tolerances 1e-1 … 1e-8 of the tables
TOLERANCES = range(1, 9)
#: bits and tolerance of the quadrature, and where it begins (of 1, before the power) at a sextactic end
BITS, ACCURACY, START = 64, "1e-10", "0.01"


class ComplexBalls:
    """The field of flint's complex balls, for formulas of sin and cos."""

    def number(self, value: Fraction) -> Any:
        """A rational number."""
        return acb(value.numerator) / value.denominator

    def constant(self, name: str) -> Any:
        """pi or e."""
        return acb.pi() if name == "pi" else acb(1).exp()

    def function(self, name: str) -> Any:
        """flint's entire or meromorphic function of that name; raises DomainError for others."""
        if name not in {"sin", "cos", "sinh", "cosh", "exp"}:
            raise DomainError(f"{name} is not continued to complex numbers here.")
        return getattr(acb, name)

    def power(self, base: Any, exponent: Fraction) -> Any:
        """Raises DomainError: roots have branches."""
        raise DomainError(f"The power {exponent} is not continued to complex numbers here.")


@cache
def enclosed_constant(text: str, low: str, high: str, primitive: str) -> Any:
    """The leading constant of (3.17) or (3.18) over an arc without special points inside: a ball.

    flint integrates (|n|/9)^(1/4) D^(−1/4) v^(−1/4) or (|m|/27)^(1/5) D^(−2/5) v^(−1/5), the integrands in
    the forms of `PlaneJet` with v = |α̇|, as analytic functions with a rigorous error. Where m vanishes at
    the first end, t = low + length·u⁵, and the piece below u = `START` is enclosed by its largest value.

    >>> print(enclosed_constant("t*cos(t), t*sin(t)", "pi/6", "2*pi", "parabola").str(8, radius=False))
    2.5667741
    """
    order, leading, cut = (4, 1, "0") if primitive == "parabola" else (5, 2, START)
    name = "parabolic_form" if order == 4 else "sextactic_form"
    closed = CLOSED.get(text)
    formulas = (
        text if closed is None else f"{closed[name]}, {closed['inflection_form']}, {closed['speed_squared']}"
    )
    compiled = program(parse_tuple(formulas), order if closed is None else 0)
    with precision(BITS):
        first, last = (constant(node) for node in parse_tuple(f"{low}, {high}"))

        def forms(t: Any) -> tuple[Any, Any, Any]:
            rows = compiled.run(t, ComplexBalls())
            if closed is None:
                jet = PlaneJet(rows[0], rows[1])
                rows = [[getattr(jet, name)], [jet.inflection_form], [jet.speed_squared]]
            return rows[0][0] / (9 if order == 4 else 27), rows[1][0], rows[2][0]

        side = 1 if forms(acb((first + last) / 2))[0].real > 0 else -1
        singular = forms(acb(first))[0].contains(0)
        power, begin = (order, arb(cut)) if singular else (1, arb(0))

        def density(u: Any, analytic: bool) -> Any:
            factors = forms(first + (last - first) * _power(u, power))
            form, turning, speed = factors[0] * side, factors[1], factors[2]
            if analytic and any(z.imag.contains(0) and not z.real > 0 for z in (form, turning, speed)):
                return acb("nan")
            value = ((form.log() - leading * turning.log() - speed.log() / 2) / order).exp()
            return value * (last - first) * power * _power(u, power - 1)

        total = acb.integral(density, begin, 1, rel_tol=arb(ACCURACY), abs_tol=arb(ACCURACY)).real
        if singular:
            near = forms(acb(ball(first, first + (last - first) * _power(begin, power))))
            least = near[1].real.lower() ** leading * near[2].real.lower().sqrt()
            most = (abs(near[0].real).upper() / least).root(order) * (last - first) * _power(begin, power)
            total += ball(0, most)
        return total * law_of(primitive).ball().root(order)


def _power(base: Any, exponent: int) -> Any:
    result = base * 0 + 1
    for _ in range(exponent):
        result = result * base
    return result


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
    return _rounds(enclosed_constant(*SPIRAL, "parabola"), form)


@claim(
    "section 3.7.1-2",
    "The constant of (3.18) is 1.269590 on the spiral.",
    method=Method.ENCLOSURE,
    form="1.269590",
    wrong=("1.269591", "1.269589"),
)
def spiral_conic(form: str) -> Evidence:
    """Rigorous quadrature of complex balls, rounded to the digits given."""
    return _rounds(enclosed_constant(*SPIRAL, "conic"), form)


@claim(
    "section 3.7.2-1",
    "The constant of (3.17) is 1.181870 on the half 0 ≤ t ≤ 3π/4 of Cayley's sextic.",
    method=Method.ENCLOSURE,
    form="1.181870",
    wrong=("1.181871", "1.181869"),
)
def cayley_parabola(form: str) -> Evidence:
    """Rigorous quadrature of complex balls, rounded to the digits given."""
    return _rounds(enclosed_constant(*HALF, "parabola"), form)


@claim(
    "section 3.7.2-2",
    "The constant of (3.18) is 0.529301 on the half of Cayley's sextic.",
    method=Method.ENCLOSURE,
    form="0.529301",
    wrong=("0.529302", "0.529300"),
)
def cayley_conic(form: str) -> Evidence:
    """The same; the integrand vanishes like t^(1/5) at the sextactic point t = 0."""
    return _rounds(enclosed_constant(*HALF, "conic"), form)


@claim(
    "table 3.1.1",
    "Theory's numbers of parabolas on the spiral for ε = 1e-1 … 1e-8 are as printed.",
    method=Method.ENCLOSURE,
    form="5, 9, 15, 26, 46, 82, 145, 257",
    wrong=("5, 9, 15, 26, 46, 82, 145, 256", "4, 9, 15, 26, 46, 82, 145, 257"),
)
def table_spiral_parabola(form: str) -> Evidence:
    """⌈C ε^(−1/4)⌉ with the enclosed constant."""
    return _counts(form, SPIRAL, "parabola", 1)


@claim(
    "table 3.1.2",
    "Theory's numbers of conics on the spiral for ε = 1e-1 … 1e-8 are as printed.",
    method=Method.ENCLOSURE,
    form="3, 4, 6, 9, 13, 21, 32, 51",
    wrong=("2, 4, 6, 9, 13, 21, 32, 51", "3, 4, 6, 9, 13, 21, 32, 50"),
)
def table_spiral_conic(form: str) -> Evidence:
    """⌈C ε^(−1/5)⌉ with the enclosed constant."""
    return _counts(form, SPIRAL, "conic", 1)


@claim(
    "table 3.3.1",
    "Theory's numbers of parabolas on Cayley's sextic, split at t = 0, are as printed.",
    method=Method.ENCLOSURE,
    form="6, 8, 14, 24, 44, 76, 134, 238",
    wrong=("5, 8, 14, 24, 43, 75, 133, 237",),
)
def table_cayley_parabola(form: str) -> Evidence:
    """2⌈C ε^(−1/4)⌉ with the constant of one half: the halves are mirror images."""
    return _counts(form, HALF, "parabola", 2)


@claim(
    "table 3.3.2",
    "Theory's numbers of conics on Cayley's sextic, split at t = 0, are as printed.",
    method=Method.ENCLOSURE,
    form="2, 4, 6, 8, 12, 18, 28, 44",
    wrong=("4, 4, 6, 8, 12, 18, 28, 44", "2, 3, 5, 7, 11, 17, 27, 43"),
)
def table_cayley_conic(form: str) -> Evidence:
    """2⌈C ε^(−1/5)⌉ with the constant of one half."""
    return _counts(form, HALF, "conic", 2)
