"""The only reader of formulas: text in, an expression or a FormulaError out, and nothing ever executed.

The grammar, in EBNF, with blanks (spaces, tabs, line ends) allowed between any two tokens:

    tuple      = list | "(" list ")"
    list       = expression { "," expression }
    expression = term { ("+" | "-") term }
    term       = factor { ("*" | "/") factor }
    factor     = ("+" | "-") factor | power
    power      = operand [ ("**" | "^") factor ]
    operand    = number | name | function "(" expression ")" | "(" expression ")"
    number     = (digits [ "." [ digits ] ] | "." digits) [ ("e" | "E") [ "+" | "-" ] digits ]
    name       = "pi" | "e" | one of the variables
    function   = sin cos tan sec csc cot asin acos atan sinh cosh tanh sech csch coth asinh acosh atanh
                 exp log sqrt cbrt abs, or an alias: ln, arcsin, arccos, arctan, arsinh, arcosh, artanh,
                 arcsinh, arccosh, arctanh

So -t^2 is -(t^2), t^2^3 is t^(2^3), 2^-t is 2^(-t), and there is no multiplication without a sign. Numbers
are exact rationals (0.1 is 1/10); cbrt is the real cube root, every other root wants a base >= 0.
Limits: 4096 characters, ASCII, 64 nested parentheses and exponents, 2000 nodes, numbers of 4096 bits; a
file may hold more (`FILE`).
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeVar

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas import expression as ex
from osculant.cas.formulas.expression import Node
from osculant.cas.formulas.graph import topological
from osculant.cas.formulas.rationals import decimal

Result = TypeVar("Result")
CHARACTERS = 4096
DEPTH = 64
NODES = 2000
WINDOW = 72  # characters of a long text shown in a message

_TOKEN = re.compile(
    r"(?P<number>(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)"
    r"|(?P<name>[A-Za-z][A-Za-z0-9_]*)"
    r"|(?P<sign>\*\*|[-+*/^(),])"
    r"|(?P<blank>[ \t\r\n]+)"
)
_HINTS = {
    "=": "give the expression alone, without '='",
    "_": "digits are not grouped and names begin with a letter",
    "'": "text in quotes is no formula",
    '"': "text in quotes is no formula",
    ".": "a point belongs to a number, as in 0.5",
    "[": "use round parentheses",
    "]": "use round parentheses",
    "{": "use round parentheses",
    "}": "use round parentheses",
    "|": "write abs(...)",
    ";": "separate coordinates by commas",
    "π": "write pi",
    "·": "write *",
    "×": "write *",
    "−": "write -",
    "²": "write ^2",
    "³": "write ^3",
    "√": "write sqrt(...)",
}
# Binding strengths of the grammar's levels; a sign in front binds between product and power.
_SUM, _PRODUCT, _FACTOR, _POWER = range(1, 5)
_BINDING = {"+": _SUM, "-": _SUM, "*": _PRODUCT, "/": _PRODUCT, "**": _POWER, "^": _POWER}
_OPERATIONS = {"+": ex.add, "-": ex.sub, "*": ex.mul, "/": ex.div, "**": ex.power, "^": ex.power}
_CONSTANTS = {"pi": ex.PI, "e": ex.E}


class Limits(NamedTuple):
    """How long a text may be, and how many operations and operands it may have."""

    characters: int = CHARACTERS
    nodes: int = NODES


#: the limits of what is typed, and of what is read from a file
USUAL, FILE = Limits(), Limits(1_000_000, 50_000)


class _Token(NamedTuple):
    kind: str  # "number", "name", "sign" or "end"
    text: str
    column: int


def parse(text: str, variables: Sequence[str] = ("t",)) -> Node:
    """The expression that a formula writes.

    text: one formula in the grammar of this module; variables: the names that it may use.
    Raises FormulaError, with the place under the text, for everything else.

    >>> print(parse("2*cos(t)^2 - 0.5"))
    2*cos(t)**2 - 1/2
    >>> parse("2t")
    Traceback (most recent call last):
    osculant.cas.errors.FormulaError: An operator is missing; for a product write 2*t.
      2t
       ^
    """
    parser = _Parser(text, variables)
    node = parser.expression(_SUM)
    if parser.token.text == ",":
        raise parser.error("One formula is expected here; remove this comma and what follows.")
    return parser.finish([node])[0]


def parse_tuple(text: str, variables: Sequence[str] = ("t",), limits: Limits = USUAL) -> tuple[Node, ...]:
    """The expressions of a list of formulas separated by commas, the whole in parentheses or not.

    text: formulas in the grammar of this module; variables: the names they may use; limits: of their size.
    Raises FormulaError, with the place under the text, for everything else.

    >>> [str(node) for node in parse_tuple("(t, t^2)")]
    ['t', 't**2']
    """
    parser = _Parser(text, variables, limits)
    enclosed = parser.enclosed()
    if enclosed:
        parser.advance()
    nodes = [parser.expression(_SUM)]
    while parser.token.text == ",":
        parser.advance()
        nodes.append(parser.expression(_SUM))
    if enclosed:
        parser.advance()
    return parser.finish(nodes)


def parse_constant(text: str) -> Node:
    """The expression of a formula without variables, such as "2*pi" or "-1.5e-3".

    >>> print(parse_constant("pi/6"))
    pi/6
    """
    return parse(text, ())


class _Parser:
    """Precedence climbing over the tokens of one text; it recurses where the grammar nests, within DEPTH."""

    def __init__(self, text: str, variables: Sequence[str], limits: Limits = USUAL) -> None:
        self.text, self.limits = text, limits
        self.variables = {name: ex.variable(name) for name in variables}
        self.tokens = self.tokenize()
        self.position = 0
        self.depth = 0

    @property
    def token(self) -> _Token:
        return self.tokens[self.position]

    def advance(self) -> _Token:
        self.position += 1
        return self.tokens[self.position - 1]

    def error(self, sentence: str, column: int | None = None) -> FormulaError:
        """The sentence, beneath it the text and a caret under the column, by default the present token's."""
        column = self.token.column if column is None else column
        start = max(0, column - WINDOW // 2)
        before = "..." if start else ""
        shown = "".join(c if c.isprintable() else " " for c in self.text[start : start + WINDOW])
        after = "..." if start + WINDOW < len(self.text) else ""
        blanks = " " * (len(before) + column - start)
        return FormulaError(f"{sentence}\n  {before}{shown}{after}\n  {blanks}^")

    def tokenize(self) -> list[_Token]:
        most = self.limits.characters
        if len(self.text) > most:
            raise self.error(f"A formula has at most {most} characters; this one has {len(self.text)}.", most)
        tokens: list[_Token] = []
        column = 0
        while column < len(self.text):
            match = _TOKEN.match(self.text, column)
            if match is None:
                character = self.text[column]
                hint = _HINTS.get(character, "a formula is made of numbers, names, + - * / ^ and parentheses")
                raise self.error(f"The character {character!r} has no meaning in a formula; {hint}.", column)
            if match.lastgroup != "blank":
                tokens.append(_Token(str(match.lastgroup), match[0], column))
            column = match.end()
        if not tokens:
            raise FormulaError("The formula is empty; write for instance t^2.")
        tokens.append(_Token("end", "", len(self.text.rstrip())))
        return tokens

    def enclosed(self) -> bool:
        """Whether one pair of parentheses encloses the whole text, and that is a list."""
        depth, comma = 0, False
        for token in self.tokens[:-1]:
            depth += (token.text == "(") - (token.text == ")")
            comma = comma or (token.text == "," and depth == 1)
            if depth <= 0:
                return comma and token is self.tokens[-2]
        return False

    def finish(self, nodes: list[Node]) -> tuple[Node, ...]:
        if self.token.text == ")":
            raise self.error("This parenthesis closes nothing; remove it or open one before.")
        if len(topological(nodes)) > (most := self.limits.nodes):
            raise self.error(f"The formula has more than {most} operations; write a shorter one.")
        return tuple(nodes)

    def expression(self, floor: int) -> Node:
        """Operands joined by operators that bind at least as tightly as `floor`."""
        left = self.operand()
        while True:
            token = self.token
            if token.kind in ("number", "name") or token.text == "(":
                raise self.missing_operator()
            binding = _BINDING.get(token.text, 0)
            if binding < floor:
                return left
            self.advance()
            right = self.nested(_FACTOR, token) if binding == _POWER else self.expression(binding + 1)
            left = self.make(token, _OPERATIONS[token.text], left, right)

    def nested(self, floor: int, opening: _Token) -> Node:
        self.depth += 1
        if self.depth > DEPTH:
            sentence = f"Parentheses and exponents nest at most {DEPTH} deep; write a flatter formula."
            raise self.error(sentence, opening.column)
        node = self.expression(floor)
        self.depth -= 1
        return node

    def operand(self) -> Node:
        token = self.token
        if token.text in ("+", "-"):
            minus = False
            while self.token.text in ("+", "-"):
                minus ^= self.advance().text == "-"
            node = self.expression(_POWER)
            return self.make(token, ex.neg, node) if minus else node
        if token.kind == "number":
            self.advance()
            return self.make(token, ex.number, self.make(token, decimal, token.text))
        if token.kind == "name":
            self.advance()
            return self.name(token)
        if token.text == "(":
            self.advance()
            return self.enclosure(token, "A parenthesis holds")
        place = f"after {self.tokens[self.position - 1].text!r}" if self.position else "at the beginning"
        found = f"{token.text!r} follows" if token.text else "the formula ends"
        raise self.error(f"A number, a name or '(' is missing {place}, where {found}.")

    def enclosure(self, opening: _Token, holder: str) -> Node:
        """The one expression up to the closing parenthesis; the opening one has been read."""
        node = self.nested(_SUM, opening)
        if self.token.text == ",":
            raise self.error(f"{holder} one expression; remove this comma.")
        if self.token.kind == "end":
            raise self.error("This parenthesis is never closed; add ')'.", opening.column)
        self.advance()
        return node

    def name(self, token: _Token) -> Node:
        name = token.text
        if name in self.variables:
            return self.variables[name]
        if name in _CONSTANTS:
            return _CONSTANTS[name]
        if name not in ex.RESERVED:
            raise self.unknown(token)
        if self.token.text != "(":
            sentence = f"The function {name} needs its argument in parentheses; write {name}(...)."
            raise self.error(sentence, token.column)
        opening = self.advance()
        return self.make(token, ex.call, name, self.enclosure(opening, f"The function {name} takes"))

    def make(self, token: _Token, rule: Callable[..., Result], *args: object) -> Result:
        """rule(*args), with the token's place added to the error that it may raise."""
        try:
            return rule(*args)
        except (DomainError, FormulaError) as error:
            raise self.error(str(error), token.column) from None

    def unknown(self, token: _Token) -> FormulaError:
        known = [*self.variables, *_CONSTANTS, *sorted(ex.RESERVED)]
        near = difflib.get_close_matches(token.text[:WINDOW].lower(), known, 1)
        guess = f"; did you mean {near[0]}?" if near else "."
        count, names = len(self.variables), ", ".join(self.variables)
        allowed = f"variable{'s'[: count > 1]} allowed: {names}" if names else "no variables are allowed here"
        return self.error(f"The name {token.text[:WINDOW]!r} is unknown ({allowed}){guess}", token.column)

    def missing_operator(self) -> FormulaError:
        before, token = self.tokens[self.position - 1], self.token
        if before.kind == token.kind == "number":
            return self.error("Two numbers follow each other; write an operator between them.")
        left, right = ("(...)" if part.kind == "sign" else part.text[:WINDOW] for part in (before, token))
        fault = (
            f"{left} is not a function"
            if before.kind == "name" and right == "(...)"
            else "An operator is missing"
        )
        return self.error(f"{fault}; for a product write {left}*{right}.")
