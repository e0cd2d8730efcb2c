"""The class of a germ in the lists of the literature, at the front door.

A name is told only with an explicit equivalence, found and verified by substitution, of the germ with a row
of a list, on jets of the order to which the row is determined. "On none of the lists" is told only where
every row is excluded. Else it is undecided.

Plain data (``version`` 1): the germ as in `osculant.germs.report`: ``source``, ``target``, ``components``,
``boundary``, ``group``, ``at``, ``even``; ``lists``: those that were looked through; ``name``: of the real
class, with signs and moduli, ``complex``: of the class over ℂ; ``table`` and ``id``: the row of a list,
with its ``integers``; ``normal_form``: texts of components in ``variables``; ``signs``: ±1 by the first
monomial that each governs; ``moduli``: their values as text; ``estimates``: floats near those that are not
rational; ``real_field``: the ``name`` of a number that stands in them, the ``polynomial`` of which it is a
root, and a float ``near`` it, null without one; ``codimension``: of T G f in Mθ, a number or "infinite",
null where it is not known; ``determinacy``: the degree to which the row is determined;
``proof``: "equivalence"; "key" for a function of a row to which no equivalence is built (``reason`` tells
that; ``normal_form``, ``signs`` and ``moduli`` are null then), null without a name; ``key``: parts that
were computed (`osculant.cas.recognition.keys`), each a list of numbers by the order of jets; ``reason``:
why there is no name; ``undecided``: whether there may be one, and then ``alike``: names that are not
excluded; ``unused``: source variables on which the germ does not depend; ``secants``: of a class of table
6.2, the rows of table 6.1 whose secant germs have it. With a tolerance: ``tolerance``; ``nearby``: the germ
that was recognised; ``margin``: the smallest singular value ``kept``, the largest ``dropped``, and the
``noise`` (`osculant.germs.rounded.Margin`). What a germ without a name has not is null. With
``equivalence`` it is as in `osculant.germs.equivalence_file`, of jets alone.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import to_text
from osculant.cas.formulas.graph import variables
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import Algebraic
from osculant.cas.germs.expansion import as_node
from osculant.cas.recognition.answer import Recognition
from osculant.cas.recognition.names import printed, sign_names
from osculant.germs.even import even_data

if TYPE_CHECKING:
    from osculant.cas.recognition.equivalence import Equivalence
    from osculant.germs.map_germ import GroupName, MapGerm
    from osculant.germs.rounded import Margin


def recognised(germ: MapGerm, group: GroupName = None, tolerance: float | None = None) -> Recognised:
    """The class of a germ; `MapGerm.recognise` asks for it."""
    from osculant.cas.recognition.recognise import recognise as exactly

    acting = germ.group(group)
    if tolerance is None:
        return Recognised(germ, exactly(germ.exact, acting, germ.patience))
    from osculant.cas.recognition.keys import version_of
    from osculant.germs.rounded import margin, nearby

    near = nearby(germ.exact, tolerance)
    found = exactly(near, acting, germ.patience)
    if found.form is None or found.key is None:
        reason = f"Not of all germs within the tolerance it is decided. Of a near one: {found.reason}"
        return Recognised(germ, replace(found, reason=reason, undecided=True, codimension=None), tolerance)
    order = max(found.key.order, found.form.order)
    safe = margin(germ.exact, near, acting, version_of(near, acting), order, tolerance)
    if not safe.safe:
        name = found.complex or ""
        reason = "A rank is not decided within the tolerance: see the margin."
        found = replace(found, form=None, equivalence=None, undecided=True, reason=reason, alike=(name,))
        found = replace(found, codimension=None)
    return Recognised(germ, found, tolerance, safe)


@dataclass(frozen=True)
class Recognised:
    """The class of a germ, or why it has no name.

    Attributes:
        germ: the germ.
        found: the recognition as the exact room `osculant.cas.recognition` has it; with a tolerance that of
            the germ nearby with the simplest coefficients.
        tolerance: to which the coefficients are known; None if they are exact.
        margin: how safely ranks are told within the tolerance.
    """

    germ: MapGerm
    found: Recognition
    tolerance: float | None = None
    margin: Margin | None = None

    @property
    def name(self) -> str | None:
        """The name of the real class, such as "S1+" or "P3(2/5)"; None without one."""
        return self.found.name

    @property
    def complex(self) -> str | None:
        """The name of the class over ℂ, such as "S1"."""
        return self.found.complex

    @property
    def table(self) -> str | None:
        """The name of the list."""
        return None if self.found.form is None else self.found.form.entry.list

    @property
    def id(self) -> str | None:
        """The row of the list."""
        return None if self.found.form is None else self.found.form.entry.id

    @property
    def codimension(self) -> int | Literal["infinite"] | None:
        """Of T G f in Mθ, where it is known."""
        return self.found.codimension

    @property
    def reason(self) -> str:
        """Why there is no name, or no equivalence; empty if there is one."""
        return self.found.reason

    @property
    def undecided(self) -> bool:
        """Whether the germ may have a name, though none is told."""
        return self.found.undecided

    @property
    def signs(self) -> dict[str, int]:
        """1 or −1 by the first monomial of the normal form that each ± governs."""
        form, equivalence = self.found.form, self.found.equivalence
        if form is None or equivalence is None:
            return {}
        return {text: equivalence.signs[place] for place, text in sign_names(form).items()}

    @property
    def moduli(self) -> dict[str, Any]:
        """The values of the moduli: Fractions, or numbers that tell themselves as text."""
        return {} if self.found.equivalence is None else dict(self.found.equivalence.moduli)

    @property
    def normal_form(self) -> tuple[str, ...]:
        """The components of the normal form, in the variables of the list; none without a name.

        >>> from osculant.germs.recognise import recognise
        >>> recognise("x^3 + x*y^2 + x^5", "x y").normal_form
        ('x**2*y + y**3',)
        """
        form, equivalence = self.found.form, self.found.equivalence
        if form is None or equivalence is None:
            return ()
        return printed(form, equivalence.signs, equivalence.moduli)

    @property
    def equivalence(self) -> Equivalence | None:
        """The equivalence of the germ with the normal form, as the exact room has it."""
        return self.found.equivalence

    @property
    def secants(self) -> tuple[str, ...]:
        """The rows of table 6.1 whose secant germs have this class of table 6.2.

        >>> from osculant.germs.recognise import recognise
        >>> recognise("x1, x2, x3*u + x1*x3 + x2*x3^2 + x3^3", "x1 x2 x3 u").secants
        ('4-8+', '4-P3(c)')
        """
        if self.table != "table 6.2" or self.name is None:
            return ()
        from osculant.cas.recognition.secant_rows import secant_rows

        return secant_rows(self.germ.target).get(self.name, ())

    @property
    def unused(self) -> tuple[str, ...]:
        """The source variables on which the formulas do not depend."""
        seen = variables(self.germ.exact.components)
        return tuple(name for name in self.germ.source if name not in seen)

    def told(self) -> dict[str, Any]:
        """All of it as plain data (module text).

        >>> from osculant.germs.recognise import recognise
        >>> found = recognise("x^3 + y^2", "x y").told()
        >>> found["name"], found["normal_form"], found["signs"], found["proof"]
        ('A2', ['x**3 + y**2'], {'x**3': 1, 'y**2': 1}, 'equivalence')
        """
        found, form, named = self.found, self.found.form, self.equivalence is not None
        told: dict[str, Any] = {
            "version": 1,
            "source": list(self.germ.source),
            "target": self.germ.target,
            "components": list(self.germ.components),
            "boundary": self.germ.boundary,
            "group": found.group.name,
        }
        if self.germ.at is not None:
            told["at"] = list(self.germ.at)
        if self.germ.even is not None:
            told["even"] = even_data(self.germ, found.group)
        if self.tolerance is not None:
            told["tolerance"] = self.tolerance
            told["nearby"] = [to_text(node) for node in found.germ.components]
            told["margin"] = None if self.margin is None else asdict(self.margin)
        return {
            **told,
            "lists": list(found.lists),
            "name": self.name,
            "complex": self.complex,
            "table": self.table,
            "id": self.id,
            "integers": None if form is None else dict(form.integers),
            "normal_form": list(self.normal_form) if named else None,
            "variables": None if form is None else list(form.variables),
            "signs": self.signs if named else None,
            "moduli": {name: str(value) for name, value in self.moduli.items()} if named else None,
            "estimates": {n: float(v) for n, v in self.moduli.items() if not isinstance(v, Fraction)},
            "real_field": self._field(),
            "codimension": self.codimension,
            "determinacy": None if form is None else form.order,
            "proof": "equivalence" if named else None if form is None else "key",
            "key": None if found.key is None else {k: list(v) for k, v in found.key.parts.items()},
            "reason": self.reason or None,
            "undecided": self.undecided,
            "alike": list(found.alike),
            "unused": list(self.unused),
            **({"secants": list(self.secants)} if self.table == "table 6.2" else {}),
        }

    def _field(self) -> dict[str, Any] | None:
        """The real number field in which lines or moduli of the germ are found, where one is needed."""
        found = self.found.equivalence
        bases = [getattr(value, "base", None) for value in self.moduli.values()]
        fields = [base.field for base in bases if isinstance(base, Algebraic)]
        if found is not None and found.finish is not None:
            fields = [found.finish.field]
        if not fields:
            return None
        told = fields[0].told()
        terms = {poly.monomial((i,)): Fraction(c) for i, c in enumerate(told["polynomial"]) if Fraction(c)}
        low, high = map(Fraction, told["interval"])
        text = to_text(as_node(terms, (told["name"],)))
        return {"name": told["name"], "polynomial": text, "near": float((low + high) / 2)}

    def equivalence_data(self) -> dict[str, Any] | None:
        """The equivalence as plain data, of jets (`osculant.germs.equivalence_file`); None without one."""
        from osculant.germs.equivalence_file import equivalence_file

        found = self.found.equivalence
        return None if found is None else equivalence_file(self.germ, found, determined=False)

    def certificate(self) -> dict[str, Any]:
        """The equivalence as a certificate file, which `osculant.check` checks; it may prove determinacy too.

        Raises DomainError where there is no equivalence.

        >>> from osculant.certificates.checker import check
        >>> from osculant.germs.recognise import recognise
        >>> len(check(recognise("x, x*y + y^4 + x^3", "x y").certificate())) > 1
        True
        """
        from osculant.germs.equivalence_file import equivalence_file

        found = self.found.equivalence
        if found is None:
            raise DomainError(f"There is no equivalence to certify: {self.reason}")
        return equivalence_file(self.germ, found)

    def __repr__(self) -> str:
        return f"<Recognised {self.name or 'no name'} {', '.join(self.germ.components)}>"
