"""Section 1.3.3's open question whether geometric Hermite interpolants keep the curve's shape, for conics."""

from __future__ import annotations

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.laws.table import law_of


@claim(
    "section 1.3.3-6",
    "A parabola tangent at both ends to a convex arc has no inflection, but it has a vertex inside exactly "
    "if both ⟨e₁, e₂⟩ < |e₁|² and ⟨e₁, e₂⟩ < |e₂|² for its legs e₁, e₂: always if the arc turns by π/2 or "
    "more, also where the arc has none. So interpolants need not preserve the shape.",
    method=Method.PROOF,
    form="pi/2",
    wrong=("pi/3", "pi", "2*pi/3", "pi/4"),
)
def vertex_of_the_parabola(form: str) -> Evidence:
    """The form is the least turning that forces a vertex, whatever the legs.

    β′ = 2((1−u)e₁ + ue₂) and β″ = 2(e₂ − e₁) give [β′, β″] = 4[e₁, e₂], constant: no inflection; and κ′ has
    the sign of −⟨β′, β″⟩, which is linear in u and changes its sign inside exactly if ⟨e₁, e₂ − e₁⟩ < 0 <
    ⟨e₂, e₂ − e₁⟩. With ⟨e₁, e₂⟩ = |e₁||e₂| cos ψ ≤ 0 both hold; for cos ψ > 0 they fail if |e₁| ≤ |e₂| cos ψ.
    The threshold is the zero of the cosine. Spiral arcs that turn by more exist, without a vertex.
    """
    u, p, q = sp.symbols("u p q", positive=True)
    psi = sp.Symbol("psi", positive=True)
    first, second = (p, sp.S.Zero), (q * sp.cos(psi), q * sp.sin(psi))
    speed = [2 * ((1 - u) * a + u * b) for a, b in zip(first, second, strict=True)]
    bend = [2 * (b - a) for a, b in zip(first, second, strict=True)]
    area = speed[0] * bend[1] - speed[1] * bend[0]
    inner = speed[0] * bend[0] + speed[1] * bend[1]
    square = speed[0] ** 2 + speed[1] ** 2
    slope = sp.diff(area / square ** sp.Rational(3, 2), u)  # of κ by u
    found = vanishes(area - 4 * p * q * sp.sin(psi), "[β′, β″]")
    found &= vanishes(slope * square ** sp.Rational(5, 2) + 3 * area * inner, "κ′|β′|⁵ + 3[β′, β″]⟨β′, β″⟩")
    ends = [sp.expand(inner.subs(u, at) / 4) for at in (0, 1)]
    stated = [p * q * sp.cos(psi) - p**2, q**2 - p * q * sp.cos(psi)]
    for at, (one, other) in enumerate(zip(ends, stated, strict=True)):
        found &= vanishes(one - other, f"⟨β′, β″⟩/4 at u = {at}")
    threshold = min(sp.solveset(sp.cos(psi), psi, sp.Interval(0, sp.pi)))
    return found & vanishes(read(form, {}) - threshold, "least turning that forces a vertex")


@claim(
    "section 1.3.3-7",
    "Conics tangent to a convex arc at both ends never have an inflection; short bitangent conics of an arc "
    "with κ′ ≠ 0 have no vertex inside either: their curvature and its derivative tend to the curve's.",
    method=Method.PROOF,
    form="5, 4",
    wrong=("4, 4", "5, 5", "3, 2"),
)
def short_conics_keep_the_shape(form: str) -> Evidence:
    """The form has the orders of contact, in the arc's length, of the best conic and of the parabola.

    The displacement is x²(1 − x)² times a smooth function, of the order p: so its third derivative along the
    arc is O(σᵖ⁻³), and κ′ of the conic differs from that of the curve by that much. p ≥ 4 makes it tend to 0.
    The curvature of an ellipse, parabola or hyperbola is nowhere 0. Whether cubics and longer arcs keep
    vertices stays open, as in the thesis.
    """
    orders = tuple(law_of(primitive).order for primitive in ("conic", "parabola"))
    parts = tuple(read(part, {}) for part in form.split(","))
    if len(parts) != 2:
        raise DomainError(f"The form {form!r} has other than two orders: give 2.")
    found = Evidence(all(order > 3 for order in orders), (f"orders {orders}: third derivatives tend to 0",))
    for part, order in zip(parts, orders, strict=True):
        found &= vanishes(part - sp.sympify(order), f"order {order}")
    return found


@claim(
    "section 3.1.1-4",
    "Schaback's conic splines have the order h⁵, as all conics tangent at both ends that meet the arc once "
    "more inside; the constant is |dk/dr|κ² max x²(1 − x)²|x − c|/40 for a crossing at the part c, least "
    "for c = 1/2. Which c his scheme has, and so its constant, is open here.",
    method=Method.PROOF,
    form="1/2",
    wrong=("1/3", "0", "2/5", "1"),
)
def conics_with_a_crossing(form: str) -> Evidence:
    """The form is the crossing with the least constant.

    The displacement of a member that crosses at c is the remainder of x⁵ at the nodes 0, 0, 1, 1, c, to
    leading order. At c = 1/2 it equioscillates. Another c differs by (c − 1/2)x²(1 − x)², of one sign, which
    makes one of the two extremes larger (de la Vallée Poussin).
    """
    x, c = sp.symbols("x c", real=True)
    shape = x**2 * (1 - x) ** 2 * (x - c)
    balance = sp.expand(shape.subs(x, 1 - x) + shape.subs(c, 1 - c))
    stated = read(form, {})
    symmetric = vanishes(balance, "the shape for c at 1 − x against minus that for 1 − c at x")
    equal = vanishes(stated - sp.solve(sp.Eq(c, 1 - c), c)[0], "the crossing that is its own mirror image")
    peaks = [p for p in sp.solve(sp.diff(shape.subs(c, sp.Rational(1, 2)), x), x) if 0 < p < 1]
    values = [sp.nsimplify(sp.simplify(shape.subs({c: sp.Rational(1, 2), x: p}))) for p in peaks]
    alternate = Evidence(
        len([v for v in values if v != 0]) == 2 and sp.simplify(sum(values)) == 0,
        (f"extremes at c = 1/2: {', '.join(map(str, values))}",),
    )
    constant = max(abs(v) for v in values) / 40
    law = vanishes(constant - sp.Rational(1) / (2000 * sp.sqrt(5)), "max over 40 against 1/(2000√5)")
    return symmetric & equal & alternate & law
