"""The rules of Gauss and what they tell of their own errors."""

import numpy as np
import pytest

from osculant.kernels import gauss


@pytest.mark.parametrize("rule", range(len(gauss.SIZES)))
def test_rules_are_exact_and_see_the_last_coefficient(rule):
    size = gauss.SIZES[rule]
    x, w, tail = (table[rule, :size] for table in (gauss.NODES, gauss.WEIGHTS, gauss.TAILS))
    for k in range(2 * size):
        assert w @ x**k == pytest.approx(1 / (k + 1), rel=1e-13)
    for k in range(size):
        polynomial = np.polynomial.legendre.Legendre.basis(k)(2 * x - 1)
        assert tail @ polynomial == pytest.approx(float(k == size - 1), abs=1e-13)


@pytest.mark.parametrize("rule", range(1, len(gauss.SIZES)))
@pytest.mark.parametrize("frequency", [0.5, 2.0, 8.0])
def test_the_square_of_the_last_coefficient_bounds_the_error(rule, frequency):
    size = gauss.SIZES[rule]
    x, w, tail = (table[rule, :size] for table in (gauss.NODES, gauss.WEIGHTS, gauss.TAILS))
    for values, exact in (
        (np.exp(frequency * x), np.expm1(frequency) / frequency),
        (1 / (1 + frequency * x), np.log1p(frequency) / frequency),
        (np.sin(frequency * x), (1 - np.cos(frequency)) / frequency),
    ):
        error = abs(w @ values - exact)
        assert error <= (tail @ values) ** 2 / abs(exact) + 1e-13 * abs(values).max()
