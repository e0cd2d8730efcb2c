"""Every format has all its parts, and none is named elsewhere."""

from __future__ import annotations

import inspect
import io
import json
import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from importlib import import_module
from pathlib import Path

import ezdxf
import pytest

import osculant as osc
from osculant.approximation.for_files import check_arcs, wanted_files
from osculant.cas.errors import OsculantError
from osculant.files.registry import WRITERS, register, writer_of, writers
from osculant.pieces.kinds import KINDS
from osculant.primitives.table import PRIMITIVES, may_become
from tests.front.samples import written

FOLDER = Path(osc.__file__).parent
README = (FOLDER.parent / "README.md").read_text(encoding="utf-8")
#: to be written, by dimension: pieces that every format holds
CURVES = {2: ("cos(t), sin(t)/2", "biarc"), 3: ("cos(t), sin(t), t", "bihelix")}
#: what reads a file back, and returns what it tells about the pieces
READERS = {
    "SVG": lambda text: ET.fromstring(text).find("{http://www.w3.org/2000/svg}desc").text,
    "JSON": lambda text: f"{json.loads(text)['primitive']}, {len(json.loads(text)['segments'])} pieces",
    "G-code": lambda text: " ".join(re.findall(r"^\((.*)\)$", text, re.MULTILINE)),
    "DXF": lambda text: dict(ezdxf.read(io.StringIO(text)).header.custom_vars.properties)["primitive"],
}


def each(test):
    return pytest.mark.parametrize("writer", WRITERS, ids=[writer.name for writer in WRITERS])(test)


def function_of(writer):
    module, _, name = writer.function.partition(":")
    return getattr(import_module(module), name)


@each
def test_a_writer_has_all_its_parts(writer):
    function = function_of(writer)
    assert function.__doc__ and import_module(function.__module__).__doc__
    parameters = inspect.signature(function).parameters.values()
    keywords = [p.name for p in parameters if p.kind is p.KEYWORD_ONLY]
    assert keywords == list(writer.options)
    assert all(p.default is not p.empty for p in parameters if p.name in keywords)
    assert [p.name for p in parameters if p.kind is not p.KEYWORD_ONLY] == ["chain", "facts", "room"]
    assert all(re.search(rf"^ +{option}: ", function.__doc__, re.MULTILINE) for option in writer.options)
    assert set(writer.exact) | set(writer.replaced) <= set(KINDS)
    assert not set(writer.exact) & set(writer.replaced)
    assert writer.suffixes and all(re.fullmatch(r"\.[a-z]+", suffix) for suffix in writer.suffixes)
    assert writer.suffixes[0] in README or writer.name in README
    writer.check_installed()


@each
def test_what_it_writes_is_read_back(writer, tmp_path):
    for dimension in writer.dimensions:
        formula, primitive = CURVES[dimension]
        files = [tmp_path / f"curve{suffix.upper()}" for suffix in writer.suffixes]
        spline = osc.approximate(osc.curve(formula, 0, 2), primitive, 1e-2, files=files)
        for path in files:
            assert spline.write(path).error <= 1e-2
            assert f"{primitive}, {len(spline)} pieces" in READERS[writer.name](path.read_text("utf-8"))


@each
def test_kinds_that_it_cannot_hold_are_refused(writer):
    """Pieces of every kind in the plane: what is neither exact nor replaced raises, all else is written."""
    spirals = {"conic": "t*cos(t), t*sin(t)", "parabola": "t, t^3 + t"}
    for primitive, formula in spirals.items():
        spline = osc.approximate(osc.curve(formula, "1/2", 2), primitive, 1e-2)
        kinds = {arc.kind for arc in spline.chain.arcs}
        if writer.holds(kinds):
            assert READERS[writer.name](written(spline, function_of(writer)))
        else:
            with pytest.raises(OsculantError, match="approximate with biarcs"):
                written(spline, function_of(writer))


@pytest.mark.parametrize(
    ("primitive", "formulas"),
    [
        ("parabola", ["t, t^3 + t", "t, 2*t", "t, t^2"]),
        ("conic", ["t*cos(t), t*sin(t)", "cos(t), sin(t)", "t, 2*t", "t, 1/t", "t, t^2", "t, t^3"]),
        ("biarc", ["t*cos(t), t*sin(t)", "cos(t), sin(t)", "t, 2*t"]),
        ("bihelix", ["t, t^2, t^3", "cos(t), sin(t), t", "cos(t), sin(t), 1", "t, t, t"]),
    ],
)
def test_pieces_are_of_the_kinds_that_their_primitive_tells(primitive, formulas):
    splines = [osc.approximate(osc.curve(formula, "1/4", 2), primitive, 1e-3) for formula in formulas]
    assert {arc.kind for spline in splines for arc in spline.chain.arcs} <= set(may_become(primitive)[0].arcs)


def test_what_no_format_can_hold_is_refused(tmp_path):
    for dimension in (2, 3):
        for primitive in PRIMITIVES[dimension].values():
            for writer in writers(dimension):
                files = wanted_files(tmp_path / f"a{writer.suffixes[0]}", dimension)
                if writer.holds(primitive.arcs):
                    check_arcs(files, primitive)
                else:
                    says = rf"{writer.name} holds lines.* to be {primitive.name} arcs; choose .*biarc"
                    with pytest.raises(OsculantError, match=says):
                        check_arcs(files, primitive)
    with pytest.raises(OsculantError, match=r"a spline in space is written as \.json"):
        wanted_files(tmp_path / "a.svg", 3)


def test_every_writer_is_read_and_two_of_one_suffix_are_refused():
    assert set(READERS) == {writer.name for writer in WRITERS}
    for double in (WRITERS[2], replace(WRITERS[2], name="other"), replace(WRITERS[2], suffixes=(".other",))):
        with pytest.raises(ValueError, match="Two writers are called"):
            register(*WRITERS, double)
    for writer in WRITERS:
        assert all(writer_of(f"a{suffix}") is writer for suffix in writer.suffixes)


def test_splines_in_space_have_fewer_formats():
    assert {2, 3} == {dimension for writer in WRITERS for dimension in writer.dimensions}
    assert len(writers(3)) < len(writers(2)) == len(WRITERS)
    with pytest.raises(
        OsculantError, match=r"a\.svg: a spline in space is written as \.json, .* and \.dxf; plot"
    ):
        writer_of("a.svg", 3)


def test_a_missing_package_is_named():
    with pytest.raises(OsculantError, match=r"^DXF needs nonesuch, .*`pip install osculant\[cad\]` adds it"):
        replace(writer_of("a.dxf"), extra=("nonesuch", "cad")).check_installed()


def test_no_suffix_is_named_elsewhere():
    """But in words for people: docstrings, comments, and help."""
    quoted = re.compile(
        "|".join(re.escape(f'"{suffix}"') for writer in WRITERS for suffix in writer.suffixes)
    )
    for folder in ("cli", "files"):
        for path in (FOLDER / folder).glob("*.py"):
            if path.name != "registry.py":
                assert not quoted.search(path.read_text("utf-8")), path
    assert not quoted.search((FOLDER / "spline.py").read_text("utf-8"))
