"""Multigerms against Tjurina numbers, δ and values in print."""

from __future__ import annotations

import pytest
import sympy

from osculant.cas.errors import DomainError
from osculant.cas.germs.codimension import codimension as single
from osculant.cas.germs.delta import relative_delta
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.local_algebra import milnor_number
from osculant.cas.germs.multigerm import MultiGerm, codimension, determinacy


def multi(text: str, source: str = "x y") -> MultiGerm:
    return MultiGerm([Germ(part, source) for part in text.split(";")])


def extended(text: str, source: str = "x y") -> int | str:
    return codimension(multi(text, source), extended=True).value


CONTACT = ["x**2 + y**2", "x**2 + y**3", "x**2 + y**6", "x**2*y + y**3", "x**2*y + y**5", "x**3 + y**4"]
CONTACT += ["x**3 + x*y**3", "x**3 + y**5", "x**3 + y**3 + x*y**3", "x**4 + y**4 + x**2*y**3"]


@pytest.mark.parametrize("h", CONTACT)
def test_two_immersions(h: str) -> None:
    """Two sheets in contact by h: the extended codimension is the Tjurina number of h (Hobbs and Kirk)."""
    assert extended(f"x, y, 0; x, y, {h}") == single(Germ(h, "x y"), "K", extended=True).value


#: Cooper, Mond and Wik Atique 2002, the germs of codimension 0 and 1; Hobbs and Kirk 2001
SURFACES = [
    ("x, y, 0; x, 0, y", 0),
    ("x, y, 0; x, 0, y; 0, x, y", 0),
    ("x, y, 0; x, y, x**2 + y**2", 1),
    ("x, y, 0; x, y, x**2 - y**2", 1),
    ("x, y, 0; x, 0, y; x, y, y + x**2", 1),
    ("x, y, 0; x, 0, y; x, y, y + x**4", 3),
    ("x, y, 0; x, 0, y; 0, x, y; x, y, x + y", 1),
    ("x, y**2, x*y; x, x, y", 1),
    ("x, y**2, x*y; x, x + y**2, y", 1),
    ("x, y, 0; x, y, 0", "infinite"),
    ("x, y, 0; x, y, x**2*y", "infinite"),
    ("x, y**2, x*y; x, y**2, x*y", "infinite"),
    ("x, y, 0; x, 0, y; x, y, y", "infinite"),
    ("x, y**2, 0; x, 0, y", "infinite"),
]


@pytest.mark.parametrize(("text", "value"), SURFACES)
def test_surfaces(text: str, value: int | str) -> None:
    assert extended(text) == value


PLANE_CURVES = [
    "t, 0; 0, t",
    "t, 0; 0, t; t, t",
    "t, 0; t, t**2",
    "t, 0; t, t**4",
    "t**2, t**3; 0, t",
    "t**2, t**3; t, 0",
    "t**2, t**3; t**3, t**2",
    "t, 0; 0, t; t, t; t, 2*t",
    "t, 0; t, t**2; t, 2*t**2",
    "t, 0; t, t**2; 0, t",
]


@pytest.mark.parametrize("text", PLANE_CURVES)
def test_plane_curves(text: str) -> None:
    """μ = 2δ − r + 1, and the extended codimension is τ − δ, of the curve's equation."""
    t, x, y = sympy.symbols("t x y")
    equation = sympy.Integer(1)
    for part in text.split(";"):
        first, second = map(sympy.sympify, part.split(","))
        equation *= sympy.resultant(first - x, second - y, t)
    germ, curve = Germ(str(sympy.expand(equation)), "x y"), multi(text, "t")
    delta = relative_delta(curve.branches)
    assert milnor_number(germ) == 2 * delta - len(curve.branches) + 1
    assert extended(text, "t") == single(germ, "K", extended=True).value - delta


def test_plane_to_plane() -> None:
    assert extended("x, y**2; y**2, x") == 0  # transverse folds
    assert extended("x, y**2; x, x**2 + y**2") == 1  # folds in contact
    assert extended("x, y**2; x, x**3 + y**2") == 2
    assert extended("x, y**2; y**2, x; x, x + y**2") == 1  # three folds
    assert extended("x, x*y + y**3; y**2, x") == 1  # a cusp and a fold
    assert extended("x, y**2; x, y**2") == "infinite"


@pytest.mark.parametrize(
    ("text", "degree"),
    [("x, y, 0; x, y, x**2 + y**3", 3), ("x, y, 0; x, 0, y; x, y, y + x**2", 2), ("x, y, 0; x, 0, y", 1)],
)
def test_determinacy(text: str, degree: int) -> None:
    found = determinacy(multi(text))
    assert (found.degree, found.sharp) == (degree, True)


def test_determinacy_is_unchanged_by_higher_terms() -> None:
    whole = multi("x, y, x**5; x + x**4*y, y, x**2 + y**3 + x**3*y**2 - y**5")
    assert codimension(whole, extended=True).value == 2
    assert determinacy(whole).degree == 3
    assert determinacy(multi("x, y, 0; x, y, 0")).degree == "infinite"


@pytest.mark.parametrize(
    "text", ["x, y**2, x*y; x, x, y", "x, y, 0; x, y, x**2 + y**3", "x, y, 0; x, 0, y; x, y, y + x**3"]
)
def test_coordinates_do_not_matter(text: str) -> None:
    x, y = sympy.symbols("x y")
    sources = [(x + y**2 - x * y, y / 2 + x**2), (y + x * y, x - y - y**2 / 3), (x + 2 * y, y - x**2)]
    branches = []
    for part, new in zip(text.split(";"), sources):
        X, Y, Z = (sympy.sympify(f).subs({x: new[0], y: new[1]}, simultaneous=True) for f in part.split(","))
        moved = (X + Y * Z - Z**2, Y - 2 * X + X * Z, Z + Y / 2 - X * Y)
        branches.append(Germ(", ".join(str(sympy.expand(f)) for f in moved), "x y"))
    plain, other = multi(text), MultiGerm(branches)
    assert codimension(other).value == codimension(plain).value
    assert codimension(other, extended=True).value == codimension(plain, extended=True).value


def test_one_branch_is_a_germ() -> None:
    for text in ("x, y**2, y**3 + x**3*y", "x, x*y + y**5, y**3"):
        assert extended(text) == single(Germ(text, "x y"), "A", extended=True).value
        assert codimension(multi(text)).value == single(Germ(text, "x y"), "A").value


def test_branches_must_fit() -> None:
    with pytest.raises(DomainError, match="one source and one target"):
        MultiGerm([Germ("x, y", "x y"), Germ("x", "x y")])
