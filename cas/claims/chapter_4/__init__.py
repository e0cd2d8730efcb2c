"""Claims of chapter 4."""
