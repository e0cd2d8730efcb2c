"""Formulas as people write them, in Unicode, from the mathematics of `osculant.thesis.latex`."""

from __future__ import annotations

import re
import unicodedata

from osculant.thesis.latex import formula_latex

_RAISED = dict(zip("0123456789+-=()ni", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿⁱ"))
_LOWERED = dict(zip("0123456789+-=()aehijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ"))
_SIGNS = {r"\cdot": "·", r"\pm": "±", r"\neq": "≠", r"\left": "", r"\right": "", "-": "−"}
_SPACES = {r"\,", r"\ ", r"\;"}
#: what may follow a fraction that needs no parentheses
_ENDS = {"", "+", "-", r"\pm", ",", ";", ")", r"\right", "}", "]"}
#: pieces of LaTeX: a command, or a character
_PIECE = re.compile(r"\\[A-Za-z]+|\\.|.", re.DOTALL)


def plain(form: str) -> str:
    """A claim's form as a formula in Unicode; a text that is no formula stays as it is.

    Args:
        form: as `formula_latex` takes it.

    >>> print(plain("l1**2 - 4*Q*l0*l2"), plain("(w^2 - 1)/(2*n)"), plain("k monotone"), sep="; ")
    l₁² − 4 Q l₀ l₂; (w² − 1)/(2 n); k monotone
    >>> print(plain("-2*cbrt(kappa1)/pi^(1/3)"))
    −2 ∛κ₁/(π^(1/3))
    """
    written = formula_latex(form)
    if written is None:
        return form
    pieces = _PIECE.findall(written.removeprefix(r"\ensuremath{").removesuffix("}"))
    pieces.reverse()  # read from the end of the list
    text = _until(pieces, "")
    return re.sub(r" +", " ", text).strip()


def _until(pieces: list[str], end: str) -> str:
    """Pieces up to a closing brace, or all of them, as Unicode; they are taken off the list."""
    text = ""
    while pieces:
        piece = pieces.pop()
        if piece == end:
            break
        if piece == r"\frac":
            fraction = f"{_bound(_group(pieces), '·')}/{_bound(_group(pieces), '')}"
            alone = not text.strip() or text.rstrip()[-1] in "+−(,=±"
            followed = _next(pieces) not in _ENDS
            text += f"({fraction})" if followed or not alone else fraction
        elif piece == r"\sqrt":
            sign = "√"
            if pieces and pieces[-1] == "[":
                sign = "∛"
                _until(pieces, "]")
            text += f"{sign}{_bound(_group(pieces), '')}"
        elif piece in "^_":
            text += _script(_group(pieces), piece)
        elif piece == r"\bar":
            text += _group(pieces) + "\u0304"
        elif piece == r"\mathrm":
            text += _group(pieces)
        elif piece == "{":
            text += _until(pieces, "}")
        elif piece in _SPACES:
            text += " "
        elif piece in _SIGNS:
            text += _SIGNS[piece]
        else:
            text += _letter(piece) if piece.startswith("\\") else piece
    return text


def _group(pieces: list[str]) -> str:
    """What a command or a script takes: a group in braces, or one piece."""
    piece = pieces.pop()
    return _until(pieces, "}") if piece == "{" else _SIGNS.get(piece, piece)


def _script(text: str, kind: str) -> str:
    """Raised or lowered if there are such characters, else with the sign of the script."""
    letters = _RAISED if kind == "^" else _LOWERED
    bare = text.replace("−", "-")
    if all(c in letters for c in bare):
        return "".join(letters[c] for c in bare)
    return f"{kind}({text})" if kind == "^" or len(text) > 1 else f"{kind}{text}"


def _bound(text: str, joined: str) -> str:
    """In parentheses unless it is one number or letter or, where a product is ``joined`` too, a product."""
    simple = re.fullmatch(r"\w+|\w[₀-₉⁰-⁹²³¹]*", text)
    return text if simple or (joined and not re.search(r"[+−±/,]", text)) else f"({text})"


def _next(pieces: list[str]) -> str:
    """The next piece that is no space; nothing at the end."""
    return next((piece for piece in reversed(pieces) if piece not in (*_SPACES, " ")), "")


def _letter(command: str) -> str:
    r"""The Greek letter of a command, or its name: sin, cos.

    >>> _letter("\\kappa"), _letter("\\sin"), _letter("\\varphi")
    ('κ', 'sin', 'φ')
    """
    name = command.lstrip("\\").removeprefix("var")
    kind = "SMALL" if name.islower() else "CAPITAL"
    try:
        return unicodedata.lookup(f"GREEK {kind} LETTER {name.upper().replace('LAMBDA', 'LAMDA')}")
    except KeyError:
        return name
