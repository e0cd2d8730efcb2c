"""Errors enclosed in ball arithmetic."""
