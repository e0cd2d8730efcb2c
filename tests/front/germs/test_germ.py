"""`osculant.germs` and `osculant germ`: answers, JSON, what is infinite or undecided, mistakes."""

from __future__ import annotations

import json

import pytest
import symengine
import sympy
import typer
from typer.testing import CliRunner

from osculant.cas.errors import DomainError, FormulaError, OsculantError, UndecidedError
from osculant.cas.germs import codimension as codimensions
from osculant.cas.germs.groups import Group
from osculant.cli.germ import GermCommand
from osculant.cli.germ import germ as command
from osculant.cli.grammar import Commands
from osculant.germs.map_germ import germ
from osculant.germs.report import certificate, report

app = typer.Typer(cls=Commands, pretty_exceptions_enable=False)
app.callback()(lambda: None)
app.command("germ", cls=GermCommand)(command)

FOLD = ("x1, x2, x3**2 + x1*u + x2*u**2 + u**3", "x1 x2 x3 u")
KEYS = {
    "source": list,
    "target": int,
    "components": list,
    "boundary": str,
    "group": str,
    "rank": int,
    "codimension": (int, str),
    "extended_codimension": (int, str),
    "determinacy": (int, str),
    "sharp": bool,
    "sharpness": str,
    "stable": bool,
    "unfolding": list,
    "unfolding_germ": dict,
    "tjurina": (int, str),
    "multiplicity": (int, str),
    "hilbert": list,
    "ramification": (int, str),
    "certificate": dict,
    "reason": dict,
    "undecided": list,
}


def run(*arguments: str):
    """The output of a command line; what it raises, which `osculant.cli.main.main` tells in a sentence."""
    result = CliRunner().invoke(app, ["germ", *arguments])
    if result.exception is not None:
        raise result.exception
    assert result.exit_code == 0
    return result.stdout


def run_json(*arguments: str):
    return json.loads(run(*arguments, "--json"))


def assert_schema(data: dict, function: bool = False) -> None:
    kinds = KEYS | ({"milnor": (int, str)} if function else {})
    assert set(data) == set(kinds)
    nothing_to_tell = {"boundary", "sharp"}
    for key, kind in kinds.items():
        if data[key] is None:
            assert key in nothing_to_tell or data["reason"][key].endswith(".")
        else:
            assert isinstance(data[key], kind), key
            assert key not in data["reason"]
            assert not isinstance(data[key], str) or kind is str or data[key] == "infinite"
    assert set(data["certificate"]) == {"codimension", "extended_codimension", "determinacy"}
    json.dumps(data, allow_nan=False)


def test_the_germ_of_the_readme():
    data = run_json(FOLD[0], "--source", FOLD[1], "--group", "A(H)")
    assert_schema(data)
    assert data["source"] == ["x1", "x2", "x3", "u"]
    assert (data["target"], data["rank"], data["boundary"], data["group"]) == (3, 2, "u", "A(H)")
    assert (data["codimension"], data["extended_codimension"]) == (3, 0)
    assert (data["determinacy"], data["sharp"]) == (3, True)
    assert (data["stable"], data["unfolding"], data["reason"].keys()) == (True, [], {"hilbert"})
    proof = data["certificate"]["determinacy"]
    assert (proof["bound"], proof["order"]) == (3, 6)
    for key, constants in (("codimension", 3), ("extended_codimension", 0)):
        certificate = data["certificate"][key]
        assert certificate["columns"] - certificate["rank"] == len(certificate["functionals"])
        assert data[key] == len(certificate["functionals"]) - constants


def test_report_and_methods_agree():
    g = germ("x, y**2, y**3 - x**3*y", "x y")
    data = report(g)
    assert_schema(data)
    assert data["codimension"] == g.codimension("A") == 4
    assert data["extended_codimension"] == g.codimension("A", extended=True) == 2
    found = g.determinacy("A")
    assert (data["determinacy"], data["sharp"], data["sharpness"]) == (found.degree, True, found.reason)
    assert data["stable"] is g.is_stable("A") is False
    assert tuple(data["unfolding"]) == g.unfolding("A").terms
    assert len(data["unfolding"]) == 2
    assert data["certificate"] == certificate(g, "A")
    assert (data["tjurina"], data["multiplicity"]) == (g.tjurina, g.multiplicity)
    assert data["ramification"] == g.ramification.dimension
    assert tuple(data["hilbert"]) == g.q_algebra.hilbert


def test_an_unfolding_is_versal_and_a_stable_one_stable():
    unfolded = germ("x, y**2, y**3 + x**2*y", "x y").unfolding("A", "s").germ
    assert unfolded.source == ("s1", "x", "y")
    assert unfolded.codimension("A", extended=True) == 0
    assert germ("x**2 + y**3", "x y").stable_unfolding("A").germ.is_stable("A")
    genotype = germ("z**2 + u**3", "z u").stable_unfolding("A(H)")
    assert genotype.terms == ("u", "u**2")
    assert genotype.germ.boundary == "u"
    assert genotype.germ.codimension("A(H)") == 3


def test_groups_that_are_meant():
    x, y = sympy.symbols("x y")
    assert [germ(f, "x y").group().name for f in (x, [x, y])] == ["R", "A"]
    assert [germ(f, "x y", boundary=y).group().name for f in (x, [x, y])] == ["R(H)", "A(H)"]
    assert germ("x**2 + u**3", "x u").codimension(extended=True) == 3
    own = Group("R(cusp)", "own", "none", ("2*x, 3*y", "2*y, 3*x**2"))
    assert germ("x + y", "x y").codimension(own, extended=True) == 1
    assert germ("x", "x", "x").group("r ( h )").name == "R(H)"


def test_expressions_are_read_like_text():
    x, y = sympy.symbols("x y")
    a, b = symengine.symbols("x y")
    written = "x, x*y + y**3/3"
    expected = report(germ(written, "x y"))
    for formulas, source in (
        ([x, x * y + y**3 / 3], [x, y]),
        ((a, a * b + b**3 / 3), (a, b)),
        (sympy.Matrix([x, x * y + y**3 / 3]), "x, y"),
        (["x", x * y + y**3 / 3], ("x", y)),
    ):
        got = report(germ(formulas, source))
        texts = {"components": 0, "unfolding_germ": 0}  # written as they were given
        assert {**got, **texts} == {**expected, **texts}
    assert germ(x**3, x).milnor == germ("x**3", "x").milnor == 2
    assert germ(sympy.sin(x) ** 2, x).codimension("R", extended=True) == 1


def test_functions_have_a_milnor_number():
    data = run_json("x^4 + y^5 + x^2*y^3", "--source", "x y")
    assert_schema(data, function=True)
    assert (data["group"], data["milnor"], data["tjurina"], data["ramification"]) == ("R", 12, 11, 12)
    assert data["stable"] is None
    assert (data["multiplicity"], data["hilbert"]) == ("infinite", None)


def test_algebras():
    g = germ("x**2 + y**2, x*y", "x y")
    assert (g.multiplicity, g.q_algebra.hilbert, g.ramification) == (4, (1, 2, 1), "infinite")
    assert germ("x*y, x*y", "x y").multiplicity == "infinite"
    assert germ("x, y, x*z", "x y z").ramification == "infinite"
    assert germ("x, y, 0", "x y").ramification.dimension == 0
    assert germ("x**2*y**2", "x y").milnor == germ("x**2*y**2", "x y").tjurina == "infinite"
    with pytest.raises(DomainError, match="that of a function"):
        _ = g.milnor


@pytest.mark.parametrize("text", ["x, y^2, 0", "x, y^4, x*y^2"])
def test_infinite_is_an_answer(text):
    data = run_json(text, "--source", "x y")
    assert_schema(data)
    assert data["codimension"] == data["extended_codimension"] == data["determinacy"] == "infinite"
    assert (data["stable"], data["unfolding"]) == (False, None)
    assert "infinite codimension" in data["reason"]["unfolding"]
    assert data["certificate"]["determinacy"] == data["certificate"]["codimension"]
    assert data["certificate"]["codimension"]["kind"] == "locus"
    table = run(text, "--source", "x y", "--certificate")
    assert "infinite codimension: the points where df has rank 1 or less have dimension 1 or more." in table


def test_undecided_is_told_with_its_reason():
    # the inverse sine has no model, so no geometry helps; jets alone never settle it
    arguments = "asin(x)^2, asin(y)^2, 0", "--source", "x y", "--patience", "0.5"
    data = run_json(*arguments)
    assert_schema(data)
    assert data["codimension"] is data["determinacy"] is data["unfolding"] is None
    assert data["multiplicity"] == 4  # an algebra is a question of its own
    assert "within 0.5 seconds" in data["reason"]["codimension"]
    assert data["reason"]["determinacy"] == data["reason"]["codimension"]
    assert data["stable"] is False
    assert data["certificate"] == dict.fromkeys(("codimension", "extended_codimension", "determinacy"))
    lines = run(*arguments, "--certificate").splitlines()
    assert any(line.startswith("codimension           undecided: The A codimension of") for line in lines)
    assert "determinacy           undecided" in lines
    assert "stable                no" in lines
    with pytest.raises(UndecidedError, match="jets of order"):
        germ("asin(x)^2, asin(y)^2, 0", "x y", patience=0.5).codimension("A")


def test_the_table():
    lines = run(FOLD[0], "--source", FOLD[1], "--certificate").splitlines()
    assert lines[:11] == [
        "germ                  x1, x2, x3**2 + x1*u + x2*u**2 + u**3",
        "source                x1 x2 x3 u, boundary u = 0",
        "group                 A(H)",
        "rank                  2",
        "codimension           3",
        "extended codimension  0",
        "determinacy           3, sharp: x1, x2, x3**2 + x1*u has the same 2-jet and M^3θ not in its "
        "tangent space",
        "  proof               l = 3, jets of order 6, nilpotent fields y3∂/∂y1",
        "stable                yes",
        "unfolding             no terms",
        "Tjurina number        2",
    ]
    assert "                      (u, 0, 0): -1, (0, 0, u**2): 1" in lines
    assert not any(line != line.rstrip() for line in lines)
    unfolded = run("x, y^2, y^3 + x^3*y", "--source", "x y").splitlines()
    place = unfolded.index("unfolding             (0, 0, y)")
    assert unfolded[place + 1] == " " * 22 + "(0, 0, x*y)"


def test_complete_transversals():
    data = run_json("x1, x2, u", "--source", "x1 x2 x3 u", "--transversal", "1")
    assert (data["jet"], data["group"], data["components"]) == (1, "A(H)", ["x1", "x2", "u"])
    assert data["transversal"] == ["(0, 0, x1*x3)", "(0, 0, x2*x3)", "(0, 0, x3**2)"]
    table = run("x, x*y", "--source", "x y", "--transversal", "2")
    assert table.splitlines()[-1] == "3-transversal         (0, y**3)"
    fourth = ["x^3 + x*y^3", "--source", "x y", "--group", "K", "--transversal", "4"]
    assert run_json(*fourth)["transversal"] == ["y**5"]
    assert run_json(*fourth, "--order", "y x")["transversal"] == []
    assert run("x, y", "--source", "x y", "--transversal", "1").splitlines()[-1].endswith("no terms")
    with pytest.raises(UndecidedError, match="400-jet is out of reach"):
        germ("x, y", "x y").transversal(400)


@pytest.mark.parametrize("formula", ["-x", "-x-y", "-x, -y", "-u + x", "-(x)^2", "-exp(x) + 1"])
def test_a_formula_may_begin_with_a_minus(formula):
    data = run_json("--source", "x y u", formula, "--group=A")
    assert data["components"][0].startswith("-")


MISTAKES = {
    "not 0 at the origin": (["x + 1", "--source", "x"], "Component 1 of the germ is 1 at the origin"),
    "unknown variable": (["x, z", "--source", "x y"], "The name 'z' is unknown"),
    "no source": (["x, y"], "The source variables are missing"),
    "empty source": (["1 - 1", "--source", ""], "must be one or more, all different"),
    "reserved": (["x", "--source", "x pi"], "'pi' names a function or a constant"),
    "no boundary": (["x, y^2", "--source", "x y", "--group", "A(H)"], "needs the boundary variable u"),
    "no such boundary": (["x", "--source", "x y", "--boundary", "z"], "'z' is not a source variable"),
    "no such group": (["x", "--source", "x", "--group", "B"], "There is no group 'B': choose one of R, L"),
    "not analytic": (["sqrt(x)", "--source", "x"], "not analytic at the origin"),
    "irrational": (["sin(1)*x", "--source", "x"], "irrational Taylor coefficient"),
    "transcendental": (["pi*x", "--source", "x"], "pi is neither rational nor algebraic"),
    "two formulas": (["x", "y", "--source", "x y"], "one too many"),
    "a flag's value": (["x", "--json=x"], "takes no value"),
    "transversal of what": (["x", "--source", "x", "--transversal", "one"], "needs a whole number"),
    "transversal too low": (["x", "--source", "x", "--transversal", "0"], "at least 1"),
    "unknown coordinate": (["x", "--source", "x", "--transversal", "1", "--order", "z"], "'z' is no coord"),
    "no patience": (["x", "--source", "x", "--patience", "0"], "no positive number of seconds"),
    "patience in words": (["x", "--source", "x", "--patience", "long"], "needs a finite number"),
    "order alone": (["x", "--source", "x", "--order", "x"], "needs --transversal"),
    "unknown option": (["x", "--sorce", "x"], "did you mean --source"),
}


@pytest.mark.parametrize("arguments, words", MISTAKES.values(), ids=MISTAKES)
def test_mistakes_are_told_in_a_sentence(arguments, words):
    with pytest.raises(OsculantError) as caught:
        run(*arguments)
    assert words in str(caught.value)


def test_mistakes_of_the_api():
    for formulas in (None, 3.5, object(), [], [None], ["x", []]):
        with pytest.raises((FormulaError, DomainError)):
            germ(formulas, "x")
    with pytest.raises(FormulaError, match="no name of a variable"):
        germ("x", 3)
    with pytest.raises(FormulaError, match="not among its source variables"):
        germ([sympy.Symbol("z")], "x")
    for ask in ("codimension", "determinacy", "is_stable", "unfolding", "stable_unfolding"):
        with pytest.raises(DomainError, match="needs the boundary variable"):
            getattr(germ("x, y**2", "x y"), ask)("A(H)")
    with pytest.raises(DomainError, match="needs the boundary variable"):
        report(germ("x, y**2", "x y"), "A(H)")
    with pytest.raises(DomainError, match="no versal unfolding"):
        germ("x, y**2, 0", "x y").unfolding("A")
    with pytest.raises(DomainError, match="Stability is asked of A"):
        germ("x**2", "x").is_stable("R")


def test_progress_is_told():
    g, parts = germ("x, y^2", "x y"), []
    assert repr(g) == "<MapGerm x, y**2 in x y>"
    report(g, progress=parts.append)
    assert parts == sorted(parts)
    assert parts[0] == 0
    assert parts[-1] < 1


def test_a_codimension_is_computed_once(monkeypatch):
    calls = []
    kept = codimensions.codimension
    monkeypatch.setattr(codimensions, "codimension", lambda *args: calls.append(args) or kept(*args))
    g = germ("x, y**2, 0", "x y")
    assert g.codimension("A") == g.codimension("A") == g.codimension("A", extended=True) == "infinite"
    assert len(calls) == 1
