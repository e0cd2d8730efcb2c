"""The numbers by which kernels tell the primitives apart."""

PARABOLA = 1
CONIC = 2
BIARC = 3
