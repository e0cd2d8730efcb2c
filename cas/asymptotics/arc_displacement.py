"""The displacement of a bitangent conic from a short arc as a power series in the arc's length h.

The curve is generic: κ = 1 in the middle of the arc (a matter of scale), with derivatives κ₁, κ₂, … by arc
length. The steps:

1. the curve at u = xh/2 and the ends x = ±1 in the Frenet frame of the middle, as series in h whose
   coefficients are polynomials in x and κ₁, κ₂, …;
2. the pencil F = l₁² − 4Q l₀l₂ of conics tangent at both ends, Q a series in h with unknown coefficients;
3. the displacement d along the normal, from F(α + dN) = 0;
4. Q is known for a parabola; for the conic of least Hausdorff distance each coefficient makes the two extreme
   values of d, near x = ±1/√5, opposite to one order more (equioscillation).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import sympy as sp
from flint import Ordering, fmpq, fmpq_mpoly_ctx

from osculant.cas.errors import DomainError
from osculant.cas.geometry import pencil
from osculant.cas.jets.canonical import euclidean_arc
from osculant.cas.numbers.power_series import PowerSeries, ratio, solve

#: κ, κ₁, κ₂, …: the curvature and its derivatives by arc length in the middle of the arc
KAPPA = sp.symbols("kappa:8", real=True)
Pair = tuple[PowerSeries, PowerSeries]
#: coefficients of d that are known: orders 0 to 5 in d/h², the least for e₂ of a conic
LENGTH = 6


@cache
def peak_spread() -> int:
    """1/x² at the extreme values of (1 − x²)²x, the leading error of a conic over x in [−1, 1].

    >>> peak_spread()
    5
    """
    return int(sp.nsimplify(1 / sp.expand((2 * pencil.lobes(1)["first"] - 1) ** 2)))


@cache
def displacement(primitive: str) -> tuple[list[Any], ...]:
    """d(x) = Σ hⁿdₙ(x) for n = 0 … 7 and κ = 1: for each n the coefficients of x⁰, x¹, … .

    They are elements of sympy's field ℚ(κ₁, κ₂, …). For a conic Q is the one that equioscillates, to the
    order that matters. Raises DomainError for an unknown primitive.

    >>> displacement("parabola")[4][1:]  # a multiple of (1 − x²)²
    [0, (-5*kappa1**2 + 3*kappa2 + 9)/576, 0, (5*kappa1**2 - 3*kappa2 - 9)/1152]
    """
    field = sp.QQ.frac_field(*KAPPA[1:LENGTH])
    parts, _ = _solved(primitive)
    return tuple(_by_powers(part, field) for part in (0 * parts[0], 0 * parts[0], *parts))


def optimal_pencil() -> PowerSeries:
    """4Q|c|²/h² of the conic of least Hausdorff distance as a series in h, c the chord, for κ = 1.

    Elements of sympy's field ℚ(κ₁, κ₂, …).

    >>> optimal_pencil()[2]
    (4*kappa1**2 - 3*kappa2 - 3)/36
    """
    field = sp.QQ.frac_field(*KAPPA[1:LENGTH])
    _, found = _solved("conic")
    return PowerSeries([field.one, field.zero, *(_by_powers(q, field)[0] for q in found)])


@cache
def _solved(primitive: str) -> tuple[list[Any], list[Any]]:
    """The coefficients of d/h², flint polynomials in x, κ₁, …, and those of the conic's Q."""
    if primitive not in {"parabola", "conic"}:
        raise DomainError(f"Error series are known for 'parabola' and 'conic', not for {primitive!r}.")
    names = ["x", *(str(k) for k in KAPPA[1:LENGTH]), *(f"q{i}" for i in range(2, LENGTH - 1))]
    gens = fmpq_mpoly_ctx.get(names, Ordering.degrevlex).gens()
    x, kappa, unknown = gens[0], gens[1:LENGTH], gens[LENGTH:] if primitive == "conic" else ()
    d = list(along_normal(x, (x * 0 + 1, *kappa), unknown).coefficients)
    solutions = []
    # The extreme values near ±x* become opposite order by order: dₙ(x*) + dₙ(−x*) = 0 fixes qₙ₋₂.
    # The last coefficient of d is left: more of Q would move both of its values alike, not their difference.
    for place, q in enumerate(unknown):
        even = _even_part(d[2 + place], x, peak_spread())
        solutions.append(q - even / even.derivative(str(q)))
        d = [part.compose(*(solutions[-1] if g == q else g for g in gens)) for part in d]
    return d, solutions


def along_normal(x: Any, kappa: Sequence[Any], unknown: Sequence[Any]) -> PowerSeries:
    """d/h² as a series in h for the conic tangent at both ends of the arc, along the normal at u = xh/2.

    Args:
        x: the place, in [−1, 1] from end to end.
        kappa: κ = 1, κ₁, κ₂, … in the same ring.
        unknown: (q₂, q₃, …) for the conic with Q|c|² = h²(1 + q₂h² + q₃h³ + …)/4, c the chord; none for the
            parabola.
    """
    X, Y, _ = euclidean_arc(LENGTH + 2, [*kappa, *(x * 0,) * (LENGTH + 1 - len(kappa))])

    def at(place: Any) -> tuple[Pair, Pair]:
        return (X.scaled(place), Y.scaled(place)), (
            X.derivative().scaled(place),
            Y.derivative().scaled(place),
        )

    half = x * 0 + ratio(1, 2, x)
    (start, first), (end, last), (point, tangent) = at(-half), at(half), at(x * half)
    normal, chord = (-tangent[1], tangent[0]), _minus(end, start)
    # each line, and each sine, is divided by the power of h that it has as a factor
    lines = [
        _bracket(last, _minus(point, end)).shifted(-2),
        _bracket(chord, _minus(point, start)).shifted(-3),
        _bracket(first, _minus(point, start)).shifted(-2),
    ]
    rates = [_bracket(last, normal), _bracket(chord, normal).shifted(-1), _bracket(first, normal)]
    if unknown:
        rest = [x * 0] * (LENGTH - 2 - len(unknown))
        q = PowerSeries([x * 0 + 1, x * 0, *unknown, *rest]) * ratio(1, 4, x)
    else:
        sines = _bracket(first, chord).shifted(-2), _bracket(chord, last).shifted(-2)
        q = _parabola_q()(*sines, _bracket(first, last).shifted(-1)).cut(LENGTH)

    def on_conic(d: PowerSeries) -> PowerSeries:
        return _implicit()(*(line + d * rate for line, rate in zip(lines, rates, strict=True)), q).cut(LENGTH)

    # F is quadratic in d, so this difference is its derivative by d
    one = PowerSeries([x * 0 + 1] + [x * 0] * (LENGTH - 1))
    slope = ((on_conic(one) - on_conic(-one)) * ratio(1, 2, x))[0]
    return solve(on_conic, slope, LENGTH)


@cache
def _implicit() -> Callable[..., PowerSeries]:
    lines = (pencil.l0, pencil.l1, pencil.l2)
    compiled: Callable[..., PowerSeries] = sp.lambdify(
        (*lines, pencil.Q), pencil.implicit(lines), modules=[{}]
    )
    return compiled


@cache
def _parabola_q() -> Callable[..., PowerSeries]:
    sines = (pencil.sin_a, pencil.sin_b, pencil.sin_psi)
    compiled: Callable[..., PowerSeries] = sp.lambdify(sines, pencil.weights()["parabola"], modules=[{}])
    return compiled


def _bracket(a: Pair, b: Pair) -> PowerSeries:
    return a[0] * b[1] - a[1] * b[0]


def _minus(a: Pair, b: Pair) -> Pair:
    return a[0] - b[0], a[1] - b[1]


def _even_part(polynomial: Any, x: Any, spread: int) -> Any:
    """The part even in x, where x² = 1/spread."""
    ring = polynomial.context()
    found: dict[tuple[int, ...], Any] = {}
    for powers, c in polynomial.to_dict().items():
        if powers[0] % 2 == 0:
            rest = (0, *powers[1:])
            found[rest] = found.get(rest, 0) + c * fmpq(1, spread ** (int(powers[0]) // 2))
    return ring.from_dict(found)


def _by_powers(polynomial: Any, field: Any) -> list[Any]:
    """The coefficients of x⁰, x¹, … in sympy's field."""
    terms = polynomial.to_dict()
    found = [field.zero] * (1 + max((int(powers[0]) for powers in terms), default=0))
    for powers, c in terms.items():
        monomial = field(sp.QQ(int(c.p), int(c.q)))
        for generator, exponent in zip(field.gens, powers[1:LENGTH], strict=True):
            monomial *= generator ** int(exponent)
        found[int(powers[0])] += monomial
    return found
