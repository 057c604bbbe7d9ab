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


def simulated(scene: sim.Scene, seconds: float, after: float, console: Console) -> list[sim.Moment]:
    """The moments of a scene that nobody touches, 60 a second; of no seconds, one.

    Args:
        scene: what moves.
        seconds: how long, s.
        after: simulated seconds before the first moment.
        console: for the progress bar.

    Raises:
        InputError: the body becomes unstable; the sentence says when and why.
    """
    simulation = sim.Simulation(scene)
    with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
        task = progress.add_task("simulating", total=after + seconds)
        # In pieces, so that the bar moves.
        while simulation.time < after - simulation.dt / 2.0:
            _go(simulation, min(0.5, after - simulation.time))
            progress.update(task, completed=simulation.time)
        moments = [simulation.capture()]
        for _ in range(round(seconds * RATE)):
            _go(simulation, 1.0 / RATE)
            # A time step may be longer than a frame.
            if simulation.time > moments[-1].time:
                moments.append(simulation.capture())
            progress.update(task, completed=simulation.time)
    return moments


def _go(simulation: sim.Simulation, seconds: float) -> None:
    simulation.advance(seconds)
    if simulation.divergence is not None:
        raise InputError(str(simulation.divergence))


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
