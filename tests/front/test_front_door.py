from __future__ import annotations

import subprocess
import sys
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
    with pytest.raises(AttributeError, match="no attribute 'curves'"):
        _ = osculant.curves


@pytest.mark.parametrize("room", ["cas", "codegen", "kernels"])
def test_rooms_are_real_folders_seen_through_links(room):
    link = FOLDER / room
    assert link.is_dir()
    assert (FOLDER.parent / room).resolve() == link.resolve()


def test_the_front_door_is_lazy():
    heavy = "{'sympy', 'symengine', 'numba', 'llvmlite', 'flint', 'matplotlib'}"
    code = f"import sys, osculant, osculant.cas.errors; print(sorted(set(sys.modules) & {heavy}))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
