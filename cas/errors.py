"""The errors that osculant raises on purpose; every message is one sentence fit to be shown to a user."""

from __future__ import annotations

from collections.abc import Mapping


class OsculantError(Exception):
    """Base of all errors of osculant; the command line turns it into one line and exit status 2.

    Args:
        sentence: what is wrong, and the way out.
        argument: the name of the function's argument that is wrong (or of a function that helps), as the
            sentence mentions it first; the command line has other names.
    """

    def __init__(self, sentence: str = "", *, argument: str = "") -> None:
        super().__init__(sentence)
        self.argument = argument

    def told(self, names: Mapping[str, str]) -> str:
        """The sentence, the argument called what ``names`` has for it.

        >>> FormulaError("low: there is no name 'x'.", argument="low").told({"low": "first end"})
        "first end: there is no name 'x'."
        """
        return str(self).replace(self.argument, names.get(self.argument, self.argument), 1)


class FormulaError(OsculantError, ValueError):
    """A formula that cannot be read, or is beyond the limits; shows the place where the text is known."""


class DomainError(OsculantError, ValueError):
    """A point, or an input, where the object asked for does not exist: a pole, a cusp, a root of -1."""


class ToleranceError(OsculantError, ValueError):
    """A tolerance that is not positive, not finite, or below the floor that rounding sets."""


class UndecidedError(OsculantError):
    """A computation that reached its cap without an answer; the message says which cap."""
