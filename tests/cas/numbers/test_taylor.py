"""Taylor programs against numerical differentiation, exact arithmetic and enclosures."""

from __future__ import annotations

import operator
from contextlib import suppress
from fractions import Fraction
from math import factorial

import mpmath
import pytest
import sympy
from flint import arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas.expression import FUNCTIONS, Node, call, number, power
from osculant.cas.formulas.graph import fold
from osculant.cas.formulas.parser import parse, parse_tuple
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.numbers import recurrences
from osculant.cas.numbers.balls import ball, precision
from osculant.cas.numbers.fields import Balls, ExactNumbers, Multiprecision
from osculant.cas.numbers.taylor import program
from tests.cas.numbers.rationals import Rationals
from tests.graphs import built, formulas, rationals, t

ORDER = 8


class ExcessiveError(Exception):
    """A tower of exponentials, which mpmath would compute to the end."""


def value(node, at):
    """The value of a formula in mpmath, without Taylor arithmetic; NaN outside the domain."""

    def rule(node, args):
        match node.kind:
            case "number":
                result = mpmath.mpf(node.value.numerator) / node.value.denominator
            case "pi" | "e":
                result = +getattr(mpmath, node.kind)
            case "variable":
                result = at
            case "add" | "sub" | "mul" | "div":
                result = OPERATIONS[node.kind](*args) if node.kind != "div" or args[1] else mpmath.nan
            case "neg":
                result = -args[0]
            case "pow":
                exponent = mpmath.mpf(node.value.numerator) / node.value.denominator
                result = args[0] ** exponent if args[0] or exponent > 0 else mpmath.nan
            case _:
                functions = {"cbrt": lambda x: mpmath.sign(x) * mpmath.cbrt(abs(x)), "abs": abs}
                result = (functions.get(node.value) or getattr(mpmath, node.value))(args[0])
        if isinstance(result, mpmath.mpc) or not mpmath.isfinite(result):
            return mpmath.nan
        if abs(result) > 1e100:
            raise ExcessiveError
        return result

    return fold([node], rule)[0]


OPERATIONS = {"add": operator.add, "sub": operator.sub, "mul": operator.mul, "div": operator.truediv}


def derivatives(node, at, order):
    """Derivatives by differences over about 1e-60."""
    return list(mpmath.diffs(lambda x: value(node, x), at, order))


def agrees(node, at, order=ORDER):
    """Whether the program's derivatives are those by differences, to 25 of 50 digits."""
    with mpmath.workdps(50):
        at = mpmath.mpf(at)
        [got] = program([node], order).run(at, Multiprecision())
        expected = derivatives(node, at, order)
        size = mpmath.mpf(0)
        for a, b in zip(got, expected, strict=True):
            size = max(size, abs(b))
            if not abs(a - b) <= mpmath.mpf(10) ** -25 * (abs(b) + mpmath.mpf(10) ** -15 * size):
                return False
    return True


# Every function, also next to where it ends.

POINTS = [
    *(("sin", "0.7"), ("sin", "1e-12"), ("cos", "-2.1"), ("cos", "1e5"), ("tan", "1.5707963"), ("tan", "-1")),
    *(("asin", "0.3"), ("asin", "0.999999999"), ("acos", "-0.999999999"), ("acos", "0.2"), ("atan", "1e8")),
    *(("atan", "-0.4"), ("sinh", "0.5"), ("sinh", "-20"), ("cosh", "1e-9"), ("cosh", "3"), ("tanh", "0.1")),
    *(
        ("tanh", "18"),
        ("tanh", "-300"),
        ("asinh", "-1e-9"),
        ("asinh", "7"),
        ("acosh", "1.000000001"),
        ("acosh", "5"),
    ),
    *(("atanh", "-0.999999"), ("atanh", "0.25"), ("exp", "-30"), ("exp", "1.5"), ("log", "1e-12")),
    *(("log", "40"), ("sqrt", "1e-14"), ("sqrt", "2"), ("cbrt", "-1e-9"), ("cbrt", "-8.5"), ("cbrt", "3")),
    *(("abs", "-0.3"), ("abs", "1e-20")),
]


def composed(name, at):
    """f of a cubic that takes the value ``at`` at t = 0, so that all inner coefficients matter."""
    return call(name, parse(at) + t / 3 - t**2 + t**3 / 5)


@pytest.mark.parametrize(("name", "at"), POINTS)
def test_functions(name, at):
    assert agrees(composed(name, at), 0)


def test_every_function_is_among_them():
    assert {name for name, _ in POINTS} == FUNCTIONS


WRONG = {
    "sinh": lambda w, a: w.paired(a, ("sinh", "cosh"), -1)[0],
    "cos": lambda w, a: w.paired(a, ("sin", "cos"), 1)[1],
    "tan": recurrences._tanh,
    "tanh": recurrences._tan,
    "atan": recurrences._RULES["atanh"],
    "acos": lambda w, a: w.inverse_function("acos", a, recurrences._inverse_root(w, a, w.one_plus(a, -1))),
    "acosh": lambda w, a: w.inverse_function("acosh", a, recurrences._inverse_root(w, a, w.one_plus(a, 1))),
    "cbrt": lambda w, a: w.powered(a, Fraction(2, 3), w.call("cbrt", a[0])),
    "log": lambda w, a: w.inverse_function("log", a, w.quotient(a, a)),
    "exp": lambda w, a: w.integral(w.call("exp", a[0]), a, lambda k, y: y[0]),
    "abs": lambda w, a: a,
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_recurrence_is_noticed(name, monkeypatch):
    at = next(at for f, at in POINTS if f == name)
    assert agrees(composed(name, at), 0)
    monkeypatch.setitem(recurrences._RULES, name, WRONG[name])
    assert not agrees(composed(name, at), 0)


EXPONENTS = [2, 3, 7, 10, -1, -2, -5, *map(Fraction, ("1/2", "-1/2", "3/2", "2/3", "-5/3", "5/4", "-1/7"))]


@pytest.mark.parametrize("exponent", EXPONENTS, ids=str)
@pytest.mark.parametrize("base", ["0.3", "1e-9", "250", "-0.7"])
def test_powers(exponent, base):
    raised = power(parse(base) + t / 3 - t**2, number(exponent))
    if parse(base).value < 0 and Fraction(exponent).denominator > 1:
        [values] = program([raised], ORDER).run(mpmath.mpf(0), Multiprecision())
        assert all(mpmath.isnan(x) for x in values)
    else:
        assert agrees(raised, 0)


def test_a_root_at_zero_has_a_value_and_no_derivative():
    for text in ("sqrt(t)", "t^(2/3)", "cbrt(t)"):
        with precision(100):
            at_zero, slope = program([parse(text)], 1).run(arb(0), Balls())[0]
        assert at_zero == 0
        assert not slope.is_finite()


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_against_symbolic_derivatives(name):
    x = sympy.Symbol("x", positive=True)
    outer = {"abs": sympy.Abs, "cbrt": lambda u: u ** sympy.Rational(1, 3)}.get(name) or getattr(sympy, name)
    inner = x / 3 + 1 if name == "acosh" else x / 3
    node = call(name, t / 3 + 1 if name == "acosh" else t / 3)
    with mpmath.workdps(50):
        [got] = program([node], 5).run(mpmath.mpf(2) / 7, Multiprecision())
        for k, number_ in enumerate(got):
            symbolic = sympy.diff(outer(inner), x, k).subs(x, sympy.Rational(2, 7))
            assert abs(number_ - mpmath.mpf(sympy.N(symbolic, 50))) < mpmath.mpf(10) ** -40


# Random formulas.


@given(formulas, rationals)
@settings(max_examples=120, deadline=None)
def test_random_formulas(node, at):
    """Where the differences of two precisions agree, the program agrees with them."""
    with mpmath.workdps(50):
        point = mpmath.mpf(at.numerator) / at.denominator
        try:
            expected = derivatives(node, point, 4)
            with mpmath.workdps(80):
                finer = derivatives(node, mpmath.mpf(at.numerator) / at.denominator, 4)
        except ExcessiveError:
            assume(False)
        size = max(map(abs, finer)) + mpmath.mpf(10) ** -5
        assume(all(abs(a - b) < mpmath.mpf(10) ** -32 * size for a, b in zip(expected, finer)))
        try:
            [got] = program([node], 4).run(point, Multiprecision())
        except ZeroDivisionError:  # a removable singularity: sqrt(u)**2 at u = 0, an even power of cbrt
            assume(False)
        assume(not any(map(mpmath.isnan, got)))
        assert all(abs(a - b) < mpmath.mpf(10) ** -25 * size for a, b in zip(got, finer))


OUTSIDE = {
    "log": lambda u: call("log", -1 - u**2),
    "sqrt": lambda u: call("sqrt", -1 - u**2),
    "power": lambda u: power(-1 - u**2, number(Fraction(-2, 3))),
    "asin": lambda u: call("asin", 2 + u**2),
    "acos": lambda u: call("acos", -2 - u**2),
    "acosh": lambda u: call("acosh", -(u**2)),
    "atanh": lambda u: call("atanh", 2 + u**2),
    "division": lambda u: u / (u - u),
}


@given(st.sampled_from(sorted(OUTSIDE)), formulas, formulas, rationals)
@settings(max_examples=100, deadline=None)
def test_outside_the_domain_there_is_no_value(kind, inner, outer, at):
    """The protocol's "NaN or raise", also if the rest of the formula is harmless."""
    node = outer + OUTSIDE[kind](inner + t)
    with mpmath.workdps(50):
        point = mpmath.mpf(at.numerator) / at.denominator
        try:
            assert mpmath.isnan(value(node, point))
        except ExcessiveError:
            assume(False)
        with suppress(ZeroDivisionError):
            [[first]] = program([node], 0).run(point, Multiprecision())
            assert not mpmath.isfinite(first)


@given(formulas, rationals, st.integers(0, 30), st.fractions(0, 1, max_denominator=64))
@settings(max_examples=200, deadline=None)
def test_balls_enclose(node, low, halvings, share):
    """Over an interval the balls hold the derivatives at any point in it."""
    width = Fraction(3) / 2**halvings
    inner = low + share * width
    with mpmath.workdps(50), precision(160):
        whole = ball(exact_ball(low), exact_ball(low + width))
        point = mpmath.mpf(inner.numerator) / inner.denominator
        try:
            value(node, point)
            [got] = program([node], 4).run(point, Multiprecision())
        except (ExcessiveError, ZeroDivisionError):
            assume(False)
        [enclosures] = program([node], 4).run(whole, Balls())
        for x, enclosure in zip(got, enclosures, strict=True):
            if enclosure.is_finite() and mpmath.isfinite(x):
                assert enclosure.overlaps(rounded(x))


def exact_ball(q):
    return arb(q.numerator) / q.denominator


def rounded(x):
    """A ball around an mpmath number that has lost some of its 50 digits."""
    return arb(mpmath.nstr(x, 45), mpmath.nstr(abs(x) * mpmath.mpf(10) ** -20 + mpmath.mpf(10) ** -35, 5))


def test_enclosures_are_worth_something():
    formula = parse("sin(t)^2/(1 + t^2) + cbrt(t - 3) + t^(2/3)*exp(-t) + atan(tan(t/2)) + abs(t - 9)")
    with mpmath.workdps(50), precision(160):
        [got] = program([formula], 4).run(mpmath.mpf(2), Multiprecision())
        for enclosure, x in zip(program([formula], 4).run(ball(1.999, 2.001), Balls())[0], got):
            assert enclosure.overlaps(rounded(x))
            assert not enclosure.overlaps(rounded(x + 3))
        exact = program([formula], 4).run(arb(2), Balls())[0]
        assert all(c.rel_accuracy_bits() > 100 for c in exact)


def test_balls_know_no_value_where_there_may_be_none():
    functions = "log(t)", "asin(2*t)", "acosh(2*t)", "atanh(1.1*t)", "tan(3*t)"
    for text in ("sqrt(t - 1/2)", "1/(t - 1/2)", "(t - 1/2)^(-2/3)", *functions):
        with precision(100):
            first = program([parse(text)], 0).run(ball(0, 1), Balls())[0][0]
        assert not first.is_finite(), text


# The fields of numbers agree.

polynomials = st.recursive(
    st.one_of(st.just(t), rationals.map(number)),
    lambda parts: st.builds(
        built, st.sampled_from([Node.__add__, Node.__sub__, Node.__mul__, Node.__truediv__]), parts, parts
    ),
    max_leaves=10,
)


@given(polynomials, rationals)
@settings(max_examples=100, deadline=None)
def test_rational_functions_in_every_field(node, at):
    compiled = program([node], 4)
    try:
        [exact] = compiled.run(at, Rationals())
    except ZeroDivisionError:
        with precision(200):
            assert not all(x.is_finite() for x in compiled.trace(exact_ball(at), Balls()))
        return
    [symbolic] = compiled.run(sympy.Rational(at.numerator, at.denominator), ExactNumbers())
    with precision(200), mpmath.workdps(60):
        [balls] = compiled.run(exact_ball(at), Balls())
        [floats] = compiled.run(mpmath.mpf(at.numerator) / at.denominator, Multiprecision())
        for q, s, b, f in zip(exact, symbolic, balls, floats, strict=True):
            assert Fraction(int(s.p), int(s.q)) == q
            assert b.contains(exact_ball(q).mid()) or b.overlaps(exact_ball(q))
            assert abs(f - mpmath.mpf(q.numerator) / q.denominator) <= mpmath.mpf(10) ** -35 * (1 + abs(f))


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_elementary_functions_in_every_field(name):
    compiled = program([call(name, t + 2 if name == "acosh" else t)], 4)
    at = Fraction(-1, 3) if name not in {"log", "sqrt"} else Fraction(1, 3)
    [symbolic] = compiled.run(sympy.Rational(at.numerator, at.denominator), ExactNumbers())
    with precision(200), mpmath.workdps(60):
        [balls] = compiled.run(exact_ball(at), Balls())
        [floats] = compiled.run(mpmath.mpf(at.numerator) / at.denominator, Multiprecision())
        for s, b, f in zip(symbolic, balls, floats, strict=True):
            assert abs(mpmath.mpf(sympy.N(s, 60)) - f) < mpmath.mpf(10) ** -50
            assert b.overlaps(rounded(f))
            assert b.rel_accuracy_bits() > 150 or b == 0


def test_exact_numbers_are_exact():
    [values] = program([parse("sin(t)*cbrt(-2)^3")], 2).run(sympy.pi / 6, ExactNumbers())
    assert values == [-1, -sympy.sqrt(3), 1]


def test_the_absolute_value_has_no_derivative_at_zero():
    compiled = program([parse("abs(t)")], 1)
    assert mpmath.isnan(compiled.run(mpmath.mpf(0), Multiprecision())[0][1])
    assert compiled.run(sympy.Integer(0), ExactNumbers())[0][1] is sympy.nan
    assert compiled.run(arb(0), Balls())[0][1].is_nan()


def test_rationals_refuse_what_is_not_rational():
    for text in ("pi*t", "sin(t)", "t^(1/2)", "t^(1/3)"):
        with pytest.raises(DomainError, match="rational"):
            program([parse(text)], 2).run(Fraction(1, 4), Rationals())


# What a program is.


def nested(depth):
    node = t
    for _ in range(depth):
        node = call("sin", node)
    return node


def test_nested_sines_do_not_swell():
    lengths = {depth: len(program([nested(depth)], 5).instructions) for depth in (10, 20, 30)}
    assert lengths[30] < 3000
    assert lengths[30] - lengths[20] == lengths[20] - lengths[10]  # linear in the formula
    orders = [len(program([nested(30)], order).instructions) for order in (8, 16)]
    assert orders[0] < 6000
    assert orders[1] < 4.5 * orders[0]  # quadratic in the order
    assert agrees(nested(30), "0.8", 5)


def test_shared_parts_are_written_once():
    node = t + 1
    for _ in range(40):
        node = node * node + call("cos", node)
    assert len(program([node], 3).instructions) < 40 * 60  # as a tree it has 2^40 leaves
    both = program([nested(30), call("cos", nested(29))], 5)
    assert len(both.instructions) < len(program([nested(30)], 5).instructions) + 20


def test_a_high_power_takes_few_products():
    assert len(program([t**1000], 5).instructions) < 600
    assert agrees(t**1000, "1.01")


@given(formulas)
@settings(max_examples=100, deadline=None)
def test_programs_are_straight_lines_without_waste(node):
    compiled = program([node, t * node], 3)
    assert len(set(compiled.instructions)) == len(compiled.instructions)
    used = {index for output in compiled.outputs for index in output}
    for place, step in enumerate(compiled.instructions):
        assert all(arg < place for arg in step.args)
        used.update(step.args)
    assert used == set(range(len(compiled.instructions)))


def test_normalised_coefficients():
    formula = parse("exp(2*t)/t")
    with mpmath.workdps(30):
        [plain] = program([formula], 6).run(mpmath.mpf(3), Multiprecision())
        [normal] = program([formula], 6, normalised=True).run(mpmath.mpf(3), Multiprecision())
        assert all(abs(p - factorial(k) * c) < 1e-24 * abs(p) for k, (p, c) in enumerate(zip(plain, normal)))


def test_another_variable_is_an_error():
    with pytest.raises(FormulaError, match=r"'s'; only 't'"):
        program([parse("t + s", ("s", "t"))], 2)
    assert program([parse("s^2", ("s",))], 2, "s").run(Fraction(3), Rationals()) == [[9, 6, 2]]


def test_a_program_takes_its_numbers_at_the_precision_of_each_run():
    compiled = program([parse("t/3 + pi")], 0)
    with precision(64):
        coarse = compiled.run(arb(1), Balls())[0][0]
    with precision(320):
        fine = compiled.run(arb(1), Balls())[0][0]
        exact = arb(1) / 3 + arb.pi()
        assert fine.overlaps(exact) and fine.rad() < 1e-90
        assert coarse.contains(exact) and coarse.rad() > 1e-25
    with precision(64):
        assert compiled.run(arb(1), Balls())[0][0].rad() == coarse.rad()
    with mpmath.workdps(40):
        assert (
            abs(compiled.run(mpmath.mpf(1), Multiprecision())[0][0] - (mpmath.mpf(1) / 3 + mpmath.pi)) < 1e-38
        )


@pytest.mark.parametrize("text", ["t*cos(t), t^2*sin(t)/7", "t, exp(t)/(1+t^2)", "sqrt(t), atan(3*t)"])
def test_a_program_of_low_order_is_part_of_one_of_high_order(text):
    alone, after = CurveBalls(parse_tuple(text)), CurveBalls(parse_tuple(text))
    after.program(8)
    with precision(320):
        for order in (0, 1, 2, 5):
            one, other = (curve.coefficients(arb("1.3"), order) for curve in (alone, after))
            assert [len(row) for row in other] == [order + 1] * 2
            pairs = [pair for rows in zip(one, other, strict=True) for pair in zip(*rows, strict=True)]
            assert all(p.mid() == q.mid() and p.rad() == q.rad() for p, q in pairs)
            assert len(after.program(order).instructions) == len(alone.program(order).instructions)
