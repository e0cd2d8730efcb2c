"""Bihelices: two helical arcs with a common tangent."""
