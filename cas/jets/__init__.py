"""Invariants over jets: the derivatives of any curve."""
