"""The one decorator of all kernels, and where their machine code is kept.

Kernels are compiled once per machine and version: nogil, cached on disk, IEEE semantics (no
fastmath).  numba's cache does not notice that a callee in another file changed, so the folder's
name carries a hash of all kernel sources; older folders are deleted.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar, cast

import numba
import platformdirs
from numba.core import config

Function = TypeVar("Function", bound=Callable[..., Any])

#: how many compiled versions of the kernels may lie in the cache folder
KEPT_VERSIONS = 3


def cache_root() -> Path:
    """The user's cache folder of osculant (``OSCULANT_CACHE`` overrides it)."""
    return Path(os.environ.get("OSCULANT_CACHE") or platformdirs.user_cache_dir("osculant"))


def _source_hash() -> str:
    digest = hashlib.sha256(numba.__version__.encode())
    for path in sorted(Path(__file__).parent.rglob("*.py")):
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def _prepare_folder() -> tuple[Path, bool]:
    """The folder of this version's machine code, and whether it had to be made."""
    folder = cache_root() / f"kernels-{_source_hash()}"
    try:
        fresh = not folder.is_dir()
        folder.mkdir(parents=True, exist_ok=True)
        if fresh:
            siblings = sorted(folder.parent.glob("kernels-*"), key=lambda p: p.stat().st_mtime)
            for old in siblings[:-KEPT_VERSIONS]:
                shutil.rmtree(old, ignore_errors=True)
        if not os.access(folder, os.W_OK):
            raise OSError
        return folder, fresh
    except OSError:  # a read-only home: compile anew in every process
        return Path(tempfile.mkdtemp(prefix="osculant-")), True


#: where the machine code lies; ``FRESH`` is true if nothing had been compiled when it was made
FOLDER, FRESH = _prepare_folder()


def kernel(function: Function) -> Function:
    """Compile a function of numbers and contiguous arrays: cached, nogil, no fastmath."""
    settings: Any = config  # numba's settings, filled in at run time
    before = settings.CACHE_DIR
    settings.CACHE_DIR = str(FOLDER)
    try:
        compiled = numba.njit(cache=True, nogil=True, error_model="numpy")(function)
    finally:
        settings.CACHE_DIR = before
    return cast(Function, compiled)


def announce() -> None:
    """Say on stderr, once, that this machine's first run compiles kernels."""
    global FRESH
    if FRESH:
        print(
            "osculant: compiling its kernels for this machine, once; this takes half a minute.",
            file=sys.stderr,
        )
        FRESH = False
