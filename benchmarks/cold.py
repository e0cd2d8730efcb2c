"""What a machine waits for once: `python -m benchmarks.cold`.

For each kind of pieces a new process with an empty cache: CPU seconds to its first spline, and the kernels
compiled; then the same with the cache that the process left.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile

JOBS = {
    "conic": ("t*cos(t), t*sin(t)", "conic", "hausdorff"),
    "parabola": ("t*cos(t), t*sin(t)", "parabola", "hausdorff"),
    "biarc": ("t*cos(t), t*sin(t)", "biarc", "hausdorff"),
    "polygon": ("t*cos(t), t*sin(t)", "polygon", "hausdorff"),
    "conic, area": ("t*cos(t), t*sin(t)", "conic", "area"),
    "bihelix": ("t*cos(t), t*sin(t), t", "bihelix", "hausdorff"),
}
CODE = """
import sys, time
from numba.core import event
class Count(event.Listener):
    n = 0
    def on_start(self, happening): self.n += 1
    def on_end(self, happening): pass
count = Count()
event.register("numba:compile", count)
import osculant as osc
text, primitive, metric = sys.argv[1:]
spline = osc.approximate(osc.curve(text, "pi/6", "2*pi"), primitive, 1e-4, metric=metric)
print(len(spline), round(time.process_time(), 2), count.n)
"""


def main() -> None:
    """Print a line for every kind of pieces."""
    for name, job in JOBS.items():
        with tempfile.TemporaryDirectory() as cache:
            found = []
            for _ in range(2):
                command = [sys.executable, "-c", CODE, *job]
                environment = {**os.environ, "OSCULANT_CACHE": cache}
                done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
                found.append(done.stdout.split())
            (pieces, cold, compiled), (_, warm, _) = found
            print(
                f"{name}: {pieces} pieces, {cold} CPU s cold ({compiled} compiled), {warm} s warm", flush=True
            )


if __name__ == "__main__":
    main()
