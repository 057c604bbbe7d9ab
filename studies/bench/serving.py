"""`softrod bench start` and `softrod bench page`: softrod's page and a bare viser app of its size."""

from __future__ import annotations

import contextlib
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from rich.console import Console

from app.features.hands import messages as hands
from app.wire import from_page

from ..reporting.report import Table
from .client import FRAME_PLACES, FRAME_TIME, Page, is_frame, saying, state_of
from .ready import show_ready

NODE = "/body/masses"

OPENED = "tutorial-3.3", "ring", "study-w4", "buggy"
"""What servers open: chains, a net and a vehicle with motors."""


class Served(NamedTuple):
    """A server in a process of its own.

    Attributes:
        port: at which it listens.
        listening: seconds until it listened.
        used: returns the processor time that it has used so far, s.
    """

    port: int
    listening: float
    used: Callable[[], float]


@contextlib.contextmanager
def served(kind: str, shown: str | int, cache: str) -> Iterator[Served]:
    """Serve softrod's page, or one of bare viser; see `bare`."""
    words = [sys.executable, "-m", "studies.bench.bare", str(shown), *([kind] if kind == "softrod" else [])]
    began = time.perf_counter()
    process = subprocess.Popen(
        words,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "XDG_CACHE_HOME": cache},
    )
    requests, answers = process.stdin, process.stdout
    assert requests is not None and answers is not None

    def used() -> float:
        requests.write("\n")
        requests.flush()
        return float(answers.readline())

    try:
        port = int(answers.readline())
        yield Served(port, time.perf_counter() - began, used)
    finally:
        requests.close()
        process.wait(timeout=30.0)


def _is_node(message: dict[str, Any]) -> bool:
    return message.get("name") == NODE and "props" in message


def _moves(message: dict[str, Any]) -> bool:
    """Whether a message moves the masses, of softrod or of bare viser."""
    node = message.get("name") == NODE and "batched_positions" in message.get("updates", {})
    return node or is_frame(message)


def _runs(message: dict[str, Any]) -> bool:
    """Whether simulated time has passed: in a frame, or in the state of a body at rest."""
    if is_frame(message):
        return float(message["numbers"][FRAME_TIME]) > 0.0
    state = state_of(message)
    return state is not None and bool(state.get("rest"))


def _start(kind: str, shown: str | int, cache: str) -> dict[str, float]:
    """Return the seconds until the port listens, the body is sent, and it moves."""
    began = time.perf_counter()
    with served(kind, shown, cache) as server, Page(server.port) as page:
        page.wait_for(_is_node)
        drawn = time.perf_counter() - began
        if kind == "softrod":
            page.wait_for(_runs)
        else:
            # The first frame is sent at once; a body in motion sends more.
            page.wait_for(_moves)
            page.wait_for(_moves)
        return {"port": server.listening, "drawn": drawn, "moving": time.perf_counter() - began}


def warm(cache: str) -> None:
    """Compile all kernels into a folder."""
    words = [sys.executable, "-m", "sim.compiling.precompile", "all"]
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, env={**os.environ, "XDG_CACHE_HOME": cache})


def _import_numba() -> float:
    began = time.perf_counter()
    subprocess.run([sys.executable, "-c", "import numba"], check=True)
    numba = time.perf_counter() - began
    began = time.perf_counter()
    subprocess.run([sys.executable, "-c", "pass"], check=True)
    return numba - (time.perf_counter() - began)


def bench_start(console: Console, repeats: int) -> None:
    """Measure starts of some presets, cold (no machine code on the disk) and cached, and of bare viser; and
    how long compiling takes."""
    show_ready(console, repeats)
    best: dict[tuple[str, str], dict[str, float]] = {}
    numba = float("inf")
    with tempfile.TemporaryDirectory() as cache:
        warm(cache)
        for _ in range(repeats):
            runs = {("bare viser", ""): _start("bare", 12, cache)}
            for preset in OPENED:
                # A compiler that the server has left behind may still write here for a moment.
                with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as empty:
                    runs[preset, "cold"] = _start("softrod", preset, empty)
                runs[preset, "cached"] = _start("softrod", preset, cache)
            numba = min(numba, _import_numba())
            for row, times in runs.items():
                old = best.setdefault(row, times)
                best[row] = {key: min(old[key], times[key]) for key in times}
    names = ("port", "drawn", "moving")
    rows = []
    for (name, start), times in best.items():
        late = f"{times['moving'] - best[name, 'cached']['moving']:+.2f}" if start == "cold" else ""
        rows.append((name, start, *(f"{times[key]:.2f}" for key in names), late))
    headings = ("seconds until", "", "the port listens", "it is drawn", "it moves", "cold - cached")
    console.print(Table(headings, rows, "ll"))
    bare, rope = best["bare viser", ""], best["tutorial-3.3", "cached"]
    console.print(
        f"import of numba {numba:.2f} s; tutorial-3.3, cached / (bare viser + numba): "
        f"port {rope['port'] / (bare['port'] + numba):.2f}, "
        f"drawn {rope['drawn'] / (bare['drawn'] + numba):.2f}"
    )


def _processor_share(kind: str, masses: int, seconds: float, cache: str) -> tuple[float, float, float]:
    """Return processor time per second, kB/s and frames/s of a server with one page."""
    with served(kind, masses, cache) as server, Page(server.port) as page:
        page.wait_for(_moves)
        page.read_for(3.0)  # compiling and the first frames are not measured
        before, bytes_before, began = server.used(), page.bytes, time.perf_counter()
        frames = 0
        while (left := began + seconds - time.perf_counter()) > 0:
            frames += any(_moves(message) for message in page.receive(left))
        span = time.perf_counter() - began
        return (server.used() - before) / span, (page.bytes - bytes_before) / span / 1e3, frames / span


def _latencies(masses: int, count: int, cache: str) -> list[float]:
    """Return the seconds from a pointer report to the frame in which a page sees the driven mass move."""
    with served("softrod", masses, cache) as server, Page(server.port) as page:
        page.wait_for(is_frame)
        page.read_for(4.0)
        driven = slice(FRAME_PLACES, FRAME_PLACES + 2)  # the first mass, x and y
        page.send(saying(from_page.Perform("follow")))
        page.read_for(1.0)
        result = []
        for i in range(count):
            page.read_for(0.03 + 0.01 * (i % 4))
            before = page.wait_for(is_frame)["numbers"][driven]
            began = time.perf_counter()
            page.send(saying(hands.At(((0, 0.5 * (i % 2), 1.0),))))
            page.wait_for(lambda m: is_frame(m) and (m["numbers"][driven] != before).any())  # noqa: B023
            result.append(time.perf_counter() - began)
        return result


def bench_page(console: Console, repeats: int) -> None:
    """Measure the server's cost of one page at 60 Hz and of bare viser, and the latency of the pointer."""
    rows = []
    with tempfile.TemporaryDirectory() as cache:
        warm(cache)
        for masses in (12, 200, 1000):
            best: dict[str, tuple[float, float, float]] = {}
            for _ in range(repeats):
                for kind in ("bare viser", "softrod"):
                    share = _processor_share(kind, masses, 5.0, cache)
                    best[kind] = min(best.get(kind, share), share)
            for kind, (share, rate, frames) in best.items():
                ratio = f"{share / best['bare viser'][0]:.2f}" if kind == "softrod" else ""
                cells = f"{100 * share:.1f}", f"{rate:.0f}", f"{frames:.1f}", ratio
                rows.append((str(masses), kind, *cells))
        headings = ("masses", "server", "% of a core", "kB/s", "frames/s", "softrod / viser")
        console.print(Table(headings, rows, "rl"))
        latencies = sorted(1e3 * value for value in _latencies(12, 60, cache))
    console.print(
        f"pointer to page, server side and loopback: median {statistics.median(latencies):.1f} ms, "
        f"90 % under {latencies[int(0.9 * len(latencies))]:.1f} ms"
    )
