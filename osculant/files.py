"""Writing files whole or not at all."""

from __future__ import annotations

import os
import secrets
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from osculant.cas.errors import OsculantError

#: suffixes of G-code, and all that `Spline.write` knows
GCODE_SUFFIXES = (".nc", ".gcode", ".ngc")
SUFFIXES = (".svg", ".json", *GCODE_SUFFIXES, ".dxf")


def listed(words: Sequence[str]) -> str:
    """The words with commas and an "and".

    >>> listed([".a", ".b", ".c"])
    '.a, .b and .c'
    """
    return f"{', '.join(words[:-1])} and {words[-1]}"


def write_whole(path: str | os.PathLike[str], content: str | bytes) -> None:
    """Write a file by way of a temporary one in the same folder: readers see all of it, or the old one.

    Args:
        path: where to write; a link is followed, an existing file is replaced.
        content: text, written as UTF-8 its line ends kept, or bytes.

    Raises:
        OsculantError: the file cannot be written; names the path and the system's reason.

    >>> write_whole("/no/such/folder/spiral.svg", "")
    Traceback (most recent call last):
    ...
    osculant.cas.errors.OsculantError: Cannot write /no/such/folder/spiral.svg: No such file or directory.
    """
    target = Path(os.path.realpath(path))
    temporary = target.with_name(f".{target.name[:100]}.{secrets.token_hex(4)}.tmp")
    data = content.encode("utf-8") if isinstance(content, str) else content
    try:
        if target.is_dir():
            raise IsADirectoryError(0, "Is a directory")
        with temporary.open("xb") as file:  # opened by name, so that the user's umask sets the permissions
            file.write(data)
        os.replace(temporary, target)
    except OSError as error:
        raise OsculantError(f"Cannot write {os.fspath(path)}: {error.strerror or error}.") from error
    finally:
        with suppress(OSError):
            temporary.unlink()
