"""The expression graph: one node per expression, exact bounded folding, conversions that keep the value."""

from __future__ import annotations

import copy
import gc
import pickle
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import Any

import mpmath
import pytest
import symengine
import sympy
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas.expression import (
    FUNCTIONS,
    ONE,
    PI,
    ZERO,
    E,
    Node,
    call,
    neg,
    number,
    power,
    to_text,
    variable,
)
from osculant.cas.formulas.graph import fold, topological, variables
from osculant.cas.formulas.parser import parse
from osculant.cas.formulas.rationals import BITS, decimal, exact_root
from osculant.cas.formulas.sympy_bridge import cbrt, from_sympy, to_sympy

s, t = variable("s"), variable("t")
HALF = Fraction(1, 2)
POINT = {"s": mpmath.mpf("0.8125"), "t": mpmath.mpf("-0.40625")}


# --- random expressions, and their values computed without any of the code under test ---------------------

rationals = st.fractions(min_value=-9, max_value=9, max_denominator=12)
leaves = st.one_of(rationals.map(number), st.sampled_from([PI, E, s, t]))
exponents = st.one_of(st.integers(-4, 5).map(Fraction), st.fractions(-3, 3, max_denominator=4))


def combine(parts: st.SearchStrategy[Node]) -> st.SearchStrategy[Node]:
    def build(rule: Callable[..., Node], *args: Any) -> Node:
        try:
            return rule(*args)
        except (DomainError, FormulaError):  # such as log(-1): no expression
            return next(part for part in args if isinstance(part, Node))

    binary = st.sampled_from([Node.__add__, Node.__sub__, Node.__mul__, Node.__truediv__, power])
    return st.one_of(
        st.builds(build, binary, parts, parts),
        st.builds(build, st.just(power), parts, exponents.map(number)),
        st.builds(build, st.just(neg), parts),
        st.builds(build, st.just(call), st.sampled_from(sorted(FUNCTIONS)), parts),
    )


expressions = st.recursive(leaves, combine, max_leaves=12)


class UndefinedError(Exception):
    """The expression has no real value of reasonable size at the point."""


def real_cbrt(x: Any) -> Any:
    return mpmath.sign(x) * mpmath.cbrt(abs(x))


def value(node: Node, digits: int, limit: float = 1e30) -> Any:
    def rule(node: Node, args: list[Any]) -> Any:
        match node.kind:
            case "number":
                result = mpmath.mpf(node.value.numerator) / node.value.denominator
            case "pi":
                result = +mpmath.pi
            case "e":
                result = +mpmath.e
            case "variable":
                result = POINT[node.value]
            case "add":
                result = args[0] + args[1]
            case "sub":
                result = args[0] - args[1]
            case "mul":
                result = args[0] * args[1]
            case "div":
                result = args[0] / args[1]
            case "neg":
                result = -args[0]
            case "pow":
                result = args[0] ** (mpmath.mpf(node.value.numerator) / node.value.denominator)
            case _:
                functions = {"cbrt": real_cbrt, "abs": abs}
                result = (functions.get(node.value) or getattr(mpmath, node.value))(args[0])
        if isinstance(result, mpmath.mpc) or (result and not 1 / limit < abs(result) < limit):
            raise UndefinedError  # among the excessive are towers of exponentials
        return result

    with mpmath.workdps(digits):
        try:
            return fold([node], rule)[0]
        except (ZeroDivisionError, ValueError, OverflowError):
            raise UndefinedError from None


def stable_value(node: Node) -> Any:
    """The value to about 30 digits; examples without one, or close to a singularity, are passed over."""
    try:
        low, high = value(node, 50), value(node, 90)
    except UndefinedError:
        assume(False)
    assume(abs(low - high) <= mpmath.mpf(10) ** -40 * (1 + abs(high)) and abs(high) < 10**6)
    return high


def close(a: Any, b: Any) -> bool:
    return bool(abs(a - b) <= mpmath.mpf(10) ** -25 * (1 + abs(b)))


def near(node: Node, reference: Any) -> bool:
    return close(value(node, 90, limit=1e300), reference)


# --- one node per expression ------------------------------------------------------------------------------


def test_equal_expressions_are_one_node() -> None:
    assert (s + t) * 2 is (s + t) * Fraction(4, 2)
    assert s + t is not t + s
    assert len({s + 1, s + 1, 1 + s}) == 2


def test_operators_take_exact_numbers_only() -> None:
    assert (
        1 - t is number(1) - t
        and 1 / t is ONE / t
        and 2**t is power(number(2), t)
        and HALF * t is t.__rmul__(HALF)
    )
    assert +t is t and abs(t) is call("abs", t) and -t is neg(t)
    for operand in (0.5, "t", None):
        with pytest.raises(TypeError):
            t + operand  # type: ignore[operator]
        with pytest.raises(TypeError):
            operand / t  # type: ignore[operator]


def test_nodes_are_immutable_and_survive_copies() -> None:
    node = call("sin", t**3) / 7
    with pytest.raises(AttributeError):
        node.kind = "add"
    with pytest.raises(AttributeError):
        del node.args
    assert pickle.loads(pickle.dumps(node)) is node
    assert copy.copy(node) is node and copy.deepcopy(node) is node


def test_unused_nodes_are_forgotten() -> None:
    from osculant.cas.formulas import expression

    gc.collect()
    before = len(expression._table)
    kept = variable("only_here") + 1
    assert len(expression._table) == before + 2
    del kept
    gc.collect()
    assert len(expression._table) == before


def test_threads_agree_on_nodes() -> None:
    def build(_: int) -> list[Node]:
        return [call("sin", t + n) for n in range(300)]

    with ThreadPoolExecutor(4) as pool:
        first, *others = pool.map(build, range(4))
    assert all(a is b for other in others for a, b in zip(first, other, strict=True))


def test_deep_graphs_need_no_recursion() -> None:
    node = t
    for _ in range(20 * sys.getrecursionlimit()):
        node = call("sin", node) + 1
    order = topological([node])
    assert order[0] is t and order[-1] is node and len(order) == 40 * sys.getrecursionlimit() + 2
    assert variables([node]) == {"t"}
    assert to_text(node).startswith("sin(sin(")
    del order, node  # freed without recursion too


def test_text_of_shared_parts_is_bounded() -> None:
    node = t
    for _ in range(200):
        node = node * node
    with pytest.raises(FormulaError, match="characters"):
        to_text(node)
    assert repr(node) == "<a large mul node>" and repr(t + 1) == "Node('t + 1')"


@settings(max_examples=50, deadline=None)
@given(st.lists(expressions, max_size=4))
def test_topological_puts_arguments_first_and_nothing_twice(roots: list[Node]) -> None:
    order = topological(roots)
    place = {node: i for i, node in enumerate(order)}
    assert len(place) == len(order) and set(roots) <= set(order)
    assert all(place[argument] < i for node, i in place.items() for argument in node.args)


# --- folding ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("node", "expected"),
    [
        (t + 0, "t"),
        (0 + t, "t"),
        (t - 0, "t"),
        (0 - t, "-t"),
        (t * 1, "t"),
        (1 * t, "t"),
        (t * 0, "0"),
        (-1 * t, "-t"),
        (t / 1, "t"),
        (t / -1, "-t"),
        (neg(-t), "t"),
        (t**0, "1"),
        (t**1, "t"),
        ((t**2) ** 3, "t**6"),
        ((t**-2) ** HALF, "sqrt(t**(-2))"),
        ((t**HALF) ** 2, "sqrt(t)**2"),  # only for t >= 0, so it is not t
        (number(12) ** HALF, "sqrt(12)"),
        ((number(2) ** HALF) ** 4, "4"),
        (number(Fraction(4, 9)) ** Fraction(-3, 2), "27/8"),
        (number(-2) ** 3, "-8"),
        (number(0) ** HALF, "0"),
        (number(-1) ** (2**4000 + 1), "-1"),
        (E**2, "exp(2)"),
        (E**t, "exp(t)"),
        (E**1, "e"),
        (2**t, "exp(t*log(2))"),
        (t**PI, "exp(pi*log(t))"),
        (call("ln", t), "log(t)"),
        (call("arcosh", t), "acosh(t)"),
        (call("arctan", t), "atan(t)"),
        (call("coth", t), "1/tanh(t)"),
        (call("sqrt", t), "sqrt(t)"),
        (call("cbrt", number(Fraction(-27, 8))), "-3/2"),
        (call("cbrt", number(2)), "cbrt(2)"),
        (call("abs", number(-2)), "2"),
    ],
)
def test_folding(node: Node, expected: str) -> None:
    assert to_text(node) == expected


@pytest.mark.parametrize(
    "make",
    [
        lambda: t / 0,
        lambda: number(0) ** -1,
        lambda: number(0) ** Fraction(-1, 2),
        lambda: number(-8) ** Fraction(1, 3),
        lambda: call("log", ZERO),
        lambda: call("log", number(-1)),
        lambda: call("asin", number(2)),
        lambda: call("acos", number(-2)),
        lambda: call("acosh", number(HALF)),
        lambda: call("atanh", ONE),
        lambda: call("sin", t) / (t * 0),
    ],
)
def test_what_does_not_exist_is_a_domain_error(make: Any) -> None:
    with pytest.raises(DomainError):
        make()


HUGE = 2 ** (BITS - 1)


@pytest.mark.parametrize(
    "make",
    [
        lambda: number(2 * HUGE),
        lambda: number(Fraction(1, 2 * HUGE)),
        lambda: number(HUGE) + HUGE,
        lambda: number(HUGE) * 2,
        lambda: number(1) / HUGE / HUGE,
        lambda: number(3) ** HUGE,
        lambda: number(Fraction(3, 2)) ** -HUGE,
        lambda: number(2) ** (HUGE + HALF),
        lambda: (number(2) ** HALF) ** HUGE,
        lambda: (t**HUGE) ** 2,
        lambda: decimal("1e99999999999999999999"),
        lambda: decimal("1e-1300"),
        lambda: decimal("1" * 2000),
    ],
)
def test_numbers_are_bounded_before_they_are_computed(make: Any) -> None:
    with pytest.raises(FormulaError, match="bits"):
        make()


@pytest.mark.parametrize("name", ["", "1x", "_x", "x y", "x'", "θ", "pi", "e", "sin", "ln", "sec", "x\n"])
def test_names_of_variables(name: str) -> None:
    with pytest.raises(FormulaError):
        variable(name)


def test_unknown_function() -> None:
    with pytest.raises(FormulaError, match="gamma"):
        call("gamma", t)


@settings(deadline=None)
@given(st.fractions(), st.integers(1, 60))
def test_exact_roots(q: Fraction, degree: int) -> None:
    assume(q >= 0 or degree % 2)
    assert exact_root(q**degree, degree) == q
    if q not in (-1, 0, 1) and degree > 1:
        assert exact_root(q**degree * 2, degree) is None
    if degree % 2 == 0 and q:
        assert exact_root(-(q**degree), degree) is None


@settings(deadline=None)
@given(st.decimals(allow_nan=False, allow_infinity=False, places=12))
def test_decimals_are_exact(x: Any) -> None:
    assert decimal(str(x)) == Fraction(str(x))


@pytest.mark.parametrize("text", ["", ".", "e5", "1_0", "0x10", "nan", "inf", "1e", " 1", "١"])
def test_what_is_no_decimal(text: str) -> None:
    with pytest.raises(FormulaError):
        decimal(text)


# --- text and sympy ---------------------------------------------------------------------------------------


@settings(max_examples=300, deadline=None)
@given(expressions)
@example((t * number(Fraction(1, 3))) / (s / t) - (s - t) - neg(t * s) ** 2)
@example(number(Fraction(-1, 3)) * t - number(-2) + number(Fraction(-1, 3)))
def test_text_is_read_back_as_the_same_node(node: Node) -> None:
    assert parse(to_text(node), ("s", "t")) is node


@settings(max_examples=150, deadline=None)
@given(expressions)
@example(parse("abs(exp(exp(s*log(s))*log(pi)))", ("s",)))  # sympy makes real parts and arguments of it
def test_sympy_has_the_same_value_and_returns_it(node: Node) -> None:
    expected = stable_value(node)
    expression = to_sympy(node)
    with mpmath.workdps(90):
        function = sympy.lambdify(sympy.symbols("s t", real=True), expression, "mpmath")
        assert close(function(*POINT.values()), expected)
    assert near(from_sympy(expression), expected)


@settings(max_examples=80, deadline=None)
@given(expressions)
def test_symengine_expressions_are_read(node: Node) -> None:
    assume(not any(part.value == "cbrt" for part in topological([node])))
    expected = stable_value(node)
    assert near(from_sympy(symengine.sympify(to_sympy(node))), expected)


def test_sympy_symbols() -> None:
    assert to_sympy(s + t).free_symbols == set(sympy.symbols("s t", real=True))
    x = sympy.Symbol("x", positive=True)
    assert to_sympy(t**2, {"t": x}) == x**2
    assert from_sympy(x**2) is variable("x") ** 2


def test_what_from_sympy_reads() -> None:
    x = sympy.Symbol("t")
    assert from_sympy(3) is number(3) and from_sympy(HALF) is number(HALF) and from_sympy(t) is t
    assert from_sympy(0.1) is number(Fraction(1, 10)) and from_sympy(1e-300).value == Fraction(10) ** -300
    assert from_sympy(sympy.Float("0.1", 40)).value == Fraction(1, 10)
    assert from_sympy(symengine.RealDouble(0.3)).value == Fraction(3, 10)
    assert to_text(from_sympy(1 - 2 * x / (x + 1))) in ("1 - 2*t/(1 + t)", "1 - 2*t/(t + 1)")
    assert to_text(from_sympy(abs(sympy.Symbol("t", real=True)).diff())) == "t/abs(t)"
    assert from_sympy(sympy.exp(2 * x) * sympy.sec(x)) is call("exp", 2 * t) * (1 / call("cos", t))


@pytest.mark.parametrize(
    "given",
    [
        "t",
        None,
        b"t",
        sympy.I,
        sympy.zoo,
        sympy.nan,
        sympy.oo,
        float("inf"),
        float("nan"),
        sympy.gamma(sympy.Symbol("t")),
        sympy.Function("f")(sympy.Symbol("t")),
        sympy.Integral(sympy.Symbol("t")),
        sympy.Symbol("t") < 1,
        sympy.Matrix([1]),
        sympy.Symbol("no name"),
        sympy.Float("1e99999"),
        sympy.Integer(10) ** 2000,
        sympy.Piecewise((1, sympy.Symbol("t") < 1), (2, True)),
    ],
)
def test_what_from_sympy_refuses(given: Any) -> None:
    with pytest.raises(FormulaError):
        from_sympy(given)


@pytest.mark.parametrize("text", ["1/(t - t)", "sqrt(-t^2)", "log(-pi)", "log(t - t)"])
def test_nowhere_defined(text: str) -> None:
    with pytest.raises(DomainError):
        to_sympy(parse(text))


@pytest.mark.parametrize(
    "text",
    [
        "abs(exp(exp(exp(100))) - 1)",
        "pi^(10^1000)",
        "e^-e^e^e^e^e",
        "(10^1000 + 3)^(3/7)",
        "sqrt(exp(1e100) - 1)",
    ],
)
def test_constants_that_sympy_would_choke_on(text: str) -> None:
    with pytest.raises(FormulaError):
        to_sympy(parse(text))


# --- the real cube root in sympy --------------------------------------------------------------------------


def test_real_cube_root() -> None:
    x = sympy.Symbol("x", real=True)
    assert cbrt(sympy.Rational(-27, 8)) == sympy.Rational(-3, 2) and cbrt(0) == 0
    assert cbrt(2).is_positive and cbrt(-2).is_negative and cbrt(x).is_real
    assert cbrt(-x) == -cbrt(x)
    assert cbrt(x**2).diff(x) == 2 * x / (3 * cbrt(x**2) ** 2)
    assert sympy.latex(cbrt(x + 1)) == r"\sqrt[3]{x + 1}"
    assert sympy.latex(cbrt(x) ** 2) == r"\left(\sqrt[3]{x}\right)^{2}"
    digits = cbrt(-sympy.pi).evalf(60)
    assert abs(digits**3 + sympy.pi.evalf(60)) < sympy.Float(10) ** -57
    assert sympy.lambdify(x, cbrt(x), "math")(-8.0) == pytest.approx(-2)
    assert sympy.lambdify(x, cbrt(x), "numpy")(-8.0) == pytest.approx(-2)
    assert from_sympy(cbrt(x)) is call("cbrt", variable("x"))
