"""The tables of the thesis: reproduced cell by cell, and able to fail."""

from __future__ import annotations

import json
import re

import pytest

from osculant.cas.errors import DomainError
from osculant.cli.main import main
from osculant.thesis import tables

# The numbers as corrected, by table, reading and primitive; theory is the same unless it is in THEORY.
NUMBERS = {
    ("3.1", "whole curve", "parabola"): [5, 9, 15, 26, 46, 82, 145, 257],
    ("3.1", "whole curve", "conic"): [3, 4, 6, 9, 13, 21, 32, 51],
    ("3.2", "whole curve", "parabola"): [9, 15, 26, 46, 82, 146],
    ("3.2", "whole curve", "conic"): [4, 6, 9, 13, 21, 33],
    ("3.3", "whole curve", "parabola"): [6, 8, 14, 24, 44, 76, 134, 238],
    ("3.3", "whole curve", "conic"): [2, 4, 6, 8, 12, 18, 28, 44],
    ("3.4", "each half", "parabola"): [8, 12, 20, 34, 60, 108],
    ("3.4", "each half", "conic"): [4, 4, 6, 10, 16, 24],
    ("3.4", "whole curve", "parabola"): [8, 13, 23, 40, 72, 127],
    ("3.4", "whole curve", "conic"): [4, 5, 8, 11, 17, 26],
}
# Of the whole curve theory gives both halves the same number.
THEORY = {
    ("3.4", "each half", "parabola"): [6, 12, 20, 34, 60, 108],
    ("3.4", "whole curve", "parabola"): [8, 14, 24, 40, 72, 128],
    ("3.4", "whole curve", "conic"): [4, 6, 8, 12, 18, 26],
}
# To 18 digits from an independent computation.
CONSTANTS = {
    "3.1": {"3.17": "2.56677413266675333", "3.18": "1.26959011703699553"},
    "3.2": {"3.25": "4.58989272897455017", "3.26": "2.03777820080992568"},
    "3.3": {"3.17": "1.18187030003858798", "3.18": "0.529300817502150973"},
    "3.4": {"3.25": "1.67934089089600706", "3.26": "0.708049754584166635"},
}
# What the thesis has wrong: table, primitive, printed, computed.
CORRECTED = {("3.3", "conic", 4, 2), ("3.4", "parabola", 6, 8)}


@pytest.fixture(scope="module", params=list(CONSTANTS))
def table(request):
    return tables.compute(request.param)


def test_every_cell_is_right(table):
    number, seen = table.printed.number, 0
    for key, numbers in NUMBERS.items():
        if key[0] != number:
            continue
        for quantity in ("experiment", "theory"):
            cells = [c for c in table.cells if (c.reading, c.primitive, c.quantity) == (*key[1:], quantity)]
            right = THEORY.get(key, numbers) if quantity == "theory" else numbers
            assert [cell.computed for cell in cells] == right
            assert [cell.tolerance for cell in cells] == [float(f"1e-{n + 1}") for n in range(len(right))]
            seen += len(cells)
    assert seen == len(table.cells)


def test_the_corrected_cells_are_those_of_the_errata(table):
    number = table.printed.number
    others = [cell for cell in table.cells if cell.verdict not in {"as printed", "computed"}]
    found = {(number, cell.primitive, cell.printed, cell.computed) for cell in others}
    assert found == {row for row in CORRECTED if row[0] == number}
    for cell in others:
        assert (cell.tolerance, cell.quantity, cell.verdict) == (0.1, "experiment", "corrected")
        assert cell.note and cell.reading == table.printed.readings[0]


def test_nothing_is_said_of_a_reading_that_is_not_printed(table):
    for cell in table.cells:
        ours = cell.reading != table.printed.readings[0]
        assert (cell.verdict == "computed") == ours == (cell.printed is None)
    assert {cell.reading for cell in table.cells} == set(table.printed.readings)


def test_the_error_named_in_the_correction_is_that_of_the_two_conics():
    import osculant

    printed = tables.PRINTED["3.3"]
    curve = osculant.curve(printed.formula, printed.low, printed.high)
    spline = osculant.approximate(curve, "conic", 0.1, split_at=printed.split_at)
    (erratum,) = printed.errata.values()
    assert f"{spline.error:.7f}" in erratum.reason


def test_the_area_named_in_the_correction_is_that_of_three_parabolas():
    import osculant

    printed = tables.PRINTED["3.4"]
    (erratum,) = printed.errata.values()
    for low, high, _ in printed.parts("each half"):
        curve = osculant.curve(printed.formula, low, high)
        spline = osculant.approximate(curve, "parabola", pieces=3, metric="area")
        assert f"{spline.error:.6f}" in erratum.reason and spline.error > 0.1
        assert osculant.approximate(curve, "parabola", pieces=4, metric="area").error < 0.1


def test_the_constants_to_15_digits(table):
    for constant in table.constants:
        assert float(constant.value) == pytest.approx(
            float(CONSTANTS[table.printed.number][constant.equation]), rel=1e-15
        )
        assert len(constant.value.replace(".", "").lstrip("0")) >= 15


def test_a_wrong_number_differs(monkeypatch):
    def wrong(curve, primitive, tolerance, metric, split_at):
        assert metric == "hausdorff"
        return range(4)  # four pieces, whatever was asked for

    monkeypatch.setattr("osculant.api.approximate", wrong)
    cells = [cell for cell in tables.compute("3.3").cells if cell.quantity == "experiment"]
    verdicts = {(cell.primitive, cell.tolerance): cell.verdict for cell in cells}
    assert verdicts["conic", 0.01] == "as printed"  # four is right there
    assert verdicts.pop(("conic", 0.01)) and set(verdicts.values()) == {"differs"}  # also where 4 is printed


def test_a_reading_counts_all_its_parts(monkeypatch):
    asked = []

    def three(curve, primitive, tolerance, metric, split_at):
        asked.append((tolerance, metric, split_at))
        return range(3)

    monkeypatch.setattr("osculant.api.approximate", three)
    cells = [cell for cell in tables.compute("3.4").cells if cell.quantity == "experiment"]
    assert {(cell.reading, cell.computed) for cell in cells} == {("each half", 6), ("whole curve", 3)}
    assert {cell.verdict for cell in cells if cell.reading == "each half"} == {"differs", "as printed"}
    assert {metric for _, metric, _ in asked} == {"area"} and {split for *_, split in asked} == {(), ("0",)}
    assert {tolerance for tolerance, *_ in asked} == {float(f"1e-{n}") for n in range(1, 7)}


def test_progress_goes_to_the_end():
    parts: list[float] = []
    tables.compute("3.1", parts.append)
    assert len(parts) == 16 and parts[-1] == 1.0 and parts == sorted(parts)


def test_other_tables_are_refused():
    with pytest.raises(DomainError, match=r"'1\.1' here: choose 3\.1 or 3\.2 or 3\.3"):
        tables.compute("1.1")


def test_a_table_in_words(capsys):
    assert main(["tables", "3.3"]) == 0
    output = capsys.readouterr().out
    assert re.search(r"^conic +1e-01 +2 +4 +corrected +2 +2 +as printed$", output, re.MULTILINE)
    assert "each half turns by exactly pi" in output
    assert "0.529300817502150973" in output
    assert max(map(len, output.splitlines()[1:20])) <= 82


def test_both_readings_in_words(capsys):
    assert main(["tables", "3.4"]) == 0
    output = capsys.readouterr().out
    thesis, ours = output.split("The tolerance holds for the whole curve (not printed)")
    assert "holds for each half (as the thesis reads it)" in thesis
    assert re.search(r"^parabola +1e-01 +8 +6 +corrected +6 +6 +as printed$", thesis, re.MULTILINE)
    assert re.search(r"^conic +1e-06 +26 +computed +26 +computed *$", ours, re.MULTILINE)
    assert "parabola, experiment at 1e-01: three parabolas on a half have the total area 0.105361" in ours
    assert "constant (3.25), parabola, one half  1.67934089089600706" in ours
    assert "differs" not in output


def test_a_table_as_plain_data(capsys):
    assert main(["tables", "3.4", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert (data["table"], data["metric"], data["split_at"]) == ("3.4", "area", ["0"])
    first, last = data["cells"][0], data["cells"][-1]
    assert (first["primitive"], first["quantity"], first["reading"]) == (
        "parabola",
        "experiment",
        "each half",
    )
    assert (first["computed"], first["printed"], first["verdict"]) == (8, 6, "corrected")
    assert (last["computed"], last["printed"], last["verdict"]) == (26, None, "computed")
