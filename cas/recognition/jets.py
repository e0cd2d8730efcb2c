"""Jets of maps made from terms and from matrices, and read as terms."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from flint import fmpq, fmpq_mat

from osculant.cas.germs.jets_of_maps import MapJet
from osculant.cas.germs.model import ring
from osculant.cas.recognition.forms import Column, Exponents


def jet_of(terms: Iterable[tuple[Column, Any]], n: int, p: int, order: int) -> MapJet:
    """The jet of a map from terms: (exponents, component) and a number of flint's.

    >>> jet_of([(((0, 2), 0), fmpq(3))], 2, 1, 2).polynomials() == ({2 << 24 | 2 << 12: 3},)
    True
    """
    context = ring([f"x{i + 1}" for i in range(n)])
    found: list[list[dict[Exponents, Any]]] = [[{} for _ in range(order + 1)] for _ in range(p)]
    for (m, j), c in terms:
        if (degree := sum(m)) <= order:
            found[j][degree][m] = c
    return MapJet(order, tuple(tuple(context.from_dict(part) for part in parts) for parts in found))


def graded_jet(jet: MapJet, degrees: Sequence[int]) -> MapJet:
    """The same map, its parts those of equal weighted degree, cut above the order.

    Jets of one grading are composed as they are; what they cannot do is to flow and to be inverted.
    """
    context, order = jet.context, jet.order
    found: list[list[dict[Exponents, Any]]] = [[{} for _ in range(order + 1)] for _ in jet.components]
    for (m, j), c in terms_of(jet).items():
        if (degree := sum(d * e for d, e in zip(degrees, m))) <= order:
            found[j][degree][m] = c
    return MapJet(order, tuple(tuple(context.from_dict(part) for part in parts) for parts in found))


def terms_of(jet: MapJet) -> dict[Column, Any]:
    """The terms of a jet, with numbers of flint's."""
    return {
        (tuple(map(int, m)), j): c
        for j, parts in enumerate(jet.components)
        for part in parts
        for m, c in part.to_dict().items()
    }


def matrix_jet(matrix: fmpq_mat, order: int) -> MapJet:
    """The linear map of a matrix as a jet."""
    p, n = matrix.nrows(), matrix.ncols()
    units = [tuple(int(i == j) for j in range(n)) for i in range(n)]
    found = (((units[j], i), matrix[i, j]) for i in range(p) for j in range(n) if matrix[i, j] != 0)
    return jet_of(found, n, p, order)


def identity_jet(n: int, order: int) -> MapJet:
    """The identity as a jet."""
    return matrix_jet(identity(n), order)


def identity(n: int) -> fmpq_mat:
    """The unit matrix."""
    return fmpq_mat(n, n, [fmpq(int(i == j)) for i in range(n) for j in range(n)])


def matrix_of(rows: Sequence[Sequence[Any]]) -> fmpq_mat:
    """A matrix of flint's from its rows."""
    return fmpq_mat(len(rows), len(rows[0]), [fmpq(v) if isinstance(v, int) else v for r in rows for v in r])
