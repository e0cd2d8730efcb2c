"""Formulas: text, expressions, and the bridge to sympy."""
