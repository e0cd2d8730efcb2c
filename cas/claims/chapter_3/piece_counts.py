"""Section 3.8: what follows the leading term of the number of pieces, which the thesis leaves open."""

from __future__ import annotations

from functools import cache
from typing import Any

import mpmath
import sympy as sp
from flint import arb

from osculant.cas.asymptotics.end_corrections import end_correction
from osculant.cas.asymptotics.short_arcs import arc_error, height_series
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import HALF_SEXTIC, SPIRAL, SPIRAL_ARC
from osculant.cas.claims.proof import agrees, read, read_tuple, split, vanishes
from osculant.cas.formulas.parser import parse_constant, parse_tuple
from osculant.cas.geometry.bitangent import ReferenceCurve
from osculant.cas.geometry.greedy import greedy_knots
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.laws.complexity import complexity_constant
from osculant.cas.laws.next_term import density_terms, next_constant
from osculant.cas.numbers.balls import PRECISION, constant, precision

#: greedy splines of the spiral for comparison: ε, a guess of the first arc, the number of arcs; then twice as
#: many arcs at ε/2ᵖ, which reach nearly as far
TRIALS = {"parabola": ("1e-4", "0.22", 5), "conic": ("1e-7", "0.16", 2)}
NO_PROOF = (
    "the formula is derived (X3.8-6), but its integral is known by quadrature whose error is "
    "estimated, and that "
    "greedy counts follow it is measured"
)
QUADRATURE = "the quadrature converges doubly exponentially, but its error is estimated, not enclosed"
ENDS = (
    "the limit of a sequence of greedy arcs is extrapolated; its error is estimated from two extrapolations"
)


@claim(
    "X3.8-1",
    "Where the integrand is smooth and not 0, N(ε) has no term of order 1: an arc's relative error "
    "begins with h².",
    method=Method.PROOF,
    form="0",
    wrong=("kappa1", "kappa1/5"),
)
def no_constant_term(form: str) -> Evidence:
    """With E = hᵖ(e₀ + e₁h + …) about the middle of an arc, N has the O(1) term ∫e₁/(p e₀) ds.

    e₁ is read off the derived series of both primitives, for a generic curve.
    """
    result = Evidence(True)
    for primitive in ("parabola", "conic"):
        order, _, height = height_series(primitive)
        middle = sp.sympify((height[1] / (order * height[0])).as_expr())
        result &= vanishes(
            middle - read(form, {"kappa1": sp.Symbol("kappa1")}), f"e₁/(p e₀) of a {primitive}"
        )
    return result


@claim(
    "X3.8-6",
    "N(ε) = Cε^(−1/p) + c₁ε^(1/p) + …, c₁ = ∫ρ₁ ds with ρ₁ = a e₂/(p e₀) − (a²/24) d²(1/a)/ds², a = "
    "e₀^(−1/p).",
    method=Method.PROOF,
    form="a*e2/(p*e0) - a^2*b/24",
    wrong=("a*e2/(p*e0) + a^2*b/24", "a*e2/(p*e0) - a^2*b/12", "a*e2/e0 - a^2*b/24"),
)
def next_density_formula(form: str) -> Evidence:
    """hρ + h³ρ″/24 = 1 and hᵖ(e₀ + e₂h²) = ε, ρ = ε^{−1/p}(1/a + δρ₁), δ = ε^{2/p}; b stands for d²(1/a)/ds².

    The claimed ρ₁ is put into the first condition, with h from the second to the order δ; what is left must
    be O(δ²). p is any number. The program's own expansion has to agree for p = 4 and 5.
    """
    a, e0, e2, p, b, delta = sp.symbols("a e0 e2 p b delta", positive=True)
    claimed = read(form, {"a": a, "e0": e0, "e2": e2, "p": p, "b": b})
    x = sp.Symbol("x")
    # h = ε^{1/p} a(1 + xδ), e₀aᵖ = 1: d/dδ of (1 + xδ)ᵖ(1 + (e₂/e₀)a²δ) vanishes at δ = 0
    (x,) = sp.solve(sp.diff((1 + x * delta) ** p * (1 + e2 / e0 * a**2 * delta), delta).subs(delta, 0), x)
    content = a * (1 + x * delta) * (1 / a + delta * claimed) + a**3 * b * delta / 24
    result = vanishes(sp.diff(content, delta).subs(delta, 0), "content of an arc to the order ε^(2/p)")
    for order in (4, 5):
        _, following = density_terms(order)
        (function,) = following.atoms(sp.Function("a"))
        own = following.subs(sp.Derivative(1 / function, (function.args[0], 2)), b).subs(function, a)
        own = own.subs({sp.Symbol("e0"): e0, sp.Symbol("e2"): e2})
        result &= vanishes(own - claimed.subs(p, order), f"expansion for p = {order}")
    return result


@claim(
    "X3.8-7",
    "Counted in fractions of the last arc, the relative error of (3.17) is O(ε^(1/2)) and that of "
    "(3.18) O(ε^(2/5)).",
    method=Method.PROOF,
    form="1/2, 2/5",
    wrong=("1/4, 1/5", "1/2, 1/5"),
)
def sharper_orders(form: str) -> Evidence:
    """c₁ε^{1/p} over Cε^{−1/p} is of the order 2/p, since e₁ = 0 and e₂ is not; p is derived."""
    found = [height_series(primitive) for primitive in ("parabola", "conic")]
    result = Evidence(all(h[1] == 0 and h[2] != 0 for *_, h in found), ("e₁ = 0 and e₂ ≠ 0",))
    for claimed, (order, *_) in zip(read_tuple(form, {}, 2), found, strict=True):
        result &= vanishes(claimed - sp.Rational(2, order), f"order for p = {order}")
    return result


@claim(
    "X3.8-2",
    "The spiral (t cos t, t sin t) on [π/6, 2π] has c₁ = 0.36722549350995 for parabolic splines.",
    method=Method.NUMERICAL,
    reason=NO_PROOF,
    form="0.36722549350995",
    wrong=("0.367226", "0.3671"),
)
def spiral_parabola(form: str) -> Evidence:
    """c₁ by quadrature of ρ₁; and greedy splines at many digits, no series in them, against C and c₁."""
    return _spiral(form, "parabola")


@claim(
    "X3.8-3",
    "The spiral (t cos t, t sin t) on [π/6, 2π] has c₁ = 0.44678845323402 for conic splines.",
    method=Method.NUMERICAL,
    reason=NO_PROOF,
    form="0.44678845323402",
    wrong=("0.446789", "0.4467"),
)
def spiral_conic(form: str) -> Evidence:
    """c₁ by quadrature of ρ₁; and greedy splines at many digits, no series in them, against C and c₁."""
    return _spiral(form, "conic")


def _spiral(form: str, primitive: str) -> Evidence:
    measured = _measured(primitive)
    with precision(PRECISION):
        whole, _ = next_constant(_curve(), primitive, arb.pi() / 6, 2 * arb.pi())
    return agrees(whole.str(25, radius=False), form, 13, "c₁ of the whole") & measured


@cache
def _measured(primitive: str) -> Evidence:
    """n − Cε^{−1/p} − c₁ε^{1/p} after n arcs must be like ε^{3/p}: by 2³ less for half the length."""
    order, rests, lines = arc_error(primitive).order, [], []
    first, guess, arcs = TRIALS[primitive]
    with mpmath.workdps(25):
        for factor in (1, 2):
            tolerance, count = mpmath.mpf(first) / factor**order, factor * arcs
            low, length = mpmath.pi / 6, mpmath.mpf(guess) / factor
            last = greedy_knots(ReferenceCurve(SPIRAL), primitive, low, tolerance, length, count)[-1]
            with precision(PRECISION):
                ends = arb.pi() / 6, arb(mpmath.nstr(last, 25))
            leading, following = (
                mpmath.mpf(f(_curve(), primitive, *ends)[0].str(25, radius=False))
                for f in (complexity_constant, next_constant)
            )
            unit = mpmath.root(tolerance, order)
            after_leading = (count - leading / unit) / unit
            rests.append((after_leading - following) * unit)
            lines.append(
                f"{count} greedy arcs at {mpmath.nstr(tolerance, 5)}: (n − Cε^(−1/p))/ε^(1/p) = "
                f"{mpmath.nstr(after_leading, 7)}, "
                f"c₁ = {mpmath.nstr(following, 7)}"
            )
        ratio = rests[0] / rests[1]
    lines.append(f"the rests are in the ratio {mpmath.nstr(ratio, 4)}; 8 in the limit")
    return Evidence(bool(abs(ratio / 8 - 1) < 0.1), tuple(lines))


@cache
def _curve() -> CurveBalls:
    return CurveBalls(parse_tuple(SPIRAL))


@claim(
    "X3.8-4",
    "An end with a simple zero of dk/dr costs a conic spline 0.048365680944480 pieces more (Hausdorff).",
    method=Method.NUMERICAL,
    reason=ENDS,
    form="0.048365680944480",
    wrong=("0.0484", "0.048365681"),
)
def sextactic_end(form: str) -> Evidence:
    """The greedy spline of the model d = (u−a)²(u−b)²([u⁶/6!; a,a,b,b,u] − q), q minimax, from u = 0."""
    return _end(form, "conic")


@claim(
    "X3.8-5",
    "An end with a simple zero of k costs a parabolic spline 0.055030019684383 pieces more (Hausdorff).",
    method=Method.NUMERICAL,
    reason=ENDS,
    form="0.055030019684383",
    wrong=("0.0550", "0.055030020"),
)
def parabolic_end(form: str) -> Evidence:
    """The greedy spline of the model d = (u−a)²(u−b)²[u⁵/5!; a,a,b,b,u] from u = 0."""
    return _end(form, "parabola")


def _end(form: str, primitive: str) -> Evidence:
    value: Any = end_correction(primitive, 14)
    return agrees(value, form, 12, f"end correction of a {primitive}")


@claim(
    "X3.6-1",
    "The constants of (3.17) are 2.56677413266675333 for the spiral and 1.18187030003858798 for "
    "half of Cayley's "
    "sextic.",
    method=Method.NUMERICAL,
    reason=QUADRATURE,
    form="2.56677413266675333, 1.18187030003858798",
    wrong=("2.566774132667, 1.18187030003858798", "2.56677413266675333, 1.18187030003859"),
)
def parabola_constants(form: str) -> Evidence:
    """∫e₀^{1/4} ds with the derived e₀, from the jets in 320-bit balls; 17 digits are compared."""
    return _leading_constants(form, "parabola")


@claim(
    "X3.6-2",
    "The constants of (3.18) are 1.26959011703699553 for the spiral and 0.529300817502150973 for half of "
    "Cayley's sextic.",
    method=Method.NUMERICAL,
    reason=QUADRATURE,
    form="1.26959011703699553, 0.529300817502150973",
    wrong=("1.269590117037, 0.529300817502150973", "1.26959011703699553, 0.52930081750215"),
)
def conic_constants(form: str) -> Evidence:
    """∫e₀^{1/5} ds with the derived e₀, from the jets in 320-bit balls; 17 digits are compared."""
    return _leading_constants(form, "conic")


def _leading_constants(form: str, primitive: str) -> Evidence:
    result = Evidence(True)
    for claimed, (curve, low, high) in zip(split(form, 2), (SPIRAL_ARC, HALF_SEXTIC), strict=True):
        with precision(PRECISION):
            ends = constant(parse_constant(low)), constant(parse_constant(high))
        value, _ = complexity_constant(CurveBalls(parse_tuple(curve)), primitive, *ends)
        result &= agrees(value.str(30, radius=False), claimed, 17, f"constant of ({curve})")
    return result
