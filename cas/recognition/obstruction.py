"""What stands in the way of an equivalence."""

from __future__ import annotations

from typing import Any

from osculant.cas.recognition.forms import Column


class NotEquivalent(Exception):  # noqa: N818  (an answer, not an error)
    """A germ that is not of the form asked about: what stands in the way.

    Attributes:
        column: the monomial with its component, if one is in the way.
        level: its level, if so.
        value: its coefficient.
    """

    def __init__(
        self, sentence: str, column: Column | None = None, level: int | None = None, value: Any = None
    ) -> None:
        super().__init__(sentence)
        self.column, self.level, self.value = column, level, value
