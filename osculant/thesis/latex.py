"""Text with mathematical letters as LaTeX in plain ASCII, for the standard classes without packages."""

from __future__ import annotations

import ast
import re
import unicodedata
from itertools import groupby

#: characters of text that are no mathematics
_SPECIAL = {
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    **{sign: rf"\ensuremath{{{sign}}}" for sign in "<>|"},
    **{sign: f"\\{sign}" for sign in "{}#$%&_"},
    **dict(zip("–—‘’“”\u00a0\u2009\u202f", ("--", "---", "`", "'", "``", "''", "~", r"\,", r"\,"))),
    **{letter: rf"\{name}{{}}" for letter, name in zip("ßøØæłı§", ("ss", "o", "O", "ae", "l", "i", "S"))},
}

#: signs, each with the command that does not follow from its name; Greek letters and scripts go by rule
_COMMANDS = """
± pm ∓ mp · cdot ⋅ cdot × times ∘ circ ⊕ oplus ⊗ otimes ⋯ cdots ≤ leq ≥ geq ≠ neq ≈ approx ∼ sim ≃ simeq
≡ equiv ≅ cong ∝ propto ≪ ll ≫ gg ∞ infty ℓ ell ∈ in ∉ notin ⊂ subset ⊆ subseteq ⊃ supset ∪ cup ∩ cap
∅ emptyset ∖ setminus ∀ forall ∃ exists ∧ wedge ∨ vee ¬ neg ⊥ perp ∥ | ‖ | ∣ mid ∠ angle → to ← leftarrow
↔ leftrightarrow ↦ mapsto ⇒ Rightarrow ⇔ Leftrightarrow ∂ partial ∇ nabla ∫ int ∑ sum ∏ prod √ surd
⟨ langle ⟩ rangle ⌈ lceil ⌉ rceil ⌊ lfloor ⌋ rfloor ε varepsilon ϕ phi φ varphi
"""
_SIGNS = {
    **{sign: f"\\{command}" for sign, command in re.findall(r"(\S) (\S+)", _COMMANDS)},
    **dict(zip("−′⁄∗°∛∜", ("-", "'", "/", "*", r"^{\circ}", r"{}^{3}\surd", r"{}^{4}\surd"))),
    **{letter: rf"\mathbf{{{name}}}" for letter, name in zip("ℝℂℚℤℕ", "RCQZN")},
}

#: combining accents: the command in text and that in mathematics
_ACCENTS = {
    "\u0300": (r"\`", r"\grave"),
    "\u0301": (r"\'", r"\acute"),
    "\u0302": (r"\^", r"\hat"),
    "\u0303": (r"\~", r"\tilde"),
    "\u0304": (r"\=", r"\bar"),
    "\u0305": (r"\=", r"\bar"),
    "\u0306": (r"\u", r"\breve"),
    "\u0307": (r"\.", r"\dot"),
    "\u0308": (r"\"", r"\ddot"),
    "\u030b": (r"\H", r"\ddot"),
    "\u030c": (r"\v", r"\check"),
    "\u20d7": ("", r"\vec"),
    "\u20db": ("", r"\dot\ddot"),
}

#: a character with the accents that follow it
_CLUSTER = re.compile(rf".[{''.join(_ACCENTS)}]*", re.DOTALL)
#: capital Greek letters that have no command because they look Latin
_LATIN = dict(zip("ΑΒΕΖΗΙΚΜΝΟΡΤΧο", "ABEZHIKMNOPTXo"))


def latex(text: str) -> str:
    r"""Text as LaTeX that prints it: Greek letters, scripts, accents and signs as commands.

    Args:
        text: any text.

    Returns pure ASCII that needs no package. A character without a command is written as what it resembles
    or, failing that, as its Unicode name in brackets.

    >>> print(latex("κ^(1/3), x₁² ≤ 9 %"))
    \ensuremath{\kappa}\textasciicircum{}(1/3), x\ensuremath{_{1}}\ensuremath{^{2}} \ensuremath{\leq} 9 \%
    >>> print(latex("Höllig: α̇ ☃"))
    H\"{o}llig: \ensuremath{\dot{\alpha}} [snowman]
    """
    clusters = _CLUSTER.findall(unicodedata.normalize("NFC", text))
    parts = []
    for script, run in groupby(clusters, _script):
        if script:
            parts.append(rf"\ensuremath{{{script}{{{''.join(map(_mathematical, run))}}}}}")
        else:
            parts += map(_letter, run)
    return "".join(parts)


def formula_latex(form: str) -> str | None:
    r"""A formula as LaTeX mathematics that keeps the order of its terms; None for a text that is no formula.

    Args:
        form: as in ``cbrt(kappa)``; several separated by commas or semicolons; ± and != are understood, and
            names such as kappa1, taub (with a bar), dk_dr.

    >>> print(formula_latex("-k0*r**3/6 + cbrt(kappa1)"))
    \ensuremath{-\frac{k_{0}\,r^{3}}{6} + \sqrt[3]{\kappa_{1}}}
    >>> formula_latex("strictly convex") is None
    True
    """
    if "|" in form:  # which stands for ± below
        return None
    written = []
    for part in form.split(";"):
        # "|" binds less than + and -, so what stands around ± is written without parentheses
        text = part.replace("±", "|").replace("^", "**").strip()
        try:
            written.append(_formula(ast.parse(text, mode="eval").body)[0])
        except (SyntaxError, KeyError, ValueError):
            return None
    return rf"\ensuremath{{{_GAP.join(written)}}}"


#: between formulas, and the sign that begins a command
_GAP, _COMMAND = r";\ ", "\\"
#: how strongly the outermost operation of a formula binds
_TUPLE, _SUM, _PRODUCT, _FRACTION, _POWER, _ATOM = range(6)
_ROOTS = {"sqrt": r"\sqrt{%s}", "cbrt": r"\sqrt[3]{%s}", "abs": r"\left|%s\right|"}
_FUNCTIONS = {"sin", "cos", "tan", "sec", "csc", "cot", "sinh", "cosh", "tanh", "coth", "exp", "log"}
#: a numerator or denominator longer than that stays on the line
_LONG = 60


def _formula(node: ast.expr) -> tuple[str, int]:
    """The mathematics and how strongly it binds; KeyError or ValueError for what is no formula."""
    match node:
        case ast.Tuple(elts=parts) if parts:
            return r",\ ".join(_within(part, _SUM) for part in parts), _TUPLE
        case ast.Compare(left=left, ops=[ast.NotEq()], comparators=[right]):
            return rf"{_within(left, _SUM)} \neq {_within(right, _SUM)}", _TUPLE
        case ast.Constant(value=int(number)) if not isinstance(number, bool):
            return str(number), _ATOM
        case ast.Name(id=name):
            letter = _name(name)
            return letter, _FRACTION if letter.startswith(r"\frac") else _ATOM
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]) if arguments:
            inner = r",\ ".join(_within(argument, _SUM) for argument in arguments)
            if name in _ROOTS:
                return _ROOTS[name] % inner, _ATOM
            return f"{_COMMAND + name if name in _FUNCTIONS else _name(name)}{_bracketed(inner)}", _ATOM
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return f"-{_within(operand, _PRODUCT)}", _SUM
        case ast.BinOp(left=left, op=ast.Pow(), right=right):
            return f"{_within(left, _ATOM)}^{{{_exponent(right)}}}", _POWER
        case ast.BinOp(op=ast.Mult() | ast.Div()) if (positive := _without_sign(node)) is not node:
            return f"-{_within(positive, _PRODUCT)}", _SUM
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            first, second = _within(left, _PRODUCT), _within(right, _FRACTION)
            sign = r" \cdot " if re.match(r"[0-9]|\\frac\{[0-9]", second) else r"\,"
            return f"{first}{sign}{second}", _PRODUCT
        case ast.BinOp(left=left, op=ast.Div(), right=right):
            above, below = _within(left, _TUPLE), _within(right, _TUPLE)
            if max(len(above), len(below)) > _LONG:
                return f"{_within(left, _PRODUCT)}/{_within(right, _FRACTION)}", _PRODUCT
            return rf"\frac{{{above}}}{{{below}}}", _FRACTION
        case ast.BinOp(left=left, op=ast.BitOr(), right=right):
            return rf"{_within(left, _SUM)} \pm {_within(right, _SUM)}", _SUM
        case ast.BinOp(left=left, op=ast.Add() | ast.Sub() as operator, right=right):
            sign = "+" if isinstance(operator, ast.Add) else "-"
            return f"{_within(left, _SUM)} {sign} {_within(right, _PRODUCT)}", _SUM
    raise ValueError


def _within(node: ast.expr, least: int) -> str:
    """The same as a part of something, in parentheses if it binds less than is wanted there."""
    text, binds = _formula(node)
    return text if binds >= least else _bracketed(text)


def _exponent(node: ast.expr) -> str:
    """The same as an exponent: a fraction of integers stays on its line."""
    text, _ = _formula(node)
    return re.sub(r"^(-?)\\frac\{([0-9]+)\}\{([0-9]+)\}$", r"\1\2/\3", text)


def _without_sign(node: ast.expr) -> ast.expr:
    """A product without the minus of its first factor, which belongs to all of it; else the node itself."""
    match node:
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return operand
        case ast.BinOp(left=left, op=ast.Mult() | ast.Div() as operator, right=right):
            positive = _without_sign(left)
            return node if positive is left else ast.BinOp(positive, operator, right)
    return node


def _bracketed(text: str) -> str:
    return rf"\left({text}\right)" if r"\frac" in text else f"({text})"


def _name(name: str) -> str:
    """The letter of a variable: kappa1, taub (with a bar), l; the fraction dk_dr; a word upright."""
    ratio = re.fullmatch(r"d([a-zA-Z]+)_d([a-zA-Z]+)", name)
    if ratio is not None:
        return rf"\frac{{d{_name(ratio[1])}}}{{d{_name(ratio[2])}}}"
    found = re.fullmatch(r"([A-Za-z]+?)(b?)_?([0-9]*|(?<=_)[A-Za-z]+)", name)
    if found is None:
        return rf"\mathrm{{{latex(name)}}}"
    letter, bar, index = found.groups()
    index = _name(index) if index.isalpha() else index
    if bar and not _is_greek(letter):
        letter, bar = letter + bar, ""
    if _is_greek(letter):
        letter = _COMMAND + letter
    elif len(letter) > 1:
        letter = rf"\mathrm{{{letter}}}"
    barred = rf"\bar{{{letter}}}" if bar else letter
    return f"{barred}_{{{index}}}" if index else barred


def _is_greek(word: str) -> bool:
    """Whether a word is the name of a Greek letter that has a command.

    >>> _is_greek("kappa"), _is_greek("k")
    (True, False)
    """
    kind = "SMALL" if word.islower() else "CAPITAL"
    spelt = word.upper().replace("LAMBDA", "LAMDA")
    try:
        letter = unicodedata.lookup(f"GREEK {kind} LETTER {spelt}")
    except KeyError:
        return False
    return letter not in _LATIN and _mathematical(letter) in {_COMMAND + word, f"{_COMMAND}var{word}"}


def _script(cluster: str) -> str:
    kind = unicodedata.decomposition(cluster[0]).partition(" ")[0]
    return {"<super>": "^", "<sub>": "_"}.get(kind, "")


def _letter(cluster: str) -> str:
    """A character, perhaps with accents, in text."""
    if cluster in _SPECIAL:
        return _SPECIAL[cluster]
    if cluster.isascii():
        return cluster if cluster.isprintable() or cluster == "\n" else " "
    if cluster not in _SIGNS:
        base, *accents = list(unicodedata.normalize("NFD", cluster))
        if len(accents) == 1 and base.isascii() and _ACCENTS.get(accents[0], ("",))[0]:
            return rf"{_ACCENTS[accents[0]][0]}{{{base}}}"
    inner = _mathematical(cluster)
    return inner if inner.startswith("[") else rf"\ensuremath{{{inner}}}"


def _mathematical(cluster: str) -> str:
    """The same in mathematics."""
    if cluster in _SIGNS or cluster in _LATIN:
        return _SIGNS.get(cluster) or _LATIN[cluster]
    if cluster.isascii():
        return _SPECIAL.get(cluster, cluster) if cluster in "{}#$%&_" else cluster
    base, *accents = list(unicodedata.normalize("NFD", cluster))
    if accents:
        inner = _mathematical(base)
        for accent in accents:
            for command in reversed(_ACCENTS.get(accent, ("", ""))[1].split("\\")[1:]):
                inner = rf"\{command}{{{inner}}}"
        return inner
    name = unicodedata.name(cluster, f"character {ord(cluster):x}")
    greek = re.fullmatch(r"GREEK (SMALL|CAPITAL) LETTER ([A-Z]+)", name)
    if greek is not None:
        word = greek[2].replace("LAMDA", "LAMBDA")
        return "\\" + (word.lower() if greek[1] == "SMALL" else word.capitalize())
    alike = unicodedata.normalize("NFKD", cluster)
    return f"[{name.lower()}]" if alike == cluster else "".join(map(_mathematical, alike))
