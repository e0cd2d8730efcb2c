"""Claims as LaTeX: every sign has a command, formulas are mathematics, the list of errata compiles."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

from osculant.cas.claims import all_claims
from osculant.cas.errors import DomainError
from osculant.thesis.errata import errata_document
from osculant.thesis.latex import formula_latex, latex
from osculant.thesis.verification import Verification

ERRATA = [c for c in all_claims() if c.erratum]


def balanced(text: str) -> bool:
    depth = 0
    for sign in re.sub(r"\\[{}\\]", "", text):
        depth += (sign == "{") - (sign == "}")
        if depth < 0:
            return False
    return depth == 0


def test_every_text_of_every_claim_has_its_latex():
    for c in all_claims():
        for text in (c.statement, c.form, c.printed or "", c.erratum, c.reason, c.name):
            written = latex(text)
            assert written.isascii() and balanced(written)
            unknown = re.findall(r"\[[a-z]+(?: [a-z]+)+\]", written)
            assert not set(unknown) - set(re.findall(r"\[[a-z]+(?: [a-z]+)+\]", text)), (c.name, unknown)


def formulas(text: str) -> set[str]:
    """What stands in the braces of ensuremath, with these."""
    found = set()
    for start in re.finditer(r"\\ensuremath(?=\{)", text):
        rest = text[start.end() :]
        ends = (i for i, sign in enumerate(rest) if sign == "}" and balanced(rest[: i + 1]))
        found.add(rest[: next(ends) + 1])
    return found


@pytest.fixture(scope="module")
def document() -> str:
    return errata_document(Verification((), tuple(ERRATA), 0.0))


def test_the_errata_need_no_package_but_geometry(document):
    assert document.isascii() and balanced(document)
    assert re.findall(r"\\usepackage.*", document) == [r"\usepackage[margin=25mm]{geometry}"]
    assert document.count(r"\begin{description}") == document.count(r"\end{description}") == len(ERRATA)
    outside = document
    for formula in formulas(document):
        outside = outside.replace(rf"\ensuremath{formula}", "")
    assert not re.search(r"(?<!\\)[$^_&#]", outside)  # these would need mathematics or an alignment


def test_matplotlib_knows_the_mathematics(document):
    mathtext = pytest.importorskip("matplotlib.mathtext")
    parser = mathtext.MathTextParser("path")
    assert formulas(document)
    for formula in formulas(document):
        parser.parse("$" + formula.replace(r"\surd", r"\sqrt{0}") + "$")


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="needs pdflatex")
def test_the_errata_compile(document, tmp_path):
    (tmp_path / "errata.tex").write_text(document, encoding="ascii")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "errata.tex"]
    done = subprocess.run(
        command, cwd=tmp_path, capture_output=True, text=True, errors="replace", check=False
    )
    assert done.returncode == 0, done.stdout[-2000:]
    assert "Overfull" not in done.stdout


def test_latex_of_signs():
    assert latex("κ′(s) ≠ ½") == r"\ensuremath{\kappa}\ensuremath{'}(s) \ensuremath{\neq} \ensuremath{1/2}"
    assert latex("xⁿ⁻¹x₁₂") == r"x\ensuremath{^{n-1}}x\ensuremath{_{12}}"
    assert latex("τ̄ α⃛ φ̈") == (
        r"\ensuremath{\bar{\tau}} \ensuremath{\dot{\ddot{\alpha}}} \ensuremath{\ddot{\varphi}}"
    )
    assert latex("50 % {a_b} #1 $x$ & ~ ^ \\") == (
        r"50 \% \{a\_b\} \#1 \$x\$ \& \textasciitilde{} \textasciicircum{} \textbackslash{}"
    )


@pytest.mark.parametrize(
    "form, written",
    [
        ("-a*b/c", r"-\frac{a\,b}{c}"),
        ("a - (b - c)*2", r"a - (b - c) \cdot 2"),
        ("(-a)**2 - a**-k", "(-a)^{2} - a^{-k}"),
        ("dk_dr^(1/5)*abs(q/g)", r"\left(\frac{dk}{dr}\right)^{1/5}\,\left|\frac{q}{g}\right|"),
        ("x ± y + z, 1/2*pi; A(H)", r"x \pm y + z,\ \frac{1}{2}\,\pi;\ A(H)"),
        ("cbrt(kappab) != Gamma_1 - Alpha", r"\sqrt[3]{\bar{\kappa}} \neq \Gamma_{1} - \mathrm{Alpha}"),
        ("Q_u*Q_sigma", r"Q_{u}\,Q_{\sigma}"),
        ("area*sin(t0)", r"\mathrm{area}\,\sin(t_{0})"),
    ],
)
def test_latex_of_formulas(form, written):
    assert formula_latex(form) == rf"\ensuremath{{{written}}}"


@pytest.mark.parametrize(
    "text",
    ["k monotone", "(3.4)", "lemma 3.5.1.2", "", "f(x=1)", "a|b", "a < b", "True", "x[1]", "+", "()", "a;"],
)
def test_texts_that_are_no_formulas(text):
    assert formula_latex(text) is None


def test_no_erratum_is_no_document():
    with pytest.raises(DomainError, match="no erratum"):
        errata_document(Verification((), (), 0.0))
