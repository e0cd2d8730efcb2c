"""From pieces to a file: drafted, measured by its own numbers, and written if it keeps the tolerance."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from osculant.cas.errors import ToleranceError
from osculant.files.drafts import Draft, Written
from osculant.files.registry import Writer, writer_of
from osculant.files.writing import write_out

if TYPE_CHECKING:
    from osculant.files.deviation import Follow
    from osculant.files.facts import Facts
    from osculant.pieces.chain import Chain

#: by what part of itself an error may be above the tolerance, as doubles measure it
SLACK = 1e-9


class Drafted(NamedTuple):
    """A draft with the error of what it draws."""

    writer: Writer
    draft: Draft
    error: float

    def keeps(self, tolerance: float) -> bool:
        """Whether the error is within a tolerance, to the rounding of doubles."""
        return self.error <= tolerance * (1 + SLACK)


def drafted(
    path: str | os.PathLike[str],
    chain: Chain,
    facts: Facts,
    follow: Follow | None,
    options: Mapping[str, Any],
) -> Drafted:
    """What would be written, and how good it is.

    Args:
        path: a file, whose suffix names the format.
        chain: the pieces.
        facts: about the spline.
        follow: the curve's points at parameters, None if they are not known.
        options: of the format.

    Raises what the format's function does, and OsculantError for an unknown suffix.
    """
    writer = writer_of(path, chain.dimension)
    draft = writer.draft(chain, facts, facts.room(chain), options)
    return Drafted(writer, draft, draft.error(chain, facts, follow))


def write_file(
    path: str | os.PathLike[str],
    chain: Chain,
    facts: Facts,
    follow: Follow | None,
    options: Mapping[str, Any],
    *,
    kept: bool = True,
) -> Written:
    """Write a file, whole or not at all.

    Args:
        path: a file, whose suffix names the format.
        chain: the pieces.
        facts: about the spline.
        follow: the curve's points at parameters, None if they are not known.
        options: of the format.
        kept: whether a file whose error is above the tolerance is refused.

    Raises:
        ToleranceError: a file that would leave the tolerance.
        OsculantError: a file that cannot be written; and as `drafted`.
    """
    writer, draft, error = made = drafted(path, chain, facts, follow, options)
    if kept and not made.keeps(facts.tolerance):
        raise ToleranceError(
            f"{os.fspath(path)} would have the error {error:.3g}, more than the tolerance "
            f"{facts.tolerance:.3g}: name the file and its options when approximating, so that the search "
            "leaves room for them."
        )
    told = f"{error:.6g} (measured)" if draft.readings and math.isfinite(error) else None
    write_out(path, draft.text(told))
    return Written(os.fspath(path), writer.name, error, draft.moves, draft.numbers)
