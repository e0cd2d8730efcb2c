"""Tangent spaces of dense germs modulo a prime: their codimension, and up to which degree they are not all.

In prenormal coordinates (x, g) the fields ∂/∂xᵢ, i ≤ r, say what is in the first r components; the others
carry x^α ∂g/∂y and the target part, e_i becoming −∂g/∂xᵢ. These are products of matrices.

T is a module over the functions of the target, by f* (Mather), also with linear fields added to G₁: if
M^kθ ⊂ T + f*M·M^kθ, then M^kθ ⊂ T. As f*M has x₁, …, x_r, the monomials of degree above k other than those in
y alone need not be looked at, and these up to degree k + l − 1 only, where M^lθ ⊂ T K_e f modulo that prime.
For the groups whose tangent spaces are modules over the source's functions degree k is enough.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Target, Version
from osculant.cas.germs.lifting import primes
from osculant.cas.germs.linear_fields import LinearField, all_linear_fields
from osculant.cas.germs.modular_ring import BELOW, ModularRing
from osculant.cas.germs.modular_span import Array, Span, product
from osculant.cas.germs.prenormal import Prenormal, modular_jet, prenormal

#: monomials that a ring may have
LARGEST_RING = 4000
#: a prime may mislead: another one is tried for every order, so far apart
APART = 256
#: the share of all terms from which on a germ is dense
DENSE = 0.25


@dataclass(frozen=True)
class ModularTangent:
    """A tangent space modulo a prime, by its annihilator in prenormal coordinates.

    Attributes:
        f: the germ in these coordinates.
        version: of the group.
        prime: the prime.
        ring: the monomials looked at.
        values: the functionals, one a column; the rows are described by ``degrees``.
        degrees: the degree of every row: first those of the components from r on, one after the other, then
            of the first r in degrees below the version.
    """

    f: Prenormal
    version: Version
    prime: int
    ring: ModularRing
    values: Array
    degrees: Array

    @property
    def codimension(self) -> int:
        """That of the space in θ, modulo the prime."""
        return int(self.values.shape[1])

    @property
    def depth(self) -> int:
        """The highest degree on which a functional is not 0; −1 if there is none."""
        return _depth(self.values, self.degrees)

    def pairings(self, germ: Germ, group: Group) -> dict[LinearField, list[int]]:
        """The values of all linear fields of a group, in the germ's coordinates."""
        f, n, p = self.f, germ.n, germ.p
        gens = np.array([self.ring.variable(i) for i in range(n)])
        whole = f.components
        moved = np.zeros((n, n, self.codimension), dtype=np.int64)  # of z_c ∂/∂z_i
        for i in range(n):
            slopes = f.ring.projected(np.array([f.ring.derivative(h, i) for h in whole]), self.ring)
            for c in range(n):
                vector = np.array([self.ring.times(slope, gens[c]) for slope in slopes])
                moved[c, i] = self._value(vector)
        found = {}
        components = f.ring.projected(whole, self.ring)
        for field in all_linear_fields(germ, group):
            if field.side == "source":
                row, column = f.source[field.a], f.back[:, field.b]
                total = np.zeros(self.codimension, dtype=np.int64)
                for c in range(n):
                    for i in range(n):
                        total = (total + row[c] * column[i] % self.prime * moved[c, i]) % self.prime
            else:
                vector = np.zeros((p, self.ring.size), dtype=np.int64)
                vector[f.order.index(field.b)] = components[f.order.index(field.a)]
                total = self._value(vector)
            found[field] = [int(v) for v in total]
        return found

    def _value(self, vector: Array) -> Array:
        """The functionals on a vector of all components."""
        (found,) = product(self._reduced(vector)[None, :], self.values, self.prime)
        return np.asarray(found)

    def _reduced(self, vector: Array) -> Array:
        """A vector as a row: what is in the first components from the version's degree on is moved."""
        f, ring = self.f, self.ring
        low = ring.degrees < self.version
        rest = vector[f.rank :].copy()
        for t in range(f.rank):
            h = np.where(low, 0, vector[t])
            for k, g in enumerate(f.components[f.rank :]):
                slope = f.ring.projected(f.ring.derivative(g, t)[None, :], ring)[0]
                rest[k] = (rest[k] - ring.times(h, slope)) % self.prime
        return np.concatenate([rest.ravel(), vector[: f.rank, low].ravel()])


def is_dense(germ: Germ, group: Group, order: int) -> bool:
    """Whether the tangent space of a germ in jets of that order had better be seen modulo a prime first."""
    if germ.field is not None or group.source not in {"all", "boundary"}:
        return False
    every = len(poly.monomials(germ.n, order))
    terms = sum(map(len, germ.jet(order)))
    return every <= LARGEST_RING and terms >= DENSE * germ.p * every


def first_prime(germ: Germ, order: int) -> int:
    """The number below which primes are tried for a germ: just above one that was right, if there is one."""
    known: int = germ.known.get("prime", BELOW - APART * order)
    return known + 1 if "prime" in germ.known else known


def modular_tangent(
    germ: Germ, group: Group, version: Version, order: int, bound: int | None, start: int | None = None
) -> ModularTangent | None:
    """The tangent space modulo a prime, in jets of that order; None if the ring is too large.

    Args:
        germ: the germ.
        group: a group with all fields of the source, or those that keep the boundary.
        version: of the group.
        order: the order of the jets, not below the version.
        bound: l, 1 for the groups that need none: monomials of the kind said are left out and added, so that
            M^{depth+1}θ ⊂ T if depth < order. None: all jets of the order are looked at, and no others.
        start: the prime is the next one below; by default one that was right for the germ, if there is one.

    >>> from osculant.cas.germs.groups import group
    >>> found = modular_tangent(Germ("x, x*y + y**3", "x y"), group("A"), Version.EXTENDED, 2, 3)
    >>> found.codimension, found.depth
    (0, -1)
    """
    left = bound is not None and group.target == "left"
    high = order + (bound - 1 if bound is not None and left else 0)
    if len(poly.monomials(germ.n, high + 1)) > LARGEST_RING:
        return None
    place = germ.boundary_index if group.source == "boundary" else None
    start = start or first_prime(germ, order)
    for prime in primes(start - 1):
        jet = modular_jet(germ, high + 1, prime)
        if jet is None:
            continue
        f = prenormal(jet, germ.n, place, order + 1, high + 1, prime)
        if not left or _contact_depth(f, high + 1 - order) < high + 1 - order:
            break
    ring = ModularRing(germ.n, order, high, f.rank, prime)
    values, degrees = _annihilator(f, ring, group.target, version)
    return ModularTangent(f, version, prime, ring, values, degrees)


def _contact_depth(f: Prenormal, bound: int) -> int:
    """The highest degree up to ``bound`` in which T K_e f is not all."""
    ring = ModularRing(f.ring.n, 1, bound, f.rank, f.ring.prime)  # x lies in f*M
    values, degrees = _annihilator(f, ring, "contact", Version.EXTENDED)
    return _depth(values, degrees)


def _depth(values: Array, degrees: Array) -> int:
    return int(max(degrees[values.any(axis=1)], default=-1))


def _annihilator(f: Prenormal, ring: ModularRing, target: Target, version: Version) -> tuple[Array, Array]:
    """(functionals as columns of values, degrees of the rows) of a tangent space: see `ModularTangent`."""
    q = len(f.components) - f.rank
    width, low = q * ring.size, np.tile(ring.degrees[ring.degrees < version], f.rank)
    degrees = np.tile(ring.degrees, q)
    by_degree = np.argsort(degrees, kind="stable")
    span = Span(width, ring.prime)
    if q:
        span.add_all([part[:, by_degree] for part in _rows(f, ring, target, version)])
    _, found = span.annihilator()
    values = np.zeros((width + len(low), found.shape[1] + len(low)), dtype=np.int64)
    values[by_degree, : found.shape[1]] = found
    values[width:, found.shape[1] :] = np.eye(len(low), dtype=np.int64)
    return values, np.concatenate([degrees, low])


def _rows(f: Prenormal, ring: ModularRing, target: Target, version: Version) -> list[Array]:
    """The vectors that span the space, in the components from r on, in parts."""
    r, q = f.rank, len(f.components) - f.rank
    slopes = [
        [f.ring.projected(f.ring.derivative(g, i)[None, :], ring)[0] for g in f.components[r:]]
        for i in range(ring.n)
    ]
    parts = []
    for i in range(r, ring.n):
        field, least = slopes[i], int(version)
        if i == f.boundary:
            field, least = [ring.times(s, ring.variable(i)) for s in field], max(0, version - 1)
        rows = np.concatenate([ring.matrix(s) for s in field], axis=1)
        parts.append(rows[ring.degrees >= least])
    components = f.ring.projected(f.components, ring)
    if target == "left":
        weights = [[ring.matrix(s) for s in slopes[t]] for t in range(r)]
        for betas, values in ring.powers(list(components), ring.high):
            if len(betas) and betas[0].sum() >= version:
                parts += _units(values, q)
                for images in weights:
                    parts.append(
                        np.concatenate([product(values, image, ring.prime) for image in images], axis=1)
                    )
    elif target == "contact":
        for h in components:
            rows = ring.matrix(h)[ring.degrees >= version - 1]
            parts += _units(rows, q)
    return [part[part.any(axis=1)] for part in parts]


def _units(values: Array, q: int) -> list[Array]:
    """Rows of functions as rows of vectors, in each component."""
    found = []
    for k in range(q):
        whole = np.zeros((len(values), q, values.shape[1]), dtype=np.int64)
        whole[:, k] = values
        found.append(whole.reshape(len(values), -1))
    return found
