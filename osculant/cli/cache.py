"""The command ``osculant cache``: where compiled kernels are kept, and how to be rid of them.

JSON, version 1: {"version", "folder", "files", "bytes"}; after ``clear`` these are what is left, and
"removed_files" and "removed_bytes" tell what went.
"""

from __future__ import annotations

import re
import shutil
from contextlib import suppress
from pathlib import Path
from typing import Annotated, Any

import typer

from osculant.cas.errors import OsculantError
from osculant.cli.grammar import UsageError, unknown
from osculant.cli.options import AsJson
from osculant.cli.output import print_json, print_rows, printable

#: what osculant calls the folders that it makes in its cache folder; everything else there is not its own
OURS = re.compile(r"kernels(-\w+)?-[0-9a-f]{16}")
CLEAR = "clear"


def cache(
    action: Annotated[
        str | None, typer.Argument(metavar="clear", help="Remove what is kept; kernels are compiled anew.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Show where compiled kernels are kept and how much room they take, or clear that folder.

    The variable OSCULANT_CACHE names another folder.
    """
    if action not in (None, CLEAR):
        raise UsageError(unknown("action", str(action), [CLEAR]))

    from osculant.kernels.jit import cache_root

    root = cache_root()
    files, size = contents(root)
    data: dict[str, Any] = {"version": 1, "folder": str(root), "files": files, "bytes": size}
    rows = [("folder", printable(str(root))), ("kept", _amount(files, size))]
    if action == CLEAR:
        clear(root)
        left, left_size = contents(root)
        data |= {"files": left, "bytes": left_size}
        data |= {"removed_files": files - left, "removed_bytes": size - left_size}
        rows[1:] = [("removed", _amount(files - left, size - left_size))]
        if left:
            raise OsculantError(
                f"Could not clear all of {printable(str(root))}: left are {_amount(left, left_size)}, "
                "protected or just being written by another process; try again later."
            )
    if as_json:
        print_json(data)
    else:
        print_rows(rows)


def contents(root: Path) -> tuple[int, int]:
    """The number of files that osculant keeps below its cache folder, and their size in bytes.

    >>> contents(Path("/no/such/folder"))
    (0, 0)
    """
    sizes = []
    for folder in _folders(root):
        for path in folder.rglob("*"):
            with suppress(OSError):  # another process may be clearing, too
                if path.is_file():
                    sizes.append(path.stat().st_size)
    return len(sizes), sum(sizes)


def clear(root: Path) -> None:
    """Remove the folders that osculant made below its cache folder, as far as that is possible.

    Processes that run go on with the code that they have; what they compile afterwards is kept again.
    """
    for folder in _folders(root):
        shutil.rmtree(folder, ignore_errors=True)


def _folders(root: Path) -> list[Path]:
    """The folders that osculant made there, no links."""
    if not root.is_dir():
        return []
    return [
        path
        for path in root.iterdir()
        if OURS.fullmatch(path.name) and path.is_dir() and not path.is_symlink()
    ]


def _amount(files: int, size: int) -> str:
    """A number of files and their size, for people.

    >>> _amount(1, 2_345_678)
    '1 file, 2.3 MB'
    """
    return f"{files} file{'' if files == 1 else 's'}, {size / 1e6:.1f} MB"
