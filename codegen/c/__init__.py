"""Kernels → C: their own Python, read as data, becomes functions of C99 that need libm alone.

The kernels are a small language: numbers, tuples, arrays of doubles, loops and calls of one another.  A
function is translated for the types of its arguments, as numba compiles it, so generic kernels become one
function for each fit; the operations in the C are those of the Python, in their order, and so are its
results, bit for bit, if the compiler contracts nothing and libm is the same.

`types` has the types, `scope` what one function knows, `expressions` and `statements` turn its syntax tree
into C, `calls` knows the functions of Python that kernels use, `program` puts all of them together, and
`jets` prints the derivatives of formulas.
"""
