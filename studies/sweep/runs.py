"""One run of a sweep, as a function of nothing but its arguments, so that it can be computed anywhere."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cache, lru_cache
from importlib.metadata import version
from typing import NamedTuple

import msgspec
import numpy as np

import sim
from app.session.log import this_machine
from sim.motion.many import is_laned
from sim.settings import apply_assignments
from sim.store.files import decode_scene, encode_scene

from .measures import AT_END, GAVE_UP, SAMPLED, Floats, Track, Value, values_of

LOOKS = 120
"""Looks at the body per simulated second, where time steps are not longer; a whole number of steps apart."""

REFERENCE = "rodas5p"
"""The method of near-exact runs: it bears any stiffness."""
EXACT = 1e-9
"""Its largest tolerance, px."""
FINER = 1e-3
"""Its tolerance relative to the smallest one of a sweep."""
_FINEST = 1e-12

MAX_ATTEMPTS = 1e7
"""Steps that a method with error control may try per simulated second: with so many they are a tenth of the
shortest step that a scene can have. With more it would hardly ever get to the end."""

_MAX_NOTED = 2**17
"""Places of masses that a run beside others may note: 4 MB with their velocities."""
_MAX_MOVED = 2**23
"""Masses times steps that a run beside others may have: some dozen such runs take a few seconds."""

Points = tuple[tuple[float, float], ...]


class Row(msgspec.Struct, frozen=True):
    """What came of a run.

    Attributes:
        values: of the measures; None where there is none.
        by: what computed it: machine and versions.
    """

    values: tuple[Value, ...]
    by: str


def run(
    data: bytes,
    assignments: Sequence[str],
    duration: float,
    measures: Sequence[str],
    reference: Points | None = None,
) -> Row:
    """Simulate and measure.

    Args:
        data: the scene as a file has it.
        assignments: what is changed in it, KEY=VALUE.
        duration: s; rounded to whole time steps.
        measures: names.
        reference: near-exact positions at the end, px, for the measure `error`.
    """
    (row,) = run_several(data, [assignments], duration, measures, [reference])
    return row


def run_several(
    data: bytes,
    assignments: Sequence[Sequence[str]],
    duration: float,
    measures: Sequence[str],
    references: Sequence[Points | None],
) -> list[Row]:
    """Several runs; arguments as of `run`, of each. Those of which `is_quick` holds are done side by side."""
    scenes = [apply_assignments(_decoded(data), each) for each in assignments]
    exact = [None if each is None else np.array(each) for each in references]
    rows: dict[int, Row] = {}
    alike: dict[float, list[int]] = {}
    for i, scene in enumerate(scenes):
        if is_quick(scene, duration, measures):
            alike.setdefault(scene.integrator.dt, []).append(i)
        else:
            rows[i] = _alone(scene, duration, measures, exact[i])
    for some in alike.values():
        made = _side_by_side([scenes[i] for i in some], duration, measures, [exact[i] for i in some])
        rows.update(zip(some, made, strict=True))
    return [rows[i] for i in range(len(scenes))]


def is_quick(scene: sim.Scene, duration: float, measures: Sequence[str]) -> bool:
    """Whether a run needs no simulation of its own, so that `run_several` does many in one go."""
    if not (SAMPLED.issuperset(measures) and is_laned(scene)):
        return False
    steps, masses = steps_of(scene, duration), len(scene.masses)
    looks = 2 if AT_END.issuperset(measures) else steps // looks_apart(scene.integrator.dt) + 2
    return masses * looks <= _MAX_NOTED and masses * steps <= _MAX_MOVED


def _alone(scene: sim.Scene, duration: float, measures: Sequence[str], exact: Floats | None) -> Row:
    simulation = sim.Simulation(scene)
    track = Track(simulation, measures)
    if not follow(simulation, duration, None if AT_END.issuperset(measures) else track.look):
        return _ended(GAVE_UP if simulation.divergence is None else False, measures)
    return Row(tuple(map(_finite, track.values(measures, exact))), made_by())


def _side_by_side(
    scenes: Sequence[sim.Scene], duration: float, measures: Sequence[str], exact: Sequence[Floats | None]
) -> list[Row]:
    """The rows of quick runs with one time step."""
    dt, steps = scenes[0].integrator.dt, steps_of(scenes[0], duration)
    every = steps if AT_END.issuperset(measures) else looks_apart(dt)
    return [
        Row(tuple(map(_finite, values_of(scene, run, measures, end))), made_by())
        if run.divergence is None
        else _ended(False, measures)
        for scene, run, end in zip(scenes, sim.run_many(scenes, steps * dt, every), exact, strict=True)
    ]


def _ended(survived: Value, measures: Sequence[str]) -> Row:
    """The row of a run that did not come to its end."""
    return Row(tuple(survived if name == "survived" else None for name in measures), made_by())


def simulation_of(data: bytes, assignments: Sequence[str]) -> sim.Simulation:
    """The start of a run; arguments as of `run`."""
    return sim.Simulation(apply_assignments(_decoded(data), assignments))


def follow(simulation: sim.Simulation, duration: float, look: Callable[[], None] | None) -> bool:
    """Simulate for so many seconds, rounded to whole time steps, and look at the body now and then.

    Args:
        simulation: at its start.
        duration: s.
        look: called at the start, after each `looks_apart` steps, and at the end; None for no looks.

    Returns:
        Whether it got there: False where it ran away, or where its method would hardly ever get to the end.
    """
    steps = steps_of(simulation.scene, duration)
    between = looks_apart(simulation.dt)
    if look is None:
        attempts = _attempts(between, simulation)
        while (left := steps - simulation.step_count) > 0:
            # As far as the attempts lead; they have to lead as far as from one look to the next.
            if simulation.step(left, attempts) < min(between, left):
                return False
        return True
    look()
    while simulation.step_count < steps:
        if not _go(simulation, min(between, steps - simulation.step_count)):
            return False
        look()
    return True


def looks_apart(dt: float) -> int:
    """The time steps from one look to the next."""
    return max(1, round(1.0 / (LOOKS * dt)))


def _go(simulation: sim.Simulation, steps: int) -> bool:
    """Do so many time steps, and return whether they could be done."""
    return simulation.step(steps, _attempts(steps, simulation)) == steps


def _attempts(steps: int, simulation: sim.Simulation) -> int:
    """The attempts that so many time steps may take."""
    return math.ceil(MAX_ATTEMPTS * steps * simulation.dt)


def _finite(value: Value) -> Value:
    return None if isinstance(value, float) and not math.isfinite(value) else value


def steps_of(scene: sim.Scene, duration: float) -> int:
    """The time steps that a run of so many seconds has, at least one."""
    return max(1, round(duration / scene.integrator.dt))


class Reference(NamedTuple):
    """A near-exact run.

    Attributes:
        data: its scene as a file has it.
        end: simulated time, s.
    """

    data: bytes
    end: float


def reference_of(scene: sim.Scene, duration: float, smallest: float) -> Reference:
    """The near-exact run of a scene.

    It ends when the scene's own does, and is the same for all that differ in no more than method, tolerance
    and steps of which a whole number makes the duration.

    Args:
        scene: of the run.
        duration: of the run, s.
        smallest: tolerance of all runs of the sweep, px.
    """
    tolerance = max(_FINEST, min(EXACT, FINER * smallest))
    exact = sim.Integrator(method=REFERENCE, tolerance=tolerance)
    # Rounded, since the same end is not quite the same product of different steps.
    end = float(f"{steps_of(scene, duration) * scene.integrator.dt:.12g}")
    return Reference(encode_scene(msgspec.structs.replace(scene, integrator=exact)), end)


def run_reference(data: bytes, end: float) -> Points | None:
    """The positions at the end of a near-exact run, px; None where it does not get there."""
    parts = math.ceil(LOOKS * end)
    simulation = sim.Simulation(decode_scene(data, "the reference"), dt=end / parts)
    if not all(_go(simulation, 1) for _ in range(parts)):
        return None
    return tuple((x, y) for x, y in simulation.positions.tolist())


@lru_cache(1)
def _decoded(data: bytes) -> sim.Scene:
    return decode_scene(data, "the scene of the sweep")


@cache
def made_by() -> str:
    """What the last digits of a row may depend on."""
    return f"softrod {version('softrod')} on {this_machine()} and numpy {np.__version__}"
