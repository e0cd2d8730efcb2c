"""Claims of chapter 3."""
