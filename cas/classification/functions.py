"""Where the classification of functions starts: the lowest terms of a critical point, by linear maps.

A critical point of corank c is the sum of n − c squares and of terms of order three; the cubic part in the c
other variables is moved by linear maps. A binary cubic form over ℂ has three different roots, a double one
or a triple one, or is 0: x²y + y³, x²y, x³ are the orbits, of codimension 0, 1, 2 and, for 0, 4. Over such a
start the linear maps that remain are a finite group, a torus and the fields that `weights` let raise levels.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from flint import fmpq

from osculant.cas.classification.starts import OneJet, unit
from osculant.cas.errors import UndecidedError
from osculant.cas.germs.groups import Group
from osculant.cas.recognition.forms import Column
from osculant.cas.recognition.levels import Weights, flagged

#: binary cubic forms: exponents of x and y, the codimension of the orbit, flags of x and y
CUBICS = (
    (((2, 1), (0, 3)), 0, (0, 0)),
    (((2, 1),), 1, (0, 0)),
    (((3, 0),), 2, (1, 0)),
)
#: the codimension of the form 0 in the binary cubics
NO_CUBIC = 4


@dataclass(frozen=True)
class CriticalPoint(OneJet):
    """Functions with a critical point: squares of all variables but the first ``corank``, and a cubic form.

    Attributes:
        corank: the corank of the Hessian.
        cubic: the place in `CUBICS` of the cubic form in the first two variables, for corank 2.
    """

    corank: int = 0
    cubic: int = 0

    @property
    def codimension(self) -> int:
        """The codimension of these lowest terms."""
        more = CUBICS[self.cubic][1] if self.corank == 2 else 0
        return self.n + self.corank * (self.corank + 1) // 2 + more

    @property
    def terms(self) -> dict[Column, Any]:
        """The lowest terms."""
        found: dict[Column, Any] = {}
        for i in range(self.corank, self.n):
            found[tuple(2 * e for e in unit(i, self.n)), 0] = fmpq(1)
        for m in CUBICS[self.cubic][0] if self.corank == 2 else ():
            found[(*m, *(0,) * (self.n - 2)), 0] = fmpq(1)
        return found

    @property
    def weights(self) -> Weights:
        """Weights for which N raises levels: squares may be used to move the kernel of the Hessian only."""
        own = CUBICS[self.cubic][2] if self.corank == 2 else (0,) * self.corank
        return flagged((*own, *(2,) * (self.n - self.corank)), (0,))

    @property
    def split(self) -> bool:
        """Squares are split off, and nothing but triangular linear maps and a finite group is left."""
        return True

    def fixed(self, column: Column) -> bool:
        """Whether a term is one of the lowest, which are prescribed."""
        m = column[0]
        return sum(m) <= 2 or (self.corank == 2 and sum(m) == 3 and not any(m[2:]))


def critical_points(group: Group, n: int, codimension: int) -> list[OneJet]:
    """The starts for functions of n variables up to a codimension.

    Raises UndecidedError if a start that is not built is not beyond the codimension.

    >>> from osculant.cas.germs.groups import group
    >>> [(start.codimension, list(start.terms)) for start in critical_points(group("R"), 1, 2)]
    [(0, [((1,), 0)]), (1, [((2,), 0)]), (2, [])]
    """
    found: list[OneJet] = [OneJet(group, n, 1, 1, False)]
    found += [CriticalPoint(group, n, 1, 0, False, corank) for corank in range(min(n, 1) + 1)]
    found += [CriticalPoint(group, n, 1, 0, False, 2, cubic) for cubic in range(len(CUBICS)) if n > 1]
    beyond = min([n + 3 + NO_CUBIC] * (n >= 2) + [n + 6] * (n >= 3), default=codimension + 1)
    if codimension >= beyond:
        raise UndecidedError(f"Functions of {n} variables are not classified to codimension {codimension}.")
    return [start for start in found if start.codimension <= codimension]
