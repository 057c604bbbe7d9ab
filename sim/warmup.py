"""Compiling the kernels ahead of their first use, in the order in which they are wanted."""

from __future__ import annotations

import subprocess
import sys
import threading
from collections.abc import Callable

import msgspec

from .kernels.jit import cache_folder, is_cached
from .methods import METHODS
from .rope import rope
from .scene import Anchor, Integrator, LinearSpring, Mass, Scene
from .simulation import Simulation
from .stepping import FlowStepper

__all__ = ["Kernels", "is_cached"]

_DONE = "methods.done"
"""Marks a folder of machine code that has all methods: what is there is loaded when it is first used."""

_TUTORIAL = Integrator(method="symplectic_euler")


class Kernels:
    """Which kernels are compiled, or loaded from the disk; `compile` does it, in any one thread.

    Attributes:
        chain: set once a chain can be stepped as in the tutorial.
        general: set once any body can be stepped by symplectic Euler, and the stability limit estimated.
        every: set once the machine code of all methods, and of the energy's books, is on the disk.
    """

    def __init__(self) -> None:
        self.chain = threading.Event()
        self.general = threading.Event()
        self.every = threading.Event()
        self._helper: subprocess.Popen[bytes] | None = None
        self._stopped = False

    def stop(self) -> None:
        """Compile no more: nobody will use it."""
        self._stopped = True
        if self._helper is not None:
            self._helper.terminate()

    def ready_for(self, scene: Scene) -> bool:
        """Whether the scene can be simulated without waiting for a compilation.

        Only a rope's recipe is sure to be a chain without a closer look, so other scenes wait for the
        general path.
        """
        if METHODS[scene.integrator.method].kind != "euler":
            return self.every.is_set()
        tutorial_rope = scene.rope is not None and scene.force_law == "tutorial"
        return self.general.is_set() or (self.chain.is_set() and tutorial_rope)

    def compile(self, report: Callable[[int, int, str], None] = lambda done, of, what: None) -> None:
        """Compile everything. `report` hears how many parts of how many are done, and what comes next.

        The tutorial's own kernels come first, and take seconds. The other methods take some minutes, in a
        process of their own: numba would leave this one little time to serve a page.
        """
        parts = 5
        chain = rope(masses=3, force_law="tutorial", integrator=_TUTORIAL)
        fork = _fork(_TUTORIAL)
        held = msgspec.structs.replace(
            fork, masses=fork.masses[:1], linear_springs=(), anchors=(Anchor(mass=0),)
        )
        report(0, parts, "chains")
        simulation = Simulation(chain)
        simulation.step()
        self.chain.set()
        report(1, parts, "the stability limit")
        simulation.stability()
        report(2, parts, "bodies of any shape")
        Simulation(fork).step()
        report(3, parts, "held bodies")
        Simulation(held).step()
        self.general.set()
        report(4, parts, "all other methods")
        folder = cache_folder()
        if folder is None:
            compile_methods()
        elif not (folder / _DONE).exists() and not self._stopped:
            self._helper = subprocess.Popen(
                [sys.executable, "-m", "sim.warmup"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
            )
            self._helper.wait()
        if not self._stopped:
            self.every.set()
            report(5, parts, "ready")


def _fork(integrator: Integrator) -> Scene:
    """Two springs that point at each other: no chain."""
    return Scene(
        name="fork",
        masses=tuple(Mass(position=(float(x), 0.0)) for x in range(3)),
        linear_springs=tuple(LinearSpring(a=a, b=1, stiffness=1.0, rest_length=1.0) for a in (0, 2)),
        integrator=integrator,
    )


def compile_methods() -> None:
    """Compile every method that is not the tutorial's, the books, and the step of last resort."""
    Simulation(_fork(Integrator())).step()  # imports what finds orderings of matrices
    for method in METHODS.values():
        simulation = Simulation(rope(masses=3, integrator=Integrator(method=method.name)))
        simulation.step()
        if method.kind in ("euler", "auto"):
            simulation.energy()
            simulation.step()
        stepper = simulation._stepper
        if isinstance(stepper, FlowStepper):
            stepper.leave_dead_end()


if __name__ == "__main__":
    compile_methods()
    _folder = cache_folder()
    if _folder is not None:
        (_folder / _DONE).touch()
