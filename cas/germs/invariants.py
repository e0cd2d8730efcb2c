"""Invariants of A-equivalence of a germ, as far as they have a meaning for its dimensions.

Curves (n = 1): δ, the semigroup, and for p = 2 the image Milnor number, which is δ. n = p: cusps and double
folds (n = 2) and the other isolated types of points, μ of the critical set, the discriminant Milnor number.
p = n + 1: cross-caps and triple points (n = 2), the other isolated types, μ(D²), the image Milnor number.
Corank 1 by multiple-point schemes (`disentanglement`); of corank 2 by determinantal ideals, whose dimension
is the number of points as well: cusps by the minors of (df, dJ) (Gaffney and Mond), cross-caps by those of
df. Double folds of corank 2 by δ of the discriminant, which is that of Σ plus cusps plus double folds; triple
points of quasi-homogeneous germs by the second Fitting ideal (Mond and Pellikaan).

What needs a stable perturbation needs a finitely determined germ; for others only "infinite" can be told.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from osculant.cas.errors import DomainError, OsculantError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.colength import Size, Zeros, colength, milnor_of_intersection
from osculant.cas.germs.corank_one import CorankOne, corank_one
from osculant.cas.germs.delta import relative_delta, semigroup
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.disentanglement import isolated_types, milnor_of_points, points, sphere_count
from osculant.cas.germs.equation import equation, liftable_fields
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.local_algebra import ramification
from osculant.cas.germs.loci import minors
from osculant.cas.germs.model import Model
from osculant.cas.germs.model_reading import model_of
from osculant.cas.germs.pushforward import Pushforward, known_weights
from osculant.cas.germs.search import Patience

#: names of isolated types of points, by source and target dimension
NAMES: dict[tuple[int, int, tuple[int, ...]], str] = {
    (1, 2, (1, 1)): "double_points",
    (2, 2, (3,)): "cusps",
    (2, 2, (2, 2)): "double_folds",
    (2, 3, (2,)): "cross_caps",
    (2, 3, (1, 1, 1)): "triple_points",
    (2, 4, (1, 1)): "double_points",
    (3, 3, (4,)): "swallowtails",
    (3, 3, (3, 2)): "cuspidal_double_points",
    (3, 3, (2, 2, 2)): "triple_folds",
    (3, 4, (2, 1)): "cross_caps_on_sheets",
    (3, 4, (1, 1, 1, 1)): "quadruple_points",
}


class Invariants:
    """The invariants of a germ, which `questions` names; ``patience`` makes the time of each question.

    >>> found = Invariants(Germ("x, y**2, y**3 + x**3*y", "x y")).questions()
    >>> {name: ask() for name, ask in found.items() if name.endswith("_milnor")}
    {'double_curve_milnor': 2, 'image_milnor': 2}
    >>> found["equation"]()
    'y1**6*y2 + 2*y1**3*y2**2 + y2**3 - y3**2'
    """

    def __init__(self, germ: Germ, patience: Callable[[], Patience] = Patience) -> None:
        self.germ, self.patience = germ, patience
        self._known: dict[str, tuple[Any, OsculantError | None]] = {}

    def questions(self) -> dict[str, Callable[[], Any]]:
        """The invariants that have a meaning for these dimensions, by name; none for functions.

        Each raises DomainError or UndecidedError with the reason where it has no answer, and else returns a
        number or "infinite"; text for the equation, lists for the semigroup's and the liftable generators.
        """
        n, p = self.germ.n, self.germ.p
        found: dict[str, Callable[[], Any]] = {}
        if p == 1 or n > p:
            return found
        if n == 1:
            found |= {"delta": self.delta, "semigroup": self.semigroup}
        for parts in isolated_types(n, p):
            name = NAMES.get((n, p, parts), "points_" + "_".join(map(str, parts)))
            found[name] = partial(self.number, parts)
        if n == p > 1:
            found |= {"critical_set_milnor": self.critical_set, "discriminant_milnor": self.spheres}
        if p == n + 1:
            if n == 2:
                found["double_curve_milnor"] = self.double_points
            found["image_milnor"] = self.spheres
        if n <= p <= n + 1:
            found |= {"equation": self.equation, "liftable": self.liftable}
        return found if self.germ.field is None else dict.fromkeys(found, self.irrational)

    def irrational(self) -> Size:
        """Raise UndecidedError: invariants are counted over ℚ alone."""
        raise UndecidedError(f"This is not counted for {self.germ}: its coefficients are not rational.")

    def equation(self) -> str:
        """The equation of the image, or of the discriminant for n = p, in y1, …, yp."""
        return str(equation(self.germ, self.patience())).replace("^", "**")

    def liftable(self) -> list[str]:
        """Generators of the liftable fields of a finitely determined germ, each with p components."""
        self.needs_finite()
        return [", ".join(field) for field in liftable_fields(self.germ, self.patience())]

    def _once(self, what: str, make: Callable[[], Any]) -> Any:
        """What was made of that name, or the error that it met, without doing it again."""
        if what not in self._known:
            try:
                self._known[what] = make(), None
            except (DomainError, UndecidedError) as error:
                self._known[what] = None, error
        found, met = self._known[what]
        if met is not None:
            raise met
        return found

    def form(self) -> CorankOne:
        """The normal form of corank 1."""
        form: CorankOne = self._once("form", lambda: corank_one(self.germ, self.patience()))
        return form

    def delta(self) -> Size:
        """δ of a curve: its semigroup's gaps; "infinite" for a covering of its image."""
        if self._covers():
            return "infinite"
        return relative_delta([self.germ], patience=self.patience())

    def semigroup(self) -> list[int]:
        """Generators of the semigroup of a curve that is one to one."""
        if self._covers():
            raise DomainError("The curve covers its image several times: its semigroup has no conductor.")
        return list(semigroup(self.germ, self.patience()).generators)

    def _covers(self) -> bool:
        if self.germ.rank == 1:
            return False
        zeros = Zeros(*self.form().scheme((1, 1)))
        return colength(zeros, "double point scheme", self.patience()) == "infinite"

    def number(self, parts: tuple[int, ...]) -> Size:
        """The number of points of an isolated type in a stable perturbation."""
        germ = self.germ
        if germ.rank == germ.n:
            return 0
        if germ.rank == germ.n - 1:
            return points(self.form(), parts, self.patience())
        if (germ.n, germ.p, parts) == (2, 3, (2,)):
            try:
                return ramification(germ, self.patience()).dimension
            except DomainError:
                return "infinite"
        if (germ.n, germ.p) == (2, 2):
            return self.cusps() if parts == (3,) else self.double_folds()
        if (germ.n, germ.p, parts) == (2, 3, (1, 1, 1)) and known_weights(germ) is not None:
            module = Pushforward(germ, self.patience())
            zeros = Zeros(module.context, module.fitting(2))
            return colength(zeros, "second Fitting ideal", self.patience())
        raise UndecidedError(f"Points of type {parts} are counted for germs of corank 1 alone.")

    def cusps(self) -> Size:
        """The dimension of O over the largest minors of (df, dJ), n = p = 2; they contain J."""
        found: Size = self._once("cusps", self._cusps)
        return found

    def _cusps(self) -> Size:
        model = self.model()
        rows = [model.gradient(0), model.gradient(1)]
        (jacobian,) = minors(rows, 2, model) or (model.zero,)
        ideal = minors([*rows, model.derivatives(jacobian)], 2, model)
        return colength(Zeros(model.context, ideal), "scheme of the cusps", self.patience())

    def double_folds(self) -> Size:
        """δ of the discriminant less that of the critical set less the cusps, n = p = 2."""
        cusps = self.cusps()
        self.needs_finite()
        assert cusps != "infinite"

        def jacobian(order: int) -> Sequence[poly.Polynomial]:
            (a, b), (c, d) = ([poly.derivative(f, i, 2) for i in range(2)] for f in self.germ.jet(order + 1))
            return [poly.plus(poly.times(a, d, 2, order), poly.times(b, c, 2, order), -1)]

        return relative_delta([self.germ], jacobian, self.patience()) - cusps

    def critical_set(self) -> Size:
        """μ of the critical set of a germ with n = p, "infinite" if it is not isolated; 0 without one."""
        if self.germ.rank == self.germ.n:
            return 0
        model = self.model()
        n = self.germ.n
        jacobian = minors([model.gradient(j) for j in range(n)], n, model)
        return milnor_of_intersection(Zeros(model.context, jacobian), "critical set", self.patience())

    def double_points(self) -> Size:
        """μ(D²) of the double point curve in the pairs of points, corank 1; 0 where it is empty."""
        if self.germ.rank == self.germ.n:
            raise DomainError("An immersion has no double points near the origin.")
        if self.germ.rank < self.germ.n - 1:
            raise UndecidedError(
                "μ(D²) is known for germs of corank 1 alone: D² is no complete intersection."
            )
        found = milnor_of_points(self.form(), (1, 1), self.patience())
        if found is None:
            raise DomainError("The germ has no double points near the origin.")
        return found

    def spheres(self) -> Size:
        """The image or discriminant Milnor number of a finitely determined germ; "infinite" has no meaning.

        By Euler characteristics for corank 1, and n = p = 2; else equal to the A_e codimension where the germ
        is quasi-homogeneous and the theorem is known (n = p in the nice dimensions; n = 2, p = 3).
        """
        germ = self.germ
        self.needs_finite()
        if germ.rank >= germ.n - 1:
            return sphere_count(germ, self.patience())
        if (germ.n, germ.p) == (2, 2):
            critical, folds = self.critical_set(), self.double_folds()
            assert critical != "infinite" and folds != "infinite"
            return critical + folds
        nice = germ.n == germ.p <= 8 or (germ.n, germ.p) == (2, 3)
        if nice and known_weights(germ) is not None:
            return self.codimension()
        raise UndecidedError(
            "The Milnor number is known for corank 1, and for quasi-homogeneous germs in dimensions where it "
            "is proved to be the extended codimension."
        )

    def codimension(self) -> Size:
        """The extended codimension for A."""
        size: Size = self._once(
            "codimension", lambda: codimension(self.germ, "A", True, self.patience()).value
        )
        return size

    def needs_finite(self) -> None:
        """Raise DomainError if the germ is not finitely determined for A."""
        if self.codimension() == "infinite":
            raise DomainError(
                "The germ is not finitely determined: it has no stable perturbation to count in."
            )

    def model(self) -> Model:
        """The germ, or a jet that determines it, by polynomials."""
        model: Model = self._once("model", self._model)
        return model

    def _model(self) -> Model:
        germ = self.germ
        if germ.polynomial(poly.LARGEST) is None:
            degree = determinacy(germ, "A", self.patience()).degree
            if degree == "infinite":
                raise UndecidedError(f"{germ} is neither polynomial nor finitely determined.")
            germ = germ.truncated(degree)
        found = model_of(germ)
        assert found is not None
        return found
