"""Formulas in enclosures of doubles: zeros of forms, where a curve is finite, where it is a polynomial."""
