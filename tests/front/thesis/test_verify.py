"""`osculant verify`: tables, JSON, derivations, errata; failures and crashes are told, not thrown."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import textwrap
from importlib import import_module

import pytest

import osculant
from osculant.cas.claims import Claim, Evidence, Judgement, Method, Verdict, all_claims, select
from osculant.cas.errors import DomainError
from osculant.cli import claims as report_claims
from osculant.cli.main import main
from osculant.cli.verify import joined
from osculant.thesis.verification import Verification, rests_on_evidence

QUICK = "2.2.1"
ERRATA = [c for c in all_claims() if c.erratum]

FALSE = '''
    """Claims that fail, each in its way."""

    import os
    import sys

    from osculant.cas.claims.claim import Evidence, Method, claim

    facts = {"method": Method.EXACT, "wrong": ("6",)}


    @claim("lemma 9.1.1", "Two and two are five [sic], x_1 & 100 %.", form="5", **facts)
    def two_and_two(form):
        """Count: {two} and \\\\two."""
        return Evidence(int(form) == 2 + 2, (f"counted 4, not {form}",))


    @claim("lemma 9.1.2", "Its process dies.", form="5", **facts)
    def dies(form):
        """It dies."""
        os._exit(3)


    @claim("lemma 9.1.3", "It raises.", form="five", **facts)
    def raises(form):
        """It raises."""
        return Evidence(int(form) == 5)


    @claim("lemma 9.1.4", "It prints, and holds.", form="4", printed="5", erratum="Five_.", **facts)
    def prints(form):
        """It prints."""
        print("noise on stdout")
        print("noise on stderr", file=sys.stderr)
        return Evidence(int(form) == 2 + 2, ("counted 4",))


    @claim("lemma 9.1.5", "It passes in print.", form="4", printed="5", erratum="Both pass.", **facts)
    def passes(form):
        """It always passes."""
        return Evidence(True, ("no look",))


    damage = {"erratum": "Hm.", "uncertain": True, "given": ("R3.2-2",)}


    @claim("lemma 9.2.1", "Surely.", form="4", printed="5", **damage, **facts)
    def damaged(form):
        """Count."""
        return Evidence(int(form) == 2 + 2, ("counted 4",))


    ours_it_is = {"erratum": "An earlier version: five.", "own": True}


    @claim("R9.3-1", "Four it is.", form="4", printed="5", **ours_it_is, **facts)
    def ours(form):
        """Two and two

        are counted,
        one by one.
        """
        return Evidence(int(form) == 2 + 2, ("counted 4",))


    @claim("lemma 9.1.10", "It is slow.", form="4", printed="6", erratum="Six.", slow=True, **facts)
    def slow(form):
        """It would be slow."""
        return Evidence(int(form) == 2 + 2, ("counted 4, slowly",))
'''


@pytest.fixture
def false_claims(tmp_path, monkeypatch):
    """A module of claims that the workers find, too; forgotten afterwards."""
    folder = tmp_path / "modules"
    folder.mkdir()
    (folder / "claims_that_fail.py").write_text(textwrap.dedent(FALSE), encoding="utf-8")
    monkeypatch.syspath_prepend(str(folder))
    registry = import_module("osculant.cas.claims.claim")._REGISTRY
    before = dict(registry)
    import_module("claims_that_fail")
    yield
    sys.modules.pop("claims_that_fail")
    registry.clear()
    registry.update(before)


def test_a_selection_from_python():
    parts: list[float] = []
    done = osculant.verify(QUICK, progress=parts.append)
    assert isinstance(done, Verification) and len(done) > 0
    assert [j.claim for j in done] == select([QUICK])
    assert done.failed == () and done.left_out == ()
    assert parts == sorted(parts) and parts[-1] == 1.0 and len(parts) == len(done)
    assert done[0] is done.judgements[0] and list(done[:1]) == [done[0]]
    assert sum(done.counts.values()) == len(done) and done.counts[Verdict.FAILS] == 0
    assert repr(done) == f"<Verification: {done.summary}>" and " 0 fail; " in done.summary
    assert json.loads(json.dumps(done.to_json()))[0]["id"] == done[0].claim.name


def test_the_results_are_in_the_order_of_the_thesis():
    last, first = (next(c for c in all_claims() if c.name == f"lemma 2.2.1.{part}") for part in (2, 1))
    assert [j.claim for j in osculant.verify(last.name, first.name)] == [first, last]


def test_a_chapter_may_be_a_number():
    names = [c.name for c in select([], chapter="2")]
    assert names and main(["verify", "--chapter", "2", "--list", "--json"]) == 0
    with pytest.raises(DomainError, match="chapter '77'"):
        osculant.verify(chapter=77)


def test_failures_are_told(false_claims):
    done = osculant.verify("9.1")
    verdicts = {j.claim.name: str(j.verdict) for j in done}
    assert verdicts == {
        "lemma 9.1.1": "fails",
        "lemma 9.1.2": "fails",
        "lemma 9.1.3": "fails",
        "lemma 9.1.4": "corrected",
        "lemma 9.1.5": "fails",
    }
    reasons = {j.claim.name: " ".join(report_claims.why(j)) for j in done.failed}
    assert reasons["lemma 9.1.1"] == "counted 4, not 5"
    assert reasons["lemma 9.1.2"] == "the process that checked it ended with status 3"
    assert "ValueError" in reasons["lemma 9.1.3"]
    assert "printed form passes" in reasons["lemma 9.1.5"]
    assert [c.name for c in done.left_out] == ["lemma 9.1.10"]
    assert "1 slow left out" in done.summary


def test_slow_claims_are_checked_if_asked_for_or_named(false_claims):
    assert len(osculant.verify("9.1.10")) == 1
    assert [j.claim.name for j in osculant.verify("9.1.4", "LEMMA 9.1.10")][-1] == "lemma 9.1.10"
    assert len(osculant.verify("9.1", slow=True)) == 6


def test_a_failure_is_status_1_and_is_told_below_the_table(false_claims, capfd, monkeypatch):
    monkeypatch.setenv("COLUMNS", "60")
    assert main(["verify", "lemma", "9.1"]) == 1
    output = capfd.readouterr()
    assert output.err == ""
    lines = output.out.splitlines()
    assert lines[0].split() == ["claim", "verdict", "statement"]  # too narrow for method and time
    assert re.fullmatch(r"lemma 9\.1\.1  fails +Two and two are .*…", lines[1])
    assert re.search(r"^lemma 9\.1\.4  corrected  It prints, and holds", output.out, re.MULTILINE)
    assert "lemma 9.1.2 fails: the process that checked it ended with status 3" in lines
    assert "left out, for --slow: lemma 9.1.10" in lines
    assert re.fullmatch(r"0 hold, 1 corrected, 0 open, 4 fail; 1 slow left out; [\d.]+ s", lines[-1])
    assert max(map(len, lines[:6])) <= 60 and "noise" not in output.out


def test_a_table_as_wide_as_the_terminal(capsys, monkeypatch):
    for width in (40, 80, 120):
        monkeypatch.setenv("COLUMNS", str(width))
        assert main(["verify", QUICK]) == 0
        lines = capsys.readouterr().out.splitlines()
        assert ("method" in lines[0]) == (width >= 80)
        assert max(map(len, lines)) <= width + 4  # accents take no column
        assert all(line == line.rstrip() for line in lines)


def test_json_and_nothing_else(capfd):
    assert main(["verify", "lemma", QUICK, "--json"]) == 0
    output = capfd.readouterr()
    assert output.err == ""
    data = json.loads(output.out)
    assert [row["id"] for row in data] == [c.name for c in select(["lemma " + QUICK])]
    for row in data:
        assert row["verdict"] == "holds" and row["method"] == "symbolic proof"
        assert row["certificate"] and row["statement"] and row["derivation"] and row["seconds"] >= 0
        assert row["printed"] is row["corrected"] is None


def test_json_of_an_erratum(false_claims, capfd):
    assert main(["verify", "9.1.4", "9.1.5", "--json"]) == 1
    corrected, failed = json.loads(capfd.readouterr().out)
    assert corrected["verdict"] == "corrected" and failed["verdict"] == "fails"
    assert (corrected["printed"], corrected["corrected"]) == ("5", "4")
    assert corrected["against_printed"] == ["counted 4"] and corrected["chapter"] == "9"


def test_show(false_claims, capsys):
    assert main(["verify", "--show", "9.1.4", "--show", "9.1.1"]) == 1
    blocks = capsys.readouterr().out.split("\n\n")
    assert re.match(
        r"claim +lemma 9\.1\.1\nstatement +Two and two are five \[sic\], x_1 & 100 %\.\n", blocks[0]
    )
    assert re.search(r"^derivation +Count: \{two\} and \\two\.$", blocks[0], re.MULTILINE)
    assert re.search(r"^certificate +counted 4, not 5$", blocks[0], re.MULTILINE)
    assert re.search(r"^verdict +corrected, .* s$", blocks[1], re.MULTILINE)
    assert re.search(r"^printed +5\ncorrected +4\nerratum +Five_\.$", blocks[1], re.MULTILINE)


def test_show_breaks_long_lines(capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "60")
    assert main(["verify", "--show", "lemma 2.2.1"]) == 0
    assert max(map(len, capsys.readouterr().out.splitlines())) <= 75  # formulas are not broken


def test_the_list_checks_nothing(false_claims, capsys):
    assert main(["verify", "9.1", "--list"]) == 0
    output = capsys.readouterr().out
    assert re.search(r"^lemma 9\.1\.10  exact +erratum, slow  It is slow\.$", output, re.MULTILINE)
    assert output.endswith("\n6 claims\n")
    assert main(["verify", "9.1.4", "--list", "--json"]) == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert row["id"] == "lemma 9.1.4" and "verdict" not in row and row["wrong"] == ["6"]


@pytest.mark.parametrize(
    "arguments, says",
    [
        (["theorem", "2.2.1.1"], r"'theorem 2\.2\.1\.1': did you mean 'lemma 2\.2\.1\.1'"),
        (["2.2.1", "nothing"], "'nothing': `osculant verify --list`"),
        (["--chapter", "77"], "chapter '77': choose one of"),
        (["--chapter", "A", "lemma 2.2.1"], "No claim in chapter A"),
        (["--chapter", "3.5"], r"3\.5 is a section, not a chapter: .*`osculant verify 3\.5`"),
        (["--chaptr", "2"], "'--chaptr': did you mean --chapter"),
        (["--errata", "a.txt"], r"Cannot write a\.txt: .*\.tex"),
        (["--errata", ""], r"without a name"),
        (["--errata", "none/a.tex"], "there is no folder"),
        ([QUICK, "--errata", "a.tex"], r"Did not write a\.tex: there is no erratum"),
        (["--show"], "--show needs a value"),
    ],
)
def test_mistakes_are_one_sentence(arguments, says, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["verify", *arguments]) == 2
    output = capsys.readouterr()
    assert output.out == "" and re.fullmatch(r"osculant: .*[.?]\n", output.err)
    assert re.search(says, output.err)


def test_names_of_two_words_need_no_quotes():
    assert joined(["lemma", "2.2.1", "all"]) == ["lemma 2.2.1", "all"]
    assert joined(["all"]) == ["all"] and joined([]) == [] and joined(["A"]) == ["A"]
    assert joined(["All", "2.2.1"]) == ["All", "2.2.1"]


def test_all_wins(capsys):
    assert main(["verify", "all", QUICK, "--list"]) == 0
    assert capsys.readouterr().out.endswith(f"\n{len(all_claims())} claims\n")


def test_ascii_output_has_question_marks_and_json_escapes():
    def output(*options: str, encoding: str) -> str:
        command = [sys.executable, "-m", "osculant", "verify", QUICK, "--list", *options]
        done = subprocess.run(
            command,
            env={**os.environ, "PYTHONIOENCODING": encoding, "COLUMNS": "120"},
            capture_output=True,
            check=True,
        )
        return done.stdout.decode(encoding)

    assert "satisfy dr/ds = ?^(1/3)." in output(encoding="ascii")
    plain, letters = output("--json", encoding="ascii"), output("--json", encoding="utf-8")
    assert json.loads(plain) == json.loads(letters) and "\\u03ba" in plain and "κ" in letters


def test_an_interruption_is_told(capsys, monkeypatch):
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("osculant.thesis.verification.check", interrupted)
    assert main(["verify", QUICK]) == 130
    output = capsys.readouterr()
    assert output.out == "" and output.err == "osculant: interrupted\n"


def test_the_summary_tells_evidence_from_proof():
    def judged(name: str, verdict: Verdict, method: Method, *given: str) -> Judgement:
        found = Claim(name, "", method, lambda form: Evidence(True), "", given=given)
        return Judgement(found, verdict, Evidence(True), None, 0.0)

    rows = (
        judged("a", Verdict.HOLDS, Method.PROOF),
        judged("b", Verdict.HOLDS, Method.NUMERICAL),
        judged("c", Verdict.HOLDS, Method.PROOF, "R4.6-3", "no such claim"),
        judged("d", Verdict.CORRECTED, Method.NUMERICAL),
        judged("e", Verdict.OPEN, Method.NUMERICAL),
    )
    assert [rests_on_evidence(row.claim) for row in rows] == [False, True, True, True, True]
    assert Verification(rows, (), 1).summary == (
        "3 hold (2 by numerical evidence), 1 corrected (1 by numerical evidence), 1 open, 0 fail; 1 s"
    )


def test_what_is_given_and_uncertain_is_told(false_claims, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "120")
    assert main(["verify", "9.2.1"]) == 0
    assert re.search(
        r"^lemma 9\.2\.1  corrected  exact, given R3\.2-2 ", capsys.readouterr().out, re.MULTILINE
    )
    assert main(["verify", "9.2.1", "--list"]) == 0
    assert "exact, given R3.2-2  erratum, uncertain  Surely." in capsys.readouterr().out
    assert main(["verify", "--show", "9.2.1"]) == 0
    output = capsys.readouterr().out
    assert re.search(r"^uncertain +the print is known from a damaged text", output, re.MULTILINE)
    assert re.search(r"^method +exact computation, given R3\.2-2$", output, re.MULTILINE)
    assert main(["verify", "9.2.1", "--json"]) == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert row["uncertain"] is True and row["given"] == ["R3.2-2"]


def test_errata_are_written(false_claims, tmp_path, capsys):
    target = tmp_path / "errata.tex"
    assert main(["verify", "9.1", "2.2.1", "--errata", str(target)]) == 1
    assert f"written: {target}" in capsys.readouterr().out
    text = target.read_text(encoding="ascii")
    assert text.startswith(r"\documentclass") and text.endswith("\\end{document}\n")
    assert r"\subsection*{Lemma 9.1.4}" in text and r"\item[Verdict] \textbf{corrected}" in text
    assert r"\item[Form printed] \ensuremath{5}" in text and r"\item[Form correct] \ensuremath{4}" in text
    assert r"\item[Correct] It prints, and holds." in text and "damaged" not in text
    assert r"\item[Verdict] \textbf{not checked}" in text and "9.1.1}" not in text
    assert r"Five\_." in text


def test_uncertain_errata_have_a_section(false_claims, tmp_path):
    target = tmp_path / "errata.tex"
    assert main(["verify", "9.2.1", "9.1.4", "--errata", str(target)]) == 0
    certain, uncertain = target.read_text(encoding="ascii").split(r"\section*{Readings of a damaged text}")
    assert "Lemma 9.1.4" in certain and "Lemma 9.2.1" not in certain
    assert "Lemma 9.2.1" in uncertain and "exact computation, given R3.2-2" in uncertain


def test_errata_of_our_own_have_a_section_and_a_word(false_claims, tmp_path, capsys):
    target = tmp_path / "errata.tex"
    assert main(["verify", "9.3", "9.2.1", "9.1.4", "--errata", str(target)]) == 0
    thesis, own = target.read_text(encoding="ascii").split(r"\section*{Errata of osculant}")
    assert "R9.3-1" in own and "9.3-1" not in thesis and "Lemma 9.1.4" in thesis and "Lemma 9.2.1" in thesis
    assert r"\item[Form claimed earlier] \ensuremath{5}" in own and "Form printed" not in own
    capsys.readouterr()
    assert main(["verify", "9.3", "9.1.4", "--list"]) == 0
    listed = capsys.readouterr().out
    assert re.search(r"^R9\.3-1 .* own erratum ", listed, re.MULTILINE)
    assert re.search(r"^lemma 9\.1\.4 .*  erratum ", listed, re.MULTILINE)
    assert main(["verify", "--show", "9.3-1"]) == 0
    shown = capsys.readouterr().out
    assert re.search(r"^earlier +5\ncorrected +4\nerratum +An earlier version: five\.$", shown, re.MULTILINE)
    assert re.search(r"^derivation +Two and two\n +are counted, one by one\.$", shown, re.MULTILINE)


def test_forms_are_shown_as_formulas_and_the_identity_that_was_proved(capsys):
    assert main(["verify", "--show", "X3.2-13"]) == 0
    shown = capsys.readouterr().out
    assert re.search(r"^form +\(dk/dr\) v²$", shown, re.MULTILINE) and "**" not in shown
    assert " = 0 identically" in shown


def test_errata_tell_how_far_they_are(false_claims, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("osculant.cli.output.PATIENCE", 0.0)
    monkeypatch.setattr("osculant.cli.output.PAUSE", 0.0)
    assert main(["verify", "9.1.4", "9.2.1", "--errata", str(tmp_path / "a.tex")]) == 0
    assert re.fullmatch(
        r"osculant: verifying: 50% done\nosculant: verifying: 100% done\n", capsys.readouterr().err
    )
    assert main(["verify", "9.1.4", "9.2.1"]) == 0
    assert capsys.readouterr().err == ""


def test_errata_alone_check_only_claims_with_an_erratum(tmp_path, capsys, monkeypatch):
    seen = []

    def check(claims, left_out, progress):
        seen.extend(claims)
        return Verification((), tuple(claims), 0.0)

    monkeypatch.setattr("osculant.thesis.verification.check", check)
    assert main(["verify", "--errata", str(tmp_path / "a.tex")]) == 0
    assert seen == [c for c in ERRATA if not c.slow] and len(seen) >= 5
    assert (tmp_path / "a.tex").read_text().count("\\subsection*") == len(seen)


def test_claims_are_found_without_the_heavy_rooms():
    code = "import sys, osculant; osculant.verify; print(*sys.modules)"
    light = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert {"sympy", "numba", "flint", "rich"}.isdisjoint(light.stdout.split())


@pytest.mark.slow
def test_all_claims_in_three_minutes():
    done = osculant.verify("all")
    assert done.failed == () and len(done) >= 60
    assert done.seconds < 180
