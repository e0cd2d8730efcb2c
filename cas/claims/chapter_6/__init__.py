"""Claims of chapter 6."""
