"""Every member of a family on one arc, and on two, by code of its own, to compare minimal splines with."""

import numpy as np
import sympy

T = sympy.Symbol("t")


def cross(v, w):
    return v[..., 0] * w[..., 1] - v[..., 1] * w[..., 0]


class Curve:
    """A curve by its formula: points and unit tangents at times (m,), as (m, 2)."""

    def __init__(self, text):
        parts = sympy.sympify(f"[{text.replace('^', '**')}]", locals={"t": T}, rational=True)
        self._parts = [sympy.lambdify(T, p) for p in parts], [sympy.lambdify(T, p.diff(T)) for p in parts]

    def __call__(self, times):
        (x, y), (dx, dy) = (
            [np.broadcast_to(part(times), times.shape).astype(float) for part in parts]
            for parts in self._parts
        )
        speed = np.hypot(dx, dy)
        return np.stack([x, y], 1), np.stack([dx / speed, dy / speed], 1)

    def bends_left(self, a, b):
        return cross(*self(np.array([a, a + 1e-4 * (b - a)]))[1]) > 0


class Arc:
    """An arc that bends to the left, seen from samples; its mirror image if it bends to the right."""

    def __init__(self, curve, a, b, samples):
        points, tangents = curve(np.linspace(a, b, samples + 2))
        if not curve.bends_left(a, b):
            points, tangents = points * (1, -1), tangents * (1, -1)
        self.start, self.end = points[0], points[-1]
        self.first, self.last = tangents[0], tangents[-1]
        self.points = points[1:-1]
        self.normals = np.stack([-tangents[1:-1, 1], tangents[1:-1, 0]], 1)
        self.chord = self.end - self.start

    def _lines(self, points):
        return (
            cross(self.last, points - self.end),
            cross(self.chord / np.hypot(*self.chord), points - self.start),
            cross(self.first, points - self.start),
        )

    def conics(self, members):
        """The largest displacements of members, all between those through samples: (members,)."""
        l0, l1, l2 = self._lines(self.points)
        through = l1**2 / (4 * l0 * l2)
        inside = np.sort(through)[2:-2]  # at the ends rounding tells nothing
        return self.conic_errors(np.linspace(inside[0], inside[-1], members))

    def parabolas(self, members):
        """The error of the one parabola."""
        unit = self.chord / np.hypot(*self.chord)
        q = cross(self.first, unit) * cross(unit, self.last) / cross(self.first, self.last) ** 2
        return self.conic_errors(np.array([q]))

    def conic_errors(self, qs):
        """Along normals, on the member's side; infinite where one misses, or the member is unbounded."""
        unit = self.chord / np.hypot(*self.chord)
        sines = cross(self.first, unit), cross(unit, self.last), cross(self.first, self.last)
        weights = np.sqrt(qs / (sines[0] * sines[1])) * sines[2]
        values = [self._lines(self.points + d * self.normals) for d in (0.0, 1.0)]
        (l0, l1, l2), (m0, m1, m2) = values
        n0, n1, n2 = m0 - l0, m1 - l1, m2 - l2
        q = qs[:, None]
        a, b, c = n1**2 - 4 * q * n0 * n2, 2 * l1 * n1 - 4 * q * (l0 * n2 + l2 * n0), l1**2 - 4 * q * l0 * l2
        with np.errstate(invalid="ignore", divide="ignore"):
            root = np.sqrt(b * b - 4 * a * c)
            far = -0.5 * (b + np.copysign(root, b))
            hits = np.full(a.shape, np.inf)
            for d in (far / a, c / far):
                on_arc = (l0 + d * n0 > -1e-12) & (l1 + d * n1 < 1e-12) & (l2 + d * n2 > -1e-12)
                hits = np.where(on_arc & (d * c >= 0) & (np.abs(d) < hits), np.abs(d), hits)
        return np.where(weights > -1, hits.max(axis=1), np.inf)

    def biarcs(self, members):
        """The largest distances of samples from biarcs, whose first handle goes from nothing to all."""
        square, along = self.chord @ self.chord, self.chord @ self.first
        farthest = square / (2 * along) if along > 0 else 4 * np.sqrt(square)
        one = farthest * np.linspace(0, 1, members + 2)[1:-1]
        other = (square - 2 * one * along) / (
            2 * (self.chord @ self.last + one * (1 - self.first @ self.last))
        )
        one, other = one[other > 0][:, None], other[other > 0][:, None]
        corners = self.start + one * self.first, self.end - other * self.last
        joints = (other * corners[0] + one * corners[1]) / (one + other)
        ways = (corners[1] - corners[0]) / (one + other)
        late = np.einsum("mjk,mk->mj", self.points[None] - joints[:, None], ways) > 0
        before = self._from_circles(self.start, self.first, joints)
        after = self._from_circles(self.end, self.last, joints)
        return np.where(late, after, before).max(axis=1)

    def _from_circles(self, point, tangent, joints):
        bend = 2 * cross(tangent, joints - point) / ((joints - point) ** 2).sum(1)
        left = np.array([-tangent[1], tangent[0]])
        centres = point + left / bend[:, None]
        away = np.linalg.norm(self.points[None] - centres[:, None], axis=2)
        return np.abs(away - np.abs(1 / bend)[:, None])


def least(curve, primitive, a, b, members, samples):
    """The least error of all members on an arc."""
    return float(
        getattr(
            Arc(curve, a, b, samples),
            {"conic": "conics", "biarc": "biarcs", "parabola": "parabolas"}[primitive],
        )(members).min()
    )


def least_of_two(curve, primitive, a, b, members, samples, knots):
    """The least error of all members on two arcs, over all places of the knot between."""
    return min(
        max(least(curve, primitive, a, c, members, samples), least(curve, primitive, c, b, members, samples))
        for c in np.linspace(a, b, knots + 2)[1:-1]
    )
