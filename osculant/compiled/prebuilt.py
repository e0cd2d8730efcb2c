"""Building the kernels' own libraries: ``python -m osculant.compiled.prebuilt [FOLDER [FAMILY …]]``.

The kernels that Python calls are translated to C, a library for each family, with a manifest that tells
`osculant.kernels.prebuilt` how its functions are called.  It takes a C compiler; where there is none, numba
compiles the kernels when they are first called.  Neither numba nor sympy is loaded here: wheels are built
with numpy alone.
"""

from __future__ import annotations

import json
import os
import platform
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from osculant.cas.errors import OsculantError
from osculant.codegen.c.program import Translation
from osculant.codegen.c.types import (
    DOUBLE,
    INTEGER,
    JET,
    NOTHING,
    Array,
    Known,
    Scalar,
    Struct,
    Type,
)
from osculant.compiled.building import FLAGS, compiler, run
from osculant.compiled.faces import entries, families
from osculant.kernels import jit, operations, prebuilt

#: by the machine's kind, the processor that libraries are built for and what it must be able to do
PROCESSORS = {"x86_64": ("x86-64-v3", ("avx", "avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe"))}
#: what the fingerprint of a library says of how it was made
COMPILER = "C 2"
HEAD = """\
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#define INLINE static inline __attribute__((always_inline))
#define EXPORT __attribute__((visibility("default")))

"""
#: a jet is called with the address of its machine code
JETS = """\
static void through(double t, const double *address, double *out)
{
    ((void (*)(double, double *))(uintptr_t)address)(t, out);
}
"""


def described(kind: Type) -> Any:
    """A type as a manifest has it."""
    if isinstance(kind, Known):
        return "record"
    if isinstance(kind, Struct):
        made = None if kind.kind is None else f"{kind.kind.__module__}:{kind.kind.__name__}"
        return {"parts": [described(part) for part in kind.fields], "class": made}
    if isinstance(kind, Array):
        return kind.c
    names = {DOUBLE: "double", INTEGER: "integer", JET: "jet", NOTHING: "nothing"}
    return names.get(kind, "boolean")


class _Arguments:
    """The flat arguments of one function of C, and the expressions that put them together again."""

    def __init__(self, translation: Translation) -> None:
        self.translation, self.declared, self.lines = translation, list[str](), list[str]()

    def _new(self, kind: str) -> str:
        name = f"a{len(self.declared)}"
        self.declared.append(f"{kind}{name}" if kind.endswith("*") else f"{kind} {name}")
        return name

    def take(self, kind: Type) -> str:
        """The expression for the next argument."""
        if isinstance(kind, Struct):
            inside = ", ".join(self.take(part) for part in kind.fields)
            braces = f"{{{{{inside}}}}}" if kind.uniform else f"{{{inside}}}"
            return f"({self.translation.c_type(kind)}){braces}"
        if isinstance(kind, Array):
            axes = prebuilt.ARRAYS[kind.c][1]
            parts = [self._new(f"{kind.of.c} *"), *(self._new("int64_t") for _ in range(axes))]
            return f"({kind.c}){{{', '.join(parts)}}}"
        if kind is JET:
            name = self._new("int64_t")
            self.lines.append(f"const jet jet_{name} = {{through, (const double *)(uintptr_t){name}}};")
            return f"&jet_{name}"
        assert isinstance(kind, Scalar)
        return self._new("double" if kind is DOUBLE else "int64_t")


def _results(kind: Type, text: str) -> Iterator[str]:
    """The numbers of a result."""
    if isinstance(kind, Struct):
        for i, part in enumerate(kind.fields):
            yield from _results(part, f"{text}.{kind.member(i)}")
    elif kind is not NOTHING:
        yield text


def source(family: str) -> tuple[str, list[dict[str, Any]]]:
    """(the C file of a family, the functions in it as a manifest has them)."""
    listed = list(entries(family))
    translation = Translation(operations.registered(), operations.operations())
    texts, functions = list[str](), list[dict[str, Any]]()
    for entry in listed:
        made = translation.function(entry.kernel, entry.kinds)
        name = f"osculant_{len(texts)}"
        arguments = _Arguments(translation)
        passed = [arguments.take(kind) for kind in made.parameters if not isinstance(kind, Known)]
        lines = arguments.lines
        if made.room:
            lines.append(f"double room[{made.room}];")
            passed.insert(0, "room")
        call = f"{made.name}({', '.join(passed)})"
        if made.result is NOTHING:
            lines += [f"{call};", "(void)out;"]
        else:
            lines.append(f"const {translation.c_type(made.result)} found = {call};")
            numbers = _results(made.result, "found")
            lines += [f"out[{i}] = (double){text};" for i, text in enumerate(numbers)]
        inside = "\n".join(f"    {line}" for line in lines)
        declared = ", ".join([*arguments.declared, "double *out"])
        texts.append(f"EXPORT void {name}({declared});\nEXPORT void {name}({declared})\n{{\n{inside}\n}}\n")
        functions.append(
            {
                "name": name,
                "kernel": f"{entry.kernel.__module__}.{entry.kernel.__name__}",
                "record": None if entry.record is None else repr(entry.record),
                "takes": [described(kind) for kind in entry.kinds],
                "gives": described(made.result),
            }
        )
    return "\n".join([HEAD, translation.text(), JETS, *texts]), functions


# --- building --------------------------------------------------------------------------------------------


def build(family: str, folder: Path) -> None:
    """Compile a family's library into a folder, and write its manifest.

    Raises OsculantError where there is no compiler or it fails.
    """
    command = compiler()
    processor, needs = PROCESSORS.get(platform.machine(), (None, ()))
    flags = [*FLAGS, *([f"-march={processor}"] if processor else [])]
    text, functions = source(family)
    sources = jit.sources(jit.modules_of(family))
    manifest = {
        "library": f"{family}.so",
        "compiler": COMPILER,
        "sources": [str(path.relative_to(jit.ROOM)) for path in sources],
        "fingerprint": prebuilt.hashed(COMPILER, sources),
        "needs": [platform.machine(), *needs],
        "functions": functions,
    }
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=f".{family}-", dir=folder) as temporary:
        (Path(temporary) / f"{family}.c").write_text(text, encoding="utf-8")
        (Path(temporary) / f"{family}.json").write_text(json.dumps(manifest), encoding="utf-8")
        run([*command, *flags, "-o", f"{family}.so", f"{family}.c", "-lm"], temporary, command[0])
        for name in (f"{family}.so", f"{family}.json"):
            os.replace(Path(temporary) / name, folder / name)


def missing(folder: Path, wanted: Sequence[str]) -> list[str]:
    """The families whose library is not there or not of these sources."""

    def fits(family: str) -> bool:
        try:
            manifest = json.loads((folder / f"{family}.json").read_text(encoding="utf-8"))
            there = (folder / manifest["library"]).is_file()
            return there and manifest["compiler"] == COMPILER and prebuilt.current(manifest)
        except (OSError, ValueError, KeyError):
            return False

    return [family for family in wanted if not fits(family)]


def build_all(folder: Path, wanted: Sequence[str], tell: Callable[[str], None]) -> None:
    """Build those of the wanted families that are missing, a line told for each."""
    found = missing(folder, wanted)
    for i, family in enumerate(found):
        tell(f"compiling the kernels of {family}, {i + 1} of {len(found)}, once")
        build(family, folder)


def main(arguments: Sequence[str]) -> int:
    """Build what is missing, into a folder, the package's if none is named; of the families named after it.

    Returns the exit status, 2 for arguments that make no sense. Where nothing can be built, a line says so,
    and numba will compile: no error.
    """
    known = families()
    if arguments and arguments[0] in known:
        return _refuse(
            f"The folder comes first, and {arguments[0]} is a family: give {prebuilt.FOLDER} before it, or "
            f"{os.path.join('.', arguments[0])} for a folder of that name."
        )
    if unknown := [family for family in arguments[1:] if family not in known]:
        return _refuse(f"There is no family {unknown[0]!r} of kernels: name those of {', '.join(known)}.")
    folder = Path(arguments[0]) if arguments else prebuilt.FOLDER
    try:
        build_all(folder, arguments[1:] or known, _tell)
    except (OsculantError, OSError) as error:
        _tell(f"kernels will be compiled when they are first called. {error}")
    return 0


def _refuse(sentence: str) -> int:
    _tell(sentence)
    return 2


def _tell(line: str) -> None:
    print(f"osculant: {line}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
