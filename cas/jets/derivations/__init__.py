"""The mathematics of the jets' forms, derived step by step with sympy."""
