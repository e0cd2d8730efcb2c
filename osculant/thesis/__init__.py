"""The thesis checked: its claims, its errata, its tables."""
