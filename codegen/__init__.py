"""Expressions in, compiled functions out."""
