"""Processes that help this one: the processor time of all, and an end to them when this one is gone."""

from __future__ import annotations

import json
import os
import signal
import threading
import time
from contextlib import suppress
from pathlib import Path
from typing import Any


class Cost:
    """The processor time of a process and of its children, from now on.

    The system tells it where it has a folder /proc; elsewhere the time since the process began counts, which
    is no less for one that does one thing at a time.

    Args:
        pid: the number of the process.
    """

    def __init__(self, pid: int) -> None:
        self.pid, self.begun = pid, time.monotonic()
        self.known: float | None = None

    def seconds(self) -> float:
        """What it took until now, or until its end."""
        if self.known is not None:
            return self.known
        try:
            return _told(self.pid, True)
        except (OSError, ValueError, IndexError):
            return time.monotonic() - self.begun

    def ended(self, seconds: float | None = None) -> None:
        """Take notice that it is over, or is about to be; it may have told its seconds itself."""
        if self.known is None:
            self.known = self.seconds() if seconds is None else seconds


#: of all processes that `counted` was told of: those that may still run, and the seconds of the others
_running: list[Cost] = []
_over = [0.0]


def counted(pid: int) -> Cost:
    """The cost of a process that was begun; from now on `processor_time` includes it."""
    cost = Cost(pid)
    _running.append(cost)
    return cost


def processor_time() -> float:
    """Seconds of processor time of this process and of all that were `counted`.

    >>> begun = processor_time()
    >>> 0 <= processor_time() - begun < 1
    True
    """
    for cost in [cost for cost in _running if cost.known is not None]:
        with suppress(ValueError):  # another thread was quicker
            _running.remove(cost)
            _over[0] += cost.seconds()
    return time.process_time() + _over[0] + sum(cost.seconds() for cost in list(_running))


def _told(pid: int, family: bool) -> float:
    """The time of a process, of its children that ended and, for the family, of those that run."""
    text = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    seconds = sum(map(int, text[11:15])) / os.sysconf("SC_CLK_TCK")
    if family:
        with suppress(OSError):
            for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split():
                seconds += _told(int(child), False)
    return seconds


def question() -> Any:
    """What a helper is asked: a line of JSON on standard input. It ends when that is closed.

    Who asks keeps the other end open as long as the answer is wanted; it is closed too when that process is
    killed. A helper that leads a group of processes takes them along.
    """
    with os.fdopen(os.dup(0), "rb", closefd=True) as given:
        asked = json.loads(given.readline())
    threading.Thread(target=_end_with_input, daemon=True).start()
    return asked


def _end_with_input() -> None:
    while os.read(0, 1):
        pass
    if hasattr(os, "killpg") and os.getpgrp() == os.getpid():
        os.killpg(os.getpgrp(), signal.SIGKILL)
    os._exit(1)
