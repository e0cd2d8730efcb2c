"""Claims of section 4.4, reconstructed: junction points, junction lines and junction cylinders."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import positive, read, read_tuple, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.geometry.bihelices import End, junction_cylinder, junction_line, junction_plane
from osculant.cas.numbers.vectors import Vector3, add, cross, det, dot, scale, subtract

omega, d, z = sp.symbols("omega d z")


def _generic(name: str) -> Vector3:
    a, b, c = sp.symbols(f"{name}1:4", real=True)
    return a, b, c


def _all_vanish(vector: Vector3, what: str) -> Evidence:
    """Each of three components is identically 0."""
    first, second, third = (
        vanishes(entry, f"{what}, component {i}") for i, entry in enumerate(vector, start=1)
    )
    return first & second & third


class _Circle:
    """Both ends about the axis e₃: chord (d, 0, z), tangents of radius ρ at angles α and α + ω, T₀ at θ.

    Every pair of ends looks so in the right coordinates, for each axis orthogonal to T_R − T_L. Coordinates
    are elements of a field of fractions: of the tangents of half the angles, in which all is rational.
    """

    names = "d, z, rho, slope, half_alpha, half_omega, half_theta"

    def __init__(self) -> None:
        self.field, self.d, self.z, rho, slope, *halves = sp.field(self.names, sp.QQ)
        zero = self.field(0)
        (ca, sa), (cw, sw), (ct, st) = (((1 - h**2) / (1 + h**2), 2 * h / (1 + h**2)) for h in halves)
        self.left = End((zero, zero, zero), (rho * ca, rho * sa, slope))
        turned = (rho * (ca * cw - sa * sw), rho * (sa * cw + ca * sw), slope)
        self.right = End((self.d, zero, self.z), turned)
        self.line = junction_line(self.left, self.right, (rho * ct, rho * st, slope))
        self.cylinder = junction_cylinder(self.left, self.right, (zero, zero, zero + 1))

    def element(self, expression: Any) -> Any:
        """An expression in d, z and trigonometric functions of ω/2 and ω, as an element of the field.

        Raises DomainError for one that is not rational in them.
        """
        half = sp.Symbol("half_omega")
        rational = sp.expand_trig(expression.subs(omega, 2 * sp.atan(half)))
        try:
            return self.field.from_expr(sp.together(rational))
        except ValueError:
            raise DomainError(f"{expression} is not rational in the sine and cosine of ω/2.") from None

    def squared_distance(self, p: Vector3, x: Any, y: Any) -> Any:
        """Of p from the parallel to the axis through (x, y)."""
        return (p[0] - x) ** 2 + (p[1] - y) ** 2


@cache
def _circle() -> _Circle:
    return _Circle()


def _is_zero(element: Any, what: str) -> Evidence:
    return vanishes(element.as_expr(), what)


@claim(
    "R4.4-1",
    "A helix from (p_L, T_L) that arrives with the tangent T₀ ends in the plane through p_L with normal "
    "T₀ − T_L.",
    method=Method.PROOF,
    form="T0 - TL",
    wrong=("T0 + TL", "T0", "TL", "0*T0"),
)
def plane_of_junction_points(form: str) -> Evidence:
    """In its Darboux frame {W, N, V} a helix is α(s) = sτ̄V + (κ̄/β)(sin φ W + (1 − cos φ)N), φ = βs, with the
    tangent τ̄V + κ̄(cos φ W + sin φ N). The scalar product of chord and normal is reduced by cos² + sin² = 1.
    That every point of the plane is reached, by one short helix, is Theorem 4.3.2.
    """  # noqa: D205
    phi, beta, bend, climb = sp.symbols("phi beta bend climb", positive=True)
    c, s = sp.symbols("cos_phi sin_phi", real=True)
    chord = (bend * s / beta, bend * (1 - c) / beta, climb * phi / beta)
    tangents = {"TL": (bend, sp.Integer(0), climb), "T0": (bend * c, bend * s, climb)}
    normal = [read(form, {name: v[i] for name, v in tangents.items()}) for i in range(3)]
    given = Evidence(any(part != 0 for part in normal), (f"the normal is {tuple(normal)}",))
    return given & vanishes(dot(chord, normal), "⟨p₀ − p_L, normal⟩", [(c**2 + s**2 - 1, c)])


@claim(
    "R4.4-2",
    "For generic data the junction points with junction tangent T₀ form a line of direction "
    "(T₀ − T_L) × (T_R − T₀) = a × b.",
    method=Method.PROOF,
    form="a2*b3 - a3*b2, a3*b1 - a1*b3, a1*b2 - a2*b1",
    wrong=(
        "0, 0, 0",
        "a2*b3 + a3*b2, a3*b1 + a1*b3, a1*b2 + a2*b1",
        "a1, a2, a3",
        "a1 + b1, a2 + b2, a3 + b3",
    ),
)
def line_of_junction_points(form: str) -> Evidence:
    """The line's point is taken from Lemma B.2.1; a step λ along the direction stays in both planes."""
    a, b = _generic("a"), _generic("b")
    far = _generic("p")
    names = {str(symbol): symbol for v in (a, b) for symbol in v}
    direction = read_tuple(form, names, 3)
    origin: Vector3 = (sp.Integer(0),) * 3
    middle = _generic("t")
    left, right = End(origin, subtract(middle, a)), End(far, add(middle, b))
    point = junction_line(left, right, middle).point
    on_line = add(point, scale(sp.Symbol("lam"), direction))
    first, second = junction_plane(left, middle), junction_plane(right, middle)
    moves = Evidence(any(part != 0 for part in direction), ("the direction is not 0 for generic data",))
    return (
        moves
        & vanishes(first.offset(on_line), "left plane")
        & vanishes(second.offset(on_line), "right plane")
    )


@claim(
    "R4.4-3",
    "l(T₀) and l(T₀′) are parallel just if T₀ and T₀′ lie on one circle through T_L and T_R: the product of "
    "their directions is det(T₀ − T_L, T₀′ − T_L, c)·c with c = T_R − T_L.",
    method=Method.PROOF,
    form="D*c1, D*c2, D*c3",
    wrong=("-D*c1, -D*c2, -D*c3", "D*a1, D*a2, D*a3", "D*c1, D*c2, 0"),
)
def parallel_junction_lines(form: str) -> Evidence:
    """c ≠ 0, so the product of the directions vanishes just with the determinant: that is, if the four points
    lie in one plane, which cuts the sphere in a circle.
    """  # noqa: D205
    a, b, c = _generic("a"), _generic("b"), _generic("c")  # T₀ − T_L, T₀′ − T_L, T_R − T_L
    directions = cross(a, subtract(c, a)), cross(b, subtract(c, b))
    names = {str(s): s for v in (a, b, c) for s in v} | {"D": det(a, b, c)}
    claimed = read_tuple(form, names, 3)
    return _all_vanish(subtract(cross(*directions), claimed), "product of the directions")


@claim(
    "R4.4-4",
    "The junction lines of a circle of tangents with axis n through T_L and T_R lie on one circular "
    "cylinder; its axis goes through p_L + d/2 + (n × d)/(2 tan(ω/2)).",
    method=Method.PROOF,
    form="d/2, d/(2*tan(omega/2))",
    wrong=("d/2, -d/(2*tan(omega/2))", "d/2, d*tan(omega/2)/2", "d/2, d/(2*tan(omega))"),
)
def cylinder_axis(form: str) -> Evidence:
    """d is the part of the chord orthogonal to n, and ω the angle about n from T_L to T_R. In coordinates
    with d = (d, 0) the junction line of T₀, at the angle θ, is as far from the claimed point as p_L, for all
    θ: an identity in the tangents of half the angles.
    """  # noqa: D205
    circle = _circle()
    x, y = (circle.element(entry) for entry in read_tuple(form, {"d": d, "omega": omega}, 2))
    gap = circle.squared_distance(circle.line.point, x, y) - circle.squared_distance(circle.left.point, x, y)
    return _is_zero(gap, "squared distances of junction line and p_L from the axis")


@claim(
    "R4.4-5",
    "The junction cylinder has the radius |d|/(2|sin(ω/2)|), and passes through p_L and p_R.",
    method=Method.PROOF,
    form="d/(2*sin(omega/2))",
    wrong=("d/(2*tan(omega/2))", "d/(2*sin(omega))", "d/sin(omega/2)", "-d/(2*sin(omega/2))"),
)
def cylinder_radius(form: str) -> Evidence:
    """From the axis of the screw motion that takes (p_L, T_L) to (p_R, T_R): the distances of p_L, of p_R and
    of the junction line of every T₀ on the circle, all squared.
    """  # noqa: D205
    circle = _circle()
    stated = read(form, {"d": d, "omega": omega})
    squared = circle.element(stated**2)
    x, y, _ = circle.cylinder.axis.point
    evidence = positive(stated.subs({d: 1, omega: sp.pi / 3}), "the radius for d = 1, ω = π/3")
    points = {"p_L": circle.left.point, "p_R": circle.right.point, "l(T₀)": circle.line.point}
    for what, p in points.items():
        gap = circle.squared_distance(p, x, y) - squared
        evidence &= _is_zero(gap, f"squared distance of {what} from the axis")
    return evidence


@claim(
    "R4.4-6",
    "The axis of a junction cylinder is that of the screw motion by the angle ω and the height z of the "
    "chord that takes (p_L, T_L) to (p_R, T_R).",
    method=Method.PROOF,
    form="omega, z",
    wrong=("-omega, z", "2*omega, z", "omega, -z"),
)
def screw_motion(form: str) -> Evidence:
    """The rotation by the claimed angle about the axis of the cylinder, then the step along it."""
    circle = _circle()
    angle, height = read_tuple(form, {"omega": omega, "z": z}, 2)
    c, s, step = (circle.element(e) for e in (sp.cos(angle), sp.sin(angle), height))
    axis = circle.cylinder.axis.point

    def turned(v: Vector3) -> Vector3:
        return c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]

    moved = add(axis, turned(subtract(circle.left.point, axis)), (0, 0, step))
    gaps = {
        "point": subtract(moved, circle.right.point),
        "tangent": subtract(turned(circle.left.tangent), circle.right.tangent),
    }
    evidence = Evidence(True)
    for what, gap in gaps.items():
        for i, entry in enumerate(gap, start=1):
            evidence &= _is_zero(entry, f"screw of the left {what} minus the right one, component {i}")
    return evidence


@claim(
    "R4.4-7",
    "The axes of junction cylinders are the directions orthogonal to T_R − T_L: one parameter ψ in the basis "
    "E ∥ T_L + T_R, F = T_R × T_L/|…|, G ∥ T_R − T_L.",
    method=Method.PROOF,
    form="cos(psi), sin(psi), 0",
    wrong=("cos(psi), 0, sin(psi)", "0, cos(psi), sin(psi)"),
)
def family_of_cylinders(form: str) -> Evidence:
    """An axis makes equal angles with T_L = cE − hG and T_R = cE + hG; the formula runs through all unit
    vectors that do, since a unit vector orthogonal to G is on the circle of E and F.
    """  # noqa: D205
    psi, c, h = sp.symbols("psi c h", positive=True)
    axis = read_tuple(form, {"psi": psi}, 3)
    tangents = (c, sp.Integer(0), -h), (c, sp.Integer(0), h)
    equal = vanishes(dot(axis, tangents[0]) - dot(axis, tangents[1]), "⟨n, T_L⟩ = ⟨n, T_R⟩")
    return equal & vanishes(dot(axis, axis) - 1, "|n| = 1")


@claim(
    "R4.4-8",
    "The two planes are parallel just if T₀ = T_L, T₀ = T_R or T_L = T_R: with a = |T₀ − T_L|, "
    "b = |T_R − T₀|, c = |T_R − T_L|, just if abc = 0.",
    method=Method.PROOF,
    form="a*b*c",
    printed="a*b",
    wrong=("a*c", "a*b*c*(a - b)"),
    erratum="Section 1.5 gives every T₀ other than T_L and T_R a line of junction points; T_L ≠ T_R is "
    "needed, for otherwise both planes are parallel.",
)
def parallel_planes(form: str) -> Evidence:
    """For unit vectors |(T₀ − T_L) × (T_R − T₀)|² = det(T_L, T₀, T_R)² + (abc)²/4: the triangle has the area
    abc/4R with a circumradius R ≤ 1. Two of the points coincide if abc = 0, so then the determinant is 0 too.
    The claimed product must vanish where a, b or c does and nowhere else.
    """  # noqa: D205
    p, q, r = sp.symbols("p q r", real=True)  # ⟨T_L, T₀⟩, ⟨T₀, T_R⟩, ⟨T_L, T_R⟩
    gram = sp.Matrix([[1, p, r], [p, 1, q], [r, q, 1]])
    aa, bb, cc = 2 - 2 * p, 2 - 2 * q, 2 - 2 * r
    mixed = q - 1 - r + p  # ⟨T₀ − T_L, T_R − T₀⟩
    identity = vanishes(aa * bb - mixed**2 - gram.det() - aa * bb * cc / 4, "|U₀ × U₁|²")
    value = sp.Lambda(sp.symbols("a b c"), read(form, {n: sp.Symbol(n) for n in "abc"}))
    t = sp.Symbol("t", positive=True)
    zeros = [value(0, t, t), value(t, 0, t), value(t, t, 0)]
    others = [value(*(Fraction(n, 7) for n in sides)) for sides in ((3, 4, 5), (5, 5, 6), (6, 4, 3))]
    fits = all(sp.expand(v) == 0 for v in zeros) and all(v != 0 for v in others)
    shown, more = (", ".join(map(str, row)) for row in (zeros, others))
    line = f"the product at a = 0, b = 0, c = 0: {shown}; at three triangles: {more}"
    return identity & Evidence(fits, (line,))
