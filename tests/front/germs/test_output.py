"""What `osculant germ` prints: numbers or "undecided: reason", LaTeX."""

from __future__ import annotations

import json
import re

import pytest
import typer
from typer.testing import CliRunner

from osculant.cas.errors import FormulaError
from osculant.certificates.checker import check
from osculant.cli.germ import GermCommand
from osculant.cli.germ import germ as command
from osculant.cli.germ_rows import rows
from osculant.cli.grammar import Commands
from osculant.germs.latex import report_latex
from osculant.germs.map_germ import germ
from osculant.germs.report import certificate_file, report

app = typer.Typer(cls=Commands, pretty_exceptions_enable=False)
app.callback()(lambda: None)
app.command("germ", cls=GermCommand)(command)

#: rows with a number, and what else may stand there
NUMBERS = {
    "codimension",
    "extended codimension",
    "determinacy",
    "Tjurina number",
    "Milnor number",
    "multiplicity",
    "ramification",
}
NUMBER = re.compile(r"(\d+|infinite)(, .*)?|undecided(: .*\.)?")
KEYS = ["codimension", "extended_codimension", "determinacy", "tjurina", "multiplicity", "ramification"]

GERMS = [
    ("x^3 + y^4", "x y", "R"),
    ("x^2*y^2*(1 + x)^40", "x y", "R"),  # of degree 44, infinite
    ("(x^3 + y^4)*(1 + x + y)^40", "x y", "R"),  # of degree 44, finite
    ("x^2*y^2 + x^40", "x y", "K"),
    ("x^2 + y^2, x*y", "x y", "A"),
    ("x, y^2, 0", "x y", "A"),
    ("x, y^9 + x*y", "x y", "K"),
    ("x, y, x*z + z^3", "x y z", "A"),
    ("asin(x)^2", "x y", "R"),
    ("asin(x)^2, asin(y)^2, 0", "x y", "A"),
    ("x, u^2 + x*u", "x u", "A(H)"),
]


def run(*arguments: str) -> str:
    result = CliRunner().invoke(app, ["germ", *arguments])
    if result.exception is not None:
        raise result.exception
    return result.stdout


@pytest.mark.parametrize("formula, source, group", GERMS)
def test_where_a_number_is_expected_there_is_one_or_undecided(formula, source, group):
    data = json.loads(run(formula, "--source", source, "--group", group, "--patience", "0.5", "--json"))
    table = dict(rows(data))
    for name in NUMBERS & set(table):
        assert NUMBER.fullmatch(table[name]), (name, table[name])
    assert table.get("stable", "yes") in {"yes", "no"} or table["stable"].startswith("undecided")
    assert not any("no proof" in text for text in table.values())
    for key in [*KEYS, *(["milnor"] if len(formula.split(",")) == 1 else [])]:
        value = data[key]
        assert value is None or value == "infinite" or type(value) is int
        assert (value is None) == (key in data["undecided"])
        assert (value is None) == (key in data["reason"])


def test_high_degrees_are_decided():
    infinite, finite = (report(germ(formula, "x y")) for formula, _, _ in GERMS[1:3])
    assert {infinite[key] for key in ("codimension", "milnor", "tjurina", "ramification")} == {"infinite"}
    assert (finite["milnor"], finite["tjurina"], finite["ramification"], finite["undecided"]) == (6, 6, 6, [])
    high = report(germ("x^2*y^2 + x^40", "x y"))
    assert high["codimension"] == high["ramification"] == "infinite"


def test_ramification_is_told_where_it_says_something():
    def told(formula, source):
        return [line for line in run(formula, "--source", source).splitlines() if line.startswith("ramif")]

    assert told("x, y^2, x*y", "x y") == ["ramification          1"]
    assert told("x, y^2, 0", "x y") == ["ramification          infinite"]
    assert told("x, y", "x y") == ["ramification          0"]
    assert told("x, y^2", "x y") == []  # of a singular germ of the plane it is never finite
    assert report(germ("x, y^2", "x y"))["ramification"] == "infinite"
    assert told("x^3 + y^4", "x y") == ["ramification          6"]


def test_what_has_no_meaning_is_not_undecided():
    data = report(germ("x^2*y^2", "x y"))
    assert (data["stable"], data["unfolding"], data["unfolding_germ"], data["hilbert"]) == (None,) * 4
    assert data["undecided"] == []
    printed = run("x^2*y^2", "--source", "x y")
    assert "stable" not in printed
    assert "unfolding             none: A germ of infinite codimension has no versal unfolding." in printed


def test_latex():
    assert run("x1, x1*y + y^4/2", "--source", "x1 y", "--latex").splitlines() == [
        r"f(x_{1}, y) = \left(x_{1},\; x_{1} y + \frac{y^{4}}{2}\right)",
        r"\operatorname{rank} df(0) = 1",
        r"\operatorname{cod}(\mathcal{A}, f) = 3",
        r"\operatorname{cod}(\mathcal{A}_e, f) = 1",
        r"f \text{ is $4$-determined for } \mathcal{A} \text{, and not $3$-determined}",
        r"f \text{ is not stable for } \mathcal{A}",
        r"F(t_{1}, x_{1}, y) = \left(t_{1},\; t_{1} y + x_{1},\; x_{1} y + \frac{y^{4}}{2}\right)",
        r"\dim \theta(f) / T\mathcal{K}_e f = 3",
        r"\dim Q(f) = 4",
    ]
    e6 = run("x^3 + y^4", "--source", "x y", "--latex").splitlines()
    assert r"\mu(f) = 6" in e6
    assert r"\operatorname{cod}(\mathcal{R}_e, f) = 6" in e6
    assert not any("stable" in line for line in e6)


@pytest.mark.parametrize("formula, source, group", GERMS)
def test_latex_is_balanced(formula, source, group):
    g = germ(formula, source, patience=0.5)
    lines = list(report_latex(g, report(g, group)))
    for line in lines:
        assert line.count("{") == line.count("}")
        assert line.count(r"\left(") == line.count(r"\right)")
        assert line.count("$") % 2 == 0
        assert "None" not in line
        assert "infinite" not in line


def test_latex_of_a_huge_germ_is_refused():
    g = germ([{(k, j): 1 for k in range(1, 40) for j in range(60)}], "x y")
    with pytest.raises(FormulaError, match=r"at most 2000 operations, and this one has [0-9]+: ask for text"):
        list(report_latex(g, {}))


def test_a_certificate_of_a_long_sum_is_checked():
    """600 terms: the checker follows sums without recursion."""
    terms = {(i, 44 - i + k): i + 1 for k in range(14) for i in range(45)}
    g = germ([{(1, 0): 1}, {(0, 2): 1, **terms}], "x y")
    proved = check(certificate_file(g))
    assert len(proved) >= 3


def test_certificates_with_a_point_and_an_unfolding_are_checked():
    g = germ("x, y^2, y^3 + (x - 1)^2*y", "x y", at="1,0")
    data = certificate_file(g)
    assert data["at"] == ["1", "0"]
    assert any("3-determined" in sentence for sentence in check(json.loads(json.dumps(data))))
