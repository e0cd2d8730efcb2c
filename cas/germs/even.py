"""Germs that are even in one variable: S(…, λ) = f(…, λ²), with u = λ² the boundary variable of f.

The A-classes of such germs under changes of coordinates that commute with λ ↦ −λ are the A(H)-classes of f,
H = {u = 0}; likewise for R and K.
"""

from __future__ import annotations

from collections.abc import Iterable

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import to_text
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.polynomials import Polynomial

#: what the boundary variable u = λ² is called
BOUNDARY = "u"
#: degree of a polynomial that is read as an even germ at most
DEGREE = 60


def fresh(name: str, taken: Iterable[str]) -> str:
    """The name, repeated as often as it takes to differ from all names that are taken.

    >>> fresh("v", ["x", "v"])
    'vv'
    """
    known, found = set(taken), name
    while found in known:
        found += name
    return found


def halve(f: Polynomial, place: int, n: int) -> Polynomial:
    """The polynomial in u = λ² in place of λ, variable number ``place`` of n; DomainError if it is not even.

    >>> halve({poly.monomial((1, 4)): 3}, 1, 2) == {poly.monomial((1, 2)): 3}
    True
    """
    found = {}
    for m, c in f.items():
        exponents = list(poly.exponents_of(m, n))
        exponents[place], odd = divmod(exponents[place], 2)
        if odd:
            raise DomainError("The polynomial is not even.")
        found[poly.monomial(exponents)] = c
    return found


def double(f: Polynomial, place: int, n: int) -> Polynomial:
    """The polynomial with λ² in place of u: what `halve` takes back.

    >>> double({poly.monomial((1, 2)): 3}, 1, 2) == {poly.monomial((1, 4)): 3}
    True
    """
    unit = poly.variable(place, n)
    return {m + poly.exponents_of(m, n)[place] * unit: c for m, c in f.items()}


def halved(germ: Germ, even: str) -> Germ:
    """The germ f with f(…, λ²) = S(…, λ), in a boundary variable called u, or uu if there is a variable u.

    Args:
        germ: S, a polynomial of degree `DEGREE` at most.
        even: the name of λ.

    Raises DomainError if λ is no source variable, if S is no such polynomial, or not even in λ.

    >>> str(halved(Germ("v, l**2 + v*x", "x l v"), "l"))
    '(v, u + x*v)'
    """
    if even not in germ.source:
        raise DomainError(
            f"even: {even!r} is not a source variable: choose one of {', '.join(germ.source)}.",
            argument="even",
        )
    jet, place = germ.polynomial(DEGREE), germ.source.index(even)
    if jet is None:
        raise DomainError(
            f"even: a germ even in {even} must be a polynomial of degree at most {DEGREE}: give a jet of it.",
            argument="even",
        )
    source = [name for name in germ.source if name != even]
    source.insert(place, fresh(BOUNDARY, source))
    components = []
    for i, f in enumerate(jet, start=1):
        odd = [m for m in f if poly.exponents_of(m, germ.n)[place] % 2]
        if odd:
            term = to_text(as_node({min(odd): f[min(odd)]}, germ.source, germ.field))
            raise DomainError(
                f"even: component {i} of the germ has the term {term}, which is odd in {even}: a germ even "
                f"in {even} has even powers of it only.",
                argument="even",
            )
        components.append(as_node(halve(f, place, germ.n), tuple(source), germ.field))
    return Germ(components, source, source[place], germ.field)


def doubled(germ: Germ, even: str) -> Germ:
    """The even germ f(…, λ²) of a polynomial germ f with boundary variable u; λ gets that name.

    Raises DomainError if f has no boundary or is no polynomial of degree at most `DEGREE`.

    >>> str(doubled(Germ("v, u + x*v", "x u v"), "lam"))
    '(v, lam**2 + x*v)'
    """
    jet, place = germ.polynomial(DEGREE), germ.boundary_index
    if jet is None:
        raise DomainError(f"{germ} is not a polynomial of degree at most {DEGREE}.")
    source = tuple(even if i == place else name for i, name in enumerate(germ.source))
    nodes = [as_node(double(f, place, germ.n), source, germ.field) for f in jet]
    return Germ(nodes, source, None, germ.field)
