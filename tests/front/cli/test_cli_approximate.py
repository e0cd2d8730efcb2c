"""`osculant approximate` and `complexity`: metrics, a number of pieces, closing, splitting, files."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from types import SimpleNamespace

import pytest

import osculant
from osculant.cli.grammar import UsageError
from osculant.cli.main import main
from osculant.cli.options import writing_options
from osculant.cli.splines import UNSPLIT, print_spline
from osculant.cli.unsplit import pieces_unsplit
from osculant.primitives.table import candidates
from osculant.spline import Spline
from tests.front.cli.test_cli import assert_one_sentence
from tests.front.samples import circle, spline_of

SPIRAL = ["t*cos(t), t*sin(t)", "--from", "pi/6", "--to", "2*pi"]
CUBIC = ["t, t^3", "--from", "-1", "--to", "1"]
SPACE = ["t, t^2, t^3", "--from", "0", "--to", "1"]


def rows_of(output: str) -> dict[str, str]:
    """Names and texts of a table."""
    return dict(re.split(r"  +", line.strip(), maxsplit=1) for line in output.splitlines())


def run(capsys, *arguments: str) -> dict[str, str]:
    assert main([*arguments]) == 0
    return rows_of(capsys.readouterr().out)


def printed(capsys, spline: Spline) -> dict[str, str]:
    print_spline(spline, 0.1, ())
    return rows_of(capsys.readouterr().out)


COSH = ["t, cosh(t)", "--from", "-1", "--to", "2"]


def test_knots_that_cost_pieces_are_told(capsys):
    rows = run(capsys, "approximate", *COSH, "--tolerance", "1e-2")
    assert rows["pieces"] == "3"
    assert rows["split"].startswith("theory forces knots; with --split never 2 pieces will do")
    assert run(capsys, "approximate", *COSH, "--tolerance", "1e-2", "--split", "never")["pieces"] == "2"


@pytest.mark.parametrize(
    "options",
    [
        ["--tolerance", "1e-3", "--with", "polygon"],  # theory wants no knots
        ["--pieces", "4"],
        ["--tolerance", "1e-2", "--split", "never"],
    ],
)
def test_where_they_cost_nothing_is_said(capsys, options):
    assert "theory forces" not in run(capsys, "approximate", *COSH, *options).get("split", "")


def test_knots_that_cost_much_in_space():
    curve = osculant.curve("(6+2*cos(5*t))*cos(t), (6+2*cos(5*t))*sin(t), 2*sin(5*t)", 0, "2*pi")
    spline = osculant.approximate(curve, "bihelix", 1e-2)
    assert (len(spline), pieces_unsplit(curve, spline, 600)) == (20, 15)


def test_what_takes_too_long_is_not_told():
    curve = osculant.curve("t, cosh(t)", -1, 2)
    spline = osculant.approximate(curve, "conic", 1e-2)
    assert pieces_unsplit(curve, spline, 1e-4) is None
    assert pieces_unsplit(curve, spline, 60) == 2


def test_the_area_metric(capsys):
    rows = run(capsys, "approximate", *SPIRAL, "--metric", "area", "--tolerance", "1e-4")
    assert (rows["metric"], rows["pieces"]) == ("area", "13")
    error, largest = float(rows["error"].split(",")[0]), float(rows["largest piece"])
    assert 12 * largest < error <= 13 * largest * (1 + 1e-6) and error <= 1e-4
    assert rows["error"].endswith("the sum of the pieces' areas (estimate)")
    assert "rule" not in rows and "closed" not in rows and "split" not in rows


def test_another_rule_is_told(capsys):
    wanted = ["--metric", "area", "--rule", "minimal-area", "--tolerance", "1e-2"]
    assert run(capsys, "approximate", *SPIRAL, *wanted)["rule"] == "minimal-area"
    wanted[3] = "equisymmetric"
    assert "rule" not in run(capsys, "approximate", *SPIRAL, *wanted)


def test_a_given_number_of_pieces(capsys):
    rows = run(capsys, "approximate", *SPIRAL, "--pieces", "9")
    assert rows["pieces"] == "9 (given)" and rows["minimal"] == "by theory (the largest error of a piece)"
    assert "tolerance" not in rows and "predicted" not in rows
    assert float(rows["error"].split()[0]) == pytest.approx(float(rows["predicted error"]), rel=0.05)
    law = run(capsys, "complexity", *SPIRAL, "--pieces", "9")
    assert law["given pieces"] == "9"
    assert float(law["predicted error"]) == pytest.approx(float(rows["predicted error"]), rel=1e-5)


def test_pieces_and_tolerance_are_inverse_on_the_command_line(capsys):
    for metric in ("hausdorff", "area"):
        assert main(["approximate", *SPIRAL, "--metric", metric, "--pieces", "12", "--json"]) == 0
        data = json.loads(capsys.readouterr().out)
        assert data["given"] == "pieces" and data["pieces"] == 12
        error = max(data["errors"]) * 12 if metric == "area" else data["error"]
        tolerance = repr(error * (1 + 1e-9))
        rows = run(capsys, "approximate", *SPIRAL, "--metric", metric, "--tolerance", tolerance)
        assert rows["pieces"] == "12"


def test_never_split_says_what_is_not_proved(capsys):
    curve = ["t, cosh(t)", "--from", "-1", "--to", "1", "--tolerance", "1e-5"]
    split = run(capsys, "approximate", *curve)
    unsplit = run(capsys, "approximate", *curve, "--split", "never")
    assert split["split points"] != "none" and split.get("split") != UNSPLIT
    assert unsplit["split points"] == "none" and unsplit["split"] == UNSPLIT
    assert unsplit["minimal"] == "unknown" and int(unsplit["pieces"]) <= int(split["pieces"])


def test_a_closed_curve(capsys, tmp_path):
    curve = ["cos(t) + cos(2*t)/9, sin(t)", "--from", "0", "--to", "2*pi", "--tolerance", "1e-3"]
    target = tmp_path / "a.svg"
    rows = run(capsys, "approximate", *curve, "--write", str(target))
    assert rows["closed"] == "yes"
    path = re.search(r'id="spline".*? d="([^"]*)"', target.read_text(), re.DOTALL).group(1)
    assert path.endswith("\nZ") and path.split("\n")[-2].split()[-2:] == path.split("\n")[0][1:].split()
    assert "closed" not in run(capsys, "approximate", *curve, "--open", "--write", str(target))
    assert "\nZ" not in target.read_text()


def test_the_start_of_a_closed_curve(capsys):
    circle_like = replace(spline_of([circle(1.0, 3.0, error=1e-3)]), closed=True)
    assert "start" not in printed(capsys, circle_like)
    rows = printed(capsys, replace(circle_like, gap=0.0))
    assert rows["start"] == "t = 1: no other start has a smaller error"
    rows = printed(capsys, replace(circle_like, gap=0.0123))
    assert rows["start"] == "t = 1: from another start the error may be smaller, by at most 0.012 of it"


def test_the_best_primitive_and_why(capsys):
    rows = run(capsys, "approximate", *SPIRAL, "--with", "best", "--tolerance", "1e-2")
    best, _, why = rows["primitive"].partition(", ")
    assert why == "the best: it takes the fewest numbers to store"
    found = {
        name: re.fullmatch(r"(\d+) pieces, (\d+) numbers", rows[name]).groups() for name in candidates(2)
    }
    assert found[best][0] == rows["pieces"]
    assert min(found, key=lambda name: int(found[name][1])) == best


def test_what_is_proved_is_rounded_outwards(capsys):
    spline = spline_of([circle(1.0, 3.0, error=1e-3)], tolerance=2e-3)
    proof = SimpleNamespace(lower=1.23456789012e-3, upper=1.23456789098e-3, within=True)
    object.__setattr__(spline, "certificate", proof)  # as certify does
    rows = printed(capsys, spline)
    assert rows["certified"] == "at least 0.00123456789, at most 0.001234567891: within the tolerance"
    assert rows["error"] == "0.001234567891 (certified)"
    proof.within = False
    rows = printed(capsys, spline)
    assert rows["certified"].endswith("not proved to be within the tolerance")
    assert rows["error"] == "0.001 (estimate)"
    proof.upper = float("inf")
    rows = printed(capsys, spline)
    assert rows["certified"] == "at least 0.00123456789; no upper bound was proved"
    assert rows["error"] == "0.001 (estimate)"


def test_a_certificate_is_printed(capsys):
    rows = run(capsys, "approximate", *SPIRAL, "--tolerance", "1e-2", "--certify")
    lower, upper = map(float, re.findall(r"[\d.e-]+\d", rows["certified"]))
    assert lower < upper < 1e-2 and rows["certified"].endswith("within the tolerance")
    assert rows["error"].endswith("(certified)")
    assert main(["approximate", *SPIRAL, "--tolerance", "1e-2", "--certify", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["certificate"]["within"] is True and data["error_kind"] == "certified"


def test_the_law_of_areas_and_how_constants_combine(capsys):
    rows = run(capsys, "complexity", *CUBIC, "--metric", "area", "--tolerance", "1e-4")
    assert (rows["metric"], rows["pieces"]) == ("area", "C*tolerance^(-1/5)")
    combined = float(rows["C1"]) ** (5 / 6) + float(rows["C2"]) ** (5 / 6)
    assert float(rows["C"]) == pytest.approx(combined ** (6 / 5), rel=1e-14)
    assert float(rows["predicted"]) == pytest.approx(float(rows["C"]) * 1e-4**-0.2)
    assert rows["stretches"] == "2 between split points: C^(5/6) = C1^(5/6) + C2^(5/6)"
    rows = run(capsys, "complexity", "t, sin(t)", "--from", "0.1", "--to", "9")
    assert rows["stretches"].endswith(" between split points: C = C1 + C2 + ...")


def test_the_law_as_plain_data(capsys):
    assert main(["complexity", *SPIRAL, "--metric", "area", "--pieces", "33", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert (data["metric"], data["order"], data["pieces"]) == ("area", 5, 33)
    assert data["predicted_error"] == pytest.approx((2.03777820080992568 / 33) ** 5)
    assert "tolerance" not in data


def test_gcode_for_a_machine_of_few_decimals(capsys, tmp_path):
    target, drawing = tmp_path / "a.nc", tmp_path / "a.dxf"
    wanted = ["--decimals", "3", "--units", "mm", "--feed", "250", "--write", str(target)]
    biarcs = ["approximate", *SPIRAL, "--with", "biarc", "--tolerance", "1e-2"]
    assert main([*biarcs, *wanted, "--write", str(drawing)]) == 0
    text = target.read_text()
    assert "G21" in text and "(decimals: 3," in text and " F250.0" in text
    assert re.search(r"^\(error of this file: 0\.00\d+ \[measured\]\)$", text, re.MULTILINE)
    assert {len(d) for d in re.findall(r"[XYIJ]-?\d+\.(\d+)", text)} == {3}
    assert re.search(r"\$INSUNITS\s+70\s+4\s", drawing.read_text())
    assert main(["approximate", *SPACE, *wanted, "--tolerance", "1e-2"]) == 0
    assert "(decimals: 3," in target.read_text() and "G21" in target.read_text()


def test_writing_options_are_for_the_files_that_can_follow_them():
    assert writing_options(["a.json", "b.nc"], feed="1e3", decimals=None, units=None) == {
        "a.json": {},
        "b.nc": {"feed": 1e3},
    }
    assert writing_options(["a.svg"], knots=False) == {"a.svg": {"knots": False}}
    assert writing_options([], feed=None) == {}
    for wrong in ({"feed": "nan"}, {"feed": "some"}, {"decimals": "1.5"}, {"knots": True}):
        with pytest.raises(UsageError):
            writing_options(["a.nc"], **wrong)


#: what is wrong, the arguments, and what the sentence must say
MISTAKES = {
    "no pieces": ([*SPIRAL, "--pieces", "0"], "pieces is 0: give a whole number"),
    "fewer than none": ([*SPIRAL, "--pieces", "-3"], "pieces is -3: give a whole number"),
    "half a piece": ([*SPIRAL, "--pieces", "2.5"], r"pieces is 2\.5: give a whole number"),
    "pieces in words": ([*SPIRAL, "--pieces", "x"], "pieces is x: give a whole number"),
    "empty pieces": ([*SPIRAL, "--pieces", ""], "pieces is '': give a whole number"),
    "pieces galore": ([*SPIRAL, "--pieces", "1000000000"], "pieces is 1000000000: give .* to 100000"),
    "pieces galore in space": ([*SPACE, "--pieces", "1000000000"], "pieces is 1000000000: give"),
    "no pieces in space": ([*SPACE, "--pieces", "0"], "pieces is 0: give a whole number"),
    "pieces and tolerance": ([*SPIRAL, "--pieces", "9", "--tolerance", "1e-3"], "Both a tolerance, 1e-3,"),
    "too few for the turning": ([*SPIRAL, "--pieces", "1"], "at least 2, as it turns too far"),
    "too few for the splits": ([*CUBIC, "--pieces", "1"], "takes at least 2, as it is split into 2 parts"),
    "too few for split-at": (
        [*CUBIC, "--split-at", "1/2", "1/3", "--pieces", "3"],
        "at least 4, as it is split into 4 parts: ask for 4 or more",
    ),
    "too few biarcs": ([*CUBIC, "--with", "biarc", "--pieces", "3"], "at least 4, as it is split into 4"),
    "too few areas": ([*CUBIC, "--metric", "area", "--pieces", "1"], "at least 2"),
    "open": ([*SPIRAL, "--closed"], r"is not closed: it begins at .* 5\.84 apart"),
    "open in space": ([*SPACE, "--closed"], "is not closed: it begins at"),
    "nearly closed": (
        ["cos(t), sin(t)", "--from", "0", "--to", "6.2832", "--closed"],
        r"give ends at which it is at the same point exactly \(2\*pi rather than 6\.2832\)",
    ),
    "unknown metric": ([*SPIRAL, "--metric", "l2"], "metric 'l2' is unknown: choose one of hausdorff, area"),
    "unknown rule": (
        [*SPIRAL, "--rule", "nice"],
        "rule 'nice' is unknown for conic .*choose equioscillating",
    ),
    "unknown rule in space": ([*SPACE, "--rule", "nice"], "choose one of equioscillating, thesis"),
    "unknown split": ([*SPIRAL, "--split", "often"], "split 'often' is unknown: choose theory or never"),
    "rule of another metric": ([*SPIRAL, "--rule", "minimal-area"], "unknown for conic and the metric haus"),
    "rule of another primitive": (
        [*SPIRAL, "--with", "parabola", "--metric", "area", "--rule", "minimal-area"],
        "unknown for parabola and the metric area: choose bitangent",
    ),
    "bihelix rule of conics": (
        [*SPIRAL, "--metric", "area", "--rule", "thesis"],
        "or minimal-area, or leave",
    ),
    "area in space": ([*SPACE, "--metric", "area"], "'area' is one of plane curves"),
    "area of bihelices": (
        [*SPIRAL, "--with", "bihelix", "--metric", "area"],
        "Bihelices approximate curves in",
    ),
    "best of a number": ([*SPIRAL, "--with", "best", "--pieces", "9"], "belongs to one primitive"),
    "best of a rule": ([*SPIRAL, "--with", "best", "--rule", "equisymmetric"], "belongs to one primitive"),
    "certified area": ([*SPIRAL, "--metric", "area", "--certify"], "distances in the plane only"),
    "certified in space": ([*SPACE, "--certify"], "distances in the plane only"),
    "decimals of nothing": ([*SPIRAL, "--decimals", "4"], r"--decimals needs .* \.nc, \.gcode or \.ngc"),
    "decimals of a picture": ([*SPIRAL, "--decimals", "4", "--write", "a.svg"], "--decimals needs a file"),
    "feed of data": ([*SPIRAL, "--feed", "1", "--write", "a.json"], "--feed needs a file"),
    "no reserve": ([*SPIRAL, "--reserve", "1", "--write", "a.nc"], "no option '--reserve'"),
    "units of a picture": ([*SPIRAL, "--units", "mm", "--write", "a.svg"], r"--units needs .* or \.dxf"),
    "strange units": (
        [*SPIRAL, "--with", "biarc", "--units", "cm", "--write", "a.nc"],
        "are 'mm' or 'inch', not 'cm'",
    ),
    "strange dialect": (
        [*SPIRAL, "--with", "biarc", "--dialect", "fanuc", "--write", "a.nc"],
        "'fanuc' of G-code is unknown: choose linuxcnc, grbl or marlin",
    ),
    "no feed": ([*SPIRAL, "--with", "biarc", "--feed", "0", "--write", "a.nc"], "feed rate is 0"),
    "a feed in words": ([*SPIRAL, "--feed", "fast", "--write", "a.nc"], "finite number, and 'fast'"),
    "conics as G-code": ([*SPIRAL, "--write", "a.nc"], "G-code holds lines.*conic arcs; choose biarc"),
    "one of two files": ([*SPIRAL, "--write", "a.svg", "--write", "a.nc"], "conic arcs; choose biarc"),
    "output without a format": ([*SPIRAL, "--write", "-"], r"name the format .* such as -\.svg"),
    "output twice": ([*SPIRAL, "--write", "-.svg", "--json"], r"Only one of -\.svg and --json can be"),
    "too few decimals": (
        [*SPIRAL, "--with", "biarc", "--tolerance", "1e-3", "--decimals", "2", "--write", "a.nc"],
        "give 3 decimals or more",
    ),
    "decimals in words": ([*SPIRAL, "--decimals", "few", "--write", "a.nc"], "whole number, and 'few'"),
    "negative decimals": (
        [*SPIRAL, "--with", "biarc", "--decimals", "-1", "--write", "a.nc"],
        "is -1: give a whole number from 0",
    ),
    "closed with a value": ([*SPIRAL, "--closed=yes"], "--closed takes no value"),
}
LAW_MISTAKES = {
    "unknown metric": ([*SPIRAL, "--metric", "l2"], "'l2' is unknown"),
    "no pieces": ([*SPIRAL, "--pieces", "0"], "pieces is 0"),
    "too few": ([*CUBIC, "--pieces", "1"], "at least 2: ask for 2 or more"),
    "best": ([*SPIRAL, "--with", "best"], "'best' is unknown: choose one of parabola, conic, biarc"),
    "second term of areas": ([*SPIRAL, "--metric", "area", "--next-term"], "not known for the metric 'area'"),
    "area in space": ([*SPACE, "--metric", "area"], "'area' is one of plane curves"),
}


@pytest.mark.parametrize("arguments, says", MISTAKES.values(), ids=MISTAKES)
def test_a_mistake_is_one_sentence(arguments, says, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["approximate", *arguments]) == 2
    output = capsys.readouterr()
    assert output.out == "" and not list(tmp_path.iterdir())
    assert_one_sentence(output.err, says)


@pytest.mark.parametrize("arguments, says", LAW_MISTAKES.values(), ids=LAW_MISTAKES)
def test_a_mistake_about_the_law_is_one_sentence(arguments, says, capsys):
    assert main(["complexity", *arguments]) == 2
    output = capsys.readouterr()
    assert output.out == ""
    assert_one_sentence(output.err, says)


@pytest.mark.parametrize("primitive, suffix, pieces", [("conic", ".svg", 60), ("biarc", ".nc", 200)])
def test_a_tolerance_that_pieces_just_keep_has_room_for_rounding(primitive, suffix, pieces, capsys, tmp_path):
    """The search leaves it, with a piece more if it must; a number of pieces is written as it is."""
    spiral = osculant.curve("t*cos(t), t*sin(t)", "pi/6", "2*pi")
    tolerance = osculant.approximate(spiral, primitive, pieces=pieces).error * (1 + 1e-9)
    target = tmp_path / f"a{suffix}"
    write = ["approximate", *SPIRAL, "--with", primitive, "--write", str(target), "--json"]
    assert main([*write, "--tolerance", repr(tolerance)]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["pieces"] > pieces and data["error"] <= tolerance - data["reserved"]
    (file,) = data["files"]
    assert file["error"] <= tolerance and file["path"] == str(target)
    assert main([*write, "--pieces", str(pieces)]) == 0
    (file,) = json.loads(capsys.readouterr().out)["files"]
    assert tolerance * 0.99 < file["error"] < 1.25 * tolerance


def test_standard_output(capsys):
    """A file there, and what is told elsewhere."""
    assert main(["approximate", *SPIRAL, "--tolerance", "1e-2", "--write", "-.svg", "--no-knots"]) == 0
    output = capsys.readouterr()
    assert (
        output.out.startswith("<?xml") and output.out.endswith("</svg>\n") and 'id="knots"' not in output.out
    )
    assert rows_of(output.err)["written"].startswith("standard output: error 0.00")


def test_pairs_of_arcs_are_told_as_such(capsys):
    assert (
        run(capsys, "approximate", *SPIRAL, "--with", "biarc", "--tolerance", "1e-2")["pieces"]
        == "5, of 10 arcs"
    )


def test_the_best_for_a_file_is_counted_there(capsys, tmp_path):
    rows = run(
        capsys,
        "approximate",
        *SPIRAL,
        "--with",
        "best",
        "--tolerance",
        "1e-2",
        "--write",
        str(tmp_path / "a.nc"),
    )
    assert rows["conic"] == "not for G-code" and rows["biarc"].endswith("numbers in G-code")
