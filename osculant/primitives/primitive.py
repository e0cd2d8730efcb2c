"""What the front door knows about a kind of pieces: the records that the files of this folder fill in.

The command line lists the table for its help: kernels, laws and numpy are imported only where they are used.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

from osculant.cas.laws import law as laws

if TYPE_CHECKING:
    from osculant.pieces.piece import Floats

#: how errors are measured, the default first
METRICS = tuple(laws.METRICS)


#: the order of a short arc's error → the record of a fit in the kernels (`osculant.kernels.operations`)
Method: TypeAlias = Callable[[int], Any]


@dataclass(frozen=True)
class Itself:
    """When a curve is of arcs of a primitive: then its pieces are parts of it.

    Attributes:
        shape: what such a curve is.
        forms: of the curve's zeros, those that vanish identically; if only the first do, the curve is level,
            and the primitive has another law there, by the name "level …".
        proof: whether a curve's exact invariants prove it; None if undecided.
        turning: such a curve is cut into pieces that turn by less than this.
    """

    shape: Literal["conic", "circle", "helix"]
    forms: tuple[str, ...]
    proof: Callable[[Any], bool | None]
    turning: float


@dataclass(frozen=True)
class Theorem:
    """Why no spline has fewer pieces than the greedy one, or a smaller largest error for their number.

    It speaks of splines with knots at the split points whose pieces lie over strictly convex arcs.

    Attributes:
        claim: the one that says that an error grows with its arc.
        half_turns: the arcs turn by less than so many times π.
        member: (row of the kernel's table) → Q of the piece in the pencil of its arc, where errors are
            distances along normals, which have to meet it first on its own side; None if they are not.
    """

    claim: str
    half_turns: int = 2
    member: Callable[[Sequence[float]], float] | None = None


@dataclass(frozen=True)
class Primitive:
    """A kind of pieces for the curves of one dimension.

    Attributes:
        name: as `osculant.approximate` takes it, and `osculant.cas.laws.table`.
        plural: as sentences say it.
        dimension: of the curves, 2 or 3.
        arcs: the kinds of arcs that its pieces are made of (`osculant.pieces.kinds.KINDS`).
        methods: by metric and rule, the default first, how a piece is chosen from those tangent to the curve
            at both ends: what loads the kernels and makes their record.
        splits: the special points where no piece can pass, besides cusps; by form of the curve's zeros.
        theory: those where only theory wants a knot, as errors are not monotone across.
        itself: of curves that are arcs of the primitive; None if only straight lines are.
        monotone: whether an error grows with the arc, away from the points above.
        few: where it need not, one piece less is sought for so many, at most, that the search finds.
        theorems: by metric and rule, why the number of pieces that the search finds is the least; where
            there is none, nothing says so.
        smooth: whether pieces meet with a common tangent; others are no candidates for the best.
        fewest: what is said beside the number of pieces where they do not, as "fewest" means other splines.
        bridge: (interval, frame, frame, error) → small pieces from one frame to another, whatever the curve
            does between (`osculant.pieces.bridges`); None if there is nothing of the kind.
        pieces: (rows of the kernel's table, what `osculant.kernels.shapes` makes of them) → the pieces.
        segment: (interval, start, end) → the straight piece.
    """

    name: str
    plural: str
    dimension: int
    arcs: tuple[str, ...]
    methods: Mapping[str, Mapping[str, Method]]
    theory: tuple[str, ...]
    itself: Itself | None
    theorems: Mapping[tuple[str, str], Theorem]
    pieces: Callable[[Floats, Floats], list[Any]]
    segment: Callable[[tuple[float, float], Any, Any], Any]
    splits: tuple[str, ...] = ("inflection",)
    monotone: bool = True
    few: int = 30
    smooth: bool = True
    fewest: str = ""
    bridge: Callable[[tuple[float, float], Any, Any, float], list[Any]] | None = None

    def rules(self, metric: str) -> tuple[str, ...]:
        """The rules for a metric, the default first; none if errors are not measured so."""
        return tuple(self.methods.get(metric, ()))


@dataclass(frozen=True)
class Fit:
    """What pieces are, how their error is measured, and by what rule they are chosen.

    >>> from osculant.primitives.table import choose
    >>> fit = choose("conic", "area")
    >>> fit.rule, fit.order, fit.degree
    ('equisymmetric', 6, 2)
    """

    primitive: Primitive
    metric: str
    rule: str

    def record(self, order: int) -> Any:
        """The record of the method in the kernels, which are loaded only now, for errors of that order."""
        return self.primitive.methods[self.metric][self.rule](order)

    def law(self, kind: str = "generic") -> laws.Law:
        """How the error of one short arc depends on its length, on a stretch of that kind."""
        from osculant.cas.laws.table import law_of

        name = self.primitive.name
        return law_of(f"level {name}" if kind == "level" else name, self.metric)

    @property
    def theorem(self) -> Theorem | None:
        """Why the number of pieces that the search finds is the least; None if nothing says so."""
        return self.primitive.theorems.get((self.metric, self.rule))

    @cached_property
    def order(self) -> int:
        """The error of one short arc is of this order in its length."""
        return self.law().order

    @cached_property
    def degree(self) -> int:
        """1 if the error is a length, 2 if it is an area."""
        return self.law().dimension


def columns(record: Any, table: Floats) -> Any:
    """The columns of a table, as lists, under the names of a `NamedTuple`'s fields.

    >>> import numpy as np
    >>> from osculant.kernels.polygons.shapes import Segment
    >>> columns(Segment, np.arange(14.0).reshape(2, 7)).b
    [1.0, 8.0]
    """
    return record(*table.T.tolist())
