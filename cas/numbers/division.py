"""Divided differences of polynomials and power series: division by (x − x₁) … (x − xₙ), nothing else divided.

Dividing a polynomial by one x − xᵢ after the other leaves the divided differences as remainders. So they
need no decision about which nodes coincide, and nodes and coefficients may lie in any commutative ring. The
integral of Hermite and Genocchi gives the same numbers in a way that shares nothing with it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cache
from itertools import accumulate
from math import comb, factorial, prod
from operator import mul
from typing import Any

from osculant.cas.errors import DomainError
from osculant.cas.numbers.divided_differences import NewtonForm, exact, is_zero
from osculant.cas.numbers.power_series import PowerSeries, ratio

#: the most monomials that the integral of Hermite and Genocchi is expanded into
MONOMIALS = 20_000


def divided_by(polynomial: Sequence[Any], node: Any) -> tuple[tuple[Any, ...], Any]:
    """Quotient and remainder of a polynomial by x − node (synthetic division).

    >>> divided_by((1, 2, 3), 2)
    ((8, 3), 17)
    """
    carried, found = polynomial[-1], []
    for c in reversed(polynomial[:-1]):
        found.append(carried)
        carried = carried * node + c
    return tuple(reversed(found)) or (carried * 0,), carried


def newton_of_polynomial(polynomial: Sequence[Any], nodes: Sequence[Any]) -> NewtonForm:
    """The Newton development of a polynomial, its coefficients [x₀, …, xₖ]f as remainders of divisions.

    Args:
        polynomial: coefficients by powers of x, the constant one first, in any commutative ring.
        nodes: in any order, equal ones or not, in the same ring.

    Raises DomainError without nodes or coefficients.

    >>> newton_of_polynomial((0, 0, 0, 1), (0, 1, 1, 0)).coefficients
    (0, 1, 2, 1)
    """
    if not nodes or not polynomial:
        raise DomainError("A Newton development needs at least one node and one coefficient.")
    remaining, found = tuple(polynomial), []
    for node in nodes:
        remaining, remainder = divided_by(remaining, node)
        found.append(remainder)
    return NewtonForm(tuple(nodes), tuple(found))


def difference_quotient(polynomial: Sequence[Any], zeros: Sequence[Any]) -> tuple[Any, ...]:
    """f(x)/((x − x₁) … (x − xₙ)) = [x₁, …, xₙ, x]f as a polynomial in x (Lemma A.1.2).

    Args:
        polynomial: coefficients of f, the constant one first, in an exact ring.
        zeros: x₁ … xₙ in the same ring; each must be a zero of f as often as it is given.

    Raises DomainError, with the remainder, for a node that is not a zero of that multiplicity.

    >>> difference_quotient((0, 0, -1, 1), (0, 1, 0))
    (1,)
    """
    if not polynomial:
        raise DomainError("A polynomial needs at least one coefficient.")
    remaining = tuple(polynomial)
    for i, node in enumerate(zeros):
        remaining, remainder = divided_by(remaining, node)
        if not is_zero(remainder, "The remainder of a division"):
            raise DomainError(
                f"The node {node}, number {i + 1}, is not a zero of the multiplicity asked for: division "
                f"leaves {remainder}."
            )
    return remaining


def scaled_difference(series: PowerSeries, multiples: Sequence[Any]) -> PowerSeries:
    """[ρa₀, …, ρaₙ]f as a power series in ρ, from the power series of f at 0.

    xᵐ has the complete homogeneous polynomial hₘ₋ₙ as its divided difference, so the coefficient of ρʲ is
    the one of xⁿ⁺ʲ in f times hⱼ(a₀, …, aₙ). The result is n terms shorter than f.

    Args:
        series: f.
        multiples: a₀ … aₙ, elements of the ring of the coefficients.

    Raises DomainError without nodes or if the series has no more than n terms.

    >>> scaled_difference(PowerSeries([Fraction(1)] * 5), (0, 1, -1))
    PowerSeries([1, 0, 1])
    """
    order = len(multiples) - 1
    if order < 0:
        raise DomainError("A divided difference needs at least one node.")
    if series.length <= order:
        raise DomainError(
            f"A divided difference at {order + 1} nodes needs the coefficient of order {order}: the series "
            f"has orders 0 to {series.length - 1}."
        )
    length = series.length - order
    one = multiples[0] * 0 + 1
    homogeneous = [one] + [one * 0] * (length - 1)
    for a in multiples:
        for j in range(1, length):
            homogeneous[j] = homogeneous[j] + a * homogeneous[j - 1]
    return PowerSeries([series[order + j] * homogeneous[j] for j in range(length)])


def hermite_genocchi(polynomial: Sequence[Any], nodes: Sequence[Any]) -> Any:
    """∫ f⁽ⁿ⁾(t₀x₀ + … + tₙxₙ) dt₁ … dtₙ over the simplex, exactly, for a polynomial f; it is [x₀, …, xₙ]f.

    Args:
        polynomial: coefficients of f, the constant one first, in any commutative ring containing ℚ.
        nodes: x₀ … xₙ in the same ring, coincident ones or not.

    Raises DomainError without nodes or coefficients, and for so many that the integrand has more than
    `MONOMIALS` monomials in the t.

    >>> hermite_genocchi((0, 0, 0, 1), (1, 2, 4))
    Fraction(7, 1)
    """
    if not nodes or not polynomial:
        raise DomainError("The integral of Hermite and Genocchi needs at least one node and one coefficient.")
    order = len(nodes) - 1
    count = comb(len(polynomial), order + 1)  # the sum of comb(degree, order)
    if count > MONOMIALS:
        raise DomainError(
            f"The integral of Hermite and Genocchi at {len(nodes)} nodes has {count} monomials for "
            f"{len(polynomial)} coefficients, more than {MONOMIALS}: use newton_of_polynomial."
        )
    total = exact(polynomial[0] * nodes[0] * 0)
    # rows of powers x, x², … by multiplication only: a ball around 0 has no power
    powers = [list(accumulate([node] * (len(polynomial) - 1 - order), mul)) for node in nodes]
    for degree in range(order, len(polynomial)):
        # the degree − n th power of t₀x₀ + … + tₙxₙ, a monomial in the t at a time
        for exponents in _exponents(degree - order, order + 1):
            arrangements = Fraction(factorial(degree), prod(map(factorial, exponents)))
            weight = arrangements * simplex_moment(exponents)
            term = polynomial[degree] * ratio(weight.numerator, weight.denominator, total)
            for row, e in zip(powers, exponents):
                if e:
                    term = term * row[e - 1]
            total = total + term
    return total


@cache
def simplex_moment(exponents: tuple[int, ...]) -> Fraction:
    """∫ t₀^e₀ … tₙ^eₙ dt₁ … dtₙ over t₁ + … + tₙ ≤ 1, tᵢ ≥ 0, with t₀ = 1 − t₁ − … − tₙ.

    Integrated one variable after the other: with U = 1 − t₁ − … − tₙ₋₁ the last one gives
    ∫₀ᵁ tᵇ(U − t)ᵃ dt = Uᵃ⁺ᵇ⁺¹∫₀¹ tᵇ(1 − t)ᵃ dt, and Uᵃ⁺ᵇ⁺¹ takes the place of t₀ᵃ.

    Args:
        exponents: e₀ … eₙ, whole numbers.

    Raises DomainError without exponents or for one that is no whole number ≥ 0.

    >>> simplex_moment((0, 0, 0)), simplex_moment((1, 2))
    (Fraction(1, 2), Fraction(1, 12))
    """
    if not exponents or not all(isinstance(e, int) and e >= 0 for e in exponents):
        raise DomainError(
            f"A moment of a simplex needs exponents that are whole numbers ≥ 0, not {exponents}."
        )
    total, power = Fraction(1), exponents[0]
    for e in exponents[1:]:
        total *= _moment_of_interval(power, e)
        power += e + 1
    return total


@cache
def _moment_of_interval(a: int, b: int) -> Fraction:
    """∫₀¹ tᵇ(1 − t)ᵃ dt, a power of t at a time."""
    return sum((Fraction((-1) ** i * comb(a, i), b + i + 1) for i in range(a + 1)), Fraction(0))


def _exponents(total: int, places: int) -> Iterator[tuple[int, ...]]:
    """All tuples of that many non-negative integers with that sum."""
    if places == 1:
        yield (total,)
        return
    for first in range(total + 1):
        for rest in _exponents(total - first, places - 1):
            yield (first, *rest)
