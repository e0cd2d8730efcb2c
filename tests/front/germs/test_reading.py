"""What germs are read from: files, dictionaries of coefficients, other points; mistakes in a sentence."""

from __future__ import annotations

import json
from fractions import Fraction
from random import Random

import pytest
import sympy
import typer
from typer.testing import CliRunner

from osculant.cas.errors import DomainError, FormulaError, OsculantError
from osculant.cli.germ import GermCommand
from osculant.cli.germ import germ as command
from osculant.cli.grammar import Commands
from osculant.cli.main import main
from osculant.germs.map_germ import germ

app = typer.Typer(cls=Commands, pretty_exceptions_enable=False)
app.callback()(lambda: None)
app.command("germ", cls=GermCommand)(command)


def run_json(*arguments: str):
    result = CliRunner().invoke(app, ["germ", *arguments, "--json"])
    if result.exception is not None:
        raise result.exception
    return json.loads(result.stdout)


def dense() -> list[dict[tuple[int, int], Fraction]]:
    """S2 = (x, y², y³ + x³y) in dense coordinates, as coefficients up to degree 9."""
    random, (x, y) = Random(7), sympy.symbols("x y")
    source = [
        v + sum(sympy.Rational(random.randint(-9, 9), random.randint(1, 3)) * x**i * y**j for i, j in powers)
        for v, powers in ((x, [(2, 0), (1, 1), (0, 2), (2, 1)]), (y, [(2, 0), (1, 1), (0, 2), (0, 3)]))
    ]
    a, b = source
    f = [a, b**2, b**3 + a**3 * b]
    mixed = [f[0] + f[1] - 2 * f[2], f[1] + f[0] ** 2, f[2] + f[0] * f[1] + f[1]]
    cut = []
    for component in mixed:
        terms = sympy.Poly(sympy.expand(component), x, y).terms()
        cut.append({m: Fraction(int(c.p), int(c.q)) for m, c in terms if sum(m) <= 9})
    return cut


def text_of(coefficients: list[dict[tuple[int, int], Fraction]]) -> str:
    return ",\n".join(
        "\n + ".join(f"({c})*x^{i}*y^{j}" for (i, j), c in component.items()) for component in coefficients
    )


def test_a_long_germ_is_read_from_a_file(tmp_path):
    file = tmp_path / "dense germ.txt"
    written = text_of(dense()) + "\n"
    file.write_text(written, encoding="utf-8-sig")  # with a mark of the byte order, as some editors write it
    with pytest.raises(FormulaError, match="at most 4096 characters"):
        germ(written + 3000 * " ", "x y")
    data = run_json(f"@{file}", "--source", "x y")
    assert (data["codimension"], data["extended_codimension"], data["determinacy"]) == (4, 2, 4)
    assert data["components"] == list(germ(file, "x y").components)


def test_very_long_sums_are_read(tmp_path):
    file = tmp_path / "long.txt"
    file.write_text(
        "x, y^2, y^3 + x^2*y" + "".join(f" + {k}*x^{k % 90}*y^{k // 90 + 9}" for k in range(3000))
    )
    assert file.stat().st_size > 40_000
    assert germ(file, "x y").codimension("A") == 3


def test_text_in_a_file_is_not_run(tmp_path):
    file = tmp_path / "evil.txt"
    target = tmp_path / "made"
    file.write_text(f"__import__('os').mkdir('{target}')")
    with pytest.raises(FormulaError, match="has no meaning in a formula"):
        run_json(f"@{file}", "--source", "x")
    assert not target.exists()


def test_coefficients_are_read():
    coefficients = [{(1, 0): 1}, {(1, 1): 1, (0, 3): Fraction(1, 2), (0, 4): 0}]
    g = germ(coefficients, "x y")
    assert g.components == ("x", "x*y + 1/2*y**3")
    assert g.is_stable()
    assert germ({(3,): 2}, "x").milnor == 2
    assert germ([{(2, 0): sympy.Rational(1, 3)}, "x*y", sympy.Symbol("y") ** 2], "x y").target == 3
    assert germ([{}, {(1,): 1}], "x").components == ("0", "x")
    assert germ({(2,): 0.5}, "x").components == ("1/2*x**2",)  # as floats of expressions are
    assert germ(dense(), "x y").codimension("A") == 4


def test_coefficients_that_are_none():
    for exponents in ((1,), (1, -1), (1, 1.0), "xy", 2, (True, 1), (4000, 96)):
        with pytest.raises(DomainError, match=r"exponents .* of a coefficient are none: give a tuple of 2"):
            germ([{exponents: 1}], "x y")
    with pytest.raises(DomainError, match=r"x of \(1,\) is no number"):
        germ({(1,): sympy.Symbol("x")}, "x")
    with pytest.raises(DomainError, match="pi is neither rational nor algebraic"):
        germ({(1,): sympy.pi}, "x")
    assert germ({(2,): sympy.sqrt(2)}, "x").components == ("sqrt(2)*x**2",)
    for coefficient in ("1", None, [1], float("nan"), float("inf")):
        with pytest.raises((FormulaError, DomainError)):
            germ({(1,): coefficient}, "x")
    with pytest.raises(DomainError, match="Component 1 of the germ is 3 at the origin"):
        germ([{(0, 0): 3, (1, 0): 1}], "x y")


def test_a_germ_at_another_point():
    data = run_json("x^3 - 3*x + y^2", "--source", "x y", "--at", "-1,0")
    assert data["at"] == ["-1", "0"]
    assert (data["components"], data["milnor"]) == (["x**3 - 3*x**2 + y**2"], 1)
    # folds along x = -3*y^2, the cusp at 0, no singular point elsewhere
    found = {
        at: run_json("x, y^3 + x*y", "--source", "x y", "--at", at)["codimension"]
        for at in ("0, 0", "-3/4, 0.5", "-12,2", "1,0")
    }
    assert found == {"0, 0": 2, "-3/4, 0.5": 1, "-12,2": 1, "1,0": 0}
    g = germ("x, y^3 + x*y", "x y", at=(Fraction(-3, 4), sympy.Rational(1, 2)))
    assert (g.at, g.codimension("A")) == (("-3/4", "1/2"), 1)
    assert run_json("x^2", "--source", "x")["components"] == ["x**2"]
    assert "at" not in run_json("x^2", "--source", "x")
    # the point may be on H, and a transversal or an unfolding is asked there as well
    moved = run_json("(x - 1)^2 + u^3", "--source", "x u", "--at", "1,0", "--transversal", "1")
    assert (moved["components"], moved["at"], moved["group"]) == (["x**2 + u**3"], ["1", "0"], "R(H)")
    assert moved["transversal"] == ["x**2", "x*u", "u**2"]
    versal = run_json("(x - 1)^3 + a*x", "--source", "x a", "--at", "1,0", "--versal", "a")
    assert (versal["reached"], versal["missing"]) == (1, ["1"])


MISTAKES = {
    "too few": (["x, y", "--source", "x y", "--at", "1"], "--at: 1 coordinate for 2 source variables"),
    "too many": (["x", "--source", "x", "--at", "1,2,3"], "--at: 3 coordinates for 1 source variables"),
    "irrational": (["x", "--source", "x", "--at", "sqrt(2)"], "sqrt(2) is no exact rational number"),
    "with a variable": (["x", "--source", "x", "--at", "x"], "The name 'x' is unknown"),
    "no number": (["x", "--source", "x", "--at", ""], "The formula is empty"),
    "off the boundary": (["x + u", "--source", "x u", "--at", "0,1"], "off the boundary u = 0"),
    "a pole": (["1/x", "--source", "x", "--at", "0"], "not analytic at the origin"),
    "twice a name": (["x", "--source", "x x", "--at", "0,0"], "must be one or more, all different"),
    "no file": (
        ["@no such file", "--source", "x"],
        "no such file cannot be read: No such file or directory.",
    ),
    "no name": (["@", "--source", "x"], "The name of the file is missing after @"),
    "a folder": (["@/", "--source", "x"], "cannot be read: Is a directory."),
    "a zero byte": (["@a\0b", "--source", "x"], "cannot be read: embedded null byte."),
    "twice a name, file": (["@no such file", "--source", "x x"], "cannot be read"),
}


@pytest.mark.parametrize("arguments, words", MISTAKES.values(), ids=MISTAKES)
def test_mistakes_are_told_in_a_sentence(arguments, words, capsys):
    assert main(["germ", *arguments]) == 2
    told = capsys.readouterr().err
    assert words in told
    assert "defect" not in told


@pytest.mark.parametrize(
    "content, words",
    [
        (b"\x89PNG\r\n\x1a\n\x00", "is no text"),
        (b"x\x00y", "is no text"),
        (b"caf\xe9", "is no text"),
        (b"", "is empty"),
        (b" \n\t\n", "is empty"),
        (b"x" * 1_000_001, "is too large: a file of formulas has at most 1000000 bytes"),
        (b"+".join([b"x*x"] * 60_000), "more than 50000 operations"),
        (b"x +", "is missing after '+'"),
        (b"y^2", "The name 'y' is unknown"),
    ],
    ids=["png", "zero byte", "latin", "empty", "blank", "large", "operations", "unfinished", "unknown"],
)
def test_files_that_hold_no_germ(content, words, tmp_path, capsys):
    file = tmp_path / "given"
    file.write_bytes(content)
    assert main(["germ", f"@{file}", "--source", "x"]) == 2
    told = capsys.readouterr().err
    assert words in told
    assert "defect" not in told
    assert len(told) < 1000


def test_points_that_are_not_exact():
    for at in (0.5, [0.5], ["1/2", None], [True, 0], [sympy.pi, 0], [1, sympy.Symbol("a")]):
        with pytest.raises(OsculantError, match="no exact rational number"):
            germ("x, y", "x y", at=at)
    with pytest.raises(DomainError, match="0 coordinates for 2"):
        germ("x, y", "x y", at=[])


def test_roots_of_polynomials_on_the_command_line():
    told = run_json("x^3 + a*x^2*y^2 + y^6", "--source", "x y", "--root", "4*a^3 + 27")
    assert told["codimension"] == "infinite" and told["field"]["name"] == "a"
    told = run_json("x, y^3 + sqrt(2)*x*y", "--source", "x y")
    assert told["stable"] and told["field"]["name"] is None
    assert "field" not in run_json("x, y^3 + sqrt(4)*x*y", "--source", "x y")
    named = run_json("x^3 + t1*y^4", "--source", "x y", "--root", "t1^2 - 2")
    assert named["unfolding_germ"]["parameters"] == ["s1", "s2", "s3", "s4", "s5", "s6"]
