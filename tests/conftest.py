"""Hypothesis: the same examples in every run where CI is set, new ones elsewhere; never a time limit."""

import os

from hypothesis import settings

settings.register_profile("default", deadline=None)
settings.register_profile("ci", deadline=None, derandomize=True)
settings.load_profile("ci" if os.environ.get("CI") else "default")
