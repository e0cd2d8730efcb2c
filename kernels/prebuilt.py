"""Kernels from libraries that were built before: how Python calls them, with no compiler at run time.

A family's library lies in the folder `FOLDER`, beside a manifest of the functions in it and their types
(`osculant.compiled.prebuilt` builds both).  It is taken if the kernels' sources are those that it was built
from and the processor has what it needs; what is not in it is compiled by numba.
"""

from __future__ import annotations

import ctypes
import hashlib
import importlib
import json
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

#: the room, and where the libraries are
ROOM = Path(__file__).parent
FOLDER = ROOM / "libraries"
#: set to "no", it leaves them out
SWITCH = "OSCULANT_PREBUILT"
#: numpy's kinds of numbers and the number of axes, by the type of an array
ARRAYS = {"row": ("f", 1), "table": ("f", 2), "integers": ("i", 1), "integer_table": ("i", 2)}
SCALARS = {
    "double": ctypes.c_double,
    "integer": ctypes.c_int64,
    "boolean": ctypes.c_int64,
    "jet": ctypes.c_int64,
}

#: a type in a manifest: a name, or the parts of a tuple and where its class is
Kind = Any
Flatten = Callable[[Any, list[Any]], None]


def face_of(family: str, kernel: Any, first: type) -> Callable[..., Any] | None:
    """What Python calls for a kernel whose first argument is of that type; None if there is nothing."""
    if os.environ.get(SWITCH) == "no":
        return None
    loaded = library(family)
    if loaded is None:
        return None
    found = [entry for entry in loaded[1] if entry["kernel"] == f"{kernel.__module__}.{kernel.__name__}"]
    faces = {
        entry["record"]: face(loaded[0], entry)
        for entry in found
        if (entry["record"] or "").partition("(")[0] in ("", first.__name__)
    }
    if None not in faces and getattr(first, "_fields", None):  # records that say something
        return _by_record(faces) if faces else None
    return next(iter(faces.values()), None)


@cache
def library(family: str) -> tuple[ctypes.CDLL, list[dict[str, Any]]] | None:
    """(library, its functions) of a family; None if there is none that fits."""
    try:
        manifest = json.loads((FOLDER / f"{family}.json").read_text(encoding="utf-8"))
        if not current(manifest) or not set(manifest["needs"]) <= features():
            return None
        return ctypes.CDLL(str(FOLDER / manifest["library"])), manifest["functions"]
    except (OSError, ValueError, KeyError):  # not there, or damaged
        return None


def current(manifest: dict[str, Any]) -> bool:
    """Whether the files that a library was built from are as they were: one that is new changes another."""
    paths = (ROOM / name for name in manifest["sources"])
    return bool(manifest["fingerprint"] == hashed(manifest["compiler"], paths))


def hashed(compiler: str, paths: Iterable[Path]) -> str:
    """A hash of what compiles and of the files that it compiles."""
    digest = hashlib.sha256(compiler.encode())
    for path in paths:
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


@cache
def features() -> frozenset[str]:
    """What the processor can do, as LLVM calls it, and its kind."""
    import platform

    import llvmlite.binding as llvm

    found = {name for name, has in llvm.get_host_cpu_features().items() if has}
    return frozenset(found | {platform.machine()})


def _by_record(records: dict[str, Callable[..., Any]]) -> Callable[..., Any]:
    """A function that chooses by what the record says; a KeyError means that it is not there."""

    def call(*arguments: Any) -> Any:
        return records[repr(arguments[0])](*arguments)

    return call


def face(loaded: ctypes.CDLL, entry: dict[str, Any]) -> Callable[..., Any]:
    """The function of Python for one of the library, as its manifest describes it."""
    takes, gives = entry["takes"], entry["gives"]
    function = getattr(loaded, entry["name"])
    leaves = [leaf for kind in takes for leaf in _leaves(kind)]
    count = sum(1 for _ in _result_leaves(gives))
    function.argtypes = [*leaves, ctypes.c_void_p]
    function.restype = None
    flatten = [(i, _flatten(kind)) for i, kind in enumerate(takes) if kind != "record"]
    build, room = _build(gives), ctypes.c_double * max(count, 1)
    expected = len(takes)

    def call(*arguments: Any) -> Any:
        if len(arguments) != expected:
            raise TypeError(f"{entry['kernel']} takes {expected} arguments")
        flat: list[Any] = []
        for i, flattened in flatten:
            flattened(arguments[i], flat)
        out = room()
        function(*flat, ctypes.addressof(out))
        return build(iter(out))

    return call


def _leaves(kind: Kind) -> Iterator[Any]:
    """The types of C that an argument is passed as."""
    if isinstance(kind, dict):
        for part in kind["parts"]:
            yield from _leaves(part)
    elif kind in ARRAYS:
        yield from (ctypes.c_void_p, *[ctypes.c_int64] * ARRAYS[kind][1])
    elif kind != "record":
        yield SCALARS[kind]


def _flatten(kind: Kind) -> Flatten:
    """What appends an argument's parts to those that are passed."""
    if isinstance(kind, dict):
        if all(isinstance(part, str) and part in SCALARS for part in kind["parts"]):
            return lambda value, flat: flat.extend(value)
        parts = [_flatten(part) for part in kind["parts"]]

        def each(value: Any, flat: list[Any]) -> None:
            for part, flattened in zip(value, parts, strict=True):
                flattened(part, flat)

        return each
    if kind in ARRAYS:
        letter, axes = ARRAYS[kind]
        dtype = np.dtype(f"{letter}8")

        def array(value: np.ndarray[Any, Any], flat: list[Any]) -> None:
            if value.dtype != dtype or value.ndim != axes or not value.flags.c_contiguous:
                raise TypeError("an array that kernels do not take")
            flat.append(value.__array_interface__["data"][0])  # quicker than its ctypes
            flat.extend(value.shape)

        return array
    return lambda value, flat: flat.append(value)


def _result_leaves(kind: Kind) -> Iterator[str]:
    if isinstance(kind, dict):
        for part in kind["parts"]:
            yield from _result_leaves(part)
    elif kind != "nothing":
        yield kind


def _build(kind: Kind) -> Callable[[Iterator[float]], Any]:
    """What makes a result from its numbers."""
    if isinstance(kind, dict):
        parts: Sequence[Any] = [_build(part) for part in kind["parts"]]
        made = _class(kind["class"])
        return lambda numbers: made([part(numbers) for part in parts])
    if kind == "nothing":
        return lambda numbers: None
    if kind == "double":
        return next
    return (
        (lambda numbers: bool(next(numbers))) if kind == "boolean" else (lambda numbers: int(next(numbers)))
    )


def _class(name: str | None) -> Callable[[Sequence[Any]], Any]:
    """A tuple's class from its parts."""
    if name is None:
        return tuple
    module, _, attribute = name.partition(":")
    made = getattr(importlib.import_module(module), attribute)
    return lambda parts: made(*parts)
