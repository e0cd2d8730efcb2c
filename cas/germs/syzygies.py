"""All relations Σ aᵢgᵢ = 0 between polynomials, by a Gröbner basis with a variable for each, in a process.

In the ring with variables t > e₀ > … > e_p > x and lexicographic order, the ideal of the gᵢt + eᵢ and of all
products of two of t, e₀, …, e_p has a Gröbner basis whose elements without t, if they are linear in the e,
are Σ aᵢeᵢ for a basis of the relations. Relations of polynomials generate those of power series too. The
basis is made in C code that cannot be interrupted: a process of its own does it in time.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Sequence
from fractions import Fraction
from math import lcm
from os import environ, pathsep
from typing import Any

from flint import Ordering, fmpz, fmpz_mpoly_ctx, fmpz_mpoly_vec

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.processes import counted
from osculant.cas.germs.search import Patience

#: a polynomial by [exponents…, coefficient as text]
Terms = list[list[Any]]
#: seconds that they have at least
SHORTEST = 0.1


def syzygies(functions: Sequence[Any], patience: Patience | None = None) -> list[list[Any]]:
    """Generators of the relations between polynomials over ℚ of one ring, none of them superfluous over it.

    Raises UndecidedError if they are not found in time.

    >>> from osculant.cas.germs.model import ring
    >>> x, y = ring(["x", "y"]).gens()
    >>> [[str(a) for a in relation] for relation in syzygies([x, y])]
    [['y', '-x']]
    """
    patience, context = patience or Patience(), functions[0].context()
    given = {"variables": context.nvars(), "functions": [_told(f) for f in functions]}
    path = pathsep.join(p for p in sys.path if p)
    process = subprocess.Popen(
        [sys.executable, "-m", "osculant.cas.germs.syzygies"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env={**environ, "PYTHONPATH": path},
    )
    cost, told = counted(process.pid), None
    try:
        told, _ = process.communicate(json.dumps(given), timeout=max(patience.left(), SHORTEST))
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    finally:
        cost.ended()
    if told is None or process.returncode:
        raise UndecidedError(
            f"The relations between polynomials are not found in {patience.seconds:g} seconds."
        )
    relations = json.loads(told)
    return [[context.from_dict({tuple(m): fmpz(c) for *m, c in a}) for a in r] for r in relations]


def _told(f: Any) -> Terms:
    found = {tuple(map(int, m)): Fraction(int(c.p), int(c.q)) for m, c in f.to_dict().items()}
    return [[*m, str(c)] for m, c in found.items()]


def relations(n: int, functions: Sequence[dict[tuple[int, ...], Fraction]]) -> list[list[Terms]]:
    """The relations between polynomials in n variables, in this process, for as long as it takes.

    >>> relations(1, [{(1,): Fraction(1)}, {(2,): Fraction(1)}])
    [[[[1, '1']], [[0, '-1']]]]
    """
    count = len(functions)
    names = ["t", *(f"e{i}" for i in range(count)), *(f"x{i}" for i in range(n))]
    context = fmpz_mpoly_ctx.get(names, Ordering.lex)
    gens = list(context.gens())
    generators = []
    common = lcm(*(c.denominator for f in functions for c in f.values()))
    for i, f in enumerate(functions):
        front = (1, *(0,) * count)
        terms = {(*front, *m): fmpz(int(c * common)) for m, c in f.items()}
        generators.append(context.from_dict(terms) + gens[1 + i])
    marks = gens[: count + 1]
    pairs = [a * b for i, a in enumerate(marks) for b in marks[i:]]

    def linear(f: Any) -> bool:
        return all(int(m[0]) == 0 and sum(map(int, m[1 : count + 1])) == 1 for m in f.to_dict())

    basis = fmpz_mpoly_vec([*generators, *pairs], context).buchberger_naive().autoreduction()
    found = [f for f in basis if not f.is_zero() and linear(f)]
    for relation in sorted(found, key=lambda f: -f.total_degree()):
        rest = [g for g in found if g != relation]
        if rest and _within(relation, rest, pairs, context):
            found = rest
    return [_parts(relation, count) for relation in found]


def _within(f: Any, rest: Sequence[Any], pairs: Sequence[Any], context: Any) -> bool:
    """Whether a relation is a combination of others."""
    basis = fmpz_mpoly_vec([*rest, *pairs], context).buchberger_naive().autoreduction()
    more = fmpz_mpoly_vec([*basis, f], context).buchberger_naive().autoreduction()
    return {str(g) for g in basis if not g.is_zero()} == {str(g) for g in more if not g.is_zero()}


def _parts(f: Any, count: int) -> list[Terms]:
    parts: list[Terms] = [[] for _ in range(count)]
    for m, c in f.to_dict().items():
        exponents = list(map(int, m))
        parts[exponents[1 : count + 1].index(1)].append([*exponents[count + 1 :], str(c)])
    return parts


def main() -> None:
    """Read polynomials from standard input, print the relations."""
    from osculant.cas.germs.geometry import bounded

    bounded()
    read = json.load(sys.stdin)
    functions = [{tuple(m): Fraction(c) for *m, c in f} for f in read["functions"]]
    json.dump(relations(read["variables"], functions), sys.stdout)


if __name__ == "__main__":
    main()
