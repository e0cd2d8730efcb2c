"""The claims' modules: where they are, and what they may take from each other."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from osculant.cas import claims
from osculant.cas.claims import all_claims

FOLDER = Path(claims.__file__).parent
CLAIMS = all_claims()
CHECKS = {(claim.check.__module__, claim.check.__name__) for claim in CLAIMS}
WITH_CLAIMS = {module for module, _ in CHECKS}
FILES = sorted(FOLDER.rglob("*.py"))


def name_of(path):
    parts = path.relative_to(FOLDER).with_suffix("").parts
    return ".".join(("osculant.cas.claims", *parts))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.relative_to(FOLDER).as_posix())
def test_tools_are_not_taken_from_a_module_of_claims(path):
    """A lemma, that is the check of another claim, may be; tools are in modules of their own."""
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module in WITH_CLAIMS:
            assert {(node.module, alias.name) for alias in node.names} <= CHECKS


def test_claims_are_in_the_folders_of_chapters():
    folders = {path.parent.name for path in FILES if name_of(path) in WITH_CLAIMS}
    assert folders == {"appendices", *(f"chapter_{n}" for n in range(1, 7))}
    assert {name_of(path) for path in FILES} >= WITH_CLAIMS
