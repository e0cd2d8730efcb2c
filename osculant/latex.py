"""Text with mathematical letters as LaTeX in plain ASCII, for the standard classes without packages."""

from __future__ import annotations

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
