"""Multigerms, families and invariants at the front door and on the command line."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

import osculant as osc
from osculant.cli.main import app


def run(*arguments: str) -> str:
    found = CliRunner().invoke(app, ["germ", *arguments], catch_exceptions=False)
    assert found.exit_code == 0, found.output
    return found.output


def refused(*arguments: str) -> str:
    with pytest.raises(osc.OsculantError) as caught:
        CliRunner().invoke(app, ["germ", *arguments], catch_exceptions=False, standalone_mode=False)
    return str(caught.value)


def test_invariants() -> None:
    germ = osc.germ("x, y^2, y^3 + x^3*y", "x y")
    assert germ.invariants()["cross_caps"] == 3
    text = run("x, y^2, y^3 + x^3*y", "--source", "x y", "--invariants")
    assert "cross-caps            3\n" in text
    assert "μ of image            2\n" in text
    data = json.loads(run("x, x*y + y^4", "--source", "x y", "--invariants", "--json"))
    assert data["invariants"]["double_folds"] == data["invariants"]["discriminant_milnor"] == 1
    assert "none for these dimensions" in run("x^2 + y^2", "--source", "x y", "--invariants")
    covered = osc.germ("t^2, t^4", "t").invariants()
    assert covered["delta"] == "infinite"
    assert covered["semigroup"] is None
    assert "semigroup" in covered["reason"]
    assert covered["undecided"] == []


def test_multigerms() -> None:
    planes = osc.multigerm("x, y, 0; x, 0, y; x, y, y + x^2", "x y")
    assert planes.codimension(extended=True) == 1
    assert not planes.is_stable()
    text = run("x, y, 0; x, y, x^2 + y^2", "--source", "x y")
    assert "branch 2              x, y, x**2 + y**2\n" in text
    assert "extended codimension  1\n" in text
    data = json.loads(run("t, 0; 0, t; t, t", "--source", "t", "--json"))
    assert (data["delta"], data["image_milnor"], data["extended_codimension"]) == (3, 1, 1)
    infinite = json.loads(run("x, y, 0; x, y, 0", "--source", "x y", "--json"))
    assert infinite["codimension"] == infinite["determinacy"] == "infinite"


def test_multigerm_of_a_file(tmp_path: Path) -> None:
    file = tmp_path / "germ.txt"
    file.write_text("t, 0;\n0, t\n")
    assert "stable                yes" in run(f"@{file}", "--source", "t")


def test_families() -> None:
    text = run("x, x*y + y^3, x*y^2 + c*y^4", "--source", "x y", "--parameters", "c")
    for value in ("0", "1/2", "1", "3/2"):
        assert f"  where c = {value}" in text
    data = json.loads(run("x^3 + a*x*y^2 + b*y^3", "--source", "x y", "--parameters", "a b", "--json"))
    (curve, _) = data["extended_exceptional"]
    assert (curve["conditions"], curve["codimension"]) == (["4*a**3 + 27*b**2"], "infinite")
    found = osc.germ_family(["a*x^2 + b*x^3"], "x", "a b").report()["exceptional"]
    assert [stratum["values"] for stratum in found] == [{"a": "0"}, {"a": "0", "b": "0"}]
    assert "no real values" in run("x^3 + (a^2 + 1)*x^2", "--source", "x", "--parameters", "a")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("t, 0; ;t, t", "--source", "t"), "Branch 2 of the multigerm is empty"),
        (("t, 0; t", "--source", "t"), "one source and one target"),
        (("t, 0; 0, t", "--source", "t", "--at", "1"), "--at"),
        (("t, 0; 0, t", "--source", "t", "--group", "K"), "--group"),
        (("x + a", "--source", "x", "--parameters", "a"), "not 0 at the origin"),
        (("x^2*a", "--source", "x a", "--parameters", "a"), "source variable and a parameter"),
        (("a*x^2", "--source", "x", "--parameters", "a", "--latex"), "--latex"),
        (("a*x^2", "--source", "x", "--parameters", " "), "needs a parameter"),
        (("sin(a*x)", "--source", "x", "--parameters", "a"), "not a polynomial"),
    ],
)
def test_bad_input(arguments: tuple, words: str) -> None:
    assert words in refused(*arguments)


def test_hypersurfaces() -> None:
    group = osc.preserving("x^3 - y^2", "x y")
    assert osc.germ("x + y", "x y").codimension(group, extended=True) == 1
    text = run("y - z", "--source", "x y z", "--preserving", "z^2 - x^2*y", "--group", "K")
    assert "group                 K(V)\n" in text
    assert "extended codimension  2\n" in text
    words = "does not contain the origin"
    assert words in refused("x", "--source", "x y", "--preserving", "x + 1")
    assert "choose R, K or A" in refused("x", "--source", "x y", "--preserving", "x", "--group", "L")
    assert "--certificate" in refused("x", "--source", "x y", "--preserving", "x", "--certificate")


def test_equations() -> None:
    found = osc.germ("x, x*y + y^3", "x y").invariants()
    assert found["equation"] == "4*y1**3 + 27*y2**2"
    assert len(found["liftable"]) == 2
    text = run("x, x*y + y^3", "--source", "x y", "--invariants")
    assert "liftable fields       9*y2, -2*y1**2\n                      2*y1, 3*y2\n" in text


def test_bad_patience() -> None:
    for make in (
        lambda: osc.multigerm("t, 0; 0, t", "t", patience=0),
        lambda: osc.germ_family("a*x", "x", "a", patience=-1),
        lambda: osc.preserving("x*y", "x y", patience=0),
    ):
        with pytest.raises(osc.DomainError, match="patience"):
            make()
