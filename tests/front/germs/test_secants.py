"""`osculant secant`, `osculant.secant` and even germs: outputs, JSON, certificates, mistakes."""

from __future__ import annotations

import json
import re
from fractions import Fraction

import mpmath
import pytest
import sympy

import osculant as osc
from osculant.cli.main import main
from osculant.germs.report import report

EXAMPLE = ["secant", "x, y, x^2+y^3", "--source", "x y", "--at", "0,0", "--direction", "1,0"]
TANGENT = "t - 2*t^4, t^2 - t^4, t^3 - t^4"


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert main(list(arguments)) == 0
    captured = capsys.readouterr()
    assert not captured.err
    return captured.out


def run_json(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict:
    return json.loads(run(capsys, *arguments, "--json"))


def test_the_example_and_its_json(capsys):
    shown = run(capsys, *EXAMPLE)
    assert re.search(r"^secant germ +v, x \+ 3/4\*\(y\*\*2\*v\) \+ 1/4\*\(u\*v\*\*3\)$", shown, re.MULTILINE)
    assert re.search(r"^  group +A\(H\), as A\^Z2 of germs even in lam$", shown, re.MULTILINE)
    data = run_json(capsys, *EXAMPLE)
    assert (data["kind"], data["version"], data["order"], data["settled"]) == ("secant", 1, None, True)
    assert data["immersion"] == ["x", "y", "x**2 + y**3"] and data["source"] == ["x", "y"]
    assert (data["at"], data["direction"], data["linked"]) == (["0", "0"], ["1", "0"], 3)
    germ = data["germ"]
    assert (germ["boundary"], germ["group"], germ["codimension"], germ["stable"]) == ("u", "A(H)", 0, True)
    assert germ["even"]["source"] == ["x", "y", "lam", "v"] and germ["even"]["group"] == "A^Z2"
    assert data["projection"]["components"] == ["y", "x**2 + y**3"]
    assert "frenet" not in data and "variety" not in data


def test_the_report_of_the_germ_can_be_read_again(capsys):
    """As an even germ, and as one with a boundary: the same answers."""
    arguments = ["x, y, x^3 + x*y^2", "--source", "x y", "--direction", "1,0"]
    data = run_json(capsys, "secant", *arguments)["germ"]
    again = osc.germ(data["components"], data["source"], data["boundary"])
    even = osc.germ(data["even"]["components"], data["even"]["source"], even=data["even"]["variable"])
    for other in (again, even):
        told = report(other, "A(H)")
        assert all(told[key] == data[key] for key in ("source", "codimension", "determinacy", "stable"))
    assert (data["codimension"], data["determinacy"]) == (2, 2)  # row 3-5 of table 6.1


def test_the_secant_variety_and_frenet_data(capsys):
    data = run_json(capsys, "secant", "t, t^2, t^4 + t^5", "--source", "t", "--variety")
    assert data["variety"]["codimension"] == "infinite" and data["variety"]["source"] == ["t", "u", "s"]
    assert data["frenet"]["condition"] == "360" and data["frenet"]["case"] == "pitchfork"
    assert run_json(capsys, "secant", "t, t^3, t^4", "--source", "t")["frenet"] is None
    shown = run(capsys, "secant", "3*cos(t), 3*sin(t), 4*t", "--source", "t")
    assert "κ = 3/25, τ = 4/25" in shown and "fold (x, y^2)" in shown
    assert "Proposition 1.4.5 says nothing" in run(capsys, "secant", "t, t^3, t^4", "--source", "t")


def test_frenet_data_are_those_of_the_curve():
    """At another point, in numbers, against the curve's own invariants."""
    curve = osc.curve("t, t^2, t^3 + t^5")
    found, values = osc.secant("t, t^2, t^3 + t^5", "t", at="1/2").frenet(), curve.at("1/2", 30)
    for name in ("curvature", "torsion", "curvature_slope", "torsion_slope"):
        text = str(getattr(found, name))
        assert (
            abs(
                sympy.N(sympy.sympify(text, rational=True), 30)
                - sympy.Float(mpmath.nstr(values[name], 28), 28)
            )
            < 1e-20
        )


def test_two_points(capsys):
    data = run_json(capsys, "secant", TANGENT, "--source", "t", "--at", "1", "--to", "0")
    assert (data["kind"], data["version"], data["at"], data["to"]) == ("secant apart", 1, ["1"], ["0"])
    assert data["versality"]["versal"] and data["versality"]["missing"] == []
    assert data["bigerm"]["extended_codimension"] == "infinite" and len(data["bigerm"]["branches"]) == 2
    staying = ["t - 2*t^4, t^2 - t^4, t^3*(1 - t)^2", "--source", "t", "--at", "1", "--to", "0"]
    shown = run(capsys, "secant", *staying)
    assert re.search(r"^versal +no: the parameters account for 0$", shown, re.MULTILINE)
    assert re.search(r"^missing terms +\(0, t\)$", shown, re.MULTILINE)
    # the point is the origin where none is given
    assert run_json(capsys, "secant", "t, t^2", "--source", "t", "--to", "1")["at"] == ["0"]
    # a plane curve on both sides of its bitangent: Morse functions with one value
    bitangent = osc.secant_apart("t, (t^2 - 1)^2", "t", at=-1, to=1)
    assert bitangent.bigerm_codimension() == bitangent.bigerm.codimension(extended=True) == 1
    # a germ that nothing unfolds versally
    flat = run_json(
        capsys, "secant", "t, (t - 1)^2*t^2, 0*t", "--source", "t", "--to", "1", "--patience", "1"
    )
    assert flat["versality"] is None and "no versal unfolding" in flat["reason"]["versality"]


def test_variables_called_like_the_boundary(capsys):
    data = run_json(capsys, "secant", "u, v, u*v", "--source", "u v", "--direction", "0,1")
    assert data["source"] == ["u", "v"] and data["germ"]["source"] == ["p1", "p2", "u", "v"]
    assert data["projection"]["boundary"] is None and data["projection"]["group"] == "A"
    apart = run_json(capsys, "secant", "u, v, u*v", "--source", "u v", "--to", "0,1")
    assert apart["source"] == ["u", "v"] and apart["germ"]["source"] == ["p1", "p2", "q1", "q2"]
    assert apart["germ"]["boundary"] is None and apart["parameters"] == ["p1", "p2"]


def test_jets_that_do_not_settle_the_germ(capsys):
    data = run_json(capsys, "secant", "t, t^2, sin(t)^4*(1 + t)", "--source", "t", "--order", "1")
    assert (data["order"], data["settled"], data["germ"]["codimension"]) == (1, False, None)
    assert data["germ"]["reason"]["codimension"].startswith("Jets of order 1 do not determine the germ")
    assert data["germ"]["even"]["variable"] == "lam"
    arc = run_json(capsys, "secant", "t, t^2, sin(t)^3", "--source", "t", "--variety")
    assert (arc["settled"], arc["germ"]["codimension"], arc["variety"]["codimension"]) == (True, 0, None)
    assert arc["variety"]["reason"]["stable"].startswith("Jets of order 2 alone are known of the variety's")
    shown = run(capsys, "secant", "x, y, exp(x*y) - 1", "--source", "x y", "--direction", "1,0")
    assert re.search(r"^  known by +jets of order 2$", shown, re.MULTILINE)


def test_points_and_directions_in_python(tmp_path):
    surface = tmp_path / "surface.txt"
    surface.write_text("x, y, x^3 + x*y^2", encoding="utf-8")
    for at, direction in (
        ((0, 0), (1, 0)),
        (["0", Fraction(0)], sympy.Matrix([2, 0])),
        ("0, 0", "sqrt(2), 0"),
    ):
        found = osc.secant(surface, "x y", at=at, direction=direction)
        assert found.germ.codimension("A(H)") == 2 and found.germ.group().name == "A(H)"
        assert found.projection.codimension("A") == 3 and found.linked() == 3
    assert osc.secant("x, y, x*y", "x y", at="1, 2", direction="1, 3").frames == (
        [["1", "0"], ["3", "1"]],
        [["1", "0", "0"], ["-3", "1", "0"], ["-2", "-1", "1"]],
    )
    assert repr(osc.secant("t, t^2", "t")) == "<Secant t in t u>"
    assert osc.secant("t, t^2", "t").even.components == ("t",)
    assert repr(osc.secant_apart("x, y, x*y", "x y", (0, 0), (1, 0))).startswith("<SecantApart (y - py)/")


def test_orders_that_are_none():
    for order in (2.0, "2", True):
        with pytest.raises(osc.DomainError, match="is no whole number"):
            osc.secant("t, t^2", "t", order=order)


SURFACE = ["secant", "x, y, x*y", "--source", "x y"]
MISTAKES = {
    "no source": (["secant", "x, y"], "The source variables are missing"),
    "no direction": (SURFACE, "--direction: the direction is missing: give one in the source, such as 1, 0."),
    "direction 0": ([*SURFACE, "--direction", "0,0"], "--direction: the direction is 0"),
    "short direction": ([*SURFACE, "--direction", "1"], "--direction: 1 coordinate for 2 source variables"),
    "long point": (
        [*SURFACE, "--at", "1,2,3", "--direction", "1,0"],
        "--at: 3 coordinates for 2 source variables",
    ),
    "no immersion": (
        ["secant", "x^2, y, x*y", "--source", "x y", "--direction", "1,0"],
        "no immersion at (0, 0): its derivative has rank 1",
    ),
    "does not occur": (
        ["secant", "x, x^2, x^3", "--source", "x y", "--direction", "1,0"],
        "The source variable y does not occur in the immersion",
    ),
    "unknown variable": (["secant", "x, z", "--source", "x"], "The name 'z' is unknown"),
    "off the domain": (["secant", "x, log(x)", "--source", "x"], "--at: log(x) is not analytic at (0)"),
    "a pole": (["secant", "x, 1/x", "--source", "x", "--at", "0"], "--at: 1/x is not analytic at (0)"),
    "transcendental": (
        ["secant", "x, exp(x)", "--source", "x", "--at", "1"],
        "irrational Taylor coefficient",
    ),
    "a line": (["secant", "x", "--source", "x"], "map to the line"),
    "no number": ([*SURFACE, "--direction", "x,1"], "The name 'x' is unknown"),
    "order 0": (["secant", "x, x^2", "--source", "x", "--order", "0"], "--order: jets of order 1 to"),
    "order x": (["secant", "x, x^2", "--source", "x", "--order", "x"], "--order needs a whole number"),
    "two questions": ([*SURFACE, "--to", "1,0", "--direction", "1,0"], "leave out --direction"),
    "same image": (
        ["secant", "x^2 - 1, x^3 - x", "--source", "x", "--at", "1", "--to", "-1"],
        "--to: both points",
    ),
    "same point": (
        ["secant", "x, x^2", "--source", "x", "--to", "0"],
        "--to: both points have the same image",
    ),
    "patience": (
        ["secant", "x, x^2", "--source", "x", "--patience", "-1"],
        "--patience: -1.0 is no positive",
    ),
    "no file": (["secant", "@no such file", "--source", "x"], "no such file cannot be read"),
    "no name": (["secant", "@", "--source", "x"], "The name of the file is missing after @"),
    "evil": (["secant", "__import__('os')", "--source", "x"], "has no meaning in a formula"),
    "odd": (
        ["germ", "x, x*lam", "--source", "x lam", "--even", "lam"],
        "--even: component 2 of the germ has the",
    ),
    "even of what": (
        ["germ", "x, x^2", "--source", "x", "--even", "y"],
        "--even: 'y' is not a source variable",
    ),
    "even sine": (
        ["germ", "x, cos(l) - 1", "--source", "x l", "--even", "l"],
        "--even: a germ even in l must be",
    ),
    "two boundaries": (
        ["germ", "x, l^2", "--source", "x l", "--even", "l", "--boundary", "x"],
        "--even: a germ even in l gets its own boundary",
    ),
    "off the axis": (
        ["germ", "x, l^2", "--source", "x l", "--even", "l", "--at", "0,1"],
        "--at: a germ even in l is one at l = 0",
    ),
    "even family": (
        ["germ", "a*x, l^2", "--source", "x l", "--even", "l", "--parameters", "a"],
        "A family (--parameters) has no answer to --even",
    ),
    "even branches": (
        ["germ", "x, l^2; x, l^4", "--source", "x l", "--even", "l"],
        "A multigerm (branches between semicolons) has no answer to --even",
    ),
    "even and preserving": (
        ["germ", "x + l^2", "--source", "x l", "--even", "l", "--preserving", "x"],
        "The group of a hypersurface (--preserving) has no answer to --even",
    ),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_is_one_sentence(name, capsys):
    arguments, sentence = MISTAKES[name]
    assert main(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and sentence in captured.err and captured.err.startswith("osculant: ")
    if name not in {"no number", "unknown variable", "evil"}:  # which show the place in the text
        assert captured.err.count("\n") == 1


@pytest.mark.parametrize("given", [(0.5, 0), "x, 0", (True, 0), (sympy.Float(1), 0), (sympy.Symbol("x"), 0)])
def test_coordinates_that_are_not_exact(given):
    with pytest.raises(osc.OsculantError):
        osc.secant("x, y, x*y", "x y", at=given, direction=(1, 0))


def test_an_even_germ(capsys, tmp_path):
    arguments = ["germ", "x, x*lam^2+lam^4", "--source", "x lam", "--even", "lam"]
    shown = run(capsys, *arguments)
    assert shown.startswith(
        "germ                  x, x*u + u**2\nsource                x u, boundary u = 0\n"
    )
    assert "as an even germ       x, x*lam**2 + lam**4, with u = lam**2\n" in shown
    assert "group                 A(H), as A^Z2 of germs even in lam\n" in shown
    data = run_json(capsys, *arguments)
    assert data["even"]["variable"] == "lam" and data["group"] == "A(H)"
    assert (data["codimension"], data["determinacy"], data["stable"]) == (1, 2, True)
    file = tmp_path / "even.json"
    file.write_text(run(capsys, *arguments, "--certificate", "--json"), encoding="utf-8")
    assert "is 2-determined for A(H)" in run(capsys, "check", str(file))
    unfolded = run(capsys, "germ", "x, x*l^2 + l^6", "--source", "x l", "--even", "l", "--group", "A")
    assert "  even                t1, x + t1*l**2, x*l**2 + l**6\n" in unfolded
    transversal = run_json(capsys, *arguments, "--transversal", "1")
    assert transversal["even"]["group"] == "A^Z2"
    assert run_json(capsys, "germ", "x^2 + l^4", "--source", "x l", "--even", "l")["even"]["group"] == "R^Z2"
    contact = osc.germ("x^2 + l^6", "x l", even="l")
    assert contact.group("K").name == "K(H)" and contact.codimension("K", extended=True) == 3
    moved = osc.germ("x - 1, l^2", "x l", at=(1, 0), even="l")
    assert (moved.at, moved.components) == (("1", "0"), ("x", "u"))


def test_other_groups_of_germs_that_are_not_even_stay():
    assert osc.germ("x, u", "x u").group("A").name == "A"
    assert osc.germ("x, l^2", "x l", even="l").group("A").name == "A(H)"
    assert osc.germ("x, l^2", "x l", even="l").group("L").name == "L"
