"""Inscribed polygons: the chords of arcs, in the plane and in space."""
