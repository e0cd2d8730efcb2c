"""Every claim: its form passes the check; the printed form of an erratum and every wrong form fail."""

from __future__ import annotations

import pickle
import re
from fractions import Fraction

import mpmath as mp
import pytest
import sympy as sp
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from osculant.cas.claims import Claim, Evidence, Method, Verdict, all_claims, judge, means, select
from osculant.cas.claims.claim import claim as register
from osculant.cas.claims.claim import registered
from osculant.cas.claims.proof import (
    agrees,
    encloses,
    integers,
    order,
    positive,
    read,
    read_tuple,
    rounding,
    split,
    vanishes,
)
from osculant.cas.errors import DomainError, FormulaError, OsculantError, UndecidedError

CLAIMS = all_claims()
KINDS = "lemma|theorem|corollary|proposition|remark|conjecture|definition|algorithm|table|section"
NUMBER = r"[1-9A-Z](\.\d+)+"
NAME = re.compile(rf"({KINDS}) {NUMBER}(-\w+)?(\.\d+)*|\({NUMBER}\)(\.\d+)?|[RX]{NUMBER}-\d+(\.\d+)*")


def every(claims: tuple[Claim, ...] = CLAIMS) -> list[object]:
    return [
        pytest.param(claim, id=claim.name, marks=[pytest.mark.slow] if claim.slow else []) for claim in claims
    ]


def rejected(evidence: object) -> bool:
    assert isinstance(evidence, Evidence) and evidence.holds in {True, False}
    assert all(isinstance(line, str) and line.strip() for line in evidence.certificate)
    return not evidence and len(evidence.certificate) > 0


@pytest.mark.parametrize("claim", every())
def test_the_form_claimed_holds(claim):
    evidence = claim.check(claim.form)
    assert not rejected(evidence), evidence.certificate
    assert evidence.certificate


@pytest.mark.parametrize("claim", every(tuple(c for c in CLAIMS if c.printed is not None)))
def test_the_printed_form_of_an_erratum_fails(claim):
    assert rejected(claim.check(claim.printed)), claim.printed


@pytest.mark.slow
@pytest.mark.parametrize("claim", every())
def test_every_wrong_form_is_rejected(claim):
    for form in claim.wrong:
        assert rejected(claim.check(form)), form


@pytest.mark.slow
@pytest.mark.parametrize("claim", every())
@pytest.mark.parametrize("form", ["?", "0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0"])
def test_what_is_no_form_is_refused_in_a_sentence(claim, form):
    try:
        assert rejected(claim.check(form))
    except OsculantError as refused:
        assert str(refused).rstrip()[-1] in ".?^"  # a FormulaError ends with a mark under the place


def test_what_a_proof_takes_for_granted_is_a_claim_and_shown():
    known = {claim.name: claim for claim in CLAIMS}
    leaning = {claim.name: claim for claim in CLAIMS if claim.given}
    assert {"proposition 3.3.4", "proposition 3.4.2", "X3.4-4", "X3.4-5", "conjecture 3.1.2"} <= set(leaning)
    for claim in leaning.values():
        assert set(claim.given) <= set(known) and claim.name not in claim.given
        assert claim.to_json()["given"] == list(claim.given)
    assert known["R3.2-2"].method is Method.PROOF and not known["R3.2-2"].given
    assert not known["conjecture 3.1.2"].open


def test_no_claim_takes_itself_for_granted():
    known = {claim.name: claim for claim in CLAIMS}

    def below(name, path=()):
        assert name not in path, path
        return {name}.union(*(below(given, (*path, name)) for given in known[name].given))

    assert "R3.2-2" in below("X3.4-5") and "X3.2-2" in below("X5.3-7")
    proofs = [claim for claim in CLAIMS if claim.method is Method.PROOF]
    assert all(known[name].method is Method.PROOF for claim in proofs for name in below(claim.name))


def test_errata_of_our_own_are_told_apart():
    own = [claim for claim in CLAIMS if claim.own]
    assert "R3.2-2" in {claim.name for claim in own}
    for claim in own:
        assert claim.printed is not None and not claim.uncertain and "earlier version" in claim.erratum
        assert claim.to_json()["own"] is True and claim.name.startswith(("R", "X"))


def test_readings_of_a_damaged_text_are_marked():
    uncertain = [claim for claim in CLAIMS if claim.uncertain]
    assert {"(4.10)", "algorithm 4.1.2", "lemma 2.3.4", "lemma 4.2.1", "section 3.7.2-6"} <= {
        claim.name for claim in uncertain
    }
    for claim in uncertain:
        assert claim.printed is not None and "seem" in claim.erratum and claim.to_json()["uncertain"] is True


@pytest.mark.parametrize(
    "name, right, wrong",
    [
        ("(4.10)", "-sqrt(2)/(1 - t0)*abs(q)/g", "-sqrt(2)/(1 - t0)*q/g"),
        ("(2.3)", "b12/cbrt(b12)^2", "b12"),
        ("section 3.2-1", "2*y - x**2 - k*y**2", "x**2 + k*y**2 - 2*y + 1"),
        ("section 4.2-2", "-2*V0", "V0 - V0"),
        ("corollary 4.2.3", "2*start - 2*end", "0"),
        ("R3.3-1", "4*Q*l0*l2 - l1**2", "l1**2 - 2*Q*l0*l2"),
    ],
)
def test_other_ways_to_write_a_form_hold_too(name, right, wrong):
    (claim,) = (c for c in CLAIMS if c.name == name)
    assert claim.check(right) and rejected(claim.check(wrong))


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.name)
def test_a_claim_says_what_it_is(claim):
    assert NAME.fullmatch(claim.name), "a name of no known kind"
    assert claim.statement.rstrip()[-1] in ".:)" and len(claim.statement) > 10 and len(claim.derivation) > 15
    assert claim.form.strip() and len(set(claim.wrong)) == len(claim.wrong) > 0
    assert claim.form not in claim.wrong and claim.form != claim.printed
    assert (claim.method is Method.NUMERICAL) <= bool(claim.reason)
    assert (claim.printed is not None) <= bool(claim.erratum)
    assert claim.chapter in set("123456ABC")
    assert select([claim.name])[0].name == claim.name
    assert select([claim.name.upper()])[0].name == claim.name
    assert "\n" not in claim.statement + claim.reason + claim.erratum


def test_there_are_enough_claims():
    assert len(CLAIMS) >= 60
    assert {"2", "3", "4", "A"} <= {claim.chapter for claim in CLAIMS}
    assert sum(claim.printed is not None for claim in CLAIMS) >= 5
    assert sum(claim.method in {Method.PROOF, Method.EXACT} for claim in CLAIMS) >= 40


def test_the_order_is_that_of_the_thesis():
    names = [claim.name for claim in CLAIMS]
    assert len(set(names)) == len(names) == len(registered())
    chapters = [claim.chapter for claim in CLAIMS]
    assert chapters == sorted(chapters)  # digits come before letters


def test_names_are_ordered_naturally():
    from osculant.cas.claims import _place

    ordered = [
        *("section 1.5-1", "section 1.5-10", "lemma 2.2.1", "lemma 2.2.1.2", "lemma 2.2.1.10", "lemma 2.2.2"),
        *("R2.2-1", "X2.2-1", "remark 2.3.1", "lemma 2.10.1", "(2.2)", "(2.12)", "remark 3.3.5", "R3.3-2"),
        *("R3.3-10", "X3.3-1", "lemma 3.4.1", "algorithm 4.1", "table 6.2-4", "table 6.2-4e", "table 6.2-10"),
        *("lemma A.2.1", "(A.3)", "lemma B.1.1", "nonsense"),
    ]
    assert sorted(sorted(ordered), key=_place) == ordered


@given(st.text(max_size=12), st.text(max_size=12))
def test_any_names_can_be_ordered(one, other):
    from osculant.cas.claims import _place

    assert (_place(one) < _place(other)) or (_place(other) <= _place(one))


def made(name: str, **changes: object) -> Claim:
    return Claim(
        **{"statement": "", "method": Method.EXACT, "check": five, "form": "5", "name": name} | changes
    )


def five(form: str) -> Evidence:
    """Two and three are counted together."""
    return Evidence(int(form) == 2 + 3, (f"2 + 3 against {form}",))


@pytest.mark.parametrize(
    "name, wanted, itself, below",
    [
        ("lemma 3.5.1", "3.5.1", True, True),
        ("lemma 3.5.1", " Lemma  3.5.1", True, True),
        ("lemma 3.5.1", "theorem 3.5.1", False, False),
        ("lemma 3.5.1", "3.5", False, True),
        ("lemma 3.5.1", "3", False, True),
        ("lemma 3.5.1", "3.", False, False),
        ("lemma 3.5.10", "3.5.1", False, False),
        ("lemma 3.5.1.2", "lemma 3.5.1", False, True),
        ("(3.13)", "3.13", True, True),
        ("(3.13)", "(3.13)", True, True),
        ("(3.13)", "3.1", False, False),
        ("lemma 3.13", "(3.13)", False, False),
        ("R4.5-1", "4.5-1", True, True),
        ("R4.5-1", "r4.5", False, True),
        ("R4.5-1", "4.5", False, True),
        ("table 6.2-4e", "table 6.2", False, True),
        ("lemma A.2.1", "a", False, True),
        ("lemma A.2.1", "", False, False),
    ],
)
def test_names_may_be_shortened(name, wanted, itself, below):
    claim = made(name)
    assert means(wanted, claim) == itself
    assert means(wanted, claim, below=True) == below


def test_chapters():
    names = {
        "(2.13)": "2",
        "R4.5-1": "4",
        "X3.8-2": "3",
        "lemma A.2.1": "A",
        "algorithm 4.1": "4",
        "table 6.2-4e": "6",
    }
    assert {name: made(name).chapter for name in names} == names


def test_what_selects_nothing_is_refused():
    with pytest.raises(DomainError, match=r"did you mean"):
        select([CLAIMS[0].name + "7"])
    with pytest.raises(DomainError, match="all_claims"):
        select(["riemann hypothesis"])
    with pytest.raises(DomainError, match=r"chapter '9': choose one of .*2.*3.*A"):
        select([], chapter="9")
    with pytest.raises(DomainError, match=r"in chapter A is called 'lemma 2"):
        select(["lemma 2.2.1"], chapter="A")
    assert select([]) == select(["all"]) == select(["ALL"]) == list(CLAIMS)
    assert {claim.chapter for claim in select([], chapter="a")} == {"A"}


@pytest.mark.parametrize(
    "changes, verdict",
    [
        ({}, Verdict.HOLDS),
        ({"printed": "6"}, Verdict.CORRECTED),
        ({"open": True}, Verdict.OPEN),
        ({"form": "6"}, Verdict.FAILS),
        ({"form": "6", "open": True}, Verdict.FAILS),
        ({"printed": "5"}, Verdict.FAILS),
        ({"form": "five"}, Verdict.FAILS),
        ({"printed": "six"}, Verdict.FAILS),
    ],
)
def test_verdicts(changes, verdict):
    judgement = judge(made("(0.1)", **changes))
    assert judgement.verdict is verdict
    if "form" in changes and not changes["form"].isdigit():
        (line,) = judgement.evidence.certificate
        assert "ValueError" in line and "five" in line
    data = judgement.to_json()
    assert {"id", "statement", "verdict", "method", "printed", "corrected", "seconds"} <= set(data)
    assert (data["corrected"] is None) == (data["printed"] is None)


def test_who_gives_up_leaves_a_claim_open():
    def gives_up(form: str) -> Evidence:
        raise UndecidedError("The cap of 7 terms was reached.")

    judgement = judge(made("(0.1)", check=gives_up))
    assert judgement.verdict is Verdict.OPEN and "7 terms" in judgement.evidence.certificate[0]


def test_a_claim_that_cannot_fail_is_refused():
    good = {"method": Method.EXACT, "form": "5", "wrong": ("6",)}
    for bad in ({"wrong": ()}, {"method": Method.NUMERICAL}, {"printed": "6"}):
        with pytest.raises(DomainError, match=r"'lemma 0\.0\.1' lacks"):
            register("lemma 0.0.1", "2 + 3 = 5", **good | bad)
    with pytest.raises(DomainError, match="uncertain"):
        register("lemma 0.0.1", "2 + 3 = 5", **good, uncertain=True)
    with pytest.raises(DomainError, match="earlier form"):
        register("lemma 0.0.1", "2 + 3 = 5", **good, own=True)
    with pytest.raises(DomainError, match=r"registered twice, in .* and .*"):
        register(CLAIMS[0].name, "2 + 3 = 5", **good)(five)
    assert "lemma 0.0.1" not in registered()


def test_judgements_travel():
    judgement = judge(CLAIMS[0])
    again = pickle.loads(pickle.dumps(judgement))
    assert again == judgement and again.claim is registered()[CLAIMS[0].name]


x, y = sp.symbols("x y")
n = sp.Symbol("n", integer=True)
p = sp.Symbol("p", positive=True)
t = sp.Symbol("t")
f, g = (sp.Function(name)(t) for name in "fg")


@pytest.mark.parametrize(
    "identity",
    [
        (x + y) ** 3 - x**3 - 3 * x**2 * y - 3 * x * y**2 - y**3,
        sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1,
        sp.sqrt(p**2) - p,
        sp.cos(sp.pi * n) - (-1) ** n,
        1 / (x - 1) - 1 / (x + 1) - 2 / (x**2 - 1),
        p ** sp.Rational(1, 3) * p ** sp.Rational(2, 3) - p,
        sp.diff(f * g, t) - f * g.diff(t) - g * f.diff(t),
        sp.Derivative(f**2, t) - 2 * f * f.diff(t),
        sp.sqrt(2) * sp.sqrt(3) - sp.sqrt(6),
    ],
    ids=str,
)
def test_identities_are_proved_and_near_misses_refuted(identity):
    assert vanishes(identity, "identity")
    for wrong in (
        identity + sp.Rational(1, 10**30),
        identity + x / 1000,
        2 * identity - identity.subs(x, 2) + y,
    ):
        evidence = vanishes(wrong, "wrong")
        assert not evidence and "differ by" in evidence.certificate[0]


def test_only_for_positive_symbols():
    evidence = vanishes(sp.sqrt(x**2) - x, "root")
    assert not evidence and "x = -" in evidence.certificate[0]


def test_what_cannot_be_proved_is_undecided():
    from sympy.core.function import Function

    class hidden(Function):  # sympy evaluates it, and knows no rule for it
        nargs = 1

        def _eval_evalf(self, precision):
            return (self.args[0] ** 2)._eval_evalf(precision)

    with pytest.raises(UndecidedError, match=r"square: .*no proof"):
        vanishes(hidden(x) - x**2, "square")
    with pytest.raises(UndecidedError):
        vanishes(sp.nan, "nothing")


def test_relations_are_divided_out():
    circle = (x**2 + y**2 - 1, x)
    assert vanishes(x**4 - (1 - y**2) ** 2, "circle", [circle])
    assert not vanishes(x**4 - (1 - y**2), "circle", [circle])
    assert not vanishes(x**2 + y**2 - 1, "without")


def test_forms_are_read_and_nothing_else():
    assert read("a^2 + cbrt(b)", {"a": sp.sqrt(x), "b": sp.Integer(8)}) == x + 2
    assert read("a*b", {"a": y, "b": x}) == x * y
    assert read_tuple("a, 2*b", {"a": y, "b": x}) == (y, 2 * x)
    for bad in ("a +", "c", "__import__('os')", ""):
        with pytest.raises(FormulaError):
            read(bad, {"a": x})


def test_the_parts_of_a_form_are_counted():
    assert integers("4, 2 + 3", 2) == (4, 5) and split("a, -b", 2) == ["a", "-b"]
    assert rounding("-0.50", 1) == (Fraction(-1, 2), Fraction(1, 200))
    for read_parts in (lambda text: read_tuple(text, {}, 2), lambda text: integers(text, 2)):
        for text in ("1", "1, 2, 3"):
            with pytest.raises(DomainError, match=r"part.*: give 2\.$"):
                read_parts(text)
    with pytest.raises(DomainError, match="give 3"):
        split("1, 2", 3)
    for text in ("1/2", "pi", "2, 1.5"):
        with pytest.raises(DomainError, match="integer"):
            integers(text)
    for text in ("0.5", "pi/2", ""):
        with pytest.raises(DomainError, match="expected"):
            rounding(text, 3)
    with pytest.raises(DomainError, match="1 at least"):
        order(sp.Integer(0))


def test_signs_are_decided_at_a_point():
    assert positive(p**2 + p, "both") and positive(sp.sqrt(2) * p, "root")
    for wrong in (-p, sp.S.Zero, sp.nan, sp.zoo, sp.I * p):
        assert not positive(wrong, "wrong")


def test_what_is_infinite_or_no_polynomial_is_no_identity():
    assert not vanishes(1 / (x - x), "pole")
    with pytest.raises(DomainError, match="no polynomial in x"):
        vanishes(sp.sin(x) + y, "sine", [(x**2 - y, x)])


def test_numbers_agree_to_the_digits_wanted_and_no_more():
    assert agrees(1.001, 1, 2.9, "one") and not agrees(1.001, 1, 3.1, "one")
    with mp.workdps(60):
        third, off = mp.mpf(1) / 3, mp.mpf(1) / 3 + mp.mpf(10) ** -40
    assert agrees(off, third, 39, "third") and not agrees(off, third, 41, "third")
    for wrong in (-1, mp.nan, mp.inf):
        assert not agrees(wrong, 1, 1, "wrong")
    assert not agrees(1, 0, 1, "nothing") and not agrees(0, 0, 1, "nothing")


def test_balls_must_be_narrow_and_right():
    assert encloses(arb(2).sqrt() ** 2, arb(2), "two")
    assert not encloses(arb("2 +/- 0.1"), arb(2), "wide")
    assert not encloses(arb(2), arb(2) + arb(2) ** -40, "beside")
    assert not encloses(arb("nan"), arb(2), "nan")


def test_evidence_adds_up():
    good, bad = Evidence(True, ("a",)), Evidence(False, ("b",))
    assert (good & good).holds and not (good & bad).holds and not (bad & good).holds
    assert (good & bad).certificate == ("a", "b")
