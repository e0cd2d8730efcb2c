"""Claims of chapter 5."""
