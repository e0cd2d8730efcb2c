"""Linear vector fields, for the checker: what they add to a tangent space, and whether they are nilpotent.

Imports nothing of osculant but the checker's own algebra.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from osculant.certificates.check_algebra import Row, Vector, derivative, number
from osculant.certificates.check_tangents import Problem, added, cut, moved
from osculant.certificates.check_text import require


def applied(problem: Problem, told: Mapping[str, Any], order: int, weights: tuple[int, ...]) -> Vector:
    """What a linear field, a matrix on one side, adds to the tangent space."""
    matrix = [[number(v) for v in row] for row in told["matrix"]]
    top = order // min(weights, default=1)
    jet = [cut(f, order, weights) for f in problem.jet(top)]
    side, n = told["side"], problem.n
    size = n if side == "source" else problem.p
    require(len(matrix) == size and all(len(row) == size for row in matrix), "a field has the wrong size")
    found: Vector = [{} for _ in range(problem.p)]
    for a, row in enumerate(matrix):
        for b, v in enumerate(row):
            if v and side == "source":
                found = [
                    added(f, {moved(m, a): c for m, c in derivative(g, b).items()}, v)
                    for f, g in zip(found, jet)
                ]
            elif v:
                found[b] = added(found[b], jet[a], v)
    return [cut(f, order, weights) for f in found]


def check_nilpotent(problem: Problem, fields: Sequence[Mapping[str, Any]]) -> None:
    """Check that linear fields belong to the group and are triangular together in some coordinates."""
    source, target = problem.parts
    for side, size in (("source", problem.n), ("target", problem.p)):
        matrices = [[[number(v) for v in row] for row in f["matrix"]] for f in fields if f["side"] == side]
        if not matrices:
            continue
        require((source if side == "source" else target) != "none", "a field is not of the group")
        if side == "source" and problem.fixed is not None:
            u = problem.fixed
            require(all(not m[a][u] for m in matrices for a in range(size)), "a field moves the boundary")
        killed: list[Row] = []  # functions x_b that the fields carry into the span of those before
        while len(killed) < size:
            rows = _kernel(matrices, killed, size)
            require(len(rows) > len(killed), "the fields are not nilpotent together")
            killed = rows
    require(all(f["side"] in {"source", "target"} for f in fields), "a field has no side")


def _kernel(matrices: Sequence[list[list[Fraction]]], killed: list[Row], size: int) -> list[Row]:
    """A basis of the functions v with M v in the span of those killed before; M x_b = Σ M[a][b] x_a."""
    # unknowns: v, and for every matrix the coefficients of M v on the killed ones
    width = size + len(matrices) * len(killed)
    equations: list[Row] = []
    for k, matrix in enumerate(matrices):
        for a in range(size):
            row: Row = {b: matrix[a][b] for b in range(size) if matrix[a][b]}
            for i, f in enumerate(killed):
                if f.get(a):
                    row[size + k * len(killed) + i] = -f[a]
            if row:
                equations.append(row)
    return [{c: x for c, x in v.items() if c < size} for v in null_space(equations, width)]


def null_space(equations: Sequence[Row], width: int) -> list[Row]:
    """A basis of the solutions.

    >>> null_space([{0: Fraction(1), 1: Fraction(1)}], 2)
    [{0: Fraction(1, 1), 1: Fraction(-1, 1)}]
    """
    reduced: dict[int, Row] = {}
    for given in equations:
        row = dict(given)
        for lead, known in reduced.items():
            if factor := row.get(lead):
                row = _combined(row, known, -factor)
        if not row:
            continue
        lead = max(row)
        row = {c: v / row[lead] for c, v in row.items()}
        for other in list(reduced):
            if factor := reduced[other].get(lead):
                reduced[other] = _combined(reduced[other], row, -factor)
        reduced[lead] = row
    found: list[Row] = []
    for c in (c for c in range(width) if c not in reduced):
        rest = {lead: -row[c] for lead, row in reduced.items() if row.get(c)}
        found.append({c: Fraction(1), **rest})
    return found


def _combined(a: Row, b: Row, factor: Any) -> Row:
    found = dict(a)
    for c, v in b.items():
        value = found.get(c, 0) + factor * v
        if value:
            found[c] = value
        else:
            found.pop(c, None)
    return found
