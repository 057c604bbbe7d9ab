"""The table of a scene's surroundings."""

from __future__ import annotations

import math

import numpy as np

from ..kernels.core.surroundings import FILLING_ROW, WALL_ROW, WAVE_ROW, Surroundings
from ..kernels.core.tables import Floats, Indices
from ..methods.registry import METHODS
from ..scene.columns import column
from ..scene.surroundings import Gas, Liquid, Wall, Wind
from ..scene.types import Scene, is_surrounded
from .contact import new_contacts

REFERENCE_SPEED = 1000.0
"""Speed, px/s, at which a mass hits a wall to leave it with the bounciness of the wall."""

_WAVES = 12
"""Number of waves that make gusts."""
_OCTAVES = 4.0
"""Their wavelengths reach from the length scale to this many octaves below it."""
_TURN = math.pi * (3.0 - math.sqrt(5.0))
"""Angle between the directions of one wave and the next: the golden angle spreads any number evenly."""


def new_surroundings(scene: Scene, mass_index: Indices, ends: Indices, slots: int) -> Surroundings:
    """The table of a valid scene.

    Args:
        scene: the scene.
        mass_index: (n,) the slot of each of its masses.
        ends: (S, 2) the slots of the masses at the ends of each spring, in the order of the tables.
        slots: number of slots of a state.
    """
    mass = np.zeros(slots)
    mass[mass_index] = column(scene.masses, "mass")
    start = np.cumsum([0, *(len(filling.masses) for filling in scene.fillings)])
    loops = [_loop(scene, filling.masses) for filling in scene.fillings]
    method = METHODS[scene.integrator.method]
    softened = not (method.adaptive or method.implicit)
    wind = scene.wind if scene.air_friction > 0.0 else None
    around = Surroundings(
        mass=mass,
        present=is_surrounded(scene),
        step=scene.integrator.dt if softened else 0.0,
        walls=np.array([_wall(wall) for wall in scene.walls], float).reshape(-1, WALL_ROW),
        air_friction=scene.air_friction if wind else 0.0,
        wind_x=wind.velocity[0] if wind else 0.0,
        wind_y=wind.velocity[1] if wind else 0.0,
        waves=_waves(wind) if wind else np.zeros((0, WAVE_ROW)),
        loop_start=start.astype(np.int64),
        loop=mass_index[np.array([m for masses, _ in loops for m in masses], np.int64)],
        fillings=np.array(
            [_filling(f, area) for f, (_, area) in zip(scene.fillings, loops, strict=True)], float
        ).reshape(-1, FILLING_ROW),
        contact=new_contacts(
            scene, mass_index, ends, slots, loss_of(scene.contact.bounciness) if scene.contact else 0.0
        ),
    )
    for _, array in around.arrays():
        array.setflags(write=False)
    return around


def loss_of(bounciness: float) -> float:
    """The factor c of a wall's damping, s/px, with which a mass of the reference speed bounces as it should.

    Without other forces, a mass that enters with s leaves with r where c s - ln(1 + c s) = -c r - ln(1 - c r)
    (Hunt & Crossley 1975). Zero for a bounciness of 1; 0.01 is the least that is distinguished.
    """
    e = max(bounciness, 0.01)
    if e >= 1.0:
        return 0.0
    low, high = 0.0, 1.0 / e
    for _ in range(200):
        c = 0.5 * (low + high)
        left = c - math.log1p(c) + e * c + math.log1p(-e * c) if e * c < 1.0 else -math.inf
        # Both sides vanish at c = 0; in between, more damping is needed as long as the left side is larger.
        low, high = (c, high) if left > 0.0 else (low, c)
    return 0.5 * (low + high) / REFERENCE_SPEED


def _wall(wall: Wall) -> list[float]:
    size = math.hypot(*wall.normal)
    normal = [part / size for part in wall.normal]
    return [*wall.point, *normal, wall.hardness, wall.friction, wall.slip_speed, loss_of(wall.bounciness)]


def _waves(wind: Wind) -> Floats:
    """(K, 6) waves whose energy falls with the wave number as in turbulence, by the power -5/3."""
    speed = math.hypot(*wind.velocity)
    if wind.turbulence * speed == 0.0:
        return np.zeros((0, WAVE_ROW))
    rng = np.random.default_rng(wind.seed)
    octave = np.arange(_WAVES) * (_OCTAVES / (_WAVES - 1))
    number = np.asarray(math.tau / wind.length_scale * 2.0**octave, float)
    turn = _TURN * np.arange(_WAVES) + rng.uniform(0.0, math.tau)
    amplitude = number ** (-1.0 / 3.0)  # equal shares of the octaves, each with the energy k^(-2/3)
    # The mean square of both components together is half of the sum of all squared amplitudes.
    amplitude *= 2.0 * wind.turbulence * speed / math.sqrt(float((amplitude**2).sum()))
    x, y = number * np.cos(turn), number * np.sin(turn)
    u, v = -amplitude * np.sin(turn), amplitude * np.cos(turn)
    phase = rng.uniform(0.0, math.tau, _WAVES)
    return np.stack((x, y, u, v, phase, -(x * wind.velocity[0] + y * wind.velocity[1])), 1)


def _loop(scene: Scene, masses: tuple[int, ...]) -> tuple[tuple[int, ...], float]:
    """The masses of a loop in the order in which its area is positive, and its area, px²."""
    x, y = np.array([scene.masses[m].position for m in masses]).T
    x, y = x - x[0], y - y[0]
    area = 0.5 * float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum())
    return (masses, area) if area > 0.0 else (masses[::-1], -area)


def _filling(filling: Gas | Liquid, area: float) -> list[float]:
    size = filling.area if filling.area is not None else area
    if isinstance(filling, Liquid):
        return [0.0, filling.bulk_modulus, 0.0, size]
    # A gas whose area is tiny is the same as one at the loop's own area. Below a hundredth of its area, its
    # pressure grows linearly, and no step could follow that within a hundredth of a tiny one.
    larger = max(size, area)
    return [1.0, filling.pressure * (size / larger), filling.outside, larger]
