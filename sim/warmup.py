"""Compiling the kernels ahead of their first use, in the order in which they are wanted."""

from __future__ import annotations

import threading
from collections.abc import Callable

from .kernels.jit import is_cached
from .rope import rope
from .scene import Anchor, LinearSpring, Mass, Scene
from .simulation import Simulation

__all__ = ["Kernels", "is_cached"]


class Kernels:
    """Which kernels are compiled, or loaded from the disk; `compile` does it, in any one thread.

    Attributes:
        chain: set once a chain can be stepped.
        general: set once any body can be stepped, and the stability limit estimated.
    """

    def __init__(self) -> None:
        self.chain = threading.Event()
        self.general = threading.Event()

    def ready_for(self, scene: Scene) -> bool:
        """Whether the scene can be simulated without waiting for a compilation.

        Only a rope's recipe is sure to be a chain without a closer look, so other scenes wait for the
        general path.
        """
        return self.general.is_set() or (self.chain.is_set() and scene.rope is not None)

    def compile(self, report: Callable[[int, int, str], None] = lambda done, of, what: None) -> None:
        """Compile everything. `report` hears how many parts of how many are done, and what comes next."""
        chain = rope(masses=3)
        # Two springs that point at each other are no chain.
        fork = Scene(
            name="fork",
            masses=tuple(Mass(position=(float(x), 0.0)) for x in range(3)),
            linear_springs=tuple(LinearSpring(a=a, b=1, stiffness=1.0, rest_length=1.0) for a in (0, 2)),
        )
        held = Scene(name="held", masses=(Mass(position=(0.0, 0.0)),), anchors=(Anchor(mass=0),))
        report(0, 4, "chains")
        simulation = Simulation(chain)
        simulation.step()
        self.chain.set()
        report(1, 4, "the stability limit")
        simulation.stability()
        report(2, 4, "bodies of any shape")
        Simulation(fork).step()
        report(3, 4, "held bodies")
        Simulation(held).step()
        self.general.set()
        report(4, 4, "ready")
