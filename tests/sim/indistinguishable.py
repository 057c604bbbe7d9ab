"""Measurements that leave something open, each of another kind, with what they do tell."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace

import sim
from sim.design.measurements import Column, Measurement
from sim.settings import set_value
from tests.sim.builders import built
from tests.sim.measured import measure, spring_pendulum, swing


class Open(NamedTuple):
    """A measurement that leaves something open.

    Attributes:
        guess, data, vary: as of `sim.fit`.
        said: the only sentence of the fit, with {} for numbers.
        truth: the hidden numbers in their place; of a bound, the number that it bounds.
    """

    guess: sim.Scene
    data: Measurement
    vary: list[str]
    said: str
    truth: list[float]


def weightless(scene: sim.Scene) -> sim.Scene:
    """With the mass 40 px beyond the rest length."""
    masses = (scene.masses[0], replace(scene.masses[1], position=(0.0, 140.0)))
    return replace(scene, gravity=(0.0, 0.0), masses=masses)


def scaled_together(draw: np.random.Generator) -> Open:
    """A spring pendulum without weight moves by the ratios of stiffness, damping and mass alone."""
    mass, stiffness, damping = draw.uniform(0.5, 2.0), draw.uniform(40.0, 160.0), draw.uniform(0.2, 0.6)
    hidden = weightless(spring_pendulum(mass, stiffness, damping))
    each = draw.random() < 0.5
    names = ["spring0.stiffness", "spring0.damping"] if each else ["linear_stiffness", "linear_damping"]
    return Open(
        weightless(spring_pendulum()),
        measure(hidden, ["mass1.y"], 3.0, noise(draw), draw),
        [*names, "mass1.mass"],
        f"The data cannot tell {names[0]}, {names[1]} and mass1.mass apart: of them only "
        f"{names[0]} / mass1.mass = {{}} and {names[1]} / mass1.mass = {{}} are known.",
        [stiffness / mass, damping / mass],
    )


def fall_without_scale(draw: np.random.Generator) -> Open:
    """A mass that falls from a place that is known, in a unit that is not."""
    gravity, scale = draw.uniform(700.0, 1300.0), draw.uniform(300.0, 600.0)
    fall = sim.Scene(name="fall", masses=(sim.Mass(position=(0.0, 0.0)),), gravity=(0.0, 1000.0))
    pixels = measure(set_value(fall, "gravity", gravity), ["mass0.y"], 1.0, noise(draw), draw)
    data = Measurement(
        "fall.csv", pixels.time, (Column("mass0.y", "cm", pixels.columns[0].values / scale * 100.0),)
    )
    return Open(
        fall,
        data,
        ["gravity", "length_scale"],
        "The data cannot tell gravity and length_scale apart: of them only "
        "gravity / length_scale = {} is known.",
        [gravity / scale],
    )


def springs_on_both_sides(draw: np.random.Generator) -> Open:
    """A mass between two springs that are both at rest in the middle: their stiffnesses add up."""

    def scene(left: float, right: float) -> sim.Scene:
        places = [(x, 0.0) for x in (0.0, 110.0, 180.0)]
        return built(places, stiffness=(left, right), damping=0.3, rest_length=(80.0, 100.0), held=(0, 2))

    left, right = draw.uniform(20.0, 60.0), draw.uniform(20.0, 60.0)
    return Open(
        scene(30.0, 50.0),
        measure(scene(left, right), ["mass1.x"], 3.0, noise(draw), draw),
        ["spring0.stiffness", "spring1.stiffness"],
        "The data cannot tell spring0.stiffness and spring1.stiffness apart: of them only "
        "spring0.stiffness + spring1.stiffness = {} kg/s² is known.",
        [left + right],
    )


def springs_in_a_row(draw: np.random.Generator) -> Open:
    """Two springs in a row with hardly a mass between them, of which only the lower end is seen."""

    def scene(upper: float, lower: float) -> sim.Scene:
        # The mass between starts where both pull alike.
        between = 60.0 + 40.0 * lower / (upper + lower)
        places = [(0.0, 0.0), (0.0, between), (0.0, 160.0)]
        mass = (1.0, 2e-4, 1.0)
        return built(places, mass=mass, stiffness=(upper, lower), rest_length=60.0, held=(0,))

    upper, lower = draw.uniform(60.0, 240.0), draw.uniform(60.0, 240.0)
    return Open(
        scene(120.0, 160.0),
        measure(scene(upper, lower), ["mass2.y"], 2.0, draw.uniform(0.02, 0.03), draw),
        ["spring0.stiffness", "spring1.stiffness"],
        "The data cannot tell spring0.stiffness and spring1.stiffness apart: of them only "
        "1 / (1 / spring0.stiffness + 1 / spring1.stiffness) = {} kg/s² is known.",
        [upper * lower / (upper + lower)],
    )


def masses_that_move_as_one(draw: np.random.Generator) -> Open:
    """Two masses, one held to the other by a stiff spring, on a soft one."""

    def scene(stiffness: float, upper: float, lower: float) -> sim.Scene:
        return built(
            [(0.0, 0.0), (0.0, 140.0), (0.0, 160.0)], mass=(1.0, upper, lower),
            stiffness=(stiffness, 1e6), damping=(0.0, 300.0), rest_length=(100.0, 20.0), held=(0,),
        )  # fmt: skip

    stiffness, upper, lower = draw.uniform(60.0, 120.0), draw.uniform(0.6, 1.4), draw.uniform(0.6, 1.4)
    return Open(
        scene(80.0, 1.0, 0.8),
        measure(scene(stiffness, upper, lower), ["mass2.y"], 3.0, noise(draw), draw),
        ["spring0.stiffness", "mass1.mass", "mass2.mass"],
        "The data cannot tell spring0.stiffness, mass1.mass and mass2.mass apart: of them only "
        "spring0.stiffness / (mass1.mass + mass2.mass) = {} is known.",
        [stiffness / (upper + lower)],
    )


def air_by_weight(draw: np.random.Generator) -> Open:
    """What the air does to a pendulum goes by its mass."""
    air, mass = draw.uniform(5e-4, 2e-3), draw.uniform(0.6, 1.6)
    hidden = replace(swing(), air_friction=air)
    hidden = replace(hidden, masses=(hidden.masses[0], replace(hidden.masses[1], mass=mass)))
    return Open(
        replace(swing(), air_friction=1e-3),
        measure(hidden, ["spring0.direction"], 2.0, draw.uniform(0.01, 0.03), draw),
        ["gravity", "air_friction", "mass1.mass"],
        "The data cannot tell air_friction and mass1.mass apart: of them only "
        "air_friction / mass1.mass = {} is known.",
        [air / mass],
    )


def hanging_still(draw: np.random.Generator) -> Open:
    """How far a spring is stretched tells the weight over the stiffness."""
    gravity, stiffness, mass = draw.uniform(800.0, 1200.0), draw.uniform(50.0, 110.0), draw.uniform(0.7, 1.4)
    hidden = set_value(spring_pendulum(mass, stiffness, 18.0), "gravity", gravity)
    moving = measure(hidden, ["mass1.y"], 6.0, 0.0, draw)
    late = moving.time > 4.0
    still = moving.columns[0].values[late] + 0.05 * draw.standard_normal(int(late.sum()))
    return Open(
        spring_pendulum(damping=18.0),
        Measurement("still.csv", moving.time[late], (Column("mass1.y", "px", still),)),
        ["linear_stiffness", "gravity", "mass1.mass"],
        "The data cannot tell linear_stiffness, gravity and mass1.mass apart: of them only "
        "linear_stiffness / gravity / mass1.mass = {} is known.",
        [stiffness / gravity / mass],
    )


def one_phase(draw: np.random.Generator) -> Open:
    """Seen at one phase of its swings only, a start farther out is as one that is faster."""

    def scene(x: float, speed: float) -> sim.Scene:
        moving = [(0.0, 0.0), (speed, 0.0)]
        places = [(0.0, 0.0), (x, 0.0)]
        return built(places, velocities=moving, stiffness=80.0, rest_length=200.0, held=(0,))

    x, speed = draw.uniform(230.0, 250.0), draw.uniform(100.0, 300.0)
    rate, phase = math.sqrt(80.0), draw.uniform(0.6, 1.0)
    time = np.array([(phase + math.pi * k) / rate for k in range(12)])
    off = (x - 200.0) * math.cos(phase) + speed / rate * math.sin(phase)
    seen = 200.0 + off * (-1.0) ** np.arange(12) + 0.1 * draw.standard_normal(12)
    factor = math.tan(phase) / rate
    return Open(
        scene(240.0, 150.0),
        Measurement("phase.csv", time, (Column("mass1.x", "px", seen),)),
        ["mass1.x", "mass1.vx"],
        "The data cannot tell mass1.x and mass1.vx apart: of them only "
        f"mass1.x + {factor:.3g} mass1.vx = {{}} px is known.",
        [x + factor * speed],
    )


def fall_from_somewhere(draw: np.random.Generator) -> Open:
    """A fall in an unknown unit and from an unknown zero: the start is known in neither."""
    gravity, scale, origin = draw.uniform(700.0, 1300.0), draw.uniform(300.0, 600.0), draw.uniform(-0.2, 0.2)
    fall = sim.Scene(name="fall", masses=(sim.Mass(position=(0.0, 80.0)),), gravity=(0.0, 1000.0))
    pixels = measure(set_value(fall, "gravity", gravity), ["mass0.y"], 1.0, noise(draw), draw)
    metres = pixels.columns[0].values / scale + origin
    return Open(
        fall,
        Measurement("fall.csv", pixels.time, (Column("mass0.y", "m", metres),)),
        ["gravity", "length_scale", "origin"],
        "The data cannot tell gravity, length_scale and origin_y apart: of them only "
        "gravity / length_scale = {} and origin_y + 80 / length_scale = {} m are known.",
        [gravity / scale, origin + 80.0 / scale],
    )


def bending_that_never_moves(draw: np.random.Generator) -> Open:
    """A rod that hangs straight down and bounces: its joints never turn."""
    stiffness, joints = draw.uniform(2e3, 8e3), draw.uniform(1e3, 1e4)
    places = [(0.0, 50.0 * i) for i in range(5)]
    rod = built(
        places, stiffness=4e3, damping=5.0, joint={"stiffness": 3e3}, held=(0,), gravity=(0.0, 1000.0)
    )
    hidden = set_value(set_value(rod, "linear_stiffness", stiffness), "angular_stiffness", joints)
    return Open(
        rod,
        measure(hidden, ["mass4.y"], 1.0, noise(draw), draw),
        ["linear_stiffness", "angular_stiffness"],
        "The data do not tell angular_stiffness: whatever it is, the fit is as good.",
        [],
    )


def another_body(draw: np.random.Generator) -> Open:
    """Of two spring pendulums one is seen."""

    def scene(one: float, other: float) -> sim.Scene:
        places = [(0.0, 0.0), (0.0, 140.0), (200.0, 0.0), (200.0, 130.0)]
        springs = [(0, 1), (2, 3)]
        return built(places, springs, stiffness=(one, other), damping=0.3, rest_length=100.0, held=(0, 2))

    one, other = draw.uniform(50.0, 120.0, 2)
    return Open(
        scene(80.0, 80.0),
        measure(scene(one, other), ["mass1.y"], 3.0, noise(draw), draw),
        ["spring0.stiffness", "spring1.stiffness"],
        "The data do not tell spring1.stiffness: whatever it is, the fit is as good.",
        [],
    )


def stiff_enough(draw: np.random.Generator) -> Open:
    """A pendulum on a spring that hardly gives: it is stiff, but how stiff does not show."""
    gravity, stiffness = draw.uniform(800.0, 1200.0), draw.uniform(1e5, 3e5)
    hidden = set_value(set_value(swing(), "gravity", gravity), "linear_stiffness", stiffness)
    return Open(
        set_value(swing(), "linear_stiffness", 1e5),
        measure(hidden, ["spring0.direction"], 2.0, draw.uniform(0.02, 0.03), draw),
        ["gravity", "linear_stiffness"],
        "The data hardly tell linear_stiffness: it is at least {} kg/s².",
        [stiffness],
    )


def noise(draw: np.random.Generator) -> float:
    """0.2 to 3 %."""
    return draw.uniform(0.002, 0.03)


KINDS: tuple[Callable[[np.random.Generator], Open], ...] = (
    scaled_together,
    fall_without_scale,
    springs_on_both_sides,
    springs_in_a_row,
    masses_that_move_as_one,
    air_by_weight,
    hanging_still,
    one_phase,
    fall_from_somewhere,
    bending_that_never_moves,
    another_body,
    stiff_enough,
)
