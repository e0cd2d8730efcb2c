"""Certificates over number fields: accepted as they are, refused with other fields, roots and numbers."""

from __future__ import annotations

import json
from copy import deepcopy
from fractions import Fraction
from functools import cache

import pytest

from osculant.certificates.check_numbers import Field, over
from osculant.certificates.check_text import RejectedError
from osculant.certificates.checker import check
from osculant.germs.map_germ import germ
from osculant.germs.report import certificate_file

CASES = [
    ("x^2 + sqrt(2)*x*y + y^3", "x y", "R", None),
    ("x, y^3 + sqrt(2)*x*y", "x y", "A", None),
    ("x, y^2, y^3 + cbrt(2)*x^3*y", "x y", "A", None),
    ("x, x*y + sqrt(2)*y^5 + sqrt(3)*y^7", "x y", "A", None),
    ("x^3 + a*y^4 + x*y^3", "x y", "R", "a^3 - a - 1"),
    ("x, u^2 + sqrt(2)*x*u", "x u", "A(H)", None),
    ("i*x^2 + u^3", "x u", "K(H)", "i^2 + 1"),
    ("x + sqrt(2)*y^2, (y + sqrt(2)*x)^2, (y + sqrt(2)*x)^3 + x^3*y", "x y", "A", None),
    ("cbrt(x - 2) + cbrt(2) + y^2", "x y", "R", None),
    ("sqrt(4)*x^2 + y^3*exp(sqrt(1 + sqrt(2))*x)", "x y", "K", None),
    ("(x^2 - sqrt(2)*y^2)^2", "x y", "R", None),
    ("x, x*y, sqrt(2)*y^3", "x y", "A", None),
    ("x^2 - sqrt(2)*y^2, x*y", "x y", "A", None),
    ("x, (y^2 - sqrt(2)*x - x^2)^2", "x y", "A", None),
    ("x^3 + a*x^2*y^2 + y^6", "x y", "R", "4*a^3 + 27"),
    ("x, y^3*sqrt(3 + y)", "x y", "A", None),
    ("t^2, sqrt(2)*t^4", "t", "L", None),
]
SQUARE_ROOT = {"polynomial": ["-2", "0", "1"], "name": None, "interval": ["1", "2"]}


@cache
def written(text, source, group, root):
    return json.dumps(certificate_file(germ(text, source, root=root), group))


def made(case):
    return json.loads(written(*case))


@pytest.mark.parametrize("case", CASES)
def test_files_over_fields_are_accepted(case):
    data = made(case)
    assert data["field"]["polynomial"] and not data["undecided"]
    assert len(check(data)) >= 3


def tampered(data):
    """Files that say something else, and for stated roots what is no field of them."""
    field = data["field"]

    def other(**changes):
        found = deepcopy(data)
        found["field"] |= changes
        return found

    yield other(polynomial=["1"])
    yield other(polynomial=[*field["polynomial"][:-1], "0"])
    yield other(polynomial=[1.5, *field["polynomial"][1:]])
    yield {**data, "field": None}
    if field["name"] is not None:
        yield other(name="x")
        yield other(name="b")
        return
    yield other(polynomial=[str(Fraction(field["polynomial"][0]) - 1), *field["polynomial"][1:]])
    yield other(interval=None)
    yield other(interval=["100", "200"])
    yield other(roots=[])
    for i, root in enumerate(field["roots"]):
        negative = [str(-Fraction(v)) for v in root["value"]]
        more = [*root["value"][:-1], str(Fraction(root["value"][-1]) + 1)]
        for value in (negative, more):
            yield other(roots=[*field["roots"][:i], {**root, "value": value}, *field["roots"][i + 1 :]])


@pytest.mark.parametrize("case", [case for case in CASES if len(case[0]) < 40])
def test_other_fields_are_refused(case):
    for data in tampered(made(case)):
        with pytest.raises(RejectedError):
            check(data)


def numbers(told, path=()):
    """(path, value) of all texts in a certificate that are numbers with a root."""
    items = told.items() if isinstance(told, dict) else enumerate(told) if isinstance(told, list) else ()
    for key, value in items:
        if isinstance(value, str) and ("sqrt" in value or value in {"a", "2*a"}) and key not in {"sentence"}:
            yield (*path, key)
        else:
            yield from numbers(value, (*path, key))


@pytest.mark.parametrize("case", CASES)
def test_other_numbers_are_refused(case):
    data = made(case)
    for path in list(numbers(data["certificate"]))[:8]:
        if "other" in path or "fields" in path or "coordinates" in path:
            continue
        found = deepcopy(data)
        holder = found["certificate"]
        for key in path[:-1]:
            holder = holder[key]
        holder[path[-1]] = f"1 + {holder[path[-1]]}"
        with pytest.raises(RejectedError):
            check(found)


def test_numbers_of_the_checker():
    field = Field({**SQUARE_ROOT, "roots": [{"degree": 2, "of": ["2"], "value": ["0", "1"]}]}, ("x",))
    root = field.root(Fraction(2), 2)
    assert root * root == 2 and (1 + root) * (1 + root).inverse() == 1 and (3 - root) / (3 - root) == 1
    assert root**-2 == Fraction(1, 2) and 2 - root == -(root - 2) and hash(root) == hash(root * 1)
    with pytest.raises(RejectedError, match="is not known"):
        field.root(Fraction(3), 2)
    reducible = Field({**SQUARE_ROOT, "polynomial": ["-1", "0", "1"], "interval": None, "roots": []}, ("x",))
    with pytest.raises(RejectedError, match="reducible"):
        (reducible.generator - 1).inverse()
    with over(field):
        pass


def test_zero_divisors_prove_nothing():
    # a² = a: for the root 1 the codimension is 1, for the root 0 it is 2
    data = made(("x^2 + x^3", "x", "R", None))
    assert check(data)
    data["components"] = ["a*x**2 + x**3"]
    data["field"] = {"polynomial": ["0", "-1", "1"], "name": "a", "interval": None, "roots": []}
    with pytest.raises(RejectedError):
        check(data)
    data["certificate"]["codimension"]["functionals"][0] = {"1": "a"}
    with pytest.raises(RejectedError, match="reducible"):
        check(data)
