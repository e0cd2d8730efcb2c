"""Generated from cas/jets/plane.py and cas/jets/space.py by codegen.generate; do not edit.

Made with sympy 1.14.0, mpmath 1.3.0: `make generate`.
"""


from __future__ import annotations

from osculant.kernels.jit import kernel


@kernel
def inflection(x1: float, x2: float, y1: float, y2: float) -> float:
    """The inflection form of a plane curve's derivatives 1…2."""
    return x1*y2 - x2*y1


@kernel
def parabolic(x1: float, x2: float, x3: float, x4: float, y1: float, y2: float, y3: float, y4: float) -> float:
    """The parabolic form of a plane curve's derivatives 1…4."""
    return (3.0*x1*y2 - 3.0*x2*y1)*(x1*y4 + 4.0*x2*y3 - 4.0*x3*y2 - x4*y1) - 5.0*((x1*y3 - x3*y1) * (x1*y3 - x3*y1))


@kernel
def sextactic(x1: float, x2: float, x3: float, x4: float, x5: float, y1: float, y2: float, y3: float, y4: float, y5: float) -> float:
    """The sextactic form of a plane curve's derivatives 1…5."""
    _v0 = x1*y2
    _v1 = x2*y1
    _v2 = x1*y3 - x3*y1
    _v3 = x3*y2
    _v4 = x1*y4
    _v5 = 3.0*_v0 - 3.0*_v1
    return -_v2*(-40.0*(_v2 * _v2) + 8.0*_v5*(-4.0*_v3 + _v4 + 4.0*x2*y3 - x4*y1)) + (_v0 - _v1)*(3.0*_v2*(-2.0*_v3 - 7.0*_v4 + 2.0*x2*y3 + 7.0*x4*y1) + 3.0*_v5*(x1*y5 + 5.0*x2*y4 - 5.0*x4*y2 - x5*y1))


@kernel
def vertex(x1: float, x2: float, x3: float, y1: float, y2: float, y3: float) -> float:
    """The vertex form of a plane curve's derivatives 1…3."""
    return ((x1 * x1) + (y1 * y1))*(x1*y3 - x3*y1) - (x1*x2 + y1*y2)*(3.0*x1*y2 - 3.0*x2*y1)


@kernel
def space_vertex(x1: float, x2: float, x3: float, y1: float, y2: float, y3: float, z1: float, z2: float, z3: float) -> float:
    """The vertex form of a space curve's derivatives 1…3."""
    _v0 = x1*y2 - x2*y1
    _v1 = -x1*z2 + x2*z1
    _v2 = y1*z2 - y2*z1
    return -(3.0*(_v0 * _v0) + 3.0*(_v1 * _v1) + 3.0*(_v2 * _v2))*(x1*x2 + y1*y2 + z1*z2) + ((x1 * x1) + (y1 * y1) + (z1 * z1))*(_v0*(x1*y3 - x3*y1) + _v1*(-x1*z3 + x3*z1) + _v2*(y1*z3 - y3*z1))


@kernel
def inflection_size(n1: float, n2: float) -> float:
    """The size of the terms of the inflection form, from the derivatives' lengths."""
    return n1*n2


@kernel
def parabolic_size(n1: float, n2: float, n3: float, n4: float) -> float:
    """The size of the terms of the parabolic form, from the derivatives' lengths."""
    _v0 = (n1 * n1)
    return 3.0*_v0*n2*n4 + 5.0*_v0*(n3 * n3) + 12.0*n1*(n2 * n2)*n3


@kernel
def sextactic_size(n1: float, n2: float, n3: float, n4: float, n5: float) -> float:
    """The size of the terms of the sextactic form, from the derivatives' lengths."""
    _v0 = (n1 * n1 * n1)
    _v1 = (n2 * n2)
    _v2 = (n1 * n1)
    _v3 = 45.0*n4
    return 9.0*_v0*_v1*n5 + _v0*_v3*n2*n3 + 40.0*_v0*(n3 * n3 * n3) + 90.0*_v1*_v2*(n3 * n3) + _v2*_v3*(n2 * n2 * n2)


@kernel
def vertex_size(n1: float, n2: float, n3: float) -> float:
    """The size of the terms of the vertex form, from the derivatives' lengths."""
    return (n1 * n1 * n1)*n3 + 3.0*(n1 * n1)*(n2 * n2)


@kernel
def space_vertex_size(n1: float, n2: float, n3: float) -> float:
    """The size of the terms of the space_vertex form, from the derivatives' lengths."""
    return (n1 * n1 * n1 * n1)*n2*n3 + 3.0*(n1 * n1 * n1)*(n2 * n2 * n2)
