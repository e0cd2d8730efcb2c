"""Curves given by formulas, in the plane and in space."""
