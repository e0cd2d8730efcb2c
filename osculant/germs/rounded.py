"""Germs whose coefficients are known to a tolerance: a simple germ nearby, and how safely its class is told.

Every coefficient becomes the simplest fraction within the tolerance. Of the class of that germ it is asked
whether it would still be told if the coefficients moved by as much: the tangent space in the jets has a
matrix of some rank, the smallest singular value that counts must be well above what such moves change, and
those that are dropped must not be. So no germ within the tolerance is more degenerate in these jets, and the
one recognised is as degenerate as it is said to be. Real forms of one class are apart by more degenerate
germs. What moves change is the largest of some that are tried, in doubles: no proof.
"""

from __future__ import annotations

import random
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.tangent import JetSpace, spanning
from osculant.cas.germs.tangent_space import tangent

if TYPE_CHECKING:
    import numpy as np

#: degree of the polynomials that are taken as a whole; jets of this order are taken of others
DEGREE, JET = 30, 12
#: how far the smallest singular value that counts must be above what moves of the coefficients change
SAFETY = 10.0
#: random moves of the coefficients that are tried
MOVES = 3
#: what rounding in doubles changes
ROUNDING = 1e-12


@dataclass(frozen=True)
class Margin:
    """How safely a rank is told.

    Attributes:
        kept: the smallest singular value that counts, of rows of length 1.
        dropped: the largest that does not; 0 if all count.
        noise: how much singular values may change within the tolerance: the largest that was seen.
    """

    kept: float
    dropped: float
    noise: float

    @property
    def safe(self) -> bool:
        """Whether the rank is that for all coefficients within the tolerance, as far as was tried."""
        return self.kept > SAFETY * max(self.noise, self.dropped) and self.dropped <= SAFETY * self.noise


def nearby(germ: Germ, tolerance: float) -> Germ:
    """The germ with the simplest fractions within the tolerance as coefficients; none is left out.

    Raises DomainError for a tolerance that is not positive, and for coefficients that are not rational.

    >>> print(nearby(Germ("0.3333333333*x**2 + 0.7499999999*y**2", "x y"), 1e-8))
    (1/3*x**2 + 3/4*y**2)
    """
    if not 0 < tolerance < float("inf"):
        raise DomainError(f"tolerance: {tolerance} is no positive number.", argument="tolerance")
    if germ.field is not None:
        raise DomainError(
            "tolerance: the coefficients are roots of numbers, which are exact: leave it out.",
            argument="tolerance",
        )
    width = Fraction(tolerance)
    components = [
        {m: simplest(Fraction(c) - width, Fraction(c) + width) for m, c in f.items()} for f in _terms(germ)
    ]
    return _made(germ, components)


def simplest(low: Fraction, high: Fraction) -> Fraction:
    """The fraction with the least denominator in an interval; 0 if it is there.

    >>> simplest(Fraction(33, 100), Fraction(34, 100)), simplest(Fraction(-1, 9), Fraction(1, 9))
    (Fraction(1, 3), Fraction(0, 1))
    """
    if low <= 0 <= high:
        return Fraction(0)
    if high < 0:
        return -simplest(-high, -low)
    whole = low.numerator // low.denominator
    if whole == low:
        return Fraction(whole)
    if whole + 1 <= high:
        return Fraction(whole + 1)
    return whole + 1 / simplest(1 / (high - whole), 1 / (low - whole))


def margin(germ: Germ, near: Germ, group: Group, version: Version, order: int, tolerance: float) -> Margin:
    """How safely the rank of the tangent space of the nearby germ in jets of that order is that of the germ.

    >>> from osculant.cas.germs.groups import group as of
    >>> f = Germ("0.3333333333*x**2 + 0.2*y**3", "x y")
    >>> margin(f, nearby(f, 1e-8), of("R"), Version.EXTENDED, 3, 1e-8).safe
    True
    """
    import numpy as np

    rank = tangent(near, group, version, order).annihilator.rank
    mine = _rows(germ, group, version, order)
    scales = {label: float(np.linalg.norm(row)) or 1.0 for label, row in mine.items()}
    columns = JetSpace(germ.n, germ.p, order).columns
    matrix = np.array([row / scales[label] for label, row in mine.items()]).reshape(-1, columns)
    values = np.linalg.svd(matrix, compute_uv=False)
    draw, noise = random.Random(0), ROUNDING
    for other in (near, *(_moved(germ, draw, tolerance) for _ in range(MOVES))):
        theirs = _rows(other, group, version, order)
        labels = [*mine, *(label for label in theirs if label not in mine)]
        zero = np.zeros(columns)
        change = np.array(
            [(theirs.get(k, zero) - mine.get(k, zero)) / scales.get(k, 1.0) for k in labels]
        ).reshape(-1, columns)
        noise = max(noise, float(np.linalg.norm(change, 2)))
    values = np.concatenate([values, np.zeros(max(0, rank + 1 - len(values)))])
    return Margin(float(values[rank - 1]) if rank else float("inf"), float(values[rank]), noise)


def _rows(germ: Germ, group: Group, version: Version, order: int) -> dict[Any, np.ndarray]:
    import numpy as np

    space, found = JetSpace(germ.n, germ.p, order), {}
    place = space.place()
    for side, exponents, generator, vector in spanning(germ, group, version, order):
        row = np.zeros(space.columns)
        for j, f in enumerate(vector):
            for m, c in f.items():
                row[space.p * place[m] + j] = float(c)
        found[side, exponents, generator] = row
    return found


def _terms(germ: Germ) -> tuple[poly.Polynomial, ...]:
    return germ.polynomial(DEGREE) or germ.jet(JET)


def _moved(germ: Germ, draw: random.Random, tolerance: float) -> Germ:
    """The germ with every coefficient that is no integer moved by the tolerance, up or down."""
    width = Fraction(tolerance)
    return _made(
        germ,
        [
            {m: c if Fraction(c).denominator == 1 else c + draw.choice((-1, 1)) * width for m, c in f.items()}
            for f in _terms(germ)
        ],
    )


def _made(germ: Germ, components: list[poly.Polynomial]) -> Germ:
    kept = [{m: c for m, c in f.items() if c} for f in components]
    return Germ([as_node(f, germ.source) for f in kept], germ.source, germ.boundary)
