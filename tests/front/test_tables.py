"""The tables of the thesis: reproduced cell by cell, and able to fail."""

from __future__ import annotations

import re

import pytest

from osculant import tables
from osculant.cas.errors import DomainError
from osculant.cli import main

# The numbers as corrected, and the constants to 18 digits from an independent computation.
SPIRAL = {"parabola": [5, 9, 15, 26, 46, 82, 145, 257], "conic": [3, 4, 6, 9, 13, 21, 32, 51]}
SEXTIC = {"parabola": [6, 8, 14, 24, 44, 76, 134, 238], "conic": [2, 4, 6, 8, 12, 18, 28, 44]}
CONSTANTS = {
    "3.1": {"3.17": "2.56677413266675333", "3.18": "1.26959011703699553"},
    "3.3": {"3.17": "1.18187030003858798", "3.18": "0.529300817502150973"},
}


@pytest.fixture(scope="module", params=["3.1", "3.3"])
def table(request):
    return tables.compute(request.param)


def test_every_cell_is_right(table):
    right = SPIRAL if table.printed.number == "3.1" else SEXTIC
    for primitive, numbers in right.items():
        for quantity in ("experiment", "theory"):
            cells = [cell for cell in table.cells if (cell.primitive, cell.quantity) == (primitive, quantity)]
            assert [cell.computed for cell in cells] == numbers
            assert [cell.tolerance for cell in cells] == [float(f"1e-{n}") for n in range(1, 9)]


def test_one_cell_is_corrected(table):
    others = [cell for cell in table.cells if cell.verdict != "as printed"]
    if table.printed.number == "3.1":
        assert others == []
        return
    (cell,) = others
    assert (cell.primitive, cell.tolerance, cell.quantity) == ("conic", 0.1, "experiment")
    assert (cell.computed, cell.printed, cell.verdict) == (2, 4, "corrected")
    assert "0.0933688" in cell.note


def test_the_error_named_in_the_correction_is_that_of_the_two_conics():
    import osculant

    printed = tables.PRINTED["3.3"]
    curve = osculant.curve(printed.formula, printed.low, printed.high)
    spline = osculant.approximate(curve, "conic", 0.1, split_at=printed.split_at)
    (erratum,) = printed.errata.values()
    assert f"{spline.error:.7f}" in erratum.reason


def test_the_constants_to_15_digits(table):
    for constant in table.constants:
        assert float(constant.value) == pytest.approx(
            float(CONSTANTS[table.printed.number][constant.equation]), rel=1e-15
        )
        assert len(constant.value.replace(".", "").lstrip("0")) >= 15


def test_a_wrong_number_differs(monkeypatch):
    def wrong(curve, primitive, tolerance, split_at):
        return range(4)  # four pieces, whatever was asked for

    monkeypatch.setattr("osculant.api.approximate", wrong)
    cells = [cell for cell in tables.compute("3.3").cells if cell.quantity == "experiment"]
    verdicts = {(cell.primitive, cell.tolerance): cell.verdict for cell in cells}
    assert verdicts["conic", 0.01] == "as printed"  # four is right there
    assert verdicts.pop(("conic", 0.01)) and set(verdicts.values()) == {"differs"}  # also where 4 is printed


def test_progress_goes_to_the_end():
    parts: list[float] = []
    tables.compute("3.1", parts.append)
    assert len(parts) == 16 and parts[-1] == 1.0 and parts == sorted(parts)


def test_other_tables_are_refused():
    with pytest.raises(DomainError, match=r"'1\.1' here: choose 3\.1 or 3\.3"):
        tables.compute("1.1")


def test_a_table_in_words(capsys):
    assert main(["tables", "3.3"]) == 0
    output = capsys.readouterr().out
    assert re.search(r"^conic +1e-01 +2 +4 +corrected +2 +2 +as printed$", output, re.MULTILINE)
    assert "each half turns by exactly pi" in output
    assert "0.529300817502150973" in output
    assert max(map(len, output.splitlines()[1:20])) <= 82
