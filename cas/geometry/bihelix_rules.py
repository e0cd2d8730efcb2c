"""Which bihelix of the three-parameter family: the thesis's rule, and the one with equal peaks (thesis 4.6).

Both take the junction tangent the approximation theorem asks for, T₀ = normalise(T − κ′(σ²/24 + u²/2)N) at
the offset u from the middle of an arc of length σ. The *thesis rule* has u = 0 and the point of the junction
line nearest to the middle of the arc; the *equioscillating rule* takes the point nearest to the curve, and
the u at which the largest distances left and right of the junction are equal. This is the reference, in
mpmath numbers at the working precision.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath as mp

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.expression import Node
from osculant.cas.geometry.bihelices import Bihelix, End, Line, bihelix_through, junction_line
from osculant.cas.geometry.short_helices import ShortHelix
from osculant.cas.jets.space import SpaceJet
from osculant.cas.numbers.fields import Multiprecision
from osculant.cas.numbers.roots import increasing_root, root_between
from osculant.cas.numbers.taylor import program
from osculant.cas.numbers.vectors import Vector3, add, cross, dot, scale, subtract

#: points of each side at which a peak is looked for, and steps of any iteration
SAMPLES, STEPS = 10, 60
#: points of a helix among which the foot of a point is looked for first
TABLE = 24
#: offsets tried on each side of the middle for the sign change of the difference of the peaks
OFFSETS = 16


@dataclass(frozen=True)
class SpaceArc:
    """An arc of a parametric space curve.

    Args:
        coordinates: three formulas in the variable t.
        low: parameter of the left end.
        high: of the right one, larger.
    """

    coordinates: Sequence[Node]
    low: Any
    high: Any

    def jet(self, t: Any) -> SpaceJet:
        """The curve's jet of order 3 at a parameter value."""
        return SpaceJet(*self._program.run(mp.mpf(t), Multiprecision()))

    @cached_property
    def _program(self) -> Any:
        return program(tuple(self.coordinates), 3)

    def length(self, low: Any, high: Any) -> Any:
        """Arc length between two parameter values, by mpmath's quadrature."""
        return mp.quad(lambda t: self.jet(t).speed, [low, high], method="gauss-legendre")

    @cached_property
    def sigma(self) -> Any:
        """σ, the length of the whole arc."""
        return self.length(self.low, self.high)

    def after(self, length: Any) -> Any:
        """The parameter value at an arc length from the left end."""
        start = self.low + (self.high - self.low) * length / self.sigma
        known = {"t": self.low, "length": mp.mpf(0)}

        def value_and_slope(t: Any) -> tuple[Any, Any]:
            known["length"] += self.length(known["t"], t)  # the rest of the arc only
            known["t"] = t
            return known["length"] - length, self.jet(t).speed

        return increasing_root(value_and_slope, self.low, self.high, start)

    @cached_property
    def ends(self) -> tuple[End, End]:
        """Points and tangents at both ends."""
        left, right = (self.jet(t) for t in (self.low, self.high))
        return End(left.point(0), left.tangent), End(right.point(0), right.tangent)

    def foot(self, line: Line, start: Any) -> Any:
        """The parameter of the curve point nearest to a line, near a first value."""
        unit = scale(1 / mp.sqrt(dot(line.direction, line.direction)), line.direction)

        def value_and_slope(t: Any) -> tuple[Any, Any]:
            jet = self.jet(t)
            away, velocity = (
                subtract(v, scale(dot(v, unit), unit))
                for v in (subtract(jet.point(0), line.point), jet.point(1))
            )
            return dot(away, velocity), dot(velocity, velocity) + dot(away, jet.point(2))

        return increasing_root(value_and_slope, self.low, self.high, start)


def thesis_bihelix(arc: SpaceArc) -> Bihelix:
    """Junction tangent T* from the middle of the arc, junction point on l(T*) nearest to the middle (4.1.2).

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> arc = SpaceArc(parse_tuple("t, t^2, t^3"), mp.mpf(1), mp.mpf("1.1"))
    >>> print(mp.nstr(max(peaks(arc, thesis_bihelix(arc))), 5))
    4.5103e-5
    """
    middle = arc.jet(arc.after(arc.sigma / 2))
    tangent = junction_tangent(middle, arc.sigma, mp.mpf(0))
    line = junction_line(*arc.ends, tangent)
    return bihelix_through(*arc.ends, tangent, line.nearest(middle.point(0)))


def junction_tangent(jet: SpaceJet, sigma: Any, u: Any) -> Vector3:
    """normalise(T − κ′(σ²/24 + u²/2)N) at the jet of the curve at the offset u from the middle."""
    lean = jet.curvature_slope * (sigma * sigma / 24 + u * u / 2)
    return scale(1 / mp.sqrt(1 + lean * lean), subtract(jet.tangent, scale(lean, jet.normal)))


def shifted_bihelix(arc: SpaceArc, u: Any) -> Bihelix:
    """The bihelix whose junction is at the arc length u from the middle, nearest to the curve."""
    t = arc.after(arc.sigma / 2 + u)
    tangent = junction_tangent(arc.jet(t), arc.sigma, u)
    line = junction_line(*arc.ends, tangent)
    near = arc.jet(arc.foot(line, t)).point(0)
    return bihelix_through(*arc.ends, tangent, line.nearest(near))


def equioscillating_bihelix(arc: SpaceArc, digits: int = 6) -> Bihelix:
    """The shifted bihelix whose peaks left and right of the junction agree to a relative 10^−digits.

    Raises UndecidedError if no offset tried changes the sign of their difference: long arcs may have none.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> arc = SpaceArc(parse_tuple("t, t^2, t^3"), mp.mpf(1), mp.mpf("1.1"))
    >>> print(mp.nstr(max(peaks(arc, equioscillating_bihelix(arc))), 5))
    2.2892e-5
    """

    def difference(u: Any) -> Any:
        left, right = peaks(arc, shifted_bihelix(arc, u))
        return (left - right) / (left + right)

    return shifted_bihelix(arc, root_between(difference, *_bracket(arc, difference), mp.mpf(10) ** -digits))


def _bracket(arc: SpaceArc, difference: Callable[[Any], Any]) -> tuple[Any, Any]:
    """The two offsets nearest to the middle between which the peaks change places."""
    at_middle = difference(mp.mpf(0))
    edges = {1: (mp.mpf(0), at_middle), -1: (mp.mpf(0), at_middle)}
    for i in range(1, OFFSETS):
        for side, (low, low_value) in list(edges.items()):
            high = side * arc.sigma * i / (2 * OFFSETS)
            try:
                high_value = difference(high)
            except (DomainError, UndecidedError):  # so far out there is no such bihelix
                del edges[side]
                continue
            if mp.sign(high_value) != mp.sign(low_value):
                return low, high
            edges[side] = high, high_value
    raise UndecidedError(
        f"No junction makes the peaks equal on the arc from t = {mp.nstr(arc.low, 8)} to "
        f"{mp.nstr(arc.high, 8)}: halve it."
    )


def peaks(arc: SpaceArc, bihelix: Bihelix) -> tuple[Any, Any]:
    """The largest distances of the curve from the bihelix on the left and on the right of its junction."""
    junction = bihelix.junction
    plane = Line(junction.point, junction.tangent)
    middle = arc.after(arc.sigma * bihelix.left.length / (bihelix.left.length + bihelix.right.length))
    t = increasing_root(lambda t: _height(arc.jet(t), plane), arc.low, arc.high, middle)
    return _peak(arc, bihelix.left, arc.low, t), _peak(arc, bihelix.right, t, arc.high)


def _height(jet: SpaceJet, plane: Line) -> tuple[Any, Any]:
    return dot(subtract(jet.point(0), plane.point), plane.direction), dot(jet.point(1), plane.direction)


def _peak(arc: SpaceArc, piece: ShortHelix, low: Any, high: Any) -> Any:
    """The largest distance of the curve between two parameters from one helix: samples, then Newton."""
    helix = _Runner(piece)
    found = []
    for i in range(SAMPLES + 1):
        t = low + (high - low) * i / SAMPLES
        p = arc.jet(t).point(0)
        s = helix.foot(p)
        found.append((_square(subtract(p, helix.at(s)[0])), t, s))
    best = max(range(SAMPLES + 1), key=lambda i: found[i][0])
    square, t, s = found[best]
    spacing = abs(high - low) / SAMPLES
    for _ in range(STEPS):
        jet = arc.jet(t)
        point, tangent, bend = helix.at(s)
        away = subtract(jet.point(0), point)
        # half the derivatives of the squared distance by t, at the foot s(t)
        first = dot(away, jet.point(1))
        stiff = 1 - dot(away, bend)
        turn = dot(jet.point(1), tangent)
        second = dot(jet.point(1), jet.point(1)) + dot(away, jet.point(2)) - turn * turn / stiff
        if second >= 0:
            break  # not concave: the largest sample is at the junction
        new = t - first / second
        if not low <= new <= high or abs(new - found[best][1]) > 2 * spacing:
            break
        p = arc.jet(new).point(0)
        s = helix.foot(p)
        square, moved, t = max(square, _square(subtract(p, helix.at(s)[0]))), abs(new - t), new
        if moved <= spacing * mp.sqrt(mp.eps):
            break
    return mp.sqrt(square)


class _Runner:
    """A short helix with everything that does not depend on the arc length computed once."""

    def __init__(self, piece: ShortHelix) -> None:
        helix = piece.helix
        self.rate, self.origin = helix.rate, helix.point
        self.along = scale(dot(helix.tangent, helix.axis), helix.axis) if helix.curvature else helix.tangent
        self.out = subtract(helix.tangent, self.along)
        self.side = cross(helix.tangent, helix.axis) if helix.curvature else self.out
        self.spacing = piece.length / TABLE
        self.table = [(self.spacing * i, self.at(self.spacing * i)[0]) for i in range(TABLE + 1)]

    def at(self, s: Any) -> tuple[Vector3, Vector3, Vector3]:
        """Point, unit tangent and its derivative at arc length s."""
        c, w = mp.cos_sin(self.rate * s)
        half = mp.sin(self.rate * s / 2)
        r = 1 / self.rate if self.rate else mp.mpf(0)
        point = add(
            self.origin, scale(s, self.along), scale(w * r, self.out), scale(2 * half * half * r, self.side)
        )
        tangent = add(self.along, scale(c, self.out), scale(w, self.side))
        bend = scale(self.rate, subtract(scale(c, self.side), scale(w, self.out)))
        return point, tangent, bend

    def foot(self, p: Vector3) -> Any:
        """The arc length of the point nearest to p; a little beyond the ends the helix is continued."""
        near = min(self.table, key=lambda row: _square(subtract(p, row[1])))[0]

        def value_and_slope(s: Any) -> tuple[Any, Any]:
            point, tangent, bend = self.at(s)
            away = subtract(p, point)
            return -dot(away, tangent), 1 - dot(away, bend)

        return increasing_root(value_and_slope, near - self.spacing, near + self.spacing, near)


def _square(v: Vector3) -> Any:
    return dot(v, v)
