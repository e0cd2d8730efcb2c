"""Distances between dense polygons, made without the code that they check."""

import numpy as np
from scipy.spatial import cKDTree

from osculant.kernels.curves.jets import sample_many


def polygon(jet, a, b, count):
    """Points of the curve of a jet over [a, b], equidistant in the parameter: (count, 2 or 3)."""
    rows = np.empty((count, jet.size))
    sample_many(jet.address, np.linspace(a, b, count), rows)
    return rows.reshape(count, jet.formulas, jet.order + 1)[:, :, 0].copy()


def distances(points, line):
    """Distances of points from a polygon, through a tree of its corners."""
    near = cKDTree(line).query(points)[1]
    found = np.full(len(points), np.inf)
    for shift in (-1, 0):
        i = np.clip(near + shift, 0, len(line) - 2)
        step = line[i + 1] - line[i]
        along = np.clip(((points - line[i]) * step).sum(1) / (step * step).sum(1), 0, 1)
        found = np.minimum(found, np.linalg.norm(points - line[i] - along[:, None] * step, axis=1))
    return found


def two_sided(one, other):
    """The larger of the distances from the corners of either polygon to the other one."""
    return max(distances(one, other).max(), distances(other, one).max())
