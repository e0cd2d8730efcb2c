"""The table of primitives: every entry has all its parts, and each part does what it says."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import osculant as osc
from osculant.approximation.fitting import EXACT
from osculant.cas.errors import DomainError
from osculant.cli.main import main
from osculant.pieces.kinds import KINDS
from osculant.primitives.primitive import METRICS, Fit
from osculant.primitives.table import PRIMITIVES, USUAL, candidates, choose, register, usual_first

ENTRIES = [entry for table in PRIMITIVES.values() for entry in table.values()]
FITS = [Fit(entry, metric, rule) for entry in ENTRIES for metric in METRICS for rule in entry.rules(metric)]
#: by dimension, a curve that is no primitive itself, and a straight line
SPIRALS = {
    2: osc.curve("t*cos(t), t*sin(t)", "pi/6", "2*pi"),
    3: osc.curve("t*cos(t), t*sin(t), t", "pi/6", "2*pi"),
}
LINES = {2: osc.curve("t, 2*t", 0, 1), 3: osc.curve("t, 2*t, 3*t", 0, 1)}
#: curves that are arcs of a primitive
THEMSELVES = {
    "parabola": osc.curve("t, t^2", -1, 2),
    "conic": osc.curve("2*cos(t), sin(t)", 0, 3),
    "biarc": osc.curve("cos(t), sin(t)", 0, 3),
    "bihelix": osc.curve("3*cos(t), 3*sin(t), 4*t", 0, 3),
}
README = Path(__file__).parents[3].joinpath("README.md").read_text(encoding="utf-8")


def name_of(value):
    return f"{value.primitive.name}-{value.metric}-{value.rule}" if isinstance(value, Fit) else value.name


def distance(points, chain):
    """The largest distance of points (m, d) to the polygon through the rows of ``chain`` (n, d)."""
    starts, steps = chain[:-1], np.diff(chain, axis=0)
    away = points[:, None] - starts
    along = np.clip((away * steps).sum(axis=2) / (steps * steps).sum(axis=1), 0, 1)
    return np.linalg.norm(away - along[..., None] * steps, axis=2).min(axis=1).max()


@pytest.mark.parametrize("entry", ENTRIES, ids=name_of)
def test_an_entry_is_where_it_says_and_speaks_of_forms_that_there_are(entry):
    assert PRIMITIVES[entry.dimension][entry.name] is entry
    forms = set(SPIRALS[entry.dimension].zeros.forms)
    assert {*entry.splits, *entry.theory} <= forms and not {*entry.splits} & {*entry.theory}
    assert "segment" in entry.arcs and set(entry.arcs) <= set(KINDS)
    assert set(entry.methods) <= set(METRICS) and entry.rules(METRICS[0])
    if entry.itself is not None:
        assert set(entry.itself.forms) <= forms and entry.itself.forms
        assert entry.itself.shape in {*EXACT, "helix"}


@pytest.mark.parametrize("entry", [entry for entry in ENTRIES if entry.itself], ids=name_of)
def test_a_curve_is_known_to_be_a_primitive_itself(entry):
    curve = THEMSELVES[entry.name]
    assert entry.itself.proof(curve.exact) is True
    assert all(map(curve.vanishes, entry.itself.forms))
    assert entry.itself.proof(SPIRALS[entry.dimension].exact) is False
    assert not curve.vanishes("inflection") and not SPIRALS[entry.dimension].vanishes(entry.itself.forms[0])
    spline = osc.approximate(curve, entry.name, 1e-6)
    assert (spline.error, spline.error_kind) == (0.0, "exact")
    turning = len(spline) * entry.itself.turning
    assert turning > 3 * (len(spline) - 1)


@pytest.mark.parametrize("fit", FITS, ids=name_of)
def test_a_fit_has_its_law(fit):
    law, entry = fit.law(), fit.primitive
    assert entry.dimension in law.spaces
    assert (law.primitive, law.metric, law.order) == (entry.name, fit.metric, fit.order)
    if entry.itself is not None and len(entry.itself.forms) > 1:
        assert fit.law("level").order > fit.order
    else:
        with pytest.raises(DomainError, match="No error law"):
            fit.law("level")


@pytest.mark.parametrize("fit", FITS, ids=name_of)
def test_a_fit_has_its_kernels_and_pieces(fit):
    curve = SPIRALS[fit.primitive.dimension]
    spline = osc.approximate(curve, fit.primitive.name, 1e-3, metric=fit.metric, rule=fit.rule)
    assert (spline.primitive, spline.metric, spline.rule) == (fit.primitive.name, fit.metric, fit.rule)
    proved = fit.theorem is not None and fit.metric == "hausdorff"  # no theorem is about sums of areas
    assert spline.minimal == ("by theory" if proved else "unknown")
    assert len(spline) >= spline.predicted_pieces > 2
    assert 0 < spline.error <= 1e-3
    # ends of pieces are points of the curve: whatever the kernel's coordinates, rows came back right
    for piece in spline.pieces:
        ends = curve.jets(piece.interval)[..., 0]
        assert np.allclose([piece.start, piece.end], ends, rtol=0, atol=1e-13)
    if fit.primitive.smooth:
        assert spline.max_tangent_jump() < 1e-12
    if fit.metric == "hausdorff":
        points = curve.jets(np.linspace(*curve.interval, 300))[..., 0]
        assert distance(points, spline.sample(300)) == pytest.approx(spline.error, rel=0.05)


@pytest.mark.parametrize("entry", ENTRIES, ids=name_of)
def test_straight_lines_are_one_segment(entry):
    (piece,) = osc.approximate(LINES[entry.dimension], entry.name).pieces
    assert (piece.kind, piece.error) == ("segment", 0.0)
    assert (piece.start, piece.end) == ((0, 0, 0)[: entry.dimension], (1, 2, 3)[: entry.dimension])
    made = entry.segment((0.0, 2.0), (0.0,) * entry.dimension, (3.0,) * entry.dimension)
    assert math.dist(made.start, made.end) == pytest.approx(3 * math.sqrt(entry.dimension))


def test_names_are_taken_once():
    for entry in ENTRIES:
        with pytest.raises(ValueError, match=f"{entry.name!r} is twice in the table"):
            register(replace(entry))
        assert PRIMITIVES[entry.dimension][entry.name] is entry


def test_what_is_usual_and_what_may_be_the_best():
    for dimension, table in PRIMITIVES.items():
        assert usual_first(dimension)[0] == USUAL[dimension] in table
        assert sorted(usual_first(dimension)) == sorted(table)
        assert set(candidates(dimension)) == {name for name, entry in table.items() if entry.smooth}
        best = osc.approximate(SPIRALS[dimension], "best", 1e-3)
        assert len(best.choice) == len(candidates(dimension))


def test_the_command_line_and_the_readme_list_them(capsys):
    main(["approximate", "--help"])
    (listed,) = re.findall(r"--with (\S+)", capsys.readouterr().out)
    assert sorted(listed.split("|")) == sorted({entry.name for entry in ENTRIES} | {"best"})
    for entry in ENTRIES:
        assert re.search(rf"\b{entry.name}|\b{entry.plural}", README, re.IGNORECASE)


def test_choices_that_do_not_exist():
    with pytest.raises(DomainError, match="'quartic' is unknown: choose one of parabola, conic, biarc"):
        choose("quartic", "hausdorff")
    with pytest.raises(DomainError, match=r"^Bihelices approximate curves in space and t, t has two coord"):
        choose("bihelix", "hausdorff", curve="t, t")
    with pytest.raises(
        DomainError, match=r"choose conic, parabola, biarc, cubic or polygon, or add a third coordinate"
    ):
        choose("bihelix", "hausdorff")
    with pytest.raises(
        DomainError, match="approximated with bihelix or polygon, not 'conic': choose bihelix or"
    ):
        choose("conic", "hausdorff", dimension=3)
    with pytest.raises(DomainError, match="one of plane curves, and t, t, t has three coordinates"):
        choose("bihelix", "area", dimension=3, curve="t, t, t")
    with pytest.raises(
        DomainError, match=r"'nice' is unknown for .* choose equisymmetric or minimal-area, or l"
    ):
        choose("conic", "area", "nice")
    with pytest.raises(DomainError, match="'nice' is unknown: choose one of equioscillating, thesis"):
        choose("bihelix", "hausdorff", "nice", dimension=3)


@pytest.mark.parametrize("fit", FITS, ids=name_of)
def test_pieces_of_a_table_are_what_their_constructor_makes(fit):
    curve = SPIRALS[fit.primitive.dimension]
    spline = osc.approximate(curve, fit.primitive.name, 1e-2, metric=fit.metric, rule=fit.rule)
    ends = curve.jets(spline.knots)[..., 0]
    for piece, start, end in zip(spline.pieces, ends[:-1], ends[1:], strict=True):
        again = replace(piece)
        assert again == piece and list(vars(again)) == list(vars(piece))[: len(vars(again))]
        assert type(piece.error) is float and {type(t) for t in piece.interval} == {float}
        assert np.allclose(piece.start, start, rtol=0, atol=1e-14)
        assert np.allclose(piece.end, end, rtol=0, atol=1e-13)


@pytest.mark.parametrize("weight", [-1.0, math.inf, math.nan])
def test_a_table_with_an_arc_that_is_not_bounded_is_refused(weight):
    shapes = np.zeros((2, 10))
    shapes[:, -1] = 0.5, weight
    with pytest.raises(DomainError, match="bounded only for a weight above -1"):
        PRIMITIVES[2]["conic"].pieces(np.ones((2, 13)), shapes)
