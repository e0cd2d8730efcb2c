"""Generated from sympy's π and log 2 by codegen.generate; do not edit.

Each is a + b + c, three doubles, the first two with few digits, so that multiples are exact.
"""


HALF_PI = (1.5707963267941523, 7.443547480480255e-13, 6.36831716351095e-25)
LOG_2 = (0.6931471805592082, 7.371002565161996e-13, 5.8029889835956905e-25)
