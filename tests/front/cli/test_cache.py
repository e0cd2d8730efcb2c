"""`osculant cache`: what is kept, and that nothing but osculant's own is removed."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

from osculant.cli.main import main

#: a process that compiles a kernel, waits, and compiles another
COMPILING = """
from osculant.kernels.curves.vectors import dot, norm
print(dot((1.0, 2.0, 3.0), (4.0, 5.0, 6.0)), flush=True)
input()
print(norm((2.0, 3.0, 6.0)), dot((1.0, 0.0, 0.0), (1.0, 0.0, 0.0)))
"""
#: folders that osculant makes, and others that it must leave alone
OURS = ("kernels-0123456789abcdef", "kernels-conics-0123456789abcdef")
OTHERS = ("kernels-mine", "kernels-0123456789abcde", "photos", "kernels-0123456789ABCDEF")


@pytest.fixture
def root(tmp_path, monkeypatch):
    monkeypatch.setenv("OSCULANT_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def cache(capsys, *arguments: str) -> dict:
    assert main(["cache", *arguments, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_a_cache_that_is_not_there(root, capsys):
    kept = cache(capsys)
    assert kept == {"version": 1, "folder": str(root), "files": 0, "bytes": 0}
    assert cache(capsys, "clear") == {**kept, "removed_files": 0, "removed_bytes": 0}
    assert not root.exists()


def test_only_what_osculant_made_is_removed(root, capsys, tmp_path):
    for name in (*OURS, *OTHERS):
        (root / name / "deeper").mkdir(parents=True)
        (root / name / "deeper" / "a.nbc").write_bytes(b"12345")
    (root / "kernels-fedcba9876543210").symlink_to(root / "photos")
    (root / "kernels-aaaaaaaaaaaaaaaa").write_text("a file")
    assert cache(capsys)["files"] == len(OURS)
    assert main(["cache"]) == 0
    assert capsys.readouterr().out == f"folder  {root}\nkept    2 files, 0.0 MB\n"
    done = cache(capsys, "clear")
    assert (done["files"], done["removed_files"], done["removed_bytes"]) == (0, len(OURS), 5 * len(OURS))
    assert not any((root / name).exists() for name in OURS)
    assert all((root / name / "deeper" / "a.nbc").exists() for name in OTHERS)
    assert (root / "kernels-fedcba9876543210").is_symlink()
    assert (root / "kernels-aaaaaaaaaaaaaaaa").exists()


def test_what_cannot_be_removed_is_told(root, capsys, monkeypatch):
    (root / OURS[0]).mkdir(parents=True)
    (root / OURS[0] / "a.nbc").write_bytes(b"12345")
    monkeypatch.setattr("shutil.rmtree", lambda *_, **__: None)  # the superuser may remove anything
    assert main(["cache", "clear"]) == 2
    output = capsys.readouterr()
    assert output.out == "" and f"Could not clear all of {root}: left are 1 file, 0.0 MB" in output.err


def test_an_unknown_action_is_a_mistake(root, capsys):
    assert main(["cache", "claer"]) == 2
    assert capsys.readouterr().err == "osculant: There is no action 'claer': did you mean clear?\n"


def test_a_process_that_runs_goes_on_and_keeps_again(root, capsys):
    with subprocess.Popen(
        [sys.executable, "-c", COMPILING], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout.readline() == "32.0\n"
        done = cache(capsys, "clear")
        assert done["removed_files"] > 0 and done["files"] == 0
        assert process.communicate("\n")[0] == "7.0 1.0\n"
    assert process.returncode == 0
    assert cache(capsys)["bytes"] > 0
