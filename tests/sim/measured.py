"""Bodies with hidden numbers, and what a camera would have measured of them."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from msgspec.structs import replace

import sim
from sim.design.measurements import Column, Measurement
from sim.settings import set_value, setting_of
from tests.sim.builders import built


class Case(NamedTuple):
    """What was measured of a body, and what is to be found.

    Attributes:
        guess: the scene to start from.
        data: what was measured.
        vary: what is sought.
        truth: the hidden numbers.
    """

    guess: sim.Scene
    data: Measurement
    vary: list[str]
    truth: dict[str, float]


def measure(
    scene: sim.Scene, names: list[str], seconds: float, noise: float, random: np.random.Generator
) -> Measurement:
    """Quantities of a run at 30 frames a second, with white noise, as a part of how much each varies."""
    fine = replace(scene.integrator, method="auto", tolerance=1e-7, dt=1 / 30)
    run = sim.Simulation(replace(scene, integrator=fine)).record(seconds, *names)
    columns = tuple(
        Column(
            name,
            run.units[name],
            run[name] + noise * float(np.std(run[name])) * random.standard_normal(len(run)),
        )
        for name in names
    )
    return Measurement("measured.csv", run.time, columns)


def spring_pendulum(mass: float = 1.0, stiffness: float = 80.0, damping: float = 0.3) -> sim.Scene:
    """A mass that hangs by a spring, and starts above where it would rest."""
    return built(
        [(0.0, 0.0), (0.0, 102.0)], mass=(1.0, mass), stiffness=stiffness, damping=damping,
        rest_length=100.0, held=(0,), gravity=(0.0, 1000.0),
    )  # fmt: skip


def swing(length: float = 250.0, degrees: float = 40.0) -> sim.Scene:
    """A mass on a stiff spring, pulled aside."""
    angle = math.radians(degrees)
    places = [(0.0, 0.0), (length * math.sin(angle), length * math.cos(angle))]
    numbers: dict[str, Any] = {"stiffness": 2e4, "damping": 40.0, "rest_length": length}
    return built(places, **numbers, held=(0,), gravity=(0.0, 1000.0), name="swing")


def any_case(seed: int) -> Case:
    """A rod, a rope or a pendulum with hidden numbers, and noise of 0.2 to 3 %."""
    random = np.random.default_rng(seed)

    def hidden(scene: sim.Scene, names: list[str]) -> sim.Scene:
        for name in names:
            value = setting_of(scene, name).read(scene)
            scene = set_value(scene, name, value * math.exp(random.uniform(-0.3, 0.3)))
        return scene

    kind = seed % 4
    if kind == 0:
        guess = sim.rod(masses=int(random.integers(5, 9)), length=200.0, stiffness=2e4, angular_stiffness=3e3)
        guess = set_value(guess, "angular_damping", 20.0)
        names, seconds = ["angular_stiffness", "angular_damping", "gravity"], 2.0
        last = len(guess.masses) - 1
        seen = [f"mass{last}.x", f"mass{last}.y"]
    elif kind == 1:
        guess = replace(
            sim.rope(masses=int(random.integers(4, 7)), stiffness=3e3, damping=4.0, joints=False),
            gravity=(0.0, 1000.0),
        )
        names, seconds = ["linear_stiffness", "gravity"], 0.8
        last = len(guess.masses) - 1
        seen = [f"mass{last}.x", f"mass{last}.y"]
    elif kind == 2:
        guess, names, seconds = spring_pendulum(), ["linear_stiffness", "linear_damping"], 4.0
        seen = ["mass1.y"]
    else:
        guess, names, seconds = swing(), ["gravity"], 3.0
        guess = replace(guess, air_friction=1e-3)
        names = ["gravity", "air_friction"]
        seen = ["spring0.direction"]
    scene = hidden(guess, names)
    truth = {name: setting_of(scene, name).read(scene) for name in names}
    noise = math.exp(random.uniform(math.log(0.002), math.log(0.03)))
    return Case(guess, measure(scene, seen, seconds, noise, random), names, truth)
