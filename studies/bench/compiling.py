"""`softrod bench compile`: processor time that compiling takes, by entry point and by kernel."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from typing import Any

from rich.console import Console

from ..reporting.report import Table

MIN_SHOWN = 0.4
"""Seconds from which on a kernel has a row of its own."""


def _measure() -> dict[str, Any]:
    """Compile everything in this process, whose cache is empty."""
    import resource

    from numba.core import event

    began = time.process_time()
    from sim.compiling.compiler import ENTRY_POINTS

    class Listener(event.Listener):
        """Measures the time of each kernel without that of the kernels it calls."""

        def __init__(self) -> None:
            self.stack: list[list[float]] = []
            self.own: dict[str, float] = defaultdict(float)

        def on_start(self, event: Any) -> None:
            self.stack.append([time.process_time(), 0.0])

        def on_end(self, event: Any) -> None:
            started, inside = self.stack.pop()
            whole = time.process_time() - started
            function = event.data["dispatcher"].py_func
            self.own[f"{function.__module__.removeprefix('sim.kernels.')}.{function.__name__}"] += (
                whole - inside
            )
            if self.stack:
                self.stack[-1][1] += whole

    listener = Listener()
    event.register("numba:compile", listener)
    points = {}
    for name, point in ENTRY_POINTS.items():
        before = time.process_time()
        point.load()
        points[name] = (point.label, time.process_time() - before)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    return {
        "points": points,
        "own": listener.own,
        "whole": time.process_time() - began,
        "peak": peak,
    }


def bench_compile(console: Console, repeats: int) -> None:
    """Compile into an empty folder, and print where the time went; the fastest of some runs."""
    best: dict[str, Any] = {}
    for _ in range(repeats):
        with tempfile.TemporaryDirectory() as empty:
            environment = {**os.environ, "XDG_CACHE_HOME": empty}
            words = [sys.executable, "-m", "studies.bench.compiling"]
            run = subprocess.run(words, env=environment, check=True, capture_output=True, text=True)
        found = json.loads(run.stdout)
        best = min(best or found, found, key=lambda result: result["whole"])
    rows = [(name, label, f"{seconds:.1f}") for name, (label, seconds) in best["points"].items()]
    title = "processor time of each entry point, with what those before it have not compiled already"
    console.print(Table(("entry point", "", "s"), rows, "ll", title))
    own = sorted(best["own"].items(), key=lambda item: -item[1])
    rows = [(name, f"{seconds:.2f}") for name, seconds in own if seconds >= MIN_SHOWN]
    rest = [seconds for _, seconds in own if seconds < MIN_SHOWN]
    rows.append((f"{len(rest)} others", f"{sum(rest):.2f}"))
    console.print(Table(("kernel", "s"), rows, title="processor time of each kernel by itself"))
    console.print(f"all in one process: {best['whole']:.1f} s, at most {best['peak']:.0f} MB")


if __name__ == "__main__":
    print(json.dumps(_measure()))
