"""How long compiling takes from nothing: until a scene moves by its method, and until it has all kernels."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time

from rich.console import Console

import sim
from sim.compiling.compiler import Compiler, is_ready, needed_by
from sim.model.system import build_system

from ..reporting.report import Table

SCENES = "tutorial-3.3", "study-cloth", "jelly", "lesson-worm", "heart"
"""A chain, a net, a net with fillings, and bodies with walls and contact."""

LOOK_EVERY = 0.02
"""Seconds."""


def _measure(name: str) -> tuple[float, float]:
    """Compile as a server does that opens a scene.

    Returns:
        The seconds until the kernels of its method are ready, and until all are that it may come to by any
        method. A server compiles those of other forces only once a scene needs them.
    """
    scene = sim.load_scene(name)
    method, body = scene.integrator.method, build_system(scene).body
    needed = needed_by(method, body)
    compiler = Compiler(())
    compiler.want_for(method, body)
    began = time.perf_counter()
    compiler.start()
    while not is_ready(needed):
        time.sleep(LOOK_EVERY)
    own = time.perf_counter() - began
    compiler.wait()
    return own, time.perf_counter() - began


def show_ready(console: Console, repeats: int) -> None:
    """Print them for some scenes, the fastest of some starts."""
    rows = []
    for name in SCENES:
        times = []
        for _ in range(repeats):
            with tempfile.TemporaryDirectory() as empty:
                environment = {**os.environ, "XDG_CACHE_HOME": empty}
                words = [sys.executable, "-m", "studies.bench.ready", name]
                run = subprocess.run(words, env=environment, check=True, capture_output=True, text=True)
            times.append(json.loads(run.stdout))
        own, every = map(min, zip(*times, strict=True))
        rows.append((name, f"{own:.1f}", f"{every:.1f}"))
    headings = ("compiling from nothing", "s until it moves at machine speed", "s until it has all kernels")
    console.print(Table(headings, rows, "l"))


if __name__ == "__main__":
    print(json.dumps(_measure(sys.argv[1])))
