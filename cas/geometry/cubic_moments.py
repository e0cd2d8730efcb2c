"""The cubics with given tangents at both ends that have the area of an arc, and its first moment.

The chord goes from (0, 0) to (c, 0). The arms are a₀, a₃ along the unit tangents T₀, T₃; ∫ y dx and ∫ xy dx
are polynomials in them, the area linear in each, so that a₃ can be eliminated: a quartic in a₀ is left.  Its
real roots are near the cubics of least distance, where the two displacements cross about as often.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy as sp

#: chord, tangents, area and moment, and the arms
CHORD, X0, Y0, X3, Y3, AREA, MOMENT = sp.symbols("c tx0 ty0 tx3 ty3 area moment", real=True)
ARM0, ARM3 = sp.symbols("a0 a3", real=True)
ARGUMENTS = CHORD, X0, Y0, X3, Y3, AREA, MOMENT


@cache
def moments() -> tuple[Any, Any]:
    """(∫ y dx, ∫ xy dx) along the cubic.

    >>> quarter = {X0: 0, Y0: 1, X3: 1, Y3: 0, ARM0: 0, ARM3: 0}
    >>> [value.subs(quarter) for value in moments()]
    [0, 0]
    """
    u = sp.Symbol("u")
    first, last = 3 * u * (1 - u) ** 2, 3 * u**2 * (1 - u)
    x = first * ARM0 * X0 + last * (CHORD - ARM3 * X3) + u**3 * CHORD
    y = first * ARM0 * Y0 - last * ARM3 * Y3
    along = sp.diff(x, u)
    area, moment = (sp.integrate(sp.expand(part * along), (u, 0, 1)) for part in (y, x * y))
    return area, moment


@cache
def other_arm() -> tuple[Any, Any]:
    """Numerator and denominator of a₃ for a given a₀ and area.

    >>> other_arm()[1].has(ARM3)
    False
    """
    area = sp.Poly(moments()[0] - AREA, ARM3)
    slope, rest = area.all_coeffs()
    return sp.factor(-rest), sp.factor(slope)


@cache
def quartic() -> list[Any]:
    """Coefficients of the quartic in a₀, from a₀⁴ to a₀⁰.

    >>> len(quartic())
    5
    """
    above, below = other_arm()
    moment = sp.Poly(moments()[1] - MOMENT, ARM3)
    degree = moment.degree()
    cleared = sum(c * above**power * below ** (degree - power) for (power,), c in moment.terms())
    return [sp.factor(c) for c in sp.Poly(sp.expand(cleared), ARM0).all_coeffs()]
