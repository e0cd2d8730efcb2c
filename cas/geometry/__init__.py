"""Reference geometry to any number of digits: conics, biarcs and helices through given data."""
