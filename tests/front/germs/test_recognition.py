"""Germs by name at the front door and on the command line."""

from __future__ import annotations

import json
from fractions import Fraction

import pytest

import osculant as osc
from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.reference import NAMES, reference
from osculant.cas.recognition.recognise import recognise
from osculant.certificates.checker import check
from osculant.cli.main import main
from tests.cas.recognition.test_keys import changed
from tests.cas.recognition.test_recognise import ROWS

GERM_KEYS = {"version", "source", "target", "components", "boundary", "group"}
ROW_KEYS = {
    "name",
    "complex",
    "table",
    "id",
    "integers",
    "normal_form",
    "variables",
    "signs",
    "moduli",
    "estimates",
    "real_field",
}
OTHER_KEYS = {"lists", "codimension", "determinacy", "proof", "key", "reason", "undecided", "alike", "unused"}
KEYS = GERM_KEYS | ROW_KEYS | OTHER_KEYS


def answer(capsys, *arguments):
    """What the command prints."""
    assert main(["recognise", *arguments]) == 0
    return capsys.readouterr().out


def told(capsys, *arguments):
    """What it prints as JSON."""
    return json.loads(answer(capsys, *arguments, "--json"))


def test_a_name_with_all_that_belongs_to_it(capsys):
    found = told(capsys, "x, y^2 + x*y, y^3 - 2*x^2*y + x^4", "--source", "x y")
    assert set(found) == KEYS and found["version"] == 1
    assert (found["name"], found["complex"], found["table"], found["id"]) == ("S1-", "S1", "mond", "S_k")
    assert found["integers"] == {"k": 1} and found["signs"] == {"x**2*y": -1} and found["moduli"] == {}
    assert found["normal_form"] == ["x", "y**2", "y**3 - x**2*y"] and found["variables"] == ["x", "y"]
    assert (found["codimension"], found["determinacy"], found["proof"]) == (3, 3, "equivalence")
    assert (found["reason"], found["undecided"], found["alike"]) == (None, False, [])
    f = osc.germ("x, y^2 + x*y, y^3 - 2*x^2*y + x^4", "x y")
    assert f.recognise().told() == found and f.codimension("A") == 3
    assert f.recognise("K").name is None  # no list for K of maps from the plane to space


def test_none_of_the_lists_and_undecided_are_told_apart(capsys):
    none = told(capsys, "x^5 + y^5", "--source", "x y")
    assert set(none) == KEYS and none["codimension"] == osc.germ("x^5 + y^5", "x y").codimension("R")
    assert (none["name"], none["proof"], none["undecided"], none["id"]) == (None, None, False, None)
    assert none["reason"] and none["key"]["orbit"][:5] == [1, 3, 6, 10, 13]
    unclear = told(capsys, "x, y^2, y^3 + sqrt(2)*x^2*y", "--source", "x y")
    assert (unclear["name"], unclear["undecided"], unclear["alike"]) == (None, True, ["S1"])
    by_key = told(capsys, "x^3 + sqrt(2)*x*y^2", "--source", "x y")
    assert (by_key["name"], by_key["proof"], by_key["signs"], by_key["moduli"]) == ("D4", "key", None, None)
    assert "undecided: " in answer(capsys, "x, y^2, y^3 + sqrt(2)*x^2*y", "--source", "x y")
    assert "signs and moduli are not known" in answer(capsys, "x^3 + sqrt(2)*x*y^2", "--source", "x y")


def test_options(capsys, tmp_path):
    at = told(capsys, "x, y^4 - 2*y^3 + x*y", "--source", "x y", "--at", "0,0")
    assert at["at"] == ["0", "0"] and at["name"] == "3"
    file = tmp_path / "germ.txt"
    file.write_text("x1, x2, u + x3^2", encoding="utf-8")
    assert told(capsys, f"@{file}", "--source", "x1 x2 x3 u")["name"] == "3b+"
    named = told(capsys, "x^3 - y^2*x + z", "--source", "x y z", "--boundary", "z")
    assert (named["name"], named["group"], named["boundary"]) == ("D4", "R(H)", "z")
    assert told(capsys, "x^2 + y^3", "--source", "x y", "--group", "K")["group"] == "K"
    assert told(capsys, "x^2 + y^3 + a*y^4", "--source", "x y", "--root", "a^2 - 2")["name"] == "A2"
    unused = told(capsys, "x1, x2", "--source", "x1 x2 x3 u")
    assert (unused["name"], unused["unused"]) == ("2a", ["x3", "u"])
    assert "unused variables      x3 u" in answer(capsys, "x1, x2", "--source", "x1 x2 x3 u")
    even = told(capsys, "v, x, lam^4 + v*lam^2 - y^2", "--source", "x y lam v", "--even", "lam")
    assert (even["name"], even["group"], even["even"]["variable"]) == ("3d-", "A(H)", "lam")
    slow = told(capsys, "x, y^2, x^4*y + y^7 + x^2*y^5", "--source", "x y", "--patience", "0.001")
    assert slow["undecided"] and slow["name"] is None


def test_an_equivalence_and_its_certificate(capsys):
    germ = ("x, y^3 - 3*x^2*y + x*y^2", "--source", "x y")
    changes = told(capsys, *germ, "--equivalence")["equivalence"]
    assert changes["phi"] == ["x", "(-1/3)*x + y"] and changes["kind"] == "equivalence"
    shown = answer(capsys, *germ, "--equivalence")
    assert "y = (-1/3)*x + y" in shown and "scales of the source  (3/10)**(1/2), 1" in shown
    certificate = json.loads(answer(capsys, *germ, "--certificate"))
    sentences = list(check(certificate))
    assert "are A-equivalent over the real numbers." in sentences[-1]
    certificate["phi"][1] = "y"
    with pytest.raises(osc.RejectedError):
        list(check(certificate))
    contact = answer(capsys, "x^2 + y^3, x*y^2 + y^4", "--source", "x y", "--group", "K", "--equivalence")
    assert "matrix" in contact
    with pytest.raises(DomainError, match="There is no equivalence to certify: Its codimension is infinite"):
        osc.recognise("x, y^3", "x y").certificate()


def test_a_tolerance_gives_the_name_with_its_margin_or_leaves_it_undecided(capsys):
    third = ("x, y^2, 0.3333333333*y^3 - 0.1428571429*x^2*y", "--source", "x y")
    found = told(capsys, *third, "--tolerance", "1e-8")
    assert set(found) == KEYS | {"tolerance", "nearby", "margin"} and found["tolerance"] == 1e-8
    assert (found["name"], found["nearby"][2]) == ("S1-", "1/3*y**3 - 1/7*(x**2*y)")
    kept, dropped, noise = (found["margin"][key] for key in ("kept", "dropped", "noise"))
    assert kept > 0.01 > 1e-6 > noise > 1e-9 and dropped < 1e-12
    assert "singular values from" in answer(capsys, *third, "--tolerance", "1e-8")
    # within a coarser tolerance the term of x^2*y may not be there, nor its sign be known
    for text, width in ((third[0], "0.2"), ("x, y^2, y^3 - 0.00000001*x^2*y + x^3*y", "1e-9")):
        found = told(capsys, text, *third[1:], "--tolerance", width)
        assert (found["name"], found["undecided"]) != ("S1-", False) and found["name"] != "S1+"
    assert osc.recognise("x^3 + 0.2*y^4", "x y", tolerance=1e-3).name == "E6+"
    assert osc.recognise("x, x*y + y^4", "x y", tolerance=1e-9).name == "5"  # whole numbers are exact
    none = osc.recognise("0.3333*x^5 + y^5", "x y", tolerance=1e-3)
    assert (none.name, none.undecided) == (None, True)
    with pytest.raises(DomainError, match=r"tolerance: -1\.0 is no positive number"):
        osc.recognise("x^2", "x", tolerance=-1.0)
    with pytest.raises(DomainError, match="roots of numbers, which are exact"):
        osc.recognise("sqrt(2)*x^2 + x^3", "x", tolerance=1e-3)


@pytest.mark.parametrize(("entry", "signs", "values"), [row.values for row in ROWS[::23]])
def test_rounded_coefficients_give_the_right_name_or_none(entry, signs, values):
    germ, order = entry.germ(signs, **values), entry.value("determinacy", **values)
    dense = changed(germ, entry.group, order, 3 + order)
    rounded = [
        {poly.exponents_of(m, germ.n): Fraction(f"{float(c):.10g}") for m, c in f.items()}
        for f in dense.jet(order)
    ]
    given = osc.germ(rounded, germ.source, germ.boundary)
    found = given.recognise(entry.group, tolerance=1e-8)
    assert found.undecided or found.name == osc.MapGerm(germ).recognise(entry.group).name
    assert found.margin is not None and found.margin.safe != found.undecided


@pytest.mark.parametrize("name", NAMES)
def test_lists_are_shown(capsys, name):
    found = told(capsys, "--list", name.upper())
    entries = reference(name).entries
    assert [row["id"] for row in found["rows"]] == [entry.id for entry in entries]
    assert found["version"] == 1 and found["source"] == reference(name).source
    shown = answer(capsys, "--list", name)
    assert found["title"] in shown and found["source"] in shown
    for row in found["rows"]:
        assert ", ".join(row["normal_form"]) in shown and row["codimension"] in shown


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ([], "The germ is missing: give its components"),
        (["x, y^2"], "The source variables are missing"),
        (["x, y^2", "--source", "x y", "--group", "A(H)"], "An (H) group needs the boundary variable u"),
        (
            ["x, y^2", "--source", "x y", "--boundary", "w"],
            "The boundary variable 'w' is not a source variable",
        ),
        (["x, y^2 + z", "--source", "x y"], "The name 'z' is unknown"),
        (["x, y^2", "--source", "x y", "--group", "Q"], "There is no group 'Q'"),
        (["x, y^2 + 1", "--source", "x y"], "Component 2 of the germ is 1 at the origin, not 0"),
        (["x, y^2", "--source", "x y", "--at", "1"], "--at"),
        (
            ["x, y^2", "--source", "x y", "--patience", "0"],
            "--patience: 0.0 is no positive number of seconds",
        ),
        (["@", "--source", "x y"], "The name of the file is missing after @"),
        (["--list", "moond"], "There is no reference list 'moond'"),
        (["--list", "mond", "--source", "x"], "A list (--list) has no answer to --source"),
        (["x, y^2", "--source", "x y", "--tolerance", "0"], "--tolerance: 0.0 is no positive number"),
        (["x, y^3", "--source", "x y", "--certificate"], "There is no equivalence to certify"),
    ],
)
def test_mistakes_are_one_sentence(capsys, arguments, sentence):
    assert main(["recognise", *arguments]) == 2
    told = capsys.readouterr()
    assert told.out == "" and sentence in told.err


def test_errors_from_python():
    with pytest.raises(FormulaError, match="unknown"):
        osc.recognise("x + w", "x y")
    with pytest.raises(DomainError, match="needs the boundary variable"):
        osc.recognise("x^2", "x", group="R(H)")


@pytest.mark.parametrize(
    ("text", "name", "over"),
    [
        ("x^4 + 5*x^2*y^2 - y^4", "X9+-(5)", "X9(a)"),  # over ℂ a = ±5i
        ("x^4 + 2*x^2*y^2 - y^4", "X9+-(2)", "X9(a)"),  # degenerate for x^4 + y^4 alone
        ("x^3 + 2*x^2*y^2 - x*y^4", "J10-(2)", "J10(a)"),
        ("x^2*y^2 + x^6 - 7*y^6", "Y6,6++(-7)", "Y6,6(-7)"),
        ("x^2*y^2 - 7*x^6 + y^6", "Y6,6++(-7)", "Y6,6(-7)"),
        ("x^2*y^2 + 3*x^8 - 2*y^8", "Y8,8++(-6)", "Y8,8(-6)"),
        ("x^3 - y^8 + 3*x*y^6", "E14-(3)", "E14(a)"),
    ],
)
def test_moduli_are_those_of_the_class(text, name, over):
    found = osc.recognise(text, "x y")
    assert (found.name, found.complex) == (name, over)
    assert recognise(changed(osc.germ(text, "x y").exact, "R", 8, 1), "R").name == name


def test_numbers_in_moduli_are_defined():
    told = osc.recognise("x^4 + x^3*y + x^2*y^2 + x*y^3 + y^4", "x y").told()
    assert told["estimates"]["a"] == pytest.approx(2 * 5**0.5 - 4, rel=1e-12)
    field = told["real_field"]
    assert field["name"] in told["moduli"]["a"]
    root = field["near"]
    assert abs(sum(c * root**i for i, c in enumerate((1, 6, 6, 6, 1)))) < 1e-10


def test_an_even_variable_may_be_called_u():
    assert osc.germ("x, x*u^2 + u^4", "x u", even="u").recognise().germ.components == ("x", "x*u + u**2")
