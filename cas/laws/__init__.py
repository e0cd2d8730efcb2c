"""How many pieces theory predicts."""
