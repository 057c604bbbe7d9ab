"""Scenes that several test files need."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import Any

from msgspec.structs import replace

import sim
from sim import Anchor, AngularSpring, Integrator, LinearSpring, Mass, Scene
from sim.scene.makers import fine_rope
from sim.scene.types import Circle, ForceLaw, Method
from sim.store.files import built_in_folder
from tests.sim.changes import posed

PRESETS = sorted(path.stem for path in built_in_folder().glob("*.json"))


def euler(dt: float = 0.0025) -> Integrator:
    """The tutorial's method."""
    return Integrator(method="symplectic_euler", dt=dt)


def tutorial_rope(**changes: Any) -> Scene:
    """A rope with the tutorial's constants, law and method; `changes` are arguments of `sim.rope`."""
    return sim.rope(**{"force_law": "tutorial", "integrator": euler(), **changes})


def tutorial_preset(name: str) -> Scene:
    """A preset under the tutorial's laws and method, whatever it says itself."""
    return replace(sim.load_scene(name), force_law="tutorial", air_law="tutorial", integrator=euler())


def rod(masses: int, law: ForceLaw = "conservative", **changes: Any) -> Scene:
    """The tutorial's rope in so many pieces, horizontal, held at its left end."""
    return fine_rope(masses, force_law=law, **changes)


def led_rod(masses: int, method: Method = "auto", tolerance: float = 0.1) -> Scene:
    """The rod under the tutorial's law, its first mass led in a circle twice a second."""
    integrator = Integrator(method=method, dt=1.0 / 60.0, tolerance=tolerance)
    return rod(
        masses, "tutorial", integrator=integrator, circle=Circle(radius=200.0, frequency=2.0, ramp=0.1)
    )


def folded_rope() -> Scene:
    """The tutorial's rope, its second half folded back by 180 degrees."""
    scene = sim.rope(direction=(1.0, 0.0), start=(100.0, 100.0), driven=None)
    spacing = 300.0 / 11.0
    there = [100.0 + spacing * i for i in range(6)]
    back = [there[5] - spacing * (i + 1) for i in range(6)]
    return posed(scene, [(x, 100.0) for x in (*there, *back)])


Places = Sequence[tuple[float, float]]
Numbers = float | Sequence[float]
"""One for all parts, or one for each."""


def each(value: Numbers, count: int) -> list[float]:
    return [value] * count if isinstance(value, int | float) else list(value)


def built(
    places: Places,
    pairs: Sequence[tuple[int, int]] | None = None,
    *,
    stiffness: Numbers = 0.0,
    damping: Numbers = 0.0,
    rest_length: Numbers | None = None,
    spring: dict[str, Any] | None = None,
    joint: dict[str, Any] | None = None,
    held: Sequence[int] = (),
    mass: Numbers = 1.0,
    velocities: Places | None = None,
    **fields: Any,
) -> Scene:
    """A body of masses at these places, with nothing acting on it but what is asked for.

    Args:
        places: of the masses, px.
        pairs: the masses that each spring joins; without them, each mass is joined to the next.
        stiffness, damping, rest_length: of the springs, which are at rest where no lengths are given.
        spring: further fields of all springs.
        joint: fields of a joint between every two springs that follow each other, if there are any.
        held: masses that are held.
        mass, velocities: of the masses.
        fields: of the scene.
    """
    ends = list(itertools.pairwise(range(len(places)))) if pairs is None else pairs
    lengths = [math.dist(places[a], places[b]) for a, b in ends] if rest_length is None else rest_length
    springs = zip(ends, *(each(n, len(ends)) for n in (stiffness, damping, lengths)), strict=True)
    moving = velocities or [(0.0, 0.0)] * len(places)
    joints = range(len(ends) - 1) if joint is not None else ()
    parts = {
        "masses": tuple(
            Mass(position=at, velocity=v, mass=m)
            for at, v, m in zip(places, moving, each(mass, len(places)), strict=True)
        ),
        "linear_springs": tuple(
            LinearSpring(a=a, b=b, stiffness=k, damping=c, rest_length=rest, **(spring or {}))
            for (a, b), k, c, rest in springs
        ),
        "angular_springs": tuple(AngularSpring(a=j, b=j + 1, **(joint or {})) for j in joints),
        "anchors": tuple(Anchor(mass=i) for i in held),
    }
    return Scene(**{"name": "built", **parts, **fields})


def chain(
    positions: Places,
    *,
    angular_stiffness: float = 0.0,
    rest_length: Numbers = 10.0,
    dt: float = 0.001,
    **numbers: Any,
) -> Scene:
    """A row of equal masses and springs under the tutorial's law and method; `numbers` are of `built`."""
    joint = {"stiffness": angular_stiffness} if angular_stiffness else None
    tutorial: dict[str, Any] = {"name": "chain", "force_law": "tutorial", "integrator": euler(dt)}
    return built(positions, rest_length=rest_length, joint=joint, **tutorial, **numbers)


def row(count: int, spacing: float = 10.0) -> list[tuple[float, float]]:
    """Positions along a horizontal line."""
    return [(spacing * i, 0.0) for i in range(count)]


def hoop(count: int, radius: float, *, mass: float, stiffness: float, damping: float, **fields: Any) -> Scene:
    """A ring of springs around the origin, at rest and without joints."""
    turns = [math.tau * i / count for i in range(count)]
    places = [(radius * math.cos(v), radius * math.sin(v)) for v in turns]
    pairs = [(i, (i + 1) % count) for i in range(count)]
    edge = 2.0 * radius * math.sin(math.pi / count)
    return built(places, pairs, mass=mass, stiffness=stiffness, damping=damping, rest_length=edge, **fields)


def star(arms: int) -> Scene:
    """Springs from one hub, some of them towards it, and an angular spring between every two of them."""
    angles = [2.0 * math.pi * i / arms + 0.1 * math.sin(3.0 * i) for i in range(arms)]
    tips = [(100.0 * math.cos(v), 80.0 * math.sin(v)) for v in angles]
    return Scene(
        name="star",
        masses=(Mass(position=(0.0, 0.0), velocity=(3.0, 4.0)), *(Mass(position=tip) for tip in tips)),
        linear_springs=tuple(
            LinearSpring(
                a=0 if i % 3 else i + 1,
                b=i + 1 if i % 3 else 0,
                stiffness=500.0 + 10.0 * i,
                damping=5.0 + i,
                rest_length=70.0 + i,
            )
            for i in range(arms)
        ),
        angular_springs=tuple(
            AngularSpring(a=a, b=b, stiffness=40.0 + a + 10.0 * b, rest_angle=20.0 * (a - b))
            for a, b in itertools.combinations(range(arms), 2)
        ),
        force_law="tutorial",
        integrator=euler(1e-3),
    )


def askew() -> Scene:
    """The tutorial's third example, hung askew so that everything in it moves."""
    scene = sim.load_scene("tutorial-3.3")
    return posed(scene, [(m.position[0] + 3.0 * i, m.position[1]) for i, m in enumerate(scene.masses)])


def undisturbed(steps: int) -> sim.Simulation:
    """The rope that hangs askew after some steps in which nothing is done to it."""
    simulation = sim.Simulation(askew())
    simulation.step(steps)
    return simulation


def spinning(rate: float) -> Scene:
    """A mass that goes round an anchor by so many radians a second."""
    moving = [(0.0, 0.0), (0.0, 100.0 * rate)]
    return built(
        [(0.0, 0.0), (100.0, 0.0)], velocities=moving, stiffness=1e6, rest_length=100.0, held=(0,),
        integrator=Integrator(method="rk4", dt=1.0 / 4800.0),
    )  # fmt: skip
