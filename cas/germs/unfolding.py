"""Stability, versal unfoldings and the stable unfoldings of a genotype.

A germ is stable for A or A(H) exactly if θ = T K_e f + (constants) (Mather; for the boundary, thesis 6.4).
The terms that span θ modulo T G_e f make a miniversal unfolding f + Σ tᵢφᵢ; those that span Mθ modulo T K_e
g make the least stable unfolding of a genotype g.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import Node, variable
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.annihilator import annihilator
from osculant.cas.germs.codimension import codimension, contact_bound
from osculant.cas.germs.geometry import Degeneration
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version, group
from osculant.cas.germs.search import Patience
from osculant.cas.germs.tangent import JetSpace, Vector, rows, vectors
from osculant.cas.germs.versal import Family

Term = tuple[int, int]


@dataclass(frozen=True)
class Unfolding:
    """The unfolding (t, f + Σ tᵢφᵢ): its ``terms`` φᵢ, as (monomial, component), and the germ as a whole."""

    terms: tuple[Term, ...]
    germ: Germ


def is_stable(germ: Germ, name: str | Group, patience: Patience | None = None) -> bool:
    """Whether the germ is stable for A or A(H), decided exactly.

    Raises DomainError for groups without target changes of coordinates, UndecidedError if K-finiteness is not
    settled.

    >>> is_stable(Germ("x, x*y + y**3", "x y"), "A"), is_stable(Germ("x, y**3", "x y"), "A")
    (True, False)
    """
    g = group(name)
    if g.target != "left":
        raise DomainError(f"Stability is asked of A or A(H), not of {g.name}.")
    family = None if g.source == "own" else unfolded_germ(germ)  # own fields name all variables
    f = germ if family is None else family.germ
    bound = contact_bound(f, g, patience)
    if isinstance(bound, Degeneration):
        return False  # a stable germ is K-finite
    return not _beyond_constants(f, g, bound, [] if family is None else family.velocities(max(bound, 1)))


def unfolded_germ(germ: Germ) -> Family | None:
    """A germ (t, F(t, x)) as an unfolding of F(0, ·); None if no component is a variable, or nothing is left.

    >>> family = unfolded_germ(Germ("x, x*y + y**3", "x y"))
    >>> family.parameters, str(family.germ)
    (('x',), '(y**3)')
    """
    bare = dict.fromkeys(f.value for f in germ.components if f.kind == "variable")
    names = [name for name in bare if name != germ.boundary]
    once = sum(f.kind == "variable" and f.value in names for f in germ.components) == len(names)
    if not (0 < len(names) < min(germ.n, germ.p) and once):
        return None
    return Family(germ, names)


def _beyond_constants(germ: Germ, g: Group, bound: int, velocities: Sequence[Vector]) -> bool:
    """Whether T K_e f + constants + velocities is less than everything; T K_e f contains M^bound θ.

    An unfolding (t, F) of f is stable if that is everything, with its velocities ∂F/∂tᵢ at t = 0.
    """
    space = JetSpace(germ.n, germ.p, max(bound, 1))
    contact = Group(g.name, g.source, "contact", g.fields)
    constants: list[Vector] = [tuple({0: 1} if i == j else {} for i in range(germ.p)) for j in range(germ.p)]
    spanning = [*vectors(germ, contact, Version.EXTENDED, space.order), *constants, *velocities]
    return annihilator(rows(spanning, space), space.columns, germ.field).codimension > 0


def unfolding(
    germ: Germ, name: str | Group, parameter: str = "t", patience: Patience | None = None
) -> Unfolding:
    """A miniversal unfolding, with as many parameters as the extended codimension.

    That of a function up to R has the constant 1 among its terms.

    Raises DomainError if the codimension is infinite: there is no versal unfolding then.

    >>> unfolding(Germ("x**4", "x"), "R").germ.text(4)[-1]
    't1 + t2*x + t3*x**2 + x**4'
    """
    g = group(name)
    found = codimension(germ, g, extended=True, patience=patience)
    if found.tangent is None:
        raise DomainError(f"{germ} has no versal unfolding: its {g.name} codimension is infinite.")
    terms = found.tangent.complement()
    return Unfolding(terms, _unfolded(germ, terms, parameter))


def stable_unfolding(genotype: Germ, name: str | Group, parameter: str = "t") -> Unfolding:
    """The least stable unfolding of a germ g: by a basis of Mθ modulo T K_e g.

    Raises DomainError if g is not K-finite.

    >>> stable_unfolding(Germ("x**3", "x"), "A").germ.text(3)
    ('t1', 't1*x + x**3')
    """
    g = group(name)
    contact = Group(g.name, g.source, "contact", g.fields)
    found = codimension(genotype, contact, extended=True)
    if found.tangent is None:
        raise DomainError(f"{genotype} has no stable unfolding: {found.proof}.")
    terms = tuple(term for term in found.tangent.complement() if term[0])
    return Unfolding(terms, _unfolded(genotype, terms, parameter))


def _unfolded(germ: Germ, terms: tuple[Term, ...], parameter: str) -> Germ:
    names = [f"{parameter}{i + 1}" for i in range(len(terms))]
    clash = set(names) & set(germ.source)
    if clash:
        raise DomainError(
            f"The name {sorted(clash)[0]!r} of a parameter is a source variable: choose another letter."
        )
    components: list[Node] = list(germ.components)
    for name, (m, j) in zip(names, terms):
        term = variable(name)
        for x, e in zip(germ.source, poly.exponents_of(m, germ.n)):
            term = term * variable(x) ** e if e else term
        components[j] = components[j] + term
    boundary = germ.boundary
    return Germ([*map(variable, names), *components], (*names, *germ.source), boundary, germ.field)
