"""Map-germs: jets, groups of equivalences, tangent spaces and what follows from them, exactly."""
