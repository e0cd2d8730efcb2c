"""Certificates of equivalence: those of random equivalences are accepted, tampered ones refused."""

from __future__ import annotations

import json
import random
import re
from copy import deepcopy
from functools import cache

import pytest

from osculant.cas.germs.germ import Germ
from osculant.cas.germs.reference import reference
from osculant.cas.recognition.equivalence import equivalence
from osculant.cas.recognition.forms import form, stabilised
from osculant.certificates.check_algebra import read
from osculant.certificates.check_text import RejectedError
from osculant.certificates.checker import check
from osculant.germs.equivalence_file import equivalence_file
from osculant.germs.map_germ import MapGerm
from tests.random_equivalences import accepted, cases

#: germs with what they are: list, row, integers, text, variables, the boundary
GERMS = {
    "R": ("simple functions", "E_6", {}, "(x + y**2/2)**3 - 2*(y - x)**4 + x**2*y**3", "x y", None),
    "cubic field": ("simple functions", "D_k", {"k": 4}, "x**3 - 3*x*y**2 + y**3 + x*y**3", "x y", None),
    "modulus": ("unimodal functions", "J_10", {}, "2*x**3 + x**2*y**2 - x*y**4 + 3*y**6", "x y", None),
    "R(H)": ("boundary functions", "C_k", {"k": 3}, "3*x*y + 2*y**3 + x**2 - x*y**2", "x y", "x"),
    "A": ("mond", "P_3", {}, "2*x, x*y + y**3 + x**2, x*y**2 + 2*y**4 + x**3 + x", "x y", None),
    "A(H)": ("table 6.2", "3d", {}, "x1 + x2**2, x2, 2*u**2 + x1*u - 3*x3**2 + x2*x3", "x1 x2 x3 u", "u"),
    "K": ("simple icis", "U_7", {}, "x**2 + y*z + x*y, x*y + z**3 + x*z**2", "x y z", None),
}


@cache
def certificate(name):
    listed, row, integers, text, source, boundary = GERMS[name]
    germ = Germ(text, source, boundary)
    found = equivalence(germ, form(reference(listed)[row], **integers))
    return json.dumps(equivalence_file(MapGerm(germ), found))


@pytest.mark.parametrize("name", GERMS)
def test_a_certificate_says_what_it_proves(name):
    data = json.loads(certificate(name))
    first, second, third = check(data)
    assert first.startswith(f"The jets of order {data['order']} of ({', '.join(data['components'])}) and (")
    assert second.endswith(f"is {data['determinacy']['degree']}-determined for {data['group']}.")
    assert third.startswith("So the germs (") and third.endswith("-equivalent over the real numbers.")
    data["determinacy"] = None
    assert check(data) == (first,)


def leaves(data, path=()):
    """The places of all numbers and texts."""
    if isinstance(data, dict | list):
        for key, value in data.items() if isinstance(data, dict) else enumerate(data):
            yield from leaves(value, (*path, key))
    else:
        yield path


def at(data, path):
    for key in path:
        data = data[key]
    return data


def put(data, path, value):
    changed = deepcopy(data)
    at(changed, path[:-1])[path[-1]] = value
    return changed


def changes(value, data):
    """Other values for a leaf."""
    if value is None:
        return ["x"]
    if isinstance(value, int):
        return [value + 1, -value, str(value)]
    if re.fullmatch(r"-?\d+(/\d+)?", value):
        return [f"{value}1", "0" if value != "0" else "1", f"-{value}".replace("--", "")]
    names = [name for name in (*data["form"]["variables"], *data["source"], *data["target"]) if name in value]
    return [f"{value} + {names[0]}" if names else f"{value}0", f"2*({value})", "0", ""]


#: nothing is proved of these, and proofs of determinacy are the business of other tests
FREE = ("list", "id", "integers", "determinacy")


def as_good(data, path, other, name):
    """Whether a changed certificate is one still.

    Another sign of a scale may stand in even powers only; jets of a higher order may have no more terms.
    """
    if path[0] == "scales":
        variables = data["form"]["variables"]
        names = (*variables, *data["form"]["moduli"])
        terms = [m for f in data["form"]["components"] for m in read(f, names)]
        return path[1] == "source" and all(m[path[2]] % 2 == 0 for m in terms)
    return path == ("order",) and other == data["order"] + 1 and name == "modulus"


@pytest.mark.parametrize("name", GERMS)
def test_tampered_certificates_are_refused(name):
    data = json.loads(certificate(name))
    tried = 0
    for path in leaves(data):
        value = at(data, path)
        for other in () if set(path) & set(FREE) else changes(value, data):
            if other in (value, "-0") or as_good(data, path, other, name):
                continue
            tried += 1
            with pytest.raises(RejectedError):
                told = check(put(data, path, other))
                pytest.fail(f"{path}: {other} in place of {value} is accepted: {told}")
    assert tried > 40


@pytest.mark.parametrize("name", GERMS)
def test_a_false_statement_about_determinacy_is_refused(name):
    data = json.loads(certificate(name))
    degree, order = data["determinacy"]["degree"], data["order"]
    for wrong in (degree - 1, 0, -1, str(degree), None):
        with pytest.raises(RejectedError):
            told = check(put(data, ("determinacy", "degree"), wrong))
            pytest.fail(f"{degree} changed to {wrong} is accepted: {told}")
    with pytest.raises(RejectedError, match="not told to be determined by its jet"):
        check(put(data, ("determinacy", "degree"), order + 1))


def tampered(name, path, value):
    return put(json.loads(certificate(name)), path, value)


def test_the_reasons():
    for changed, reason in (
        (tampered("R", ("phi", 0), "x + 1"), "moves the origin"),
        (tampered("R", ("phi", 0), "y"), "not invertible|jets differ"),
        (tampered("R", ("psi",), ["Y1"]), "change of the target is not in R"),
        (tampered("R", ("scales", "target"), ["2"]), "scales of the target are not in R"),
        (tampered("A", ("matrix",), [["1", "0"], ["0", "1"]]), "matrix is not in A"),
        (tampered("A", ("psi",), None), "change of the target is not in A"),
        (tampered("A", ("scales", "source", 0), {"factor": "1", "powers": [["-2", "1/2"]]}), "positive"),
        (tampered("A", ("form", "moduli"), {"x": "1"}), "called like a variable"),
        (tampered("K", ("matrix", 0, 0), "x"), "not invertible at the origin"),
        (tampered("R(H)", ("phi", 0), "x + y"), "does not preserve the boundary"),
        (tampered("R(H)", ("form", "boundary"), "z"), "no boundary variable"),
        (tampered("cubic field", ("field", "interval"), ["5", "6"]), "not told to have a root"),
        (tampered("R", ("order",), 0), "no order"),
        (tampered("R", ("kind",), "equality"), "no certificate file"),
        (tampered("R", ("version",), 2), "version"),
        (tampered("R", ("group",), "S"), "no group"),
    ):
        with pytest.raises(RejectedError, match=reason):
            check(changed)


def test_the_sides_of_the_boundary_are_kept():
    data = json.loads(certificate("R(H)"))
    data["phi"] = [f.replace("x", "(-x)") for f in data["phi"]]
    data["form"]["components"] = ["-x*y + y**3"]
    with pytest.raises(RejectedError, match="sides of the boundary"):
        check(data)
    data["group"], data["boundary"], data["form"]["boundary"] = "R", None, None
    data["determinacy"] = None
    assert len(check(data)) == 1


def test_a_field_without_a_real_root_is_complex():
    data = {
        "kind": "equivalence",
        "version": 1,
        "group": "R",
        "source": ["x"],
        "boundary": None,
        "components": ["x**2"],
        "field": {"polynomial": ["1", "0", "1"], "name": "i", "interval": None, "roots": []},
        "order": 2,
        "form": {"components": ["-x**2"], "variables": ["x"], "boundary": None, "moduli": {}},
        "phi": ["i*x"],
        "target": [],
        "psi": None,
        "matrix": None,
        "scales": {"source": ["1"], "target": ["1"]},
        "determinacy": None,
    }
    assert check(data) == (
        "The jets of order 2 of (x**2) and (-x**2) are R-equivalent over the complex numbers.",
    )
    data["field"] |= {"polynomial": ["-1", "0", "1"], "interval": ["0", "2"]}
    with pytest.raises(RejectedError, match="jets differ"):
        check(data)


def test_the_generator_has_a_name_of_its_own():
    germ = Germ("theta**3 - 3*theta*y**2 + y**3 + z**2", "theta y z")
    found = equivalence(germ, stabilised(form(reference("simple functions")["D_k"], k=4), 3))
    data = equivalence_file(MapGerm(germ), found, determined=False)
    assert data["field"]["name"] == "theta_"
    assert "over the real numbers" in check(data)[0]


@pytest.mark.parametrize("group", ["R", "R(H)", "A", "A(H)", "K"])
def test_random_equivalences_are_accepted(group):
    fit = [case.form.group.name == group and case.terms < 150 for case in cases()]
    seeds = [seed for seed, fits in enumerate(fit) if fits]
    for seed in random.Random(group).sample(seeds, 4):
        verdict, told = accepted(seed)
        assert verdict in ("ACCEPTED", "UNDECIDED"), told
