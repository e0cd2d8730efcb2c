"""Codimension at an algebraic number: a root a₀ of a polynomial q irreducible over ℚ.

The field ℚ(a₀) is a vector space over ℚ of dimension s = deg q. Each entry of a matrix becomes the s × s
matrix of the multiplication by it: the rank over ℚ is s times that over ℚ(a₀), and the exact annihilator
over ℚ serves as for rational germs.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import lcm
from typing import Any

from flint import fmpq_poly, fmpz_poly

from osculant.cas.germs.annihilator import annihilator
from osculant.cas.germs.family import GenericGerm
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.tangent import JetSpace, Vector, vectors

#: of a polynomial over ℤ, the constant one first
Coefficients = tuple[int, ...]

#: orders beyond the generic one that are tried
MORE = 6
#: columns of the largest matrix made
COLUMNS = 7000


@dataclass(frozen=True)
class AtRoot:
    """The codimension at the roots of q: at least ``at_least``, and that exactly if ``settled``."""

    at_least: int
    settled: bool


def codimension_at_root(germ: GenericGerm, g: Group, extended: bool, q: Coefficients, order: int) -> AtRoot:
    """The codimension at the roots of q, by the criterion for rational germs.

    Jets from ``order`` to a few orders above are tried; if they do not settle it, it may be infinite.

    >>> from osculant.cas.germs.family import Family
    >>> from osculant.cas.germs.groups import group
    >>> generic = GenericGerm(Family("(a**2 - 2)*x**3 + x**5", "x", "a"))
    >>> codimension_at_root(generic, group("R"), True, (-2, 0, 1), 4)
    AtRoot(at_least=4, settled=True)
    """
    version = Version.EXTENDED if extended else Version.ORDINARY
    margin = 1
    if g.target == "left":
        contact = Group(g.name, g.source, "contact", g.fields)
        found, depth = _settled(germ, contact, Version.EXTENDED, q, 0, order + MORE, 1)
        margin = depth + 1 if found.settled else order + MORE + 2  # without a bound on l nothing is settled
    return _settled(germ, g, version, q, order, order + MORE, max(margin, 1))[0]


def _settled(
    germ: GenericGerm, g: Group, version: Version, q: Coefficients, first: int, last: int, margin: int
) -> tuple[AtRoot, int]:
    """(codimension, depth) at the first order that is ``margin`` above the depth, or at the last."""
    s = len(q) - 1
    constants = 0 if version is Version.EXTENDED else germ.p
    for order in range(first, last + 1):
        space = JetSpace(germ.n, germ.p, order)
        if order > first and s * space.columns > COLUMNS:
            break
        rows = [r for v in vectors(germ, g, version, order) for r in _over_the_rationals(v, space, q)]
        found = annihilator(rows, s * space.columns)
        depth = max((space.degree(c // s) for f in found.functionals for c in f), default=-1)
        settled = order >= depth + margin
        if settled:
            break
    return AtRoot(found.codimension // s - constants, settled), depth


def _over_the_rationals(vector: Vector, space: JetSpace, q: Coefficients) -> list[dict[int, int]]:
    """The vector times 1, a, …, a^{s−1} as integer rows of coordinates by powers of a."""
    place, p, s = space.place(), space.p, len(q) - 1
    field, a = fmpq_poly(list(q)), fmpq_poly([0, 1])
    entries: dict[int, Any] = {
        p * place[m] + j: fmpq_poly([c]) if isinstance(c, int) else c
        for j, f in enumerate(vector)
        for m, c in f.items()
    }
    found = []
    for _ in range(s):
        entries = {c: reduced for c, v in entries.items() if (reduced := v % field)}
        common = lcm(*(int(v.denom()) for v in entries.values()))
        row = {
            c * s + i: int(x.p) * (common // int(x.q))
            for c, v in entries.items()
            for i, x in enumerate(v.coeffs())
            if x
        }
        if row:
            found.append(row)
        entries = {c: v * a for c, v in entries.items()}
    return found


def rational_root(q: Coefficients) -> Fraction | None:
    """The root of an irreducible polynomial if it is rational.

    >>> rational_root((-3, 2))
    Fraction(3, 2)
    """
    return Fraction(-q[0], q[1]) if len(q) == 2 else None


def real_roots(q: Coefficients) -> int:
    """How many roots of a polynomial without multiple roots are real.

    >>> real_roots((-2, 0, 0, 1)), real_roots((-2, 0, 1))
    (1, 2)
    """
    roots: Any = fmpz_poly(list(q)).complex_roots()
    return sum(1 for root, _ in roots if root.imag == 0)


def polynomial_text(q: Coefficients, name: str) -> str:
    """The polynomial in a variable of that name, as a formula.

    >>> polynomial_text((-1, 0, -2, 3), "a")
    '3*a**3 - 2*a**2 - 1'
    """
    terms = []
    for i, c in reversed(list(enumerate(q))):
        if c:
            power = "" if i == 0 else name if i == 1 else f"{name}**{i}"
            size = str(abs(c)) if not power else power if abs(c) == 1 else f"{abs(c)}*{power}"
            terms.append(("- " if c < 0 else "+ ") + size)
    text = " ".join(terms)
    return text[2:] if text.startswith("+ ") else "-" + text[2:]
