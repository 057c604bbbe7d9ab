"""Wild scenes of any topology with wild inputs, drawn from a seed."""

from __future__ import annotations

import contextlib
import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, get_args

import numpy as np
from msgspec.structs import replace

import sim
from sim import (
    Anchor,
    AngularSpring,
    Beat,
    Integrator,
    JointMuscle,
    LinearSpring,
    Mass,
    Scene,
    Simulation,
    SpringMuscle,
)
from sim.scene.surroundings import Gas, Ground, Liquid, Medium, Wall, Wind
from sim.scene.types import AirLaw, ArrowKeys, ForceLaw
from sim.settings import settings_of
from tests.sim.bodies import sharing
from tests.sim.changes import with_joints

Positions = list[tuple[float, float]]
Pairs = list[tuple[int, int]]
Random = np.random.Generator

STEPS = 7
"""Time steps in a frame."""

_SLIDERS = (
    "linear_stiffness",
    "linear_damping",
    "angular_stiffness",
    "rest_angle",
    "gravity",
    "air_friction",
    "rest_length_scale",
)


def _ten_to(rng: Random, low: float, high: float) -> float:
    return float(10.0 ** rng.uniform(low, high))


def _row(rng: Random, n: int, h: float) -> tuple[Positions, Pairs]:
    turn = float(rng.uniform(0.0, math.tau))
    positions = [(300.0 + h * i * math.cos(turn), 150.0 + h * i * math.sin(turn)) for i in range(n)]
    return positions, [(i, i + 1) for i in range(n - 1)]


def _ring(_: Random, n: int, h: float) -> tuple[Positions, Pairs]:
    radius, turn = h * n / math.tau, math.tau / n
    positions = [(300.0 + radius * math.cos(turn * i), 300.0 + radius * math.sin(turn * i)) for i in range(n)]
    return positions, [(i, (i + 1) % n) for i in range(n)]


def _tree(rng: Random, n: int, h: float) -> tuple[Positions, Pairs]:
    positions, pairs = [(300.0, 300.0)], []
    for i in range(1, n):
        parent, turn = int(rng.integers(max(0, i - 4), i)), float(rng.uniform(0.0, math.tau))
        x, y = positions[parent]
        positions.append((x + h * math.cos(turn), y + h * math.sin(turn)))
        pairs.append((parent, i))
    return positions, pairs


def _cloth(rng: Random, _: int, h: float) -> tuple[Positions, Pairs]:
    wide, high = (int(size) for size in rng.integers(2, 6, 2))
    positions = [(250.0 + h * i, 150.0 + h * j) for j in range(high) for i in range(wide)]
    along = [(j * wide + i, j * wide + i + 1) for j in range(high) for i in range(wide - 1)]
    return positions, along + [
        (j * wide + i, (j + 1) * wide + i) for j in range(high - 1) for i in range(wide)
    ]


def _tangle(rng: Random, n: int, _: float) -> tuple[Positions, Pairs]:
    positions = [(float(x), float(y)) for x, y in rng.uniform(200.0, 400.0, (n, 2))]
    pairs = list(itertools.combinations(range(n), 2))
    return positions, [
        pairs[i] for i in sorted(rng.choice(len(pairs), min(len(pairs), 2 * n), replace=False))
    ]


_SHAPES: dict[str, Callable[[Random, int, float], tuple[Positions, Pairs]]] = {
    "rope": _row, "free": _row, "ring": _ring, "tree": _tree, "cloth": _cloth, "tangle": _tangle,
}  # fmt: skip


def _joints(rng: Random, pairs: Pairs, most: int) -> Pairs:
    """Springs that meet in a mass."""
    meeting = sharing(pairs)
    kept = sorted(rng.choice(len(meeting), min(len(meeting), most), replace=False)) if meeting else []
    return [meeting[i] for i in kept]


def wild_scene(rng: Random) -> Scene:
    """A scene, perhaps not a valid one.

    Stiffnesses, dampings and masses differ by many powers of ten, rest lengths may be next to nothing, and
    springs may lie on one another.
    """
    shape = str(rng.choice(list(_SHAPES)))
    law: ForceLaw = rng.choice(["conservative", "tutorial", "angle"], p=[0.5, 0.35, 0.15])
    n = int(rng.integers(3, 26))
    positions, pairs = _SHAPES[shape](rng, n, float(rng.uniform(5.0, 40.0)))
    at = np.array(positions) + rng.normal(0.0, _ten_to(rng, -9.0, 1.5), (len(positions), 2))
    stiffness, bending = _ten_to(rng, 1.0, 7.0), _ten_to(rng, 0.0, 7.0)
    damping = _ten_to(rng, -1.0, 4.0) if rng.random() < 0.8 else 0.0
    twist = _ten_to(rng, -2.0, 2.0) if rng.random() < 0.3 else 0.0
    spread, kilograms, speed = rng.random() < 0.4, _ten_to(rng, -2.0, 1.0), _ten_to(rng, 0.0, 3.0)

    def about(size: float) -> float:
        return size * _ten_to(rng, -1.0, 1.0) if spread else size

    def weight() -> float:
        odd = _ten_to(rng, -2.0, 2.0) if rng.random() < 0.1 else 1.0
        return float(np.clip(about(kilograms) * odd, 1e-6, 1e6))

    def rest_length(a: int, b: int) -> float:
        part = rng.choice([1.0, rng.uniform(0.5, 1.5), rng.uniform(0.0, 0.01)], p=[0.6, 0.3, 0.1])
        return float(np.hypot(*(at[a] - at[b])) * part)

    held = [] if shape == "free" else sorted(set(rng.integers(0, len(at), int(rng.integers(1, 3))).tolist()))
    return Scene(
        name=shape,
        masses=tuple(
            Mass(position=(x, y), mass=weight(), velocity=(float(u), float(v)))
            for (x, y), (u, v) in zip(at.tolist(), rng.normal(0.0, speed, at.shape), strict=True)
        ),
        linear_springs=tuple(
            LinearSpring(
                a=a, b=b, stiffness=about(stiffness), damping=about(damping), rest_length=rest_length(a, b)
            )
            for a, b in pairs
        ),
        angular_springs=tuple(
            AngularSpring(
                a=a,
                b=b,
                stiffness=about(bending),
                damping=about(twist),
                rest_angle=float(rng.uniform(-180.0, 180.0)),
            )
            for a, b in _joints(rng, pairs, 2 * n)
        ),
        anchors=tuple(Anchor(mass=i, driven=i == held[0]) for i in held),
        gravity=(0.0, _ten_to(rng, 1.0, 4.0)),
        air_friction=float(rng.choice([0.0, 0.002, 0.05])),
        air_law=rng.choice(get_args(AirLaw)),
        force_law=law,
        arrow_keys=ArrowKeys(),
        integrator=Integrator(method="auto"),
    )


def wild_world(scene: Scene, rng: Random) -> Scene:
    """The scene among walls that the body may be deep inside of, in wind, filled, and as fragile as glass."""
    at = np.array([mass.position for mass in scene.masses])
    size = float(np.ptp(at, axis=0).max()) + 1.0
    fields: dict[str, Any] = {}
    alone = rng.random() < 0.3
    if not alone:
        fields["walls"] = tuple(
            Wall(
                point=tuple((at.mean(0) + rng.normal(0.0, size, 2)).tolist()),
                normal=tuple(rng.normal(0.0, 1.0, 2).tolist()),
                hardness=_ten_to(rng, 1.0, 6.0),
                friction=float(rng.choice([0.0, 0.5, 10.0])),
                bounciness=float(rng.choice([0.0, 0.5, 1.0])),
                slip_speed=_ten_to(rng, 0.0, 2.0),
                restitution="constant" if k % 2 else "viscous",
                tangential_hardness=1e4 if k == 1 else 0.0,
            )
            for k in range(int(rng.integers(1, 4)))
        )
    if alone or rng.random() < 0.3:
        velocity = tuple((rng.normal(0.0, 1.0, 2) * _ten_to(rng, 1.0, 4.0)).tolist())
        fields["wind"] = Wind(
            velocity=velocity,
            turbulence=float(rng.choice([0.0, 0.5, 3.0])),
            length_scale=_ten_to(rng, 1.0, 3.0),
        )
    if rng.random() < 0.5:
        loop = tuple(rng.permutation(len(at))[: int(rng.integers(3, len(at) + 1))].tolist())
        if scene.name == "ring":
            loop = tuple(range(len(at)))
        pressure, area = _ten_to(rng, 0.0, 5.0), size * size * _ten_to(rng, -3.0, 1.0)
        fields["fillings"] = (
            Gas(masses=loop, pressure=pressure, outside=pressure * rng.random(), area=area)
            if rng.random() < 0.5
            else Liquid(masses=loop, bulk_modulus=pressure, area=area),
        )
    if rng.random() < 0.4:
        strength = _ten_to(rng, 2.0, 7.0)
        fields["linear_springs"] = tuple(
            replace(spring, **_limits(rng, strength * _ten_to(rng, -1.0, 1.0)))
            for spring in scene.linear_springs
        )
        scene = with_joints(scene, yield_torque=lambda *_: _ten_to(rng, 3.0, 8.0))
    if rng.random() < 0.5:
        fields["medium"] = Medium(across=_ten_to(rng, -3.0, 1.0), along=_ten_to(rng, -3.0, 1.0))
    if rng.random() < 0.5:
        forward, backward, sideways = rng.choice([0.0, 0.3, 2.0], 3).tolist()
        fields["ground"] = Ground(
            forward=forward, backward=backward, sideways=sideways, slip_speed=_ten_to(rng, 0.5, 2.0)
        )
    return replace(scene, **fields)


def with_muscles(scene: Scene, rng: Random) -> Scene:
    """The scene with muscles in some of its springs and joints, on a beat of their own."""

    def muscle(kind: Callable[..., Any], most: float) -> dict[str, Any]:
        if rng.random() < 0.5:
            return {}
        wave, per_beat = str(rng.choice(["sine", "pulse"])), int(rng.choice([1, 1, 2, 16]))
        amplitude, phase = most * float(rng.uniform(-1.0, 1.0)), float(rng.uniform(0.0, 360.0))
        return {"muscle": kind(amplitude=amplitude, phase=phase, wave=wave, per_beat=per_beat)}

    springs, joints = scene.linear_springs, scene.angular_springs
    size = float(rng.choice([0.1, 0.9]))
    return replace(
        scene,
        bodies=(),
        linear_springs=tuple(replace(s, **muscle(SpringMuscle, size)) for s in springs),
        angular_springs=tuple(replace(j, **muscle(JointMuscle, 180.0 * size)) for j in joints),
        beat=Beat(frequency=_ten_to(rng, -1.0, 1.0), phase=float(rng.uniform(0.0, 360.0))),
    )


def _limits(rng: Random, strength: float) -> dict[str, float]:
    """What a spring bears: it breaks, or yields, or both, or neither."""
    limits = {"strength": strength} if rng.random() < 0.7 else {}
    if rng.random() < 0.5:
        limits |= {"yield_force": 0.3 * strength, "hardening": _ten_to(rng, 0.0, 5.0)}
    return limits


@dataclass
class Ending:
    """How a case went.

    Attributes:
        simulation: as it was left.
        tries: steps tried in the worst frame.
        made: energy that came from nowhere, as a part of all that was turned over.
        unexplained: the balance's residual, as a part of all that was turned over or lost.
    """

    simulation: Simulation
    tries: int
    made: float
    unexplained: float


def run_case(seed: int, frames: int, budget: int, world: bool = False) -> Ending:
    """A wild scene with inputs: an anchor moved at once, led or torn, keys held, sliders flung, masses
    grabbed and dragged. One in five has muscles. `world`: whether it is in a wild world."""
    rng = np.random.default_rng((seed, 1) if world else seed)
    simulation = None
    while simulation is None:
        try:
            scene = wild_scene(rng)
            scene = wild_world(scene, rng) if world else scene
            if seed % 5 == 0:
                scene = with_muscles(scene, np.random.default_rng((seed, 2)))
            simulation = Simulation(scene)
        except sim.SceneError:
            continue
    simulation.track_energy(True)
    simulation.energy()
    does = rng.choice(["nothing", "move", "lead", "keys", "sliders", "tear", "grab"])
    worst = 0
    for frame in range(frames):
        _disturb(simulation, does, frame, rng)
        simulation.step(STEPS, attempts=budget)
        stats = simulation.stats()
        worst = max(worst, stats.steps + stats.rejected)
        if simulation.divergence is not None:
            break
    balance = simulation.energy()
    turned_over = (
        balance.kinetic
        + balance.linear
        + balance.angular
        + abs(balance.anchors)
        + abs(balance.keys)
        + abs(balance.muscles)
        + abs(balance.changes)
    ) + abs(balance.law)
    turned_over += balance.walls + abs(balance.fillings) + max(balance.air, 0.0)
    lost = -balance.damping - min(balance.air, 0.0) - balance.friction - balance.plastic - balance.broken
    return Ending(
        simulation,
        worst,
        made=(balance.residual - lost) / max(turned_over, 1e-9),
        unexplained=abs(balance.residual) / max(turned_over + lost, 1e-9),
    )


def _disturb(simulation: Simulation, does: str, frame: int, rng: Random) -> None:
    anchors = simulation.anchors
    if anchors and does in ("move", "lead", "tear"):
        mass = anchors[0].mass
        x, y = simulation.positions[mass]
        dx, dy = rng.normal(0.0, 20.0, 2)
        if does == "move" and frame % 7 == 3:
            simulation.move(mass, (300.0 + 7.5 * dx, 300.0 + 7.5 * dy))
        elif does == "lead":
            simulation.lead(mass, (float(x + dx), float(y + dy)))
        elif does == "tear":
            simulation.lead(mass, (300.0 + (frame % 2) * 500.0, 300.0))
    if does == "grab":
        # A hand for each of some masses; what it has let go may be taken again.
        mass = int(rng.integers(len(simulation.positions)))
        if frame % 2:
            simulation.grab(mass)
            simulation.follow(mass, tuple(rng.normal(300.0, 100.0, 2).tolist()))
        else:
            simulation.release(mass)
    if does == "keys":
        simulation.keys = set(rng.choice(["up", "down", "left", "right"], 2).tolist())
    if does == "sliders" and frame % 3 == 0:
        sliders = [slider_box for slider_box in settings_of(simulation.scene) if slider_box.key in _SLIDERS]
        setting = sliders[rng.integers(len(sliders))]
        with contextlib.suppress(sim.SettingError, sim.SceneError):
            simulation.replace(sim.set_value(simulation.scene, setting.key, setting.slider[rng.integers(2)]))
