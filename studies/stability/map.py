"""Maps of stability: how runs end over two parameters, and where linear theory puts the border."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from sim import Integrator, Scene, Simulation
from sim.motion.stability import largest_step
from sim.scene.parts import constant_force
from sim.solve.registry import METHODS

from .axes import Axis, extent, in_cell

Floats = NDArray[np.float64]

UNKNOWN = -1
ACCURATE = 0
DAMPED_WRONGLY = 1
UNSTABLE = 2
NO_REFERENCE = 3
ENDINGS = {
    ACCURATE: "accurate",
    DAMPED_WRONGLY: "damped wrongly",
    UNSTABLE: "unstable",
    NO_REFERENCE: "no reference",
    UNKNOWN: "",
}
"""The endings of runs, for people."""

NEAR = 0.01
"""Largest distance from the reference, in extents of the body, of a run that counts as accurate."""

SAMPLES = 20
"""Samples of a run."""

_MAX_ATTEMPTS = 60
"""Attempts per step for a method that shortens steps that fail; one that needs more counts as failed."""

_REFERENCE_SAMPLES = 400
"""Samples of a reference, which is interpolated by cubics between them."""

_MAX_REFERENCE_STEPS = 20_000
"""Steps between two samples of a reference."""


@dataclass
class Map:
    """One map; rows are along y, columns along x.

    Attributes:
        x, y: axes.
        xs, ys: their values.
        dt: time step, s, unless it is an axis.
        endings: (rows, columns) of each method, see ENDINGS.
        errors: largest distance from the reference at any sample, in extents; NaN where a body ran away.
        limits: analytic limit of the step in each cell, s.
    """

    x: Axis
    y: Axis
    xs: Floats
    ys: Floats
    dt: float
    endings: dict[str, NDArray[np.int64]] = field(default_factory=dict)
    errors: dict[str, Floats] = field(default_factory=dict)
    limits: dict[str, Floats] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """Name of its files."""
        return f"{self.x.key}-{self.y.key}"

    @property
    def complete(self) -> bool:
        """Whether every cell of every method that was begun is computed."""
        return all((ending != UNKNOWN).all() for ending in self.endings.values())

    def steps(self) -> Floats:
        """Return the (rows, columns) time steps of the cells, s."""
        if self.x.key == "dt":
            return np.broadcast_to(self.xs, self.shape)
        if self.y.key == "dt":
            return np.broadcast_to(self.ys[:, None], self.shape)
        return np.full(self.shape, self.dt)

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return len(self.ys), len(self.xs)


@dataclass(frozen=True)
class Track:
    """The sampled motion of a body in a cell.

    Attributes:
        times: (SAMPLES,) s.
        positions: (SAMPLES, n, 2) px, in the order of the scene's masses; NaN once the body has passed the
            limits of a `Simulation`, or the method has found no step.
        velocities: (SAMPLES, n, 2) px/s; NaN as well then.
    """

    times: Floats
    positions: Floats
    velocities: Floats


def track_of(scene: Scene, method: str, dt: float, duration: float) -> Track:
    """Run a scene by a method with steps of `dt` s, at least one, and sample it at even times."""
    simulation = Simulation(scene, dt=dt, integrator=method)
    steps = max(1, round(duration / dt))
    marks = [max(1, round(steps * (k + 1) / SAMPLES)) for k in range(SAMPLES)]
    positions, velocities = np.full((2, SAMPLES, len(scene.masses), 2), np.nan)
    for k, mark in enumerate(marks):
        more = mark - simulation.step_count
        if simulation.step(more, attempts=_MAX_ATTEMPTS * more) < more:
            break
        positions[k], velocities[k] = simulation.positions, simulation.velocities
    return Track(dt * np.array(marks), positions, velocities)


def fixed_step_methods() -> list[str]:
    """Return the methods that a map can have."""
    return [name for name, method in METHODS.items() if not method.adaptive]


class ReferenceMotion:
    """A reference motion: by `auto`, to a thousandth of what counts as accurate.

    Attributes:
        extent: of the body at the start, px.
        budget: energy put in, kg px²/s²: kinetic and elastic energy at the start, and the work of the body's
            weight along its extent.
        ceiling: upper bound of kinetic and potential energy in a stable motion: a budget more than in the
            reference. The springs' energy is left out, since those of the stable spring are softer.
    """

    def __init__(self, scene: Scene, duration: float) -> None:
        self.extent = extent(scene)
        dt = duration / _REFERENCE_SAMPLES
        integrator = Integrator(method="auto", dt=dt, tolerance=min(1e-3 * NEAR * self.extent, 1.0))
        simulation = Simulation(replace(scene, integrator=integrator))
        start = simulation.energy()
        shape = _REFERENCE_SAMPLES + 1, len(scene.masses), 2
        self._dt = dt
        self._positions, self._velocities = np.full((2, *shape), np.nan)
        for k in range(_REFERENCE_SAMPLES + 1):
            if k and simulation.step(attempts=_MAX_REFERENCE_STEPS) < 1:
                break
            self._positions[k], self._velocities[k] = simulation.positions, simulation.velocities
        self.known = bool(np.isfinite(self._positions).all())
        self._mass = np.array([m.mass for m in scene.masses])
        forces = [constant_force(mass) or (0.0, 0.0) for mass in scene.masses]
        self._forces = np.outer(self._mass, scene.gravity) + forces
        energy = self._energy(self._positions, self._velocities)
        weight = sum(m.mass for m in scene.masses) * math.hypot(*scene.gravity)
        weight += sum(math.hypot(*force) for m in scene.masses if (force := constant_force(m)))
        self.budget = start.kinetic + start.linear + start.angular + weight * self.extent
        self.ceiling = float(np.nanmax(energy)) + self.budget

    def judge(self, track: Track) -> tuple[int, float]:
        """Return how a run ended, and its largest distance from the reference, in extents."""
        if not np.isfinite(track.positions).all():
            return UNSTABLE, math.nan
        energy = self._energy(track.positions, track.velocities)
        apart = track.positions - self._at(track.times)
        error = float(np.hypot(apart[..., 0], apart[..., 1]).max()) / self.extent
        if not np.max(energy) <= self.ceiling:
            return UNSTABLE, error
        if not self.known:
            return NO_REFERENCE, math.nan
        return (ACCURATE if error <= NEAR else DAMPED_WRONGLY), error

    def _energy(self, positions: Floats, velocities: Floats) -> Floats:
        """Return (samples,) kinetic and potential energy, with that of constant forces."""
        kinetic = 0.5 * (self._mass[:, None] * velocities**2).sum((1, 2))
        return kinetic - (positions * self._forces).sum((1, 2))

    def _at(self, times: Floats) -> Floats:
        """Return (samples, n, 2) positions at some times, extrapolated beyond the end."""
        k = np.clip((times / self._dt).astype(np.int64), 0, _REFERENCE_SAMPLES - 1)
        u = (times / self._dt - k)[:, None, None]
        p, q = self._positions[k], self._positions[k + 1]
        v, w = self._dt * self._velocities[k], self._dt * self._velocities[k + 1]
        return p + u * (v + u * (3.0 * (q - p) - 2.0 * v - w + u * (2.0 * (p - q) + v + w)))


def compute(
    scene: Scene,
    chart: Map,
    methods: Sequence[str],
    duration: float,
    report: Callable[[int, int, str], None] = lambda done, of, what: None,
) -> None:
    """Fill in a map; an interruption leaves what is done in it.

    Args:
        scene: with everything that is not varied; something in it is free to move.
        chart: the map.
        methods: names of methods with a fixed step.
        duration: simulated time of each cell, s.
        report: called with the parts done, the number of parts, and what is being done.

    Raises:
        InputError: the numbers of a cell make no valid scene.
    """
    steps = chart.steps()
    keys = {cell: _key(chart, *cell) for cell in np.ndindex(*chart.shape)}
    scenes: dict[tuple[float, ...], Scene] = {}
    for (i, j), key in keys.items():
        values = {chart.x.key: float(chart.xs[j]), chart.y.key: float(chart.ys[i])}
        if key not in scenes:
            scenes[key] = in_cell(scene, {k: v for k, v in values.items() if k != "dt"})
    total = 2 * len(scenes) + len(keys) * len(methods)
    references: dict[tuple[float, ...], ReferenceMotion] = {}
    limits: dict[tuple[float, ...], dict[str, float]] = {}
    done = 2 * len(scenes)
    pool = ThreadPoolExecutor(os.cpu_count())  # kernels release the GIL
    try:
        exact = pool.map(lambda at: ReferenceMotion(at, duration), scenes.values())
        for key, reference in zip(scenes, exact, strict=True):
            references[key] = reference
            report(len(references), total, "references")
        for key, at in scenes.items():
            limits[key] = {method: largest_step(at, method) for method in methods}
            report(len(scenes) + len(limits), total, "analytic limits")
        for method in methods:
            endings = chart.endings[method] = np.full(chart.shape, UNKNOWN)
            errors = chart.errors[method] = np.full(chart.shape, np.nan)
            chart.limits[method] = np.reshape([limits[key][method] for key in keys.values()], chart.shape)

            def run(cell: tuple[int, ...], method: str = method) -> Track:
                return track_of(scenes[keys[cell]], method, float(steps[cell]), duration)

            for cell, track in zip(keys, pool.map(run, keys), strict=True):
                endings[cell], errors[cell] = references[keys[cell]].judge(track)
                done += 1
                report(done, total, method)
    finally:
        pool.shutdown(cancel_futures=True)


def _key(chart: Map, row: int, column: int) -> tuple[float, ...]:
    """Return what a cell's scene depends on: the values other than the time step."""
    values = ((chart.x.key, chart.xs[column]), (chart.y.key, chart.ys[row]))
    return tuple(float(value) for key, value in values if key != "dt")


def borders(chart: Map, method: str) -> Floats:
    """Return the steps at which a method turns unstable, over the analytic limits; empty without steps.

    For each line of cells along the step, this is the geometric mean of the first unstable step and the one
    before. Lines that are all stable or have no limit are left out.
    """
    if "dt" not in (chart.x.key, chart.y.key):
        return np.empty(0)
    unstable, limits = chart.endings[method] == UNSTABLE, chart.limits[method]
    steps = chart.xs
    if chart.y.key == "dt":
        unstable, limits, steps = unstable.T, limits.T, chart.ys
    found = []
    for line, limit in zip(unstable, limits[:, 0], strict=True):
        first = int(line.argmax())
        if line.any() and first > 0 and math.isfinite(limit):
            found.append(math.sqrt(steps[first - 1] * steps[first]) / limit)
    return np.array(found)
