"""Proof that a codimension is infinite: a curve through the origin along which the germ stays degenerate.

If T G_e f had finite codimension, it would be everything at all points near the origin. So one curve γ(t)
with γ(0) = 0 whose generic points are bad proves "infinite". Bad means: for R, C and K the values of the
generators do not span at γ(t); for A the germ of f at γ(t) is not stable, T K_e + constants is not
everything in jets of order p (Mather), or the bigerm at γ(t) and a mirrored curve with the same image is
not: the constants are then common to both points. Either is the vanishing of minors that are polynomials in
t of bounded degree: they vanish identically if they do so at more values of t than their degree, each
decided in exact arithmetic.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain, combinations, islice, product
from math import gcd, prod

from flint import fmpz_mat

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.annihilator import annihilator
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group
from osculant.cas.germs.polynomials import Number, Polynomial
from osculant.cas.germs.tangent import JetSpace, Vector, along, rows

#: exponents of the curves tried; coefficients of those tried first, and how many
EXPONENTS, UNITS, CURVES = (1, 2, 3), (1, -1), 400
#: coefficients of the curves tried if the germ is quasi-homogeneous along them, and how many are looked at
COEFFICIENTS, SHAPES = (1, -1, 2, -2, 3, -3, 4, -4), 20000
#: degree of polynomial germs that are tried, and values of t at most
DEGREE, VALUES = 30, 4000


@dataclass(frozen=True)
class Curve:
    """The curve t ↦ (c₁t^{a₁}, …, cₙt^{aₙ}); with ``mirror``, also the one with its signs changed so.

    >>> print(Curve((1, 2), (1, 0)))
    (t, 0)
    >>> print(Curve((2, 1), (-2, 1), (1, -1)))
    (-2*t**2, t) and (-2*t**2, -t)
    """

    exponents: tuple[int, ...]
    coefficients: tuple[int, ...]
    mirror: tuple[int, ...] | None = None

    def at(self, t: int) -> list[tuple[int, ...]]:
        """The points of a parameter value: one, or two with the same image."""
        point = tuple(c * t**a for c, a in zip(self.coefficients, self.exponents))
        if self.mirror is None:
            return [point]
        return [point, tuple(s * x for s, x in zip(self.mirror, point))]

    def __str__(self) -> str:
        def term(c: int, a: int) -> str:
            power = "t" if a == 1 else f"t**{a}"
            return {0: "0", 1: power, -1: f"-{power}"}.get(c, f"{c}*{power}")

        text = f"({', '.join(term(c, a) for c, a in zip(self.coefficients, self.exponents))})"
        if self.mirror is None:
            return text
        mirrored = tuple(s * c for s, c in zip(self.mirror, self.coefficients))
        return f"{text} and {Curve(self.exponents, mirrored)}"


def degenerate_curve(germ: Germ, group: Group) -> Curve | None:
    """A curve of bad points for the group, proved to be one; None if none of those tried is.

    Only for polynomial germs: a jet says nothing about points off the origin.

    >>> from osculant.cas.germs.groups import group
    >>> print(degenerate_curve(Germ("x, y**2, 0", "x y"), group("A")))
    (t, 0)
    >>> degenerate_curve(Germ("x, y**2, x*y", "x y"), group("A")) is None
    True
    """
    jet = germ.polynomial(DEGREE)
    if jet is None:
        return None
    trial = _Trial(germ, group, jet)
    simple = list(islice(_curves(germ.n, UNITS), CURVES))
    pairs = (pair for curve in simple for pair in _mirrored(curve, jet, germ, group))
    orbits = (curve for curve in islice(_curves(germ.n, COEFFICIENTS), SHAPES) if trial.symmetric(curve))
    more = chain.from_iterable((curve, *_mirrored(curve, jet, germ, group)) for curve in orbits)
    return next((curve for curve in chain(simple, pairs, more) if trial.degenerate(curve)), None)


def _mirrored(curve: Curve, jet: Vector, germ: Germ, group: Group) -> Iterator[Curve]:
    """The curve together with mirror images that f maps to the same points (for A)."""
    if group.target != "left":
        return
    for signs in product(*((1, -1) if c else (1,) for c in curve.coefficients)):
        pair = Curve(curve.exponents, curve.coefficients, signs)
        if min(signs) < 0 and all(_same_image(f, pair, germ.n) for f in jet):
            yield pair


def _same_image(f: Polynomial, pair: Curve, n: int) -> bool:
    """Whether f is the same polynomial in t on both curves."""
    difference: dict[int, Number] = {}
    for m, c in f.items():
        exponents = poly.exponents_of(m, n)
        power = sum(a * e for a, e in zip(pair.exponents, exponents))
        value = prod(q**e for q, e in zip(pair.coefficients, exponents))
        sign = prod(s**e for s, e in zip(pair.mirror or (), exponents))
        difference[power] = difference.get(power, 0) + c * value * (1 - sign)
    return not any(difference.values())


def _curves(n: int, coefficients: tuple[int, ...]) -> Iterator[Curve]:
    """Curves with these coefficients, the fewest of them not 0 first, each up to t ↦ −t."""
    for size in range(1, n + 1):
        for used in combinations(range(n), size):
            for chosen in product(coefficients, repeat=size):
                for powers in product(EXPONENTS, repeat=size):
                    if gcd(*powers) > 1:
                        continue
                    first_odd = next(i for i, a in enumerate(powers) if a % 2)  # not all are even
                    if chosen[first_odd] > 0:
                        yield _curve(n, used, powers, chosen)


def _curve(n: int, used: Sequence[int], powers: Sequence[int], chosen: Sequence[int]) -> Curve:
    exponents, coefficients = [1] * n, [0] * n
    for i, a, c in zip(used, powers, chosen):
        exponents[i], coefficients[i] = a, c
    return Curve(tuple(exponents), tuple(coefficients))


class _Trial:
    """The test of curves for one germ and group."""

    def __init__(self, germ: Germ, group: Group, jet: Vector) -> None:
        self.germ, self.group, self.jet = germ, group, jet
        self.fields = group.generators(germ)
        # a stable germ fulfils the condition in jets of any order; order p is enough to see that it does
        self.orders = range(germ.p + 1) if group.target == "left" else range(1)

    def degenerate(self, curve: Curve) -> bool:
        """Whether all points of the curve but the origin are proved to be bad."""
        if self.submersive(curve.at(1)):
            return False
        for order in self.orders:  # the lower the order in which it shows, the fewer values of t prove it
            if all(self.bad(curve.at(t), order) for t in (1, 2, 3)):
                return self.symmetric(curve) or self.always_bad(curve, order)
        return False

    def submersive(self, points: list[tuple[int, ...]]) -> bool:
        """Whether the fields' images span at a single point: it is not bad then, for any group."""
        if len(points) > 1:
            return False
        space = JetSpace(self.germ.n, self.germ.p, 0)
        here = self.local(points[0], 0, images_only=True)
        return annihilator(rows(here, space), space.columns).codimension == 0

    def symmetric(self, curve: Curve) -> bool:
        """Whether x_i ↦ t^{w_i}x_i carries the germ at γ(1) to that at γ(t): then one point proves all.

        The weights w are the curve's exponents where it moves, and otherwise any numbers for which all fⱼ
        are quasi-homogeneous.
        """
        if self.group.source == "own":
            return False
        free = [i for i, c in enumerate(curve.coefficients) if not c]
        left: list[list[int]] = []
        right: list[list[int]] = []
        for f in self.jet:
            exponents = [poly.exponents_of(m, self.germ.n) for m in f]
            for e in exponents[1:]:
                difference = [a - b for a, b in zip(e, exponents[0])]
                left.append([difference[i] for i in free])
                moving = zip(difference, curve.exponents, curve.coefficients)
                right.append([sum(d * a for d, a, c in moving if c)])
        return _rank(left) == _rank([a + b for a, b in zip(left, right)])

    def always_bad(self, curve: Curve, order: int) -> bool:
        """Whether all minors vanish at more values of t than their degree."""
        n = self.germ.n
        f = max((poly.degree_of(m, n) for component in self.jet for m in component), default=0)
        xi = max((poly.degree_of(m, n) for field in self.fields for c in field for m in c), default=0)
        columns = JetSpace(n, self.germ.p * len(curve.at(1)), order).columns
        bound = columns * (f + xi) * max(curve.exponents)  # entries are coefficients of f or of df(ξ)
        return bound <= VALUES and all(self.bad(curve.at(t), order) for t in range(1, bound + 2))

    def bad(self, points: list[tuple[int, ...]], order: int) -> bool:
        """Whether the germ at the points is not stable (A), or the generators do not span (R, C, K)."""
        p, q = self.germ.p, len(points)
        space = JetSpace(self.germ.n, p * q, order)
        spanning: list[Vector] = []
        for i, point in enumerate(points):
            before: Vector = ({},) * (p * i)
            after: Vector = ({},) * (p * (q - 1 - i))
            spanning += [(*before, *v, *after) for v in self.local(point, order)]
        if self.group.target == "left":
            spanning += [tuple({0: 1} if i % p == j else {} for i in range(p * q)) for j in range(p)]
        return annihilator(rows(spanning, space), space.columns).codimension > 0

    def local(self, point: tuple[int, ...], order: int, images_only: bool = False) -> list[Vector]:
        """Spanning vectors of T R_e f (R), T K_e f (C, K, A) at a point, in jets of that order."""
        n, p = self.germ.n, self.germ.p
        here = tuple(translated(f, point, n) for f in self.jet)
        every = poly.monomials(n, order)
        found: list[Vector] = []
        for field in self.fields:
            image = along(here, tuple(translated(c, point, n) for c in field), n, order)
            found += [tuple(poly.times(f, {m: 1}, n, order) for f in image) for m in every]
        if self.group.target != "none" and not images_only:
            for f in here:  # A compares f with its value at the point, K with 0
                local = {m: c for m, c in f.items() if m or self.group.target == "contact"}
                for m in every:
                    shifted = poly.times(local, {m: 1}, n, order)
                    found += [tuple(shifted if i == j else {} for i in range(p)) for j in range(p)]
        return found


def _rank(matrix: list[list[int]]) -> int:
    if not matrix or not matrix[0]:
        return 0
    return int(fmpz_mat(matrix).rank())


def translated(f: Polynomial, point: tuple[int, ...], n: int) -> Polynomial:
    """f(point + x), exactly.

    >>> x = poly.variable(0, 1)
    >>> translated({2 * x: 1}, (3,), 1) == {0: 9, x: 6, 2 * x: 1}
    True
    """
    top = max((poly.degree_of(m, n) for m in f), default=0)
    result: Polynomial = {}
    for m, c in f.items():
        term: Polynomial = {0: c}
        for i, e in enumerate(poly.exponents_of(m, n)):
            if e:
                shifted: Polynomial = {poly.variable(i, n): Fraction(1)}
                if point[i]:
                    shifted[0] = point[i]
                for _ in range(e):
                    term = poly.times(term, shifted, n, top)
        result = poly.plus(result, term)
    return result
