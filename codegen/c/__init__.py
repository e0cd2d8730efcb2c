"""Kernels → C: their own Python, read as data, becomes functions of C99 that need libm alone.

The kernels are a small language: numbers, tuples, arrays of doubles, loops and calls of one another.  A
function is translated for the types of its arguments, as numba compiles it, so generic kernels become one
function for each fit; the operations in the C are those of the Python, in their order, and so are its
results, bit for bit, if the compiler contracts nothing and libm is the same.

`types` has the types and `scope` what one function knows; `values` is where expressions attach, `arithmetic`,
`logic`, `subscripts` and `calls` translate them, `statements` what is made of them, and `program` puts all of
it together.  `jets` prints the derivatives of formulas.
"""
