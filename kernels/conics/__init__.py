"""Conics tangent to an arc at both ends, and parabolas among them."""
