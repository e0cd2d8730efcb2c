"""From a curve to its spline: where it is divided, how stretches are fitted, how many pieces each gets."""
