"""Equivalences of germs, for the checker: changes of coordinates are substituted, nothing is searched.

A file has the germ f (``components``, ``source``, ``boundary``, ``field``, as a file of a germ), the
``group`` and the ``order`` k; under ``form`` another germ g with ``components``, ``variables``, ``boundary``
and the values of its ``moduli``; the jets φ (``phi``, formulas for the source variables of f in those of g)
and, for A and L, ψ (``psi``, formulas in the names ``target``), for K and C the ``matrix`` of functions of
the variables of g; and ``scales``, factors s of these variables and t of the components of g. Scales and
moduli may have roots of positive numbers: see `osculant.certificates.check_powers`. With h = ψ∘f∘φ, or the
matrix times f∘φ, it is

    h ≡ Σ c x^α e_j modulo degree k + 1,    g = Σ d x^α e_j with d = c·s^α·t_j for the same terms,

the derivatives of φ and ψ at the origin, or the matrix there, are invertible, and for a group that preserves
H = {u = 0} φ takes u to u·v with v(0) > 0 (v(0) ≠ 0 if the numbers are complex).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from osculant.certificates.check_algebra import Exponents, Polynomial, Vector, pivots, plus, read, times
from osculant.certificates.check_numbers import current
from osculant.certificates.check_powers import Power, is_positive, read_power
from osculant.certificates.check_tangents import Problem
from osculant.certificates.check_text import require

#: order of jets at most
ORDER = 63


@dataclass(frozen=True)
class Equivalent:
    """Two germs whose jets of an order were found equivalent: their names, and over which numbers."""

    first: str
    second: str
    order: int
    numbers: str


def check_equivalence(problem: Problem, data: Mapping[str, Any]) -> Equivalent:
    """Check an equivalence of jets by substitution; raises RejectedError.

    Args:
        problem: the germ f with the group.
        data: the file (module text).
    """
    order, form = data["order"], data["form"]
    require(type(order) is int and 1 <= order <= ORDER, f"{str(order)[:60]!r} is no order of jets")
    names = tuple(map(str, form["variables"]))
    require(len(set(names)) == len(names) == problem.n, "the form has other variables, or too few")
    moduli = {str(name): read_power(value) for name, value in form["moduli"].items()}
    field = current()
    taken = {*names, *map(str, data["target"]), *(() if field is None else (field.name,))}
    require(not set(moduli) & taken and len(taken) >= len(names), "a modulus that is called like a variable")
    wanted = _form(tuple(map(str, form["components"])), names, moduli, order)
    require(len(wanted) == problem.p, "the form has another number of components")
    numbers = _numbers()
    phi = [_jet(text, names, order) for text in data["phi"]]
    require(len(phi) == problem.n, "φ has another number of components")
    _invertible(phi, problem.n, "φ")
    found = composed(problem.jet(order), phi, problem.n, order)
    found = _target(problem, data, names, found, order)
    source, target = _scales(problem, data["scales"])
    _kept(problem, form["boundary"], names, phi, source, numbers)
    for f, g, t in zip(found, wanted, target):
        require(set(f) == set(g), "the jets differ: a term is missing in one of them")
        for m, c in f.items():
            scaled = Power(c) * t
            for s, e in zip(source, m):
                scaled = scaled * s**e if e else scaled
            require(scaled == g[m], f"the jets differ: the coefficient of the term {list(m)} is another")
    told = ", ".join(f"{name} = {_shown(value)}" for name, value in form["moduli"].items())
    second = f"({', '.join(map(str, form['components']))})" + (f" with {told}" if told else "")
    return Equivalent(f"({', '.join(problem.components)})", second, order, numbers)


def composed(f: Sequence[Polynomial], images: Vector, n: int, order: int) -> Vector:
    """f(images) up to a degree, the powers of the images made once.

    >>> composed([{(2,): Fraction(1)}], [{(1,): Fraction(1), (2,): Fraction(3)}], 1, 3)
    [{(2,): Fraction(1, 1), (3,): Fraction(6, 1)}]
    """
    known: dict[Exponents, Polynomial] = {(0,) * len(images): {(0,) * n: Fraction(1)}}

    def power(m: Exponents) -> Polynomial:
        if m not in known:
            i = next(i for i, e in enumerate(m) if e)
            known[m] = times(power((*m[:i], m[i] - 1, *m[i + 1 :])), images[i], order)
        return known[m]

    found: Vector = []
    for component in f:
        total: Polynomial = {}
        for m, c in component.items():
            total = plus(total, power(m), c)
        found.append(total)
    return found


def _form(
    texts: Sequence[str], names: Sequence[str], moduli: Mapping[str, Power], order: int
) -> list[dict[Exponents, Power]]:
    """The normal form up to that degree: coefficients are numbers times powers of moduli."""
    found = []
    n = len(names)
    for text in texts:
        terms: dict[Exponents, Power] = {}
        for m, c in read(text, (*names, *moduli)).items():
            if sum(m[:n]) > order:
                continue
            require(m[:n] not in terms, "a coefficient of the form is a sum")
            value = Power(c)
            for modulus, e in zip(moduli.values(), m[n:]):
                value = value * modulus**e if e else value
            terms[m[:n]] = value
        found.append(terms)
    return found


def _jet(text: Any, names: Sequence[str], order: int) -> Polynomial:
    """A component of a change of coordinates; it keeps the origin."""
    f = read(text, names)
    require((0,) * len(names) not in f, "a change of coordinates moves the origin")
    require(all(sum(m) <= order for m in f), "a change of coordinates has terms above the order of the jets")
    return f


def _invertible(components: Vector, n: int, what: str) -> None:
    rows = [{i: f[unit] for i, unit in enumerate(_units(n)) if unit in f} for f in components]
    require(len(rows) == n and len(pivots(rows)) == n, f"the derivative of {what} is not invertible")


def _units(n: int) -> list[Exponents]:
    return [tuple(int(i == j) for j in range(n)) for i in range(n)]


def _target(problem: Problem, data: Mapping[str, Any], names: Sequence[str], f: Vector, order: int) -> Vector:
    """ψ(f), or the matrix times f."""
    part, p = problem.parts[1], problem.p
    psi, matrix = data["psi"], data["matrix"]
    require((psi is not None) == (part == "left"), f"a change of the target is not in {problem.group}")
    require((matrix is not None) == (part == "contact"), f"a matrix is not in {problem.group}")
    if psi is not None:
        target = tuple(map(str, data["target"]))
        require(len(set(target)) == len(target) == p, "the target has other variables")
        changes = [_jet(text, target, order) for text in psi]
        _invertible(changes, p, "ψ")
        return composed(changes, f, problem.n, order)
    if matrix is not None:
        rows = [[read(text, names) for text in row] for row in matrix]
        require(len(rows) == p and all(len(row) == p for row in rows), "the matrix has another size")
        zero = (0,) * problem.n
        at_0 = [{j: entry[zero] for j, entry in enumerate(row) if zero in entry} for row in rows]
        require(len(pivots(at_0)) == p, "the matrix is not invertible at the origin")
        found = []
        for row in rows:
            total: Polynomial = {}
            for entry, component in zip(row, f):
                total = plus(total, times(entry, component, order))
            found.append(total)
        return found
    return f


def _scales(problem: Problem, told: Mapping[str, Any]) -> tuple[list[Power], list[Power]]:
    """The factors of the variables and of the components, which the group must have."""
    source, target = ([read_power(value) for value in told[key]] for key in ("source", "target"))
    require(len(source) == problem.n and len(target) == problem.p, "there are other scales")
    one = Power(Fraction(1))
    if problem.parts[1] == "none":
        require(all(t == one for t in target), f"scales of the target are not in {problem.group}")
    if problem.parts[0] == "none":
        require(all(s == one for s in source), f"scales of the source are not in {problem.group}")
    return source, target


def _kept(
    problem: Problem, boundary: Any, names: Sequence[str], phi: Vector, scales: list[Power], numbers: str
) -> None:
    """φ and the scales are in the source part of the group."""
    if problem.parts[0] == "none":
        require(phi == [{m: Fraction(1)} for m in _units(problem.n)], "φ is not the identity")
    if problem.fixed is None:
        require(boundary is None is problem.boundary, f"{problem.group} has no boundary variable")
        return
    require(boundary in names, "the form has no boundary variable")
    place = names.index(boundary)
    image = phi[problem.fixed]
    require(all(m[place] for m in image), "φ does not preserve the boundary")
    factor = image.get(_units(problem.n)[place], Fraction(0))
    require(bool(factor), "φ does not preserve the boundary")
    if numbers == "real":
        require(is_positive(factor) and scales[place].positive(), "φ exchanges the sides of the boundary")


def _numbers() -> str:
    """Which numbers an equivalence is over: real ones if the number field is told to be real."""
    field = current()
    return "real" if field is None or field.interval is not None else "complex"


def _shown(value: Any) -> str:
    if not isinstance(value, Mapping):
        return str(value)
    powers = [f"({base})^({exponent})" for base, exponent in value["powers"]]
    return "*".join([str(value["factor"]), *powers])
