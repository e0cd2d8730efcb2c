"""The command ``osculant compile``."""

import json

import pytest

from osculant.cli.main import main
from tests.front.compiled.fixed import needs_cc


@needs_cc
def test_a_curve_is_compiled(tmp_path, capsys):
    folder = str(tmp_path / "out")
    command = ["compile", "t, sin(t)", "--from", "1", "--to", "4", "--with", "conic", "--out", folder]
    assert main([*command, "--name", "sine", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["name"] == "sine" and told["version"] == 1
    assert told["splits"] == [1.5707963267948966, 3.141592653589793]
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == told["files"]
    assert set(told["files"]) == {"libsine.so", "sine.c", "sine.h", "sine.hpp", "sine_example.c"}
    assert main(command) == 0
    assert "split at  1.5707963267949, 3.14159265358979" in capsys.readouterr().out


@needs_cc
def test_invariants_and_jets_are_compiled(tmp_path, capsys):
    folder = str(tmp_path)
    assert main(["compile", "-t, t^2", "--what", "invariants", "--out", folder, "--language", "python"]) == 0
    assert (tmp_path / "curve.py").exists()
    assert main(["compile", "--jet", "space", "--out", folder, "--name", "own"]) == 0
    assert "own_jet evaluate" in (tmp_path / "own.h").read_text()


BAD = [
    (["t, t^2"], "--out"),
    (["t, t^2", "--out", "x", "--what", "areas"], "--what areas"),
    (["t, t^2", "--out", "x", "--jet", "4d"], "--jet"),
    (["t, t^2", "--out", "x", "--what", "distance", "--with", "conic"], "--with"),
    (["t, a*t", "--out", "x"], "'a' is unknown"),
    (["t, t^2", "--out", "x", "--from", "0"], "two ends"),
    (["t, t^2", "--out", "x", "--split-at", "1"], "--split-at is for a fixed curve, and here the interval"),
    (["t, a*t", "--out", "x", "--parameters", "a", "--split-at", "1"], "the values of a are"),
    (["--jet", "plane", "--out", "x", "--split-at", "1"], "the curve is known at run time"),
    (["t, t^2", "--out", "/dev/null"], "the folder /dev/null, as it is none"),
    (["t, t^2", "--out", "x", "--with", "best"], "a library is for all: choose one of conic, parabola"),
]


@pytest.mark.parametrize(("arguments", "says"), BAD)
def test_mistakes_are_one_sentence(tmp_path, monkeypatch, capsys, arguments, says):
    monkeypatch.chdir(tmp_path)
    assert main(["compile", *arguments]) == 2
    told = capsys.readouterr().err
    assert says in told and told.startswith("osculant: ")
    assert not list(tmp_path.iterdir())
