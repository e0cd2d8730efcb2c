"""How much of θ, or of O, is left modulo a tangent space, or an ideal, and a power of the maximal ideal.

The functionals that vanish on T in the jets of order k tell dim θ/(T + M^{i+1}θ) for all i ≤ k at once: it is
the number of those independent ones that live in degrees up to i.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from osculant.cas.germs.algebraic import NumberField
from osculant.cas.germs.annihilator import Functional, annihilator
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.linear import echelon
from osculant.cas.germs.local_algebra import multiples
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.germs.tangent import JetSpace
from osculant.cas.germs.tangent_space import tangent

#: generators(k): an ideal's generators, cut above degree k
Generators = Callable[[int], Sequence[Polynomial]]


def dimensions(functionals: Sequence[Functional], space: JetSpace) -> tuple[int, ...]:
    """dim θ/(T + M^{i+1}θ) for i = 0, …, order, from the functionals that vanish on T in the jets.

    >>> space = JetSpace(1, 1, 2)
    >>> dimensions([{0: 1}, {0: 2, 1: 3}], space)
    (1, 2, 2)
    """
    columns = sorted({c for f in functionals for c in f}, reverse=True)  # the highest degrees first
    _, leading = echelon([[f.get(c, 0) for c in columns] for f in functionals], len(columns))
    found = [0] * (space.order + 1)
    for place in leading:
        found[space.degree(columns[place])] += 1
    return tuple(sum(found[: i + 1]) for i in range(space.order + 1))


def orbit_codimensions(germ: Germ, group: Group, version: Version, order: int) -> tuple[int, ...]:
    """The codimensions of the tangent space in the jets of orders 0, …, order; exact.

    In Jⁱ of θ for the extended version, of Mθ for the others.

    >>> from osculant.cas.germs.groups import group
    >>> orbit_codimensions(Germ("x, x*y + y**3", "x y"), group("A"), Version.ORDINARY, 4)
    (0, 1, 2, 2, 2)
    """
    t = tangent(germ, group, version, order)
    constants = 0 if version is Version.EXTENDED else germ.p
    return tuple(d - constants for d in dimensions(t.annihilator.functionals, t.space))


def ideal_dimensions(
    generators: Generators, n: int, order: int, field: NumberField | None = None
) -> tuple[int, ...]:
    """dim O/(I + M^{i+1}) for i = 0, …, order; exact.

    >>> from osculant.cas.germs import polynomials as poly
    >>> x, y = poly.variable(0, 2), poly.variable(1, 2)
    >>> ideal_dimensions(lambda k: [{2 * x: 1}, {x + y: 1}], 2, 3)
    (1, 3, 4, 5)
    """
    space = JetSpace(n, 1, order)
    found = annihilator(multiples(generators(order), space), space.columns, field)
    return dimensions(found.functionals, space)
