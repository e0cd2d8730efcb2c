"""What splines are made of, in the coordinates of the user."""
