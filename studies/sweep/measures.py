"""What is measured of a run: at its end, or at samples all through it."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import sim
from sim.analysis.predictability import GrowthMeter
from sim.errors import InputError, did_you_mean
from sim.model.state import rest_lengths
from sim.scene.columns import column, ends

Floats = NDArray[np.float64]
Value = float | bool | str | None
"""A measure of a run; None if it has none, and GAVE_UP as a value of `survived`."""

GAVE_UP = "gave up"
"""Value of `survived` where the method would hardly ever have reached the end."""


@dataclass(frozen=True)
class Measure:
    """Something that can be measured.

    Attributes:
        name: in `--measure`.
        unit: empty for a pure number; "px" stands for the scene's own length unit.
        summary: for people.
    """

    name: str
    unit: str
    summary: str


_ALL = (
    Measure("sag", "px", "largest displacement of a mass from the start along gravity, at the end"),
    Measure("period", "s", "mean period of the swings of the free masses' centre of mass"),
    Measure(
        "energy_residual", "",
        "largest |residual| of the energy balance over the largest sum of kinetic energy, energy of the "
        "springs, and change of the energy of height",
    ),
    Measure("error", "px", "largest distance of a mass at the end from a near-exact run of the same scene"),
    Measure("stretch", "", "largest |L - rest length| / rest length of a linear spring"),
    Measure("growth", "", "factor by which a small error grows in a second, see `sim.predictability`"),
    Measure(
        "survived", "",
        "yes; no where the body ran away, or gave up where the method hardly got on, and then the rest is "
        "empty; always there",
    ),
)  # fmt: skip

MEASURES: dict[str, Measure] = {measure.name: measure for measure in _ALL}
"""The measures, by name."""

_BAND = 0.1
"""Part of the largest displacement from the mean that both sides of a swing must exceed."""

_STILL = 1e-8
"""Largest displacement, relative to the largest coordinate, that counts as rest; rounding errors, also those
amplified by methods with a tolerance, are smaller."""


def parse_measures(names: Sequence[str]) -> tuple[str, ...]:
    """Return the names of measures, each once, in the order given; `survived` is always included.

    Raises:
        InputError: there is none, or there is no such measure.
    """
    if not names:
        raise InputError(f"--measure: name at least one of {', '.join(MEASURES)}")
    for name in names:
        if name not in MEASURES:
            meant = did_you_mean(name, MEASURES)
            raise InputError(f"--measure: {name!r} is not one of {', '.join(MEASURES)}{meant}")
    return tuple(dict.fromkeys((*names, "survived")))


AT_END = frozenset(("sag", "error", "survived"))
"""Measures for which start and end suffice, without samples in between."""

SAMPLED = frozenset(("sag", "period", "error", "stretch", "survived"))
"""Measures for which sampled positions and velocities suffice, see `values_of`."""


def values_of(
    scene: sim.Scene, run: sim.Run, measures: Sequence[str], reference: Floats | None
) -> tuple[Value, ...]:
    """Compute measures of `SAMPLED` from a run that has reached its end.

    Args:
        scene: of the run.
        run: with its samples.
        measures: names.
        reference: (n, 2) px, near-exact positions at the end; None if there are none.
    """
    times, positions, velocities = run.sample_times, run.sample_positions, run.sample_velocities
    start = positions[0]
    if run.time > times[-1] + 1e-12 * run.time:
        times = np.append(times, run.time)
        positions, velocities = (
            np.concatenate((rows, last[None]))
            for rows, last in ((positions, run.positions), (velocities, run.velocities))
        )
    found: dict[str, Value] = {"survived": True}
    if "sag" in measures:
        found["sag"] = sag(np.array(scene.gravity), run.positions - start)
    if "period" in measures:
        free, weights = _free_masses(scene)
        found["period"] = (
            period(times, *(_mean(rows[:, free], weights) for rows in (positions, velocities)))
            if free.size
            else None
        )
    if "error" in measures:
        found["error"] = None if reference is None else distance(run.positions, reference)
    if "stretch" in measures:
        rest = column(scene.linear_springs, "rest_length") * scene.rest_length_scale
        of = np.flatnonzero(rest)
        a, b = (end[of] for end in ends(scene.linear_springs))
        found["stretch"] = stretch(positions[:, b] - positions[:, a], rest[of]) if of.size else None
    return tuple(found[name] for name in measures)


def _free_masses(scene: sim.Scene) -> tuple[NDArray[np.int64], Floats]:
    """Return the indices of the masses that are not held, and their masses, kg."""
    held = {anchor.mass for anchor in scene.anchors}
    free = np.array([i for i in range(len(scene.masses)) if i not in held], np.int64)
    return free, np.array([scene.masses[i].mass for i in free])


def _mean(rows: Floats, weights: Floats) -> Floats:
    """Return the mean of (..., n, k) rows with n weights."""
    return (weights[:, None] * rows).sum(-2) / weights.sum()


class Track:
    """Samples what the measures need of a simulation.

    Args:
        simulation: at its start.
        measures: names.
    """

    def __init__(self, simulation: sim.Simulation, measures: Sequence[str]) -> None:
        scene = simulation.scene
        self._simulation, self._wanted = simulation, set(measures)
        self._gravity = np.array(scene.gravity)
        self._start = simulation.positions
        self._free, self._weights = _free_masses(scene)
        self._springs = np.flatnonzero(column(scene.linear_springs, "rest_length"))
        self._a, self._b = (end[self._springs] for end in ends(scene.linear_springs))
        self._rows = np.argsort(simulation.tables[0].spring_order)[self._springs]  # in the tables
        self._stretch = self._residual = self._moved = self._farthest = 0.0
        self._height: float | None = None
        self._times: list[float] = []
        self._centres: list[Floats] = []
        self._errors = GrowthMeter(simulation) if "growth" in self._wanted else None
        simulation.track_energy("energy_residual" in self._wanted)

    def look(self) -> None:
        """Sample the present state."""
        positions = self._simulation.positions
        if "stretch" in self._wanted and self._springs.size:
            system, state = self._simulation.tables
            rest = rest_lengths(system.body, state)[self._rows]
            self._stretch = max(self._stretch, stretch(positions[self._b] - positions[self._a], rest))
        if "period" in self._wanted and self._free.size:
            velocities = self._simulation.velocities
            rows = np.concatenate((positions[self._free], velocities[self._free]), axis=1)
            self._times.append(self._simulation.time)
            self._centres.append(_mean(rows, self._weights))
        if self._errors is not None:
            self._errors.look(self._simulation)
        if "energy_residual" in self._wanted:
            balance = self._simulation.energy()
            self._height = balance.gravity if self._height is None else self._height
            height = abs(balance.gravity - self._height)
            self._moved = max(self._moved, balance.kinetic + balance.linear + balance.angular + height)
            self._residual = max(self._residual, abs(balance.residual))
            self._farthest = max(self._farthest, distance(positions, self._start))

    def values(self, measures: Sequence[str], reference: Floats | None) -> tuple[Value, ...]:
        """Return the measures at the end.

        Args:
            measures: names.
            reference: (n, 2) px, near-exact positions at the end; None if there are none.
        """
        found: dict[str, Value] = {
            "sag": sag(self._gravity, self._simulation.positions - self._start),
            "period": self._period(),
            "energy_residual": self._energy_residual(),
            "error": None if reference is None else distance(self._simulation.positions, reference),
            "stretch": self._stretch if self._springs.size else None,
            "growth": self._growth(),
            "survived": True,
        }
        return tuple(found[name] for name in measures)

    def _energy_residual(self) -> float | None:
        # A body that rests has energies of rounding errors only, and no ratio of them means anything.
        moves = self._farthest > _STILL * max(1.0, float(np.abs(self._start).max()))
        return self._residual / self._moved if moves and self._moved > 0.0 else None

    def _growth(self) -> float | None:
        if self._errors is None or self._errors.held:
            return None
        return self._errors.result(self._simulation).per_second

    def _period(self) -> float | None:
        centres = np.array(self._centres).reshape(-1, 4)
        return period(np.array(self._times), centres[:, :2], centres[:, 2:])


def sag(gravity: Floats, displacements: Floats) -> float | None:
    """Return the largest of (n, 2) displacements along gravity, px; None without gravity."""
    size = float(np.hypot(*gravity))
    if not size:
        return None
    x, y = displacements.T
    return float((x * gravity[0] + y * gravity[1]).max()) / size


def stretch(springs: Floats, rest: Floats) -> float:
    """Return the largest |L - rest length| / rest length of one or more springs.

    Args:
        springs: (..., m, 2) px, from end to end.
        rest: (m) px.
    """
    return float(np.abs(np.hypot(springs[..., 0], springs[..., 1]) / rest - 1.0).max())


def distance(one: Floats, other: Floats) -> float:
    """Return the largest distance between two positions of a mass, px; both are (n, 2)."""
    return float(np.hypot(*(one - other).T).max())


def period(times: Floats, positions: Floats, velocities: Floats) -> float | None:
    """Return the mean period of a point's swings along the line on which it moves most.

    A swing goes from one side of the mean position to the other and back, on both by more than a tenth of the
    largest displacement; smaller ripples do not count. Crossings of the mean are found on cubic splines, so
    that they are much more accurate than the sampling interval.

    Args:
        times: (k,) s.
        positions: (k, 2) px.
        velocities: (k, 2) px/s.

    Returns:
        Seconds; None if there is no whole swing.
    """
    if len(times) < 4:
        return None
    # Here, not above: SciPy takes a second to import.
    from scipy.interpolate import CubicHermiteSpline

    x, y = (positions - positions.mean(0)).T
    # The axis by its angle, and sums without BLAS: the same bits whatever does linear algebra elsewhere.
    angle = 0.5 * math.atan2(2.0 * float((x * y).sum()), float((x * x - y * y).sum()))
    along = math.cos(angle) * x + math.sin(angle) * y
    speed = math.cos(angle) * velocities[:, 0] + math.sin(angle) * velocities[:, 1]
    swing = float(np.abs(along).max())
    if not swing > _STILL * max(1.0, float(np.abs(positions).max())):
        return None
    side = np.where(np.abs(along) > _BAND * swing, np.sign(along), 0.0)
    seen = np.flatnonzero(side)
    turns = [(i, j) for i, j in itertools.pairwise(seen) if side[i] < 0.0 < side[j]]
    if len(turns) < 2:
        return None
    crossings = []
    for i, j in (turns[0], turns[-1]):
        roots = CubicHermiteSpline(times[i : j + 1], along[i : j + 1], speed[i : j + 1]).roots(
            extrapolate=False
        )
        crossings.append(float(roots[-1]))
    found = (crossings[1] - crossings[0]) / (len(turns) - 1)
    return found if math.isfinite(found) else None
