"""What all commands print with: rows for people, JSON for programs, a bar for those who wait."""

from __future__ import annotations

import json
import os
import sys
import textwrap
from collections.abc import Iterable
from contextlib import suppress
from shutil import get_terminal_size
from time import perf_counter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import TracebackType

    from rich.console import Console
    from rich.progress import Progress

#: seconds before a progress bar appears
PATIENCE = 1.0
#: and between lines that say how far the work is
PAUSE = 10.0
#: columns of an output that is no terminal
ENDLESS = 200
#: columns of running text at most
WIDEST = 110


class Waiting:
    """A progress bar on stderr, shown only on a terminal and after `PATIENCE` seconds.

    With ``lines`` it says how far the work is where there is no terminal, too: once in `PAUSE` seconds.

    Call it with the part that is done, 0…1; use it as a context manager, so that it goes away.

    >>> with Waiting("counting") as progress:
    ...     progress(0.5)
    """

    def __init__(self, what: str, lines: bool = False) -> None:
        self.what, self.began, self.lines = what, perf_counter(), lines
        self.told = self.began + PATIENCE - PAUSE
        self.bar: Progress | None = None

    def __enter__(self) -> Waiting:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self.bar is not None:
            self.bar.stop()

    def __call__(self, part: float) -> None:
        """Show the part that is done."""
        if self.lines and sys.stderr is not None and not sys.stderr.isatty():
            if perf_counter() - self.told >= PAUSE:
                self.told = perf_counter()
                tell(f"{self.what}: {part:.0%} done")
            return
        if self.bar is None:
            if sys.stderr is None or not sys.stderr.isatty() or perf_counter() - self.began < PATIENCE:
                return
            from rich.console import Console
            from rich.progress import Progress

            self.bar = Progress(console=Console(stderr=True), transient=True)
            self.bar.add_task(self.what, total=1.0)
            self.bar.start()
        self.bar.update(self.bar.task_ids[0], completed=part)


def tell(sentence: str) -> None:
    """Print a sentence for people on stderr, if there is one; stdout is for what was asked for."""
    if sys.stderr is not None:  # it was closed before the start
        with suppress(OSError):
            print(f"osculant: {printable(sentence)}", file=sys.stderr, flush=True)


def announce_compiling() -> None:
    """Say that kernels are being compiled, if they have to be, which happens once on a machine."""
    from osculant.kernels.jit import when_compiling

    when_compiling(lambda: tell("compiling kernels for this machine, once: ten seconds to half a minute."))


def print_json(data: Any) -> None:
    """Print plain data as JSON, letters as they are if the output has them all.

    >>> print_json({"interval": [0, 1.5]})
    {
     "interval": [
      0,
      1.5
     ]
    }
    """
    universal = (getattr(sys.stdout, "encoding", None) or "").lower().startswith("utf")
    print(json.dumps(data, indent=1, allow_nan=False, ensure_ascii=not universal))


def print_rows(rows: Iterable[tuple[str, str]], least: int = 0, columns: int | None = None) -> None:
    """Print names and texts in two columns; the lines of a text stay lines.

    Args:
        rows: the names and the texts.
        least: width of the column of names at least.
        columns: longer lines are broken between words; None breaks none.

    >>> print_rows([("rank", "2"), ("stable", "yes")])
    rank    2
    stable  yes
    """
    rows = list(rows)
    margin = max([least, *(len(name) + 2 for name, _ in rows)])
    width = sys.maxsize if columns is None else max(columns - margin, 1)
    breaking = textwrap.TextWrapper(width, break_long_words=False, break_on_hyphens=False)
    for name, text in rows:
        lines = text.splitlines() or [""]
        if columns is not None:
            lines = [part for line in lines for part in breaking.wrap(line) or [""]]
        for place, line in enumerate(lines):
            print(f"{'' if place else name:<{margin}}{line}".rstrip())


def printable(text: str) -> str:
    r"""Text fit for any output: what is no valid Unicode (in a file's name) as an escape.

    >>> printable("a\udcff.svg")
    'a\\udcff.svg'
    """
    return text.encode("utf-8", "backslashreplace").decode("utf-8")


def output_width() -> int:
    """Columns of the output: those of a terminal or of the variable COLUMNS, otherwise `ENDLESS`."""
    return get_terminal_size().columns if sys.stdout.isatty() or "COLUMNS" in os.environ else ENDLESS


def console() -> Console:
    """The output for tables: rich, but text only, no markup."""
    from rich.console import Console

    return Console(width=output_width(), markup=False, emoji=False, highlight=False)


def lenient() -> None:
    """Let an output that has no mathematical letters, such as ASCII, show a question mark for each."""
    reconfigure = getattr(sys.stdout, "reconfigure", None)
    if reconfigure is not None:
        reconfigure(errors="replace")
