"""What compiled approximators do by themselves and the front door does for Python.

These kernels are there to be translated to C (`osculant.codegen.c`); nothing in Python calls them.
"""
