"""Zeros of functions given by Taylor programs, isolated in enclosures of doubles."""
