"""One bihelix: the reference in mpmath, its junction, and distances that no point of the curve sees."""

import mpmath as mp
import numpy as np
import pytest

from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry import bihelix_rules as reference
from osculant.kernels.bihelices.balance import two_of
from osculant.kernels.bihelices.family import EQUIOSCILLATING, THESIS, bihelix, offset
from osculant.kernels.bihelices.hausdorff import two_sided
from osculant.kernels.bihelices.records import Bihelix
from osculant.kernels.bihelices.scan import peaks
from osculant.kernels.curves.arc_length import after, measure_lengths, workspace
from osculant.kernels.curves.space import Frame
from osculant.kernels.operations import ERROR, A, B
from tests.kernels.arcs import SPACE, arc, jet_of, spline
from tests.kernels.bihelices.chains import (
    BOTH,
    CONICAL,
    MOMENT,
    check_chain,
    independent_error,
    smooth_text,
    spline_of,
)


def one_arc(text, a, b):
    """The arc, its length, and the lengths along it."""
    on, lengths = arc(jet_of(text, 3), a, b, SPACE), workspace(Bihelix())
    return on, measure_lengths(on.source, a, b, lengths), lengths


@pytest.mark.parametrize("text, a, b", [(MOMENT, 1.0, 1.1), (CONICAL, 2.0, 2.5), ("t, t^2, t^3", 0.2, 0.5)])
def test_the_reference_has_the_same_peaks(text, a, b):
    on, sigma, lengths = one_arc(text, a, b)
    exact = reference.SpaceArc(parse_tuple(text), mp.mpf(a), mp.mpf(b))
    assert sigma == pytest.approx(float(exact.sigma), rel=1e-12)
    for part in (0.1, 0.5, 0.77):
        t = after(lengths, a, b, part * sigma, sigma)
        assert t == pytest.approx(float(exact.after(part * exact.sigma)), rel=1e-10)
    found, two = bihelix(THESIS, *on.given, sigma, 0.0, lengths)
    expected = [float(x) for x in reference.peaks(exact, reference.thesis_bihelix(exact))]
    assert found
    assert peaks(on.source, a, b, two, 8)[:2] == pytest.approx(expected, rel=1e-7)
    seen, _ = two_of(EQUIOSCILLATING, *on.given, 0.0, 1e-7, 8, lengths)
    equal = max(reference.peaks(exact, reference.equioscillating_bihelix(exact)))
    assert seen.trusted
    assert (seen.left, seen.right) == pytest.approx((float(equal),) * 2, rel=1e-5)
    assert two_sided(on.source, a, b, sigma, seen.two) == pytest.approx(max(seen.left, seen.right), rel=1e-7)


def test_the_junction_point_is_in_both_planes():
    rng = np.random.default_rng(3)
    for _ in range(20):
        points = [tuple(map(float, p)) for p in rng.normal(size=(3, 3))]
        t_left, t_right, tangent = (tuple(map(float, v / np.linalg.norm(v))) for v in rng.normal(size=(3, 3)))
        left, right = Frame(points[0], t_left), Frame(points[1], t_right)
        step, w = offset(left, right, tangent, points[2])
        p = np.add(points[2], step)
        assert abs(np.dot(p - points[0], np.subtract(tangent, t_left))) < 1e-12
        assert abs(np.dot(points[1] - p, np.subtract(t_right, tangent))) < 1e-12
        assert abs(np.dot(step, w)) < 1e-12  # nearest


@BOTH
def test_short_arcs_from_an_inflection_have_a_bihelix(rule):
    text = "t, sin(2*t), t^3+sin(3*t)"  # κ = 0 with torsion at 0: the junction planes are nearly parallel
    slope = 829**0.5 / 14**2  # κ′ at 0
    for b in (0.004, 0.01, 0.02, 0.05):
        on, sigma, lengths = one_arc(text, 0.0, b)
        seen, _ = two_of(rule, *on.given, 0.0, 1e-6, 8, lengths)
        assert seen.trusted
        law = slope * sigma**3 / 324
        assert 0.9 * law <= max(seen.left, seen.right) <= (1.1 if rule == EQUIOSCILLATING else 2.0) * law
    for tolerance in (1e-1, 1e-2, 1e-4, 1e-6):
        table, jet = spline_of(text, 0.0, 2.0, tolerance, rule)
        check_chain(table, jet)
        for row in table[:3]:
            assert row[ERROR] <= tolerance
            assert independent_error(row, jet, 8001) == pytest.approx(row[ERROR], rel=1e-4, abs=1e-9)
            assert row[B] - row[A] > 0.2 * tolerance ** (1 / 3)


def test_a_helix_that_no_point_of_the_curve_sees_is_not_trusted():
    text = smooth_text((0, 0, 0, 0, 0, 0, 1, 1, 0))
    a, b = 0.590424034, 1.29040685
    on, sigma, lengths = one_arc(text, a, b)
    found, two = bihelix(THESIS, *on.given, sigma, 0.0, lengths)
    assert found
    assert two.t - a < 1e-8  # the junction is behind the left end, and the left helix turns by 6 radians
    first, second, trusted = peaks(on.source, a, b, two, 8)
    careful = two_sided(on.source, a, b, sigma, two)
    assert careful > 3 * max(first, second)
    assert not trusted
    rows, _, _ = spline(Bihelix(THESIS), on.jet, a, b, (0.9, 1.0), SPACE)
    assert rows[0, ERROR] == pytest.approx(independent_error(rows[0], on.jet, 8001), rel=1e-5)
