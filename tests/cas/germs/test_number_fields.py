"""Germs over number fields: the arithmetic, and answers that do not depend on how a germ is written."""

from __future__ import annotations

import random
import re
from fractions import Fraction

import pytest
from flint import arb

from osculant.cas.errors import DomainError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.adapted import adapted
from osculant.cas.germs.algebraic import Algebraic, NumberField, exact
from osculant.cas.germs.annihilator import annihilator
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.eigenvalues import at_matrix, factors
from osculant.cas.germs.family import Family
from osculant.cas.germs.geometry import prove
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Version, group
from osculant.cas.germs.linear import echelon, inverse, null_space, product, rank, solution
from osculant.cas.germs.local_algebra import milnor_number, q_algebra
from osculant.cas.germs.radicals import extended, positive
from osculant.cas.germs.tangent import JetSpace, rows, vectors
from osculant.cas.germs.transversal import transversal
from osculant.cas.germs.unfolding import is_stable, stable_unfolding, unfolding
from osculant.cas.germs.versal import Family as Unfolded
from osculant.cas.germs.versal import versality

ROOT = NumberField.stated("a^2 - 2")


def numbers(field, count, source):
    return [
        field.of([Fraction(source.randint(-4, 4), source.randint(1, 3)) for _ in range(field.degree)])
        for _ in range(count)
    ]


@pytest.mark.parametrize("text", ["a^2 - 2", "b**3 - b - 1", "i^2 + 1", "2*x^4 - 10*x^2/3 + 5", "r^12 - 3"])
def test_arithmetic_of_a_field(text):
    field, source = NumberField.stated(text), random.Random(1)
    for _ in range(20):
        x, y, z = numbers(field, 3, source)
        assert (x + y) * z == x * z + y * z and x - y == -(y - x) and 2 * x == x + x
        assert x * y == y * x and (x * y) * z == x * (y * z) and x - x == 0
        if x:
            assert x / x == 1 and 1 / x * x == 1 and (y / x) * x == y and x**-2 * x**2 == 1
        prime, _ = field.split
        whole = [exact(v) * 36 for v in (x, y)]
        residues = [v.residue() if isinstance(v, Algebraic) else int(v) % prime for v in whole]
        both = exact(whole[0] * whole[1])
        assert (residues[0] * residues[1]) % prime == (
            both.residue() if isinstance(both, Algebraic) else int(both) % prime
        )
    assert not any(
        [sum((c * field.generator**i for i, c in enumerate(numbers_of(field.polynomial))), Fraction(0))]
    )


def numbers_of(polynomial):
    return [Fraction(int(c.p), int(c.q)) for c in polynomial.coeffs()]


def test_fields_with_roots_of_numbers():
    field = extended(extended(extended(None, 2, Fraction(2)), 3, Fraction(5)), 2, Fraction(3, 2))
    assert field.degree == 12
    for (degree, of), root in field.roots.items():
        assert root**degree == of and positive(root)
    value, start = field.real(), arb(2).sqrt() + arb(5).root(3)
    assert abs(value - start - (arb(3) / 2).sqrt()) < 1e-12
    two = extended(None, 2, Fraction(2))
    deep = extended(two, 2, two.generator + 1)
    assert deep.degree == 4 and positive(deep.generator)
    again = extended(two, 2, Fraction(8))  # no larger
    assert again.degree == 2 and again.roots[2, Fraction(8)] == 2 * again.roots[2, Fraction(2)]
    with pytest.raises(DomainError, match="degree"):
        extended(field, 2, Fraction(7))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a^2 - 4", "reducible"),
        ("a^2 + 2*a + 1", "reducible"),
        ("a - 1", "degree 1"),
        ("a^13 - 2", "degree up to 12"),
        ("a*b - 1", "one variable"),
        ("3", "one variable"),
        ("sin(a)", "one variable"),
        ("a^2 - 1/a", "rational coefficients"),
        ("a^(1/2) - 2", "rational coefficients"),
    ],
)
def test_roots_that_are_none(text, words):
    with pytest.raises(DomainError, match=words):
        NumberField.stated(text)


def test_a_root_has_a_name_of_its_own():
    with pytest.raises(DomainError, match="'a' is a source variable and the root"):
        Germ("a**2 + x", "x a", field=ROOT)
    with pytest.raises(DomainError, match="beside the stated root a"):
        Germ("a*x**2 + sqrt(3)*x", "x", field=ROOT)
    with pytest.raises(DomainError, match="irrational coefficients"):
        Family("x**2 + sqrt(2)*c*x", "x", "c")
    with pytest.raises(DomainError, match="not analytic"):
        Germ("sqrt(sqrt(2) - 2)*x", "x")
    assert Germ("sqrt(3 + 2*sqrt(2)) - 1 - sqrt(2) + x", "x").jet(1) == ({poly.variable(0, 1): 1},)
    assert Germ("cbrt(x - 2) + cbrt(2)", "x").rank == 1


def test_linear_algebra_over_a_field():
    field, source = NumberField.stated("b**3 - b - 1"), random.Random(2)
    for size in (1, 2, 3, 4):
        matrix = [numbers(field, size, source) for _ in range(size)]
        if rank(matrix, size) == size:
            assert product(matrix, inverse(matrix)) == [
                [int(i == j) for j in range(size)] for i in range(size)
            ]
        form, leading = echelon([*matrix, [a + b for a, b in zip(matrix[0], matrix[-1])]], size + 0)
        assert len(form) == len(leading) == rank(matrix, size)
        right = numbers(field, size, source)
        found = solution(matrix, right, size)
        if found is not None:
            assert [sum((a * x for a, x in zip(row, found)), Fraction(0)) for row in matrix] == right
        for vector in null_space(matrix[:-1], size):
            assert not any(sum((a * x for a, x in zip(row, vector)), Fraction(0)) for row in matrix[:-1])
        whole = [[Fraction(int(i == j)) for j in range(size)] for i in range(size)]
        for factor, count in factors(matrix):
            for _ in range(count):
                whole = product(whole, at_matrix(factor, matrix))
        assert not any(v for row in whole for v in row)  # Cayley and Hamilton


@pytest.mark.parametrize(
    ("text", "name"), [("x**3 + a*x*y**2 + y**4", "R"), ("x + a*y**2, x*y + a*y**3", "A")]
)
def test_the_annihilator_against_elimination_over_the_field(text, name):
    germ, space = Germ(text, "x y", field=ROOT), JetSpace(2, 1 if name == "R" else 2, 5)
    spanning = rows(vectors(germ, group(name), Version.ORDINARY, 5), space)
    found = annihilator(spanning, space.columns, ROOT)
    dense = [[exact(row.get(c, 0)) for c in range(space.columns)] for row in spanning]
    form, leading = echelon(dense, space.columns)
    assert found.rank == len(form) and set(found.free) == set(range(space.columns)) - set(leading)
    for functional, free in zip(found.functionals, found.free):
        assert functional[free] == 1
        for row in form:
            assert sum((v * row[c] for c, v in functional.items()), Fraction(0)) == 0


#: rational germs; a change over ℚ(√2) must not change what is told of them
RATIONAL = [
    ("x**3 + y**4", "x y", "R"),
    ("x**2*y + y**4", "x y", "K"),
    ("x**2, y**3", "x y", "C"),
    ("x, y**2", "x y", "L"),
    ("x**2, x**3", "x", "L"),
    ("x, x*y + y**4", "x y", "A"),
    ("x, y**2, y**3 + x**2*y", "x y", "A"),
    ("x**3, x**4", "x", "A"),
    ("x**2 + u**3", "x u", "R(H)"),
    ("x**2 + u**2, x*u", "x u", "K(H)"),
    ("x, u**2 + x*u", "x u", "A(H)"),
    ("x**2*y**2", "x y", "R"),
    ("x, y**3, x*y", "x y", "A"),
    ("x, x*u**2", "x u", "A(H)"),
]
INFINITE = {"x**2*y**2", "x, y**3, x*y", "x, x*u**2", "x, y**2"}


def changed(text, source, root):
    """The germ after x ↦ x + √2 y …, u ↦ (1 + √2) u."""
    names = source.split()
    if len(names) == 1:
        images = {names[0]: f"({root}*X + X**2)"}
    elif names[1] == "u":
        images = {"x": f"({root}*X - U)", "u": f"((1 + {root})*U)"}
    else:
        images = {"x": f"(X + {root}*Y)", "y": f"({root}*Y - X/2)"}
    for name, image in images.items():
        text = text.replace(name, image)
    return text.replace("X", names[0]).replace("Y", names[-1]).replace("U", names[-1])


@pytest.mark.parametrize(("text", "source", "name"), RATIONAL)
def test_a_change_over_the_field_keeps_the_answers(text, source, name):
    first = Germ(text, source)
    others = [Germ(changed(text, source, root), source) for root in ("sqrt(2)", "(-sqrt(2))")]
    others.append(Germ(changed(text, source, "a"), source, field=ROOT))
    assert (text in INFINITE) == (codimension(first, name).value == "infinite")
    for other in others:
        assert other.field is not None and other.field.degree == 2
        assert codimension(other, name).value == codimension(first, name).value
        assert codimension(other, name, extended=True).value == codimension(first, name, extended=True).value
        known, found = determinacy(first, name), determinacy(other, name)
        assert (found.degree, found.sharp) == (known.degree, known.sharp)
        if first.p == 1 and text not in INFINITE and name == "R":
            assert milnor_number(other) == milnor_number(first)
        if name == "C":
            assert q_algebra(other) == q_algebra(first)


@pytest.mark.parametrize(
    ("text", "source", "name", "value"),
    [
        ("x**2 + sqrt(2)*x*y + y**3", "x y", "R", 1),
        ("x, y**3 + sqrt(2)*x*y", "x y", "A", 0),
        ("x**4 + a*x**2*y**2 + y**4", "x y", "R", 9),  # X₉
        ("x**4 + 2*x**2*y**2 + y**4 + a*x**5", "x y", "R", 11),  # T₂₅₅: p + q + r − 1
        ("x, x*y + a*y**5 + y**7", "x y", "A", 2),
        ("x, y**2, y**3 + cbrt(2)*x**3*y", "x y", "A", 2),
        ("exp(sqrt(2)*x) - 1, sin(y)**2", "x y", "A", 0),
        ("sqrt(2 + x) - sqrt(2) + y**2", "x y", "R", 0),
        ("sqrt(2) - sqrt(2 + x**3 + y**2)", "x y", "R", 2),
    ],
)
def test_germs_with_irrational_coefficients(text, source, name, value):
    germ = Germ(text, source, field=ROOT if re.search(r"\ba\b", text) else None)
    found = codimension(germ, name, extended=True)
    assert found.value == value
    whole = unfolding(germ, name)
    assert len(whole.terms) == value
    if value:
        names = [n for n in whole.germ.source if n.startswith("t")]
        assert versality(Unfolded(whole.germ, names), name).versal
        assert not versality(Unfolded(whole.germ, names), name).missing
    if name == "A":
        assert is_stable(germ, "A") == (value == 0)


@pytest.mark.parametrize(
    ("text", "source", "name", "kind", "root"),
    [
        ("(x**2 - sqrt(2)*y**2)**2", "x y", "R", "module", None),
        ("x, x*y, sqrt(2)*y**3", "x y", "A", "multiple", None),
        ("x**2 - sqrt(2)*y**2, x*y", "x y", "A", "double", None),
        ("x, (y**2 - sqrt(2)*x - x**2)**2", "x y", "A", "multiple", None),
        ("x**3 + a*x**2*y**2 + y**6", "x y", "R", "module", "4*a^3 + 27"),
        ("x**3 + y**3 + z**3 + a*x*y*z", "x y z", "R", "module", "a^2 - 3*a + 9"),
        ("x, y**3*sqrt(3 + y)", "x y", "A", "singular", None),
        ("i*x**2, x*u**2", "x u", "K(H)", "module", "i^2 + 1"),
        ("t**2, sqrt(2)*t**4", "t", "L", "double", None),
    ],
)
def test_infinite_over_a_field(text, source, name, kind, root):
    germ = Germ(text, source, field=None if root is None else NumberField.stated(root))
    found = prove(germ, group(name))
    assert found is not None and found.locus["kind"] == kind
    assert codimension(germ, name).value == "infinite"


def test_exceptional_values_only():
    # x³ + a x² y² + y⁶ is finite but at the roots of 4a³ + 27; the Hesse pencil but at those of a³ = −27
    near = NumberField.stated("4*a^3 + 26")
    assert codimension(Germ("x**3 + a*x**2*y**2 + y**6", "x y", field=near), "R", True).value == 10
    cube = NumberField.stated("a^3 - 2")
    assert codimension(Germ("x**3 + y**3 + z**3 + a*x*y*z", "x y z", field=cube), "R", True).value == 8


def test_other_questions_over_a_field():
    germ = Germ("x**2 + sqrt(2)*x*y**2", "x y")
    assert codimension(germ, "R", True).value == 3
    assert [poly.exponents_of(m, 2) for m, _ in transversal(Germ("x**2*sqrt(2)", "x y"), 2, "R")] == [(0, 3)]
    assert stable_unfolding(Germ("sqrt(2)*x**3", "x"), "A").germ.text(3) == ("t1", "t1*x + sqrt(2)*x**3")
    frame = adapted(Germ("(x + sqrt(2)*y)**2 + (x - y)**5", "x y"), group("R"), 6)
    assert frame is not None
    assert "X = " in frame.text(Germ("(x + sqrt(2)*y)**2 + (x - y)**5", "x y"))[0]
