"""Germs of the lists in random dense coordinates, and a check of equivalences along random lines.

The check knows nothing of jets: it puts (a₁t, …, aₙt) into φ, the outcome into f and that into ψ, with series
in t alone.
"""

from __future__ import annotations

import random
from collections import defaultdict
from fractions import Fraction
from math import lcm

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.jets_of_maps import map_jet
from osculant.cas.germs.reference import reference
from osculant.cas.recognition.forms import form


def members(name, most=99):
    """(form, germ, signs, moduli) for what stands for all in a list, up to a degree of determinacy."""
    for entry in reference(name).entries:
        for signs, parameters in entry.tried():
            moduli = {p.name for p in entry.parameters if p.least is None}
            found = form(entry, **{k: v for k, v in parameters.items() if k not in moduli})
            if found.order <= most:
                values = {k: Fraction(v) for k, v in parameters.items() if k in moduli}
                yield found, entry.germ(signs, **parameters), signs, values


def diffeomorphism(draw, n, order, u=None):
    """A dense jet with denominators up to 3; the u-th component is u·(positive + …) if there is a u."""
    while True:
        components = []
        for i in range(n):
            terms = {}
            for m in poly.monomials(n, order)[1:]:
                exponents = poly.exponents_of(m, n)
                if i == u and not exponents[u]:
                    continue
                c = Fraction(draw.randint(-3, 3), draw.randint(1, 3))
                if i == u and sum(exponents) == 1:
                    c = abs(c) or Fraction(1)
                if c:
                    terms[m] = c
            components.append(terms)
        if all(components) and (found := map_jet(components, n, order)).linear_part().det() != 0:
            return found


def disguised(germ, form, seed):
    """The germ in random coordinates of source and target, cut at the order of the form."""
    draw, k = random.Random(seed), form.order
    f = map_jet(germ.jet(k), germ.n, k).compose(diffeomorphism(draw, germ.n, k, form.boundary))
    f = diffeomorphism(draw, germ.p, k).compose(f)
    return Germ([as_node(g, germ.source) for g in f.polynomials()], germ.source, germ.boundary)


def along(components, series, k):
    """The components at series in t (lists of k + 1 coefficients), cut above t^k."""
    n = len(series)
    powers = [[[Fraction(1)] + [Fraction(0)] * k] for _ in series]

    def times(a, b):
        found = [Fraction(0)] * (k + 1)
        for i, x in enumerate(a):
            if x:
                for j in range(k + 1 - i):
                    found[i + j] += x * b[j]
        return found

    products = {}

    def product(exponents):
        if exponents not in products:
            total = None
            for i, e in enumerate(exponents):
                while len(powers[i]) <= e:
                    powers[i].append(times(powers[i][-1], series[i]))
                if e:
                    total = powers[i][e] if total is None else times(total, powers[i][e])
            products[exponents] = total
        return products[exponents]

    images = []
    for f in components:
        total = [Fraction(0)] * (k + 1)
        for m, c in f.items():
            total = [a + Fraction(c) * b for a, b in zip(total, product(poly.exponents_of(m, n)))]
        images.append(total)
    return images


def check(found, germ, seed=0, lines=2):
    """Asserts that an equivalence is one: both sides, the linear parts, the boundary and the scales."""
    draw, k, form = random.Random(seed), found.order, found.form
    for _ in range(lines):
        point = [Fraction(draw.randint(-5, 5), draw.randint(1, 4)) for _ in range(form.n)]
        line = [[Fraction(0), a] + [Fraction(0)] * (k - 1) for a in point]
        image = along(found.source.polynomials(), line, k)
        image = along(found.target.polynomials(), along(germ.jet(k), image, k), k)
        wanted = [[Fraction(0)] * (k + 1) for _ in range(form.p)]
        for (m, j), c in found.coefficients.items():
            value = c
            for a, e in zip(point, m):
                value *= a**e
            wanted[j][sum(m)] += value
        assert image == wanted
    assert found.source.linear_part().det() != 0 and found.target.linear_part().det() != 0
    if (u := form.boundary) is not None:
        of_u = found.source.polynomials()[u]
        assert all(poly.exponents_of(m, form.n)[u] for m in of_u) and of_u[poly.variable(u, form.n)] > 0
        assert found.scales.source[u].sign == 1
    check_scales(found)


def check_scales(found):
    """Asserts that the scales make the printed coefficients, by powers in which no root is left."""
    form, roots = found.form, (*found.scales.source, *found.scales.target)
    values = defaultdict(Fraction, found.coefficients)
    terms = [t for t in form.terms if sum(t.monomial) <= form.order]
    assert set(found.coefficients) <= {t.column for t in terms}
    for t in terms:
        wanted = t.coefficient * (1 if t.sign is None else found.signs[t.sign])
        modulus = None if t.modulus is None else found.moduli[t.modulus]
        if modulus == 0:
            assert values[t.column] == 0
            continue
        extra = [] if modulus is None or isinstance(modulus, Fraction) else [modulus]
        if isinstance(modulus, Fraction):
            wanted *= modulus
        power = 2 * lcm(*(r.index for r in (*roots, *extra)))
        total, sign = values[t.column] ** power, 1 if values[t.column] > 0 else -1
        exponents = [*t.monomial, *(int(j == t.component) for j in range(form.p))]
        for r, e in zip(roots, exponents):
            total *= r.base ** (e * power // r.index)
            sign *= r.sign**e
        right, wanted_sign = wanted**power, 1 if wanted > 0 else -1
        for r in extra:
            right *= r.base ** (power // r.index)
            wanted_sign *= r.sign
        assert (total, sign) == (right, wanted_sign)
