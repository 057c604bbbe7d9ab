"""Searches in this process, and what they leave in their folders."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path

import msgspec
from rich.console import Console

import sim
from studies.improve.goals import parse_goal
from studies.improve.improve import OptimizationProblem, SearchResult, improve, print_result
from studies.improve.ranges import make_ranges
from studies.improve.search import default_population
from studies.sweep.journal import Entry
from tests.studies.sweeping import Here

SWINGS = sim.Scene(
    name="swings",
    masses=(sim.Mass(position=(0.0, 0.0), mass=1.0), sim.Mass(position=(110.0, 0.0), mass=1.0)),
    linear_springs=(sim.LinearSpring(a=0, b=1, stiffness=100.0, damping=1.0, rest_length=100.0),),
    anchors=(sim.Anchor(mass=0),),
    integrator=sim.Integrator(method="rk4", dt=0.01),
)
"""A mass on a spring, drawn out by 10 px: 10 radians a second, and 20 kg/s damp it critically."""


def problem_of(
    scene: sim.Scene,
    vary: Sequence[str],
    goal: str,
    duration: float = 4.0,
    runs: int = 60,
    seed: int = 1,
    settings: Sequence[str] = (),
) -> OptimizationProblem:
    """What the command would make of these."""
    found, scene = parse_goal(goal, scene)
    grid, ranges = make_ranges(scene, settings, vary)
    return OptimizationProblem(grid, ranges, found, duration, runs, default_population(len(ranges)), seed)


def improved(
    out: Path, problem: OptimizationProblem, interrupt_at: int | None = None
) -> tuple[int, Here, str, SearchResult]:
    """The exit status of a search in this process, what was asked for and printed, and what was found."""
    here, text = Here(interrupt_at, "trial"), io.StringIO()
    console = Console(file=text, width=200)
    found = improve(problem, here, out, console)
    return print_result(problem, found, out, console), here, text.getvalue(), found


def rows_by_number(out: Path) -> dict[int, tuple]:
    """The values of the runs that are kept, by number; the same number twice is an error."""
    lines = (out / "improve.jsonl").read_bytes().splitlines()[1:]
    found = [msgspec.json.decode(line, type=Entry) for line in lines]
    assert len({line.run for line in found}) == len(found)
    return {line.run: line.row.values for line in sorted(found, key=lambda line: line.run)}
