"""Jobs that are timed in turn, so that whatever else the machine does falls on all alike."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from typing import Any

#: rounds, and seconds that one job gets in each of them
ROUNDS, ENOUGH = 5, 4e-3
#: a job that takes so many seconds has one round
SLOW = 1.0


class AbsentError(Exception):
    """A peer that is not installed, or cannot do what is asked."""


@dataclass(frozen=True)
class Job:
    """What is timed, and what makes of its result what is compared."""

    run: Callable[[], Any]
    read: Callable[[Any], Any]


def installed(package: str) -> str:
    """The version of a peer; raises AbsentError if it is not there."""
    try:
        return version(package)
    except PackageNotFoundError:
        raise AbsentError(f"{package} is not installed") from None


def medians(jobs: Mapping[str, Job]) -> dict[str, float]:
    """The median seconds of each job, rounds interleaved; all are warm."""
    often: dict[str, int] = {}
    times: dict[str, list[float]] = {name: [] for name in jobs}
    for name, job in jobs.items():
        before = time.perf_counter()
        job.run()
        took = time.perf_counter() - before
        often[name] = max(1, min(100, int(ENOUGH / took)))
        times[name].append(took)
    for _ in range(ROUNDS):
        for name, job in jobs.items():
            if times[name][0] > SLOW:
                continue
            before = time.perf_counter()
            for _ in range(often[name]):
                job.run()
            times[name].append((time.perf_counter() - before) / often[name])
    return {name: statistics.median(own[1:] or own) for name, own in times.items()}
