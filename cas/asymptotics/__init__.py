"""Errors of short arcs, numbers of pieces and their next terms, derived from the contact conditions."""
