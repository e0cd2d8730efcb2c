"""The command line: golden output, and one sentence for every mistake."""

from __future__ import annotations

import io
import json
import math
import os
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

import osculant
from osculant.cas.errors import OsculantError, UndecidedError
from osculant.cli import output as printing
from osculant.cli.grammar import UsageError, arrange
from osculant.cli.main import main
from osculant.cli.splines import print_spline
from osculant.files.registry import suffixes
from osculant.files.writing import listed
from osculant.kernels import jit
from tests.front.samples import circle, spline_of

DATA = Path(__file__).parents[2] / "data"
GOLDEN = sorted(DATA.glob("golden-*.json"))
SPIRAL = ["t*cos(t), t*sin(t)", "--from", "pi/6", "--to", "2*pi"]
CUBIC = ["approximate", "t, t^3", "--from", "0", "--to", "1"]

#: where a spline's knots lie is determined by errors in a window of relative width 1e-6, over and over
LOOSE = dict.fromkeys(("knots", "interval", "points", "middle", "weight"), 1e-5)
#: so that the last piece, which takes what is left, has its error to this part of the tolerance
ERROR = 1e-4


def assert_alike(got: object, golden: object, tolerance: float, relative: float = 1e-9) -> None:
    assert type(got) is type(golden)
    if isinstance(golden, dict):
        assert list(got) == list(golden)
        for key, value in golden.items():
            if key in {"error", "errors"}:
                flat = value if isinstance(value, list) else [value]
                mine = got[key] if isinstance(value, list) else [got[key]]
                assert mine == pytest.approx(flat, rel=0, abs=ERROR * tolerance)
            else:
                assert_alike(got[key], value, tolerance, max(relative, LOOSE.get(key, 0)))
    elif isinstance(golden, list):
        assert len(got) == len(golden)
        for one, other in zip(got, golden):
            assert_alike(one, other, tolerance, relative)
    elif isinstance(golden, float):
        assert got == pytest.approx(golden, rel=relative, abs=relative)
    else:
        assert got == golden


@pytest.mark.parametrize("path", GOLDEN, ids=lambda path: path.stem.removeprefix("golden-"))
def test_json_is_as_in_the_golden_file(path, capsys):
    golden = json.loads(path.read_text(encoding="utf-8"))
    assert main([*golden["command"], "--json"]) == 0
    output = capsys.readouterr()
    assert output.err == ""
    assert_alike(json.loads(output.out), golden["output"], golden["output"].get("tolerance", 1.0))


def test_there_are_golden_files():
    assert {path.stem.split("-")[1] for path in GOLDEN} == {
        "approximate",
        "complexity",
        "invariants",
        "tables",
    }


def interval(formula: str, low: str = "0", high: str = "1") -> list[str]:
    return ["approximate", formula, "--from", low, "--to", high]


#: what is wrong, the arguments, and what the sentence must say
MISTAKES = {
    "malformed formula": (interval("t*cos(t, t"), "cos takes one expression"),
    "empty formula": (interval(""), "empty"),
    "unknown name": (interval("q*t, t"), "'q'"),
    "unknown function": (interval("t, sine(t)"), "'sine'.*sin"),
    "one coordinate": (interval("t"), "two coordinates.* 1"),
    "four coordinates": (interval("t, t, t, t"), "two coordinates.* 4"),
    "conics in space": (
        [*interval("t, t^2, t^3"), "--with", "conic"],
        "in space is approximated with bihelix",
    ),
    "bihelices in the plane": ([*interval("t, t^2"), "--with", "bihelix"], "two coordinates"),
    "empty interval": (interval("t, t^2", "1", "1"), "from 1 to 1 is empty"),
    "reversed interval": (interval("t, t^2", "2*pi", "0"), r"from 2\*pi to 0 is empty or reversed"),
    "variable in the interval": (interval("t, t^2", "t", "2"), "'t'"),
    "infinite end": (interval("t, t^2", "0", "1/0"), "zero"),
    "pole": (interval("t, 1/(3*t-1)"), r"t = 0\.33333"),
    "pole of a function": (interval("t, tan(t)", "0", "2"), r"t = 1\.570796"),
    "undefined stretch": (interval("t, sqrt(t)", "-1", "1"), "t = -1"),
    "undefined end": (interval("t, log(t)"), "t = 0"),
    "no derivative": (interval("t, abs(t)", "-1", "1"), "t = 0"),
    "single point": (interval("1, 2"), "point"),
    "tolerance 0": ([*CUBIC, "--tolerance", "0"], "tolerance is 0"),
    "tolerance < 0": ([*CUBIC, "--tolerance", "-1e-6"], "tolerance is -1e-06"),
    "tolerance nan": ([*CUBIC, "--tolerance", "nan"], "tolerance is nan"),
    "tolerance inf": ([*CUBIC, "--tolerance", "inf"], "tolerance is inf"),
    "tolerance text": ([*CUBIC, "--tolerance", "fine"], "'fine' is not a number"),
    "tolerance tiny": ([*CUBIC, "--tolerance", "1e-15"], r"floor 2\.22e-13"),
    "floor far away": ([*interval("t+1e6, t^3"), "--tolerance", "1e-9"], r"floor 1\.16e-07"),
    "unknown primitive": ([*CUBIC, "--with", "quartic"], "'quartic' is unknown: choose one of parabola"),
    "split outside": ([*CUBIC, "--split-at", "2"], "split point 2 "),
    "split at the end": ([*CUBIC, "--split-at", "1"], "split point 1 "),
    "split no number": ([*CUBIC, "--split-at", "t/2"], "'t'"),
    "no interval": (CUBIC[:2], "--from and --to"),
    "no end": (CUBIC[:4], "give --to"),
    "no formula": (CUBIC[:1], "FORMULA"),
    "no command": (["aproximate"], "'aproximate': did you mean approximate"),
    "strange command": (
        ["t, t^2"],
        "choose one of approximate, cache, check, classify, compile, complexity, germ, invariants, "
        "recognise, secant, tables, verify",
    ),
    "option before": (["--verson"], "'--verson': did you mean --version"),
    "unknown option": ([*CUBIC, "--tolerence", "1"], "'--tolerence': did you mean --tolerance"),
    "short option": ([*CUBIC, "-x"], "'-x'"),
    "value missing": ([*CUBIC, "--tolerance"], "--tolerance needs a value"),
    "value forgotten": (["approximate", "t, t^2", "--from", "--to", "1"], "--from needs a value, but --to"),
    "value too much": ([*CUBIC, "--json=yes"], "--json takes no value"),
    "unquoted formula": (["approximate", "t,", "t^2", "--from", "0"], r"'t\^2' is one too many"),
    "minus without comma": (["approximate", "-t", "--from", "0", "--to", "1"], "two coordinates"),
    "table": (["tables", "2.7"], "'2.7' here: choose 3.1 or 3.2 or 3.3 or 3.4 or 4.1"),
    "digits": (["invariants", "t, t^2", "--at", "1", "--digits", "many"], "'many'"),
    "no digits": (["invariants", "t, t^2", "--at", "1", "--digits", "0"], "0 digits"),
    "digits of nothing": (["invariants", "t, t^2", "--digits", "9"], "--at"),
    "pole of an invariant": (["invariants", "t, 1/t", "--at", "0"], "t = 0"),
    "half an interval": (["invariants", "t, t^2", "--to", "0"], "both ends"),
    "complexity tolerance": (["complexity", *CUBIC[1:], "--tolerance", "-3"], "tolerance is -3"),
    "complexity pole": (["complexity", *interval("t, 1/t", "-1", "1")[1:]], "t = 0"),
    "complexity interval": (["complexity", "t, t^2"], "--from and --to"),
}


def assert_one_sentence(error: str, says: str) -> None:
    lines = error.splitlines()
    assert re.fullmatch(r"osculant: \S.*[.?]", lines[0])
    assert re.search(says, lines[0])
    assert not re.search(r"[a-z)'][.?] [A-Z]", lines[0])  # one sentence
    if len(lines) > 1:  # the formula with a caret under the place
        assert len(lines) == 3 and lines[2].strip() == "^"
    assert "Traceback" not in error and "Usage:" not in error


@pytest.mark.parametrize("arguments, says", MISTAKES.values(), ids=MISTAKES)
def test_a_mistake_is_one_sentence_and_status_2(arguments, says, capsys):
    assert main(arguments) == 2
    output = capsys.readouterr()
    assert output.out == ""
    assert_one_sentence(output.err, says)


#: what is wrong with an output in a folder that holds an empty "file" and the folder "folder.svg"
UNWRITABLE = {
    "suffix": (["--write", "a.step"], r"a\.step.*\.svg, \.json.* and \.dxf"),
    "no suffix": (["--write", "svg"], r"\.svg, \.json.* and \.dxf"),
    "conics as G-code": (["--with", "conic", "--write", "a.nc"], r"a\.nc.*conic.*biarc"),
    "no name": (["--write", ""], "without a name"),
    "folder": (["--write", "folder.svg"], r"folder\.svg: it is a folder"),
    "no folder": (["--write", "none/a.svg"], "there is no folder"),
    "below a file": (["--write", "file/a.svg"], "file is not a folder"),
    "second file": (["--write", "a.svg", "--write", "file/a.json"], "file is not a folder"),
    "picture suffix": (["--plot", "a.xyz"], r"a\.xyz.*\.pdf"),
    "picture place": (["--plot", "file/a.png"], "file is not a folder"),
}


@pytest.mark.parametrize("options, says", UNWRITABLE.values(), ids=UNWRITABLE)
def test_outputs_are_refused_before_the_work(options, says, tmp_path, capsys, monkeypatch):
    if "--plot" in options:
        pytest.importorskip("matplotlib")
    (tmp_path / "file").write_text("")
    (tmp_path / "folder.svg").mkdir()
    monkeypatch.chdir(tmp_path)
    for name in ("approximate_curve", "Spline"):  # what searches, under the checks of files
        where = "for_files" if name == "approximate_curve" else "approximate"
        monkeypatch.setattr(f"osculant.approximation.{where}.{name}", lambda *_, **__: pytest.fail("worked"))
    before = sorted(tmp_path.rglob("*"))
    assert main([*CUBIC, *options]) == 2
    output = capsys.readouterr()
    assert_one_sentence(output.err, says)
    assert output.out == "" and sorted(tmp_path.rglob("*")) == before


def test_the_folder_of_an_output_may_be_forbidden(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(os, "access", lambda *_: False)  # the superuser may write anywhere
    assert main([*CUBIC, "--write", str(tmp_path / "a.svg")]) == 2
    assert_one_sentence(capsys.readouterr().err, "nothing may be written in the folder")


def test_known_suffixes_are_those_of_the_spline(tmp_path, capsys):
    files = [tmp_path / f"spline{suffix}" for suffix in suffixes()]
    assert main([*CUBIC, "--with", "biarc", "--tolerance", "1e-3", "--write", *map(str, files)]) == 0
    assert all(file.stat().st_size for file in files)
    with pytest.raises(OsculantError, match=re.escape(listed(suffixes()))):
        spline_of([circle(0.0, 1.0)]).write("spline.xyz")


def test_several_files_are_written(tmp_path, capsys):
    picture, data = tmp_path / "a.svg", tmp_path / "b.json"
    assert main([*CUBIC, "--write", str(picture), "--write", str(data), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert [file["path"] for file in told.pop("files")] == [str(picture), str(data)]
    assert json.loads(data.read_text()) == told
    assert "osculant approximate 't, t^3' --from 0 --to 1 --write" in picture.read_text()


def test_a_failed_computation_leaves_nothing(tmp_path, capsys):
    target = tmp_path / "a.svg"
    assert main([*interval("t, 1/t", "-1", "1"), "--write", str(target)]) == 2
    assert list(tmp_path.iterdir()) == []


def test_a_plot_is_drawn(tmp_path, capsys):
    pytest.importorskip("matplotlib")
    assert main([*CUBIC, "--plot", str(tmp_path / "a.png")]) == 0
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    assert re.search(r"^written +\S+a\.png$", capsys.readouterr().out, re.MULTILINE)


def test_the_table_of_a_spline(capsys):
    assert main(["approximate", *SPIRAL, "--tolerance", "1e-6"]) == 0
    rows = dict(re.split(r"  +", line, maxsplit=1) for line in capsys.readouterr().out.splitlines())
    assert rows["pieces"] == "21" and rows["predicted"] == "20.1216, in whole pieces 21"
    assert rows["minimal"] == "by theory" and rows["split points"] == "none"
    assert 9.9e-7 < float(rows["error"].removesuffix(" (estimate)")) <= 1e-6
    assert rows["time"].endswith(" s") and "undecided" not in rows


def test_an_unknown_prediction_does_not_hide_the_spline(capsys):
    spline = osculant.approximate(osculant.curve("t, t^3", 0, 1), "conic", 1e-3)

    def unsettled() -> None:
        raise UndecidedError("The integral did not settle.")

    for given, name in (("tolerance", "predicted"), ("pieces", "predicted error")):
        print_spline(replace(spline, predict=unsettled, given=given), 0.1, ())
        unknown = rf"^{name} +unknown: the integral of the theory did not settle$"
        assert re.search(unknown, capsys.readouterr().out, re.MULTILINE)


def test_many_split_points_are_abridged(capsys):
    splits = [f"{n}/40" for n in range(1, 13)]
    assert main(["approximate", "t, exp(t)", "--from", "0", "--to", "1", "--split-at", *splits]) == 0
    assert "0.025, 0.05, 0.075, 0.1, 0.125, 0.15, 0.175, 0.2 and 4 more" in capsys.readouterr().out


def test_invariants_in_words_and_in_latex(capsys):
    assert main(["invariants", "4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)"]) == 0
    assert "kappa = 1/(3*cos(t/3)**2)\n" in capsys.readouterr().out
    assert main(["invariants", "2*cos(t), 2*sin(t)", "--latex"]) == 0
    assert r"\kappa = \frac{1}{2}" in capsys.readouterr().out.splitlines()


def test_values_of_invariants_to_many_digits(capsys):
    assert main(["invariants", "t, exp(t)", "--at", "0", "--digits", "50"]) == 0
    assert "kappa = 0.35355339059327376220042218105242451964241796884424\n" in capsys.readouterr().out
    assert main(["invariants", "t, t^3", "--at", "0"]) == 0
    output = capsys.readouterr().out
    assert "k = undefined here" in output and "kappa = 0" in output
    assert main(["invariants", "t, t^2", "--at", "0", "--latex"]) == 0
    assert r"\kappa = 2.0" in capsys.readouterr().out.splitlines()


def test_a_swollen_invariant_is_shown_over_jets(capsys):
    nested = "sin(" * 12 + "t" + ")" * 12
    assert main(["invariants", f"{nested}, t^5+exp({nested})"]) == 0
    assert "are the derivatives of the coordinates" in capsys.readouterr().out


def test_complexity_in_words(capsys):
    assert main(["complexity", *SPIRAL, "--tolerance", "1e-8"]) == 0
    output = capsys.readouterr().out
    assert "1.26959011703699" in output and re.search(r"whole pieces +51\n", output)
    assert main(["complexity", "t, t^3", "--from", "-1", "--to", "1"]) == 0
    assert "2 between split points: C = C1 + C2\n" in capsys.readouterr().out


@pytest.mark.parametrize(
    "arguments",
    [
        ["-t, t^2", "--from", "-1", "--to", "-1/2"],
        ["--from", "-1", "--to", "-1/2", "-t, t^2"],
        ["--from=-1", "--to=-1/2", "--", "-t, t^2"],
        ["--from", "-1", "-t, t^2", "--json", "--to", "-1/2"],
        ["-(t), t^2", "--from", "-1", "--to", "-0.5", "--split-at", "-0.6", "-0.7"],
    ],
)
def test_formulas_and_values_may_begin_with_a_minus(arguments, capsys):
    assert main(["approximate", *arguments]) == 0
    assert "t**2" in capsys.readouterr().out


def test_arranging():
    def arranged(*arguments: str) -> list[str]:
        return arrange(arguments, ["--at", "--file"], ["--json"], ["--file"], 1)

    assert arranged("-t", "--json") == ["--json", "--", "-t"]
    assert arranged("--at", "-pi", "-t,t") == ["--at", "-pi", "--", "-t,t"]
    assert arranged("--at=a=b", "x") == ["--at", "a=b", "--", "x"]
    assert arranged("--file", "a", "x", "--file", "b", "c") == [
        *("--file", "a", "--file", "b", "--file", "c"),
        *("--", "x"),
    ]
    assert arranged("--", "--json") == ["--", "--json"]
    for wrong in (["-q"], ["--fil", "a"], ["a", "b"], ["--at", "--json"], ["--at"], ["--json=1"]):
        with pytest.raises(UsageError):
            arranged(*wrong)


def test_help_and_version(capsys):
    assert main([]) == 0
    door = capsys.readouterr().out
    assert main(["--help"]) == 0
    assert capsys.readouterr().out == door
    assert all(name in door for name in ("approximate", "invariants", "complexity", "tables"))
    assert "completion" not in door
    assert main(["approximate", "--help"]) == 0
    assert "--split-at" in capsys.readouterr().out
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"osculant {osculant.__version__}\n"


def test_control_c_is_status_130(monkeypatch, capsys):
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("osculant.api.approximate", interrupted)
    assert main(CUBIC) == 130
    assert "Traceback" not in capsys.readouterr().err


def test_a_defect_is_told_from_a_mistake(monkeypatch, capsys):
    def broken(*_: object, **__: object) -> None:
        raise ZeroDivisionError("oh")

    monkeypatch.setattr("osculant.api.approximate", broken)
    monkeypatch.delenv("OSCULANT_DEBUG", raising=False)
    assert main(CUBIC) == 1
    assert "defect of osculant (ZeroDivisionError: oh)" in capsys.readouterr().err
    monkeypatch.setenv("OSCULANT_DEBUG", "1")
    with pytest.raises(ZeroDivisionError):
        main(CUBIC)


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_a_bar_is_shown_on_a_terminal_to_those_who_wait(monkeypatch):
    for patience, shown in ((0.0, True), (math.inf, False)):
        monkeypatch.setattr(printing, "PATIENCE", patience)
        monkeypatch.setattr(sys, "stderr", Terminal())
        with printing.Waiting("counting") as progress:
            progress(0.25)
            progress(1.0)
        assert ("counting" in sys.stderr.getvalue()) == shown


def test_no_bar_without_an_output_for_it(monkeypatch):
    monkeypatch.setattr(printing, "PATIENCE", 0.0)
    monkeypatch.setattr(sys, "stderr", None)  # as Python has it where that was closed before the start
    with printing.Waiting("counting") as progress:
        progress(0.5)
    assert main([]) == 0 and main(["aproximate"]) == 2


def test_no_bar_in_a_pipe(monkeypatch, capsys):
    monkeypatch.setattr(printing, "PATIENCE", 0.0)
    with printing.Waiting("counting") as progress:
        progress(0.5)
    assert capsys.readouterr().err == ""


def test_the_notice_of_compiling_is_no_part_of_the_answer(capsys, monkeypatch, tmp_path):
    monkeypatch.setattr(jit, "folder_of", lambda family: tmp_path)  # nothing is compiled before
    printing.announce_compiling()
    jit.kernel(lambda x: x + 1.0)(1.0)
    output = capsys.readouterr()
    assert output.out == "" and re.fullmatch(r"osculant: compiling kernels .*\.\n", output.err)


def test_long_texts_are_broken_beside_their_names(capsys):
    printing.print_rows([("name", "one two three\nfour"), ("", "five")], least=8, columns=16)
    assert capsys.readouterr().out == f"name    one two\n{' ' * 8}three\n{' ' * 8}four\n{' ' * 8}five\n"


def test_an_output_without_letters_has_question_marks():
    fold = ["x, y^2", "--source", "x y", "--certificate"]
    done = subprocess.run(
        [sys.executable, "-m", "osculant", "germ", *fold],
        env={**os.environ, "PYTHONIOENCODING": "ascii"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert "contains M^2? (l = 1)" in done.stdout


def test_a_process_of_its_own():
    def run(*arguments: str, **options: object) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "osculant", *arguments]
        return subprocess.run(command, capture_output=True, text=True, check=False, **options)

    refused = run("approximate", "t, 1/t", "--from", "-1", "--to", "1")
    assert refused.returncode == 2 and refused.stdout == ""
    assert_one_sentence(refused.stderr, "t = 0")

    code = "import sys; from osculant.cli.main import main; main(['--help']); print(*sys.modules)"
    light = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    heavy = {"sympy", "symengine", "numba", "llvmlite", "flint", "matplotlib", "numpy", "rich"}
    assert heavy.isdisjoint(light.stdout.splitlines()[-1].split())


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_and_a_reader_who_went_away():
    command = [
        sys.executable,
        "-m",
        "osculant",
        "invariants",
        "t, t^2",
        "--at",
        "1",
        "--digits",
        "3000",
    ]
    with open("/dev/full", "w") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 2
    assert_one_sentence(done.stderr, "Cannot write the output: No space left")
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    process.stdout.close()
    assert process.stderr.read() == ""
    process.stderr.close()
    assert process.wait() == 141
