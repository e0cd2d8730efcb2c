"""Dimensions of local rings ℚ[v]/I at the origin, and Milnor numbers of isolated complete intersections.

A generator with a linear term c·v and no other v is solved for v first: the ring is that of fewer variables.
What is left is a linear algebra of jets, exact by Nakayama's lemma; "infinite" is proved by a dimension.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from typing import Any, Literal

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.local_algebra import q_algebra
from osculant.cas.germs.loci import minors
from osculant.cas.germs.model import Model, ring
from osculant.cas.germs.search import Patience

Size = int | Literal["infinite"]
#: choices of generators that are tried for the steps of Lê and Greuel
CHOICES = 3


@dataclass(frozen=True)
class Zeros:
    """An ideal at the origin: ``generators`` in the ring ``context`` of polynomials.

    >>> R = ring(["x", "y", "z"])
    >>> x, y, z = R.gens()
    >>> [str(f) for f in Zeros(R, [z - x*y, x**2 + z, y**3]).solved().generators]
    ['x^2 + x*y', 'y^3']
    """

    context: Any
    generators: Sequence[Any]

    @property
    def empty(self) -> bool:
        """Whether a generator is not 0 at the origin."""
        zero = (0,) * self.context.nvars()
        return any(zero in f.to_dict() for f in self.generators)

    def solved(self) -> Zeros:
        """The same ring without the variables that generators give as functions of the others."""
        context, found = self.context, [f for f in self.generators if not f.is_zero()]
        while (step := _solvable(context, found)) is not None:
            place, i, value = step
            names = [name for k, name in enumerate(context.names()) if k != i]
            smaller = ring(names)
            gens = list(smaller.gens())
            rest = [*gens[:i], smaller.constant(0), *gens[i:]]
            images = [*gens[:i], value.compose(*rest, ctx=smaller), *gens[i:]]
            moved = [f.compose(*images, ctx=smaller) for k, f in enumerate(found) if k != place]
            context, found = smaller, [f for f in moved if not f.is_zero()]
        return Zeros(context, found)


def _solvable(context: Any, generators: Sequence[Any]) -> tuple[int, int, Any] | None:
    """(generator, variable, its value): the shortest generator that is linear in a variable alone."""
    n = context.nvars()
    for place in sorted(range(len(generators)), key=lambda k: len(generators[k].to_dict())):
        told = {tuple(map(int, m)): c for m, c in generators[place].to_dict().items()}
        for i in range(n):
            unit = tuple(int(k == i) for k in range(n))
            if unit in told and all(m == unit or not m[i] for m in told):
                if n == 1:
                    continue
                return place, i, context.gens()[i] - generators[place] / told[unit]
    return None


def colength(zeros: Zeros, what: str, patience: Patience | None = None) -> Size:
    """The dimension of the local ring at the origin: a number, or "infinite" where that is proved.

    Args:
        zeros: the ideal.
        what: the name of the ring, for errors.
        patience: the time that it may take; `search.SECONDS` by default.

    Raises UndecidedError if it is not settled in that time.

    >>> R = ring(["x", "y"])
    >>> x, y = R.gens()
    >>> colength(Zeros(R, [x**2, y**3 + x]), "example"), colength(Zeros(R, [x*y]), "example")
    (6, 'infinite')
    """
    if zeros.empty:
        return 0
    small = zeros.solved()
    if small.empty:
        return 0
    names = small.context.names()
    if len(small.generators) < len(names):
        return "infinite"  # Krull
    germ = Germ([as_node(_terms(f), names) for f in small.generators], names, None)
    try:
        return q_algebra(germ, patience, what).dimension
    except DomainError:
        return "infinite"


def _terms(f: Any) -> poly.Polynomial:
    found: poly.Polynomial = {}
    for m, c in f.to_dict().items():
        q = Fraction(int(c.p), int(c.q))
        found[poly.monomial(tuple(map(int, m)))] = int(q) if q.denominator == 1 else q
    return found


def milnor_of_intersection(zeros: Zeros, what: str, patience: Patience | None = None) -> Size:
    """The Milnor number of an isolated complete intersection; "infinite" if the zeros are not one.

    The steps of Lê and Greuel: μ(f₁, …, f_j) + μ(f₁, …, f_{j−1}) = dim O/(f₁, …, f_{j−1}, the largest minors
    of d(f₁, …, f_j)), for combinations of the generators all of which are isolated complete intersections,
    as general ones are. For points it is the dimension of the ring less 1.

    Raises UndecidedError if the numbers are not settled in time, DomainError if the origin is no zero.

    >>> R = ring(["x", "y", "z"])
    >>> x, y, z = R.gens()
    >>> milnor_of_intersection(Zeros(R, [x**2 + y**2 + z**2, y*z]), "four lines"), milnor_of_intersection(
    ...     Zeros(R, [x**3 + y**2 + z**4]), "E6")
    (5, 6)
    """
    if zeros.empty:
        raise DomainError(f"The {what} do not pass through the origin: they have no Milnor number there.")
    small = zeros.solved()
    generators, n = list(small.generators), small.context.nvars()
    if not generators:
        return 0
    if len(generators) >= n:
        length = colength(small, what, patience)
        return length if length == "infinite" else length - 1
    if colength(_step(small, generators, len(generators)), f"singular {what}", patience) == "infinite":
        return "infinite"
    for choice in range(CHOICES):
        total = _greuel(small, _combined(generators, choice), what, patience)
        if total is not None:
            return total
    raise UndecidedError(f"The Milnor number of the {what}: {CHOICES} combinations of equations fail.")


def _greuel(zeros: Zeros, combined: Sequence[Any], what: str, patience: Patience | None) -> int | None:
    total = 0
    for j in range(1, len(combined) + 1):
        step = colength(_step(zeros, combined[:j], j - 1), what, patience)
        if step == "infinite":
            return None
        total = step - total
    return total


def _step(zeros: Zeros, functions: Sequence[Any], kept: int) -> Zeros:
    """The first functions, and the largest minors of the Jacobian matrix of all of them."""
    n = zeros.context.nvars()
    rows = [[f.derivative(i) for i in range(n)] for f in functions]
    model = Model(zeros.context, n, (), ())
    return Zeros(zeros.context, [*functions[:kept], *minors(rows, len(functions), model)])


def _combined(generators: Sequence[Any], choice: int) -> list[Any]:
    """Unipotent combinations of the generators, in another way for each choice."""
    found = list(generators)
    for i, k in combinations(range(len(found)), 2):
        factor = choice * (2 * i + 3 * k + 1)
        found[i] = found[i] + found[k] * factor
    return found
