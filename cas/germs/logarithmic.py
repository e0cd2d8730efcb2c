"""Vector fields tangent to a hypersurface V = {h = 0}, and the groups R(V), K(V) that preserve it.

ξ is logarithmic if ξ(h) is a multiple of h: the relations between h and its partial derivatives tell all. If
V is the discriminant of a germ with n = p, or the image of one with p = n + 1, finitely determined, they are
the liftable fields: those of the target that are df(ξ) = η∘f for some ξ of the source.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse
from osculant.cas.germs.expansion import expanded
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import FIELD_ORDER, Group
from osculant.cas.germs.model import polynomial, ring
from osculant.cas.germs.search import Patience
from osculant.cas.germs.syzygies import syzygies


def logarithmic_fields(
    h: str, names: Sequence[str], patience: Patience | None = None
) -> tuple[tuple[str, ...], ...]:
    """Generators of the module of fields ξ with ξ(h) in (h), each by its components as text.

    Args:
        h: a polynomial in the variables, 0 at the origin, not 0 everywhere.
        names: the variables.
        patience: the time that it may take; `search.SECONDS` by default.

    Raises FormulaError for text that is none, DomainError for what is no such polynomial, UndecidedError if
    the fields are not found in time.

    >>> logarithmic_fields("x**3 - y**2", ["x", "y"])
    (('2*y', '3*x**2'), ('2*x', '3*y'))
    """
    node = parse(h, names)
    if expanded((node,), tuple(names), 0)[0]:
        raise DomainError(
            f"The hypersurface {h} = 0 does not contain the origin: choose a function that is 0 there."
        )
    germ = Germ([node], names, None)
    jet = germ.polynomial(FIELD_ORDER)
    if jet is None or not jet[0] or germ.field is not None:
        raise DomainError(
            f"The hypersurface {h} = 0 needs a rational polynomial of degree at most {FIELD_ORDER}, not 0."
        )
    return fields_of(polynomial(jet[0], ring(names), germ.n), patience)


def fields_of(h: Any, patience: Patience | None = None) -> tuple[tuple[str, ...], ...]:
    """The same fields for a polynomial of flint, in the variables of its ring.

    >>> x, y = ring(["x", "y"]).gens()
    >>> fields_of(x * y)
    (('x', '-y'), ('0', 'y'))
    """
    n = h.context().nvars()
    found = syzygies([h, *(h.derivative(i) for i in range(n))], patience)
    fields = [_signed(relation[1:]) for relation in found]
    some = [field for field in fields if any(not c.is_zero() for c in field)]
    return tuple(tuple(str(c).replace("^", "**") for c in field) for field in some)


def _signed(field: Sequence[Any]) -> list[Any]:
    """The field or its negative: the first coefficient of the first component is positive."""
    leading = next((c.leading_coefficient() for c in field if not c.is_zero()), 1)
    return [-c for c in field] if leading < 0 else list(field)


def preserving(kind: str, h: str, names: Sequence[str], patience: Patience | None = None) -> Group:
    """R(V), K(V) or A(V): source changes that preserve V = {h = 0}; arguments as for `logarithmic_fields`.

    Raises DomainError for another kind.

    >>> from osculant.cas.germs.codimension import codimension
    >>> group = preserving("R", "x**3 - y**2", ["x", "y"])
    >>> codimension(Germ("x + y", "x y"), group, extended=True).value
    1
    """
    targets = {"R": "none", "K": "contact", "A": "left"}
    if kind.upper() not in targets:
        raise DomainError(f"No group {kind} preserves a hypersurface here: choose R, K or A.")
    fields = logarithmic_fields(h, names, patience)
    target: Any = targets[kind.upper()]
    return Group(f"{kind.upper()}(V)", "own", target, tuple(", ".join(field) for field in fields))
