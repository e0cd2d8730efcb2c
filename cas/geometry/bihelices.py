"""Bihelices through two points with given tangents: junction planes, junction lines, junction cylinders.

Two helical arcs, from (p_L, T_L) to (p₀, T₀) and on to (p_R, T_R), each turning less than once. Since a short
helix joins two points with two tangents just if the chord is orthogonal to the difference of the tangents
(Theorem 4.3.2), the junction point p₀ lies in two planes, so on the *junction line* l(T₀) of its tangent
(thesis 4.4). The lines of all T₀ on one circle of the unit sphere through T_L and T_R are parallel and lie on
one circular cylinder, the *junction cylinder*: its axis is that of the screw motion along the circle's axis
that takes p_L and T_L to p_R and T_R. Nothing but + − * / is used, so rational data have exact answers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from osculant.cas.errors import DomainError
from osculant.cas.geometry.short_helices import ShortHelix, short_helix
from osculant.cas.numbers.power_series import ratio
from osculant.cas.numbers.vectors import Vector3, add, cross, dot, scale, subtract

#: binary digits that floating point data may lose before a direction counts as undetermined
GUARD = 12


@dataclass(frozen=True)
class End:
    """A point and the unit tangent there; coordinates of any one kind of number."""

    point: Vector3
    tangent: Vector3


@dataclass(frozen=True)
class Plane:
    """The plane through a point with a normal of any length."""

    point: Vector3
    normal: Vector3

    def offset(self, p: Vector3) -> Any:
        """⟨p − point, normal⟩: 0 just for the points of the plane."""
        return dot(subtract(p, self.point), self.normal)


@dataclass(frozen=True)
class Line:
    """The line through a point with a direction of any length."""

    point: Vector3
    direction: Vector3

    def at(self, factor: Any) -> Vector3:
        """The point plus a multiple of the direction."""
        return add(self.point, scale(factor, self.direction))

    def nearest(self, p: Vector3) -> Vector3:
        """The point of the line that is nearest to p.

        >>> Line((0, 0, 5), (0, 0, 1)).nearest((3, 4, 12)) == (0, 0, 12)
        True
        """
        along = dot(subtract(p, self.point), self.direction)
        length = dot(self.direction, self.direction)
        return self.at(along * _inverse(length))


@dataclass(frozen=True)
class Cylinder:
    """A circular cylinder about an axis, with the screw motion along it.

    Attributes:
        axis: a point of the axis and its direction m, of any length.
        radius_squared: of the cylinder.
        cosine: of the angle ω of the screw.
        sine: sin(ω)/|m|, which is rational for rational data.
        advance: the screw moves along the axis by this multiple of m.
    """

    axis: Line
    radius_squared: Any
    cosine: Any
    sine: Any
    advance: Any

    def distance_squared(self, p: Vector3) -> Any:
        """The square of the distance of p from the axis."""
        out = subtract(p, self.axis.nearest(p))
        return dot(out, out)

    def turn(self, v: Vector3) -> Vector3:
        """The screw applied to a vector: its rotation alone."""
        m = self.axis.direction
        kept = scale((1 - self.cosine) * dot(v, m) * _inverse(dot(m, m)), m)
        return add(scale(self.cosine, v), scale(self.sine, cross(m, v)), kept)

    def screw(self, p: Vector3) -> Vector3:
        """The screw applied to a point."""
        moved = add(self.axis.point, self.turn(subtract(p, self.axis.point)))
        return add(moved, scale(self.advance, self.axis.direction))

    def mesh(
        self, through: Vector3, low: float, high: float, rows: int = 2, columns: int = 49
    ) -> list[list[Vector3]]:
        """A grid of points in floats, to draw the cylinder as a surface or, by columns, its junction lines.

        Args:
            through: a point of the cylinder, on the first and the last line.
            low: the grid begins at this distance along the axis from that point …
            high: … and ends at this one.
            rows: number of points on each line, at least 2.
            columns: number of lines around the axis, at least 2.

        >>> tube = Cylinder(Line((0, 0, 0), (0, 0, 2)), 1, 1, 0, 0)
        >>> _, top = tube.mesh((1, 0, 0), 0, 3, 2, 3)
        >>> [tuple(round(c, 9) + 0 for c in p) for p in top]
        [(1.0, 0.0, 3.0), (-1.0, 0.0, 3.0), (1.0, 0.0, 3.0)]
        """
        m = [float(c) for c in self.axis.direction]
        unit = [c / math.hypot(*m) for c in m]
        foot = [float(c) for c in self.axis.nearest(through)]
        out = [float(c) - f for c, f in zip(through, foot)]
        side = [float(c) for c in cross(unit, out)]
        grid: list[list[Vector3]] = []
        for i in range(rows):
            height = low + (high - low) * i / (rows - 1)
            row: list[Vector3] = []
            for j in range(columns):
                angle = 2 * math.pi * j / (columns - 1)
                x, y, z = (
                    f + height * e + math.cos(angle) * p + math.sin(angle) * q
                    for f, e, p, q in zip(foot, unit, out, side)
                )
                row.append((x, y, z))
            grid.append(row)
        return grid


def junction_plane(end: End, tangent: Vector3) -> Plane:
    """The points that a short helix from ``end`` reaches with the given tangent: a plane through the end.

    The end itself belongs to the plane, but no helix leads there. Raises DomainError for the end's own
    tangent, with which only the straight segment ends.

    >>> junction_plane(End((1, 2, 3), (1, 0, 0)), (0, 1, 0))
    Plane(point=(1, 2, 3), normal=(-1, 1, 0))
    """
    normal = subtract(tangent, end.tangent)
    if _negligible(dot(normal, normal), 1):
        raise DomainError(
            f"The junction tangent {_shown(tangent)} equals the tangent at an end: only a straight segment "
            "has equal tangents at both ends, so choose another."
        )
    return Plane(end.point, normal)


def junction_line(left: End, right: End, tangent: Vector3) -> Line:
    """The line l(T₀) of all junction points whose junction tangent is T₀ (thesis 4.4 and Lemma B.2.1).

    Its direction is (T₀ − T_L) × (T_R − T₀), not normalised.

    Raises DomainError if T₀ is T_L or T_R, or if T_L = T_R. Three different points of a sphere are never on
    one line, so the two planes are parallel in no other case; then either each of their points would do, or
    there is none.

    >>> left, right = End((0, 0, 0), (1, 0, 0)), End((2, 1, 1), (0, 1, 0))
    >>> junction_line(left, right, (0, 0, 1)).direction
    (-1, -1, -1)
    """
    first, second = junction_plane(left, tangent), junction_plane(right, tangent)
    u, v = first.normal, scale(-1, second.normal)
    direction = cross(u, v)
    below = dot(direction, direction)
    if _negligible(below, dot(u, u) * dot(v, v)):
        raise DomainError(
            f"Both ends have the tangent {_shown(left.tangent)}: the two planes of junction points are "
            "parallel, and no line is determined; split the arc elsewhere."
        )
    gamma = dot(subtract(right.point, left.point), v)
    across = add(scale(-dot(u, v), u), scale(dot(u, u), v))
    return Line(add(left.point, scale(gamma * _inverse(below), across)), direction)


def junction_cylinder(left: End, right: End, axis: Vector3) -> Cylinder:
    """The cylinder of the junction lines parallel to ``axis``, and its screw motion from left to right.

    Args:
        left: p_L and T_L.
        right: p_R and T_R.
        axis: m orthogonal to T_R − T_L, of any length, such as the direction of a junction line; the
            junction tangents of these lines are on the circle about m through T_L and T_R.

    With n = m/|m|, d and u the parts of p_R − p_L and of T orthogonal to n, and ω the angle from u_L to u_R
    about n: radius |d|/(2|sin(ω/2)|), and the axis goes through p_L + d/2 + (n × d)/(2 tan(ω/2)).
    For d = 0 all these lines are the axis itself and the radius is 0.

    Raises DomainError if T_L = T_R, or if m is not orthogonal to T_R − T_L.

    >>> from fractions import Fraction as Q
    >>> left, right = End((Q(0), Q(0), Q(0)), (Q(1), Q(0), Q(0))), End((Q(2), Q(0), Q(3)), (Q(0), Q(1), Q(0)))
    >>> cylinder = junction_cylinder(left, right, (Q(0), Q(0), Q(1)))
    >>> cylinder.radius_squared, cylinder.screw(left.point) == right.point
    (Fraction(2, 1), True)
    """
    change = subtract(right.tangent, left.tangent)
    length = dot(axis, axis)
    if _negligible(dot(change, change), 1):
        raise DomainError(
            f"Both ends have the tangent {_shown(left.tangent)}: no screw with a rotation joins them, so "
            "there is no junction cylinder."
        )
    tilt = dot(change, axis)
    if length == 0 or not _negligible(tilt * tilt, length):
        raise DomainError(
            f"The axis {_shown(axis)} of a junction cylinder must be orthogonal to the difference "
            f"{_shown(change)} of the end tangents."
        )
    u_left, u_right = (_orthogonal(end.tangent, axis) for end in (left, right))
    shrink = _inverse(dot(u_left, u_left))
    cosine = dot(u_left, u_right) * shrink
    sine = dot(axis, cross(u_left, u_right)) * shrink * _inverse(length)
    step = subtract(right.point, left.point)
    d = _orthogonal(step, axis)
    # tan(ω/2) = (1 − cos ω)/sin ω, which stays finite where ω = π
    half = _inverse(2 * (1 - cosine))
    foot = add(left.point, scale((1 - cosine) * half, d), scale(sine * half, cross(axis, d)))
    return Cylinder(Line(foot, axis), dot(d, d) * half, cosine, sine, dot(step, axis) * _inverse(length))


@dataclass(frozen=True)
class Bihelix:
    """Two short helices that meet with a common tangent."""

    left: ShortHelix
    right: ShortHelix

    @property
    def junction(self) -> End:
        """Junction point p₀ and junction tangent T₀."""
        return End(self.right.helix.point, self.right.helix.tangent)


def bihelix_through(left: End, right: End, tangent: Vector3, point: Vector3) -> Bihelix:
    """The bihelix between two ends with a given junction tangent and junction point, in mpmath numbers.

    Args:
        left: p_L and T_L.
        right: p_R and T_R.
        tangent: T₀, a unit vector.
        point: p₀, on the junction line of T₀ and different from p_L and p_R.

    Raises DomainError if p₀ is not on l(T₀), or is one of the ends, or l(T₀) does not exist.

    >>> from mpmath import mpf
    >>> left, right = End((mpf(0), 0, 0), (0, mpf(1), 0)), End((mpf(2), 2, 1), (0, mpf(1), 0))
    >>> bihelix_through(left, right, (mpf(1), 0, 0), (mpf(1), 1, mpf(1) / 2))
    Traceback (most recent call last):
    ...
    osculant.cas.errors.DomainError: Both ends have the tangent (0, 1.0, 0): the two planes of junction
    points are parallel, and no line is determined; split the arc elsewhere.
    """
    junction_line(left, right, tangent)  # for its errors only: they name the reason
    first = short_helix(left.point, left.tangent, point, tangent)
    return Bihelix(first, short_helix(point, tangent, right.point, right.tangent))


def _orthogonal(v: Vector3, m: Vector3) -> Vector3:
    """The part of v orthogonal to m."""
    return subtract(v, scale(dot(v, m) * _inverse(dot(m, m)), m))


def _inverse(value: Any) -> Any:
    """1/value, exact for integers too."""
    return ratio(1, 1, value) / value


def _negligible(square: Any, size: Any) -> bool:
    """Whether a sum of squares is 0, or for floating point numbers is lost in the rounding of ``size``."""
    if isinstance(square, float):
        return bool(square <= size * 2.0 ** (2 * GUARD - 106))
    if type(square).__module__.startswith("mpmath"):
        import mpmath

        return bool(square <= size * mpmath.mpf(2) ** (2 * (GUARD - mpmath.mp.prec)))
    return bool(square == 0)


def _shown(v: Vector3) -> str:
    return f"({', '.join(str(c) for c in v)})"
