from __future__ import annotations

import ast
import os
import subprocess
import sys
import tomllib
from importlib import import_module
from pathlib import Path

import pytest

import osculant

FOLDER = Path(osculant.__file__).parent


def test_no_module_hides_a_public_name():
    modules = {path.stem for path in FOLDER.iterdir()}
    assert modules.isdisjoint(osculant.__all__)


def test_every_public_name_has_a_home_and_can_be_had():
    for name in osculant.__all__:
        assert getattr(osculant, name).__name__ == name
    assert set(osculant.__all__) <= set(dir(osculant))


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'splines'"):
        _ = osculant.splines


@pytest.mark.parametrize("room", ["cas", "codegen", "kernels"])
def test_rooms_are_real_folders_seen_through_links(room):
    link = FOLDER / room
    assert link.is_dir()
    assert (FOLDER.parent / room).resolve() == link.resolve()


def test_the_version_is_that_of_the_distribution():
    settings = tomllib.loads((FOLDER.parent / "pyproject.toml").read_text(encoding="utf-8"))
    assert "version" in settings["project"]["dynamic"]
    home, _, name = settings["tool"]["setuptools"]["dynamic"]["version"]["attr"].rpartition(".")
    assert getattr(import_module(home), name) == osculant.__version__


def imported(path: Path) -> set[str]:
    """The modules that a file imports at any time, and what of them."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
    return found


def test_nobody_inside_comes_in_by_the_front_door():
    walk = os.walk(FOLDER, followlinks=True)
    inside = [Path(folder, name) for folder, _, names in walk for name in names if name.endswith(".py")]
    assert len(inside) > 200
    door = {"osculant", *(f"osculant.{name}" for name in [*osculant.__all__, "__version__"])}
    assert [path for path in inside if door & imported(path)] == []


def test_the_front_door_is_lazy():
    heavy = "{'sympy', 'symengine', 'numba', 'llvmlite', 'flint', 'matplotlib'}"
    code = f"import sys, osculant, osculant.cas.errors; print(sorted(set(sys.modules) & {heavy}))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
