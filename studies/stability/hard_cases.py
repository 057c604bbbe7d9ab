"""Scenes that are hard on an integrator, and what is done to them while they run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import msgspec
import numpy as np

import sim
from sim import Integrator, Pose, Scene, Simulation
from sim.scene.makers import fine_rope

REPLACE = msgspec.structs.replace
SPACING = 300.0 / 11.0

Act = Callable[[Simulation, int, np.random.Generator], None]
"""Acts on a simulation before a frame of a given number."""


@dataclass(frozen=True)
class HardCase:
    """A scene, and what its user does."""

    scene: Scene
    act: Act = lambda simulation, frame, rng: None


def rope(**changes: object) -> Scene:
    """Return the tutorial's rope, horizontal, held at its left end."""
    defaults: dict[str, object] = {"direction": (1.0, 0.0), "start": (100.0, 100.0), "driven": None}
    return sim.rope(**(defaults | changes))  # type: ignore[arg-type]


def placed(scene: Scene, positions: list[tuple[float, float]]) -> Scene:
    """Return the scene with its masses at other positions, at rest."""
    rest = ((0.0, 0.0),) * len(positions)
    return REPLACE(scene, pose=Pose(positions=tuple(positions), velocities=rest))


def weighted(scene: Scene, masses: list[float]) -> Scene:
    """Return the scene with other masses, kg."""
    changed = tuple(REPLACE(m, mass=kg) for m, kg in zip(scene.masses, masses, strict=True))
    return REPLACE(scene, bodies=(), masses=changed)


def _folded(noise: float) -> list[tuple[float, float]]:
    """Fold the second half of the rope back by 180 degrees, exactly but for noise."""
    rng = np.random.default_rng(1)
    straight = [100.0 + SPACING * i for i in range(6)]
    positions = [(x, 100.0) for x in (*straight, *(straight[5] - SPACING * (i + 1) for i in range(6)))]
    return [positions[0], *((x + rng.normal(0, noise), y + rng.normal(0, noise)) for x, y in positions[1:])]


def _short(length: float) -> list[tuple[float, float]]:
    """Let one spring start with almost no length."""
    positions = [(100.0 + SPACING * i, 100.0) for i in range(12)]
    positions[6] = (positions[5][0] + length, 100.0)
    return positions


def _tangled() -> list[tuple[float, float]]:
    rng = np.random.default_rng(2)
    return [(100.0, 100.0), *((100.0 + x, 100.0 + y) for x, y in rng.uniform(-60.0, 60.0, (11, 2)).tolist())]


def _teleport(simulation: Simulation, frame: int, rng: np.random.Generator) -> None:
    if frame == 10:
        simulation.move(0, (600.0, 100.0))


def _teleport_always(simulation: Simulation, frame: int, rng: np.random.Generator) -> None:
    x, y = 300.0 + rng.normal(0.0, 150.0, 2)
    simulation.move(0, (float(x), float(y)))


def _tear(simulation: Simulation, frame: int, rng: np.random.Generator) -> None:
    simulation.lead(0, (100.0 + 500.0 * (frame % 2), 100.0))


def _tear_gently(simulation: Simulation, frame: int, rng: np.random.Generator) -> None:
    """As in the page, which limits the speed of hands."""
    simulation.follow(0, (100.0 + 500.0 * (frame // 6 % 2), 100.0))


def _coincide(simulation: Simulation, frame: int, rng: np.random.Generator) -> None:
    """Put the anchor on the free mass next to it."""
    if frame % 5 == 0:
        x, y = simulation.positions[1]
        simulation.move(0, (float(x), float(y)))


def _shrink(simulation: Simulation, frame: int, rng: np.random.Generator) -> None:
    simulation.keys = {"down", "left"}


def _fling_sliders(simulation: Simulation, frame: int, rng: np.random.Generator) -> None:
    keys = ("linear_stiffness", "angular_stiffness", "linear_damping", "rest_angle")
    ends = ((1e2, 1e6), (10.0, 1e6), (0.0, 200.0), (-180.0, 180.0))
    simulation.replace(sim.set_value(simulation.scene, keys[frame % 4], ends[frame % 4][frame // 4 % 2]))


def hard_cases() -> dict[str, HardCase]:
    """Return the cases by name; their scenes take any method and law."""
    keyed = REPLACE(rope(), arrow_keys=sim.ArrowKeys())
    stiff_ring = sim.set_value(sim.load_scene("ring"), "linear_stiffness", 1e8)
    return {
        "plain": HardCase(rope()),
        "folded by 180 degrees": HardCase(placed(rope(), _folded(0.0))),
        "folded, with noise": HardCase(placed(rope(), _folded(1e-3))),
        "a spring of 1e-9": HardCase(placed(rope(), _short(1.1e-9))),
        "a spring of no length": HardCase(rope(), _coincide),
        "masses 1:1000": HardCase(weighted(rope(), [1.0 if i % 2 else 1e-3 for i in range(12)])),
        "masses 1:1e6": HardCase(weighted(rope(), [1.0 if i % 2 else 1e-6 for i in range(12)])),
        "tip mass 1000": HardCase(weighted(rope(), [1.0] * 11 + [1000.0])),
        "rest length almost zero": HardCase(REPLACE(rope(), rest_length_scale=0.01)),
        "keys held down": HardCase(keyed, _shrink),
        "anchor teleported": HardCase(rope(), _teleport),
        "anchor teleported every frame": HardCase(rope(), _teleport_always),
        "anchor torn to and fro": HardCase(rope(), _tear),
        "stiffness x1e3": HardCase(rope(stiffness=1e7, angular_stiffness=1e7)),
        "stiffness x1e6": HardCase(rope(stiffness=1e10, angular_stiffness=1e10)),
        "no stiffness, no air": HardCase(rope(stiffness=0.0, angular_stiffness=0.0, air_friction=0.0)),
        "nothing damps": HardCase(rope(damping=0.0, air_friction=0.0)),
        "rest angle 180": HardCase(rope(rest_angle=180.0)),
        "rest angle -180": HardCase(rope(rest_angle=-180.0)),
        "a tangle": HardCase(placed(rope(), _tangled())),
        "damping x1e4": HardCase(rope(damping=4e5)),
        "time step of a second": HardCase(
            REPLACE(rope(), integrator=Integrator(dt=1.0, method="auto", tolerance=0.1))
        ),
        "sliders flung": HardCase(rope(), _fling_sliders),
        "stiff ring": HardCase(sim.set_value(stiff_ring, "angular_stiffness", 1e8)),
    }


def long_rods() -> dict[str, HardCase]:
    """Return rods led round a circle, and torn to and fro; too long for other methods than `auto`."""
    circle = sim.Circle(radius=50.0, frequency=2.0, ramp=0.1)
    led = {f"rod of {n} masses on a circle": HardCase(_rod(n, circle)) for n in (1000, 3000)}
    torn = {
        f"rod of {n} masses, torn to and fro": HardCase(_rod(n, None), _tear_gently) for n in (1000, 3000)
    }
    return led | torn


def _rod(masses: int, circle: sim.Circle | None) -> Scene:
    """Return the tutorial's rope in more pieces, which share its drag."""
    return fine_rope(masses, air_friction=0.002 / ((masses - 1) / 11.0), circle=circle)
