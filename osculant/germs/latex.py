"""The answers about a germ as LaTeX, one equation on a line."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import FormulaError
from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.graph import topological
from osculant.germs.report import tells_ramification

if TYPE_CHECKING:
    from osculant.germs.map_germ import MapGerm

#: operations of the largest germ written in LaTeX
MOST = 2000
INFINITE, UNDECIDED = r"\infty", r"\text{undecided}"


def map_latex(name: str, components: Sequence[Node], source: Sequence[str]) -> str:
    r"""A map as an equation; FormulaError for one of more than `MOST` operations.

    >>> from osculant.germs.map_germ import germ
    >>> print(map_latex("f", germ("x1, x1*y + y^3/2", "x1 y").exact.components, ["x1", "y"]))
    f(x_{1}, y) = \left(x_{1},\; x_{1} y + \frac{y^{3}}{2}\right)
    """
    return f"{name}({_listed(_names(source))}) = {vector_latex(components)}"


def vector_latex(components: Sequence[Node]) -> str:
    """A vector of expressions, or one expression without parentheses; FormulaError as for `map_latex`."""
    operations = len(topological(components))
    if operations > MOST:
        raise FormulaError(
            f"LaTeX is written of germs of at most {MOST} operations, and this one has {operations}: "
            "ask for text or JSON."
        )
    from sympy import latex

    from osculant.cas.formulas.sympy_bridge import to_sympy

    parts = [str(latex(to_sympy(node))) for node in components]
    return parts[0] if len(parts) == 1 else rf"\left({_listed(parts, semicolon=True)}\right)"


def group_latex(name: str, extended: bool = False) -> str:
    r"""A group's name.

    >>> print(group_latex("A(H)", extended=True), group_latex("R"))
    \mathcal{A}(H)_e \mathcal{R}
    """
    subscript = "_e" if extended else ""
    found = re.fullmatch(r"([RLCKA])(\(H\))?", name)
    if found is None:  # a group of one's own
        return rf"\mathrm{{{name}}}{subscript}"
    return rf"\mathcal{{{found[1]}}}{found[2] or ''}{subscript}"


def report_latex(germ: MapGerm, data: dict[str, Any]) -> Iterator[str]:
    r"""The answers that `osculant.germs.report.report` gives about a germ, each an equation or a statement.

    >>> from osculant.germs.map_germ import germ
    >>> from osculant.germs.report import report
    >>> g = germ("x, y^2, y^3 + x^2*y", "x y")
    >>> print(*report_latex(g, report(g)), sep="\n")
    f(x, y) = \left(x,\; y^{2},\; x^{2} y + y^{3}\right)
    \operatorname{rank} df(0) = 1
    \operatorname{cod}(\mathcal{A}, f) = 3
    \operatorname{cod}(\mathcal{A}_e, f) = 1
    f \text{ is $3$-determined for } \mathcal{A} \text{, and not $2$-determined}
    f \text{ is not stable for } \mathcal{A}
    F(t_{1}, x, y) = \left(t_{1},\; x,\; y^{2},\; t_{1} y + x^{2} y + y^{3}\right)
    \dim \theta(f) / T\mathcal{K}_e f = 3
    \dim Q(f) = 2
    \dim \mathcal{O} / R(f) = 2
    """
    yield map_latex("f", germ.exact.components, germ.source)
    yield rf"\operatorname{{rank}} df(0) = {data['rank']}"
    name = data["group"]
    acting, extended = group_latex(name), group_latex(name, extended=True)
    yield rf"\operatorname{{cod}}({acting}, f) = {_value(data['codimension'])}"
    yield rf"\operatorname{{cod}}({extended}, f) = {_value(data['extended_codimension'])}"
    yield rf"f \text{{ {_determined(data)} }} {acting}" + _sharp(data)
    if data["stable"] is not None:
        yield rf"f \text{{ is {'' if data['stable'] else 'not '}stable for }} {acting}"
    elif "stable" in data["undecided"]:
        yield rf"f \text{{ is stable for }} {acting} \text{{: undecided}}"
    if data["unfolding"] is not None:
        unfolded = germ.unfolding(name, _letter(data)) if data["unfolding"] else None
        if unfolded is not None:
            yield map_latex("F", unfolded.germ.exact.components, unfolded.germ.source)
    yield rf"\dim \theta(f) / T\mathcal{{K}}_e f = {_value(data['tjurina'])}"
    if "milnor" in data:
        yield rf"\mu(f) = {_value(data['milnor'])}"
    yield rf"\dim Q(f) = {_value(data['multiplicity'])}"
    if tells_ramification(data):
        yield rf"\dim \mathcal{{O}} / R(f) = {_value(data['ramification'])}"


def _value(value: Any) -> str:
    return UNDECIDED if value is None else INFINITE if value == "infinite" else str(value)


def _determined(data: dict[str, Any]) -> str:
    degree = data["determinacy"]
    if degree is None:
        return "is finitely determined, which is undecided, for"
    return "is not finitely determined for" if degree == "infinite" else f"is ${degree}$-determined for"


def _sharp(data: dict[str, Any]) -> str:
    sharp = data["sharp"] and data["determinacy"] != "infinite" and data["determinacy"] > 1
    return rf" \text{{, and not ${data['determinacy'] - 1}$-determined}}" if sharp else ""


def _letter(data: dict[str, Any]) -> str:
    return str(data["unfolding_germ"]["parameters"][0]).rstrip("0123456789")


def _names(source: Sequence[str]) -> list[str]:
    from sympy import Symbol, latex

    return [str(latex(Symbol(name))) for name in source]


def _listed(parts: Sequence[str], semicolon: bool = False) -> str:
    return (r",\; " if semicolon else ", ").join(parts)
