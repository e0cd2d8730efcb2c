"""Certificates: errors enclosed in ball arithmetic, and the independent checker of certificate files."""
