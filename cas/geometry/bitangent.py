"""The bitangent conics of one arc in as many digits as asked for: slow, precise, apart from the kernels.

The pencil F = l₁² − 4Q l₀l₂ of `osculant.cas.geometry.pencil` (thesis 3.3, reconstructed) in mpmath's
arithmetic at its current precision: displacement along the normals, its peaks, the parabola, the conic of
least Hausdorff distance by equioscillation (`osculant.cas.geometry.moons` has the areas). An oracle for
claims and tests.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from mpmath import mp

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry.vectors import Vector, bracket
from osculant.cas.numbers.fields import Multiprecision
from osculant.cas.numbers.roots import root_between
from osculant.cas.numbers.taylor import program

#: inner samples between which peaks and crossings are looked for
SAMPLES = 40
#: Newton steps for Q, each with peaks exact to the working precision
STEPS = 60


def _real(value: Any, what: str) -> Any:
    """An mpmath number; raises DomainError for anything that is no real number."""
    try:
        return mp.mpf(value)
    except (TypeError, ValueError):
        raise DomainError(
            f"{what} {value!r} is not a real number: give a float or an mpmath number."
        ) from None


class ReferenceCurve:
    """A plane curve from its formulas: point, unit tangent, speed and curvature in mpmath numbers.

    Args:
        coordinates: text such as "t*cos(t), t*sin(t)", or the two parsed formulas, in the variable t.

    >>> circle = ReferenceCurve("cos(t), sin(t)")
    >>> float(circle.frame(mp.mpf(1)).curvature)
    1.0
    """

    def __init__(self, coordinates: str | Sequence[Node]) -> None:
        nodes = parse_tuple(coordinates) if isinstance(coordinates, str) else tuple(coordinates)
        if len(nodes) != 2:
            raise DomainError(f"A plane curve has two coordinates, not {len(nodes)}: give x(t), y(t).")
        self._program = program(nodes, 2)
        self._field = Multiprecision()

    def frame(self, t: Any) -> Frame:
        """The curve at a parameter; raises DomainError where it is undefined or has no tangent."""
        t = _real(t, "The parameter")
        try:
            (x0, x1, x2), (y0, y1, y2) = self._program.run(t, self._field)
        except ZeroDivisionError:
            raise DomainError(
                f"The curve is undefined at t = {mp.nstr(t, 10)}: end the arc before."
            ) from None
        speed = mp.hypot(x1, y1)
        if not mp.isfinite(speed) or speed == 0:
            raise DomainError(f"The curve has no tangent at t = {mp.nstr(t, 10)}: end the arc before.")
        return Frame((x0, y0), (x1 / speed, y1 / speed), speed, (x1 * y2 - y1 * x2) / speed**3)


@dataclass(frozen=True)
class Frame:
    """A point of a curve, its unit tangent T, the speed ds/dt and the signed curvature κ."""

    point: Vector
    tangent: Vector
    speed: Any
    curvature: Any

    @property
    def normal(self) -> Vector:
        """N, to the left of T."""
        return -self.tangent[1], self.tangent[0]


@dataclass(frozen=True)
class Displacement:
    """Where the normal at a point of the curve meets a bitangent conic.

    Attributes:
        d: the signed distance along the left normal.
        across, along: derivatives of F at the foot along N and T; ``along`` = 0 at a common normal.
        by_q: ∂d/∂Q.
        on_arc: whether the foot lies on the arc of the conic, not elsewhere on the conic.
    """

    d: Any
    across: Any
    along: Any
    by_q: Any
    on_arc: bool


class BitangentPencil:
    """The conics tangent to the arc α[a, b] at both its ends, one for each Q > 0.

    Args:
        curve: a `ReferenceCurve`.
        a, b: parameters of the ends; the arc must be convex and turn by less than 2π.

    Raises DomainError if the chord or the tangents at the ends are degenerate; so do the methods for a Q that
    is not positive and finite.

    >>> quarter = BitangentPencil(ReferenceCurve("cos(t), sin(t)"), 0, mp.pi / 2)
    >>> mp.nstr(quarter.weight(quarter.through(0.3))**2, 12), mp.nstr(quarter.hausdorff(quarter.parabola), 6)
    ('0.5', '0.0606602')
    """

    def __init__(self, curve: ReferenceCurve, a: Any, b: Any) -> None:
        self.curve, self.a, self.b = curve, *(_real(end, "The end of an arc") for end in (a, b))
        self.first, self.last = curve.frame(self.a), curve.frame(self.b)
        p, q = self.first.point, self.last.point
        self.chord = mp.hypot(q[0] - p[0], q[1] - p[1])
        if self.chord == 0:
            raise DomainError(f"The arc over [{a}, {b}] has no chord: its ends are one point.")
        self.direction = ((q[0] - p[0]) / self.chord, (q[1] - p[1]) / self.chord)
        sin_a = bracket(self.first.tangent, self.direction)
        sin_b = bracket(self.direction, self.last.tangent)
        #: sign of the curvature: +1 turns left
        self.side = 1 if sin_a > 0 else -1
        self.sin_a, self.sin_b = self.side * sin_a, self.side * sin_b
        if not (self.sin_a > 0 and self.sin_b > 0):
            raise DomainError(f"The arc over [{a}, {b}] does not bend to one side of its chord: shorten it.")
        self.sin_psi = self.side * bracket(self.first.tangent, self.last.tangent)
        self._frames: dict[Any, Frame] = {self.a: self.first, self.b: self.last}

    def frame(self, t: Any) -> Frame:
        """The curve's frame, kept: other members of the pencil ask for it again."""
        if t not in self._frames:
            self._frames[t] = self.curve.frame(t)
        return self._frames[t]

    def lines(self, point: Vector) -> tuple[Any, Any, Any]:
        """(l₀, l₁, l₂) at a point: distances from the tangent at the end, the chord, the first tangent."""
        p, q = self.first.point, self.last.point
        from_p, from_q = (point[0] - p[0], point[1] - p[1]), (point[0] - q[0], point[1] - q[1])
        return (
            bracket(self.last.tangent, from_q),
            bracket(self.direction, from_p),
            bracket(self.first.tangent, from_p),
        )

    def weight(self, q: Any) -> Any:
        """The rational Bézier weight w of the member Q: 1 parabola, below ellipses, above hyperbolas."""
        return self.sin_psi * mp.sqrt(_positive(q) / (self.sin_a * self.sin_b))

    def control(self, q: Any) -> Vector:
        """wP₁ = wP₀ + V of the member Q, finite also where the end tangents are parallel."""
        reach = self.chord * mp.sqrt(_positive(q) * self.sin_b / self.sin_a)
        w, (x, y), (u, v) = self.weight(q), self.first.point, self.first.tangent
        return w * x + reach * u, w * y + reach * v

    def member(self, q: Any, x: Any) -> Vector:
        """The point of the member Q at the Bézier parameter x in [0, 1]."""
        b0, b1, b2 = (1 - x) ** 2, 2 * x * (1 - x), x * x
        m, below = self.control(q), b0 + self.weight(q) * b1 + b2
        (x0, y0), (x2, y2) = self.first.point, self.last.point
        return (b0 * x0 + b1 * m[0] + b2 * x2) / below, (b0 * y0 + b1 * m[1] + b2 * y2) / below

    @property
    def parabola(self) -> Any:
        """The Q of the parabola, w = 1; raises DomainError if the arc turns by π or more."""
        if self.sin_psi <= 0:
            raise DomainError(
                f"No parabola touches the arc over [{mp.nstr(self.a, 8)}, {mp.nstr(self.b, 8)}] at both "
                f"ends: "
                "it turns by π or more."
            )
        return self.sin_a * self.sin_b / self.sin_psi**2

    def through(self, t: Any) -> Any:
        """The Q of the member through the inner point α(t); raises DomainError where there is none."""
        l0, l1, l2 = self.lines(self.frame(_real(t, "The parameter")).point)
        if not l0 * l2 > 0:
            raise DomainError(
                f"No single bitangent conic passes through the point at t = {mp.nstr(mp.mpf(t), 10)}: take "
                f"an inner point of the arc over [{mp.nstr(self.a, 8)}, {mp.nstr(self.b, 8)}]."
            )
        return l1**2 / (4 * l0 * l2)

    def displacement(self, t: Any, q: Any) -> Displacement:
        """The displacement of the member Q at α(t); raises UndecidedError if the normal misses the conic."""
        frame, q = self.frame(t), _positive(q)
        l0, l1, l2 = self.lines(frame.point)
        n0, n1, n2 = self._directions(frame.normal)
        second, first, rest = n1**2 - 4 * q * n0 * n2, 2 * (l1 * n1 - 2 * q * (l0 * n2 + l2 * n0)), (
            l1**2 - 4 * q * l0 * l2
        )  # fmt: skip
        under = first**2 - 4 * second * rest
        if under <= 0:
            raise UndecidedError(f"The normal at t = {mp.nstr(t, 8)} misses the conic: the arc is too long.")
        root = mp.sign(first) * mp.sqrt(under)
        d = -2 * rest / (first + root)
        f0, f1, f2 = l0 + d * n0, l1 + d * n1, l2 + d * n2
        t0, t1, t2 = self._directions(frame.tangent)
        along = 2 * (f1 * t1 - 2 * q * (f0 * t2 + f2 * t0))
        s = self.side
        # beyond the ends by no more than rounding
        slack = -(mp.eps ** mp.mpf("0.5")) * self.chord
        on_arc = bool(s * f0 >= slack and s * f2 >= slack and s * f1 <= -slack)
        return Displacement(d, root, along, 4 * f0 * f2 / root, on_arc)

    def _directions(self, v: Vector) -> tuple[Any, Any, Any]:
        return bracket(self.last.tangent, v), bracket(self.direction, v), bracket(self.first.tangent, v)

    @cached_property
    def grid(self) -> list[Any]:
        """Inner parameters between which `peaks` and `crossings` look for changes of sign."""
        return [self.a + (self.b - self.a) * i / (SAMPLES + 1) for i in range(1, SAMPLES + 1)]

    def peaks(self, q: Any) -> list[tuple[Any, Any]]:
        """(t, d) at the inner extremes of the displacement: where curve and conic have a common normal."""
        seen = [self.displacement(t, q) for t in self.grid]
        found = [
            root_between(lambda t: self.displacement(t, q).along, low, high)
            for low, high, one, two in zip(self.grid, self.grid[1:], seen, seen[1:])
            if one.along * two.along <= 0
        ]
        return [(t, self.displacement(t, q).d) for t in found]

    def crossings(self, q: Any) -> list[Any]:
        """The inner parameters where curve and conic meet, if they cross there."""
        offset = [self.through(t) - q for t in self.grid]
        return [
            root_between(lambda t: self.through(t) - q, low, high)
            for low, high, one, two in zip(self.grid, self.grid[1:], offset, offset[1:])
            if one * two <= 0
        ]

    def hausdorff(self, q: Any) -> Any:
        """max|d| of the member Q, to the working precision; UndecidedError if a foot is off the arc."""
        for t in self.grid:
            if not self.displacement(t, q).on_arc:
                raise UndecidedError(f"The normal at t = {mp.nstr(t, 8)} misses the conic's arc.")
        return max((abs(d) for _, d in self.peaks(q)), default=mp.mpf(0))

    def best(self) -> Any:
        """The Q of least Hausdorff distance: max d = −min d (Corollary 3.3.3), by Newton's method.

        Each step needs the peaks of one member and ∂d/∂Q there. Raises UndecidedError if it does not settle.
        """
        q, before = self.through((self.a + self.b) / 2), mp.inf
        for _ in range(STEPS):
            peaks = [*self.peaks(q), (self.a, mp.mpf(0))]
            (top, high), (bottom, low) = max(peaks, key=lambda p: p[1]), min(peaks, key=lambda p: p[1])
            slope = sum(self.displacement(t, q).by_q for t in (top, bottom))
            step = (high + low) / slope
            # quadratic convergence ends where the steps are the rounding of the displacements
            if step == 0 or (abs(step) >= before / 2 and abs(step) < q * mp.sqrt(mp.eps)):
                return q
            q, before = q - max(-q / 2, min(q / 2, step)), abs(step)
        raise UndecidedError(
            f"The best conic over [{mp.nstr(self.a, 8)}, {mp.nstr(self.b, 8)}] did not settle: shorten the "
            f"arc."
        )


def _positive(q: Any) -> Any:
    q = _real(q, "The parameter Q of a bitangent conic")
    if not (q > 0 and mp.isfinite(q)):
        raise DomainError(
            f"The parameter Q of a bitangent conic is positive and finite, not {mp.nstr(q, 8)}."
        )
    return q
