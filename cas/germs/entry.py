"""Germs and families of germs in reference lists: formulas with signs and parameters, names, known values."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import product
from math import prod

from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_constant
from osculant.cas.germs.even import halved
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.secants import projected

#: degree of the polynomials in a list of even germs at most
DEGREE = 30

Value = int | str | Fraction
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_BRACES = re.compile(r"\{([^{}]*)\}")


@dataclass(frozen=True)
class Parameter:
    """A parameter of a family: an integer with a ``least`` value, or a modulus (a rational number).

    ``tried`` are values that stand for all in tests, ``excluded`` the values where the family degenerates,
    and ``excluded_plus`` those where it does if the product of its signs is +.
    """

    name: str
    least: int | None
    tried: tuple[Value, ...]
    excluded: tuple[Fraction, ...] = ()
    excluded_plus: tuple[Fraction, ...] = ()

    def degenerate(self, signs: Sequence[int] | None) -> tuple[Fraction, ...]:
        """The values where the family with these signs degenerates; for None with any signs."""
        return self.excluded + (self.excluded_plus if signs is not None and prod(signs) > 0 else ())

    def text(self, value: Value, family: str, signs: Sequence[int] | None = None) -> str:
        """A value as a formula; raises DomainError for one that the parameter of that family cannot have."""
        try:
            number = Fraction(value)
        except ValueError:
            raise DomainError(f"{self.name} = {value!r} in {family} is not a rational number.") from None
        if self.least is not None and (number.denominator > 1 or number < self.least):
            raise DomainError(
                f"{self.name} = {value} is out of the range of {family}: choose an integer from {self.least} "
                "on."
            )
        if number in self.degenerate(signs):
            raise DomainError(f"{family} degenerates at {self.name} = {value}: choose another value.")
        return f"({number})"


@dataclass(frozen=True)
class Entry:
    """A germ or a family of germs in a reference list.

    Args:
        list: the name of its list.
        id: its name there.
        text: its formula, with ``±`` for signs and with the names of parameters.
        group: the group of equivalences of the list.
        variables: the source variables of the formula.
        parameters: integers and moduli.
        values: what is known about it, by name: formulas in the integers. "cod" and "cod_e" are the
            codimensions of T G f in Mθ and of T G_e f in θ, "determinacy" the least degree, "milnor" the
            Milnor number, "tjurina" the codimension for K_e (for K(H)_e if there is a boundary).
        name: how the germs are called: ``{…}`` stands for a formula in the integers, or for a modulus, and
            ``±`` for the signs of the text, in their order, as many as the name tells.
        complex: the name over ℂ, if that is not the name without signs.
        computed: the names of values that were computed here and not seen in print.
        where: formulas in the integers that must not be negative.
        rows: values of the parameters, in order, that stand for all in tests; by default all combinations of
            what is tried of each.
        boundary: the variable u with H = {u = 0}, if the group wants one.
        even: the variable λ in which the formula is even, if the germ is S(…, λ) = f(…, λ²).
        projection: for secant germs, the projection along the x-axis that belongs to them.
        printed: the formula in the source where it prints another.
        printed_values: the values in the source where it prints others.
        note: a remark.
    """

    list: str
    id: str
    text: str
    group: str
    variables: tuple[str, ...]
    parameters: tuple[Parameter, ...]
    values: Mapping[str, str]
    name: str
    computed: tuple[str, ...] = ()
    where: tuple[str, ...] = ()
    rows: tuple[tuple[Value, ...], ...] = ()
    boundary: str | None = None
    even: str | None = None
    projection: str | None = None
    printed: str | None = None
    printed_values: Mapping[str, str] = field(default_factory=dict)
    note: str = ""
    complex: str = ""

    @property
    def integers(self) -> tuple[Parameter, ...]:
        """The parameters that are integers."""
        return tuple(p for p in self.parameters if p.least is not None)

    @property
    def moduli(self) -> tuple[Parameter, ...]:
        """The parameters that are moduli."""
        return tuple(p for p in self.parameters if p.least is None)

    @property
    def usual(self) -> dict[str, Value]:
        """The values of the moduli that are tried first.

        >>> from osculant.cas.germs.reference import reference
        >>> reference("mond")["P_3"].usual
        {'c': '2'}
        """
        return {p.name: p.tried[0] for p in self.moduli}

    @property
    def signs(self) -> tuple[tuple[int, ...], ...]:
        """Every choice of the signs; one empty choice if there are none."""
        return tuple(product((1, -1), repeat=self.text.count("±")))

    def formula(self, signs: Sequence[int] | None = None, **parameters: Value) -> str:
        """The formula with these signs (all + by default) and values of the parameters.

        Raises DomainError for a wrong number of signs, for parameters that are missing or unknown, and for
        values out of range.

        >>> from osculant.cas.germs.reference import reference
        >>> reference("mond")["S_k"].formula((-1,), k=1)
        'x, y**2, y**3 - x**((1) + 1)*y'
        """
        return instance(self.text, signs, self._texts(parameters, signs or ()))

    def called(self, signs: Sequence[int] | None = None, **parameters: Value) -> str:
        """The name of one germ of the family; raises DomainError as `formula` does.

        >>> from osculant.cas.germs.reference import reference
        >>> reference("mond")["S_k"].called((-1,), k=2), reference("rieger")["8"].called(alpha="2/4")
        ('S2-', '8+(1/2)')
        """
        texts = self._texts(parameters, signs or ())
        instance(self.text, signs, texts)  # refuses wrong signs
        shown = ["+" if s > 0 else "-" for s in signs or (1,) * self.text.count("±")]
        parts = self.name.split("±")
        whole = parts[0] + "".join(sign + part for sign, part in zip(shown, parts[1:], strict=False))
        return _BRACES.sub(lambda found: str(_constant(found[1], texts)), whole)

    def germ(self, signs: Sequence[int] | None = None, **parameters: Value) -> Germ:
        """The germ that the group acts on; for an even formula S that is f with S(…, λ) = f(…, λ²).

        Raises DomainError as `formula` does.

        >>> from osculant.cas.germs.reference import reference
        >>> str(reference("rieger")["4_k"].germ(k=2))
        '(x, y**3 + x**2*y)'
        """
        germ = Germ(self.formula(signs, **parameters), self.variables, self.boundary)
        return germ if self.even is None else halved(germ, self.even)

    def projected(self, signs: Sequence[int] | None = None, **parameters: Value) -> Germ:
        """The projection that belongs to a secant germ; raises DomainError if the list has none.

        >>> from osculant.cas.germs.reference import reference
        >>> str(reference("table 6.1")["3-6"].projected())
        '(y, x**3 + x*y**3)'
        """
        if self.projection is None:
            raise DomainError(f"{self.list} has no projections: they belong to secant germs (table 6.1).")
        count = self.projection.count("±")
        chosen = None if signs is None else tuple(signs)[:count]
        return Germ(instance(self.projection, chosen, self._texts(parameters)), "x y")

    def projected_secant(self, signs: Sequence[int] | None = None, **parameters: Value) -> Germ:
        """The projection made from a secant germ S itself: (x, y) ↦ x·S(x, y, λ = x, v = y/x).

        Raises DomainError if the list has no secant germs.

        >>> from osculant.cas.germs.reference import reference
        >>> reference("table 6.1")["3-2"].projected_secant().text(3)
        ('y', 'x**3 + x*y')
        """
        secant = Germ(self.formula(signs, **parameters), self.variables)
        jet = secant.polynomial(DEGREE) if self.projection is not None else None
        if jet is None:
            raise DomainError(f"{self.id} of {self.list} is no secant germ: only table 6.1 has them.")
        components = [as_node(projected(f, secant.n // 2), ("x", "y")) for f in jet]
        return Germ(components, "x y")

    def value(self, name: str, **parameters: Value) -> int:
        """A value of the entry for these parameters; raises DomainError for one that is not in the list.

        >>> from osculant.cas.germs.reference import reference
        >>> reference("mond")["H_k"].value("cod", k=3)
        5
        """
        if name not in self.values:
            raise DomainError(f"{self.list} has no {name!r} of {self.id}: it has {', '.join(self.values)}.")
        found = _constant(self.values[name], self._texts(parameters))
        if found.denominator > 1:
            raise DomainError(f"The {name} of {self.id} is {found}, not an integer: correct {self.list}.")
        return int(found)

    def stable(self, **parameters: Value) -> bool:
        """Whether the germs are stable, by their codimension; raises DomainError if the group has no target.

        >>> from osculant.cas.germs.reference import reference
        >>> reference("mond")["S_k"].stable(k=0), reference("mond")["S_k"].stable(k=1)
        (True, False)
        """
        if not self.group.startswith("A"):
            raise DomainError(f"{self.list} is a list for {self.group}: only germs for A or A(H) are stable.")
        return self.value("cod_e", **parameters) == 0

    def tried(self) -> Iterator[tuple[tuple[int, ...], dict[str, Value]]]:
        """(signs, parameters) that stand for the whole family: every choice of signs, small parameters."""
        names = [p.name for p in self.parameters]
        for values in self.rows or product(*(p.tried for p in self.parameters)):
            for signs in self.signs:
                yield signs, dict(zip(names, values))

    def _texts(self, parameters: Mapping[str, Value], signs: Sequence[int] | None = None) -> dict[str, str]:
        names = [p.name for p in self.parameters]
        if sorted(parameters) != sorted(names):
            wanted = ", ".join(names) if names else "no parameters"
            given = ", ".join(parameters) if parameters else "none"
            raise DomainError(f"{self.id} of {self.list} takes {wanted}; given: {given}.")
        texts = {p.name: p.text(parameters[p.name], self.id, signs) for p in self.parameters}
        for condition in self.where:
            if _constant(condition, texts) < 0:
                given = ", ".join(f"{name} = {value}" for name, value in parameters.items())
                raise DomainError(
                    f"{given} is out of the range of {self.id}: {condition} must be at least 0."
                )
        return texts


def instance(text: str, signs: Sequence[int] | None, parameters: Mapping[str, str]) -> str:
    """A formula with signs in place of ± and texts in place of the names of parameters.

    Whole names are replaced, so a parameter k leaves a variable k1 alone. All signs are + by default. Raises
    DomainError if the number of signs is not that of ±, or one is not 1 or −1.

    >>> instance("x ± y**k", (-1,), {"k": "(3)"})
    'x - y**(3)'
    """
    parts = text.split("±")
    chosen = (1,) * (len(parts) - 1) if signs is None else tuple(signs)
    if len(chosen) != len(parts) - 1 or not set(chosen) <= {1, -1}:
        raise DomainError(f"{text!r} takes {len(parts) - 1} signs, each 1 or -1; given: {chosen}.")
    whole = parts[0] + "".join(("+" if s > 0 else "-") + part for s, part in zip(chosen, parts[1:]))
    return _NAME.sub(lambda name: parameters.get(name[0], name[0]), whole)


def _constant(text: str, parameters: Mapping[str, str]) -> Fraction:
    """The value of a formula in the parameters; raises DomainError if it is not rational."""
    return Fraction(parse_constant(instance(text, None, parameters)).value)
