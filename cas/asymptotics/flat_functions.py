"""Functions with n-fold zeros at both ends of a short interval: how small they are (thesis, Lemma A.2.1).

On [0, r] such a function is uⁿ(r − u)ⁿF(u, r), and with one more zero at u = s it is
uⁿ(r − u)ⁿ(u − s)F(u, s, r). With u = rx, s = ry and F ≠ 0 it is a multiple of a *model* xⁿ(1 − x)ⁿ or
xⁿ(1 − x)ⁿ(x − y) plus what is small with r. Everything here follows from the models' logarithmic derivatives,
for a symbol n as for a number: they are rational in x, y and n although the models themselves are not.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp

from osculant.cas.errors import DomainError

#: the scaled position u/r, the scaled third zero s/r, and the flatness
x, y = sp.symbols("x y", real=True)
n = sp.Symbol("n", positive=True)


@dataclass(frozen=True)
class Model:
    """The model of a function with n-fold zeros at 0 and 1 and perhaps a simple zero between them.

    flatness: n, a positive integer or a positive symbol; crossing: the simple zero y, or None.

    >>> Model(2).peak, Model(2, y).critical_form
    (1/16, -5*x**2 + 4*x*y + 3*x - 2*y)
    """

    flatness: Any = n
    crossing: Any = None

    def __post_init__(self) -> None:
        whole = sp.sympify(self.flatness)
        if whole.is_positive is not True or (whole.is_number and whole.is_integer is not True):
            raise DomainError(f"The flatness must be a positive integer or symbol, not {self.flatness}.")

    @property
    def shape(self) -> Any:
        """The model as an expression in x."""
        factor = 1 if self.crossing is None else x - self.crossing
        return x**self.flatness * (1 - x) ** self.flatness * factor

    @property
    def log_slope(self) -> Any:
        """The logarithmic derivative of the model, a rational function of x."""
        found = self.flatness / x - self.flatness / (1 - x)
        return found if self.crossing is None else found + 1 / (x - self.crossing)

    @property
    def critical_form(self) -> Any:
        """The polynomial Q in x with (model)′ = xⁿ⁻¹(1 − x)ⁿ⁻¹Q (A.5)."""
        factor = x * (1 - x) * (1 if self.crossing is None else x - self.crossing)
        return sp.expand(sp.cancel(factor * self.log_slope))

    @property
    def critical_points(self) -> tuple[Any, ...]:
        """The zeros of Q, the critical points of the model inside (0, 1), from left to right.

        >>> Model(2, sp.Rational(1, 2)).critical_points
        (1/2 - sqrt(5)/10, sqrt(5)/10 + 1/2)
        """
        polynomial = sp.Poly(self.critical_form, x)
        if polynomial.degree() == 1:
            a, b = polynomial.all_coeffs()
            return (sp.cancel(-b / a),)
        a, b, c = polynomial.all_coeffs()
        root = sp.sqrt(sp.factor(b**2 - 4 * a * c))
        centre, reach = sp.cancel(-b / (2 * a)), root / (-2 * a)  # a = −(2n + 1) is negative
        return centre - reach, centre + reach

    @property
    def critical_values(self) -> tuple[Any, ...]:
        """The model at its critical points."""
        return tuple(self.shape.subs(x, point) for point in self.critical_points)

    @property
    def peak(self) -> Any:
        """max |model| on [0, 1] without a crossing, or with one in the middle, where both lobes are equal.

        Raises DomainError for another crossing: which lobe is larger then depends on it.

        >>> Model(1).peak, Model(1, sp.Rational(1, 2)).peak, Model(2, sp.Rational(1, 2)).peak
        (1/4, sqrt(3)/36, sqrt(5)/250)
        """
        if self.crossing is not None and sp.expand(2 * self.crossing - 1) != 0:
            raise DomainError(f"The lobes differ: the crossing is at {self.crossing}, not at 1/2.")
        point = self.critical_points[-1]
        if self.crossing is None:
            return sp.powsimp(self.shape.subs(x, point), force=True)
        # x(1 − x) at the critical point is rational in n, so that its nth power is one power
        product = sp.factor(sp.expand(point * (1 - point)))
        return sp.powsimp(product**self.flatness * (point - self.crossing))


@cache
def flat_constant(flatness: Any, crossings: int) -> Any:
    """The constant of Lemma A.2.1: (1/4)ⁿ without, cₙ with one crossing.

    The error max |f| of a function with n-fold zeros at 0 and r is this constant times |∂ᵐf|/m! times rᵐ, to
    leading order, with m = 2n + crossings; with a crossing for the best place of it.

    Args:
        flatness: n, a positive integer or symbol.
        crossings: 0 or 1.

    Raises DomainError for anything else.

    >>> flat_constant(2, 0), flat_constant(2, 1), flat_constant(n, 0)
    (1/16, sqrt(5)/250, 4**(-n))
    """
    if crossings not in (0, 1):
        raise DomainError(f"A flat function has 0 or 1 crossings here, not {crossings}.")
    return Model(flatness, sp.Rational(1, 2) if crossings else None).peak


def slope_by_crossing() -> Any:
    """∂(model)/∂y, which is negative inside (0, 1).

    At a critical point it is the whole derivative of the critical value by y. So Δ(y), the sum of both
    critical values, decreases, and has one zero; by the symmetry x ↦ 1 − x that is y = 1/2.

    >>> slope_by_crossing().subs(n, 1)
    -x*(1 - x)
    """
    return sp.diff(Model(n, y).shape, y)


#: F and its derivatives by u, s and r at the origin
F, F_u, F_s, F_r = sp.symbols("F F_u F_s F_r", real=True, nonzero=True)


def critical_point_shift(crossing: Any = None) -> tuple[Any, ...]:
    """dx/dr at r = 0 of the critical points x(r) of xⁿ(1 − x)ⁿF(rx, …) or xⁿ(1 − x)ⁿ(x − y)F(rx, …).

    By the implicit function theorem for the equation ∂(model·F)/∂x = 0 freed of its zeros at 0 and 1; the one
    without crossing says where the error of a parabola peaks: at u = r/2 + (dx/dr) r² + ….

    >>> critical_point_shift()
    (F_u/(8*F*n),)
    """
    model, r = Model(n, crossing), sp.Symbol("r")
    factor = x * (1 - x) * (1 if crossing is None else x - crossing)
    equation = model.critical_form * F + factor * r * F_u
    shift = -sp.diff(equation, r) / sp.diff(model.critical_form * F, x)
    return tuple(sp.simplify(shift.subs(x, point)) for point in model.critical_points)


def balance_shift() -> Any:
    """dy₀/dr at r = 0 of the balanced crossing y₀(r) = 1/2 + …, where both lobes are equally high.

    Δ(y, r) = Σ f̃(x±, y, r) has the partial derivatives Σ ∂f̃/∂r and Σ ∂f̃/∂y, since ∂f̃/∂x = 0 at x±. With
    it the best third zero is s₀(r) = r·y₀(r) = r/2 + (dy₀/dr) r² + ….

    >>> balance_shift()
    F_u/(4*F*(2*n + 1))
    """
    model = Model(n, sp.Rational(1, 2))
    # both critical values have the same xⁿ(1 − x)ⁿ, which cancels in the quotient
    common = x**n * (1 - x) ** n
    by_r = sp.cancel(model.shape / common) * (F_u * x + F_s / 2 + F_r)
    by_y = sp.cancel(slope_by_crossing() / common) * F
    sums = [sum(term.subs(x, point) for point in model.critical_points) for term in (by_r, by_y)]
    return sp.factor(sp.simplify(-sums[0] / sums[1]))
