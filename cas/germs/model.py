"""A germ as rational functions of the source variables and of a few analytic functions, exactly.

Every transcendental or algebraic function T = f(a) − f(a(0)) of the germ becomes a variable of its own that
is 0 at the origin; ∂T/∂xᵢ is a rational function of all variables. What vanishes identically in these m + n
variables vanishes on the graph of T too, so a set of dimension d there meets the graph in dimension d − m at
least. Ideals do not change if a generator is multiplied by a unit: denominators are cleared.
T = a·(c + U) with a the argument and U analytic: with U in place of T, what vanishes with a is seen.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import Ordering, fmpq, fmpq_mpoly_ctx, fmpq_poly

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import Algebraic, NumberField, rational

#: the name of the generator of a number field as a variable: no variable of a formula has it
GENERATOR = "_r"
#: a rational function: numerator, denominator (a unit at the origin)
Quotient = tuple[Any, Any]


@dataclass(frozen=True)
class Model:
    """The components of a germ, and the derivatives of the functions in them.

    Attributes:
        context: the ring of the variables; the first n are those of the source.
        n: the source dimension.
        components: numerators and denominators.
        rules: for each function its partial derivatives by the source variables, over one denominator.
        field: the number field of the coefficients: its generator is the last variable; None for ℚ.
        arguments: for each function its argument less the value at the origin, and its derivative there as a
            polynomial; None for an argument with a denominator.

    >>> from osculant.cas.germs.germ import Germ
    >>> from osculant.cas.germs.model_reading import model_of
    >>> model = model_of(Germ("x, y**3*exp(x)", "x y"))
    >>> model.extra, [str(f) for f in model.gradient(1)]
    (1, ['y^3*_0 + y^3', '3*y^2*_0 + 3*y^2'])
    """

    context: Any
    n: int
    components: tuple[Quotient, ...]
    rules: tuple[tuple[tuple[Any, ...], Any], ...]
    field: NumberField | None = None
    arguments: tuple[tuple[Any, Any] | None, ...] = ()

    @property
    def extra(self) -> int:
        """How many functions became variables."""
        return len(self.rules)

    @property
    def variables(self) -> list[Any]:
        """All variables, those of the source first."""
        return list(self.context.gens())

    @property
    def constants(self) -> list[Any]:
        """The generator of the number field as a variable, if there is one."""
        return [] if self.field is None else self.variables[-1:]

    def divided(self, f: Any) -> Any:
        """A polynomial with U in place of T for the functions T = a·(c + U), a the argument and c = T′(a(0)).

        U is analytic and 0 at the origin too, but what vanishes with a need not be told any more.
        """
        images = self.variables
        for k, told in enumerate(self.arguments):
            if told is not None:
                argument, slope = told
                images[self.n + k] = argument.compose(*images) * (slope + images[self.n + k])
        return f.compose(*images)

    def at_origin(self, f: Any, exponents: tuple[int, ...] = ()) -> Any:
        """The number before a power product of the source variables: by default the value at the origin."""
        width = self.context.nvars() - len(self.constants)
        wanted = (*exponents, *([0] * (width - len(exponents))))
        if self.field is None:
            c = f.to_dict().get(wanted, fmpq(0))
            return Fraction(int(c.p), int(c.q))
        return split(f, self.field).get(wanted, Fraction(0))

    def derivatives(self, f: Any) -> list[Any]:
        """The partial derivatives of a polynomial by the source variables, all times one unit."""
        unit = self.one
        for _, denominator in self.rules:
            unit = unit * denominator
        found = []
        for i in range(self.n):
            total = f.derivative(i) * unit
            for k, (numerators, denominator) in enumerate(self.rules):
                outer = f.derivative(self.n + k)
                if not outer.is_zero() and not numerators[i].is_zero():
                    total = total + outer * numerators[i] * (unit // denominator)
            found.append(total)
        return found

    def gradient(self, j: int) -> list[Any]:
        """The partial derivatives of a component, all times one unit."""
        numerator, denominator = self.components[j]
        above = self.derivatives(numerator)
        if denominator.is_constant():
            return above
        below = self.derivatives(denominator)
        return [a * denominator - b * numerator for a, b in zip(above, below)]

    def number(self, c: Any) -> Any:
        """A number of the field as a polynomial."""
        return polynomial({0: c} if c else {}, self.context, self.n)

    def reduced(self, f: Any) -> Any:
        """The polynomial with powers of the generator of the field below its degree."""
        if self.field is None:
            return f
        terms: dict[tuple[int, ...], fmpq] = {}
        for m, c in split(f, self.field).items():
            parts = c.coefficients() if isinstance(c, Algebraic) else (c,)
            terms |= {(*m, i): rational(part) for i, part in enumerate(parts) if part}
        return self.context.from_dict(terms)

    @property
    def one(self) -> Any:
        """The polynomial 1."""
        return self.context.constant(1)

    @property
    def zero(self) -> Any:
        """The polynomial 0."""
        return self.context.constant(0)

    def restricted(self, i: int) -> Model:
        """The germ on xᵢ = 0, in the other variables; raises ValueError for a germ that is not rational."""
        if self.rules:
            raise ValueError("only a rational germ is restricted")
        names = [name for k, name in enumerate(self.context.names()) if k != i]
        context = ring(names)
        gens = list(context.gens())
        images = [*gens[:i], context.constant(0), *gens[i:]]
        moved = tuple(
            (a.compose(*images, ctx=context), b.compose(*images, ctx=context)) for a, b in self.components
        )
        return Model(context, self.n - 1, moved, (), self.field)


def split(f: Any, field: NumberField) -> dict[tuple[int, ...], Any]:
    """A polynomial whose last variable is the generator of a field, as one over the field."""
    parts: dict[tuple[int, ...], dict[int, fmpq]] = {}
    for m, c in f.to_dict().items():
        parts.setdefault(tuple(map(int, m[:-1])), {})[int(m[-1])] = c
    found = {}
    for m, powers in parts.items():
        value = field.number(fmpq_poly([powers.get(i, fmpq(0)) for i in range(max(powers) + 1)]))
        if value:
            found[m] = value
    return found


def ring(names: Sequence[str], field: NumberField | None = None) -> Any:
    """The polynomials over ℚ in variables of these names, and the generator of a field, if there is one."""
    if field is not None:
        names = [*names, GENERATOR]
    return fmpq_mpoly_ctx.get(list(names), Ordering.degrevlex)


def polynomial(f: poly.Polynomial, context: Any, n: int) -> Any:
    """A polynomial of this room as one of the ring, whose first n variables are its own.

    The last variable is the generator of the number field of the coefficients, if there is one.
    """
    rest = (0,) * (context.nvars() - n)
    terms = {}
    for m, c in f.items():
        parts = c.coefficients() if isinstance(c, Algebraic) else (Fraction(c),)
        for i, part in enumerate(parts):
            if part:
                power = (*rest[1:], i) if i else rest
                terms[(*poly.exponents_of(m, n), *power)] = rational(part)
    return context.from_dict(terms)
