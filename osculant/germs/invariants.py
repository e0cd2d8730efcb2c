"""The invariants of a map-germ at the front door, as plain data."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError, UndecidedError

if TYPE_CHECKING:
    from osculant.germs.map_germ import MapGerm

#: what the invariants are called in tables
TITLES = {
    "delta": "δ",
    "double_points": "double points",
    "double_folds": "double folds",
    "cross_caps": "cross-caps",
    "triple_points": "triple points",
    "critical_set_milnor": "μ of critical set",
    "discriminant_milnor": "μ of discriminant",
    "double_curve_milnor": "μ of double curve D²",
    "image_milnor": "μ of image",
    "liftable": "liftable fields",
}


def invariants(germ: MapGerm) -> dict[str, Any]:
    """Invariants of A-equivalence of a germ with n ≤ p, p ≥ 2, as plain data.

    Curves: ``delta`` (double points of a plane curve, for any p the codimension of its ring), ``semigroup``
    (generators). n = 2, p = 3: ``cross_caps``, ``triple_points``, ``double_curve_milnor`` (μ of D², the pairs
    of points with one image), ``image_milnor``. n = p = 2: ``cusps``, ``double_folds``,
    ``critical_set_milnor``, ``discriminant_milnor``. Other dimensions: the isolated points of a stable
    perturbation by their type, such as ``swallowtails`` (n = p = 3), and the last Milnor number.

    p = n or n + 1: ``equation`` of the discriminant or image in y1, …, yp, and ``liftable``, generators of
    the fields of the target that lift to the source, each the text of p components.

    All are counted over ℂ. The image (discriminant) Milnor number is the number of spheres in the image
    (discriminant) of a stable perturbation; where a germ is quasi-homogeneous, it is the extended
    codimension. A value is else a number or "infinite"; null where there is none, with ``reason``, and
    ``undecided`` lists what time or method did not settle. Nothing else for other dimensions.

    >>> from osculant.germs.map_germ import germ
    >>> invariants(germ("x, y**2, y**3 + x**3*y", "x y"))["cross_caps"]
    3
    >>> invariants(germ("t**3, t**4", "t"))["delta"], invariants(germ("x, x*y + y**4", "x y"))["cusps"]
    (3, 2)
    """
    from osculant.cas.germs.invariants import Invariants
    from osculant.cas.germs.search import Patience

    asked = Invariants(germ.exact, lambda: germ.patience).questions()
    germ.clock = Patience(germ.seconds)
    try:
        return answered(asked)
    finally:
        germ.clock = None


def answered(questions: dict[str, Callable[[], Any]]) -> dict[str, Any]:
    """The answers to questions, null with a reason where one is undecided or has no meaning.

    >>> answered({"delta": lambda: 3})
    {'delta': 3, 'reason': {}, 'undecided': []}
    """
    data: dict[str, Any] = {}
    reasons: dict[str, str] = {}
    undecided: list[str] = []
    for name, ask in questions.items():
        data[name] = None
        try:
            data[name] = ask()
        except UndecidedError as error:
            reasons[name] = str(error)
            undecided.append(name)
        except DomainError as error:
            reasons[name] = str(error)
    return {**data, "reason": reasons, "undecided": undecided}


def title(name: str) -> str:
    """What an invariant is called in a table.

    >>> title("delta"), title("points_3_2"), title("cusps")
    ('δ', 'points of type 3, 2', 'cusps')
    """
    if name.startswith("points_"):
        return f"points of type {', '.join(name.split('_')[1:])}"
    return TITLES.get(name, name.replace("_", " "))
