"""The curve, sampled inside kernels."""
