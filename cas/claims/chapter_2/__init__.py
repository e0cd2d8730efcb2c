"""Claims of chapter 2."""
