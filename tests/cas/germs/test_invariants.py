"""Invariants against values in print and second ways to the same numbers."""

from __future__ import annotations

from itertools import pairwise

import pytest
import sympy

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.delta import relative_delta, semigroup
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.invariants import Invariants
from osculant.cas.germs.local_algebra import milnor_number, ramification

#: Mond 1985, 1987: cross-caps C, triple points T, extended codimension = image Milnor number
MOND = [
    *((f"x, y**2, y**3 + x**{k + 1}*y", k + 1, 0, k) for k in range(1, 6)),
    *((f"x, y**2, x**2*y + y**{2 * k + 1}", 2, 0, k) for k in range(2, 6)),
    *((f"x, y**2, x*y**3 + x**{k}*y", k, 0, k) for k in range(3, 7)),
    ("x, y**2, x**3*y + y**5", 3, 0, 4),
    *((f"x, x*y + y**{3 * k - 1}, y**3", 2, k - 1, k) for k in range(2, 5)),
    ("x, x*y + y**3, x*y**2 + 2*y**4", 3, 1, 4),
    ("x, y**2, x*y", 1, 0, 0),
]
#: Rieger 1987, Gaffney and Mond 1991: cusps, double folds
RIEGER = [
    ("x, x*y + y**3", 1, 0),
    *((f"x, y**3 + x**{k}*y", k, 0) for k in range(2, 5)),
    *((f"x, x*y + y**{k}", k - 2, (k - 2) * (k - 3) // 2) for k in range(4, 8)),
    ("x, x*y + y**5 + y**7", 3, 3),
    *((f"x, x*y**2 + y**4 + y**{2 * k + 1}", 3, k) for k in range(2, 5)),
    ("x, x*y**2 + y**5 + y**6", 4, 4),
    ("x, x*y**2 + y**5", 4, 4),
    ("x, x**2*y + y**4 + y**5", 4, 2),
    ("x, x**2*y + y**4", 4, 2),
    ("x**2 + y**3, y**2 + x**3", 3, 2),
    ("x**2 + y**3, y**2 + x**5", 3, 3),
    ("x**2 + y**5, y**2 + x**5", 3, 4),
    ("x**2 - y**2 + x**3, x*y", 3, 2),
]
#: the least orders of terms of plane curves, δ by (a − 1)(b − 1)/2 or from the semigroup in print
CURVES = [
    ("t**2, t**3", (2, 3), 1),
    ("t**2, t**9", (2, 9), 4),
    ("t**3, t**4", (3, 4), 3),
    ("t**3, t**7 + t**8", (3, 7), 6),
    ("t**4, t**5 + t**7", (4, 5), 6),
    ("t**5, t**6", (5, 6), 10),
    ("t**4, t**6 + t**7", (4, 6, 13), 8),
    ("t**4, t**6 + t**9", (4, 6, 15), 9),
    ("t**6, t**8 + t**9", (6, 8, 25), 18),
    ("t + t**2, t**2", (1,), 0),
]


def asked(text: str, source: str = "x y") -> dict:
    questions = Invariants(Germ(text, source)).questions()
    return {name: ask() for name, ask in questions.items() if name not in {"equation", "liftable"}}


@pytest.mark.parametrize(("text", "caps", "triple", "spheres"), MOND)
def test_mond(text: str, caps: int, triple: int, spheres: int) -> None:
    germ, found = Germ(text, "x y"), asked(text)
    assert (found["cross_caps"], found["triple_points"], found["image_milnor"]) == (caps, triple, spheres)
    assert ramification(germ).dimension == caps
    assert codimension(germ, "A", extended=True).value == spheres  # they are all quasi-homogeneous
    # Marar and Mond: μ = (μ(D²) + C − 1)/2 + T
    assert 2 * (spheres - triple) == found["double_curve_milnor"] + caps - 1


@pytest.mark.parametrize(("text", "cusps", "folds"), RIEGER)
def test_rieger(text: str, cusps: int, folds: int) -> None:
    invariants, found = Invariants(Germ(text, "x y")), asked(text)
    assert (found["cusps"], found["double_folds"]) == (cusps, folds)
    assert invariants.cusps() == cusps  # by minors
    assert invariants.double_folds() == folds  # by the rings of the discriminant and of the critical set
    assert found["discriminant_milnor"] == found["critical_set_milnor"] + folds


QUASI_HOMOGENEOUS = [
    "x, x*y + y**4",
    "x, x*y + y**6",
    "x, x*y**2 + y**5",
    "x, x**2*y + y**4",
    "x, y**3 + x**4*y",
]


@pytest.mark.parametrize("text", QUASI_HOMOGENEOUS)
def test_discriminants_of_quasi_homogeneous_germs(text: str) -> None:
    """Damon and Mond: the discriminant Milnor number is the extended codimension."""
    found = codimension(Germ(text, "x y"), "A", extended=True).value
    assert asked(text)["discriminant_milnor"] == found


SPACES = [
    ("x, y, z**4 + x*z + y**2*z**2", {"swallowtails": 2, "cuspidal_double_points": 0, "triple_folds": 0}),
    ("x, y, z**5 + x*z + y*z**2", {"swallowtails": 2, "cuspidal_double_points": 2, "triple_folds": 0}),
    ("x, y, z**3 + x**2*z + y**3*z", {"swallowtails": 0, "discriminant_milnor": 2}),
    ("x, y, z**2, z*(z**2 + x**2 + y**2)", {"image_milnor": 1, "quadruple_points": 0}),
    ("x, y, z**2, z*(z**2 + x**3 + y**5)", {"image_milnor": 8, "cross_caps_on_sheets": 0}),
]


@pytest.mark.parametrize(("text", "values"), SPACES)
def test_three_dimensions(text: str, values: dict) -> None:
    """Marar and Tari; Houston and Kirk: Milnor numbers are extended codimensions here too."""
    found = asked(text, "x y z")
    assert values.items() <= found.items()
    spheres = found.get("image_milnor", found.get("discriminant_milnor"))
    assert spheres == codimension(Germ(text, "x y z"), "A", extended=True).value


@pytest.mark.parametrize(("text", "generators", "delta"), CURVES)
def test_plane_curves(text: str, generators: tuple, delta: int) -> None:
    curve, found = Germ(text, "t"), asked(text, "t")
    assert found["delta"] == found["double_points"] == found["image_milnor"] == delta
    assert tuple(found["semigroup"]) == (generators if generators != (1,) else ())
    assert semigroup(curve).delta == delta
    assert semigroup(curve).conductor == 2 * delta
    t, x, y = sympy.symbols("t x y")
    first, second = (sympy.sympify(part) for part in text.split(","))
    equation = sympy.resultant(first - x, second - y, t)
    assert milnor_number(Germ(str(sympy.expand(equation)), "x y")) == 2 * delta


def test_space_curves() -> None:
    """δ is the number of gaps of the numerical semigroup for monomial curves."""
    for orders, gaps in (((3, 4, 5), 2), ((4, 5, 6), 4), ((4, 5, 7), 4), ((5, 6, 7, 8), 5)):
        curve = Germ(", ".join(f"t**{k}" for k in orders), "t")
        assert relative_delta([curve]) == semigroup(curve).delta == gaps


def test_coordinates_do_not_matter() -> None:
    plain = asked("x, y**2, x*y**3 + x**3*y")
    source = {"x": "(x + y*x/2)", "y": "(y - x**2 + x*y)"}
    text = ", ".join("".join(source.get(c, c) for c in part) for part in ("x", "y**2", "x*y**3 + x**3*y"))
    assert asked(text) == plain
    assert asked("sin(x), y**2 + y**2*x, exp(x)*(y**3 + x**3*y)") == asked("x, y**2, y**3 + x**3*y")


def test_infinite_and_meaningless() -> None:
    assert asked("t**3, t**4", "t")["delta"] == 3
    double = Invariants(Germ("t**2, t**4", "t"))
    assert double.delta() == "infinite"
    with pytest.raises(DomainError, match="covers"):
        double.semigroup()
    edge = Invariants(Germ("x, y**2, 0", "x y")).questions()
    assert edge["cross_caps"]() == "infinite"
    with pytest.raises(DomainError, match="not finitely determined"):
        edge["image_milnor"]()
    assert Invariants(Germ("x, x*y, y**3", "x y")).questions()["triple_points"]() == "infinite"
    assert Invariants(Germ("x**2 + y**2", "x y")).questions() == {}
    assert Invariants(Germ("x, x*y", "x y z")).questions() == {}
    corank = Invariants(Germ("x**2, y**2, x*y + x**3 + y**3", "x y")).questions()
    assert corank["cross_caps"]() == 3
    with pytest.raises(UndecidedError, match="corank 1"):
        corank["triple_points"]()


def test_immersions_and_submersions_have_no_special_points() -> None:
    assert set(asked("x + y**2, y").values()) == {0}
    questions = Invariants(Germ("x, y, x*y", "x y")).questions()
    assert [questions[k]() for k in ("cross_caps", "triple_points", "image_milnor")] == [0, 0, 0]


def test_more_of_a_perturbation_never_less() -> None:
    """Numbers of points are upper semicontinuous along the adjacencies of S₁, S₂, and so on."""
    counts = [asked(f"x, y**2, y**3 + x**{k}*y")["cross_caps"] for k in range(1, 6)]
    assert all(a < b for a, b in pairwise(counts))
