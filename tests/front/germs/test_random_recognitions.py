"""The record of random recognitions, a sample of its questions asked again, and many in the slow tests."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from tests.random_recognitions import BEYOND, FAULTS, NAMED, ROUNDED, line, recorded, summary

RECORD = Path(__file__).parents[2] / "data" / "random-recognitions.txt"
EVERY = NAMED + BEYOND + ROUNDED


def test_the_record_has_no_wrong_name():
    rows = recorded(RECORD)
    seeds = [int(row[0]) for row in rows]
    assert seeds == sorted(set(seeds)) and set(seeds) <= set(range(EVERY))
    counts = Counter(row[1] for row in rows)
    assert not set(counts) & set(FAULTS) and set(counts) == {"right", "refused", "undecided"}
    named = Counter(row[1] for row in rows if int(row[0]) < NAMED)
    assert named["right"] > 0.99 * named.total()
    beyond = Counter(row[1] for row in rows if NAMED <= int(row[0]) < NAMED + BEYOND)
    assert beyond["refused"] == beyond.total() == BEYOND
    seconds = sorted(float(row[2]) for row in rows if int(row[0]) < NAMED)
    assert seconds[len(seconds) // 2] < 0.3
    assert summary(RECORD).startswith(f"{len(rows)} questions: {BEYOND} refused, {counts['right']} right")


@pytest.mark.parametrize("seed", [5, 25, 803, 1610, 2411, NAMED + 3, NAMED + 9, NAMED + BEYOND + 4])
def test_a_sample(seed):
    assert line(seed).split()[1] not in FAULTS


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(7, EVERY, 17))
def test_many(seed):
    assert line(seed).split()[1] not in FAULTS
