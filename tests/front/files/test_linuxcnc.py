"""Programs run by LinuxCNC's own interpreter, where there is one: `rs274`, or what OSCULANT_RS274 names.

It prints canonical motions with four decimals: points of them are compared with the curve.
"""

from __future__ import annotations

import math
import os
import re
import shutil
import subprocess

import numpy as np
import pytest

import osculant as osc
from tests.front.files.machine import two_sided
from tests.front.files.test_kept import CURVES, sampled

RS274 = os.environ.get("OSCULANT_RS274") or shutil.which("rs274")
pytestmark = pytest.mark.skipif(RS274 is None, reason="LinuxCNC's rs274 is not installed (linuxcnc-uspace)")
#: the last digit of canonical motions
DIGIT = 1e-4
AXES = {"XY": (0, 1, 2), "YZ": (1, 2, 0), "XZ": (2, 0, 1)}


def run(path, folder):
    """The canonical motions of a program; a refusal fails."""
    (folder / "tool.tbl").touch()
    (folder / "var.var").touch()
    command = [RS274, "-g", "-t", folder / "tool.tbl", "-v", folder / "var.var", path]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60, cwd=folder)
    assert done.returncode == 0, done.stdout[-300:] + done.stderr[-300:]
    assert "PROGRAM_END" in done.stdout
    return re.findall(r"^\s*\d+\s+N\S*\s+(\w+)\(([^)]*)\)", done.stdout, re.MULTILINE)


def points_of(motions, dimension):
    """Points along them, and how many there are."""
    here, plane, found, count = None, AXES["XY"], [], 0
    for word, text in motions:
        numbers = [float(number) for number in text.split(",")] if "FEED(" in f"{word}(" else []
        if word == "SELECT_PLANE":
            plane = AXES[text.rpartition("_")[2]]
        elif word == "STRAIGHT_TRAVERSE":
            here = np.array([float(number) for number in text.split(",")[:3]])
        elif word == "STRAIGHT_FEED":
            there, count = np.array(numbers[:3]), count + 1
            found.append(here + np.linspace(0, 1, 101)[:, None] * (there - here))
            here = there
        elif word == "ARC_FEED":
            a, b, c = plane
            first, second, centre_first, centre_second, turns, height = numbers[:6]
            begun = math.atan2(here[b] - centre_second, here[a] - centre_first)
            ended = math.atan2(second - centre_second, first - centre_first)
            turned = (ended - begun) % math.tau - (0 if turns > 0 else math.tau)
            f = np.linspace(0, 1, 1001)
            radius = np.hypot(first - centre_first, second - centre_second)
            points = np.empty((len(f), 3))
            points[:, a] = centre_first + radius * np.cos(begun + f * turned)
            points[:, b] = centre_second + radius * np.sin(begun + f * turned)
            points[:, c] = here[c] + f * (height - here[c])
            found.append(points)
            here, count = points[-1], count + 1
    return np.concatenate(found)[:, :dimension], count


@pytest.mark.parametrize(
    ("name", "primitive", "tolerance", "decimals"),
    [
        ("trochoid", "biarc", 1e-2, 3),
        ("trochoid", "biarc", 1e-3, 3),
        ("ellipse", "biarc", 1e-2, 3),
        ("ellipse", "biarc", 1e-3, 3),
        ("spiral", "polygon", 1e-2, None),
        ("cone", "bihelix", 1e-2, None),
        ("torus knot", "bihelix", 1e-2, None),
    ],
)
def test_programs_run_to_their_end_and_keep_the_tolerance(name, primitive, tolerance, decimals, tmp_path):
    path, options = tmp_path / "a.ngc", {"units": "mm"} | ({} if decimals is None else {"decimals": decimals})
    spline = osc.approximate(osc.curve(*CURVES[name]), primitive, tolerance, files={path: options})
    file = spline.write(path, **options)
    motions = run(path, tmp_path)
    assert ("SET_FEED_RATE", "600.0000") in motions
    points, count = points_of(motions, spline.chain.dimension)
    assert count == file.moves
    # of centres far away a digit counts more
    assert two_sided(points, sampled(name)) <= tolerance + 20 * DIGIT


def test_a_program_without_a_feed_rate_is_refused_there(tmp_path):
    """So the motions before were not run for nothing."""
    path = tmp_path / "a.ngc"
    osc.approximate(osc.curve("t, t^2", 0, 1), "biarc", 1e-2, files=path).write(path)
    text = path.read_text()
    path.write_text(re.sub(r" F[\d.]+$", "", text, flags=re.MULTILINE))
    with pytest.raises(AssertionError, match="zero feed rate"):
        run(path, tmp_path)
