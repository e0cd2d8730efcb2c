"""Map-germs (Kⁿ,0) → (Kᵖ,0) with rational coefficients: polynomial, or analytic and expanded as asked."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import Any

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas.expression import Node, number, to_text
from osculant.cas.formulas.graph import topological, variables
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import NumberField, exact
from osculant.cas.germs.expansion import EXPANSION, as_node, expanded, moving_nodes, size_of, with_roots
from osculant.cas.germs.linear import rank
from osculant.cas.germs.polynomials import Number, Polynomial

#: characters of a germ that sentences show; of these at its end
SHOWN, END = 200, 30


class Germ:
    """A map-germ f = (f₁, …, fₚ) with f(0) = 0.

    Args:
        components: the formulas of f₁, …, fₚ, separated by commas, or their expression nodes.
        source: the names of the source variables, in order, separated by spaces.
        boundary: the name of the variable u with H = {u = 0}, for the groups that preserve H; by default the
            variable called ``u`` if there is one.

    Raises FormulaError for text that is no formula, DomainError for a germ that is not analytic at 0, does
    not vanish there or has coefficients that are not rational, and for a boundary that is no variable.

    >>> fold = Germ("x, y**2", "x y")
    >>> fold.n, fold.p, fold.rank
    (2, 2, 1)
    >>> Germ("sin(x) + y", "x y").text(3)
    ('-x**3/6 + x + y',)
    """

    def __init__(
        self,
        components: str | Sequence[Node],
        source: str | Sequence[str],
        boundary: str | None = None,
        field: NumberField | None = None,
    ) -> None:
        self.source = tuple(source.replace(",", " ").split() if isinstance(source, str) else source)
        if not self.source or len(set(self.source)) < len(self.source):
            raise DomainError(
                f"The source variables {' '.join(self.source)!r} must be one or more, all different."
            )
        root = () if field is None or field.name is None else (field.name,)
        if shared := set(root) & set(self.source):
            raise DomainError(
                f"{min(shared)!r} is a source variable and the root of a polynomial: rename one."
            )
        names = (*self.source, *root)
        nodes = parse_tuple(components, names) if isinstance(components, str) else tuple(components)
        if not nodes:
            raise DomainError("A germ has at least one component: give a formula.")
        unknown = sorted(variables(nodes) - set(names))
        if unknown:
            raise FormulaError(
                f"The germ uses {', '.join(unknown)}, not among its source variables: add them."
            )
        self.components = nodes
        #: what was computed of this germ, by those who did
        self.known: dict[Hashable, Any] = {}
        if boundary is None and "u" in self.source:
            boundary = "u"
        if boundary is not None and boundary not in self.source:
            raise DomainError(
                f"The boundary variable {boundary!r} is not a source variable: choose one of "
                f"{', '.join(self.source)}."
            )
        self.boundary = boundary
        #: the number field of the coefficients; None if they are rational
        self.field = field
        for i, f in enumerate(self._first_jet(), start=1):
            if f.get(0, 0):
                raise DomainError(f"Component {i} of the germ is {f[0]} at the origin, not 0: subtract it.")

    def _first_jet(self) -> tuple[Polynomial, ...]:
        """The jet of order 1; the field grows by the roots that the components have at the origin."""
        found, self.field = with_roots(self.components, self.source, 1, self.field)
        return found

    @property
    def n(self) -> int:
        """The source dimension."""
        return len(self.source)

    @property
    def p(self) -> int:
        """The target dimension."""
        return len(self.components)

    @property
    def boundary_index(self) -> int:
        """The place of u among the source variables; raises DomainError if there is no boundary."""
        if self.boundary is None:
            raise DomainError(
                "An (H) group needs the boundary variable u of H = {u = 0}: name one of "
                f"{', '.join(self.source)} as the boundary."
            )
        return self.source.index(self.boundary)

    @property
    def rank(self) -> int:
        """The rank of df at 0."""
        rows = [[exact(f.get(poly.variable(i, self.n), 0)) for i in range(self.n)] for f in self.jet(1)]
        return rank(rows, self.n)

    def jet(self, order: int) -> tuple[Polynomial, ...]:
        """The components up to that degree; raises DomainError above degree 63 or off the analytic domain."""
        return expanded(self.components, self.source, order, self.field)

    def expanded(self, nodes: tuple[Node, ...], order: int) -> tuple[Polynomial, ...]:
        """Other expressions in the variables of the germ, such as parts of its components, expanded."""
        return expanded(nodes, self.source, order, self.field)

    def polynomial(self, degree: int) -> tuple[Polynomial, ...] | None:
        """The components as polynomials, if they are polynomials of at most that degree; else None.

        None too if the work of expanding them is not bounded by `EXPANSION` beforehand.

        >>> Germ("exp(x) - 1", "x").polynomial(10) is None
        True
        >>> Germ("x*(1 + x + y)**3000", "x y").polynomial(4000) is None
        True
        """
        kinds = {"number", "variable", "add", "sub", "neg", "mul", "div", "pow"}
        moving = moving_nodes(self.components, self.source)
        for node in topological(self.components):
            if node not in moving:
                continue  # a number
            whole = node.kind != "pow" or (node.value.denominator == 1 and node.value >= 0)
            if node.kind not in kinds or not whole or (node.kind == "div" and node.args[1] in moving):
                return None
        sizes = [size_of(node, self.source) for node in self.components]
        bound = max(size.degree for size in sizes)
        return None if bound > degree or sum(s.work for s in sizes) > EXPANSION else self.jet(bound)

    def truncated(self, order: int) -> Germ:
        """The jet of that order, as a polynomial germ.

        >>> str(Germ("sin(x)", "x").truncated(3))
        '((-1/6)*x**3 + x)'
        """
        nodes = [as_node(f, self.source, self.field) for f in self.jet(order)]
        return Germ(nodes, self.source, self.boundary, self.field)

    def text(self, order: int) -> tuple[str, ...]:
        """The components of the jet as text, to show."""
        import sympy

        from osculant.cas.formulas.sympy_bridge import to_sympy

        def coefficient(c: Number) -> Any:
            return to_sympy(number(exact(c)) if self.field is None else self.field.expression(c))

        symbols = sympy.symbols(self.source)
        return tuple(
            str(
                sympy.Add(
                    *(
                        coefficient(c)
                        * sympy.prod(s**e for s, e in zip(symbols, poly.exponents_of(m, self.n)))
                        for m, c in f.items()
                    )
                )
            )
            for f in self.jet(order)
        )

    def __str__(self) -> str:
        return f"({', '.join(to_text(node) for node in self.components)})"

    def __format__(self, spec: str) -> str:
        """As text to be read in a sentence: a long germ is cut."""
        shown = str(self)
        if len(shown) > SHOWN:
            shown = f"{shown[: SHOWN - 2 * END]} … {shown[-END:]}"
        return format(shown, spec)

    def __repr__(self) -> str:
        return f"Germ({', '.join(to_text(node) for node in self.components)!r}, {' '.join(self.source)!r})"
