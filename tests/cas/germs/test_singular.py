"""Codimensions and local algebras agree with what Singular answered (see tests/data/make_singular.py)."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.local_algebra import milnor_number, q_algebra, ramification
from tests.cas.germs.oracles import tjurina_number

ANSWERS = json.loads(
    (Path(__file__).parents[2] / "data" / "singular-codimensions.json").read_text(encoding="utf-8")
)


def ours(germ: Germ, question: str) -> Any:
    if question == "algebra":
        return list(q_algebra(germ).hilbert)
    algebras = {
        "milnor": milnor_number,
        "tjurina": tjurina_number,
        "ramification": lambda f: ramification(f).dimension,
    }
    if question not in algebras:
        return codimension(germ, question.removesuffix("_e"), extended=question.endswith("_e")).value
    try:
        return algebras[question](germ)
    except (DomainError, UndecidedError):  # how these say that a dimension is, or may be, infinite
        return "infinite"


def test_the_answers_are_many_and_of_every_kind():
    asked = {question for record in ANSWERS for question in record["answers"]}
    assert {"R", "K", "A", "R(H)", "K(H)", "A(H)", "A_e", "A(H)_e", "algebra", "ramification"} <= asked
    assert len(ANSWERS) >= 100
    assert sum("A_e" in r["answers"] or "A(H)_e" in r["answers"] for r in ANSWERS) >= 60


@pytest.mark.parametrize("record", ANSWERS, ids=[f"{r['source']}: {r['germ'][:60]}" for r in ANSWERS])
def test_agrees_with_singular(record):
    germ = Germ(record["germ"].replace("^", "**"), record["source"])
    assert {q: ours(germ, q) for q in record["answers"]} == record["answers"]
