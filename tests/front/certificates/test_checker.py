"""The independent checker: files of finite and infinite germs are accepted, tampered ones refused."""

from __future__ import annotations

import json
import random
import re
from copy import deepcopy
from functools import cache

import pytest

import osculant as osc
from osculant.certificates.check_algebra import read
from osculant.certificates.check_taylor import taylor
from osculant.certificates.check_text import RejectedError, limited
from osculant.certificates.checker import check
from osculant.germs.map_germ import germ
from osculant.germs.report import certificate_file

FINITE = [
    ("x^3 + y^4", "x y", "R", 7, 4),
    ("(x - y/2 + x^2)^3 + (y + 2*x - x*y/3)^4", "x y", "R", 7, 4),
    ("x^4 + y^5 + x^2*y^3", "x y", "K", 12, None),
    ("x, x*y + y^6", "x y", "A", 8, None),
    ("x + y^2, x*y + 2*y^3", "x y", "A", 2, 3),
    ("x, y^2, y^3 + x^3*y", "x y", "A", 4, 4),
    ("x^2 + y^3, y^2 + x^3", "x y", "A", 4, None),
    ("x^3, x^7 + x^8", "x", "A", 6, None),
    ("exp(x) - 1, x*sin(y) + tan(y)^3", "x y", "A", 2, 3),
    ("x, u^2 + x*u", "x u", "A(H)", 1, 2),
    ("x, y, z*u + x*z + y*z^2 - z^3", "x y z u", "A(H)", 3, 3),
    ("x^2 + u^3", "x u", "R(H)", 3, 3),
    ("a, b, c, z^5 + a*z + b*z^2 + c*z^3", "a b c z", "A", 4, 5),
    ("x, y", "x y", "L", 0, 1),
]
INFINITE = [
    ("x, y^2, 0", "x y", "A"),
    ("x, x*y, y^3", "x y", "A"),
    ("t^3, t^9, t^12", "t", "A"),
    ("(t+t^2)^2, (t+t^2)^4", "t", "A"),
    ("x^2 - y^2, x*y", "x y", "A"),
    ("x^2 + y^2, x*y^2", "x y", "A"),
    ("x, (y^2 - x - x^2)^2", "x y", "A"),
    ("x, x*y + y^5, x*y^2", "x y", "A"),
    ("x + y^2, x*y + y^3, (x + y^2)*y^4", "x y", "A"),
    ("x^2, y^2, z^2", "x y z", "A"),
    ("sin(x)^2", "x y", "R"),
    ("x, y^3*exp(x)", "x y", "A"),
    ("x/(1-y), y^3/(1+x)", "x y", "A"),
    ("tan(x) - x, atan(y)", "x y", "A"),
    ("sin(x) - x, y", "x y", "A"),
    ("sqrt(1 + x) - 1, y^3*cos(x)", "x y", "A"),
    ("(x^2 + y^2 + z^2)^2", "x y z", "K"),
    ("x^2 + y^2", "x y", "C"),
    ("x^3 + y^4", "x y", "L"),
    ("x^2, y^2", "x y", "L"),
    ("u, x^2", "x u", "A(H)"),
    ("x, y*u", "x y u", "A(H)"),
    ("x^2*u", "x u", "R(H)"),
    ("u", "x u", "K(H)"),
]


@cache
def written(formulas: str, source: str, group: str) -> str:
    return json.dumps(certificate_file(germ(formulas, source), group))


def made(formulas: str, source: str, group: str) -> dict:
    return json.loads(written(formulas, source, group))


@pytest.mark.parametrize("case", FINITE, ids=lambda c: f"{c[2]}: {c[0]}")
def test_files_of_finite_germs_are_accepted(case):
    formulas, source, group, codimension, degree = case
    data = made(formulas, source, group)
    assert data["codimension"] == codimension
    assert degree is None or data["determinacy"] == degree
    proved = check(data)
    assert len(proved) == 3 + bool(data["sharp"]) and data["sharp"]
    assert proved[0].endswith(f" is {codimension}.")
    assert f"{data['determinacy']}-determined for {group}." in proved[2]


@pytest.mark.parametrize("case", INFINITE, ids=lambda c: f"{c[2]}: {c[0]}")
def test_files_of_infinite_germs_are_accepted(case):
    data = made(*case)
    assert data["codimension"] == data["determinacy"] == "infinite"
    assert len(check(data)) == 3


def changes(data: dict):
    """Files that say something else than was proved, or prove it no more."""
    for key in ("codimension", "extended_codimension", "determinacy"):
        wrong = deepcopy(data)
        wrong[key] = 2 if data[key] == "infinite" else data[key] - 1
        yield key, wrong
        wrong = deepcopy(data)
        wrong[key] = "infinite" if data[key] != "infinite" else 0
        yield f"{key} turned", wrong
    for key in ("codimension", "determinacy"):
        proof = data["certificate"][key]
        for part, value in walk(proof):
            wrong = deepcopy(data)
            place(wrong["certificate"][key], part[:-1])[part[-1]] = value
            yield f"{key}: {part}", wrong


def walk(proof: dict):
    """Places in a proof, and what is put there instead."""
    if proof["kind"] == "locus":
        yield ("dimension",), proof["dimension"] + 1
        yield ("locus", "kind"), "nothing"
        if proof["zeros"]["proof"] == "basis":
            basis = proof["zeros"]["basis"]
            yield ("zeros", "basis"), [*basis, [[1, *[0] * (len(basis[0][0]) - 2), "1"]]]
            yield ("zeros", "basis"), basis[1:]
            yield ("zeros", "free"), []
            yield ("zeros", "proof"), "count"
        return
    told = ("annihilator",) if "annihilator" in proof else ()
    functionals = place(proof, told)["functionals"]
    yield (*told, "functionals"), functionals[1:]
    yield (*told, "functionals"), [*functionals, functionals[0]]
    # a term of the highest degree is in the tangent space
    order, term = place(proof, told)["order"], next(iter(functionals[-1]))
    high = re.sub(r"[a-z]\w*(\*\*\d+)?(\*[a-z]\w*(\*\*\d+)?)*|\b1\b", f"x**{order}", term, count=1)
    yield (*told, "functionals"), [*functionals[:-1], {**functionals[-1], high: "1/7"}]
    yield (*told, "order"), 0
    yield (*told, "prime"), 4
    if "contact" in proof:
        yield ("contact", "functionals"), proof["contact"]["functionals"][1:]
    if "functional" in proof:
        yield ("functional", "values"), {}
        yield ("other",), list(reversed(proof["other"])) if len(proof["other"]) > 1 else ["x**2"]


def place(proof: dict, part: tuple):
    for key in part:
        proof = proof[key]
    return proof


@pytest.mark.parametrize(
    "case", [FINITE[0], FINITE[3], FINITE[5], FINITE[9], *INFINITE[1:5], INFINITE[11]], ids=lambda c: c[0]
)
def test_tampered_files_are_refused(case):
    data = made(*case[:3])
    refused = 0
    for what, wrong in changes(data):
        with pytest.raises(RejectedError):
            check(wrong)
            pytest.fail(f"accepted: {what}")
        refused += 1
    assert refused >= 10


@pytest.mark.parametrize("case", [FINITE[0], FINITE[4], INFINITE[0], INFINITE[4]], ids=lambda c: c[0])
def test_a_proof_of_another_germ_is_refused(case):
    data = made(*case[:3])
    for text in ("x**2", "x*y**5", "x + y"):
        wrong = {**data, "components": [*data["components"][:-1], text]}
        with pytest.raises(RejectedError):
            check(wrong)


def test_fields_must_be_nilpotent_together():
    data = made("x, u^2 + x*u", "x u", "A(H)")
    proof = data["certificate"]["determinacy"]
    for matrix in ([["0", "1"], ["1", "0"]], [["1", "0"], ["0", "1"]], [["0", "1"], ["0", "0"]]):
        wrong = deepcopy(data)
        wrong["certificate"]["determinacy"]["matrices"] = [
            *proof["matrices"],
            {"side": "source", "matrix": matrix},
        ]
        with pytest.raises(RejectedError, match=r"nilpotent|boundary"):
            check(wrong)


@pytest.mark.parametrize(
    "data",
    [
        {},
        {"kind": "spline"},
        {"kind": "germ", "version": 2},
        {"kind": "germ", "version": 1},
        {
            "kind": "germ",
            "version": 1,
            "components": ["__import__('os')"],
            "source": ["x"],
            "boundary": None,
            "group": "R",
            "codimension": 1,
            "extended_codimension": None,
            "determinacy": None,
            "certificate": {},
        },
    ],
)
def test_what_is_no_certificate(data):
    with pytest.raises(RejectedError):
        check(data)


def test_files(tmp_path):
    file = tmp_path / "germ.json"
    file.write_text(written("x^3", "x", "R"), encoding="utf-8")
    assert osc.check(file) == osc.check(str(file)) == check(made("x^3", "x", "R"))
    file.write_text("no json")
    with pytest.raises(osc.RejectedError, match="no JSON"):
        osc.check(file)
    with pytest.raises(OSError, match="missing"):
        osc.check(tmp_path / "missing.json")


def test_formulas_are_read_like_sympys():
    import sympy

    x = sympy.Symbol("x")
    for name in ("exp", "sin", "cos", "sinh", "cosh", "tan", "tanh", "atan", "atanh", "asin", "asinh"):
        series = sympy.Poly(sympy.series(getattr(sympy, name)(x), x, 0, 9).removeO(), x)
        expected = [series.coeff_monomial(x**k) for k in range(9)]
        assert [sympy.Rational(c.numerator, c.denominator) for c in taylor(name, 0, 8)] == expected
    for text in ("__import__('os')", "x if x else x", "x + z", "x**y", "lambda: x", "(", "x" * 3, "1/x"):
        with pytest.raises(RejectedError):
            read(text, ["x", "y"], 3)


def random_germ(seed: int) -> tuple[str, str, str]:
    """A random germ of few terms, finite or not, with a group."""
    source = random.Random(seed)
    group = source.choice(["R", "K", "A", "A", "A", "R(H)", "A(H)", "K(H)", "C", "L"])
    names = source.choice(["x y", "x", "x y"]) if "(H)" not in group else "x u"
    variables, p = names.split(), 1 if group[0] == "R" else source.choice([1, 2, 2, 3])
    parts = []
    for j in range(p):
        terms = [variables[0]] if group[0] in "AL" and j == 0 and source.random() < 0.7 else []
        for _ in range(source.randint(1, 3)):
            c = source.choice(["", "2*", "-", "1/3*", "-3/2*"])
            powers = [f"{v}^{e}" for v in variables if (e := source.randint(0, 4))]
            terms.append(c + "*".join(powers or [f"{variables[-1]}^2"]))
        parts.append(" + ".join(f"({t})" for t in terms))
    return ", ".join(parts), names, group


@pytest.mark.parametrize(
    "seeds",
    [range(12), *(pytest.param(range(i, i + 48), marks=pytest.mark.slow) for i in range(12, 300, 48))],
)
def test_random_germs(seeds):
    """What is decided is accepted; each second file is refused when its codimension is another."""
    decided = 0
    for seed in seeds:
        formulas, names, group = random_germ(seed)
        data = json.loads(json.dumps(certificate_file(germ(formulas, names, patience=3), group)))
        if data["codimension"] is None:
            continue
        decided += 1
        assert check(data), (formulas, group)
        if seed % 2:
            data["codimension"] = 3 if data["codimension"] == "infinite" else data["codimension"] + 1
            with pytest.raises(RejectedError):
                check(data)
    assert decided >= 0.9 * len(seeds)


@pytest.mark.parametrize("text", ["x**3 + 1e-400*x**2", "x**3+0.99999999999999999999*x**2-x**2"])
def test_decimals_are_read_exactly(text):
    told = certificate_file(germ("x^3", "x"))
    with pytest.raises(RejectedError):
        check({**told, "components": [text]})


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("x^2/1234567890123456789 + y^3", "x y"),
        ("x^2/2147483647 + y^3", "x y"),
        ("x^2 + lambda^3", "x lambda"),
    ],
)
def test_large_denominators_and_names_that_python_reserves(text, names):
    assert len(check(certificate_file(germ(text, names)))) == 4


def test_work_is_bounded_for_one_certificate_and_not_for_all():
    with pytest.raises(RejectedError, match="more work"), limited(10):
        read("(x + y)^9", ["x", "y"])
    assert len(read("(x + y)^9", ["x", "y"])) == 10


@pytest.mark.parametrize("number", ["Infinity", "-Infinity", "NaN", "1e999", "-1e999", "1.0"])
def test_infinity_is_no_number_of_a_file(number, tmp_path):
    whole = json.loads(json.dumps(certificate_file(germ("x**3 + y**4", "x y"))))
    file = tmp_path / "germ.json"

    def put(holder, key):
        """The file with that number in the place of another."""
        kept, holder[key] = holder[key], "HERE"
        file.write_text(json.dumps(whole).replace('"HERE"', number))
        holder[key] = kept

    proof = whole["certificate"]["determinacy"]
    first = whole["certificate"]["codimension"]
    functional = next(f for f in first["functionals"] if f)
    places = [
        *((whole, key) for key in ("codimension", "extended_codimension", "determinacy", "version")),
        *((first, key) for key in ("order", "prime")),
        *((proof["annihilator"], key) for key in ("order", "prime")),
        (functional, next(iter(functional))),
    ]
    for holder, key in places:
        put(holder, key)
        with pytest.raises(RejectedError):
            check(file)
        value = float(number)
        kept, holder[key] = holder[key], value
        with pytest.raises(RejectedError):
            check(whole)
        holder[key] = kept
    assert check(whole)
