"""`run_many`: many scenes, each from its own start, in one call.

Scenes of one shape are moved side by side (`kernels.integrators.many`), in a fiftieth of the time that a
`Simulation` of each takes. They are those of which `is_laned` holds: an explicit method with a fixed step;
springs, still air and gravity, and nothing else that acts on masses; no law but those whose torque is a sine;
nothing that yields or breaks; no held mass that moves by itself. Any other scene has a `Simulation` of its
own. So has one that leaves the bounds of good states, so that it ends where a `Simulation` does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from operator import attrgetter
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..body.layout import slab
from ..errors import InputError, SceneError
from ..forces.environment import acting_on
from ..forces.joints import LAWS, NO_JOINTS, SINE_LAWS
from ..kernels.core.tables import Tableau
from ..kernels.integrators.many import LANES, Batch, run_batch
from ..methods.tableaux import RK4
from ..scene.columns import column
from ..scene.numbers import MAX_COORDINATE, RUNAWAY_SPEED
from ..scene.parts import AngularSpring, LinearSpring
from ..scene.types import Scene, is_loaded, is_muscular
from ..scene.validate import validate
from .divergence import Divergence
from .simulation import Simulation

Floats = NDArray[np.float64]

_MAX_SAMPLES = 2**24
"""Numbers in the samples of bodies that are moved at once: 128 MB."""


class _Method(NamedTuple):
    """How a method steps; see `Batch`."""

    table: Tableau
    corrects: bool = False


def _one_stage(to_position: float) -> Tableau:
    """One evaluation a step, at the end of the step before: q + h v + h² to_position k, and v + h k."""
    a, abar = np.zeros((2, 2, 2))
    a[1, 0], abar[1, 0] = 1.0, to_position
    return Tableau(stages=1, c=np.array([0.0, 1.0]), a=a, abar=abar)


_METHODS = {
    "symplectic_euler": _Method(_one_stage(1.0)),
    "velocity_verlet": _Method(_one_stage(0.5), corrects=True),
    "rk4": _Method(RK4),
}
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
        raise InputError(f"run_many: {seconds:g} is not in the range 0..1e+09 s")
    if every is not None and not (isinstance(every, int) and every >= 1):
        raise InputError(f"run_many: every is {every}, but must be a whole number from 1")
    scenes = list(scenes)
    shapes = _Shapes()
    groups: dict[_Shape, list[int]] = {}
    runs: list[Run | None] = [None] * len(scenes)
    for i, scene in enumerate(scenes):
        try:
            validate(scene)
        except SceneError as error:
            raise SceneError(f"scenes[{i}]: {error}") from None
        shape = shapes.of(scene)
        if shape is not None:
            groups.setdefault(shape, []).append(i)
    for shape, members in groups.items():
        steps = _steps(shape.dt, seconds)
        numbers = 1 + (steps // every + 1 if every else 0)
        at_once = LANES * max(1, _MAX_SAMPLES // (numbers * 4 * shape.masses * LANES))
        for first in range(0, len(members), at_once):
            some = members[first : first + at_once]
            for i, run in zip(
                some, _side_by_side([scenes[i] for i in some], shape, steps, every), strict=True
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
    LinearSpring: attrgetter("strength", "yield_force"),
    AngularSpring: attrgetter("yield_torque"),
}
"""What a spring or a joint bears; None for any load."""
_NO_LIMITS = {LinearSpring: {(None, None)}, AngularSpring: {None}}
"""The same of parts that bear any load."""


class _Shape(NamedTuple):
    """What scenes have in common that are moved side by side: the method, and what connects the masses."""

    method: str
    dt: float
    law: int
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
            or law not in SINE_LAWS
            or acting_on(scene)
            or (scene.pose is not None and scene.pose.damage is not None)
            or any(anchor.circle is not None for anchor in scene.anchors)
            or len(scene.anchors) == len(scene.masses)
            or (spring_ends := self._ends(springs)) is None
            or (joint_ends := self._ends(joints)) is None
            or is_muscular(scene)
        ):
            return None
        return _Shape(integrator.method, integrator.dt, law, len(scene.masses), spring_ends, joint_ends)

    def _ends(self, parts: tuple[Any, ...]) -> _Ends | None:
        """The ends of some springs or joints; None where one of them yields or breaks."""
        key = id(parts)
        if key not in self._known:
            lasts = not parts or set(map(_LIMITS[type(parts[0])], parts)) == _NO_LIMITS[type(parts[0])]
            self._known[key] = (*map(_A, parts), *map(_B, parts)) if lasts else None
        return self._known[key]


def _side_by_side(scenes: Sequence[Scene], shape: _Shape, steps: int, every: int | None) -> list[Run | None]:
    """The runs of scenes of one shape; None for one that has to be moved alone."""
    count, groups, n = len(scenes), -(-len(scenes) // LANES), shape.masses
    method, table = _METHODS[shape.method], _METHODS[shape.method].table
    springs, joints = (_parts(scenes, attrgetter(f)) for f in ("linear_springs", "angular_springs"))
    masses = _parts(scenes, attrgetter("masses"))
    stiffness, damping = springs("stiffness"), springs("damping")
    scale = np.array([scene.rest_length_scale for scene in scenes])[:, None]
    diagonal = [scene.template is not None and bool(scene.template % 90) for scene in scenes]
    strength = joints("stiffness") * np.where(diagonal, np.sqrt(2.0), 1.0)[:, None]
    rest = np.radians(180.0 - (180.0 - joints("rest_angle")) % 360.0)
    friction = joints("damping")
    free = np.ones((count, n))
    for row, scene in zip(free, scenes, strict=True):
        for anchor in scene.anchors:
            row[anchor.mass] = 0.0
    inverse_mass = free * (1.0 / masses("mass"))
    air = np.array([0.0 if scene.wind else scene.air_friction for scene in scenes])[:, None]
    gravity = np.array([scene.gravity for scene in scenes])[:, None, :] * free[:, :, None]
    if any(map(is_loaded, scenes)):
        loads = np.array([[mass.force or (0.0, 0.0) for mass in scene.masses] for scene in scenes])
        gravity = gravity + inverse_mass[:, :, None] * loads
    positions, velocities = _starts(scenes, n)
    velocities = velocities * free[:, :, None]
    looks = 0 if every is None else steps // every + 1
    held = len(shape.springs) // 2, len(shape.joints) // 2
    spring_run, spring_a, spring_b = _runs(shape.springs)
    joint_run, joint_a, joint_b = _runs(shape.joints)
    batch = Batch(
        groups=groups,
        masses=n,
        springs=held[0],
        joints=held[1],
        law=shape.law,
        damped=bool(damping.any()),
        joint_damped=bool(friction.any()),
        spring_run=spring_run,
        spring_a=spring_a,
        spring_b=spring_b,
        joint_run=joint_run,
        joint_a=joint_a,
        joint_b=joint_b,
        stiffness=_laid(stiffness),
        damping=_laid(damping),
        rest_tension=_laid(stiffness * (springs("rest_length") * scale)),
        torque_cos=_laid(strength * np.cos(rest)),
        torque_sin=_laid(strength * np.sin(rest)),
        torque_size=_laid(strength),
        torque_damping=_laid(friction),
        inverse_mass=_laid(inverse_mass),
        air=_laid(inverse_mass * air),
        gx=_laid(gravity[:, :, 0]),
        gy=_laid(gravity[:, :, 1]),
        x=_laid(positions[:, :, 0]),
        y=_laid(positions[:, :, 1]),
        vx=_laid(velocities[:, :, 0]),
        vy=_laid(velocities[:, :, 1]),
        stages=table.stages,
        c=table.c,
        a=table.a,
        abar=table.abar,
        corrects=method.corrects,
        h=shape.dt,
        steps=steps,
        every=every or 1,
        samples=np.empty(groups * looks * 4 * n * LANES),
        far=np.zeros(groups * LANES),
        fast=np.zeros(groups * LANES),
        **_scratch(n, *held, table.stages),
    )
    run_batch(batch)
    good = (batch.far <= MAX_COORDINATE) & (batch.fast <= RUNAWAY_SPEED)  # not NaN either
    ends = np.stack((batch.x, batch.y, batch.vx, batch.vy), 1).reshape(groups, n, LANES, 4)
    ends = ends.transpose(0, 2, 1, 3).reshape(-1, n, 4)
    samples = batch.samples.reshape(groups, looks, 4, n, LANES).transpose(0, 4, 1, 3, 2)
    samples = samples.reshape(groups * LANES, looks, n, 4)
    time = steps * shape.dt
    times = np.array([k * (every or 1) * shape.dt for k in range(looks)])
    return [
        Run(time, end[:, :2], end[:, 2:], None, times, path[:, :, :2], path[:, :, 2:]) if ok else None
        for ok, end, path in zip(good[:count].tolist(), ends, samples, strict=False)
    ]


def _runs(ends: _Ends) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Runs of parts whose ends count up by one, see `Batch`: their first parts and the end of the last, and
    both ends of these."""
    a, b = np.array(ends, np.int64).reshape(2, -1)
    firsts = np.flatnonzero((np.diff(a, prepend=-2) != 1) | (np.diff(b, prepend=-2) != 1))
    return np.append(firsts, a.size), a[firsts], b[firsts]


def _scratch(masses: int, springs: int, joints: int, stages: int) -> dict[str, Floats]:
    """The scratch of a `Batch`, by its names."""
    sizes = {
        **dict.fromkeys(("qx", "qy", "ux", "uy"), masses),
        **dict.fromkeys(("kx", "ky"), masses * (stages + 1)),
        **dict.fromkeys(("lx", "ly", "inverse", "turning", "tx", "ty"), springs),
        **dict.fromkeys(("on_ax", "on_ay", "on_bx", "on_by"), joints),
    }
    arrays = slab([(LANES * size, 0) for size in sizes.values()], page_offset=0)
    return dict(zip(sizes, arrays, strict=True))


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


def _laid(numbers: Floats) -> Floats:
    """Numbers (bodies, k) as `Batch` has them. The last group is filled up with copies of the last body."""
    count, k = numbers.shape
    groups = -(-count // LANES)
    rows = np.concatenate((numbers, np.broadcast_to(numbers[-1:], (groups * LANES - count, k))))
    return np.ascontiguousarray(rows.reshape(groups, LANES, k).transpose(0, 2, 1)).ravel()
