"""Arithmetic: Taylor programs, balls, power series, divided differences, quadrature."""
