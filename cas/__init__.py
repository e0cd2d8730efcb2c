"""Exact mathematics: symbols, rationals and balls."""
