"""Equivalences over number fields, and moduli by invariants, against roots and invariants in doubles."""

from __future__ import annotations

import random
from fractions import Fraction

import numpy as np
import pytest

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.reference import reference
from osculant.cas.recognition.equivalence import NotEquivalent, equivalence
from osculant.cas.recognition.forms import form

SIMPLE, UNIMODAL = reference("simple functions"), reference("unimodal functions")
BOUNDARY = reference("boundary functions")


def real_lines(coefficients):
    """How many real lines a binary form without multiple lines has."""
    roots = np.roots([float(c) for c in coefficients])
    return int(sum(abs(roots.imag) < 1e-9)) + int(not coefficients[0])


def test_cubics_by_their_real_lines_over_number_fields():
    draw, degrees = random.Random(4), set()
    for _ in range(30):
        c = [draw.randint(-4, 4) for _ in range(4)]
        a, b, d, e = c
        if not b * b * d * d - 4 * a * d**3 - 4 * b**3 * e - 27 * a * a * e * e + 18 * a * b * d * e:
            continue
        text = f"({a})*x**3 + ({b})*x**2*y + ({d})*x*y**2 + ({e})*y**3 + x**4 - 2*y**5"
        made = equivalence(Germ(text, "x y"), form(SIMPLE["D_k"], k=4))
        assert made.signs == ((-1,) if real_lines(c) == 3 else (1,))
        degrees.add(1 if made.finish is None else made.finish.field.degree)
    assert degrees == {1, 3}


def test_parabolic_functions_have_the_invariants_of_their_modulus():
    draw = random.Random(5)
    for _ in range(12):
        c = [draw.choice((-3, -2, -1, 1, 2, 3)) for _ in range(5)]
        a, b, d, e, f = c
        invariant_i = a * f - Fraction(b * e, 4) + Fraction(d * d, 12)
        invariant_j = (
            Fraction(a * d * f, 6)
            + Fraction(b * d * e, 48)
            - Fraction(d**3, 216)
            - Fraction(a * e * e, 16)
            - Fraction(b * b * f, 16)
        )
        if invariant_i**3 == 27 * invariant_j**2:
            continue
        text = " + ".join(f"({v})*x**{4 - i}*y**{i}" for i, v in enumerate(c)) + " + x**3*y**2"
        made = equivalence(Germ(text, "x y"), form(UNIMODAL["X_9"]))
        s, t = made.signs
        m = float(made.moduli["a"])
        its_i, its_j = s * t + m * m / 12, s * t * m / 6 - m**3 / 216
        assert its_i**3 * float(invariant_j) ** 2 == pytest.approx(
            its_j**2 * float(invariant_i) ** 3, rel=1e-9
        )
        assert its_j * invariant_j >= 0
        lines = real_lines(c)
        assert (s, t) == ((1, -1) if lines == 2 else (1, 1) if lines == 4 or a > 0 else (-1, -1))
        assert lines == 2 or (m < -2 if lines == 4 else abs(m) < 2)


def test_tangent_parabolas_by_the_roots_of_their_cubic():
    draw = random.Random(6)
    for _ in range(12):
        a, b, c, d = (draw.choice((-3, -2, -1, 1, 2, 3)) for _ in range(4))
        roots = np.roots([a, b, c, d])
        real = sorted(r.real for r in roots if abs(r.imag) < 1e-9)
        if len(real) == 2:
            continue
        r = real[len(real) // 2]
        slope = c + 2 * b * r + 3 * a * r * r  # x³ + a'x²y² ± xy⁴ over the root in the middle
        wanted = (b + 3 * a * r) / np.cbrt(a) ** 2 / np.sqrt(abs(slope / np.cbrt(a)))
        made = equivalence(
            Germ(f"({a})*x**3 + ({b})*x**2*y**2 + ({c})*x*y**4 + ({d})*y**6", "x y"), form(UNIMODAL["J_10"])
        )
        assert made.signs == (1 if slope * a > 0 else -1,)
        assert float(made.moduli["a"]) == pytest.approx(wanted, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(("p", "q"), [(1, 1), (-3, 1), (-2, 1), (0, 2), (0, -2), (5, 0), (-5, 0)])
def test_cubic_curves_by_their_j_invariant(p, q):
    text = f"x**3 + ({p})*x*z**2 + ({q})*z**3 - y**2*z + x**2*y**2"
    made = equivalence(Germ(text, "x y z"), form(UNIMODAL["P_8"]))
    assert not made.printed and made.coefficients[(3, 0, 0), 0] == 1
    k = -float(made.moduli["a"]) / 3  # x³ + y³ + z³ = 3k·xyz
    j = 27 * k**3 * (k**3 + 8) ** 3 / (k**3 - 1) ** 3
    assert j == pytest.approx(1728 * 4 * p**3 / (4 * p**3 + 27 * q**2), rel=1e-9, abs=1e-9)
    # it has two branches over the reals if and only if k > 1
    assert (k > 1) == (4 * p**3 + 27 * q**2 < 0)


def test_three_planes_or_one():
    one = equivalence(Germ("x**3 - 2*y**3 + z**4 + x*y*z**2", "x y z"), form(UNIMODAL["U_12"]))
    assert one.finish is None
    two = equivalence(Germ("x**3 - 2*x*y**2 + 5*y**3 + z**4 + y**2*z**2", "x y z"), form(UNIMODAL["U_12"]))
    assert two.finish is not None and two.finish.field.degree == 2
    with pytest.raises(NotEquivalent, match="three real lines"):
        equivalence(Germ("x**3 - 3*x*y**2 + z**4 + x*y*z**2", "x y z"), form(UNIMODAL["U_12"]))


def test_functions_at_the_boundary_over_number_fields():
    for text, sign in (("x + y**3 - 3*y*z**2 + z**3 + x*y", -1), ("-x + y**3 + y*z**2 + z**3", 1)):
        made = equivalence(Germ(text, "x y z", "x"), form(BOUNDARY["D_k"], k=4))
        assert made.signs == (1 if text[0] == "x" else -1, sign)
        assert made.finish is not None and made.finish.images[0] == {poly.variable(0, 3): 1}
