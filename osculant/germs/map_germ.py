"""Map-germs at the front door: `germ` and its answers.

Every answer is exact, or "infinite" where that is proved; UndecidedError tells the cap that was reached.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.expression import to_text
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group
from osculant.cas.germs.groups import group as group_of
from osculant.germs.reading import names_of, read_germ

if TYPE_CHECKING:
    from osculant.cas.germs.codimension import Codimension
    from osculant.cas.germs.determinacy import Determinacy
    from osculant.cas.germs.local_algebra import LocalAlgebra
    from osculant.cas.germs.search import Patience
    from osculant.cas.germs.unfolding import Unfolding
    from osculant.cas.germs.versal import Versality
    from osculant.germs.recognition import Recognised
    from osculant.germs.solutions import Combination

Size = int | Literal["infinite"]
#: part of the patience that a question of several has at least
LEAST = 0.03
GroupName = str | Group | None


def germ(
    formulas: Any,
    source: Any,
    boundary: Any = None,
    *,
    at: Any = None,
    patience: float = 10.0,
    root: str | None = None,
    even: Any = None,
) -> MapGerm:
    """A map-germ (Kⁿ,0) → (Kᵖ,0) from the formulas of its components.

    Args:
        formulas: text such as ``"x, x*y + y**3"``; a `pathlib.Path` of a file with such text, of up to a
            million bytes; one component or a sequence of them: texts, sympy or symengine expressions, or
            dictionaries such as ``{(1, 1): 1, (0, 3): Fraction(1, 2)}`` from exponents to coefficients.
        source: the source variables in order: their names separated by blanks, or a sequence of names or
            symbols.
        boundary: the variable u of H = {u = 0} for the groups R(H), K(H) and A(H), which preserve H; by
            default the variable called ``u`` if there is one.
        at: the point of the germ, if it is not the origin: text such as ``"1, -1/2"`` or a sequence of exact
            rational numbers, no floats. It is moved to the origin, and its image too: x ↦ f(a + x) − f(a).
        patience: seconds of processor time for a question (a report: for all of them, and a little more, in
            all less than a fifth, for those that are left then); what is not decided is told to be undecided.

        root: an irreducible polynomial in one variable, such as ``"a**2 - a - 1"``: its name stands for a
            root of it in the formulas, any one: the answers are the same for all. Without, roots of numbers
            such as sqrt(2) and 3**(1/3) may stand in formulas. The number field has degree 12 at most.
        even: a variable λ in which the germ S is even: it is read as f with S(…, λ) = f(…, λ²), and the
            boundary variable u = λ². Then the group A is A(H), that of even germs, and so for R and K.

    Raises FormulaError for what is no formula, uses other variables or has no component, and for a file that
    cannot be read; DomainError for a germ that does not vanish at 0, is not analytic there or has
    coefficients that are not algebraic, for a root that is not as above, for a boundary that is no source
    variable, for a point that is not exact, has another dimension or is off the boundary, for a germ called
    even that is not, and for a patience that is not positive.

    >>> germ("x1, x2, x3**2 + x1*u + x2*u**2 + u**3", "x1 x2 x3 u").codimension("A(H)")
    3
    >>> from sympy.abc import x, y
    >>> germ([x, y**2, 0], [x, y]).codimension("A")
    'infinite'
    >>> germ([{(2,): 1, (4,): -1}], "x", at=[0]).components, germ("x**3 - 3*x", "x", at="1").components
    (('x**2 - x**4',), ('x**3 + 3*x**2',))
    >>> germ("x, y**3 + sqrt(2)*x*y", "x y").codimension("A")
    2
    >>> germ("x**3 + a*x**2*y**2 + y**6", "x y", root="4*a**3 + 27").codimension("R")
    'infinite'
    >>> germ("x, x*lam^2 + lam^4", "x lam", even="lam")
    <MapGerm x, x*u + u**2 in x u>
    """
    if not patience > 0:
        raise DomainError(f"patience: {patience} is no positive number of seconds.", argument="patience")
    found = read_germ(formulas, source, boundary, at, root, even)
    return MapGerm(found.germ, patience, found.at, found.even)


@dataclass(frozen=True)
class GermUnfolding:
    """An unfolding (t, f + Σ tᵢφᵢ): the ``terms`` φᵢ as text, and the ``germ`` as a whole."""

    terms: tuple[str, ...]
    germ: MapGerm


class MapGerm:
    """A map-germ; `germ` makes it, and `osculant.germs.report.report` tells all answers as plain data.

    Groups are named "R", "L", "C", "K", "A", "R(H)", "K(H)", "A(H)", or are `Group` objects. Where none is
    named, the group is A, or R for a function (p = 1), with (H) if there is a boundary variable. An (H) group
    without one is a DomainError; where the caps are reached, UndecidedError is raised.

    Attributes:
        exact: the germ as the exact room `osculant.cas.germs` has it.
        source: the names of the source variables.
        target: the target dimension p.
        boundary: the variable u of H = {u = 0}, or None.
        components: the formulas of the components.
        rank: the rank of df at 0.
        at: the coordinates of the point that was moved to the origin, as text, or None.
        even: the germ S(…, λ) = f(…, λ²), as ``exact`` is, from which this one was read, or None.
        seconds: of processor time for one question; then UndecidedError is raised.
        clock: the time for several questions together, if there is one.

    >>> cusp = germ("x, x*y + y^3", "x y")
    >>> cusp.source, cusp.target, cusp.rank, cusp.components
    (('x', 'y'), 2, 1, ('x', 'x*y + y**3'))
    """

    def __init__(
        self,
        exact: Germ,
        patience: float = 10.0,
        at: tuple[str, ...] | None = None,
        even: Germ | None = None,
    ) -> None:
        self.exact, self.at, self.even = exact, at, even
        self.source, self.target, self.boundary = exact.source, exact.p, exact.boundary
        self.components = tuple(to_text(node) for node in exact.components)
        self.rank = exact.rank
        self._codimensions: dict[tuple[Group, bool], Codimension] = {}
        self.seconds = patience
        self.clock: Patience | None = None

    @property
    def names(self) -> tuple[str, ...]:
        """The names in the formulas: the source variables and a root of a polynomial, if one is stated."""
        field = self.exact.field
        return self.source if field is None or field.name is None else (*self.source, field.name)

    def group(self, name: GroupName = None) -> Group:
        """The group of that name, or the one that is meant where none is named; DomainError if unknown.

        >>> germ("x**2 + u", "x u").group().name
        'R(H)'
        """
        if name is None:
            name = ("R" if self.target == 1 else "A") + ("" if self.boundary is None else "(H)")
        elif self.even is not None and name in {"R", "K", "A"}:
            name = f"{name}(H)"  # what acts on even germs
        return group_of(name)

    def codimension(self, group: GroupName = None, *, extended: bool = False) -> Size:
        """The codimension of T G f in Mθ, or with ``extended`` that of T G_e f in θ.

        >>> whitney = germ("x, y**2, x*y", "x y")
        >>> whitney.codimension("A"), whitney.codimension("A", extended=True)
        (2, 0)
        """
        return self.proved_codimension(group, extended=extended).value

    def determinacy(self, group: GroupName = None) -> Determinacy:
        """The degree of determinacy that is proved, with its proof, and whether it is known to be sharp.

        >>> germ("x, y**2, y**3 + x**2*y", "x y").determinacy("A").degree
        3
        """
        from osculant.cas.germs.determinacy import determinacy

        return determinacy(self.exact, self.group(group), self.patience)

    def is_stable(self, group: GroupName = None) -> bool:
        """Whether the germ is stable for A or A(H); DomainError for other groups.

        >>> germ("x, x*y + y**3", "x y").is_stable("A")
        True
        """
        from osculant.cas.germs.unfolding import is_stable

        return is_stable(self.exact, self.group(group), self.patience)

    def unfolding(self, group: GroupName = None, parameter: str = "t") -> GermUnfolding:
        """A miniversal unfolding, with parameters t1, t2, …; DomainError for infinite codimension.

        >>> germ("x, y**2, y**3 + x**2*y", "x y").unfolding("A").terms
        ('(0, 0, y)',)
        """
        from osculant.cas.germs.unfolding import unfolding

        return self._unfolded(unfolding(self.exact, self.group(group), parameter, self.patience))

    def versality(self, parameters: Any, group: GroupName = None) -> tuple[MapGerm, Versality]:
        """The germ F(t, x), or (t, F(t, x)), read as an unfolding of f = F(0, ·): f, and whether F is versal.

        Without a group, the one that is meant for f. DomainError for parameters that are no source variables
        or leave none, and for infinite codimension.

        >>> f, found = germ("a, x**3 + a*x", "a x").versality("a", "K")
        >>> f, found.versal, tuple(map(f.term, found.missing))
        (<MapGerm x**3 in x>, False, ('1',))
        """
        from osculant.cas.germs.versal import Family, versality

        family = Family(self.exact, names_of(parameters))
        f = MapGerm(family.germ, self.seconds)
        return f, versality(family, f.group(group), self.patience)

    def stable_unfolding(self, group: GroupName = None, parameter: str = "t") -> GermUnfolding:
        """The least stable unfolding of the germ, taken as a genotype; DomainError if it is not K-finite.

        >>> germ("x**4", "x").stable_unfolding("A").germ.components
        ('t1', 't2', 'x**4 + t1*x + t2*x**2')
        """
        from osculant.cas.germs.unfolding import stable_unfolding

        return self._unfolded(stable_unfolding(self.exact, self.group(group), parameter))

    def transversal(
        self, k: int, group: GroupName = None, order: str | Sequence[str] = ()
    ) -> tuple[str, ...]:
        """A complete (k + 1)-transversal over the k-jet, k ≥ 1: its terms as text.

        With ``order``, names of source variables and target coordinates y1, y2, … with the lightest first,
        nilpotent linear fields are used that may make it smaller.  UndecidedError beyond the caps on jets.

        >>> e7 = germ("x**3 + x*y**3", "x y")
        >>> e7.transversal(4, "K"), e7.transversal(4, "K", order="y x")
        (('y**5',), ())
        """
        from osculant.cas.germs.codimension import last_order
        from osculant.cas.germs.transversal import transversal

        if k >= (last := last_order(self.exact)):
            raise UndecidedError(f"A transversal over a {k}-jet is out of reach: choose k < {last}.")
        return tuple(map(self.term, transversal(self.exact, k, self.group(group), order)))

    def recognise(self, group: GroupName = None, tolerance: float | None = None) -> Recognised:
        """The class of the germ in the lists of the literature (`osculant.germs.recognition`).

        >>> germ("x, x*y + y**4 + x**3", "x y").recognise().name
        '5'
        """
        from osculant.germs.recognition import recognised

        return recognised(self, group, tolerance)

    def solve(
        self, target: Any, order: int, group: GroupName = None, version: str = "ordinary"
    ) -> Combination | None:
        """A vector field X of the group with X·f = target up to an order (`osculant.germs.solutions.solve`).

        >>> print(germ("x**3 + y**2", "x y").solve("x**2*y", 3, "K"))
        (1/3) y ∂/∂x
        """
        from osculant.germs.solutions import solve

        return solve(self, target, order, group, version)

    @property
    def milnor(self) -> Size:
        """The Milnor number dim O/(∂f/∂x₁, …, ∂f/∂xₙ) of a function; DomainError for p > 1.

        >>> germ("x**3 + y**4", "x y").milnor
        6
        """
        if (p := self.target) != 1:
            raise DomainError(f"The Milnor number is that of a function; this germ has {p} components.")
        return self.codimension("R", extended=True)  # T R_e f is the ideal

    @property
    def tjurina(self) -> Size:
        """dim θ/T K_e f: the Tjurina number dim O/(f, ∂f) of a function.

        >>> germ("x**4 + y**5 + x**2*y**3", "x y").tjurina
        11
        """
        return self.codimension("K", extended=True)

    @property
    def multiplicity(self) -> Size:
        """The dimension of the Q-algebra.

        >>> germ("x**2, y**3", "x y").multiplicity
        6
        """
        found = self.q_algebra
        return found if found == "infinite" else found.dimension

    @property
    def q_algebra(self) -> LocalAlgebra | Literal["infinite"]:
        """Q(f) = O/(f₁, …, fₚ): its dimension and Hilbert function.

        >>> germ("x**2, y**2, x*y", "x y").q_algebra.hilbert
        (1, 2)
        """
        from osculant.germs.algebras import q_algebra

        return q_algebra(self)

    @property
    def ramification(self) -> LocalAlgebra | Literal["infinite"]:
        """O/R with R the ideal of the largest minors of df: where f is no immersion or no submersion.

        >>> germ("x, y**2, x*y", "x y").ramification.dimension, germ("x, y**2", "x y").ramification
        (1, 'infinite')
        """
        from osculant.germs.algebras import ramification

        return ramification(self)

    def invariants(self) -> dict[str, Any]:
        """δ, cusps, double folds, cross-caps, triple points, Milnor numbers: as for these dimensions.

        Plain data, as `osculant.germs.invariants.invariants` describes it.

        >>> germ("x, y**2, y**3 + x**3*y", "x y").invariants()["image_milnor"]
        2
        """
        from osculant.germs.invariants import invariants

        return invariants(self)

    @property
    def patience(self) -> Patience:
        """The time that a question asked now may take."""
        from osculant.cas.germs.search import Patience

        return Patience(self.seconds if self.clock is None else max(self.clock.left(), LEAST * self.seconds))

    def proved_codimension(self, group: GroupName = None, *, extended: bool = False) -> Codimension:
        """The codimension with its proof, as `osculant.cas.germs.codimension` has it; computed once."""
        from osculant.cas.germs.codimension import codimension

        known, g = self._codimensions, self.group(group)
        if (g, not extended) in known and not known[g, not extended].finite:
            return known[g, not extended]  # both are infinite, or neither
        if (g, extended) not in known:
            known[g, extended] = codimension(self.exact, g, extended, self.patience)
        return known[g, extended]

    def term(self, term: tuple[int, int]) -> str:
        """A term (monomial, component) of the exact room as text.

        >>> germ("x, y**2", "x y").term((poly.monomial((2, 1)), 1))
        '(0, x**2*y)'
        """
        packed, component = term
        powers = zip(self.source, poly.exponents_of(packed, self.exact.n))
        text = "*".join(name if e == 1 else f"{name}**{e}" for name, e in powers if e) or "1"
        if self.target == 1:
            return text
        return f"({', '.join(text if j == component else '0' for j in range(self.target))})"

    def _unfolded(self, found: Unfolding) -> GermUnfolding:
        return GermUnfolding(tuple(map(self.term, found.terms)), MapGerm(found.germ, self.seconds))

    def __repr__(self) -> str:
        return f"<MapGerm {', '.join(self.components)} in {' '.join(self.source)}>"
