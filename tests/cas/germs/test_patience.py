"""The time that a question takes is bounded by its patience, other processes and the expansion included."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.model_reading import HIGH, model_of
from osculant.cas.germs.polynomials import LARGEST
from osculant.cas.germs.processes import counted, processor_time
from osculant.cas.germs.search import Patience
from osculant.germs.map_germ import germ
from osculant.germs.report import report

#: seconds for the start of processes and of modules
START = 1.0


@pytest.mark.parametrize(
    ("text", "source"),
    [("asin(x)**2, asin(y)**2, 0", "x y"), ("abs(1+x)*x**2*(x+asin(y))**2, y**4*x", "x y")],
)
def test_undecided_germs_keep_their_patience(text, source):
    seconds = 3.0
    begun = processor_time()
    data = report(germ(text, source, patience=seconds), "A")
    assert "codimension" in data["undecided"]
    assert processor_time() - begun < 1.2 * seconds + START


def test_helpers_count():
    begun = processor_time()
    script = "import time\nwhile time.process_time() < 0.6: pass\nprint('done', flush=True)\ninput()"
    helper = subprocess.Popen(
        [sys.executable, "-c", script], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    cost = counted(helper.pid)
    assert helper.stdout is not None and helper.stdout.readline() == "done\n"
    assert processor_time() - begun > 0.5
    cost.ended()
    taken = cost.seconds()
    helper.communicate("\n")
    cost.ended(100.0)  # it is known already
    assert cost.seconds() == taken
    assert 0.5 < processor_time() - begun < 10


def test_waiting_ends_with_the_patience():
    patience = Patience(0.5)
    begun = time.monotonic()
    with pytest.raises(UndecidedError):
        codimension(Germ("asin(x)**2, asin(y)**2, 0", "x y"), "A", patience=patience)
    assert patience.spent() < 0.5 * 1.2 + START
    assert time.monotonic() - begun < 30


@pytest.mark.parametrize(
    ("text", "group", "value", "degree"),
    [
        ("x**3*(1 + x + y)**3000 + y**2", "R", 2, 3),
        ("x**2*(1 + x + y)**3000", "R", "infinite", "infinite"),
        ("y**3*(1 + x*y)**-700 + x**4*(2 - y)**900", "K", 6, 4),
        ("x, y**2*(1 + x + y)**2000", "A", 0, 2),
        ("x, y**3*(2 + x*y)**-500", "A", "infinite", "infinite"),
    ],
)
def test_high_powers_are_not_expanded(text, group, value, degree):
    f = Germ(text, "x y")
    begun = processor_time()
    assert f.polynomial(LARGEST) is None
    assert codimension(f, group, extended=True).value == value
    assert determinacy(f, group).degree == degree
    assert processor_time() - begun < 5


@pytest.mark.parametrize(("inner", "e"), [("1 + x", 2), ("3 + x + y**2", 40), ("x", 4000), ("x*y", 2000)])
def test_powers_that_are_cheap_are_expanded(inner, e):
    f = Germ(f"x*({inner})**{e}", "x y")
    jet = f.polynomial(LARGEST)
    assert jet is not None and jet == f.jet(LARGEST)


def test_high_powers_of_units_are_functions_of_the_model():
    model = model_of(Germ(f"y*(1 + x)**{HIGH + 1000}*(1 + x + y)**{HIGH + 2000}", "x y"))
    assert model is not None and model.extra == 2
    assert model_of(Germ("y*(1 + x)**20", "x y")).extra == 0


def test_helpers_end_with_the_process_that_asked_them():
    script = (
        "from osculant.cas.germs.geometry import Geometry\n"
        "from osculant.cas.germs.germ import Germ\n"
        "from osculant.cas.germs.groups import group\n"
        "g = Geometry(Germ('(x**2+x*y+y*z+z**2-x**3)**2+x**7+y**6*z+(x*y*z)**4', 'x y z'), group('R'))\n"
        "g.start()\n"
        "print(g.process.pid, flush=True)\n"
        "input()"
    )
    asking = subprocess.Popen(
        [sys.executable, "-c", script], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert asking.stdout is not None
    helper = int(asking.stdout.readline())
    os.kill(helper, 0)  # it is there
    asking.kill()
    asking.communicate()
    for _ in range(100):
        time.sleep(0.1)
        try:
            os.kill(helper, 0)
        except ProcessLookupError:
            return
        if Path(f"/proc/{helper}/stat").read_text().rpartition(")")[2].split()[0] == "Z":
            return  # ended, but nobody has noticed yet
    pytest.fail("the helper is still there")
