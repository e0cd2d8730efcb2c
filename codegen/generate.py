"""Writes ``kernels/generated`` from the derivations in ``cas``: ``python -m osculant.codegen.generate``.

With ``--check`` nothing is written; the exit status is 1 if a committed file differs from what the
derivations give today.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import sympy as sp

from osculant.cas.asymptotics import free_cubics
from osculant.cas.geometry import cubic_moments, pencil
from osculant.cas.invariants.values import jet_symbols
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.jets.space import SpaceJet
from osculant.cas.laws.law import METRICS, Law
from osculant.cas.laws.table import LAWS
from osculant.codegen.closed_forms import ClosedForm, module_source

FOLDER = Path(__file__).resolve().parent.parent / "kernels" / "generated"
#: digits of constants on the way to doubles, and bits of their first parts
DIGITS, SHORT = 60, 40


def pencil_module() -> str:
    """Displacement, weight and peak constants of the pencil of bitangent conics."""
    p = pencil
    move = p.displacement()
    bezier = p.weights()
    lines = (p.l0, p.l1, p.l2)
    forms = [
        ClosedForm(
            "displacement",
            "d, ∂d/∂Q, d′ and the lines l₀, l₁, l₂ at the foot; NaN where the normal misses the conic.",
            (p.Q, *lines, p.n0, p.n1, p.n2, p.t0, p.t1, p.t2, p.speed, p.curvature),
            {name: move[name] for name in ("d", "by_q", "slope", "foot0", "foot1", "foot2")},
        ),
        ClosedForm("through", "Q of the conic through a point with these lines.", lines, {"Q": p.through()}),
        ClosedForm(
            "parabola", "Q of the parabola.", (p.sin_a, p.sin_b, p.sin_psi), {"Q": bezier["parabola"]}
        ),
        ClosedForm(
            "weight",
            "Bézier weight w and the length of V = w(P₁ − P₀).",
            (p.Q, p.chord, p.sin_a, p.sin_b, p.sin_psi),
            {"weight": bezier["weight"], "reach": bezier["reach"]},
        ),
    ]
    constants: dict[str, sp.Expr | int] = {}
    for primitive, crossings in (("PARABOLA", 0), ("CONIC", 1)):
        for name, value in p.lobes(crossings).items():
            constants[f"{primitive}_{name.upper()}"] = value
    return module_source("cas/geometry/pencil.py", forms, constants)


def invariants_module() -> str:
    """The scalar invariants over jets of order 5."""
    jet = jet_symbols(PlaneJet, "xy", 5)
    names = {
        "speed": jet.speed,
        "curvature": jet.curvature,
        "curvature_slope": jet.curvature_slope,
        "affine_speed": jet.affine_speed,
        "affine_curvature": jet.affine_curvature,
        "affine_curvature_slope": jet.affine_curvature_slope,
    }
    form = ClosedForm(
        "invariants",
        "Speed, κ, dκ/ds, φ = dr/dt, k and dk/dr from the derivatives 1…5 of both coordinates.",
        (*jet.x[1:], *jet.y[1:]),
        names,
    )
    return module_source("cas/jets/plane.py", [form], {})


def laws_module() -> str:
    """The laws of `osculant.cas.laws.table`: densities of plane ones over jets of order 5, and all orders.

    `law_name` begins every name: ``conic_density``, ``conic_area_density``, ``CONIC_ORDER``,
    ``CONIC_AREA_ORDER``. Laws of space curves, and those whose density is no closed form, have none here;
    their constants c are printed instead, as ``BIHELIX_CONSTANT``.
    """
    jet = jet_symbols(PlaneJet, "xy", 5)
    laws = sorted(LAWS.values(), key=lambda law: list(METRICS).index(law.metric))
    constants: dict[str, sp.Expr | int] = {f"{law_name(law)}_ORDER".upper(): law.order for law in laws}
    forms = []
    for law in laws:
        c = law.exact()
        if 2 not in law.spaces or law.branch is not None:
            constants[f"{law_name(law)}_CONSTANT".upper()] = c
            continue
        error = "ε" if law.dimension == 1 else "a piece's area"
        purpose = (
            f"Pieces of a {law.primitive} spline per unit of the parameter, times {error}^(1/{law.order})."
        )
        density = (c * law.invariant(jet)) ** sp.Rational(1, law.order) * jet.speed
        arguments = (*jet.x[1:], *jet.y[1:])
        forms.append(ClosedForm(f"{law_name(law)}_density", purpose, arguments, {"density": density}))
    return module_source("cas/laws/table.py", forms, constants)


def law_name(law: Law) -> str:
    """What the names of a law begin with.

    >>> law_name(LAWS["conic", "area"]), law_name(LAWS["level bihelix", "hausdorff"])
    ('conic_area', 'level_bihelix')
    """
    return law.primitive.replace(" ", "_") + ("_area" if law.metric == "area" else "")


def cubics_module() -> str:
    """Six-fold contact of cubics with short arcs, and cubics of given area and moment."""
    contact, moments = free_cubics.contact(), cubic_moments
    heights = free_cubics.Y
    first, second = (sp.fraction(sp.together(third)) for third in contact.third())
    condition = sp.Poly(contact.condition, free_cubics.a).all_coeffs()
    above, below = moments.other_arm()
    forms = [
        ClosedForm(
            "condition",
            "The coefficients of a³ … a⁰ in (C).",
            heights[:-1],
            dict(zip(("c3", "c2", "c1", "c0"), condition)),
        ),
        ClosedForm(
            "thirds",
            "b of a root a of (C), as two fractions: numerator, denominator, numerator, denominator.",
            (free_cubics.a, *heights[:-1]),
            dict(zip(("above", "below", "other_above", "other_below"), (*first, *second))),
        ),
        ClosedForm(
            "residual", "D.", (free_cubics.a, free_cubics.b, *heights), {"residual": contact.residual}
        ),
        ClosedForm(
            "quartic",
            "The coefficients of a₀⁴ … a₀⁰ that area and moment leave.",
            moments.ARGUMENTS,
            dict(zip(("q4", "q3", "q2", "q1", "q0"), moments.quartic())),
        ),
        ClosedForm(
            "other_arm",
            "Numerator and denominator of a₃.",
            (moments.ARM0, *moments.ARGUMENTS[:-1]),
            {"above": above, "below": below},
        ),
    ]
    constants = {name.upper(): sp.N(value, 20) for name, value in free_cubics.lobes().items()}
    derivation = "cas/asymptotics/free_cubics.py and cas/geometry/cubic_moments.py"
    return module_source(derivation, forms, constants)


def space_module() -> str:
    """Invariants and frame of a space curve over jets of order 3."""
    x, y, z = (sp.symbols(f"{name}:4", real=True) for name in "xyz")
    jet = SpaceJet(x, y, z, sp.root)
    names = ("speed", "curvature", "curvature_slope", "torsion")
    results = {name: getattr(jet, name) for name in names}
    for name, vector in (("tangent", jet.tangent), ("normal", jet.normal)):
        results |= {f"{name}_{axis}": value for axis, value in zip("xyz", vector)}
    form = ClosedForm(
        "frenet",
        "Speed, κ, dκ/ds, τ (usual sign), T and N from the derivatives 1…3 of the three coordinates.",
        (*jet.x[1:], *jet.y[1:], *jet.z[1:]),
        results,
    )
    return module_source("cas/jets/space.py", [form], {})


#: of the forms whose zeros split splines: the attribute of the jet, and the derivatives that it takes
SPLITTING = {
    "inflection": ("inflection_form", 2),
    "parabolic": ("parabolic_form", 4),
    "sextactic": ("sextactic_form", 5),
    "vertex": ("curvature_slope_form", 3),
}


#: the lengths of a curve's derivatives
LENGTHS = sp.symbols("n:6", positive=True)


class _PlaneLengths(PlaneJet):
    """A jet whose brackets and products are those of lengths: what they are at most."""

    def bracket(self, i: int, j: int) -> sp.Expr:
        return LENGTHS[i] * LENGTHS[j]

    dot = bracket


class _SpaceLengths(SpaceJet):
    """The same in space."""

    inflection_form = (LENGTHS[1] * LENGTHS[2]) ** 2
    _inflection_rate = LENGTHS[1] ** 2 * LENGTHS[2] * LENGTHS[3]

    def dot(self, i: int, j: int) -> sp.Expr:
        return LENGTHS[i] * LENGTHS[j]


def _with_lengths(form: sp.Expr, order: int) -> sp.Expr:
    """The sum of the absolute terms of a form: rounding makes errors of so many units in it."""
    gens = LENGTHS[1 : order + 1]
    terms = sp.Poly(sp.expand(form), *gens).terms()
    return sum(abs(c) * sp.prod([g**p for g, p in zip(gens, powers)]) for powers, c in terms)


def forms_module() -> str:
    """The forms whose zeros are a curve's special points, for compiled approximators that find them alone.

    Beside each stands what its terms come to at most, from the lengths of the derivatives.
    """
    plane, space = jet_symbols(PlaneJet, "xy", 5), jet_symbols(SpaceJet, "xyz", 3)
    forms = [
        ClosedForm(
            name,
            f"The {name} form of a plane curve's derivatives 1…{order}.",
            (*plane.x[1 : order + 1], *plane.y[1 : order + 1]),
            {name: getattr(plane, attribute)},
        )
        for name, (attribute, order) in SPLITTING.items()
    ]
    vertex = ClosedForm(
        "space_vertex",
        "The vertex form of a space curve's derivatives 1…3.",
        (*space.x[1:], *space.y[1:], *space.z[1:]),
        {"space_vertex": space.curvature_slope_form},
    )
    sizes: list[ClosedForm] = []
    none = [sp.Integer(0)] * 6
    lengths = _PlaneLengths(none, none), _SpaceLengths(none, none, none)
    for name, (attribute, order) in {**SPLITTING, "space_vertex": ("curvature_slope_form", 3)}.items():
        form = getattr(lengths[name.startswith("space")], attribute)
        purpose = f"The size of the terms of the {name} form, from the derivatives' lengths."
        size = {"size": _with_lengths(form, order)}
        sizes.append(ClosedForm(f"{name}_size", purpose, tuple(LENGTHS[1 : order + 1]), size))
    return module_source("cas/jets/plane.py and cas/jets/space.py", [*forms, vertex, *sizes], {})


def constants_module() -> str:
    """π/2 and log 2, each as three doubles, the first two so short that small multiples of them are exact."""
    lines = []
    for name, exact in (("HALF_PI", sp.pi / 2), ("LOG_2", sp.log(2))):
        rest, parts = sp.Rational(sp.N(exact, DIGITS)), []
        for bits in (SHORT, SHORT, None):
            part = float(rest)
            if bits is not None:
                _, exponent = math.frexp(part)
                part = math.ldexp(math.floor(math.ldexp(part, bits - exponent)), exponent - bits)
            parts.append(part)
            rest -= sp.Rational(part)
        lines.append(f"{name} = ({', '.join(map(repr, parts))})")
    title = "Generated from sympy's π and log 2 by codegen.generate; do not edit."
    note = "Each is a + b + c, three doubles, the first two with few digits, so that multiples are exact."
    return f'"""{title}\n\n{note}\n"""\n\n\n' + "\n".join(lines) + "\n"


MODULES = {
    "constants.py": constants_module,
    "forms.py": forms_module,
    "pencil.py": pencil_module,
    "invariants.py": invariants_module,
    "laws.py": laws_module,
    "cubics.py": cubics_module,
    "space.py": space_module,
}


def main(arguments: list[str]) -> int:
    """Write or, with ``--check``, compare all generated modules; returns the exit status."""
    stale = []
    for name, make in MODULES.items():
        path, text = FOLDER / name, make()
        if "--check" not in arguments:
            path.write_text(text, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            stale.append(name)
    for name in stale:
        print(f"kernels/generated/{name} is not what its derivation gives: run `make generate`.")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
