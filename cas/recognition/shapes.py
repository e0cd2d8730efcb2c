"""The shape of a normal form of maps: which variables are components, which are not, and the weights.

For A and A(H) the components of a normal form are x₁, …, x_r, coordinates of their own, and functions h. The
weights follow from that: the coordinates of the kernel of df lie lowest; u lies above the xᵢ if it is the
linear part of some h (then u∂/∂xᵢ, with a field in the target, keeps the linear part), else below; target
coordinates follow their components, the h in the order of their lowest terms.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from osculant.cas.errors import UndecidedError
from osculant.cas.recognition.forms import Column, Exponents, Form
from osculant.cas.recognition.levels import Weights, flagged
from osculant.cas.recognition.reduction import Family

#: between the flags of coordinates
STEP = 2


@dataclass(frozen=True)
class Shape:
    """The shape of a normal form.

    Attributes:
        x: the variables that are components, with the component of each.
        z: the other variables without u.
        u: the place of u; None without H.
        linear: the component with u as its linear part; None if there is none.
        h: the components that are not among x, by the weight of their lowest terms.
        weights: the weights of all coordinates.
    """

    x: dict[int, int]
    z: tuple[int, ...]
    u: int | None
    linear: int | None
    h: tuple[int, ...]
    weights: Weights

    def families(self, form: Form) -> tuple[Family, ...]:
        """Linear forms in x₁, …, x_r, r ≥ 2, that stand before a monomial without x."""
        if len(self.x) < 2:
            return ()
        found = []
        for term in form.core:
            own = [i for i in self.x if term.monomial[i]]
            if len(own) == 1 and term.monomial[own[0]] == 1 < sum(term.monomial) and term.sign is None:
                j = term.component
                columns: dict[Column, int] = {(_put(term.monomial, own[0], i), j): i for i in self.x}
                found.append(Family(columns, term.column, own[0], self.x))
        return tuple(found)


@lru_cache(maxsize=256)
def shape(form: Form) -> Shape:
    """The shape of a form for A or A(H).

    Raises UndecidedError for a form whose linear part is no part of the coordinates.

    >>> from osculant.cas.germs.reference import reference
    >>> from osculant.cas.recognition.forms import form
    >>> found = shape(form(reference("table 6.2")["5c"]))
    >>> found.x, found.z, found.linear, found.h
    ({0: 0, 1: 1}, (2,), 3, (3, 2, 4))
    """
    u = form.boundary
    x: dict[int, int] = {}
    linear = None
    for j in range(form.p):
        terms = [t for t in form.core if t.component == j]
        first = [t.monomial.index(1) for t in terms if sum(t.monomial) == 1]
        if not first:
            continue
        if first == [u]:
            linear = j
        elif len(terms) == 1 and first[0] not in x:
            x[first[0]] = j
        else:
            raise UndecidedError(f"{form} is not in the coordinates that its linear part gives.")
    z = tuple(i for i in range(form.n) if i not in x and i != u)
    h = [j for j in range(form.p) if j not in x.values()]
    least = STEP * len(z) + STEP
    source = [0] * form.n
    for place, i in enumerate(reversed(z), start=1):
        source[i] = STEP * place
    for place, i in enumerate(reversed(list(x)), start=1):
        source[i] = least + STEP * place
    top = least + STEP * len(x) + 1
    if u is not None:
        source[u] = least if linear is None else top + len(h)
    target = [0] * form.p
    for i, j in x.items():
        target[j] = source[i]
    plain = flagged(source, target)
    lowest = {j: [plain.of(t.monomial) for t in form.core if t.component == j] for j in h}
    h.sort(key=lambda j: (not lowest[j], min(lowest[j], default=0)))
    for place, j in enumerate(h):
        target[j] = top + place
    return Shape(x, z, u, linear, tuple(h), flagged(source, target))


def _put(monomial: Exponents, old: int, new: int) -> Exponents:
    found = list(monomial)
    found[old] -= 1
    found[new] += 1
    return tuple(found)
