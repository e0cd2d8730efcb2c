"""Invariants of a formula as simplified expressions."""
