"""Zeros isolated in ball arithmetic: the points where curves are split."""
