"""The one decorator of all kernels, and where their machine code is kept.

What Python calls is taken from a library that was built before (`osculant.kernels.prebuilt`), if there is one
that fits; numba is not even imported then.  Else a kernel is compiled when it is first called: nogil, IEEE
semantics (no fastmath).  Kernels called by kernels become part of their callers, without the wrappers that
Python needs; what Python calls is kept on disk, in a folder for each family.  numba's cache does not notice
that a callee in another file changed, so the folder's name carries a hash of all sources of the family's
code: an edit recompiles the families that it touches.
"""

from __future__ import annotations

import os
import re
import shutil
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import cache, cached_property, update_wrapper
from pathlib import Path
from typing import Any, Protocol, TypeVar, cast

from osculant.kernels.prebuilt import face_of, hashed

Function = TypeVar("Function", bound=Callable[..., Any])

#: how many versions of one family's machine code may lie in the cache folder
KEPT_VERSIONS = 3
#: what all kernels are compiled with, and those that only kernels call
OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy"}
BARE: Any = {**OPTIONS, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}

#: the room, and how its modules import each other
ROOM = Path(__file__).parent
PACKAGE = __name__.rpartition(".")[0]
IMPORTS = re.compile(rf"^ *from ({re.escape(PACKAGE)}[\w.]*) import (\([^)]*\)|[^\n]*)", re.MULTILINE)


def cache_root() -> Path:
    """The user's cache folder of osculant (``OSCULANT_CACHE`` overrides it)."""
    if chosen := os.environ.get("OSCULANT_CACHE"):
        return Path(chosen)
    import platformdirs

    return Path(platformdirs.user_cache_dir("osculant"))


#: what is to be told numba as soon as it is there
_waiting: list[Callable[[], None]] = []


@cache
def numba() -> Any:
    """The compiler, imported when it is first needed."""
    import numba
    from numba.core import event

    class Listener(event.Listener):
        """Passes on when numba compiles."""

        def on_start(self, happening: Any) -> None:
            for watch in tuple(_watches):
                watch.begun()

        def on_end(self, happening: Any) -> None:
            for watch in tuple(_watches):
                watch.ended()

    event.register("numba:compile", Listener())  # type: ignore[no-untyped-call]
    while _waiting:
        _waiting.pop(0)()
    return numba


def when_numba_is_there(call: Callable[[], None]) -> None:
    """Call ``call`` before numba is first used, at once if it was."""
    if numba.cache_info().currsize:
        call()
    else:
        _waiting.append(call)


def kernel(function: Function) -> Function:
    """Compile a function of numbers and contiguous arrays when it is first called."""
    return cast(Function, Kernel(function))


class Kernel:
    """What `kernel` makes: kernels call its machine code, Python calls a face of it.

    A generic kernel has a face for each family: the type of its first argument tells which
    (`osculant.kernels.operations`).
    """

    def __init__(self, function: Callable[..., Any]) -> None:
        update_wrapper(self, function)
        self._function = function
        self._faces: dict[type, Any] = {}

    @cached_property
    def _bare(self) -> Any:
        """Its machine code inside kernels."""
        return numba().njit(**BARE)(self._function)

    @property
    def _numba_type_(self) -> Any:
        """What numba takes it for inside a kernel."""
        return self._bare._numba_type_

    def __call__(self, *args: Any) -> Any:
        """Call the machine code, after compiling it if it is not there yet."""
        first = type(args[0]) if args else type(None)
        face = self._faces.get(first) or self._face(first)
        try:
            return face(*args)
        except Exception:  # kernels raise nothing: damaged entries of the cache raise whatever pickle does,
            # before anything was computed; what is no fault of theirs is raised again
            self._faces[first] = numba().njit(**OPTIONS)(self._function)
            return self._faces[first](*args)

    def _face(self, first: type) -> Any:
        """The machine code that Python calls with such a first argument: prebuilt, from disk, or made now."""
        family = family_of(self.__module__, first.__module__)
        self._faces[first] = face_of(family, self, first) or self._compiled(family)
        return self._faces[first]

    def _compiled(self, family: str) -> Any:
        """What numba compiles, or finds on disk."""
        settings: Any = numba().core.config  # numba's settings, filled in at run time
        before = settings.CACHE_DIR
        settings.CACHE_DIR = str(folder_of(family))
        try:
            return numba().njit(cache=True, **OPTIONS)(self._function)
        finally:
            settings.CACHE_DIR = before


def sources(modules: Iterable[str]) -> list[Path]:
    """The files of kernels that code in these modules is made from, themselves among them, in order.

    >>> [path.stem for path in sources(["osculant.kernels.curves.vectors"])]
    ['vectors', 'jit', 'prebuilt']
    """
    found: dict[Path, None] = {}
    pending = list(modules)
    while pending:
        path = _file(pending.pop())
        if path is not None and path not in found:
            found[path] = None
            for parent, names in IMPORTS.findall(path.read_text(encoding="utf-8")):
                pending += [parent, *(f"{parent}.{name}" for name in re.findall(r"\w+", names))]
    return sorted(found)


def _file(module: str) -> Path | None:
    """The file of a module of this room, None for the name of something else in a module."""
    path = ROOM.joinpath(*module.removeprefix(PACKAGE).strip(".").split("."))
    return path.with_suffix(".py") if path.with_suffix(".py").is_file() else None


def family_of(*modules: str) -> str:
    """The family of the first of the modules that is in one, a folder of this room; else "generic".

    >>> family_of("osculant.kernels.search", "osculant.kernels.conics.records")
    'conics'
    """
    for module in modules:
        package, _, rest = module.partition(f"{PACKAGE}.")
        if not package and "." in rest:
            return rest.split(".")[0]
    return "generic"


def modules_of(family: str) -> list[str]:
    """The modules of a family, and the generic ones, which have machine code in its folder."""
    own = [f"{PACKAGE}.{family}.{path.stem}" for path in (ROOM / family).glob("*.py")]
    return own + [f"{PACKAGE}.{path.stem}" for path in ROOM.glob("*.py")]


def fingerprint(family: str) -> str:
    """A hash of all sources of a family's machine code, and of the version of numba."""
    return hashed(numba().__version__, sources(modules_of(family)))


@cache
def folder_of(family: str) -> Path:
    """The folder of a family's machine code, made if it is not there; then old versions go."""
    folder = cache_root() / f"kernels-{family}-{fingerprint(family)}"
    try:
        fresh = not folder.is_dir()
        folder.mkdir(parents=True, exist_ok=True)
        if fresh:
            siblings = sorted(folder.parent.glob(f"kernels-{family}-*"), key=lambda p: p.stat().st_mtime)
            for old in siblings[:-KEPT_VERSIONS]:
                shutil.rmtree(old, ignore_errors=True)
        if not os.access(folder, os.W_OK):
            raise OSError
        return folder
    except OSError:  # a read-only home: compile anew in every process
        return Path(tempfile.mkdtemp(prefix="osculant-"))


class Watch(Protocol):
    """What wants to know when kernels are compiled."""

    def begun(self) -> None:
        """A kernel, or one that it calls, is being compiled."""

    def ended(self) -> None:
        """It is done."""


_watches: list[Watch] = []


@contextmanager
def watching(watch: Watch) -> Iterator[None]:
    """Tell a watch of what is compiled meanwhile."""
    _watches.append(watch)
    try:
        yield
    finally:
        _watches.remove(watch)


class _Notice:
    """Calls once, when something is compiled for the first time."""

    call: Callable[[], None] | None = None

    def begun(self) -> None:
        call, self.call = self.call, None
        if call is not None:
            call()

    def ended(self) -> None:
        """Nothing: the beginning is told."""


_NOTICE = _Notice()
_watches.append(_NOTICE)


def when_compiling(call: Callable[[], None]) -> None:
    """Call ``call`` once, as soon as a kernel has to be compiled in this process and is not found on disk.

    It takes the place of what was to be called before.
    """
    _NOTICE.call = call


class CompileClock:
    """A `Watch` that runs while kernels are compiled.

    >>> clock = CompileClock()
    >>> clock.running, clock.seconds
    (False, 0.0)
    """

    def __init__(self) -> None:
        self._open, self._since, self._before = 0, 0.0, 0.0

    def begun(self) -> None:
        """A kernel, or one that it calls."""
        if not self._open:
            self._since = time.perf_counter()
        self._open += 1

    def ended(self) -> None:
        """The same."""
        self._open -= 1
        if not self._open:
            self._before += time.perf_counter() - self._since

    @property
    def running(self) -> bool:
        """Whether something is being compiled now."""
        return self._open > 0

    @property
    def seconds(self) -> float:
        """How long it has run, but for now."""
        return self._before
