"""Curves as libraries of C: what the kernels do, needing libm alone at run time.

How a library comes about: a `Subject` (`subject`) says what is wanted; `numbers` finds what is known of its
curve beforehand, its size and its stretches between special points; `osculant.codegen.c` translates the
kernels and prints the curve's jets; `library` puts both together behind the functions that `interface`
describes; `header`, `examples` and `modules` write what stands beside it, and `building` has it all compiled
and put into a folder.
"""
