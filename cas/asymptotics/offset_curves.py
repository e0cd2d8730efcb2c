"""Curves β = α + d·(Pt + Qn) beside a curve α, and their affine curvature, as series in all small quantities.

α has generic affine curvature k₀ + k₁u + …, (t, n) is its affine frame, d a polynomial in u with zeros at
the places of contact, P and Q generic functions. All places (u and the zeros ρ, σ, … of d) get weight 1:
they are written εu, ερ, …, so the coefficient of εⁿ is a polynomial homogeneous of degree n in the places,
and O(ρⁿ) for 0 ≤ u ≤ ρ means: order εⁿ and more. A derivative by u lowers the order by one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import sympy as sp
from flint import Ordering, fmpq_mpoly_ctx

from osculant.cas.errors import DomainError
from osculant.cas.jets.canonical import affine_arc
from osculant.cas.numbers.power_series import PowerSeries, power

Pair = tuple[PowerSeries, PowerSeries]
#: a curve tangent at two places has a d of degree 4, which is least for kβ to see a generic curvature
LEAST_DEGREE = 4


def bracket(a: Pair, b: Pair) -> PowerSeries:
    """The determinant [a, b].

    >>> one, x = PowerSeries([1, 0]), PowerSeries([0, 1])
    >>> bracket((one, x), (x, one))
    PowerSeries([1, 0])
    """
    return a[0] * b[1] - a[1] * b[0]


@dataclass(frozen=True)
class OffsetCurve:
    """The curve β beside α, for one set of places.

    Args:
        zeros: the zeros of d(u) by name, with multiplicity: "0" or the name of a place.
        terms: how many orders of P and Q are kept, at least 1: 1 for constants P0, Q0, 2 to add linear terms
            in u and the places, named Pu, Prho, …

    Raises DomainError for fewer than four zeros, and for a place named like a symbol of the curves: u, k0, …

    >>> tangent = OffsetCurve(("0", "0", "rho", "rho"))
    >>> tangent.affine_curvature[0]
    k0 + 8*Q0
    """

    zeros: tuple[str, ...]
    terms: int = 2

    def __post_init__(self) -> None:
        if len(self.zeros) < LEAST_DEGREE or self.terms < 1:
            raise DomainError(
                f"An offset curve with contacts {self.zeros} and {self.terms} orders of P and Q has no "
                "generic affine curvature: give at least four contacts and one order."
            )

        reserved = {"u", *self._names[len(self.places) :]}
        clashes = reserved & set(self.zeros)
        if clashes or not all(self.zeros):
            raise DomainError(
                f"A place of contact cannot be called {min(clashes, default='')!r}, which is a symbol of the "
                "curves: choose another name, such as sigma."
            )

    @property
    def places(self) -> tuple[str, ...]:
        """u and the other places, the variables of weight 1."""
        return ("u", *sorted(set(self.zeros) - {"0"}))

    @property
    def _names(self) -> list[str]:
        linear = [f"{f}{p}" for f in "PQ" for p in self.places] if self.terms > 1 else []
        return [*self.places, *(f"k{i}" for i in range(self.length)), "P0", "Q0", *linear]

    @cached_property
    def _generators(self) -> dict[str, Any]:
        names = self._names
        return dict(zip(names, fmpq_mpoly_ctx.get(names, Ordering.degrevlex).gens(), strict=True))

    @property
    def length(self) -> int:
        """The number of orders of β that are known: 0 up to deg d + terms − 1."""
        return len(self.zeros) + self.terms

    @cached_property
    def arc(self) -> Pair:
        """α at u."""
        X, Y = self._canonical
        u = self._generators["u"]
        return X.scaled(u).cut(self.length), Y.scaled(u).cut(self.length)

    @cached_property
    def _canonical(self) -> Pair:
        k = [self._generators[f"k{i}"] for i in range(self.length)]
        X, Y, _ = affine_arc(self.length + 1, k)
        return X, Y

    @cached_property
    def frame(self) -> tuple[Pair, Pair]:
        """(t, n) at u."""
        X, Y = (c.derivative() for c in self._canonical)
        u = self._generators["u"]
        tangent = (X.scaled(u), Y.scaled(u))
        return tangent, (X.derivative().scaled(u), Y.derivative().scaled(u))

    @cached_property
    def contact(self) -> Any:
        """d, as a polynomial in u and the places."""
        g = self._generators
        d = g["u"] ** 0
        for zero in self.zeros:
            d = d * (g["u"] if zero == "0" else g["u"] - g[zero])
        return d

    def _function(self, name: str) -> PowerSeries:
        """P or Q."""
        g = self._generators
        zero = g["u"] * 0
        linear = sum((g[f"{name}{p}"] * g[p] for p in self.places), zero) if self.terms > 1 else zero
        return PowerSeries([g[f"{name}0"], *([linear] if self.terms > 1 else [])])

    @cached_property
    def beta(self) -> Pair:
        """β at u."""
        t, n = self.frame
        P, Q = self._function("P"), self._function("Q")
        first, second = (
            a + ((P * b + Q * c) * self.contact).shifted(len(self.zeros))
            for a, b, c in zip(self.arc, t, n, strict=True)
        )
        return first, second

    def rate(self, series: PowerSeries) -> PowerSeries:
        """The derivative by u, one order shorter."""
        return PowerSeries([c.derivative("u") for c in series.coefficients[1:]])

    def derivatives(self, count: int) -> list[Pair]:
        """β_u, β_uu, … up to that many."""
        found = [self.beta]
        while len(found) <= count:
            found.append((self.rate(found[-1][0]), self.rate(found[-1][1])))
        return found[1:]

    @cached_property
    def affine_speed(self) -> PowerSeries:
        """φ = [β_u, β_uu]^{1/3}, which is 1 + …."""
        first, second = self.derivatives(2)
        return power(bracket(first, second), Fraction(1, 3))

    @cached_property
    def affine_curvature(self) -> PowerSeries:
        """kβ by (2.12); its orders 0 up to deg d + terms − 5 are known."""
        _, second, third = self.derivatives(3)
        phi = self.affine_speed
        slope = self.rate(phi)
        return bracket(second, third) * phi**-5 + (self.rate(slope) * phi - slope * slope * 3) * phi**-4

    def expression(self, polynomial: Any) -> Any:
        """A coefficient as a sympy expression in symbols of the generators' names."""
        symbols = self.symbols
        names = list(self._generators)
        return sp.Add(
            *(
                sp.Rational(int(c.p), int(c.q)) * sp.prod(symbols[s] ** e for s, e in zip(names, powers))
                for powers, c in polynomial.to_dict().items()
            )
        )

    @cached_property
    def symbols(self) -> dict[str, Any]:
        """A sympy symbol for each generator, by name."""
        return {name: sp.Symbol(name, real=True) for name in self._generators}

    def order(self, stated: Any, n: int) -> Any:
        """The part of degree n in the places of a sympy expression that is a polynomial in them."""
        small = sp.Symbol("epsilon")
        places = [self.symbols[p] for p in self.places]
        scaled = stated.subs({p: small * p for p in places}, simultaneous=True)
        return sp.Poly(sp.expand(scaled), small).coeff_monomial(small**n)


def both_ends(crossings: Sequence[str] = (), terms: int = 2) -> OffsetCurve:
    """The curve tangent to α at u = 0 and u = ρ that also crosses it at the places named.

    >>> both_ends(("sigma",)).places
    ('u', 'rho', 'sigma')
    """
    return OffsetCurve(("0", "0", "rho", "rho", *crossings), terms)
