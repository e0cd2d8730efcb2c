"""Biarcs: two circular arcs with a common tangent."""
