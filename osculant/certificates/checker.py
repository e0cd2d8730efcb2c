"""The independent checker of certificate files: `check`.

It imports nothing of osculant but its own modules ``check_…`` (a contract of the linter): polynomials are
dictionaries, elimination is Gauss's, formulas are read by Python's own grammar and never run. So what it
accepts is proved even if the engine that wrote the file is wrong.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

from osculant.certificates.check_algebra import number, read
from osculant.certificates.check_equivalence import check_equivalence
from osculant.certificates.check_fields import applied, check_nilpotent
from osculant.certificates.check_loci import check_locus
from osculant.certificates.check_numbers import Field, over
from osculant.certificates.check_tangents import (
    EXTENDED,
    ORDINARY,
    UNIPOTENT,
    Annihilated,
    Problem,
    annihilated,
    spanning,
)
from osculant.certificates.check_text import RejectedError, limited, require

#: bytes of a certificate file at most
LARGEST = 50_000_000


def check(certificate: str | Path | Mapping[str, Any]) -> tuple[str, ...]:
    """Check a certificate file, and tell what it proves.

    Args:
        certificate: the place of the file, or what is in it. Known are files of germs and of equivalences,
            as `osculant.germs.report.certificate_file`, `osculant.germs.equivalence_file` and the command
            line make them.

    Returns sentences, one for each statement that is proved.

    Raises `RejectedError`, a ValueError, for a certificate that does not prove what it says, or is none;
    OSError for a file that cannot be read.

    >>> from osculant.germs.map_germ import germ
    >>> from osculant.germs.report import certificate_file
    >>> for sentence in check(certificate_file(germ("x**3", "x"))):
    ...     print(sentence)
    The R codimension of (x**3) is 2.
    The extended R codimension of (x**3) is 2.
    (x**3) is 3-determined for R.
    (x**3) is not 2-determined for R.
    """
    if isinstance(certificate, Mapping):
        data: Any = certificate
    else:
        text = Path(certificate).read_bytes()
        require(len(text) <= LARGEST, "the file is too large")
        try:
            data = json.loads(text, parse_constant=_no_number)
        except (ValueError, RecursionError):
            raise RejectedError("the file is no JSON") from None
    require(isinstance(data, Mapping) and data.get("kind") in KINDS, "this is no certificate file of a germ")
    require(
        type(data.get("version")) is int and data["version"] == 1,
        f"the version {data.get('version')!r} of the file is not known",
    )
    try:
        with limited(), over(_field(data)):
            return KINDS[data["kind"]](data)
    except RejectedError:
        raise
    except (
        KeyError,
        TypeError,
        ValueError,
        IndexError,
        AttributeError,
        ArithmeticError,
        MemoryError,
        RecursionError,
        StopIteration,
    ) as error:
        raise RejectedError(
            f"the certificate is not well formed ({type(error).__name__}: {error})"
        ) from error


def _no_number(name: str) -> None:
    raise ValueError(name)


def _field(data: Mapping[str, Any]) -> Field | None:
    told = data.get("field")
    return None if told is None else Field(told, tuple(map(str, data["source"])))


def _problem(data: Mapping[str, Any]) -> Problem:
    problem = Problem(
        tuple(map(str, data["components"])), tuple(map(str, data["source"])), data["boundary"], data["group"]
    )
    require(bool(problem.components) and bool(problem.source), "there is no germ")
    require(len(set(problem.source)) == problem.n, "a variable is named twice")
    require(all(any(m) for f in problem.jet(1) for m in f), "the germ is not 0 at the origin")
    return problem


def _equivalence(data: Mapping[str, Any]) -> tuple[str, ...]:
    problem = _problem(data)
    found = check_equivalence(problem, data)
    pair = (
        f"{found.first} and {found.second} are {problem.group}-equivalent over the {found.numbers} numbers."
    )
    told = [f"The jets of order {found.order} of {pair}"]
    if data["determinacy"] is not None:
        degree = data["determinacy"]["degree"]
        require(degree <= found.order, "the germ is not told to be determined by its jet of that order")
        check_determinacy(problem, degree, data["determinacy"]["proof"])
        told.append(f"{found.first} is {degree}-determined for {problem.group}.")
        told.append(f"So the germs {pair}")
    return tuple(told)


def _germ(data: Mapping[str, Any]) -> tuple[str, ...]:
    problem = _problem(data)
    name, group, proofs = f"({', '.join(problem.components)})", problem.group, data["certificate"]
    told: list[str] = []
    depth = None
    for key, version, what in (
        ("codimension", ORDINARY, f"The {group} codimension"),
        ("extended_codimension", EXTENDED, f"The extended {group} codimension"),
    ):
        if data[key] is None:
            continue
        require(
            type(data[key]) is int or data[key] == "infinite", f"{str(data[key])[:60]!r} is no codimension"
        )
        found = check_codimension(problem, version, data[key], proofs[key])
        depth = found.depth(False) if found is not None and version == ORDINARY else depth
        told.append(f"{what} of {name} is {data[key]}.")
    degree = data["determinacy"]
    if degree == "infinite":
        require(proofs["determinacy"]["kind"] == "locus", "infinity needs a locus")
        check_locus(problem, proofs["determinacy"])
        told.append(f"{name} is not finitely determined for {group}.")
    elif degree is not None:
        check_determinacy(problem, degree, proofs["determinacy"])
        told.append(f"{name} is {degree}-determined for {group}.")
        if data["sharp"]:
            check_sharp(problem, degree, depth, proofs["determinacy"])
            told.append(f"{name} is not {degree - 1}-determined for {group}.")
    require(bool(told), "the file has no statement with a proof")
    return tuple(told)


def check_codimension(
    problem: Problem, version: int, value: Any, told: Mapping[str, Any]
) -> Annihilated | None:
    """Check the proof of a codimension; the annihilator if it is finite. Raises RejectedError."""
    if told["kind"] == "locus":
        require(value == "infinite", "a locus proves only that a codimension is infinite")
        check_locus(problem, told)
        return None
    require(told["kind"] == "annihilator", "no such proof")
    found = annihilated(problem, version, told)
    require(
        found.settles(_contact(problem, found.weights, told), version), "the order of the jets is too small"
    )
    constants = 0 if version == EXTENDED else problem.p
    require(value == len(found.functionals) - constants, "the codimension is another")
    return found


def _contact(problem: Problem, weights: tuple[int, ...], told: Mapping[str, Any]) -> int | None:
    """l with W_lθ ⊂ T K_e f for A and L, checked; None for modules over the source functions."""
    if problem.parts[1] != "left":
        return None
    require(tuple(told["contact"].get("weights", ())) == weights, "the weights of T K_e f are others")
    found = annihilated(problem, EXTENDED, told["contact"], "contact")
    require(found.settles(None, EXTENDED), "T K_e f is not settled")
    return found.depth() + 1


def check_determinacy(problem: Problem, degree: Any, told: Mapping[str, Any]) -> None:
    """Check that a germ is determined to a degree; raises RejectedError."""
    require(told["kind"] == "criterion", "no such proof")
    require(type(degree) is int and degree >= 1, "a degree is at least 1")
    fields = told["matrices"]
    check_nilpotent(problem, fields)
    jets = told["annihilator"]
    more = [applied(problem, f, jets["order"], tuple(jets.get("weights", ()))) for f in fields]
    found = annihilated(problem, UNIPOTENT, jets, more=more)
    require(found.depth(False) <= degree, f"M^{degree + 1}θ is not in the tangent space")
    bound = _contact(problem, found.weights, told)
    if found.weights:
        first = annihilated(problem, UNIPOTENT, told["first"])
        require(first.order == found.order and first.weights == found.weights, "the jets are others")
        require(first.settles(bound, UNIPOTENT), "the order of the jets is too small")
    else:
        require(found.order >= degree + max(bound or 1, 1), "the order of the jets is too small")


def check_sharp(problem: Problem, degree: int, depth: int | None, told: Mapping[str, Any]) -> None:
    """Check that a germ is not determined to one degree less; raises RejectedError.

    Args:
        problem: the germ and the group.
        degree: the degree k.
        depth: the m with M^{m+1}θ ⊂ T G f and no smaller one, as far as it is known.
        told: the certificate of the degree.
    """
    if degree == 1:
        return
    require(depth is not None, "the codimension is not proved")
    if depth is not None and depth >= degree:
        return  # M^kθ is not in T G f
    texts = tuple(told["other"])
    require(len(texts) == problem.p, "the other germ has another number of components")
    other = Problem(texts, problem.source, problem.boundary, problem.group)
    for f, g, text in zip(problem.jet(degree - 1), other.jet(degree - 1), texts):
        require(f == g, "the other germ has another jet")
        read(text, problem.source)  # a polynomial
    values = {other.term(t): number(v) for t, v in told["functional"]["values"].items()}
    require(all(sum(m) <= degree for m, _ in values), "the functional lives beyond the jets")
    require(any(v and sum(m) == degree for (m, _), v in values.items()), f"the functional is 0 on M^{degree}")
    for vector in spanning(other, ORDINARY, degree):
        total = sum(
            (c * values.get((m, j), 0) for j, f in enumerate(vector) for m, c in f.items()), Fraction(0)
        )
        require(total == 0, "the functional is not 0 on the other germ's tangent space")


#: what a file may be: the function that checks it and tells what is proved
KINDS: Mapping[str, Callable[[Mapping[str, Any]], tuple[str, ...]]] = {
    "germ": _germ,
    "equivalence": _equivalence,
}
