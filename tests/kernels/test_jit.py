"""Machine code on disk: folders for families, whose names know the sources; damaged files are no cache."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from numba.core import event

from osculant.kernels import jit
from osculant.kernels.curves.vectors import dot

FAMILIES = ("conics", "biarcs", "bihelices", "polygons", "curves")
#: files, and the families whose machine code they are part of
TOUCHED = {
    "conics/minimax.py": {"conics"},
    "conics/scan.py": {"conics"},
    "biarcs/family.py": {"biarcs"},
    "bihelices/foot.py": {"bihelices"},
    "curves/peaks.py": {"conics", "biarcs", "curves"},
    "curves/plane.py": {"conics", "biarcs", "polygons", "curves"},
    "curves/space.py": {"bihelices", "polygons", "curves"},
    "generated/laws.py": {"conics", "biarcs", "bihelices", "polygons"},
    "polygons/chords.py": {"polygons"},
    "search.py": set(FAMILIES),
    "jit.py": set(FAMILIES),
}

IMPORT_ALL = """
import importlib, pathlib, sys
from osculant.kernels import jit
for path in sorted(jit.ROOM.rglob("*.py")):
    name = ".".join([jit.PACKAGE, *path.relative_to(jit.ROOM).with_suffix("").parts])
    importlib.import_module(name.removesuffix(".__init__"))
"""

LOADED = """
import importlib, json, sys
from osculant.kernels import jit
for name in jit.modules_of(sys.argv[1]):
    importlib.import_module(name.removesuffix(".__init__"))
print(json.dumps([sys.modules[name].__file__ for name in sys.modules if name.startswith(jit.PACKAGE + ".")]))
"""

# generic kernels, kernels of the family and of the curves: more of them than versions are kept
SEVERAL = """
import numpy as np
from osculant.codegen.jets import compile_jet
from osculant.cas.formulas.parser import parse_tuple
from osculant.kernels import course, jit, quadrature
from osculant.kernels.conics import pencil
from osculant.kernels.conics.records import Conic

from osculant.kernels.curves.plane import Frame, Place
jit.when_compiling(lambda: print("compiling"))
jet, table = compile_jet(parse_tuple("t, t^2 + t^3"), 5), np.empty((99, 3))
second = compile_jet(parse_tuple("t, t^2 + t^3"), 2)
edges, place = np.linspace(0.0, 1.0, 17), Place(0.0, 0.0, 1.0, 1.0, 1e-15)
count = course.lay_out(Conic(), second.address, place, edges, table)
print(count, course.turns(table[:count], 0.0, 1.0), course.resolving(table[:count], 0.0, 1.0, 8))
print(quadrature.predicted(Conic(), jet.address, 1.0, 0.0, 1.0))
print(pencil.pencil(Frame(0.0, 0.0, 1.0, 0.0), Frame(1.0, 1.0, 0.0, 1.0), 1e-15))
"""


def python(code, cache, *arguments):
    """What code prints in a process of its own with that cache folder."""
    environment = {**os.environ, "OSCULANT_CACHE": str(cache), "OSCULANT_PREBUILT": "no"}
    command = [sys.executable, "-c", code, *arguments]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """An empty cache folder of this process."""
    monkeypatch.setenv("OSCULANT_CACHE", str(tmp_path / "cache"))
    jit.folder_of.cache_clear()
    yield tmp_path / "cache"
    jit.folder_of.cache_clear()


@pytest.mark.parametrize("file", TOUCHED)
def test_an_edit_touches_the_families_that_use_the_file(file, tmp_path, monkeypatch):
    shutil.copytree(jit.ROOM, tmp_path / "kernels", ignore=shutil.ignore_patterns("__pycache__"))
    before = {family: jit.fingerprint(family) for family in FAMILIES}
    monkeypatch.setattr(jit, "ROOM", tmp_path / "kernels")
    assert {family: jit.fingerprint(family) for family in FAMILIES} == before
    edited = tmp_path / "kernels" / file
    edited.write_text(edited.read_text(encoding="utf-8") + "#\n", encoding="utf-8")
    assert {family for family in FAMILIES if jit.fingerprint(family) != before[family]} == TOUCHED[file]


@pytest.mark.parametrize("family", FAMILIES)
def test_sources_are_what_is_imported(family, tmp_path):
    loaded = {Path(file) for file in json.loads(python(LOADED, tmp_path, family))}
    found = set(jit.sources(jit.modules_of(family)))
    inits = {path for path in loaded if path.name == "__init__.py"}
    assert loaded - inits == {path for path in found if path.name != "__init__.py"}
    assert len(loaded) > 10


def test_importing_kernels_makes_no_folder(tmp_path):
    python(IMPORT_ALL, tmp_path / "cache")
    assert not (tmp_path / "cache").exists()


def test_new_processes_find_everything_on_disk(tmp_path):
    first, second = python(SEVERAL, tmp_path), python(SEVERAL, tmp_path)
    assert first == "compiling\n" + second
    assert second.count("\n") == 3
    folders = sorted(re.sub("-[0-9a-f]{16}$", "", folder.name) for folder in tmp_path.iterdir())
    assert folders == ["kernels-conics", "kernels-generic"]


def test_old_versions_go(cache):
    for age in range(6):
        for family in ("conics", "biarcs"):
            folder = cache / f"kernels-{family}-{age:016x}"
            folder.mkdir(parents=True)
            os.utime(folder, (1e9 - age, 1e9 - age))
    assert jit.folder_of("conics").name == f"kernels-conics-{jit.fingerprint('conics')}"
    kept = {folder.name for folder in cache.glob("kernels-conics-*")}
    assert kept == {jit.folder_of("conics").name, *(f"kernels-conics-{age:016x}" for age in range(2))}
    assert len(kept) == jit.KEPT_VERSIONS
    assert len(list(cache.glob("kernels-biarcs-*"))) == 6


def fresh_dot():
    """⟨a, b⟩ by machine code that is not in this process yet, and how often it came from disk."""
    kernel = jit.Kernel(dot.__wrapped__)
    value = kernel((1.0, 2.0, 3.0), (4.0, 5.0, 6.0))
    (face,) = kernel._faces.values()
    return value, sum(face.stats.cache_hits.values())


def test_damaged_entries_are_no_cache(cache):
    assert fresh_dot() == (32.0, 0)
    assert fresh_dot() == (32.0, 1)
    for kind in ("nbi", "nbc"):
        for damage in (lambda data: b"", lambda data: data[: len(data) // 2], lambda data: b"\x80\xff" * 99):
            files = list(cache.rglob(f"*.{kind}"))
            assert files
            for file in files:
                file.write_bytes(damage(file.read_bytes()))
            assert fresh_dot() == (32.0, 0)
            shutil.rmtree(cache)  # made anew, as damaged files are not
            jit.folder_of.cache_clear()
            assert fresh_dot() == (32.0, 0)
            assert fresh_dot() == (32.0, 1)


def test_a_home_that_cannot_be_written_costs_only_the_cache(tmp_path, cache, monkeypatch):
    cache.write_text("a file", encoding="utf-8")
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "elsewhere"))
    assert fresh_dot() == (32.0, 0)
    assert cache.read_text(encoding="utf-8") == "a file"
    assert list((tmp_path / "elsewhere").rglob("*.nbi"))


def test_the_notice_of_compiling_is_given_once(cache):
    told = []
    jit.when_compiling(lambda: told.append("first"))
    jit.when_compiling(lambda: told.append("last"))  # in the place of the first
    assert told == []
    assert fresh_dot() == (32.0, 0)
    assert fresh_dot() == (32.0, 1)
    assert told == ["last"]
    shutil.rmtree(cache)
    jit.folder_of.cache_clear()
    assert fresh_dot() == (32.0, 0)
    assert told == ["last"]


def test_the_clock_runs_while_anything_is_compiled():
    clock = jit.CompileClock()
    jit.numba()
    with jit.watching(clock):
        with event.trigger_event("numba:compile"):
            with event.trigger_event("numba:compile"):
                assert clock.running
            assert clock.running and clock.seconds == 0
        assert not clock.running and clock.seconds > 0
        before = clock.seconds
    with event.trigger_event("numba:compile"):
        assert not clock.running
    assert clock.seconds == before
