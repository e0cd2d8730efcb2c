"""What a stable perturbation of a germ of corank 1 shows, counted at the germ: special points, Euler numbers.

For a finitely determined germ (x, g(x, y)) the multiple points of each type (k₁, …, k_s) form an isolated
complete intersection of the expected dimension e or are empty (Marar and Mond), and those of a stable
perturbation its Milnor fibre. So

* e = 0: the perturbation has dim O/I points of that type with their order, and as many unordered ones as the
  dimension over the permutations of equal parts tells: (2) cross-caps and (1, 1, 1) triple points for n = 2,
  p = 3; (3) cusps and (2, 2) double folds for n = p = 2;
* the Euler characteristic of the image (p = n + 1), or of the discriminant (n = p), is the alternating sum
  Σₖ (−1)^{k+1}/k! Σ_σ sign σ · χ(Fix σ) over the permutations σ of k points (Goryunov and Mond; Goryunov):
  the points fixed by σ are those of the type of its cycles, with parts doubled for the discriminant. The
  image, or discriminant, is a bouquet of μ spheres of dimension d, n or n − 1, and χ = 1 + (−1)^d μ.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from math import factorial, prod

from osculant.cas.errors import DomainError
from osculant.cas.germs.colength import Size, Zeros, colength, milnor_of_intersection
from osculant.cas.germs.corank_one import CorankOne, corank_one
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.schemes import UNKNOWNS, cycles
from osculant.cas.germs.search import Patience

Parts = tuple[int, ...]


def isolated_types(n: int, p: int) -> Iterator[Parts]:
    """The types of multiple points that are isolated for stable germs, n ≤ p; the largest parts first.

    >>> list(isolated_types(2, 2)), list(isolated_types(2, 3)), list(isolated_types(1, 2))
    ([(3,), (2, 2)], [(2,), (1, 1, 1)], [(1, 1)])
    """
    least = 2 if n == p else 1
    for size in range(2, 2 * n + 2):
        for parts in cycles(size):
            more = n - 1 + len(parts) - (p - n + 1) * (size - 1)
            if min(parts) >= least and more == 0 and n - 1 + len(parts) <= UNKNOWNS:
                yield parts


def points(form: CorankOne, parts: Parts, patience: Patience | None = None) -> Size:
    """How many points of an isolated type a stable perturbation has, over ℂ; "infinite" if not finitely many.

    Raises UndecidedError if that is not settled in time.

    >>> points(corank_one(Germ("x, y**2, y**3 + x**4*y", "x y")), (2,))
    4
    """
    length = colength(Zeros(*form.scheme(parts)), f"scheme of the points of type {parts}", patience)
    return length if length == "infinite" else length // prod(map(factorial, Counter(parts).values()))


def milnor_of_points(form: CorankOne, parts: Parts, patience: Patience | None = None) -> Size | None:
    """The Milnor number of the points of that type; None if there are none near the origin.

    >>> milnor_of_points(corank_one(Germ("x, y**2, y**3 + x**4*y", "x y")), (1, 1))
    3
    """
    zeros = Zeros(*form.scheme(parts))
    if zeros.empty:
        return None
    what = f"multiple points of type {parts}"
    if form.expected(parts) < 0:
        return None if colength(zeros, what, patience) != "infinite" else "infinite"
    return milnor_of_intersection(zeros, what, patience)


def sphere_count(germ: Germ, patience: Patience | None = None) -> Size:
    """μ of the image (p = n + 1) or of the discriminant (n = p) of a stable perturbation, corank at most 1.

    The germ must be finitely determined: what is told of another means nothing unless it is "infinite".

    Raises DomainError for other dimensions and coranks, UndecidedError if it is not settled in time.

    >>> sphere_count(Germ("x, x*y + y**5, y**3", "x y")), sphere_count(Germ("x, x*y + y**4", "x y"))
    (2, 1)
    """
    n, p = germ.n, germ.p
    if p not in (n, n + 1):
        raise DomainError(f"An image or discriminant Milnor number needs p = n or n + 1, not {n} and {p}.")
    if germ.rank == n:
        return 0
    form, doubled = corank_one(germ, patience), n == p
    total, dimension = Fraction(0 if doubled else 1), n - doubled
    for k in range(1 if doubled else 2, n + 2):
        for parts in cycles(k):
            shape = tuple(2 * part for part in parts) if doubled else parts
            found = milnor_of_points(form, shape, patience)
            if found == "infinite":
                return "infinite"
            if found is None:
                continue
            e = max(form.expected(shape), 0)
            weight = Fraction((-1) ** (k + 1 + k - len(parts)), _centraliser(parts))
            total += weight * (1 + (-1) ** e * found)
    spheres = (total - 1) * (-1) ** dimension
    assert spheres.denominator == 1
    return int(spheres)


def _centraliser(parts: Parts) -> int:
    """k! over the number of permutations with these cycles."""
    return prod(part**count * factorial(count) for part, count in Counter(parts).items())
