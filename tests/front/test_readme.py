"""README.md and docs/ say what is so: every command is run, every output compared."""

import doctest
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from osculant.cli.main import main

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
GUIDE = (ROOT / "docs" / "guide.md").read_text(encoding="utf-8")
(ONE_LINERS,) = re.findall(r"```sh\n(.*?)```", README, re.DOTALL)


@pytest.mark.parametrize("line", ONE_LINERS.splitlines())
def test_the_one_liners_run(line, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    command, *arguments = shlex.split(line)
    if command == "python":
        done = subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=True)
        assert done.stdout
        return
    assert command == "osculant" and main(arguments) == 0
    assert Path(arguments[arguments.index("--write") + 1]).stat().st_size > 100


@pytest.mark.parametrize("block", re.findall(r"```\n\$ osculant (.*?)```", GUIDE, re.DOTALL))
def test_the_guide_shows_real_output(block, tmp_path, capsys, monkeypatch):
    if block.startswith("compile ") and shutil.which("cc") is None:
        pytest.skip("there is no C compiler cc")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "116")
    Path("out").mkdir()
    command, shown = block.split("\n", maxsplit=1)
    assert main(shlex.split(command)) == 0

    def fixed(text: str) -> str:  # all but the time, and digits that may depend on the machine
        text = re.sub(r" +[\d.]+ s\b", " … s", text)
        return re.sub(r"^(time +).*$|(?<=9\.99999)\d+", r"\1", text, flags=re.MULTILINE)

    assert fixed(capsys.readouterr().out) == fixed(shown)


def test_the_guide_calls_python_as_it_is():
    sessions = re.findall(r"```python\n(.*?)```", GUIDE, re.DOTALL)
    assert sessions
    for session in sessions:
        test = doctest.DocTestParser().get_doctest(session, {}, "guide.md", None, 0)
        assert test.examples and doctest.DocTestRunner().run(test).failed == 0


@pytest.mark.parametrize("page", [ROOT / "README.md", ROOT / "docs" / "guide.md"], ids=lambda page: page.name)
def test_links_lead_somewhere(page):
    for link in re.findall(r"\]\(([^)#]+)", page.read_text(encoding="utf-8")):
        assert link.startswith("http") or (page.parent / link).exists(), link
