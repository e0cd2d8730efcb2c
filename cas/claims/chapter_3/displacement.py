"""Claims of section 3.3 on the displacement between an arc and its bitangent conics and on the best one."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import sympy as sp
from mpmath import mp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import SPIRAL
from osculant.cas.claims.proof import read, split, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.cas.numbers.roots import root_between

#: the lines l₀, l₁, l₂ at a point of the curve and their derivatives along its normal
L0, L1, L2, N0, N1, N2 = sp.symbols("l0 l1 l2 n0 n1 n2", real=True)
Q = sp.Symbol("Q", positive=True)


@claim(
    "R3.3-7",
    "At each point of the curve ∂d/∂Q = 4 l₀l₂/(sign(B)√(B² − 4AC)) with l₀, l₂ at the foot: of one sign "
    "along the "
    "arc, so d is strictly monotone in Q.",
    method=Method.PROOF,
    form="4*f0*f2/root",
    wrong=("-4*f0*f2/root", "2*f0*f2/root", "4*l0*l2/root"),
)
def displacement_by_q(form: str) -> Evidence:
    """The root d = −2C/(B + S) with S² = B² − 4AC is differentiated as it stands.

    A foot on the conic's arc lies on the inner side of both end tangents, so l₀l₂ > 0 there, and S = ∂F/∂N at
    the foot does not change sign while every normal meets the arc in a simple point.
    """
    root = sp.Symbol("S", real=True)
    a = N1**2 - 4 * Q * N0 * N2
    b = 2 * L1 * N1 - 4 * Q * (L0 * N2 + L2 * N0)
    rest = L1**2 - 4 * Q * L0 * L2
    d = -2 * rest / (b + root)
    root_slope = sp.diff(b**2 - 4 * a * rest, Q) / (2 * root)
    slope = sp.diff(d, Q) + sp.diff(d, root) * root_slope
    names = {"l0": L0, "l2": L2, "f0": L0 + d * N0, "f2": L2 + d * N2, "root": root}
    return vanishes(read(form, names) - slope, "∂d/∂Q", [(root**2 - b**2 + 4 * a * rest, root)])


@claim(
    "R3.3-8",
    "d′ = −v(1 − κd) F_T/F_N with F's derivatives at the foot along T and N and v = ds/du: as long as κd < "
    "1, "
    "d′(u) = 0 exactly where curve and conic have a common normal.",
    method=Method.PROOF,
    form="-v*(1 - kappa*d)*F_T/F_N",
    wrong=("-v*(1 + kappa*d)*F_T/F_N", "v*(1 - kappa*d)*F_T/F_N", "-v*F_T/F_N"),
)
def displacement_slope(form: str) -> Evidence:
    """F(α + dN) = 0 is differentiated along the curve, with α′ = vT and the tangent's angle growing by κv."""
    t = sp.Symbol("t", real=True)
    v, kappa, fx, fy, slope = sp.symbols("v kappa fx fy slope", real=True)
    angle, d, px, py = (sp.Function(name)(t) for name in ("theta", "d", "px", "py"))
    foot = (px - d * sp.sin(angle), py + d * sp.cos(angle))
    motion = {
        px.diff(t): v * sp.cos(angle),
        py.diff(t): v * sp.sin(angle),
        angle.diff(t): kappa * v,
        d.diff(t): slope,
    }
    rate = sum(f * sp.diff(z, t).subs(motion) for f, z in zip((fx, fy), foot))
    theta, gap = sp.symbols("theta gap", real=True)
    fixed = {angle: theta, d: gap}
    (found,) = sp.solve(rate.subs(fixed), slope)
    names = {
        "v": v,
        "kappa": kappa,
        "d": gap,
        "F_T": fx * sp.cos(theta) + fy * sp.sin(theta),
        "F_N": fy * sp.cos(theta) - fx * sp.sin(theta),
    }
    return vanishes(read(form, names) - found, "d′")


@claim(
    "R3.3-9",
    "Through every inner point of the arc goes one bitangent conic: Q = l₁²/(4l₀l₂) there.",
    method=Method.PROOF,
    form="l1**2/(4*l0*l2)",
    wrong=("l1**2/(2*l0*l2)", "l1/(4*l0*l2)"),
)
def through_point(form: str) -> Evidence:
    """F = l₁² − 4Q l₀l₂ is linear in Q; inside, l₀l₂ > 0."""
    member = read(form, {"l0": L0, "l1": L1, "l2": L2})
    return vanishes((L1**2 - 4 * Q * L0 * L2).subs(Q, member), "F at the point")


@claim(
    "proposition 3.3.2",
    "The bitangent conics of an arc lie side by side: two of them have no point in common but the end "
    "points P₀ and "
    "P₂, at each of which they meet twice.",
    method=Method.PROOF,
    form="P0, P2",
    wrong=("P0, P1, P2", "P0"),
)
def side_by_side(form: str) -> Evidence:
    """Members Q₁ ≠ Q₂ differ by 4(Q₂ − Q₁)l₀l₂, so at a common point l₀l₂ = 0, and then l₁ = 0.

    That is: the points where the chord meets one of the end tangents. On such a tangent both members are l₁²,
    a double zero, so the four common points of Bézout's theorem are these two, each counted twice.
    """
    p1, p2, q1, q2, c, other = sp.symbols("p1 p2 q1 q2 c R", positive=True)
    x, y = sp.symbols("x y", real=True)
    l0, l1, l2 = q1 * y - q2 * (x - c), y, p1 * y + p2 * x
    found = vanishes(
        (l1**2 - 4 * Q * l0 * l2) - (l1**2 - 4 * other * l0 * l2) - 4 * (other - Q) * l0 * l2, "F₁ − F₂"
    )
    common = {tuple(sp.solve([l1, tangent], [x, y]).values()) for tangent in (l0, l2)}
    meeting = sp.solve([l0, l2], [x, y])
    names = {"P0": (sp.S.Zero, sp.S.Zero), "P2": (c, sp.S.Zero), "P1": (meeting[x], meeting[y])}
    try:
        claimed = {names[name] for name in split(form, len(set(form.split(","))))}
    except KeyError as error:
        raise DomainError(f"No point is called {error}: use P0, P1 or P2.") from error
    line = f"common points {sorted(common, key=str)} with the chord from (0, 0) to (c, 0)"
    return found & Evidence(common == claimed, (line,))


@claim(
    "corollary 3.3.3",
    "Equioscillation: the conic of least Hausdorff distance from an affine spiral arc is the only bitangent "
    "conic "
    "with max d = −min d.",
    method=Method.PROOF,
    form="dmax + dmin",
    wrong=("dmax + 2*dmin", "2*dmax + dmin", "dmax", "dmax^2 - dmin^2"),
)
def equioscillation(form: str) -> Evidence:
    """Let e = max d = d(u₊) = −min d = −d(u₋) for the member Q.

    By R3.3-7, proved again here, d grows strictly with Q (or falls) at every point. So any other member has
    d(u₊) > e or d(u₋) < −e: its distance is larger. There is such a member since max d + min d is continuous
    in Q and has both signs at the members that cross the arc near one end or the other. The form is put to
    the test on one arc, and has to be linear: the member where it vanishes must be better than its
    neighbours.
    """
    names = {name: sp.Symbol(name) for name in ("dmax", "dmin")}
    itself = read(form, names)
    if not (itself.is_polynomial() and sp.Poly(itself, *names.values()).homogeneous_order() == 1):
        return Evidence(False, (f"{itself} is no linear form of max d and min d",))
    monotone = displacement_by_q("4*f0*f2/root")
    with mp.workdps(25):
        pencil = BitangentPencil(ReferenceCurve(SPIRAL), 1, 2)

        def value(q: Any) -> Any:
            heights = [d for _, d in pencil.peaks(q)] + [mp.mpf(0)]
            return read(form, {"dmax": _float(max(heights)), "dmin": _float(min(heights))})

        ends = [pencil.through(mp.mpf(t)) for t in ("1.02", "1.98")]
        q = root_between(lambda q: mp.mpf(str(value(q))), *ends)
        error = pencil.hausdorff(q)
        worse = [pencil.hausdorff(q * (1 + mp.mpf(10) ** -k * s)) for k in (2, 4, 6) for s in (1, -1)]
    line = (
        f"instance, Archimedean spiral on [1, 2]: Q = {mp.nstr(q, 15)}, distance {mp.nstr(error, 15)}; "
        f"members 1e-6 to 1e-2 away on both sides: {mp.nstr(min(worse), 15)} at least"
    )
    return monotone & Evidence(bool(error < min(worse)), (line,))


def _float(value: Any) -> Any:
    return sp.Float(str(value), mp.dps)


def _derivatives(order: int) -> tuple[list[Any], list[Any], Any]:
    """x⁽ⁱ⁾, y⁽ⁱ⁾ by affine arc length r at a point, in the affine frame there, and dk/dr."""
    curvature = sp.symbols(f"k:{order}")
    rows = [(sp.S.Zero, sp.S.Zero), (sp.S.One, sp.S.Zero)]
    while len(rows) <= order:
        along, across = rows[-1]
        # (a t + b n)′ = (a′ − kb) t + (a + b′) n
        rows.append(
            tuple(
                sp.expand(z)
                for z in (_rate(along, curvature) - curvature[0] * across, along + _rate(across, curvature))
            )
        )
    return [row[0] for row in rows], [row[1] for row in rows], curvature[1]


def _rate(expression: Any, jet: Any) -> Any:
    return sum(sp.diff(expression, low) * high for low, high in pairwise(jet))


@claim(
    "X3.3-1",
    "Along affine arc length the Wronskian of x, y, x², xy, y² and 1, which are the monomials of a conic's "
    "equation, is "
    "a constant times dk/dr: short arcs without sextactic points meet no conic in six points.",
    method=Method.PROOF,
    form="-108*dk",
    wrong=("-108*k", "108*dk", "-108*dk**2"),
)
def wronskian(form: str) -> Evidence:
    """Leibniz' rule on α‴ = −kα′, in the affine frame at the point; affine maps with determinant 1 keep it.

    Functions whose Wronskian does not vanish at a point have no combination with six zeros near it.
    """
    dx, dy, dk = _derivatives(5)

    def product(f: list[Any], g: list[Any], n: int) -> Any:
        return sum(sp.binomial(n, i) * f[i] * g[n - i] for i in range(n + 1))

    rows = [[dx[n], dy[n], product(dx, dx, n), product(dx, dy, n), product(dy, dy, n)] for n in range(1, 6)]
    value = sp.expand(sp.Matrix(rows).det())
    k = sp.Symbol("k0")
    return vanishes(read(form, {"dk": dk, "k": k}) - value, f"Wronskian {value}")
