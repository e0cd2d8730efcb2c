"""Secant maps of immersions at the front door: `secant` at the diagonal, `secant_apart` at two points.

The secant map of an immersion X : Rⁿ → R^{m+1} takes two points p, q to the direction of X(q) − X(p), and a
point with a direction w to that of dX(w): blown up and made symmetric it is even in λ, with q − p = λω.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.expression import ONE, ZERO, to_text
from osculant.cas.germs import secants
from osculant.cas.germs.immersions import Immersion
from osculant.germs.map_germ import MapGerm
from osculant.germs.multi import MultiMapGerm
from osculant.germs.reading import components_of, constants_of, names_of

if TYPE_CHECKING:
    from osculant.cas.germs.frenet import Frenet
    from osculant.cas.germs.versal import Versality
    from osculant.germs.recognition import Recognised

Size = int | Literal["infinite"]
#: why there are no answers about a germ of which jets alone are known
UNSETTLED = "Jets of order {order} do not determine the germ: ask for a higher order."


def secant(
    formulas: Any,
    source: Any,
    at: Any = None,
    direction: Any = None,
    *,
    order: int | None = None,
    patience: float = 10.0,
) -> Secant:
    """The secant germ of an immersion at a point of the diagonal.

    Args:
        formulas: the components of X, as for `osculant.germ`: text such as ``"x, y, x^2 + y^3"``, a path, or
            a sequence; X need not be 0 anywhere.
        source: the source variables, as there.
        at: the point, by default the origin: text such as ``"1, -1/2"`` or a sequence of exact numbers, that
            is rational ones or expressions with roots of numbers, such as ``"sqrt(2), 0"``.
        direction: the direction in the source, likewise; it may be left out if there is one variable.
        order: the order k of the jets of the germ that are asked for: X is expanded to the order 2k + 1.
            Without, a polynomial X with few terms is taken as a whole, and of other X as much as determines
            the germ for A(H), if the orders 2, 3, 5 or 8 do.
        patience: seconds of processor time for a question, as for `osculant.germ`.

    Raises FormulaError for what is no formula; DomainError for a wrong number of coordinates, a direction
    that is missing or 0, a source variable that does not occur, a point where X is not analytic or no
    immersion, numbers that are not algebraic, a map to the line, and an order that is none.

    >>> found = secant("x, y, x^2 + y^3", "x y", at=(0, 0), direction=(1, 0))
    >>> found.germ.components, found.germ.boundary, found.even.components[0]
    (('v', 'x + 3/4*(y**2*v) + 1/4*(u*v**3)'), 'u', 'v')
    >>> found.projection.components, found.germ.codimension("A(H)")
    (('y', 'x**2 + y**3'), 0)
    """
    if not patience > 0:
        raise DomainError(f"patience: {patience} is no positive number of seconds.", argument="patience")
    names = names_of(source)
    if direction is None and len(names) > 1:
        axis = ", ".join(["1", *["0"] * (len(names) - 1)])
        raise DomainError(
            f"direction: the direction is missing: give one in the source, such as {axis}.",
            argument="direction",
        )
    if order is not None and type(order) is not int:
        raise DomainError(f"order: {order!r} is no whole number: give one of at least 1.", argument="order")
    immersion = Immersion(
        components_of(formulas, names),
        names,
        [ZERO] * len(names) if at is None else constants_of(at, "at"),
        [ONE] if direction is None else constants_of(direction, "direction"),
    )
    return Secant(immersion, order, patience)


class Secant:
    """A secant germ at the diagonal; `secant` makes it.

    The point and the direction are brought to the origin and the first axis by linear changes of source and
    target; p are the coordinates of the source after that. With p = (p̄ − λω)/2, q = (p̄ + λω)/2 and
    ω = (1, v₂, …, vₙ) the germ S has the variables (p̄, λ, v).

    Attributes:
        exact: the germ as the exact room `osculant.cas.germs.secants` has it.
        order: the order of the jets in which it is known; None if it is whole.
        settled: whether it is whole or determined for A(H) by these jets, so that answers about `germ` are
            those about the secant germ.
        seconds: of processor time for one question.

    >>> secant("t, t^2, t^3", "t").germ
    <MapGerm t, 1/4*u + 3/4*t**2 in t u>
    """

    def __init__(self, immersion: Immersion, order: int | None = None, patience: float = 10.0) -> None:
        from osculant.cas.germs.search import Patience

        self.seconds = patience
        self.exact = secants.secant(immersion, order, Patience(patience))
        self.order, self.settled = self.exact.order, self.exact.settled

    @cached_property
    def germ(self) -> MapGerm:
        """The germ f of (p̄, u, v) with S = f(p̄, λ², v), and H = {u = 0}; ``germ.even`` is S."""
        return MapGerm(self.exact.germ, self.seconds, even=self.exact.even)

    @cached_property
    def even(self) -> MapGerm:
        """The germ S of (p̄, λ, v), as a germ without symmetry."""
        return MapGerm(self.exact.even, self.seconds)

    @cached_property
    def projection(self) -> MapGerm:
        """X after the projection along dX(w), of p."""
        return MapGerm(self.exact.immersion.projection, self.seconds)

    def recognise(self) -> Recognised:
        """The class of the germ for A(H) in the lists of the literature, as `MapGerm.recognise` has it.

        Raises UndecidedError where jets do not settle the germ.

        >>> secant("x, y, x^3 + x*y^2 + y^2", "x y", direction="1, 0").recognise().name
        '2b++'
        """
        if not self.settled:
            raise UndecidedError(UNSETTLED.format(order=self.order))
        return self.germ.recognise("A(H)")

    def linked(self) -> int:
        """Check that p₁·h₀·S is the projection where p̄ = p, λ = p₁, vᵢ = pᵢ/p₁ (Remark 6.2.3).

        h₀ is the first coordinate of the secant's direction, which is 1 for a graph. Returns the degree up to
        which they were compared, that of X if the germ is whole and h₀ = 1; a difference would be an
        AssertionError.

        >>> secant("x, y, x^3 + x*y", "x y", direction="1, 0").linked()
        3
        """
        return self.exact.linked()

    def variety(self) -> MapGerm:
        """The germ of (X(p) + X(q))/2 + t·(X(q) − X(p))/λ, which parametrises the secant variety; u = λ².

        >>> secant("t, t^2, t^3", "t").variety().codimension("A(H)")
        'infinite'
        """
        found = secants.variety(self.exact.immersion, self.order)
        return MapGerm(found, self.seconds)

    def frenet(self) -> Frenet:
        """Curvature and torsion of a curve in space, their derivatives, and the case of Proposition 1.4.5.

        Raises DomainError for other dimensions and where the curvature is 0.

        >>> found = secant("t, t^2, t^4 + t^5", "t").frenet()
        >>> print(found.curvature, found.torsion, found.torsion_slope, found.condition, found.case)
        2 0 12 360 pitchfork
        """
        from osculant.cas.germs.frenet import frenet

        return frenet(self.exact.immersion.moved)

    @property
    def frames(self) -> tuple[list[list[str]], list[list[str]]]:
        """The matrices B and C, by rows: p ↦ C·(X(a + B·p) − X(a)) is X in normal position.

        >>> secant("x, y, x*y", "x y", direction="0, 2").frames[0]
        [['0', '1'], ['2', '0']]
        """
        immersion = self.exact.immersion
        source, target = (
            [list(map(to_text, row)) for row in rows]
            for rows in (immersion.source_frame, immersion.target_frame)
        )
        return source, target

    def __repr__(self) -> str:
        return f"<Secant {', '.join(self.germ.components)} in {' '.join(self.germ.source)}>"


def secant_apart(formulas: Any, source: Any, at: Any, to: Any, *, patience: float = 10.0) -> SecantApart:
    """The secant germ of an immersion at two points with different images.

    Args:
        formulas: the components of X, as for `secant`.
        source: the source variables.
        at: the first point, as for `secant`.
        to: the second one.
        patience: seconds of processor time for a question.

    Raises FormulaError for what is no formula; DomainError for a wrong number of coordinates, a point where X
    is not analytic or no immersion, points with one image, and numbers that are not algebraic.

    >>> found = secant_apart("t, t^2, t^3", "t", at=0, to=1)
    >>> found.parameters, found.germ.rank, found.bigerm_codimension()
    (('pt',), 2, 0)
    """
    from osculant.cas.germs import secants_apart

    if not patience > 0:
        raise DomainError(f"patience: {patience} is no positive number of seconds.", argument="patience")
    names = names_of(source)
    found = secants_apart.secant_apart(
        components_of(formulas, names), names, constants_of(at, "at"), constants_of(to, "to")
    )
    return SecantApart(found, patience)


class SecantApart:
    """A secant germ at two points; `secant_apart` makes it.

    It is the germ of (p, q) ↦ the direction of X(q) − X(p), where p and q are 0 at the points, in an affine
    chart of directions: a family, with the parameters p, of projections of X from X(p).

    Attributes:
        exact: the germ as the exact room has it.
        parameters: the names of p.
        germ: the germ.
        bigerm: that germ, and the same with p and q exchanged.

    >>> secant_apart("t, t^2", "t", 0, 1).germ.source
    ('pt', 't')
    """

    def __init__(self, exact: Any, patience: float = 10.0) -> None:
        self.exact, self.seconds = exact, patience
        self.parameters: tuple[str, ...] = exact.parameters
        self.germ = MapGerm(exact.germ, patience)

    @cached_property
    def bigerm(self) -> MultiMapGerm:
        """Both branches, at (p₀, q₀) and at (q₀, p₀); DomainError for coefficients that are not rational."""
        return MultiMapGerm([self.germ, MapGerm(self.exact.back, self.seconds)], self.seconds)

    def bigerm_codimension(self) -> Size:
        """The extended A-codimension of the bigerm; UndecidedError if it is not known."""
        found: Size = self.exact.bigerm_codimension(self.germ.patience)
        return found

    def versality(self) -> tuple[MapGerm, Versality]:
        """The germ q ↦ S(0, q), and whether S is an A-versal unfolding of it with the parameters p (6.2.4).

        Raises DomainError if that germ has no versal unfolding.

        >>> tangent = "t - 2*t^4, t^2 - t^4, t^3"  # the line tangent at 0 meets the curve at t = 1
        >>> f, found = secant_apart(tangent + " - t^4", "t", 1, 0).versality()
        >>> found.versal, secant_apart(tangent + "*(1 - t)^2", "t", 1, 0).versality()[1].versal
        (True, False)
        """
        return self.germ.versality(self.parameters, "A")

    def __repr__(self) -> str:
        return f"<SecantApart {', '.join(self.germ.components)} in {' '.join(self.germ.source)}>"
