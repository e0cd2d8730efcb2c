"""The errors that osculant raises on purpose; every message is one sentence fit to be shown to a user."""

from __future__ import annotations


class OsculantError(Exception):
    """Base of all errors of osculant; the command line turns it into one line and exit status 2."""


class FormulaError(OsculantError, ValueError):
    """A formula that cannot be read, or is beyond the limits; shows the place where the text is known."""


class DomainError(OsculantError, ValueError):
    """A point, or an input, where the object asked for does not exist: a pole, a cusp, a root of -1."""


class ToleranceError(OsculantError, ValueError):
    """A tolerance that is not positive, not finite, or below the floor that rounding sets."""


class UndecidedError(OsculantError):
    """A computation that reached its cap without an answer; the message says which cap."""
