"""Keys: numbers of a germ that no change of coordinates of its group alters, and that tell classes apart.

A key has parts, each a sequence of dimensions for the orders 0, …, k of jets, exact over the germ's field:

* ``orbit``: the codimension of the orbit in the jets of order i; of a function that of the tangent space with
  constants, which squares in further variables do not change;
* ``unipotent``: the codimension of the orbit of G₁, the subgroup of changes with identical linear part;
* ``algebra``, ``ramification``, ``branching``, ``tjurina``, ``singular``, ``hessian 1``, …: of the ideals of
  `osculant.cas.recognition.ideals`, dim O/(I + M^{i+1});
* ``on H``, ``without H``: the orbit of f restricted to H, and of f with H forgotten;
* ``pencil``: the multiplicities of the roots of the pencil of quadratic forms of two functions;
* ``double points``: of a map of the plane to space, the triple points of a stable perturbation and μ(D²) of
  the curve of pairs of points with one image; two numbers for all orders.

Two germs whose keys differ are not equivalent, over ℝ or ℂ. Germs with one key may be: two real forms of a
class, or members of a family with other moduli, have one key.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import partial

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version, group
from osculant.cas.germs.invariants import Invariants
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition import ideals
from osculant.cas.recognition.discriminants import root_multiplicities
from osculant.cas.recognition.filtered import ideal_dimensions, orbit_codimensions

#: a part of a key: the germ, the group and the order tell a sequence
Part = Callable[[Germ, Group, int], tuple[int, ...]]


def version_of(germ: Germ, g: Group) -> Version:
    """Which tangent space the orbit of a key is of: functions have constants, but for A.

    >>> version_of(Germ("x**2", "x"), group("R")).name, version_of(Germ("x, y**2", "x y"), group("A")).name
    ('EXTENDED', 'ORDINARY')
    """
    return Version.EXTENDED if germ.p == 1 and g.target != "left" else Version.ORDINARY


def _orbit(germ: Germ, g: Group, order: int) -> tuple[int, ...]:
    return orbit_codimensions(germ, g, version_of(germ, g), order)


def _unipotent(germ: Germ, g: Group, order: int) -> tuple[int, ...]:
    return orbit_codimensions(germ, g, Version.UNIPOTENT, order)


def _ideal(
    make: Callable[[Germ, int], list[Polynomial]], germ: Germ, g: Group, order: int
) -> tuple[int, ...]:
    return ideal_dimensions(lambda k: make(germ, k), germ.n, order, germ.field)


def _hessian(excess: int, germ: Germ, g: Group, order: int) -> tuple[int, ...]:
    if excess > ideals.corank(germ):
        return ()
    return ideal_dimensions(lambda k: ideals.hessian(germ, k, excess), germ.n, order, germ.field)


def _plain(g: Group) -> Group:
    return group(g.name.removesuffix("(H)"))


def _on_boundary(germ: Germ, g: Group, order: int) -> tuple[int, ...]:
    restricted = ideals.on_boundary(germ, order + 1)
    return () if restricted is None else _orbit(restricted, _plain(g), order)


def _without_boundary(germ: Germ, g: Group, order: int) -> tuple[int, ...]:
    return _orbit(germ, _plain(g), order)


def _double_points(germ: Germ, g: Group, order: int) -> tuple[int, ...]:
    asked = Invariants(germ).questions()
    found = [asked[name]() for name in ("triple_points", "double_curve_milnor")]
    return tuple(-1 if number == "infinite" else number for number in found)


def _pencil(germ: Germ, g: Group, order: int) -> tuple[int, ...]:
    return root_multiplicities(germ)


def parts(germ: Germ, g: Group) -> Mapping[str, Part]:
    """The parts of a key for such germs, the cheap ones first.

    >>> list(parts(Germ("x, y**2", "x y"), group("A")))
    ['orbit', 'algebra', 'unipotent', 'ramification', 'singular', 'branching']
    """
    found: dict[str, Part] = {"orbit": _orbit}
    if g.source == "boundary":
        return found | {"on H": _on_boundary, "without H": _without_boundary}
    if germ.p == 1 and g.target != "left":
        found["tjurina"] = partial(_ideal, ideals.tjurina)
        if g.target == "none":
            found |= {f"hessian {i}": partial(_hessian, i) for i in (1, 2, 3)}
        return found
    found["algebra"] = partial(_ideal, ideals.algebra)
    if g.target == "left":
        found["unipotent"] = _unipotent
        for name in ("ramification", "singular", "branching"):
            found[name] = partial(_ideal, getattr(ideals, name))
        if (germ.n, germ.p) == (2, 3):
            found["double points"] = _double_points
    else:
        found |= {"pencil": _pencil, "singular": partial(_ideal, ideals.singular)}
    return found


def part(germ: Germ, g: Group, name: str, order: int) -> tuple[int, ...]:
    """One part of the key, in jets of that order; computed once.

    Raises UndecidedError or DomainError for double points that cannot be counted.

    >>> part(Germ("x, x*y + y**3", "x y"), group("A"), "algebra", 4)
    (1, 2, 3, 3, 3)
    """
    known = "key", g, name, order
    if known not in germ.known:
        germ.known[known] = parts(germ, g)[name](germ, g, order)
    found: tuple[int, ...] = germ.known[known]
    return found


@dataclass(frozen=True)
class Key:
    """The key of a germ for a group, in jets of an order: its parts by name."""

    group: str
    order: int
    parts: Mapping[str, tuple[int, ...]]

    def __hash__(self) -> int:
        return hash((self.group, self.order, *self.parts.items()))


def key(germ: Germ, name: str | Group, order: int) -> Key:
    """The whole key of a germ, in jets of that order; parts that cannot be computed are left out.

    >>> s2, b2 = Germ("x, y**2, y**3 + x**3*y", "x y"), Germ("x, y**2, x**2*y + y**5", "x y")
    >>> key(s2, "A", 6).parts["orbit"] == key(b2, "A", 6).parts["orbit"], key(s2, "A", 6) == key(b2, "A", 6)
    (True, False)
    """
    g = group(name)
    found = {}
    for title in parts(germ, g):
        with suppress(DomainError, UndecidedError):
            found[title] = part(germ, g, title, order)
    return Key(g.name, order, found)
