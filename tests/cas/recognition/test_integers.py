"""The Smith normal form, equations modulo 2, and the elimination that records its combinations."""

from __future__ import annotations

import random
from itertools import combinations, pairwise, product
from math import gcd

from flint import fmpq, fmpq_mat, fmpz_mat

from osculant.cas.recognition.elimination import echelon, swept
from osculant.cas.recognition.quadratic import diagonalised
from osculant.cas.recognition.smith import smith, solutions_mod_2


def times(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def test_smith_forms():
    draw = random.Random(5)
    for _ in range(60):
        m, n = draw.randint(1, 5), draw.randint(1, 5)
        a = [[draw.randint(-4, 4) for _ in range(n)] for _ in range(m)]
        u, diagonal, v = smith(a)
        expected = [[diagonal[i] if i == j < len(diagonal) else 0 for j in range(n)] for i in range(m)]
        assert times(times(u, a), v) == expected
        assert abs(fmpz_mat(u).det()) == abs(fmpz_mat(v).det()) == 1
        assert all(d > 0 for d in diagonal)
        assert all(e % d == 0 for d, e in pairwise(diagonal))
        assert len(diagonal) == fmpz_mat(a).rank()
        if diagonal:  # the first one is the common divisor of all entries
            assert diagonal[0] == gcd(*(e for row in a for e in row))


def test_equations_modulo_2():
    draw = random.Random(7)
    for _ in range(80):
        m, n = draw.randint(1, 5), draw.randint(1, 5)
        rows = [[draw.randint(-3, 3) for _ in range(n)] for _ in range(m)]
        right = [draw.randint(0, 1) for _ in range(m)]
        wanted = {
            x
            for x in product((0, 1), repeat=n)
            if all((sum(a * b for a, b in zip(row, x)) - r) % 2 == 0 for row, r in zip(rows, right))
        }
        found = solutions_mod_2(rows, right, n)
        if found is None:
            assert not wanted
            continue
        first, *kernel = found
        spanned = set()
        for count in range(len(kernel) + 1):
            for chosen in combinations(kernel, count):
                spanned.add(tuple(sum(column) % 2 for column in zip(first, *chosen)))
        assert spanned == wanted


def test_elimination_records_its_combinations():
    draw = random.Random(3)
    for _ in range(30):
        size = draw.randint(2, 8)
        rows = {
            name: {
                j: fmpq(draw.randint(-3, 3), draw.randint(1, 3)) for j in range(size) if draw.random() < 0.5
            }
            for name in range(draw.randint(1, 8))
        }
        rows = {name: {j: v for j, v in row.items() if v != 0} for name, row in rows.items()}
        found = echelon([(name, dict(row)) for name, row in rows.items() if row])
        for lead, (row, made) in found.items():
            assert min(row) == lead and row[lead] == 1
            total = {}
            for name, factor in made.items():
                for j, v in rows[name].items():
                    total[j] = total.get(j, fmpq(0)) + factor * v
            assert {j: v for j, v in total.items() if v != 0} == row
        for row in rows.values():
            assert swept(dict(row), found, {}) is None


def test_quadratic_forms():
    draw = random.Random(11)
    for _ in range(60):
        n = draw.randint(1, 4)
        a = [[fmpq(0)] * n for _ in range(n)]
        for i in range(n):
            for j in range(i, n):
                a[i][j] = a[j][i] = fmpq(draw.choice([0, 0, 1, -1, 2]))
        change, values = diagonalised(a)
        image = times(times([list(column) for column in zip(*change)], a), change)
        assert image == [[values[i] if i == j else 0 for j in range(n)] for i in range(n)]
        assert fmpq_mat(n, n, [v for row in change for v in row]).det() != 0
