"""Real classes of stable germs for A(H): invariants that tell signs apart, and sign changes that do not.

Stable germs are A(H)-equivalent exactly if they are K(H)-equivalent (Mather), so it is enough to look at the
genotype g(z, u), up to multiplication by invertible matrices and to source changes with u ↦ u·k, k > 0.
"""

from __future__ import annotations

from collections.abc import Hashable
from fractions import Fraction
from itertools import pairwise, permutations, product
from typing import Any

import sympy as sp

from osculant.cas.errors import UndecidedError
from osculant.cas.formulas.parser import parse_constant
from osculant.cas.formulas.sympy_bridge import to_sympy
from osculant.cas.germs.entry import instance
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import group
from osculant.cas.germs.polynomials import exponents_of

AH = group("A(H)")
VARIABLES = "x1 x2 x3 u"
#: degree of the germs compared at most
DEGREE = 10


def germs_of(form: str) -> list[Germ]:
    """The germs R⁴ → Rᵖ of a formula, for every choice of its signs ±.

    >>> [str(f) for f in germs_of("x1, u ± x2**2")]
    ['(x1, u + x2**2)', '(x1, u - x2**2)']
    """
    choices = product((1, -1), repeat=form.count("±"))
    return [Germ(instance(form, signs, {}), VARIABLES) for signs in choices]


def reflected(form: str) -> list[Germ]:
    """The germs f(x, −u): over the complex numbers the same classes as those of the formula.

    >>> [str(f) for f in reflected("x1, x2*u")]
    ['(x1, x2*(-u))']
    """
    choices = product((1, -1), repeat=form.count("±"))
    return [Germ(instance(form, signs, {"u": "(-u)"}), VARIABLES) for signs in choices]


def genotype(germ: Germ) -> tuple[list[Any], list[Any], Any]:
    """(components, variables z, u) of g(z, u): components that are coordinates of H made 0, and left out.

    >>> genotype(Germ("x1, u + x1*x2 + x2**3", "x1 x2 u"))
    ([u + x2**3], [x2], u)
    """
    components = [to_sympy(node) for node in germ.components]
    symbols = {s.name: s for f in components for s in f.free_symbols}
    source = [symbols.get(name, sp.Symbol(name, real=True)) for name in germ.source]
    u = source[germ.boundary_index]
    unfolding = {f for f in components if f.is_Symbol and f != u}
    rest = [f.subs(dict.fromkeys(unfolding, 0)) for f in components if f not in unfolding]
    return rest, [s for s in source if s != u and s not in unfolding], u


def real_class(germ: Germ) -> Hashable:
    """An invariant of the germ under A(H), where u ↦ u·k with k > 0: see the functions below.

    Raises UndecidedError where none of them applies.

    >>> real_class(Germ("x1, u + x2**2", "x1 x2 u")) == real_class(Germ("x1, u - x2**2", "x1 x2 u"))
    False
    """
    components, z, u = genotype(germ)
    components = [f for f in components if f != 0]
    if not z or not components:  # powers of u: a sign goes into the target
        return "no sign"
    if len(components) == 1:
        branches = half_branches(components[0], z[0], u) if len(z) == 1 else ()
        return hessian_signatures(components[0], z, u), branches
    if len(z) == 1:
        return marked_curve(components, z[0], u)
    raise UndecidedError(f"No invariant tells the signs of {germ} apart.")


def hessian_signatures(g: Any, z: list[Any], u: Any) -> Hashable:
    """Signatures of the second derivatives of g, where d(g|H) = 0.

    With g_u ≠ 0 that of the Hessian of g|H divided by g_u, which a factor of g does not change. With dg = 0
    those of the Hessians of g and of g|H together, up to one common sign.
    """
    origin = dict.fromkeys([*z, u], 0)
    on_boundary = sp.hessian(g, z).subs(origin)
    slope = sp.diff(g, u).subs(origin)
    if slope != 0:
        return signature(on_boundary * sp.sign(slope))
    whole = sp.hessian(g, [*z, u]).subs(origin)
    return frozenset((signature(s * whole), signature(s * on_boundary)) for s in (1, -1))


def signature(matrix: Any) -> tuple[int, int]:
    """The numbers of positive and of negative eigenvalues of a symmetric rational matrix, by Descartes' rule.

    >>> signature(sp.Matrix([[0, 1], [1, 0]])), signature(sp.Matrix([[0, 0], [0, -3]]))
    ((1, 1), (0, 1))
    """

    def changes(coefficients: list[Any]) -> int:
        signs = [c > 0 for c in coefficients if c != 0]
        return sum(a != b for a, b in pairwise(signs))  # exact, since all roots are real

    coefficients = matrix.charpoly().all_coeffs()
    return changes(coefficients), changes([(-1) ** i * c for i, c in enumerate(coefficients)])


def half_branches(g: Any, z: Any, u: Any) -> tuple[int, int]:
    """How many half-branches of the curve g(z, u) = 0 lie in u > 0 and in u < 0.

    Raises UndecidedError if g is not quasi-homogeneous: only then are they the real roots at u = ±1.

    >>> z, u = sp.symbols("z u", real=True)
    >>> half_branches(z * u + z**3, z, u)
    (1, 3)
    """
    (a, b), *others = sp.Poly(g, z, u).monoms()
    slopes = {sp.Rational(d - b, a - c) if a != c else sp.oo for c, d in others}  # weight of z / weight of u
    if len(slopes) > 1 or not all(0 < s < sp.oo for s in slopes):
        raise UndecidedError(f"{g} is not quasi-homogeneous: its half-branches are not counted.")
    above, below = (len(set(sp.Poly(g.subs(u, side), z).real_roots())) for side in (1, -1))
    return above, below


def marked_curve(components: list[Any], z: Any, u: Any) -> Hashable:
    """u = c·z^b + … in the local algebra of g(z, u), which is that of z: b, and the sign of c if b is even.

    Raises UndecidedError if no component is linear in u.
    """
    for f in components:
        slope = sp.diff(f, u)
        if slope.is_number and slope != 0:
            others = [sp.Poly(g.subs(u, -f.subs(u, 0) / slope), z) for g in components if g != f]
            solved = sp.Poly(-f.subs(u, 0) / slope, z)
            length = min(monomial for g in others if not g.is_zero for (monomial,) in g.monoms())
            leading = min(((m, c) for (m,), c in solved.terms() if c != 0), default=(length, sp.Integer(1)))
            if leading[0] >= length:
                return "no sign"
            return leading[0], leading[1] > 0 if leading[0] % 2 == 0 else None
    raise UndecidedError(f"No component of {components} is linear in {u}.")


def up_to_signs(germ: Germ) -> Hashable:
    """The first of all forms of a germ under x_i ↦ ±x_j, y_i ↦ ±y_j with u kept, which are A(H)-equivalent.

    >>> up_to_signs(Germ("x1 - u", "x1 u")) == up_to_signs(Germ("u + x1", "x1 u"))
    True
    """
    jet, place = germ.polynomial(DEGREE), germ.boundary_index
    if jet is None:
        raise UndecidedError(f"{germ} is not a polynomial of degree at most {DEGREE}.")
    free = [i for i in range(germ.n) if i != place]
    forms = []
    for order in permutations(free):
        for signs in product((1, -1), repeat=len(free)):
            changed = []
            for f in jet:
                terms = []
                for m, c in f.items():
                    exponents = exponents_of(m, germ.n)
                    moved = tuple(exponents[i] for i in order)
                    sign = 1
                    for s, e in zip(signs, moved):
                        sign *= s**e
                    terms.append((moved, exponents[place], sign * c))
                terms.sort()
                lead = terms[0][2] if terms else 1
                changed.append(tuple((*t[:2], t[2] if lead > 0 else -t[2]) for t in terms))
            forms.append(tuple(sorted(changed)))
    return min(forms)


def number(form: str, **values: int) -> Fraction:
    """A formula in these integers."""
    texts = {name: f"({value})" for name, value in values.items()}
    return Fraction(parse_constant(instance(form, None, texts)).value)
