"""Certificates convince an independent checker, and it rejects certificates that were tampered with."""

from __future__ import annotations

from copy import deepcopy
from functools import cache

import pytest

from osculant.cas.germs.annihilator import LARGEST_PRIME
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.elimination_mod_p import modular_annihilator
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Version, group
from osculant.cas.germs.tangent import rows, vectors
from osculant.cas.germs.tangent_space import tangent
from tests.cas.germs.checker import Problem, RejectedError, check_codimension, check_determinacy

#: the primes below 2³¹, as many as the tests use
PRIMES = (2147483647, 2147483629, 2147483587)
PRIME = PRIMES[0]
assert PRIME == LARGEST_PRIME

#: modulo the first prime the engine tries, these look like other germs
AGAINST_PRIMES = [
    (f"y, x*y+x**3, {PRIME}*x**2*y+x**4", "x y", "A"),
    (f"y, x*y+{PRIME}*x**3+x**4", "x y", "A"),
    (f"{PRIME}*x**2+x**3+y**2", "x y", "R"),
    (f"x, {PRIME}*y**2+y**3", "x y", "K"),
    (f"x, y**2, y**3+x**3*y+{PRIME * PRIMES[1]}*x**2*y", "x y", "A"),
    (f"x, u**2+{PRIME}*x*u+x**2*u", "x u", "A(H)"),
]

FINITE = [
    ("x, x*y+y**3", "x y", "A"),
    ("x, x*y+y**6", "x y", "A"),
    ("x, x*y+y**5+y**7", "x y", "A"),
    ("x**2+y**3, y**2+x**3", "x y", "A"),
    ("x, y**2, y**3+x**3*y", "x y", "A"),
    ("x, x*y, y**2, y**3", "x y", "A"),
    ("x**3, x**7+x**8", "x", "A"),
    ("x, x*y+y**2-x*y**2/3, (x+2*y)**3-y**2", "x y", "A"),
    ("x+y**2, (y-x)**3+x*y-x**2", "x y", "A"),
    ("x**2+x**3, x**5-7*x**4, 0", "x", "A"),
    ("x*y+sin(x)**3, x-exp(y)+1", "x y", "A"),
    ("x**3+y**4", "x y", "R"),
    ("x**4+y**5+x**2*y**3", "x y", "K"),
    ("x**2*y+y**4-x*y**3/5", "x y", "R"),
    ("x**2+y**2+z**2, x*y*z", "x y z", "K"),
    ("x**2, y**2", "x y", "C"),
    ("x, y", "x y", "L"),
    ("x**2+u**3", "x u", "R(H)"),
    ("x*u+x**4", "x u", "K(H)"),
    ("x, u**2+x*u", "x u", "A(H)"),
    ("x, y, u**3+x*u+y*u**2", "x y u", "A(H)"),
    ("x, u**2+x*u-y**3+x**2*y", "x y u", "A(H)"),
    ("x, y**2, u+x*y", "x y u", "A(H)"),
    ("x, y, z*u+x*z+y*z**2-z**3", "x y z u", "A(H)"),
]

INFINITE = [
    ("x, y**2, 0", "x y", "A"),
    ("x**2*y**2", "x y", "R"),
    ("x**2*y**2", "x y", "K"),
    ("x**2, x**3", "x", "R"),
    ("x**4, x**6", "x", "A"),
    ("x, y**4", "x y", "A"),
    ("x**2+y**2, x*y**2", "x y", "A"),
    ("(x-y**2)**2", "x y", "R"),
    ("u, x**2", "x u", "A(H)"),
    ("x**2*u", "x u", "R(H)"),
    ("u", "x u", "K(H)"),
    ("x, y*u", "x y u", "A(H)"),
]


def names(cases):
    return [f"{name} of {germ}" for germ, _, name in cases]


@cache
def proved(germ, source, name, extended):
    found = codimension(Germ(germ, source), name, extended=extended)
    return Problem(germ, source, name), found.value, found.certificate()


@pytest.mark.parametrize("case", FINITE + AGAINST_PRIMES, ids=names(FINITE + AGAINST_PRIMES))
@pytest.mark.parametrize("extended", [False, True], ids=["", "extended"])
def test_finite_codimensions(case, extended):
    problem, value, certificate = proved(*case, extended)
    assert certificate["kind"] == "annihilator"
    check_codimension(problem, extended, value, certificate)


@pytest.mark.parametrize("case", INFINITE, ids=names(INFINITE))
def test_infinite_codimensions(case):
    problem, value, certificate = proved(*case, False)
    assert value == "infinite"
    check_codimension(problem, False, value, certificate)


DETERMINED = [
    case for case in FINITE if case[2] not in {"L", "C"} and case[0].count(",") < 3
] + AGAINST_PRIMES


@pytest.mark.parametrize("case", DETERMINED + INFINITE, ids=names(DETERMINED + INFINITE))
def test_determinacy(case):
    germ, source, name = case
    found = determinacy(Germ(germ, source), name)
    check_determinacy(Problem(*case), found.degree, found.certificate())
    if found.degree != "infinite" and found.bound + found.degree > 2 and found.sharp:
        with pytest.raises(RejectedError):
            check_determinacy(Problem(*case), found.degree - 1, found.certificate())


@pytest.mark.parametrize("case", AGAINST_PRIMES, ids=names(AGAINST_PRIMES))
def test_the_prime_in_a_coefficient_misleads_modular_ranks(case):
    germ, name = Germ(case[0], case[1]), case[2]
    found = codimension(germ, name).tangent
    assert found is not None
    spanned = rows(vectors(germ, group(name), Version.ORDINARY, found.space.order), found.space)
    ranks = {
        p: found.space.columns - len(modular_annihilator(spanned, found.space.columns, p)[0]) for p in PRIMES
    }
    assert ranks[PRIME] <= ranks[PRIMES[-1]] == found.annihilator.rank
    if ranks[PRIME] < found.annihilator.rank:
        problem, value, certificate = proved(*case, False)
        with pytest.raises(RejectedError):
            check_codimension(problem, False, value, {**certificate, "prime": PRIME})


def test_inclusions_are_not_read_off_modular_ranks():
    # modulo the prime, T seems to contain a power of M that it does not contain over the rationals
    germ = Germ(AGAINST_PRIMES[0][0], "x y")
    for order in range(3, 7):
        found = tangent(germ, group("A"), Version.ORDINARY, order)
        other = tangent(Germ("y, x*y+x**3, 3*x**2*y+x**4", "x y"), group("A"), Version.ORDINARY, order)
        assert (found.codimension, found.depth) == (other.codimension, other.depth)


TAMPERED = [
    ("x, x*y+y**6", "x y", "A"),
    ("x**4+y**5+x**2*y**3", "x y", "K"),
    ("x, u**2+x*u-y**3+x**2*y", "x y u", "A(H)"),
]


def functional_changed(c):
    functional = max(c["functionals"], key=len)
    functional[min(functional)] += "1"  # a column that is no multiple of another functional


def functional_repeated(c):
    c["functionals"][1] = dict(c["functionals"][0])


def functional_missing(c):
    c["functionals"].pop()


def rank_off_by_one(c):
    c["rank"] += 1


def rank_and_functionals_off_by_one(c):
    c["functionals"].pop()
    c["rank"] += 1


def depth_lowered(c):
    c["depth"] -= 1


def order_lowered(c):
    c["order"] -= 1


def no_prime(c):
    c["prime"] = PRIME - 2


def small_prime(c):
    c["prime"] = 2


def columns_added(c):
    c["columns"] += 1


@pytest.mark.parametrize("case", TAMPERED, ids=names(TAMPERED))
@pytest.mark.parametrize(
    "tamper",
    [
        functional_changed,
        functional_repeated,
        functional_missing,
        rank_off_by_one,
        rank_and_functionals_off_by_one,
        depth_lowered,
        order_lowered,
        no_prime,
        small_prime,
        columns_added,
    ],
)
def test_tampered_codimensions_are_rejected(case, tamper):
    problem, value, certificate = proved(*case, True)
    tampered = deepcopy(certificate)
    tamper(tampered)
    with pytest.raises(RejectedError):
        check_codimension(problem, True, value, tampered)


def test_wrong_values_and_bounds_are_rejected():
    for case in TAMPERED:
        problem, value, certificate = proved(*case, True)
        with pytest.raises(RejectedError):
            check_codimension(problem, True, value - 1, certificate)
        with pytest.raises(RejectedError):
            check_codimension(problem, True, "infinite", proved("x, y**2, 0", "x y", "A", False)[2])
    problem, value, certificate = proved(*TAMPERED[0], True)
    assert certificate["bound"] == 5
    with pytest.raises(RejectedError):  # M^4θ is not in T K_e f
        check_codimension(problem, True, value, {**certificate, "bound": 4})


def test_a_certificate_of_another_germ_or_group_is_rejected():
    _, value, certificate = proved("x, x*y+y**6", "x y", "A", True)
    for germ, name in [("x, x*y+y**6+y**9", "A"), ("x, x*y+y**7", "A"), ("x, x*y+y**6", "K")]:
        with pytest.raises(RejectedError):
            check_codimension(Problem(germ, "x y", name), True, value, certificate)


@pytest.mark.parametrize("case", [("x**3+y**4", "x y", "R"), ("x, y**2, x*y", "x y", "A")])
def test_a_locus_of_another_germ_is_rejected(case):
    for other in (("x**2*y**2", "x y", "R"), ("x, y**2, 0", "x y", "A")):
        _, _, certificate = proved(*other, False)
        with pytest.raises(RejectedError):
            check_codimension(Problem(*case), False, "infinite", certificate)


def test_wrong_determinacy_is_rejected():
    problem = Problem("x, y**2, y**3+x**3*y", "x y", "A")
    found = determinacy(Germ("x, y**2, y**3+x**3*y", "x y"), "A")
    good = found.certificate()
    check_determinacy(problem, found.degree, good)
    for wrong in ({"order": good["order"] - 1}, {"bound": 0}, {"bound": 1}):
        with pytest.raises(RejectedError):
            check_determinacy(problem, found.degree, {**good, **wrong})
    for fields in (["x∂/∂y", "y∂/∂x"], ["y1∂/∂y2", "y2∂/∂y3", "y3∂/∂y1"]):
        with pytest.raises(RejectedError):
            check_determinacy(problem, found.degree, {**good, "fields": fields})
    with pytest.raises(RejectedError):
        check_determinacy(Problem("x*u+x**4", "x u", "R(H)"), 4, {**good, "fields": ["x∂/∂u"]})
