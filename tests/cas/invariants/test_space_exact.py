"""Exact invariants of space curves against difference quotients of mpmath at 50 digits."""

from __future__ import annotations

from time import perf_counter

import mpmath as mp
import pytest
import sympy

from osculant.cas.formulas.parser import parse, parse_tuple
from osculant.cas.invariants.space import SpaceExactInvariants
from osculant.cas.invariants.values import mapped
from osculant.cas.jets.space import SPACE_INVARIANTS

CURVES = {
    "t*cos(t), t*sin(t), t": lambda t: (t * mp.cos(t), t * mp.sin(t), t),
    "t, t^2, t^3": lambda t: (t, t**2, t**3),
    "exp(t), cos(t), t^2": lambda t: (mp.exp(t), mp.cos(t), t**2),
    "(2 + cos(3*t))*cos(t), (2 + cos(3*t))*sin(t), sin(3*t)": lambda t: (
        (2 + mp.cos(3 * t)) * mp.cos(t),
        (2 + mp.cos(3 * t)) * mp.sin(t),
        mp.sin(3 * t),
    ),
}


def vector(function, t, order=0):
    return mp.matrix([mp.diff(lambda u, i=i: function(u)[i], t, order) for i in range(3)])


def cross(a, b):
    return mp.matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def dot(a, b):
    return mp.fdot(a, b)


def frenet(function, t):
    """(T, N, B, κ, τ, speed) from the textbook's formulas, in derivatives by mpmath."""
    first, second, third = (vector(function, t, order) for order in (1, 2, 3))
    c = cross(first, second)
    speed, size = mp.norm(first), mp.norm(c)
    tangent, binormal = first / speed, c / size
    return tangent, cross(binormal, tangent), binormal, size / speed**3, dot(c, third) / size**2, speed


def oracle(function, t):
    tangent, normal, binormal, kappa, tau, speed = frenet(function, t)
    slopes = [mp.diff(lambda u, i=i: frenet(function, u)[i], t) / speed for i in (3, 4)]
    darboux = tau * tangent + kappa * binormal
    beta = mp.norm(darboux)
    axis = -darboux / beta
    ratio = mp.diff(lambda u: frenet(function, u)[4] / frenet(function, u)[3], t) / speed
    return {
        "speed": speed,
        "curvature": kappa,
        "torsion": tau,
        "curvature_slope": slopes[0],
        "torsion_slope": slopes[1],
        "tangent": tuple(tangent),
        "normal": tuple(normal),
        "binormal": tuple(binormal),
        "darboux_vector": tuple(darboux),
        "frame_rate": beta,
        "darboux_frame": (tuple(normal), tuple(cross(axis, normal)), tuple(axis)),
        "axis_rate": -ratio / (1 + (tau / kappa) ** 2),
    }


def flat(value):
    return [x for part in value for x in flat(part)] if isinstance(value, tuple) else [value]


@pytest.mark.parametrize("text", CURVES)
def test_exact_values_are_those_of_the_definitions(text):
    exact = SpaceExactInvariants(*parse_tuple(text))
    assert exact.over_jets <= {"torsion_slope", "frame_rate", "darboux_frame", "axis_rate"}
    t = sympy.Symbol("t", real=True)
    with mp.workdps(50):
        at = mp.mpf(7) / 10
        for name, expected in oracle(CURVES[text], at).items():
            if name in exact.over_jets:
                continue
            computed = mapped(
                lambda e: sympy.sympify(e).subs(t, sympy.Rational(7, 10)).evalf(50), exact[name]
            )
            for a, b in zip(flat(computed), flat(expected), strict=True):
                assert abs(mp.mpf(str(a)) - b) < mp.mpf(10) ** -20 * (1 + abs(b)), name


def test_all_invariants_are_covered_by_the_oracle():
    names = {invariant.name for invariant in SPACE_INVARIANTS}
    with mp.workdps(30):
        assert set(oracle(CURVES["t, t^2, t^3"], mp.mpf(1) / 3)) == names


def test_the_text_is_a_formula_again():
    exact = SpaceExactInvariants(*parse_tuple("t*cos(t), t*sin(t), t"))
    t = sympy.Symbol("t", real=True)
    for name in ("speed", "curvature", "torsion", "curvature_slope"):
        again = parse(exact.text(name))
        from osculant.cas.formulas.sympy_bridge import to_sympy

        assert abs((to_sympy(again) - exact[name]).subs(t, 2).evalf(30)) < 1e-25


def test_signs_of_the_torsion():
    assert SpaceExactInvariants(*parse_tuple("cos(t), sin(t), t"))["torsion"] > 0  # right-handed
    assert SpaceExactInvariants(*parse_tuple("cos(t), sin(t), -t"))["torsion"] < 0


@pytest.mark.parametrize(
    ("text", "straight", "planar", "helix"),
    [
        ("t, 2*t, 3*t", True, True, False),
        ("cos(t)^2, 1 - cos(t)^2, 5", True, True, False),
        ("t, t^2, 3*t^2 - t", False, True, False),
        ("cos(t), sin(t), 0", False, True, True),
        ("cos(t) + sin(t), cos(t) - sin(t), 3*t", False, False, True),
        ("t, t^2, t^3", False, False, False),
        ("exp(t)*cos(t), exp(t)*sin(t), exp(t)", False, False, False),
    ],
)
def test_special_shapes_are_proved(text, straight, planar, helix):
    exact = SpaceExactInvariants(*parse_tuple(text))
    assert (exact.straight, exact.planar, exact.circular_helix) == (straight, planar, helix)


def test_what_does_not_exist_is_none():
    line = SpaceExactInvariants(*parse_tuple("t, 2*t, 3*t"))
    assert line["curvature"] == 0
    assert line["torsion"] is line["normal"] is line["darboux_frame"] is None
    assert line.text("torsion") == line.latex("binormal") == "undefined"
    point = SpaceExactInvariants(*parse_tuple("1, 2, 3"))
    assert point["speed"] == 0
    assert point["tangent"] is None


def test_the_arc_length_is_definite_between_ends():
    two_pi = parse("2*pi")
    helix = SpaceExactInvariants(*parse_tuple("3*cos(t), 3*sin(t), 4*t"), ends=(parse("0"), two_pi))
    assert helix["arc_length"] == 10 * sympy.pi


@pytest.mark.parametrize(
    "text",
    [
        "cos(cos(cos(t))), sin(exp(t)*t), tan(t/3)",
        "sin(sin(t)), cos(exp(t)), sqrt(t^4 + 1)/(2 + sin(t))",
        "sin(t)*cos(t^2), exp(sin(t)), log(1 + t^2)",
    ],
)
def test_large_formulas_stand_over_jets_in_bounded_time(text):
    began = perf_counter()
    exact = SpaceExactInvariants(*parse_tuple(text))
    assert perf_counter() - began < 30  # seconds here; the bound is generous for loaded machines
    assert {"curvature", "torsion"} <= exact.over_jets
    assert exact.text("torsion").startswith("(x3*(y1*z2 - y2*z1)")
    assert {str(s) for s in exact["torsion"].free_symbols} <= {f"{c}{i}" for c in "xyz" for i in (1, 2, 3)}
