"""Machine-speed kernels: floats in contiguous arrays, numba; never sympy, never files."""
