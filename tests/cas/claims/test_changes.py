"""Every form changed by machine is refused, but for changes that leave the statement true."""

from __future__ import annotations

import pytest

from osculant.cas.claims import all_claims
from osculant.cas.claims.claim import Claim, Evidence, Method
from tests.cas.claims.changes import accepted, changes

CLAIMS = all_claims()
NAMES = [claim.name for claim in CLAIMS]
#: claims tried in the fast suite: each check takes a fraction of a second
SAMPLE = (
    *(
        "section 1.5-1",
        "X1.3-11",
        "lemma 2.3.2.4",
        "(2.3)",
        "(2.12)",
        "X3.1-4",
        "X3.2-4",
        "X3.2-13",
        "R3.3-9",
    ),
    *("X3.3-4", "X3.4-6", "X3.4-7", "(3.21)", "(3.22)", "R4.3-1", "R4.3-10", "R4.4-5", "(4.8)", "R5.3-1"),
    *("X5.3-1", "X5.3-6", "section B.1-6", "lemma B.2.1"),
)

#: changes known to leave a statement true, by claim
EQUIVALENT = {
    # equations, linear forms and conditions that stand for what they vanish on
    "section 3.2-1": {"sign", "twice"},
    "corollary 3.3.3": {"sign", "twice"},
    "R3.3-1": {"sign", "twice"},
    "lemma 3.4.1": {"sign", "twice"},
    "X3.4-7": {"sign", "twice"},
    "R4.4-8": {"sign", "twice"},
    # directions of lines, normals and axes
    "section 4.2-2": {"sign", "twice"},
    "lemma 4.2.1.1": {"sign", "twice"},
    "corollary 4.2.3": {"sign", "twice"},
    "section 4.3-2": {"sign", "twice"},
    "R4.4-1": {"sign", "twice"},
    "R4.4-7": {"sign"},
    "lemma B.2.1": {"sign", "twice"},
    "(4.3)": {"sign", "twice"},
    # a constant, which both ends have
    "R5.3-6": {"thousandth"},
    # numbers known to fewer digits
    "R4.6-2": {"thousandth"},
    # the sign of a discriminant
    "X1.3-4": {"twice"},
    # germs up to changes of coordinates, and generators of a vector space
    **{name: {"sign", "twice"} for name in NAMES if name.startswith(("table 6.2-", "proposition 6.4.3-"))},
    "table 1.1-D4": {"sign", "twice"},
    "section 1.4-1": {"sign", "twice", "thousandth"},
    # a thousandth more has the same floor
    "section 1.3.3-5": {"thousandth"},
    # other bases of the conics' monomials
    "(3.2)": {"integer", "sign", "twice", "thousandth"},
    # other intervals on which it is true
    "section B.1-11": {"integer", "thousandth"},
    # longer intervals, and ends within what the counts decide
    "section 3.7.1-3": {"integer", "twice", "thousandth"},
    "section 3.7.2-6": {"thousandth"},
}


def unexpected(claim: Claim) -> list[str]:
    known = EQUIVALENT.get(claim.name, set())
    return [name for name in accepted(claim) if name.split()[0] not in known]


@pytest.mark.slow
@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.name)
def test_changed_forms_are_refused(claim):
    assert unexpected(claim) == []


@pytest.mark.parametrize("name", SAMPLE)
def test_changed_forms_of_a_sample_are_refused(name):
    (claim,) = (claim for claim in CLAIMS if claim.name == name)
    assert unexpected(claim) == []


def test_the_known_changes_are_those_of_claims():
    assert set(EQUIVALENT) <= set(NAMES)


def test_what_is_changed():
    assert [form for _, form in changes("-a1^2/3, 0")] == [
        "-a1^3/3, 0",
        "-a1^2/4, 0",
        "-a1^2/3, 1",
        "-(-a1^2/3), 0",
        "0, 0",
        "2*(-a1^2/3), 0",
        "(-a1^2/3) + 1/1000, 0",
        "-a1^2/3, (0) + 1/1000",
    ]
    assert [form for _, form in changes("5, strictly convex")] == ["6, strictly convex"]
    assert list(changes("k monotone")) == [] and len(list(changes("sqrt(a), c"))) == 8


def test_a_claim_that_accepts_everything_is_found():
    weak = Claim("(0.1)", "", Method.EXACT, lambda form: Evidence(True), "x")
    strict = Claim("(0.1)", "", Method.EXACT, lambda form: Evidence(form == "x"), "x")
    assert accepted(weak) == ["sign 0", "zero 0", "twice 0", "thousandth 0"] and accepted(strict) == []
