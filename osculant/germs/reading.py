"""What a germ may be made of: text, a file, expressions, dictionaries of coefficients; never evaluated."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas.expression import ZERO, Node, number, variable
from osculant.cas.formulas.graph import variables
from osculant.cas.formulas.parser import FILE, parse, parse_constant, parse_tuple
from osculant.cas.germs import polynomials as poly

if TYPE_CHECKING:
    from osculant.cas.germs.algebraic import NumberField
    from osculant.cas.germs.germ import Germ


class ReadGerm(NamedTuple):
    """A germ f that was read; the point moved to the origin; S, if f is read from S(…, λ) = f(…, λ²)."""

    germ: Germ
    at: tuple[str, ...] | None = None
    even: Germ | None = None


def read_germ(formulas: Any, source: Any, boundary: Any, at: Any, root: str | None, even: Any) -> ReadGerm:
    """The germ that `osculant.germs.map_germ.germ` is asked for, with its arguments and errors.

    >>> found = read_germ("x, x*lam^2 + lam^4", "x lam", None, None, None, "lam")
    >>> print(found.germ, found.germ.boundary, found.even)
    (x, x*u + u**2) u (x, x*lam**2 + lam**4)
    """
    from osculant.cas.germs.even import halved
    from osculant.cas.germs.germ import Germ
    from osculant.cas.germs.moved import moved

    names = names_of(source)
    field = None if root is None else stated_field(root, names)
    components = components_of(formulas, names, field)
    u = None if boundary is None else str(boundary)
    if even is not None and u is not None:
        raise DomainError(
            f"even: a germ even in {even} gets its own boundary, where {even}**2 is 0: name no other.",
            argument="even",
        )
    point = None if at is None else point_of(at)
    if point is None:
        found = Germ(components, names, u, field)
    else:
        found = moved(components, names, point, u, field)
    told = None if point is None else tuple(map(str, point))
    if even is None:
        return ReadGerm(found, told)
    if point is not None and str(even) in names and point[names.index(str(even))]:
        raise DomainError(
            f"at: a germ even in {even} is one at {even} = 0: give 0 for {even}.", argument="at"
        )
    return ReadGerm(halved(found, str(even)), told, found)


def names_of(source: Any) -> tuple[str, ...]:
    """The names of variables, from text with blanks between them or from a sequence of names and symbols.

    >>> names_of("x, y") == names_of(["x", "y"]) == ("x", "y")
    True
    """
    names = tuple(map(str, _parts(source.replace(",", " ").split() if isinstance(source, str) else source)))
    return tuple(variable(name).value for name in names)  # refuses what cannot be a name


def stated_field(root: str, names: Sequence[str]) -> NumberField:
    """The number field of a root of a polynomial, whose variable names it; none of these names.

    Raises DomainError for what is no irreducible polynomial in one other variable.

    >>> stated_field("a^2 - 2", ("x", "y")).degree
    2
    """
    from osculant.cas.germs.algebraic import NumberField

    field = NumberField.stated(root)
    if field.name in names:
        raise DomainError(
            f"root: {field.name!r} is a source variable: call the root otherwise.", argument="root"
        )
    return field


def components_of(formulas: Any, names: Sequence[str], field: NumberField | None = None) -> tuple[Node, ...]:
    """The expressions of a germ's components, in variables of these names.

    Args:
        formulas: text, a `pathlib.Path` of a file that holds such text, or components: one or a sequence of
            texts, sympy or symengine expressions, or dictionaries {exponents: coefficient}.
        names: the source variables.
        field: the number field whose root has a name in the formulas.

    Raises FormulaError for what is none of these or has no component, and for a file that cannot be read;
    DomainError for exponents or coefficients that are none.

    >>> print(*components_of([{(1, 0): 1}, {(1, 1): 1, (0, 3): Fraction(1, 2)}], ("x", "y")))
    x x*y + 1/2*y**3
    """
    known = names if field is None else [*names, str(field.name)]
    if isinstance(formulas, str):
        return parse_tuple(formulas, known)
    if isinstance(formulas, Path):
        return parse_tuple(text_of(formulas), known, FILE)
    parts = [formulas] if isinstance(formulas, Mapping) else _parts(formulas)
    if not parts:
        raise FormulaError("The germ has no component: give at least one formula, such as x**2.")
    return tuple(_component(part, names, known) for part in parts)


def text_of(file: Path) -> str:
    """The text of a file of formulas; FormulaError if it cannot be read, is too large or no text.

    >>> text_of(Path("no such file"))
    Traceback (most recent call last):
    osculant.cas.errors.FormulaError: The file no such file cannot be read: No such file or directory.
    """
    shown = str(file).encode("utf-8", "backslashreplace").decode("utf-8")
    try:
        with file.open("rb") as stream:
            found = stream.read(FILE.characters + 1)
    except (OSError, ValueError) as error:  # a name with a zero byte is a ValueError
        raise FormulaError(
            f"The file {shown} cannot be read: {getattr(error, 'strerror', None) or error}."
        ) from None
    if len(found) > FILE.characters:
        raise FormulaError(
            f"The file {shown} is too large: a file of formulas has at most {FILE.characters} bytes."
        )
    try:
        text = found.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        raise FormulaError(f"The file {shown} is no text: it must hold formulas, such as x, x*y + y^3.")
    if not text.strip():
        raise FormulaError(f"The file {shown} is empty: it must hold formulas, such as x, x*y + y^3.")
    return text


def point_of(at: Any) -> tuple[Fraction, ...]:
    """The exact coordinates of a point, from text such as ``"1, -1/2"`` or from a sequence of numbers.

    Raises FormulaError for text that is no formula, DomainError for coordinates that are not rational, floats
    among them: their digits may not be meant.

    >>> point_of("1, -1/2") == point_of([1, Fraction(-1, 2)])
    True
    """
    parts = list(parse_tuple(at, ())) if isinstance(at, str) else _parts(at)
    return tuple(_rational(parse_constant(part) if isinstance(part, str) else part) for part in parts)


def constants_of(given: Any, argument: str) -> tuple[Node, ...]:
    """Exact constants, from text such as ``"sqrt(2), -1/2"`` or from numbers, texts and expressions of sympy.

    Raises FormulaError for text that is no formula, DomainError, naming the argument, for floats and for what
    is no constant.

    >>> print(*constants_of("sqrt(2), -1/2", "at"), *constants_of([1, "1/3"], "at"), *constants_of(2, "at"))
    sqrt(2) -1/2 1 1/3 2
    """
    parts = list(parse_tuple(given, ())) if isinstance(given, str) else _parts(given)
    return tuple(_constant(part, argument) for part in parts)


def _constant(part: Any, argument: str) -> Node:
    from osculant.cas.formulas.sympy_bridge import from_sympy

    if isinstance(part, str):
        part = parse_constant(part)
    if type(part) is int or isinstance(part, Fraction):
        part = number(part)
    if isinstance(part, (float, bool)) or getattr(part, "is_Float", False):
        raise DomainError(
            f"{argument}: the coordinate {part} is no exact number: give one such as 1/2.", argument=argument
        )
    node = part if isinstance(part, Node) else from_sympy(part)
    if variables([node]):
        raise DomainError(f"{argument}: the coordinate {part} is no number.", argument=argument)
    return node


def _rational(coordinate: Any) -> Fraction:
    value = coordinate
    if isinstance(coordinate, Node):
        value = coordinate.value if coordinate.kind == "number" else None
    elif getattr(coordinate, "is_Rational", False):  # of sympy
        value = Fraction(int(coordinate.p), int(coordinate.q))
    if not isinstance(value, (int, Fraction)) or isinstance(value, bool):
        raise DomainError(
            f"at: the coordinate {coordinate} is no exact rational number: give one such as 1/2.",
            argument="at",
        )
    return Fraction(value)


def _component(part: Any, names: Sequence[str], known: Sequence[str]) -> Node:
    if isinstance(part, str):
        return parse(part, known)
    if isinstance(part, Mapping):
        return _polynomial(part, names)
    from osculant.cas.formulas.sympy_bridge import from_sympy

    return from_sympy(part)


def _polynomial(coefficients: Mapping[Any, Any], names: Sequence[str]) -> Node:
    from osculant.cas.formulas.sympy_bridge import from_sympy

    n, total = len(names), ZERO
    for exponents, coefficient in coefficients.items():
        whole = isinstance(exponents, tuple) and all(type(e) is int and e >= 0 for e in exponents)
        if not whole or len(exponents) != n or sum(exponents) > poly.LARGEST:
            raise DomainError(
                f"The exponents {exponents!r} of a coefficient are none: give a tuple of {n} whole numbers "
                f"of at least 0 and a sum of at most {poly.LARGEST}."
            )
        node = from_sympy(coefficient)
        if variables([node]) & set(names):
            raise DomainError(f"The coefficient {coefficient} of {exponents} is no number.")
        term = node
        for name, e in zip(names, exponents):
            term = term * variable(name) ** e if e else term
        total = total + term
    return total


def _parts(given: Any) -> list[Any]:
    try:
        return list(given)
    except TypeError:  # one expression
        return [given]
