"""Claims of the appendices."""
