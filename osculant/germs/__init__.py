"""Map-germs at the front door."""
