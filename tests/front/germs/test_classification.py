"""Classification at the front door and on the command line."""

from __future__ import annotations

import json
from xml.etree import ElementTree

import pytest

import osculant as osc
from osculant.cli.main import main


def test_answer_and_drawing(tmp_path):
    found = osc.classify(source=4, target=3, group="a(h)", codimension=2)
    assert [c.id for c in found.classes] == ["0.1", "1.1", "2.1", "2.2"]
    assert [c.determinacy for c in found.classes] == [1, 2, 3, 2]
    for c in found.classes:
        for form in c.real_forms:
            assert osc.germ(form, "x1 x2 x3 u").codimension("A(H)") == c.codimension
    found.draw(tmp_path / "tree.svg")
    texts = [e.text for e in ElementTree.parse(tmp_path / "tree.svg").iter() if e.tag.endswith("text")]
    assert len(texts) == len(found.tree()) + 1


#: (n, p, group, bound): the names that recognition, which has the lists, gives to the classes
NAMES = {
    (2, 1, "R", 8): "A1 A2 A3 A4 A5 A6 A7 D4 D5 D6 D7 E6 E7",
    (3, 1, "R", 8): "A1 A2 A3 A4 A5 A6 D4 D5 D6 E6",
    (2, 2, "A", 3): "2 3 4_2 5",
    (2, 3, "A", 4): "B2 H2 S0 S1 S2",
    (1, 2, "A", 5): "A2 A4 A6 A8 E6 E8",
    (1, 3, "A", 5): "2,3 2,5",
}


@pytest.mark.parametrize("asked", NAMES)
def test_recognition_names_every_class(asked):
    """All real forms of a class have its name, signs aside, and its codimension; each name comes once."""
    found, names = osc.classify(*asked), []
    source = " ".join(f"x{i + 1}" for i in range(found.source))
    for c in found.classes[1:]:
        told = [osc.recognise(", ".join(form), source) for form in c.real_forms]
        assert {t.codimension for t in told} == {c.codimension}
        met = {t.name.rstrip("+-") for t in told}
        assert len(met) == 1
        names += met
    assert sorted(names) == sorted(NAMES[asked].split())


def test_command(capsys, tmp_path):
    drawing = str(tmp_path / "tree.svg")
    asked = ["--source", "4", "--target", "6", "--group", "A(H)", "--codimension", "3", "--tree", drawing]
    assert main(["classify", *asked, "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert [(c["id"], c["codimension"]) for c in data["classes"]] == [("0.1", 0), ("3.1", 3)]
    assert data["adjacencies"] == [["3.1", "0.1"]]
    assert data["second_route"]["agrees"] is True
    assert {branch["kind"] for branch in data["tree"]} == {"branch", "class", "closed"}
    assert ElementTree.parse(drawing) is not None
    assert main(["classify", *asked]) == 0
    assert "complete and different over ℂ" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--source", "4"], "--target"),
        (["--source", "4", "--target", "3", "--codimension", "5"], "--codimension: 5 is out of reach"),
        (["--source", "9", "--target", "3", "--codimension", "1"], "--source: 9 variables are out of reach"),
        (["--source", "4", "--target", "3", "--group", "R(H)"], "--group: germs are not classified for R(H)"),
        (["--source", "4", "--target", "3", "--group", "Q"], "There is no group 'Q'"),
        (["--source", "4", "--target", "3", "--tree", "a.png"], "its suffix must be .svg"),
        (["--source", "four", "--target", "3"], "whole number"),
    ],
)
def test_refusals(arguments, told, capsys):
    assert main(["classify", *arguments]) == 2
    error = capsys.readouterr().err
    assert told in error
    assert error.count("\n") == 1
