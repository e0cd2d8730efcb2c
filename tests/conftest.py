"""Hypothesis: the same examples in every run where CI is set, new ones elsewhere; never a time limit."""

import os

import pytest
from hypothesis import settings

from osculant.kernels import jit

settings.register_profile("default", deadline=None)
settings.register_profile("ci", deadline=None, derandomize=True)
settings.load_profile("ci" if os.environ.get("CI") else "default")


@pytest.fixture(autouse=True)
def no_notice(request, monkeypatch):
    """No notice of compiling, which depends on what ran before, but where it is tested."""
    if "notice" not in request.node.name:
        monkeypatch.setattr(jit, "when_compiling", lambda call: None)
