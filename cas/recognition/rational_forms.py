"""Rational normal forms, where those of a list need numbers that are not built: the modulus by invariants.

The reduction leaves the lowest terms as they are, with rational coefficients. The member of the list is known
all the same: for a ternary cubic by Aronhold's invariants S and T, for the square of a definite quadratic
form by what the next terms are on its complex lines.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

from osculant.cas.germs import linear
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition.finishing import Finished, Terms, unchanged
from osculant.cas.recognition.obstruction import NotEquivalent
from osculant.cas.recognition.real_fields import real_roots, sign, size
from osculant.cas.recognition.roots import root
from osculant.cas.recognition.ternary import hessian_determinant


def hesse(terms: Terms, n: int, order: int, places: Sequence[int]) -> Iterator[Finished]:
    """x³ + y³ + z³ + a·xyz of a ternary cubic without singular points: a, not the coordinates.

    Over the reals there is one a, as for λ·S(a) ~ S, λ^{3/2}·T(a) ~ T with λ > 0 there is one.
    """
    form: Polynomial = {
        poly.monomial([m[i] for i in places]): c
        for (m, _), c in terms.items()
        if sum(m) == 3 == sum(m[i] for i in places)
    }
    s, t = aronhold(form)
    if 64 * s**3 + t * t == 0:
        raise NotEquivalent("The cubic of the lowest terms has a singular point.")
    yield Finished(unchanged(n), dict(terms), {"a": _hesse_parameter(s, t)})


def aronhold(form: Polynomial) -> tuple[Fraction, Fraction]:
    """(S, T) of a ternary cubic, m − m⁴ and 1 − 20m³ − 8m⁶ for x³ + y³ + z³ + 6m·xyz.

    >>> x, y, z = (poly.variable(i, 3) for i in range(3))
    >>> aronhold({3 * x: 1, 3 * y: 1, 3 * z: 1, x + y + z: 12})
    (Fraction(-14, 1), Fraction(-671, 1))
    """

    def c(i: int, j: int, k: int) -> Fraction:
        counts = (i, j, k)
        same = 6 if counts == (1, 1, 1) else 1 if max(counts) == 3 else 3
        return Fraction(form.get(poly.monomial(counts), 0)) / same

    a, b, d, m = c(3, 0, 0), c(0, 3, 0), c(0, 0, 3), c(1, 1, 1)
    a2, a3, b1, b3, c1, c2 = c(2, 1, 0), c(2, 0, 1), c(1, 2, 0), c(0, 2, 1), c(1, 0, 2), c(0, 1, 2)
    s = (
        a * b * d * m
        - (b * d * a2 * a3 + d * a * b1 * b3 + a * b * c1 * c2)
        - m * (a * b3 * c2 + b * c1 * a3 + d * a2 * b1)
        + a * (b1 * c2**2 + c1 * b3**2)
        + b * (a2 * c1**2 + c2 * a3**2)
        + d * (b3 * a2**2 + a3 * b1**2)
        - m**4
        + 2 * m**2 * (b1 * c1 + c2 * a2 + a3 * b3)
        - 3 * m * (a2 * b3 * c1 + a3 * b1 * c2)
        - (b1**2 * c1**2 + c2**2 * a2**2 + a3**2 * b3**2)
        + (c2 * a2 * a3 * b3 + a3 * b3 * b1 * c1 + b1 * c1 * c2 * a2)
    )
    # the Hessian of the Hessian is A·f + B·Hessian with B = T/108, if the second derivatives are divided by 6
    first = {k: Fraction(v) / 216 for k, v in hessian_determinant(form).items()}
    second = {k: Fraction(v) / 216 for k, v in hessian_determinant(first).items()}
    columns = sorted({*form, *first, *second})
    rows = [[Fraction(g.get(k, 0)) for g in (form, first)] for k in columns]
    found = linear.solution(rows, [Fraction(second.get(k, 0)) for k in columns], 2)
    if found is None or linear.rank(rows, 2) < 2:
        raise NotEquivalent("The cubic of the lowest terms is its own Hessian.")
    return s, 108 * found[1]


def _hesse_parameter(s: Fraction, t: Fraction) -> Any:
    """a = 6m by v = m³: T²·v(1 − v)³ = S³·(1 − 20v − 8v²)², with the signs of S and T."""
    one, other = [0, 1, -3, 3, -1], [1, -40, 384, 320, 64]
    for v in real_roots([t * t * p - s**3 * q for p, q in zip(one, other)]):
        signs = (sign(v) * sign(1 - v), sign(1 - 20 * v - 8 * v * v))
        if signs == (sign(s), sign(t)):
            return (root(216 * size(v), 3, sign(v))).value if v else Fraction(0)
    raise NotEquivalent("No cubic of Hesse's has these invariants.")


def complex_lines(terms: Terms, n: int, order: int, places: Sequence[int]) -> Iterator[Finished]:
    """±(x² + y²)² + a·xʳ of c·(x² + d·y²)² + p·xʳ + q·x^{r−1}y: it has a² = (p² + q²/d)·|c|^{−r/2}.

    If q = 0 and a sign of x makes p positive, the scales make it; else x and y must be turned.
    """
    i, j = places[:2]

    def coefficient(e: int, f: int) -> Fraction:
        return Fraction(terms.get((tuple(e * int(v == i) + f * int(v == j) for v in range(n)), 0), 0))

    c, mixed, last = coefficient(4, 0), coefficient(2, 2), coefficient(0, 4)
    r = max((sum(m) for m, _ in terms), default=4)
    p, q = coefficient(r, 0), coefficient(r - 1, 1)
    if mixed * c <= 0 or mixed * mixed != 4 * c * last or coefficient(3, 1) or coefficient(1, 3):
        raise NotEquivalent("The lowest terms are no square of a definite form.")
    d = mixed / (2 * c)
    if r < 5 or not (p or q):
        raise NotEquivalent("There are no higher terms on the complex lines of the lowest jet.")
    turned = q or (r % 2 == 0 and p < 0)
    a = root((p * p + q * q / d) ** 2 / abs(c) ** r, 4).value
    yield Finished(unchanged(n), dict(terms), {"a": a} if turned else None)
