"""One run of a sweep: a pure function of its arguments, which can be computed anywhere."""

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

SAMPLE_RATE = 120
"""Samples per simulated second, rounded to whole time steps."""

REFERENCE = "rodas5p"
"""The method of near-exact runs: it handles any stiffness."""

MAX_TOLERANCE = 1e-9
"""Its largest tolerance, px."""

RELATIVE_TOLERANCE = 1e-3
"""Its tolerance relative to the smallest one of a sweep."""

MIN_TOLERANCE = 1e-12
"""Its smallest tolerance, px."""

MAX_ATTEMPTS = 1e7
"""Steps that a method with error control may attempt per simulated second: they are a tenth of the shortest
step that a scene can have. With more, a run would hardly ever reach its end."""

_MAX_SAMPLED = 2**17
"""Sampled positions of a run that is done with others side by side: 4 MB with their velocities."""

_MAX_MASS_STEPS = 2**23
"""Masses times steps of such a run: some dozen of them take a few seconds."""

Points = tuple[tuple[float, float], ...]


class Row(msgspec.Struct, frozen=True):
    """The row of a run.

    Attributes:
        values: of the measures; None if there is none.
        by: machine and versions that computed it.
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
        data: the scene in the format of files.
        assignments: changes of it, KEY=VALUE.
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
    """Do several runs, the quick ones side by side; arguments are those of `run`, for each."""
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
    """Whether a run needs no simulation of its own, so that `run_several` does many in one call."""
    if not (SAMPLED.issuperset(measures) and is_laned(scene)):
        return False
    steps, masses = steps_of(scene, duration), len(scene.masses)
    samples = 2 if AT_END.issuperset(measures) else steps // steps_between_samples(scene.integrator.dt) + 2
    return masses * samples <= _MAX_SAMPLED and masses * steps <= _MAX_MASS_STEPS


def _alone(scene: sim.Scene, duration: float, measures: Sequence[str], exact: Floats | None) -> Row:
    simulation = sim.Simulation(scene)
    track = Track(simulation, measures)
    if not follow(simulation, duration, None if AT_END.issuperset(measures) else track.look):
        return _ended(GAVE_UP if simulation.divergence is None else False, measures)
    return Row(tuple(map(_finite, track.values(measures, exact))), made_by())


def _side_by_side(
    scenes: Sequence[sim.Scene], duration: float, measures: Sequence[str], exact: Sequence[Floats | None]
) -> list[Row]:
    """Return the rows of quick runs with the same time step."""
    dt, steps = scenes[0].integrator.dt, steps_of(scenes[0], duration)
    every = steps if AT_END.issuperset(measures) else steps_between_samples(dt)
    return [
        Row(tuple(map(_finite, values_of(scene, run, measures, end))), made_by())
        if run.divergence is None
        else _ended(False, measures)
        for scene, run, end in zip(scenes, sim.run_many(scenes, steps * dt, every), exact, strict=True)
    ]


def _ended(survived: Value, measures: Sequence[str]) -> Row:
    """Return the row of a run that did not reach its end."""
    return Row(tuple(survived if name == "survived" else None for name in measures), made_by())


def simulation_of(data: bytes, assignments: Sequence[str]) -> sim.Simulation:
    """Return a simulation at the start of a run; arguments are those of `run`."""
    return sim.Simulation(apply_assignments(_decoded(data), assignments))


def follow(simulation: sim.Simulation, duration: float, look: Callable[[], None] | None) -> bool:
    """Simulate for so many seconds, rounded to whole time steps, with samples in between.

    Args:
        simulation: at its start.
        duration: s.
        look: called at the start, after every `steps_between_samples` steps, and at the end; or None.

    Returns:
        Whether it reached the end: False if it ran away, or if its method would hardly ever get there.
    """
    steps = steps_of(simulation.scene, duration)
    between = steps_between_samples(simulation.dt)
    if look is None:
        attempts = _attempts(between, simulation)
        while (left := steps - simulation.step_count) > 0:
            # As far as the attempts suffice; they have to suffice from one sample to the next.
            if simulation.step(left, attempts) < min(between, left):
                return False
        return True
    look()
    while simulation.step_count < steps:
        if not _go(simulation, min(between, steps - simulation.step_count)):
            return False
        look()
    return True


def steps_between_samples(dt: float) -> int:
    """Return the number of time steps from one sample to the next."""
    return max(1, round(1.0 / (SAMPLE_RATE * dt)))


def _go(simulation: sim.Simulation, steps: int) -> bool:
    """Do so many time steps, and return whether all could be done."""
    return simulation.step(steps, _attempts(steps, simulation)) == steps


def _attempts(steps: int, simulation: sim.Simulation) -> int:
    """Return the number of attempts that so many time steps may take."""
    return math.ceil(MAX_ATTEMPTS * steps * simulation.dt)


def _finite(value: Value) -> Value:
    return None if isinstance(value, float) and not math.isfinite(value) else value


def steps_of(scene: sim.Scene, duration: float) -> int:
    """Return the number of time steps in a run of so many seconds, at least one."""
    return max(1, round(duration / scene.integrator.dt))


class Reference(NamedTuple):
    """A near-exact run.

    Attributes:
        data: its scene in the format of files.
        end: simulated time, s.
    """

    data: bytes
    end: float


def reference_of(scene: sim.Scene, duration: float, smallest: float) -> Reference:
    """Return the near-exact run of a scene.

    It ends when the run of the scene does, and is the same for scenes that differ only in method, tolerance
    and steps that divide the duration.

    Args:
        scene: of the run.
        duration: of the run, s.
        smallest: tolerance of all runs of the sweep, px.
    """
    tolerance = max(MIN_TOLERANCE, min(MAX_TOLERANCE, RELATIVE_TOLERANCE * smallest))
    exact = sim.Integrator(method=REFERENCE, tolerance=tolerance)
    # Rounded, since the same end is not quite the same product of different steps.
    end = float(f"{steps_of(scene, duration) * scene.integrator.dt:.12g}")
    return Reference(encode_scene(msgspec.structs.replace(scene, integrator=exact)), end)


def run_reference(data: bytes, end: float) -> Points | None:
    """Return the positions at the end of a near-exact run, px; None if it does not get there."""
    parts = math.ceil(SAMPLE_RATE * end)
    simulation = sim.Simulation(decode_scene(data, "the reference"), dt=end / parts)
    if not all(_go(simulation, 1) for _ in range(parts)):
        return None
    return tuple((x, y) for x, y in simulation.positions.tolist())


@lru_cache(1)
def _decoded(data: bytes) -> sim.Scene:
    return decode_scene(data, "the scene of the sweep")


@cache
def made_by() -> str:
    """Return the machine and versions on which the last digits of a row may depend."""
    return f"softrod {version('softrod')} on {this_machine()} and numpy {np.__version__}"
