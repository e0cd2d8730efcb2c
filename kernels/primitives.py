"""The numbers by which kernels tell apart what pieces are made of, and by which error they are chosen."""

#: the least Hausdorff distance: of parabolas, conics, biarcs
PARABOLA, CONIC, BIARC = 1, 2, 3
#: areas: the parabola; the conic, or biarc, whose two moons are equal; the conic of least area
AREA_PARABOLA, EQUISYMMETRIC, LEAST_AREA, EQUISYMMETRIC_BIARC = 4, 5, 6, 7
#: codes of the same shape of pieces
PARABOLAS, BIARCS = (PARABOLA, AREA_PARABOLA), (BIARC, EQUISYMMETRIC_BIARC)
#: codes of areas between an arc and a parabola or conic
CONIC_AREAS = (AREA_PARABOLA, EQUISYMMETRIC, LEAST_AREA)
