"""A session without a browser, for tests."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

import sim
from app.session import commands
from app.session.ghost import Ghost
from app.session.pacing import Costs
from app.session.session import Session

T = TypeVar("T")

FRAME = 1.0 / 60.0

BUDGET = 1000.0
"""Seconds of computing for a frame: so many that nothing depends on how fast the machine is."""


class Wall:
    """A wall clock that a test moves."""

    def __init__(self) -> None:
        self.time = 100.0

    def __call__(self) -> float:
        return self.time


class SessionPage:
    """A session and its wall clock.

    Args:
        scene: what it shows; a preset's name, or a scene.
    """

    def __init__(self, scene: sim.Scene | str = "tutorial-3.3") -> None:
        self.wall = Wall()
        self.session = Session(sim.load_scene(scene) if isinstance(scene, str) else scene, clock=self.wall)

    @property
    def simulation(self) -> sim.Simulation:
        return self.session.simulation

    @property
    def ghost(self) -> Ghost:
        """The second body, which must be there."""
        assert self.session.ghost is not None
        return self.session.ghost

    @property
    def told(self) -> str:
        """The text of the session's only notice."""
        (notice,) = self.session.notices
        return notice.text

    def frames(self, count: int, *posts: commands.Command) -> None:
        """Post the commands, then let frames pass."""
        for command in posts:
            self.session.post(command)
        for _ in range(count):
            self.wall.time += FRAME
            self.session.drain()
            self.session.tick(BUDGET)

    def hold(self, count: int, *keys: str) -> None:
        """Hold arrow keys for some frames, and release them for one."""
        for _ in range(count):
            self.frames(1, commands.HoldKeys(frozenset(keys)))
        self.frames(1, commands.HoldKeys(frozenset()))

    def drag(self, mass: int, dx: float = 0.0, dy: float = 0.0, frames: int = 1) -> tuple[float, float]:
        """Take hold of a mass, lead it aside by some px, and let frames pass; where it was."""
        x, y = map(float, self.simulation.positions[mass])
        self.frames(frames, commands.DragStart(mass, x, y), commands.Point(x + dx, y + dy))
        return x, y


def in_one_piece(costs: Costs, attempts: int) -> None:
    """Let each frame be one call, in which a method may try so many steps, whatever the machine."""

    def spend(budget: float, steps: int, go: Callable[[int, int], tuple[int, int]]) -> int:
        return go(steps, attempts)[0] if steps else 0

    costs.spend = spend  # type: ignore[method-assign, assignment]


def answered(session: Session, ask: Callable[[], T]) -> T:
    """What another thread is answered that asks a session for something, while this one drains it."""
    with ThreadPoolExecutor(1) as other:
        result = other.submit(ask)
        while not result.done():
            session.drain()
        return result.result()
