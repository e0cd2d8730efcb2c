"""Writing files whole or not at all."""

from __future__ import annotations

import os
import secrets
import sys
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from osculant.cas.errors import OsculantError

#: a path of this and a suffix, "-.svg", is standard output in that format
STDOUT = "-"


def stands_for_stdout(path: str | os.PathLike[str]) -> bool:
    """Whether a path names standard output, in a format.

    >>> [stands_for_stdout(path) for path in ("-.svg", "a-.svg", "-", "./-.svg")]
    [True, False, False, False]
    """
    before, point, _ = os.fspath(path).rpartition(".")
    return before == STDOUT and bool(point)


def listed(words: Sequence[str], last: str = "and") -> str:
    """The words with commas and, before the last of several, an "and" or so.

    >>> listed([".a", ".b", ".c"]), listed(["mm", "inch"], "or"), listed([".a"])
    ('.a, .b and .c', 'mm or inch', '.a')
    """
    return f" {last} ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def not_installed(what: str, package: str, extra: str) -> OsculantError:
    """The error about a package that is missing, one of an extra of osculant.

    >>> not_installed("Drawing", "matplotlib", "plot")
    OsculantError('Drawing needs matplotlib, which is not installed; `pip install osculant[plot]` adds it.')
    """
    return OsculantError(
        f"{what} needs {package}, which is not installed; `pip install osculant[{extra}]` adds it."
    )


def write_out(path: str | os.PathLike[str], content: str) -> None:
    """Write to a file, whole or not at all, or to standard output."""
    if stands_for_stdout(path):
        sys.stdout.write(content)
        sys.stdout.flush()
    else:
        write_whole(path, content)


def write_whole(path: str | os.PathLike[str], content: str | bytes) -> None:
    """Write a file by way of a temporary one in the same folder: readers see all of it, or the old one.

    Args:
        path: where to write; a link is followed, an existing file is replaced, but no device or pipe.
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
        if target.exists() and not target.is_file():
            raise OSError(0, "Not an ordinary file")
        with temporary.open("xb") as file:  # opened by name, so that the user's umask sets the permissions
            file.write(data)
        os.replace(temporary, target)
    except OSError as error:
        raise OsculantError(f"Cannot write {os.fspath(path)}: {error.strerror or error}.") from error
    finally:
        with suppress(OSError):
            temporary.unlink()


def check_place(path: str | os.PathLike[str]) -> None:
    """Refuse a file that could not be written where it is to be; raises OsculantError, touches nothing."""
    if stands_for_stdout(path):
        return
    target = Path(os.path.realpath(path))
    folder = target.parent
    if os.path.isdir(target):
        reason = "it is a folder"
    elif not os.path.exists(folder):
        reason = f"there is no folder {folder}; make it first"
    elif not os.path.isdir(folder):
        reason = f"{folder} is not a folder"
    elif not os.access(folder, os.W_OK | os.X_OK):
        reason = f"nothing may be written in the folder {folder}"
    else:
        return
    shown = f"Cannot write {os.fspath(path)}: {reason}.".encode("utf-8", "backslashreplace")
    raise OsculantError(shown.decode("utf-8"))
