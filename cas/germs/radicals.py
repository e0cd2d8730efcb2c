"""Number fields that contain given roots of numbers: ℚ(√2), and fields over fields by a primitive element.

β, a positive real with β^q = b in K = ℚ(α), is adjoined by γ = α + cβ for a small whole c: its polynomial is
the factor at γ of the norm of (z − α)^q − c^q b, and α is the common zero of the polynomial of α and of
(γ − y)^q − c^q b(y). All is exact but the choice of the factor, which balls make.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from flint import Ordering, arb, ctx, fmpq_mpoly_ctx, fmpq_poly

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import Node, call, number, power
from osculant.cas.germs.algebraic import DEGREE, Algebraic, NumberField, rational

#: whole numbers c that are tried, and bits of the balls, at first and at most
TRIED, PRECISION, MOST = 20, 128, 4096


def positive(value: Any) -> bool:
    """Whether a number of a field, or a rational one, is positive; DomainError if the field is not real.

    >>> root = extended(None, 2, Fraction(2)).generator
    >>> positive(root - 1), positive(root - 2)
    (True, False)
    """
    if not isinstance(value, Algebraic):
        return bool(value > 0)
    return bool(_precise(lambda: _ball(value), lambda ball: ball > 0 or ball < 0) > 0)


def extended(field: NumberField | None, degree: int, of: Any) -> NumberField:
    """The least field over a field with the positive root of that degree of a positive number of it.

    The new field knows the root under ``roots[degree, of]``, and the roots that the old one knows.

    Raises DomainError beyond the degree that fields may have.

    >>> two = extended(None, 2, Fraction(2))
    >>> both = extended(two, 2, Fraction(3))
    >>> str(two.generator), both.degree, str(both.roots[2, Fraction(3)] ** 2)
    ('sqrt(2)', 4, '3')
    """
    expression = number(of) if field is None or not isinstance(of, Algebraic) else field.expression(of)
    node = call("sqrt", expression) if degree == 2 else power(expression, number(Fraction(1, degree)))
    if degree * (1 if field is None else field.degree) > 2 * DEGREE:
        raise DomainError(f"The number {node} of a germ is of a degree that is too high.")

    def root() -> Any:
        return _ball(of).root(degree)

    if field is None:
        whole = fmpq_poly([-rational(Fraction(of)), *([0] * (degree - 1)), 1])
        found = NumberField(_factor(whole, root), node, root)
        found.roots[degree, of] = found.generator
        return found
    for c in range(1, TRIED):
        made = _joined(field, degree, of, c, node, root)
        if made is not None:
            return made
    raise DomainError(f"No field with {node} and {field.node} was found.")


def _joined(
    field: NumberField, q: int, of: Any, c: int, node: Node, root: Callable[[], Any]
) -> NumberField | None:
    old = field.real
    if old is None:
        raise DomainError(
            f"{node} stands beside the stated root {field.node}: write all numbers of a germ by one root."
        )

    def real() -> Any:
        return old() + c * root()

    context = fmpq_mpoly_ctx.get(["y", "z"], Ordering.degrevlex)
    y, z = context.gens()
    below = field.number(fmpq_poly([0])) + of
    coefficients = below.coefficients() if isinstance(below, Algebraic) else (Fraction(below),)
    b = sum((y**i * rational(v) for i, v in enumerate(coefficients)), context.constant(0))
    m = sum((y**i * v for i, v in enumerate(field.polynomial.coeffs())), context.constant(0))
    norm = m.resultant((z - y) ** q - b * c**q, "y")
    dense: list[Any] = [0] * (int(norm.degrees()[1]) + 1)
    for (_, e), v in norm.to_dict().items():
        dense[int(e)] = v
    larger = NumberField(_factor(fmpq_poly(dense), real), field.node + number(c) * node, real)
    alpha = _common_zero(field, larger, q, of, c)
    if alpha is None:
        return None

    def lifted(value: Any) -> Any:
        if not isinstance(value, Algebraic):
            return value
        total: Any = 0
        for v in reversed(value.coefficients()):
            total = total * alpha + v
        return total

    larger.roots = {(d, lifted(what)): lifted(value) for (d, what), value in field.roots.items()}
    larger.roots[q, lifted(of)] = (larger.generator - alpha) / Fraction(c)
    assert larger.roots[q, lifted(of)] ** q == lifted(of)
    return larger


def _common_zero(field: NumberField, larger: NumberField, q: int, of: Any, c: int) -> Any:
    """α as a number of the larger field; None if the greatest common divisor is not linear."""
    first = [Fraction(int(v.p), int(v.q)) for v in field.polynomial.coeffs()]
    gamma = larger.generator
    second: list[Any] = [1]
    for _ in range(q):  # times γ − y
        second = [gamma * a - b for a, b in zip([*second, 0], [0, *second])]
    below = of.coefficients() if isinstance(of, Algebraic) else (Fraction(of),)
    for i, v in enumerate(below):
        second += [0] * (i + 1 - len(second))
        second[i] = second[i] - v * c**q
    a, b = _trimmed(first), _trimmed(second)
    while b:
        a, b = b, _remainder(a, b)
    return -(a[0] / a[1] if isinstance(a[1], Algebraic) else a[0] / Fraction(a[1])) if len(a) == 2 else None


def _remainder(a: list[Any], b: list[Any]) -> list[Any]:
    rest, top = list(a), b[-1] if isinstance(b[-1], Algebraic) else Fraction(b[-1])
    while len(rest) >= len(b):
        factor = rest[-1] / top
        shift = len(rest) - len(b)
        for i, v in enumerate(b):
            rest[shift + i] = rest[shift + i] - factor * v
        rest = _trimmed(rest[:-1])
    return rest


def _trimmed(a: list[Any]) -> list[Any]:
    while a and not a[-1]:
        a = a[:-1]
    return a


def _factor(whole: Any, root: Callable[[], Any]) -> Any:
    """The irreducible factor that is 0 at a real number."""
    factors = [f for f, _ in whole.factor()[1]]

    def zeros() -> list[Any]:
        ball = root()
        found = []
        for f in factors:
            total = arb(0)
            for c in reversed(f.coeffs()):
                total = total * ball + arb(c)
            if total.contains(0):
                found.append(f)
        return found

    return _precise(zeros, lambda found: len(found) == 1)[0]


def _precise(compute: Callable[[], Any], enough: Callable[[Any], bool]) -> Any:
    """What is computed with as many bits as are enough."""
    kept = ctx.prec
    try:
        ctx.prec = PRECISION
        while not enough(found := compute()):
            if ctx.prec > MOST:
                raise DomainError("A number of a germ is not told from others.")
            ctx.prec *= 2
        return found
    finally:
        ctx.prec = kept


def _ball(value: Any) -> Any:
    if not isinstance(value, Algebraic):
        return arb(rational(Fraction(value)))
    if value.field.real is None:
        raise DomainError(f"A root of {value} is not told by the polynomial of {value.field.node} alone.")
    at, total = value.field.real(), arb(0)
    for c in reversed(value.coefficients()):
        total = total * at + arb(rational(c))
    return total
