"""Unfoldings printed by `osculant germ` are pasted back and found versal; families that are not are told."""

from __future__ import annotations

import json
import re

import pytest
import typer
from typer.testing import CliRunner

from osculant.cas.errors import DomainError, OsculantError
from osculant.cli.germ import GermCommand
from osculant.cli.germ import germ as command
from osculant.cli.grammar import Commands
from osculant.germs.map_germ import germ

app = typer.Typer(cls=Commands, pretty_exceptions_enable=False)
app.callback()(lambda: None)
app.command("germ", cls=GermCommand)(command)

#: germ, source, group: of all groups, quasi-homogeneous or not, with moduli, with clashing names
GERMS = [
    ("x^3 + x*y^3", "x y", "R"),
    ("x^4 + y^5 + x^2*y^3", "x y", "R"),  # Tjurina number 11, Milnor number 12
    ("x^4 + y^5 + x^2*y^3", "x y", "K"),
    ("x^9", "x", "R"),
    ("x^20 + y^2", "x y", "R"),
    ("t1^3 + s1^2*t1", "t1 s1", "R"),
    ("cos(x) - 1 + y^3", "x y", "R"),
    ("(x^2 + y^3)*exp(x)", "x y", "K"),
    ("x^2 + u^3", "x u", "R(H)"),
    ("x*u + x^3", "x u", "K(H)"),
    ("x^2, y^3", "x y", "C"),
    ("x^2, y^2", "x y", "K"),
    ("t^2, t^5", "t", "L"),
    ("t^3, t^7", "t", "A"),
    ("t^3, t^7 + t^8", "t", "A"),
    ("x, y^2, y^3 + x^3*y", "x y", "A"),
    ("x, y^2, x^2*y - y^5", "x y", "A"),
    ("x, x*y + y^5, y^3", "x y", "A"),
    ("x, x*y^2 + y^4 + y^5", "x y", "A"),
    ("x^2 - y^2 + x^3, x*y", "x y", "A"),
    ("x, x*y + y^4", "x y", "A"),
    ("x, y^2, 1/2*y^3 - x^2*y/3", "x y", "A"),
    ("x, u^2 + x^2*u", "x u", "A(H)"),
    ("x, z^2 + x*u + u^3", "x z u", "A(H)"),
]


def run(*arguments: str) -> str:
    result = CliRunner().invoke(app, ["germ", *arguments])
    if result.exception is not None:
        raise result.exception
    return result.stdout


def rows(*arguments: str) -> dict[str, str]:
    """The table as it is printed."""
    return {line[:22].rstrip(): line[22:] for line in run(*arguments).splitlines() if line[:22].strip()}


@pytest.mark.parametrize("formula, source, group", GERMS)
def test_a_printed_unfolding_is_versal_when_pasted(formula, source, group):
    printed = rows(formula, "--source", source, "--group", group)
    text, names = printed["  as a germ"], printed["  its source"]
    parameters = names.split()[: -len(source.split())]
    assert len(parameters) == int(printed["extended codimension"])
    pasted = rows(text, "--source", names, "--group", group, "--versal", " ".join(parameters))
    assert pasted["versal"] == "yes"
    assert pasted["extended codimension"] == printed["extended codimension"]
    # as a map (t, F) it is stable, whatever the group was
    assert germ(text, names).is_stable()
    # none of the parameters can be spared
    first, *fewer = parameters
    if fewer:
        less = re.sub(rf"\b{first}\b", "0", text.partition(", ")[2])
        asked = less, "--source", names.partition(" ")[2], "--group", group, "--versal", " ".join(fewer)
        without = json.loads(run(*asked, "--json"))
        assert (without["versal"], without["reached"]) == (False, len(fewer))
        assert len(without["missing"]) == 1


@pytest.mark.parametrize(
    "formula, source, parameters, group, reached, missing",
    [
        # the swallowtail unfolded as a family of functions, without and with its constant
        ("x^4 + a*x + b*x^2", "x a b", "a b", "R", 2, ["1"]),
        ("x^4 + a*x + b*x^2 + c", "x a b c", "a b c", "R", 3, []),
        # quadratic in the parameter: no velocity at all
        ("x^3 + a^2*x", "x a", "a", "R", 0, ["1", "x"]),
        # S1 by the wrong term and by the right one, without and with the parameter as a component
        ("x, y^2, y^3 + x^2*y + a*x*y", "x y a", "a", "A", 0, ["(0, 0, y)"]),
        ("x, y^2, y^3 + x^2*y + a*y", "x y a", "a", "A", 1, []),
        ("a, x, y^2, y^3 + x^2*y + a*y", "a x y", "a", "A", 1, []),
        ("x, y^2, y^3 + x^2*y + sin(a)*exp(x)*y", "x y a", "a", "A", 1, []),
        # a coordinate change of the parameters and of the source with them
        ("(x + a)^3 + b*(x + a)", "x a b", "a b", "R", 1, ["1"]),
        ("(x + a)^3 + b*(x + a) - a", "x a b", "a b", "R", 2, []),
        ("x^3 + b*x + a*(1 + x)", "x a b", "a b", "R", 2, []),
        # more parameters than are needed
        ("x^2 + a + b + a*x", "x a b", "a b", "R", 1, []),
        ("x^2, x^3 + a*x", "x a", "a", "A", 1, []),
        # what is stable needs none
        ("x, x*y + y^3 + a*y^2", "x y a", "a", "A", 0, []),
    ],
)
def test_families_are_versal_or_not(formula, source, parameters, group, reached, missing):
    data = json.loads(run(formula, "--source", source, "--versal", parameters, "--group", group, "--json"))
    assert (data["reached"], data["missing"], data["versal"]) == (reached, missing, not missing)
    assert data["extended_codimension"] == reached + len(missing)
    table = rows(formula, "--source", source, "--versal", parameters, "--group", group)
    assert table["versal"].startswith("no" if missing else "yes")
    assert table.get("missing terms") == (missing[0] if missing else None)


def test_the_group_of_an_unfolding_is_that_of_its_germ():
    f, found = germ("a, x^3 + a*x", "a x").versality(["a"])
    assert (f.group().name, found.versal, f.components, f.source) == ("R", False, ("x**3",), ("x",))
    assert germ("a, x^3 + a*x + b, b", "a x b").versality("a b", "R")[1].versal
    u, found = germ("a, x, u^2 + a*u + x^2*u", "a x u").versality("a")
    assert (u.group().name, u.boundary, found.versal) == ("A(H)", "u", True)


MISTAKES = {
    "no parameter": ("x^2", "x a", "", "must be one or more, all different"),
    "twice": ("x^2", "x a", "a a", "must be one or more, all different"),
    "unknown": ("x^2", "x a", "b", "The parameter 'b' is not a source variable: choose among x, a."),
    "the boundary": ("x + u^2", "x u", "u", "The boundary variable 'u' is no parameter"),
    "all": ("x^2 + a", "x a", "x a", "leave at least one that is none"),
    "no germ": ("a", "x a", "a", "no components but its parameters"),
    "infinite": ("x^2*y^2 + a", "x y a", "a", "has no versal unfolding: its R codimension is infinite"),
}


@pytest.mark.parametrize("formula, source, parameters, words", MISTAKES.values(), ids=MISTAKES)
def test_mistakes_are_told_in_a_sentence(formula, source, parameters, words):
    with pytest.raises(DomainError, match=words):
        run(formula, "--source", source, "--versal", parameters)


def test_options_that_do_not_go_together():
    with pytest.raises(OsculantError, match="ask two things"):
        run("x^2 + a", "--source", "x a", "--versal", "a", "--transversal", "2")
    for more in (["--versal", "a"], ["--transversal", "2"], ["--certificate"]):
        with pytest.raises(OsculantError, match="--latex writes the answers alone"):
            run("x^2 + a", "--source", "x a", "--latex", *more)
