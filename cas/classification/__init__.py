"""Classification of germs from nothing: the orbits up to a codimension, with a proof that none is missing."""
