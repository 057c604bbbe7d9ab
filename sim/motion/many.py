"""`run_many`: many scenes, each from its own start, in one call.

Scenes of one shape are moved side by side, in a fiftieth of the time that a `Simulation` of each takes: they
are one body whose parts nothing connects, with the same mass of all scenes in slots that follow each other,
so that all springs and joints are in runs, however a scene connects them. Such scenes have an explicit method
with a fixed step; springs, still air and gravity, and nothing else that acts on masses; nothing that yields
or breaks; no held mass that moves by itself. Any other scene has a `Simulation` of its own. So has one that
leaves the bounds of good states, so that it ends where a `Simulation` does.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from operator import attrgetter
from typing import Any, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from ..engine.tables import SHORTEST_SQUARED, State
from ..errors import InputError, SceneError, of_field
from ..forces.air import still_air
from ..forces.environment import is_surrounded
from ..forces.joints import LAWS, NO_JOINTS
from ..model.state import drag_of, new_scratch, new_state, update_rest_state
from ..model.system import System, wired, with_numbers
from ..scene.columns import column
from ..scene.parts import AngularSpring, LinearSpring, constant_force
from ..scene.types import AirLaw, Scene, is_loaded, is_muscular
from ..scene.validate import validate
from ..solve.steps.guard import GOOD
from ..text import Text
from .divergence import Divergence
from .driving import Driver
from .simulation import Simulation
from .solver import Solver

Floats = NDArray[np.float64]

# Unless noted, doubling or halving one of these numbers fails no test.
LANES = 8
"""Bodies are moved in multiples of this: fewer would be in no run, and their sums in another order. Halved,
`test_what_a_body_does_depends_on_none_beside_it` fails."""
_MASSES = 1536
"""Masses of all bodies that are moved at once: what is kept of them stays in the processor's second cache."""
_MAX_SAMPLES = 2**24
"""Numbers in the samples of bodies that are moved at once: 128 MB."""


_METHODS = "symplectic_euler", "velocity_verlet", "rk4"
"""The methods by which bodies are moved side by side."""


@dataclass(frozen=True, slots=True)
class Run:
    """What came of a scene.

    Attributes:
        time: s, simulated.
        positions: (n, 2) px, at the end.
        velocities: (n, 2) px/s, zero where a mass is held.
        divergence: why it stopped before, or None.
        sample_times: (k,) s; none without `every`.
        sample_positions: (k, n, 2) px, at these times.
        sample_velocities: (k, n, 2) px/s.
    """

    time: float
    positions: Floats
    velocities: Floats
    divergence: Divergence | None
    sample_times: Floats
    sample_positions: Floats
    sample_velocities: Floats


def run_many(scenes: Iterable[Scene], seconds: float, every: int | None = None) -> list[Run]:
    """Move each scene from its start, by as many of its time steps as fit into the seconds.

        ropes = [sim.rope(12, stiffness=k, integrator=sim.Integrator(method="velocity_verlet"))
                 for k in range(5000, 15000, 10)]
        ends = [run.positions[-1] for run in sim.run_many(ropes, 1.0)]

    The results are those of a `Simulation` of each scene, but for rounding (a relative 1e-12 after some dozen
    steps; it grows as any small error does in that body), and the same to the last bit for any other scenes
    in the call. Scenes of one shape, which differ in numbers only, under symplectic Euler, velocity Verlet or
    Runge-Kutta 4 and without surroundings are moved side by side, without the interpreter's lock; see
    `sim.motion.many` for the whole rule.

    Args:
        scenes: valid scenes.
        seconds: 0..1e9, of simulated time.
        every: steps from one sample to the next, at least 1; the first is the start. None for no samples.

    Returns:
        A `Run` for each scene, in order. One that ran away has its last good state and a `divergence`.

    Raises:
        InputError: `seconds` or `every` is out of range.
        SceneError: a scene is not valid; the sentence says which.
    """
    if not 0.0 <= seconds <= 1e9:
        raise InputError(
            Text("{where}: {seconds:g} is not in the range 0..1e+09 s", where="run_many", seconds=seconds)
        )
    if every is not None and not (isinstance(every, int) and every >= 1):
        raise InputError(
            Text(
                "{where}: every is {every}, but must be a whole number from 1", where="run_many", every=every
            )
        )
    scenes = list(scenes)
    shapes = _Shapes()
    groups: dict[_Shape, list[int]] = {}
    runs: list[Run | None] = [None] * len(scenes)
    for i, scene in enumerate(scenes):
        try:
            validate(scene)
        except SceneError as error:
            raise SceneError(of_field(f"scenes[{i}]", str(error))) from None
        shape = shapes.of(scene)
        if shape is not None:
            groups.setdefault(shape, []).append(i)
    for shape, members in groups.items():
        steps = _steps(shape.dt, seconds)
        numbers = 1 + (steps // every + 1 if every else 0)
        most = min(_MAX_SAMPLES // (numbers * 4), _MASSES) // shape.masses
        at_once = LANES * max(1, most // LANES)
        for first in range(0, len(members), at_once):
            some = members[first : first + at_once]
            for i, run in zip(
                some, _side_by_side([scenes[i] for i in some], shape, steps, every or 0), strict=True
            ):
                runs[i] = run
    return [
        _alone(scene, seconds, every) if run is None else run for scene, run in zip(scenes, runs, strict=True)
    ]


def is_laned(scene: Scene) -> bool:
    """Whether `run_many` moves a valid scene beside others, and not by a `Simulation` of its own."""
    return _Shapes().of(scene) is not None


def _steps(dt: float, seconds: float) -> int:
    """The whole steps in some seconds, as `Simulation.advance` counts them."""
    return int(seconds / dt + 1e-9)


# ------------------------------------------------------------------------- one by one
def _alone(scene: Scene, seconds: float, every: int | None) -> Run:
    simulation = Simulation(scene)
    left, n = _steps(simulation.dt, seconds), len(scene.masses)
    times: list[float] = []
    rows: list[tuple[Floats, Floats]] = []
    if every is None:
        simulation.step(left)
    else:
        times.append(simulation.time)
        rows.append((simulation.positions, simulation.velocities))
        while left > 0:
            steps = min(every, left)
            if simulation.step(steps) < steps:
                break
            left -= steps
            if steps == every:
                times.append(simulation.time)
                rows.append((simulation.positions, simulation.velocities))
    return Run(
        simulation.time,
        simulation.positions,
        simulation.velocities,
        simulation.divergence,
        np.array(times),
        np.array([x for x, _ in rows]).reshape(-1, n, 2),
        np.array([v for _, v in rows]).reshape(-1, n, 2),
    )


# ------------------------------------------------------------------------- side by side
_Ends = tuple[int, ...]
"""The `a` of some springs or joints, then the `b` of each."""


_A, _B = attrgetter("a"), attrgetter("b")
_LIMITS = {
    LinearSpring: attrgetter("strength", "yield_force", "only"),
    AngularSpring: attrgetter("yield_torque", "only"),
}
"""What a spring or a joint bears; None for any load."""
_NO_LIMITS = {LinearSpring: {(None, None, msgspec.UNSET)}, AngularSpring: {(None, msgspec.UNSET)}}
"""The same of parts that bear any load."""


class _Shape(NamedTuple):
    """What scenes have in common that are moved side by side: the method, and what connects the masses."""

    method: str
    dt: float
    law: int
    air_law: AirLaw
    masses: int
    springs: _Ends
    joints: _Ends


class _Shapes:
    """Finds the shapes of scenes. Those that follow from each other share most of their parts, so what was
    found of a tuple of parts is kept by its id, as long as the scenes of a call keep it alive."""

    def __init__(self) -> None:
        self._known: dict[int, _Ends | None] = {}

    def of(self, scene: Scene) -> _Shape | None:
        """The shape of a valid scene; None where it is to be moved alone, see the module."""
        springs, joints, integrator = scene.linear_springs, scene.angular_springs, scene.integrator
        law = LAWS[scene.force_law].code if joints else NO_JOINTS
        if (
            integrator.method not in _METHODS
            or is_surrounded(scene)
            or (scene.pose is not None and scene.pose.damage is not None)
            or any(anchor.circle is not None for anchor in scene.anchors)
            or len(scene.anchors) == len(scene.masses)
            or (spring_ends := self._ends(springs)) is None
            or (joint_ends := self._ends(joints)) is None
            or is_muscular(scene)
        ):
            return None
        method, dt, air_law = integrator.method, integrator.dt, scene.air_law
        return _Shape(method, dt, law, air_law, len(scene.masses), spring_ends, joint_ends)

    def _ends(self, parts: tuple[Any, ...]) -> _Ends | None:
        """The ends of some springs or joints; None where one of them yields or breaks."""
        key = id(parts)
        if key not in self._known:
            lasts = not parts or set(map(_LIMITS[type(parts[0])], parts)) == _NO_LIMITS[type(parts[0])]
            self._known[key] = (*map(_A, parts), *map(_B, parts)) if lasts else None
        return self._known[key]


def _side_by_side(scenes: Sequence[Scene], shape: _Shape, steps: int, every: int) -> list[Run | None]:
    """The runs of scenes of one shape; None for one that runs away, and so has to be moved alone."""
    n, width, dt = shape.masses, -(-len(scenes) // LANES) * LANES, shape.dt
    system, state = _laid_together(scenes, shape, width)
    solver = Solver(scenes[0], system, state, new_scratch(system))
    solver.load(0.0)
    still = Driver(scenes[0], system, state).drive(0.0, math.inf, {})
    here = np.arange(1, n * width + 1).reshape(n, width)
    gone: set[int] = set()

    vectors = state.x, state.y, state.vx, state.vy

    def moments() -> Floats:
        """(width, 4, n) these now."""
        return np.stack([vector[here] for vector in vectors]).transpose(2, 0, 1)

    looks = range(0, steps + 1, every) if every else range(0)
    samples = np.empty((width, len(looks), 4, n))
    for k, number in enumerate((*looks, steps)):
        while solver.run(number * dt, still) != GOOD and len(gone) < width:
            # What runs away waits as it was at the start, held, while the others go on.
            lane = (solver.index - 1) % width
            gone.add(lane)
            of_lane = here[:, lane]
            for vector, row in zip(vectors, system.start, strict=True):
                vector[of_lane] = row[of_lane - 1]
            for field in (state.vx, state.vy, state.inverse_mass, drag_of(state), state.gx, state.gy):
                field[of_lane] = 0.0
            solver.integrator.a.reshape(2, -1)[:, of_lane] = 0.0
            solver.integrator.run.status = GOOD
        if k < len(looks):
            samples[:, k] = moments()
    ends, times = moments(), np.array([number * dt for number in looks])
    return [
        None
        if lane in gone
        else Run(
            steps * dt,
            ends[lane, :2].T,
            ends[lane, 2:].T,
            None,
            times,
            samples[lane, :, :2].transpose(0, 2, 1),
            samples[lane, :, 2:].transpose(0, 2, 1),
        )
        for lane in range(len(scenes))
    ]


def _laid_together(scenes: Sequence[Scene], shape: _Shape, width: int) -> tuple[System, State]:
    """The tables of one body that consists of all scenes, and its state at the start.

    Mass m of scene i is mass `width` m + i of the body; springs and joints are numbered in the same way.
    Lanes that are left over are copies of the last scene.
    """
    n, count = shape.masses, len(scenes)
    springs, joints = (_parts(scenes, attrgetter(f)) for f in ("linear_springs", "angular_springs"))
    lanes = np.arange(width)

    def laid(numbers: Floats) -> Floats:
        """Numbers (scenes, k) of the parts of the body."""
        left_over = np.broadcast_to(numbers[-1:], (width - count, numbers.shape[1]))
        return np.concatenate((numbers, left_over)).T.ravel()

    ends = [
        (width * np.array(end, np.int64)[:, None] + lanes).tobytes()
        for both in (shape.springs, shape.joints)
        for end in (both[: len(both) // 2], both[len(both) // 2 :])
    ]
    wiring = wired(n * width, False, *ends)
    scale = np.array([scene.rest_length_scale for scene in scenes])[:, None]
    diagonal = [scene.template is not None and bool(scene.template % 90) for scene in scenes]
    strength = joints("stiffness") * np.where(diagonal, np.sqrt(2.0), 1.0)[:, None]
    body = with_numbers(
        wiring,
        [laid(springs("stiffness")), laid(springs("damping")), laid(springs("rest_length") * scale)],
        [laid(strength), laid(joints("damping")), laid(joints("rest_angle"))],
        shape.law,
        SHORTEST_SQUARED,
    )
    free = np.ones((count, n))
    for row, scene in zip(free, scenes, strict=True):
        for anchor in scene.anchors:
            row[anchor.mass] = 0.0
    inverse_mass = free * (1.0 / _parts(scenes, attrgetter("masses"))("mass"))
    air = np.array([0.0 if scene.wind else scene.air_friction for scene in scenes])[:, None]
    around = body.environment.replaced(air=still_air(shape.air_law, float(air.max())))
    body = body.replaced(environment=around)
    gravity = np.array([scene.gravity for scene in scenes])[:, None, :] * free[:, :, None]
    if any(map(is_loaded, scenes)):
        loads = np.array([[constant_force(mass) or (0.0, 0.0) for mass in scene.masses] for scene in scenes])
        gravity = gravity + inverse_mass[:, :, None] * loads
    positions, velocities = _starts(scenes, n)
    velocities = velocities * free[:, :, None]
    start = [laid(vectors[:, :, axis]) for vectors in (positions, velocities) for axis in (0, 1)]
    weights = laid(inverse_mass)
    system = System(
        body=body,
        mass_order=wiring.mass_order,
        mass_index=wiring.mass_index,
        vector_index=wiring.vector_index,
        slots=wiring.slots,
        spring_order=wiring.spring_order,
        joint_order=wiring.joint_order,
        inverse_mass=weights,
        held=weights == 0.0,
        start=np.array(start),
        loads=None,
    )
    state = new_state(system)
    update_rest_state(body, state)
    here = slice(1, n * width + 1)
    still = drag_of(state)
    fields = state.x, state.y, state.vx, state.vy, state.inverse_mass, still, state.gx, state.gy
    numbers = *start, weights, laid(inverse_mass * air), laid(gravity[:, :, 0]), laid(gravity[:, :, 1])
    for field, values in zip(fields, numbers, strict=True):
        field[here] = values
    return system, state


def _parts(scenes: Sequence[Scene], parts_of: Callable[[Scene], tuple[Any, ...]]) -> Callable[[str], Floats]:
    """A function that gives the numbers that all parts of a kind have in a field, (scenes, parts)."""
    every = list(map(parts_of, scenes))
    first, count = every[0], len(scenes)
    same = all(parts is first for parts in every)

    def numbers(field: str) -> Floats:
        if same:
            return np.broadcast_to(column(first, field), (count, len(first)))
        found = map(attrgetter(field), chain.from_iterable(every))
        return np.fromiter(found, float, count * len(first)).reshape(count, len(first))

    return numbers


def _starts(scenes: Sequence[Scene], masses: int) -> tuple[Floats, Floats]:
    """(scenes, masses, 2) the positions, px, and the velocities, px/s, from which scenes start."""
    found = []
    for field, posed in (("position", "positions"), ("velocity", "velocities")):
        vectors = (
            getattr(scene.pose, posed) if scene.pose is not None else map(attrgetter(field), scene.masses)
            for scene in scenes
        )
        flat = chain.from_iterable(chain.from_iterable(vectors))
        found.append(np.fromiter(flat, float, 2 * masses * len(scenes)).reshape(-1, masses, 2))
    return found[0], found[1]
