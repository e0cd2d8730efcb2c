"""Gauss–Legendre rules on [0, 1], and the weights of each rule's last Legendre coefficient.

A smooth integrand's coefficients decay geometrically, and n nodes miss those from the 2n-th on: the square
of the last one that n nodes see, in parts of the first ones, estimates the error.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.polynomial.legendre import Legendre, leggauss

#: numbers of nodes
SIZES = (3, 7, 14, 28)


def _rules() -> tuple[np.ndarray[Any, Any], ...]:
    nodes, weights, tails = np.zeros((3, len(SIZES), max(SIZES)))
    for rule, size in enumerate(SIZES):
        x, w = leggauss(size)
        nodes[rule, :size] = 0.5 + 0.5 * x
        weights[rule, :size] = 0.5 * w
        tails[rule, :size] = 0.5 * w * (2 * size - 1) * Legendre.basis(size - 1)(x)
    return nodes, weights, tails


#: rule, node: its place, its weight, and its weight in the last coefficient
NODES, WEIGHTS, TAILS = _rules()
