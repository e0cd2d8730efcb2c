"""Every file within its tolerance, measured from its text by readers that share no code with its writer."""

from __future__ import annotations

import io
import math
import xml.etree.ElementTree as ET

import ezdxf
import numpy as np
import pytest
import sympy
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import osculant as osc
from osculant.cas.errors import OsculantError, ToleranceError
from tests.front.files.machine import along, interpret, path_of, two_sided

SVG = "{http://www.w3.org/2000/svg}"
#: how much larger than they are distances of polygons may be, in parts
FINE = 1e-3
CURVES = {
    "cone": ("t*cos(t), t*sin(t), t", "pi/6", "2*pi"),
    "twisted cubic": ("t, t^2, t^3", "0", "1"),
    "torus knot": ("cos(t)*(3+cos(5*t)), sin(t)*(3+cos(5*t)), sin(5*t)", "0", "2*pi"),
    "circle": ("10*cos(t), 10*sin(t)", "0", "5"),
    "trochoid": ("0.5*t/(2*pi)+2*cos(t), 2*sin(t)", "0", "6*pi"),
    "spiral": ("t*cos(t), t*sin(t)", "pi/6", "2*pi"),
    "ellipse": ("1000*cos(t), 800*sin(t)", "0", "2*pi"),
    "heart": ("16*sin(t)^3, 13*cos(t)-5*cos(2*t)-2*cos(3*t)-cos(4*t)", "0", "2*pi"),
    "sine": ("t, sin(t)", "0", "2*pi"),
    "lemniscate": ("sqrt(2)*cos(t)/(1+sin(t)^2), sqrt(2)*sin(t)*cos(t)/(1+sin(t)^2)", "0", "2*pi"),
}


def slow(*values):
    """Parameters of a test that takes long."""
    return pytest.param(*values, marks=pytest.mark.slow)


def sampled(name):
    """Points of a curve by sympy and numpy."""
    formula, *ends = CURVES[name]
    t = sympy.Symbol("t")
    function = sympy.lambdify(t, sympy.sympify(f"[{formula.replace('^', '**')}]"), "numpy")
    return along(function, *(float(sympy.sympify(end)) for end in ends))


def to_file(name, primitive, tolerance, path, **options):
    """What is written of a curve, its text and the densely sampled curve."""
    spline = osc.approximate(osc.curve(*CURVES[name]), primitive, tolerance, files={path: options})
    file = spline.write(path, **options)
    assert file.error <= tolerance * (1 + 1e-9)
    assert spline.error <= tolerance - spline.reserved
    return file, path.read_text("utf-8"), sampled(name)


def distances(text, curve):
    """Of a program, for all readings of a radius."""
    return {radius: two_sided(path_of(text, radius), curve) for radius in ("first", "last", "even")}


@pytest.mark.parametrize(
    ("name", "tolerance", "most"),
    [("cone", 1e-3, 135), ("twisted cubic", 1e-3, 40), ("torus knot", 1e-2, 115)],
)
def test_helices_that_are_no_arcs_of_a_machine(name, tolerance, most, tmp_path):
    file, text, curve = to_file(name, "bihelix", tolerance, tmp_path / "a.nc")
    true = max(distances(text, curve).values())
    assert true <= tolerance and file.error == pytest.approx(true, rel=2e-3)
    assert file.moves == len(interpret(text)[1]) < most


@pytest.mark.parametrize(
    ("name", "tolerance", "decimals"),
    [
        ("circle", 1e-2, 3),
        ("trochoid", 1e-2, 3),
        ("trochoid", 1e-3, 3),
        ("trochoid", 1e-2, 2),
        ("spiral", 1e-3, 3),
        ("ellipse", 1e-2, 3),
        ("ellipse", 1e-3, 3),
    ],
)
def test_few_decimals_keep_the_tolerance(name, tolerance, decimals, tmp_path):
    file, text, curve = to_file(name, "biarc", tolerance, tmp_path / "a.nc", decimals=decimals)
    found = distances(text, curve)
    assert max(found.values()) <= tolerance * (1 + FINE)
    assert file.error == pytest.approx(max(found["first"], found["last"]), rel=5e-3)


def points_of(entity):
    """Points along an entity, by ezdxf, exact to rounding."""
    kind = entity.dxftype()
    if kind == "LWPOLYLINE":
        return np.concatenate([points_of(part) for part in entity.virtual_entities()])
    if kind == "LINE":
        points = entity.dxf.start, entity.dxf.end
    elif kind == "SPLINE":
        tool = entity.construction_tool()
        points = tool.points(np.linspace(0, tool.max_t, 20_001))
    else:
        points = entity.flattening(1e-9)
    return np.array([(point.x, point.y) for point in points])


@pytest.mark.parametrize("entities", ["polyline", "arcs"])
@pytest.mark.parametrize(
    ("name", "primitive"),
    [("sine", "conic"), ("lemniscate", "conic"), ("spiral", "biarc"), ("sine", "cubic")],
)
def test_drawings(name, primitive, entities, tmp_path):
    file, text, curve = to_file(name, primitive, 1e-3, tmp_path / "a.dxf", entities=entities)
    document = ezdxf.read(io.StringIO(text))
    audit = document.audit()
    assert not audit.errors and not audit.fixes
    points = np.concatenate([points_of(entity) for entity in document.modelspace()])
    assert two_sided(points, curve) <= 1e-3 * (1 + FINE)
    assert file.error <= 1e-3


@pytest.mark.parametrize(
    ("name", "primitive", "tolerance", "most"),
    [
        ("sine", "conic", 1e-3, 60),
        ("lemniscate", "conic", 1e-4, 200),
        ("sine", "cubic", 1e-3, 26),
        ("heart", "parabola", 0.05, 66),
    ],
)
def test_pictures(name, primitive, tolerance, most, tmp_path):
    svgelements = pytest.importorskip("svgelements")
    file, text, curve = to_file(name, primitive, tolerance, tmp_path / "a.svg")
    path = svgelements.Path(ET.fromstring(text).find(f".//{SVG}path[@id='spline']").get("d"))
    path = [part for part in path if not isinstance(part, svgelements.Move | svgelements.Close)]
    assert len(path) == file.moves and file.numbers <= most
    f = np.linspace(0, 1, 8000 // len(path))
    points = np.concatenate([[(p.x, p.y) for p in map(part.point, f)] for part in path])
    assert two_sided(points, curve) <= tolerance * (1 + FINE)


@pytest.mark.slow
@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    st.floats(0.3, 3),
    st.floats(0.1, 0.9),
    st.integers(2, 5),
    st.floats(-3.5, -1.5),
    st.integers(2, 5),
    st.sampled_from(["mm", "inch", None]),
    st.sampled_from(["linuxcnc", "grbl", "marlin"]),
)
def test_random_curves_keep_random_tolerances(
    tmp_path, size, dent, waves, exponent, decimals, units, dialect
):
    """Flowers of all sizes: a program within the tolerance, or a sentence."""
    tolerance = 10**exponent
    formula = f"{size!r}*(1 + {dent!r}*cos({waves}*t))"
    curve = osc.curve(f"{formula}*cos(t), {formula}*sin(t)", 0, "2*pi")
    path = tmp_path / "a.nc"
    options = {"decimals": decimals, "units": units, "dialect": dialect}
    try:
        spline = osc.approximate(curve, "biarc", tolerance, files={path: options})
    except ToleranceError:
        assert 10.0**-decimals > 0.8 * tolerance
        return
    file = spline.write(path, **options)

    def points(t):
        radius = size * (1 + dent * np.cos(waves * t))
        return radius * np.cos(t), radius * np.sin(t)

    found = distances(path.read_text(), along(points, 0, math.tau))
    assert max(found.values()) <= tolerance * (1 + 1e-6)
    assert file.error >= max(found["first"], found["last"]) * (1 - 5e-3)


def test_a_spline_without_room_is_not_written_beyond_the_tolerance(tmp_path):
    spline = osc.approximate(osc.curve(*CURVES["spiral"]), "biarc", 1e-3)
    with pytest.raises(ToleranceError, match=r"more than the tolerance 0\.001: name the file and its"):
        spline.write(tmp_path / "a.nc", decimals=3)
    assert not list(tmp_path.iterdir())
    assert spline.write(tmp_path / "a.nc").error <= 1e-3  # in as many decimals as its error leaves
    helices = osc.approximate(osc.curve(*CURVES["twisted cubic"]), "bihelix", 1e-3)
    with pytest.raises(ToleranceError, match="that stand for helices: name the file when approximating"):
        helices.write(tmp_path / "b.nc")
    given = osc.approximate(osc.curve(*CURVES["spiral"]), "biarc", pieces=10)
    assert given.write(tmp_path / "c.nc", decimals=2).error > given.tolerance  # there was no tolerance


@pytest.mark.parametrize("suffix", [".svg", ".dxf", ".nc"])
@pytest.mark.parametrize(("first", "tolerance"), [("1/20", 1e-3), slow("1/50", 1e-2), slow("1/30", 0.05)])
def test_bends_much_narrower_than_the_tolerance_are_measured_on_their_own_branch(
    first, tolerance, suffix, tmp_path
):
    curve = osc.curve("t, sin(1/t)", first, 1)
    for primitive in ("biarc",) if suffix == ".nc" else ("cubic", "conic"):
        path = tmp_path / f"a{suffix}"
        spline = osc.approximate(curve, primitive, tolerance, files=path)
        file = spline.write(path)
        assert file.error <= tolerance
        assert len(spline) <= len(osc.approximate(curve, primitive, 0.8 * tolerance))
    if suffix == ".nc":
        points = along(lambda t: (t, np.sin(1 / t)), float(sympy.sympify(first)), 1)
        true = max(distances(path.read_text(), points).values())
        assert true <= tolerance * (1 + 1e-2) and file.error == pytest.approx(true, rel=2e-2)


def test_several_files_have_room_for_the_neediest(tmp_path):
    curve = osc.curve(*CURVES["trochoid"])
    files = {tmp_path / "a.nc": {"decimals": 3}, tmp_path / "b.svg": {}, tmp_path / "c.json": {}}
    spline = osc.approximate(curve, "biarc", 1e-3, files=files)
    for path, options in files.items():
        assert spline.write(path, **options).error <= 1e-3


def test_areas_of_files(tmp_path):
    curve = osc.curve(*CURVES["spiral"])
    for name, primitive in (("a.nc", "biarc"), ("a.svg", "conic"), ("a.dxf", "conic")):
        spline = osc.approximate(curve, primitive, 1e-2, metric="area", files=tmp_path / name)
        file = spline.write(tmp_path / name)
        assert spline.error <= file.error <= 1e-2


def test_everything_is_refused_before_the_work(tmp_path, monkeypatch):
    curve = osc.curve(*CURVES["spiral"])
    monkeypatch.setattr(type(curve), "check_finite", lambda self: pytest.fail("this is the work"))
    for files, says in (
        ({tmp_path / "a.nc": {}}, "G-code holds lines.*conic arcs; choose biarc or polygon"),
        ({tmp_path / "a.svg": {}, tmp_path / "a.nc": {}}, "conic arcs; choose biarc or polygon"),
        ({tmp_path / "a.svg": {"decimals": 3}}, "SVG has no option 'decimals': it is one of G-code"),
        ({tmp_path / "a.xyz": {}}, "known suffixes"),
        ({tmp_path / "no" / "a.svg": {}}, "there is no folder"),
    ):
        with pytest.raises(OsculantError, match=says):
            osc.approximate(curve, None, 1e-3, files=files)
    with pytest.raises(ToleranceError, match="give 3 decimals or more"):
        monkeypatch.undo()
        osc.approximate(curve, "biarc", 1e-3, files={tmp_path / "a.nc": {"decimals": 2}})
