"""The library's sentences name its arguments, those of the command line its options."""

from __future__ import annotations

import os
import pickle
import re
from pathlib import Path

import pytest
import typer

import osculant as osc
from osculant.cas.errors import DomainError, FormulaError, OsculantError
from osculant.cli.main import app, main
from osculant.cli.options import NAMES

FOLDER = Path(osc.__file__).parent
#: has a command line of its own
OWN = FOLDER / "codegen" / "generate.py"
SPIRAL = ["approximate", "t*cos(t), t*sin(t)"]


def test_lower_floors_never_speak_of_options():
    walk = os.walk(FOLDER, followlinks=True)
    paths = [Path(folder, name) for folder, _, names in walk for name in names if name.endswith(".py")]
    lower = [path for path in paths if FOLDER / "cli" not in path.parents and path != OWN]
    assert len(lower) > 200
    option = re.compile(r"(?<![-\w])--[a-z]")
    assert [path for path in lower if option.search(path.read_text(encoding="utf-8"))] == []


def test_every_name_is_translated_into_one_that_there_is():
    commands = typer.main.get_command(app).commands.values()
    options = {name for command in commands for option in command.params for name in option.opts}
    assert {word for name in NAMES.values() for word in re.findall(r"--[\w-]+", name)} <= options


@pytest.mark.parametrize(
    ("call", "said", "command", "told"),
    [
        (
            lambda: osc.curve("t, t^2", "1/x", 1),
            "low: The name 'x'",
            [*SPIRAL, "--from", "1/x", "--to", "1"],
            "--from: The name 'x'",
        ),
        (
            lambda: osc.curve("t, t^2", 0, "1/0"),
            "high",
            [*SPIRAL, "--from", "0", "--to", "1/0"],
            "--to",
        ),
        (
            lambda: osc.curve("t, t^2").at("x"),
            "t: The name 'x'",
            ["invariants", "t, t^2", "--at", "x"],
            "--at: The name 'x'",
        ),
        (
            lambda: osc.curve("t, t^2, t^3").at("x"),
            "t: The name 'x'",
            ["invariants", "t, t^2, t^3", "--at", "x"],
            "--at: The name 'x'",
        ),
        (
            lambda: osc.approximate(osc.curve("t, t^2", 0, 1), split_at="x"),
            "split_at: The name 'x'",
            ["approximate", "t, t^2", "--from", "0", "--to", "1", "--split-at", "x"],
            "--split-at: The name 'x'",
        ),
        (
            lambda: osc.verify("Riemann"),
            "No claim is called 'Riemann': osculant.cas.claims.all_claims() shows the names.",
            ["verify", "Riemann"],
            "No claim is called 'Riemann': `osculant verify --list` shows the names.",
        ),
    ],
    ids=["low", "high", "t", "t in space", "split_at", "claims"],
)
def test_a_sentence_and_its_translation(call, said, command, told, capsys):
    with pytest.raises(OsculantError) as caught:
        call()
    assert str(caught.value).startswith(said)
    assert main(command) == 2
    assert capsys.readouterr().err.startswith(f"osculant: {told}")


def test_errors_are_ordinary_exceptions():
    error = pickle.loads(pickle.dumps(FormulaError("low is 1/0.", argument="low")))
    assert (str(error), error.told({"low": "--from"})) == ("low is 1/0.", "--from is 1/0.")
    plain = DomainError("The curve is no curve.")
    assert plain.told(NAMES) == str(plain) and plain.args == ("The curve is no curve.",)
