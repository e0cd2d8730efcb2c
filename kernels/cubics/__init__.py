"""G1 cubics with both arms free: kernels."""
