"""Leading constants of conics and parabolas as balls: certified quadrature of their densities."""

from __future__ import annotations

from functools import cache
from typing import Any

from flint import acb, arb

from osculant.cas.claims.examples import SEXTIC
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.jets.jet import natural_power
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.laws.table import law_of
from osculant.cas.numbers.balls import ball, constant, precision
from osculant.cas.numbers.fields import ComplexBalls
from osculant.cas.numbers.taylor import program

#: closed forms of the invariants of Cayley's sextic, proved by claims of section 3.7.2; narrow in balls
CLOSED = {
    SEXTIC: {
        "parabolic_form": "20480/81*cos(t/3)^6*(16 + 14*cos(2*t/3))",
        "sextactic_form": "36700160/729*sin(t/3)*cos(t/3)^9*(5 + 4*cos(2*t/3))",
        "inflection_form": "64/3*cos(t/3)^4",
        "speed_squared": "16*cos(t/3)^4",
    }
}
#: bits and tolerance of the quadrature, and where it begins (of 1, before the power) at a sextactic end
BITS, ACCURACY, START = 64, "1e-10", "0.01"


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
            factors = forms(first + (last - first) * natural_power(u, power))
            form, turning, speed = factors[0] * side, factors[1], factors[2]
            if analytic and any(z.imag.contains(0) and not z.real > 0 for z in (form, turning, speed)):
                return acb("nan")
            value = ((form.log() - leading * turning.log() - speed.log() / 2) / order).exp()
            return value * (last - first) * power * natural_power(u, power - 1)

        total = acb.integral(density, begin, 1, rel_tol=arb(ACCURACY), abs_tol=arb(ACCURACY)).real
        if singular:
            near = forms(acb(ball(first, first + (last - first) * natural_power(begin, power))))
            least = near[1].real.lower() ** leading * near[2].real.lower().sqrt()
            most = (
                (abs(near[0].real).upper() / least).root(order) * (last - first) * natural_power(begin, power)
            )
            total += ball(0, most)
        return total * law_of(primitive).ball().root(order)
