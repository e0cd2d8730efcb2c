"""Claims of chapter 1."""
