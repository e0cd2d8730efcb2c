"""Equivalences of the lists' germs in random coordinates, as certificates: the record, and others."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path

import pytest

from tests.random_equivalences import TAMPERED, cases, kept, summary, tried, written
from tests.random_germs import Change, recorded

RECORD = Path(__file__).parents[2] / "data" / "random-equivalences.txt"
#: changes that the record has not
SAMPLE = [2 * len(cases()) + place for place, case in enumerate(cases()) if case.terms <= 60][::12]
MANY = [2 * len(cases()) + place for place, case in enumerate(cases()) if case.terms <= 400][::3]


def test_three_hundred_and_more_stand_in_the_record_as_accepted():
    rows = recorded(RECORD)
    seeds = [int(row[0]) for row in rows]
    verdicts = Counter(row[1] for row in rows)
    assert seeds == sorted(set(seeds)) and set(verdicts) <= {"ACCEPTED", "UNDECIDED"}
    assert verdicts["ACCEPTED"] >= 300
    undecided = {row[3].split(":")[0] for row in rows if row[1] == "UNDECIDED"}
    assert undecided <= {"marar tari", "houston kirk", "table 6.1"}
    assert {case.form.group.name for seed in seeds for case in [cases()[seed % len(cases())]]} == {
        "R",
        "R(H)",
        "K",
        "A",
        "A(H)",
    }
    for seed, row in zip(seeds, rows):
        case = cases()[seed % len(cases())]
        assert row[3].split(": ")[:2] == case.name(Change(seed, 1).signs(case.germ)).split(": ")
    assert summary(RECORD).startswith(f"{len(rows)} equivalences: {verdicts['ACCEPTED']} ACCEPTED")


@pytest.mark.parametrize("seed", SAMPLE)
def test_a_sample(seed):
    line = tried(seed)
    assert line.split()[1] == "ACCEPTED", line


@pytest.mark.slow
@pytest.mark.parametrize("seed", MANY)
def test_many(seed):
    line = tried(seed)
    assert line.split()[1] in ("ACCEPTED", "UNDECIDED"), line


def test_every_way_to_tamper_is_used():
    seen = set()
    for seed in SAMPLE[::4] + [
        place for place, case in enumerate(cases()) if case.form.entry.id in ("Z_13", "3d")
    ]:
        assert kept(seed) is None
        for name, tamper in TAMPERED.items():
            data = json.loads(written(seed))
            if tamper(data):
                seen.add(name)
    assert seen == set(TAMPERED)
