"""Clips without a page: a scene that is simulated, or a recorded log that is done again."""

from __future__ import annotations

from rich.console import Console
from rich.progress import Progress

import sim
from sim.errors import InputError

from ..session.log import Log
from ..session.replay import Player

RATE = 60
"""Moments of a simulated second."""

PIECE = 200
"""Time steps between two looks of the progress bar."""


def simulated(
    scene: sim.Scene, seconds: float, after: float, console: Console, rate: int | None = None
) -> list[sim.Moment]:
    """The moments of a scene that nobody touches, 60 a second; of no seconds, one.

    Args:
        scene: what moves.
        seconds: how long, s.
        after: simulated seconds before the first moment.
        console: for the progress bar.
        rate: frames a second; the steps just before and after each frame are captured as well.

    Raises:
        InputError: the body becomes unstable; the sentence says when and why.
    """
    simulation = sim.Simulation(scene)
    first, last = (_steps(time, simulation.dt) for time in (after, after + seconds))
    wanted = {first + _steps(k / RATE, simulation.dt) for k in range(round(seconds * RATE) + 1)}
    if rate is not None:
        befores = {first + _steps(k / rate, simulation.dt) for k in range(round(seconds * rate) + 1)}
        wanted |= befores | {step + 1 for step in befores}
    moments = []
    with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
        task = progress.add_task("simulating", total=last)
        for step in sorted(step for step in wanted if step <= last):
            # In pieces, so that the bar moves.
            while (left := step - simulation.step_count) > 0:
                simulation.step(min(left, PIECE))
                if simulation.divergence is not None:
                    raise InputError(str(simulation.divergence))
                progress.update(task, completed=simulation.step_count)
            moments.append(simulation.capture())
    return moments


def _steps(seconds: float, dt: float) -> int:
    """The number of whole time steps in some seconds, rounded as `Simulation.advance` does."""
    return int(seconds / dt + 1e-9)


def replayed(record: Log, console: Console) -> tuple[list[sim.Moment], str | None]:
    """The moments of a recorded log, and how it differs from what was recorded (None if it does not).

    Raises:
        InputError: the log asks for what cannot be done; the sentence names its line.
    """
    simulation = sim.Simulation(record.scene)
    player = Player(record, simulation)
    moments = [simulation.capture()]
    total = sum(entry.times for entry in record.entries)
    with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
        task = progress.add_task("replaying", total=total)
        while not player.ended:
            player.do()
            progress.update(task, advance=1)
            moment = simulation.capture()
            # Somebody may have gone back, and on from there.
            while moments and moments[-1].time >= moment.time:
                moments.pop()
            moments.append(moment)
    return moments, None if player.agrees else player.verdict
