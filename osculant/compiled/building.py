"""Compiling a library, and putting it and what belongs to it into a folder, all or nothing."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Mapping
from pathlib import Path

from osculant.cas.errors import OsculantError

#: what a compiler is told: to keep the operations of the source, in their order, and no errno; gcc 12,
#: vectorising, makes fused operations of a product and a difference whatever they are told of contraction
FLAGS = (
    "-std=c11", "-O2", "-fno-tree-vectorize", "-fPIC", "-shared", "-ffp-contract=off", "-fno-math-errno",
    "-fvisibility=hidden",
)  # fmt: skip
#: seconds that it may take
PATIENCE = 300
#: processors that can be named
CPU = re.compile(r"[A-Za-z0-9][A-Za-z0-9._+-]*")


def compiler() -> list[str]:
    """The command of the C compiler: that of the environment's ``CC``, or ``cc``.

    Raises OsculantError if there is none.
    """
    command = shlex.split(os.environ.get("CC", "")) or ["cc"]
    if shutil.which(command[0]) is None:
        raise OsculantError(
            f"There is no C compiler {command[0]!r}: install one, such as gcc or clang, or name it in the "
            "environment's CC."
        )
    return command


def flags_for(cpu: str | None) -> list[str]:
    """The compiler's flags, for any processor of the machine's kind or for one.

    >>> flags_for("x86-64-v3")[-1]
    '-march=x86-64-v3'
    """
    if cpu is None:
        return list(FLAGS)
    if not CPU.fullmatch(cpu):
        raise OsculantError(f"{cpu!r} is no name of a processor: give one such as x86-64-v3 or native.")
    return [*FLAGS, f"-march={cpu}"]


def build(
    folder: str | os.PathLike[str], name: str, texts: Mapping[str, str], cpu: str | None = None
) -> Path:
    """Compile ``name.c`` to ``libname.so`` and put it and all texts into a folder.

    Args:
        folder: where; it is made if only it is missing.
        name: of the library.
        texts: the files, by name.
        cpu: what the compiler knows a processor by; any if None.

    Returns the library's path.  Raises OsculantError, with nothing written, where there is no compiler, it
    fails, or the folder cannot be written to.
    """
    command, flags, target = compiler(), flags_for(cpu), Path(folder)
    library = f"lib{name}.so"
    made = not target.exists()
    if not made and not target.is_dir():
        raise OsculantError(
            f"Cannot write to the folder {target}, as it is none: name one that is there or can be made."
        )
    try:
        target.mkdir(exist_ok=True)
        for file in (*texts, library):
            if (target / file).is_dir():
                raise IsADirectoryError(0, f"{file} is a folder there")
        with tempfile.TemporaryDirectory(prefix=f".{name}-", dir=target) as temporary:
            for file, text in texts.items():
                (Path(temporary) / file).write_text(text, encoding="utf-8")
            run([*command, *flags, "-o", library, f"{name}.c", "-lm"], temporary, command[0])
            for file in (*texts, library):
                os.replace(Path(temporary) / file, target / file)
    except OSError as error:
        _remove(target, made)
        reason = error.strerror or str(error)
        raise OsculantError(f"Cannot write to the folder {target}: {reason}.") from None
    except OsculantError:
        _remove(target, made)
        raise
    return target / library


def run(command: list[str], folder: str, name: str) -> None:
    """Run a compiler in a folder; raises OsculantError if it fails."""
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        raise OsculantError(
            f"The compiler {name} took longer than {PATIENCE} seconds: name another in CC."
        ) from None
    if done.returncode:
        said = next((line for line in done.stderr.splitlines() if "error" in line), done.stderr.strip()[:200])
        raise OsculantError(f"The compiler {name} failed: {said.strip().rstrip('.') or 'it gave no reason'}.")


def _remove(folder: Path, made: bool) -> None:
    """Remove a folder that was made for nothing."""
    if made and folder.is_dir() and not any(folder.iterdir()):
        folder.rmdir()
