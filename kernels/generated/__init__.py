"""Kernels printed by `codegen.generate` from the derivations in ``cas``; never edited by hand."""
