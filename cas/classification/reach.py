"""How far classification is built and tested; beyond it a question is refused, not answered in part."""

from __future__ import annotations

from osculant.cas.errors import DomainError
from osculant.cas.germs.groups import group

#: by group: for each number of variables and of components the largest codimension
REACH: dict[str, dict[tuple[int, int], int]] = {
    "A(H)": {(n, p): 3 if n <= 4 else 2 for n in range(2, 7) for p in range(2, 8)},
    "A": {(1, 2): 5, (1, 3): 5, (2, 2): 3, (2, 3): 4},
    "R": {(1, 1): 8, (2, 1): 8, (3, 1): 8},
}


def check(n: int, p: int, name: str, codimension: int) -> None:
    """Refuse what is out of reach.

    Raises DomainError that says what the reach is.

    >>> check(4, 3, "A", 1)
    Traceback (most recent call last):
        ...
    osculant.cas.errors.DomainError: source: 4 variables are out of reach: for A from 1 to 2.
    """
    g = group(name).name
    if g not in REACH:
        raise DomainError(
            f"group: germs are not classified for {g}: only for {' and '.join(REACH)}.", argument="group"
        )
    bounds = REACH[g]
    variables = sorted({source for source, _ in bounds})
    if n not in variables:
        raise DomainError(
            f"source: {n} variables are out of reach: for {g} from {variables[0]} to {variables[-1]}.",
            argument="source",
        )
    components = sorted(target for source, target in bounds if source == n)
    if p not in components:
        raise DomainError(
            f"target: {p} components are out of reach: for {g} and {_variables(n)} from {components[0]} to "
            f"{components[-1]}.",
            argument="target",
        )
    if codimension < 0:
        raise DomainError(
            f"codimension: {codimension} is negative: that of an open orbit is 0.", argument="codimension"
        )
    if codimension > bounds[n, p]:
        raise DomainError(
            f"codimension: {codimension} is out of reach: for {g}, {_variables(n)} and {p} components at "
            f"most {bounds[n, p]}.",
            argument="codimension",
        )


def _variables(n: int) -> str:
    return "1 variable" if n == 1 else f"{n} variables"
