"""The numbers of a scene with which it moves as something that was measured.

What was measured, d, is compared with d(u) of a run of the scene, where u are the unknowns: logarithms of
what is positive, and others as parts of a typical size. Of all u the one is sought for which the sum of
((d - d(u)) / s)² is least, where s is the noise of each column, which is estimated from what is left. The
derivatives J of the residuals by u are differences of runs.

Residuals that hang together count as fewer: with the correlation r of neighbours, n of them count as
n (1 - r) / (1 + r) (the effective sample size of an autoregressive process of order 1). The singular value
decomposition J = U S Vᵀ then gives for each direction v of u how well it is known: to 1 / s. Directions that
are known to less than a factor of about e are what the data cannot tell.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, cast

import msgspec
import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, SceneError, SettingError
from ..methods.registry import METHODS
from ..motion.quantities import Quantity
from ..motion.simulation import Simulation
from ..scene.types import Scene
from ..scene.validate import validate
from .matching import Match, matched
from .measurements import Measurement, read_measurement
from .parameters import Parameter, parameter, size_of, start_of, with_start

Floats = NDArray[np.float64]

MAX_VARIED = 6
"""Largest number of names in `vary`."""
MAX_UNKNOWNS = 40
"""Largest number of unknowns; start and origin are several each."""
MAX_STEPS = 200_000
"""Largest number of steps of a run."""
OF_MEASUREMENT = {
    "start": "where the measured masses are at the first row, and how fast",
    "origin": "where the scene's zero is in what was measured",
    "length_scale": "how many of the scene's lengths are one of those that were measured",
}
"""What `vary` may name besides the scene's own numbers."""

_CONFIDENCE = 0.95
_FINE = 1e-8
"""Tolerance of runs, as a part of the body's size: differences of runs are to be smooth."""
_STEP = 3e-4
"""Step of u for a difference."""
_UNKNOWN = 0.5
"""Uncertainty of u from which on a direction counts as unknown."""
_RANK = 1e-5
"""Singular value, relative to the largest, below which it is the error of differences."""
_INVOLVED = 0.1
"""Part in an unknown direction from which on a number is named with it."""
_ELSEWHERE = math.log(4.0)
"""How far from the scene's numbers other starts are."""
_STARTS = 32
"""Number of other starts that are looked at."""
_TRIED = 3
"""Number of starts that are followed."""
_WINDOWS = (0.25, 0.5, 1.0)
"""Parts of the rows that are fitted one after another, so that no swing is mistaken for the next."""
_FEWEST = 8
"""Smallest number of rows for that."""
_ROUNDS = 60
"""Largest number of steps towards the least sum of squares."""
_FAILED = 1e3
"""Residual, in units of noise, of a run that ends early."""
_FAR = 0.1
"""Least noise of a column that is assumed at first, as a part of how far off the scene is."""
_NOISELESS = 1e-7
"""Smallest noise of a column, as a part of its range."""


@dataclass(frozen=True)
class Estimate:
    """A number that was fitted.

    Attributes:
        name, unit: what it is.
        value: the best one.
        low, high: the 95 % interval. For one that the data cannot tell they are all that it may be: 0 and
            infinity where it is positive.
        known: whether the data tell it.
        before: what it was in the scene.
    """

    name: str
    unit: str
    value: float
    low: float
    high: float
    known: bool
    before: float

    @property
    def text(self) -> str:
        """As people read it, as in "812 ± 9 kg/s²"."""
        unit = f" {self.unit}" if self.unit else ""
        if not self.known:
            return (
                f"{self.value:.3g}{unit} or any other"
                if math.isinf(self.high)
                else f"at most {self.high:.3g}{unit}"
            )
        return f"{plus_minus(self.value, self.low, self.high)}{unit}"


@dataclass(frozen=True, eq=False)
class Series:
    """A column, and what the fitted scene does instead.

    Attributes:
        file, column, quantity: of what; the quantity is as it was matched, as in "-mass1.y".
        unit: of the column.
        time: (k,) s, as in the file.
        measured, fitted: (k,) NaN where there was nothing measured.
        effective: number of independent residuals that the k hold.
    """

    file: str
    column: str
    quantity: str
    unit: str
    time: Floats
    measured: Floats
    fitted: Floats
    effective: float

    @property
    def residuals(self) -> Floats:
        """(k,) measured minus fitted; angles within half a turn."""
        left = self.measured - self.fitted
        return _wrapped(left) if self.unit == "°" else left

    @property
    def noise(self) -> float:
        """Root mean square of the residuals."""
        return float(np.sqrt(np.nanmean(self.residuals**2)))


@dataclass(frozen=True, eq=False)
class Fit:
    """What `fit` found.

    Attributes:
        scene: the scene with the numbers, and the start, of the best fit.
        values: of each number that was varied, by its name.
        series: of each column, measured and fitted.
        sentences: what else there is to know, in words.
    """

    scene: Scene
    values: Mapping[str, Estimate]
    series: tuple[Series, ...]
    sentences: tuple[str, ...]
    _draw: Callable[[Floats], Scene] = field(repr=False)
    _spread: Floats = field(repr=False)  # (known directions, unknowns) one standard deviation of each

    def draws(self, n: int, seed: int = 0) -> list[Scene]:
        """Scenes whose numbers scatter as the data leave them open; what they cannot tell at all stays.

        Args:
            n: how many, 0..1000.
            seed: of the random numbers.

        Raises:
            InputError: n is out of range.
        """
        if not 0 <= n <= 1000:
            raise InputError(f"draws: {n} is not in the range 0..1000")
        random = np.random.default_rng(seed)
        scatter = random.standard_normal((n, self._spread.shape[0])) @ self._spread
        return [self._draw(by) for by in scatter]


def fit(
    scene: Scene,
    data: Measurement | str | Path | Sequence[Measurement | str | Path],
    vary: Sequence[str],
    match: Mapping[str, str] | None = None,
    scale: float | None = None,
    progress: Callable[[str], object] = lambda _: None,
) -> Fit:
    """The numbers with which a scene moves as what was measured.

    Args:
        scene: a valid scene, to start from.
        data: one or more measurements, or their files; see `parse_measurement`.
        vary: one to six names of what is sought: settings (`sim.set_value`), numbers of parts
            ("spring0.stiffness", "mass1.mass"), what a mass starts with ("mass1.vx"), and `OF_MEASUREMENT`.
            With "start", the first row is the start; without it, time 0 is, and the scene says how it is
            then.
        match: for names of columns, quantities as in "mass1.x", "-mass1.y" or "90 - spring0.direction"; None
            for what the names say, see `matching.guesses`.
        scale: how many of the scene's lengths are one metre, or one of the lengths of a file in a unit that
            is not known in metres; needed where neither unit nor `vary` says it.
        progress: is told in a few words what is being done.

    Returns:
        The fit.

    Raises:
        SceneError: the scene is not valid.
        InputError: a file, a column or a name is not right; there are too few numbers, or the scene cannot
            be run. The sentence names it.
    """
    scene = validate(scene)
    every = [data] if isinstance(data, (Measurement, str, Path)) else list(data)
    tables = [each if isinstance(each, Measurement) else read_measurement(each) for each in every]
    if not tables:
        raise InputError("fit: name at least one file of what was measured")
    problem = _Problem(scene, tables, list(vary), match, scale)
    return _Search(problem, progress).found()


# ------------------------------------------------------------------------- what is compared
class _Table:
    """A measurement, and what of it is compared with a run."""

    def __init__(self, measurement: Measurement, matches: tuple[Match, ...], from_first: bool) -> None:
        self.measurement, self.matches = measurement, matches
        self.time = measurement.time - (measurement.time[0] if from_first else 0.0)
        if self.time[0] < 0.0:
            raise InputError(
                f"{measurement.name}: the time begins at {self.time[0]:g} s, before the scene's start "
                "at 0 s; vary start, and the first row is it"
            )
        self.measured = np.array([each.column.values for each in matches])  # (columns, rows)
        self.is_angle = np.array([each.quantity.kind.unit == "°" for each in matches])
        self.quantities = [each.quantity for each in matches]

    def rows(self, part: float) -> int:
        """How many rows that part of them is, though not too few."""
        return min(self.time.size, max(_FEWEST, math.ceil(part * self.time.size)))


@dataclass(frozen=True)
class _Unknown:
    """An unknown: a parameter, and of what it is if not of the scene.

    Attributes:
        parameter: how it is sought.
        table: of which measurement; -1 for all.
        axis: of an origin; or of the start of a mass, then with the next two.
        mass, of: index, and 0 for its place, 1 for its velocity.
    """

    parameter: Parameter
    table: int = -1
    axis: int = -1
    mass: int = -1
    of: int = -1


class _Problem:
    """Residuals as a function of the unknowns."""

    def __init__(
        self,
        scene: Scene,
        tables: list[Measurement],
        vary: list[str],
        match: Mapping[str, str] | None,
        scale: float | None,
    ) -> None:
        _refuse_names(vary)
        self.scene, self.size, self.vary = scene, size_of(scene), vary
        from_first = "start" in vary
        self.tables = [_Table(each, matched(each, scene, match), from_first) for each in tables]
        self.duration = max(float(np.ptp(table.time)) for table in self.tables) or 1.0
        self._refuse_length(scale, "length_scale" in vary)
        self.runner = _Runner(scene, self.size)
        self.scale = scale or 1.0
        self.unknowns = self._unknowns(scale)
        if len(self.unknowns) > MAX_UNKNOWNS:
            raise InputError(
                f"vary: {len(self.unknowns)} numbers are too many, {MAX_UNKNOWNS} is the most; start and "
                "origin are several each"
            )
        count = sum(int((~np.isnan(table.measured)).sum()) for table in self.tables)
        if count <= len(self.unknowns):
            name, sought = self.tables[0].measurement.name, len(self.unknowns)
            raise InputError(f"{name}: {count} numbers are too few to tell {sought} unknown ones")
        self.parameters = [each.parameter for each in self.unknowns]

    def _refuse_length(self, scale: float | None, varied: bool) -> None:
        if scale is not None and not (math.isfinite(scale) and scale > 0.0):
            raise InputError(f"scale: {scale:g} is not a positive number")
        for table in self.tables:
            for each in table.matches:
                if each.scale is None and scale is None and not varied:
                    length, where = self.scene.view.unit, f"{table.measurement.name}, column"
                    raise InputError(
                        f"{where} {each.column.name!r}: it is in {each.column.unit}, but the scene "
                        f"in {length}; say how many {length} one {each.unit.length} is (scale), or vary "
                        "length_scale"
                    )

    def _unknowns(self, scale: float | None) -> list[_Unknown]:
        own = [name for name in self.vary if name not in OF_MEASUREMENT]
        found = [_Unknown(parameter(name, self.scene, self.duration)) for name in own]
        several = len(self.tables) > 1
        if "length_scale" in self.vary:
            lengths = [m for table in self.tables for m in table.matches if m.scale is None or m.unit.power]
            if not lengths:
                raise InputError("vary: length_scale: no length was measured")
            unit = f"{self.scene.view.unit}/{lengths[0].unit.length}"
            start = scale or self._guessed_scale()
            found.append(_Unknown(Parameter("length_scale", unit, start, start / 1e3, start * 1e3, True)))
        for t, table in enumerate(self.tables):
            suffix = f" of {table.measurement.name}" if several else ""
            if "origin" in self.vary:
                found += self._origins(t, table, suffix)
            if "start" in self.vary:
                found += self._starts(t, table, suffix)
        return found

    def _guessed_scale(self) -> float:
        """From how far masses move in the scene and in what was measured."""
        ratios = []
        for table in self.tables:
            run = self.runner.run(self.scene, table.time, table.quantities)
            for c, each in enumerate(table.matches):
                if each.unit.power == 1 and run is not None:
                    there, here = np.nanstd(table.measured[c]) * each.unit.factor, float(np.std(run[c]))
                    if there > 0.0 and here > 0.0:
                        ratios.append(here / there)
        return float(np.median(ratios)) if ratios else 1.0

    def _origins(self, t: int, table: _Table, suffix: str) -> list[_Unknown]:
        found = []
        for axis, letter in enumerate("xy"):
            places = [m for m in table.matches if m.quantity.name.endswith(f".{letter}")]
            if places:
                typical = (
                    max(float(np.nanmax(np.abs(m.column.values))) * m.unit.factor for m in places) or 1.0
                )
                name = f"origin_{letter}{suffix}"
                made = Parameter(
                    name, places[0].unit.length, 0.0, -1e6 * typical, 1e6 * typical, False, typical
                )
                found.append(_Unknown(made, t, axis))
        if not found:
            raise InputError(f"vary: origin: {table.measurement.name} has no places of masses")
        return found

    def _starts(self, t: int, table: _Table, suffix: str) -> list[_Unknown]:
        held = {anchor.mass for anchor in self.scene.anchors}
        before = start_of(self.scene)
        found = []
        for each in table.matches:
            of, what = each.quantity.kind.of, each.quantity.kind.what
            if of != "mass" or what not in ("x", "y") or each.quantity.index in held:
                continue
            mass, axis = each.quantity.index, "xy".index(what)
            if any((u.mass, u.axis) == (mass, axis) for u in found):
                continue
            for is_velocity, name in enumerate((what, f"v{what}")):
                scale = self.size * (math.tau / self.duration if is_velocity else 1.0)
                start = before[is_velocity][mass][axis]
                unit = self.scene.view.unit + ("/s" if is_velocity else "")
                made = Parameter(
                    f"mass{mass}.{name}{suffix}",
                    unit,
                    start,
                    start - 1e3 * scale,
                    start + 1e3 * scale,
                    False,
                    scale,
                    spread=False,
                )
                found.append(_Unknown(made, t, axis, mass, is_velocity))
        if not found:
            raise InputError(f"vary: start: {table.measurement.name} has no places of free masses")
        return found

    # --------------------------------------------------------------------- what the unknowns say
    def scene_at(self, u: Floats, t: int = 0) -> Scene:
        """The scene of some unknowns as measurement t begins.

        Raises:
            SceneError, SettingError: there is no such scene.
        """
        scene = self.scene
        for each, value in zip(self.unknowns, u, strict=True):
            if each.parameter.write is not None:
                scene = each.parameter.write(scene, each.parameter.value(value))
        starts = {
            (each.mass, each.of, each.axis): each.parameter.value(value)
            for each, value in zip(self.unknowns, u, strict=True)
            if each.mass >= 0 and each.table == t
        }
        return validate(with_start(scene, starts)) if starts else scene

    def length_scale(self, u: Floats) -> float:
        """How many of the scene's lengths are one measured."""
        for each, value in zip(self.unknowns, u, strict=True):
            if each.parameter.name == "length_scale":
                return each.parameter.value(value)
        return self.scale

    def fitted(self, u: Floats, part: float = 1.0) -> list[Floats | None]:
        """(columns, rows) of each measurement what a run of the scene has; None where it ends early."""
        return [self._fitted(u, t, table.rows(part)) for t, table in enumerate(self.tables)]

    def _fitted(self, u: Floats, t: int, rows: int) -> Floats | None:
        table, length = self.tables[t], self.length_scale(u)
        try:
            run = self.runner.run(self.scene_at(u, t), table.time[:rows], table.quantities)
        except (SceneError, SettingError):
            return None
        if run is None:
            return None
        origin = [0.0, 0.0]
        for each, value in zip(self.unknowns, u, strict=True):
            if each.table == t and each.mass < 0:
                origin[each.axis] = each.parameter.value(value)
        for c, each in enumerate(table.matches):
            size = self._size_of(each, length)
            run[c] = (each.offset + each.sign * run[c]) / size
            if each.quantity.kind.of == "mass" and each.quantity.kind.what in ("x", "y"):
                run[c] += origin["xy".index(each.quantity.kind.what)] / each.unit.factor
        return run

    def _size_of(self, match: Match, length: float) -> float:
        """What one of a column's unit is in the scene's."""
        known = match.scale if match.scale is not None else length
        varied = "length_scale" in self.vary and match.unit.power
        return match.unit.factor * (length if varied else known) ** match.unit.power

    def residuals(self, u: Floats, noise: Sequence[Floats], part: float = 1.0) -> Floats:
        """Measured minus fitted over the noise of each column, one after the other without gaps."""
        left = []
        for t, (table, run) in enumerate(zip(self.tables, self.fitted(u, part), strict=True)):
            measured = table.measured[:, : table.rows(part)]
            if run is None:
                each = np.full_like(measured, _FAILED)
            else:
                each = measured - run
                each[table.is_angle] = self._wrapped(each[table.is_angle], table)
                each = np.clip(each / noise[t][:, None], -1e6, 1e6)
            left.append(each[~np.isnan(measured)])
        return np.concatenate(left)

    @staticmethod
    def _wrapped(degrees: Floats, table: _Table) -> Floats:
        """Residuals of angles, each in its own unit, within half a turn."""
        factors = np.array(
            [m.unit.factor for m, yes in zip(table.matches, table.is_angle, strict=True) if yes]
        )
        return _wrapped(degrees * factors[:, None]) / factors[:, None]

    # --------------------------------------------------------------------- where to begin
    def first(self) -> Floats:
        """The unknowns as the scene, and the first rows, say them."""
        u = np.array([p.u(p.start) for p in self.parameters])
        for t, table in enumerate(self.tables):
            self._first_origin(u, t, table)
            self._first_start(u, t, table)
        return u

    def _first_origin(self, u: Floats, t: int, table: _Table) -> None:
        axes = {each.axis: i for i, each in enumerate(self.unknowns) if each.table == t and each.mass < 0}
        run = self._fitted(u, t, table.time.size) if axes else None
        if run is None:
            return
        for letter, axis in (("x", 0), ("y", 1)):
            left = [
                float(np.nanmean(table.measured[c] - run[c])) * m.unit.factor
                for c, m in enumerate(table.matches)
                if m.quantity.kind.of == "mass" and m.quantity.kind.what == letter
            ]
            if left and axis in axes:
                u[axes[axis]] = self.parameters[axes[axis]].u(float(np.mean(left)))

    def _first_start(self, u: Floats, t: int, table: _Table) -> None:
        """Place and velocity of a curve of second order through the first rows."""
        length = self.length_scale(u)
        for i, each in enumerate(self.unknowns):
            if each.table != t or each.mass < 0:
                continue
            name = f"mass{each.mass}.{'xy'[each.axis]}"
            match = next(m for m in table.matches if m.quantity.name == name)
            origin = [
                v.parameter.value(u[k])
                for k, v in enumerate(self.unknowns)
                if v.table == t and v.mass < 0 and v.axis == each.axis
            ]
            values = match.column.values - sum(origin) / match.unit.factor
            there = np.flatnonzero(~np.isnan(values))[:6]
            order = min(2, there.size - 1)
            curve = np.polynomial.Polynomial.fit(table.time[there], values[there], order)
            found = (curve.deriv() if each.of else curve)(0.0)
            size = self._size_of(match, length)
            u[i] = each.parameter.u(match.sign * (float(found) * size - (0.0 if each.of else match.offset)))


def _refuse_names(vary: list[str]) -> None:
    if not 1 <= len(vary) <= MAX_VARIED:
        raise InputError(f"vary: name from 1 to {MAX_VARIED} numbers that are sought, not {len(vary)}")
    for name in vary:
        if vary.count(name) > 1:
            raise InputError(f"vary: {name} is named twice")


class _Runner:
    """Runs scenes finely enough that differences of runs are smooth.

    Args:
        scene: whose method all have.
        size: of the body.
    """

    def __init__(self, scene: Scene, size: float) -> None:
        self._size = size
        self._adaptive = METHODS[scene.integrator.method].adaptive

    def run(self, scene: Scene, time: Floats, quantities: list[Quantity]) -> Floats | None:
        """(quantities, k) at (k,) times; None where the body runs away before the last."""
        integrator = scene.integrator
        step = integrator.dt
        if self._adaptive:
            tolerance = max(1e-12, min(integrator.tolerance, _FINE * self._size))
            step = _common_step(time) or min(step, float(np.diff(time).min(initial=step)))
            integrator = msgspec.structs.replace(integrator, tolerance=tolerance, dt=step)
        steps = math.ceil(time[-1] / step - 1e-9)
        if steps > MAX_STEPS:
            raise InputError(
                f"fit: {time[-1]:g} s in steps of {step:g} s are {steps} steps, more than {MAX_STEPS}"
            )
        from scipy.interpolate import CubicSpline

        simulation = Simulation(msgspec.structs.replace(scene, integrator=integrator))
        found = np.empty((len(quantities), steps + 1))
        for k in range(steps + 1):
            if k and simulation.step() < 1:
                return None
            found[:, k] = [each.read(simulation) for each in quantities]
        at = time / step
        nearest = np.rint(at)
        if np.abs(at - nearest).max() < 1e-6:
            return found[:, nearest.astype(int)]
        for row, each in zip(found, quantities, strict=True):
            if each.kind.unit == "°":
                row[:] = np.unwrap(row, period=360.0)
        if steps < 3:
            return np.array([np.interp(at, np.arange(steps + 1.0), row) for row in found])
        return CubicSpline(np.arange(steps + 1.0), found, axis=1)(at)


def _common_step(time: Floats) -> float | None:
    """The distance of evenly spaced times, where 0 is one of them; at most 1 s."""
    apart = np.diff(time)
    if not apart.size:
        return None
    step = float(np.ptp(time)) / apart.size
    step /= math.ceil(step)
    at = time / step
    return step if step >= 1e-6 and np.abs(at - np.rint(at)).max() < 1e-6 else None


# ------------------------------------------------------------------------- the search
class _Search:
    """Finds the least sum of squares.

    Args:
        problem: of which.
        progress: see `fit`.
    """

    def __init__(self, problem: _Problem, progress: Callable[[str], object]) -> None:
        self._problem, self._progress = problem, progress
        parameters = problem.parameters
        self._low = np.array([p.u(max(p.low, 1e-300)) if p.logarithmic else p.u(p.low) for p in parameters])
        self._high = np.array([p.u(p.high) for p in parameters])
        self._noise = [
            np.array(
                [
                    max(float(np.nanstd(row)), 1e-12 * float(np.nanmax(np.abs(row))), 1e-300)
                    for row in t.measured
                ]
            )
            for t in problem.tables
        ]

    def found(self) -> Fit:
        """The fit."""
        problem = self._problem
        first = np.clip(problem.first(), self._low, self._high)
        for t, run in enumerate(problem.fitted(first)):
            if run is None:
                raise InputError("fit: the scene runs away, as it is, within the time that was measured")
            # A column that hardly changes must not outweigh all others.
            off = np.sqrt(np.nanmean((problem.tables[t].measured - run) ** 2, axis=1))
            self._noise[t] = np.maximum(self._noise[t], _FAR * off)
        best, u = np.inf, first
        for number, start in enumerate(self._starts(first), 1):
            for part in _WINDOWS:
                self._progress(f"start {number}, {part:.0%} of the rows")
                start = self._down(start, part)
            cost = float((problem.residuals(start, self._noise) ** 2).sum())
            if cost < best * (1.0 - 1e-9):
                best, u = cost, start
            if self._is_noise(u):
                break
        several = sum(len(table.matches) for table in problem.tables) > 1
        for _ in range(2 if several else 1):
            self._progress("noise of each column")
            self._noise = self._left_noise(u)
            u = self._down(u, 1.0) if several else u
        self._progress("what the data tell")
        return self._summed_up(u)

    def _starts(self, first: Floats) -> Iterator[Floats]:
        """The scene's own numbers, and then others, those that fit the first rows best first."""
        from scipy.stats import qmc

        yield first
        spread = np.array([p.spread for p in self._problem.parameters])
        if not spread.any():
            return
        points = qmc.Halton(int(spread.sum()), scramble=False).fast_forward(1).random(_STARTS)
        every = []
        for point in points:
            u = first.copy()
            u[spread] += (2.0 * point - 1.0) * [
                _ELSEWHERE if p.logarithmic else 0.3 for p in self._problem.parameters if p.spread
            ]
            every.append(np.clip(u, self._low, self._high))
        self._progress("where to begin")
        costs = [float((self._problem.residuals(u, self._noise, _WINDOWS[0]) ** 2).sum()) for u in every]
        yield from (every[i] for i in np.argsort(costs)[: _TRIED - 1])

    def _down(self, u: Floats, part: float) -> Floats:
        from scipy.optimize import least_squares

        low, high = self._low - 1e-9, self._high + 1e-9
        last: dict[bytes, Floats] = {}

        def residuals(at: Floats) -> Floats:
            """They are asked for once more for the differences."""
            if at.tobytes() not in last:
                last.clear()
                last[at.tobytes()] = self._problem.residuals(at, self._noise, part)
            return last[at.tobytes()]

        def slopes(at: Floats) -> Floats:
            here = residuals(at)
            moved = (self._problem.residuals(at + by, self._noise, part) for by in _STEP * np.eye(at.size))
            return np.column_stack([(each - here) / _STEP for each in moved])

        found = least_squares(
            residuals, np.clip(u, self._low, self._high), cast(Any, slopes),
            bounds=(low, high), x_scale=1.0, xtol=1e-9, ftol=1e-10, gtol=1e-10, max_nfev=_ROUNDS,
        )  # fmt: skip
        return np.clip(found.x, self._low, self._high)

    def _differences(self, u: Floats, residuals: Callable[[Floats], Floats]) -> Floats:
        """(residuals, unknowns) derivatives by central differences."""
        columns = []
        for i in range(u.size):
            ends = []
            for sign in (1.0, -1.0):
                moved = u.copy()
                moved[i] += sign * _STEP
                ends.append(residuals(moved))
            columns.append((ends[0] - ends[1]) / (2.0 * _STEP))
        return np.column_stack(columns)

    def _left(self, u: Floats) -> list[Floats]:
        """(columns, rows) residuals of each measurement, in units of noise, with gaps."""
        flat, found, at = self._problem.residuals(u, self._noise), [], 0
        for table in self._problem.tables:
            there = ~np.isnan(table.measured)
            each = np.full_like(table.measured, np.nan)
            each[there] = flat[at : at + int(there.sum())]
            at += int(there.sum())
            found.append(each)
        return found

    def _is_noise(self, u: Floats) -> bool:
        """Whether nothing is left but noise, so that no other start can do better."""
        every = [row for table in self._left(u) for row in table]
        return all(counted_once(row) == 1.0 for row in every) and all(np.nanstd(row) < 0.5 for row in every)

    def _left_noise(self, u: Floats) -> list[Floats]:
        """The noise of each column, from what is left of it."""
        count = sum(int((~np.isnan(table.measured)).sum()) for table in self._problem.tables)
        share = max(1.0 - u.size / count, 1.0 / count)
        found = []
        for old, left, table in zip(self._noise, self._left(u), self._problem.tables, strict=True):
            root = np.sqrt(np.nanmean(left**2, axis=1) / share) * old
            spread = np.nanmax(table.measured, axis=1) - np.nanmin(table.measured, axis=1)
            found.append(np.maximum(root, np.maximum(_NOISELESS * spread, 1e-300)))
        return found

    # --------------------------------------------------------------------- what it means
    def _summed_up(self, u: Floats) -> Fit:
        from scipy.stats import t as student

        problem = self._problem
        left = self._left(u)
        shares = [np.array([counted_once(row) for row in each]) for each in left]
        noise = [n / np.sqrt(s) for n, s in zip(self._noise, shares, strict=True)]
        residuals = partial(problem.residuals, noise=noise)
        _, singular, directions = np.linalg.svd(self._differences(u, residuals), full_matrices=False)
        counts = [(~np.isnan(table.measured)).sum(axis=1) for table in problem.tables]
        effective = [c * s for c, s in zip(counts, shares, strict=True)]
        freedom = max(1.0, sum(float(each.sum()) for each in effective) - u.size)
        wide = float(student.ppf(0.5 + 0.5 * _CONFIDENCE, freedom))
        known = singular > max(1.0 / _UNKNOWN, _RANK * float(singular.max(initial=0.0)))
        spread = directions[known] / singular[known, None]
        vague = directions[~known] * np.minimum(1.0 / np.maximum(singular[~known], 1e-300), 1.0)[:, None]
        told = _Told(problem, u, spread, directions[~known], vague, wide)
        values = told.values(partial(self._rise, u, residuals))
        runs = problem.fitted(u)
        series = [
            Series(table.measurement.name, m.column.name, m.text, m.column.unit, table.measurement.time,
                   table.measured[c], run[c] if run is not None else np.full(table.time.size, np.nan),
                   float(effective[t][c]))
            for t, (table, run) in enumerate(zip(problem.tables, runs, strict=True))
            for c, m in enumerate(table.matches)
        ]  # fmt: skip
        sentences = [*told.sentences(), *self._at_ends(u), *_hanging_together(series)]
        return Fit(
            problem.scene_at(u), {each.name: each for each in values}, tuple(series), tuple(sentences),
            lambda by: problem.scene_at(np.clip(u + by, self._low, self._high)), spread,
        )  # fmt: skip

    def _rise(self, u: Floats, residuals: Callable[[Floats], Floats], i: int, by: float) -> float:
        """How much the sum of squares grows where one unknown is larger by something."""
        moved = u.copy()
        moved[i] = min(u[i] + by, self._high[i])
        return float((residuals(moved) ** 2).sum() - (residuals(u) ** 2).sum())

    def _at_ends(self, u: Floats) -> list[str]:
        return [
            f"{p.name} has run to {p.value(value):.3g} {p.unit}".rstrip()
            + ", the end of the range in which it is sought."
            for p, value, low, high in zip(self._problem.parameters, u, self._low, self._high, strict=True)
            if p.write is not None and (value <= low + 1e-6 or value >= high - 1e-6)
        ]


def counted_once(residuals: Floats) -> float:
    """What part of some residuals is independent, by the correlation of neighbours; 1 where that is not more
    than chance.

    Args:
        residuals: (k,) evenly spaced; NaN for gaps.
    """
    both = ~np.isnan(residuals[1:]) & ~np.isnan(residuals[:-1])
    count, square = int(both.sum()), float(np.nanmean(residuals**2)) if residuals.size else 0.0
    if count < 4 or square == 0.0:
        return 1.0
    r = float((residuals[1:] * residuals[:-1])[both].mean()) / square
    if r < 2.0 / math.sqrt(count):
        return 1.0
    r = min(r, 0.999)
    return (1.0 - r) / (1.0 + r)


class _Told:
    """What the data tell of the unknowns.

    Args:
        problem: of which.
        u: the best.
        spread: (known directions, unknowns) one standard deviation of each.
        unknown: (directions, unknowns) of which they tell nothing.
        vague: the same, by how much each leaves the others open.
        wide: standard deviations of an interval.
    """

    def __init__(
        self, problem: _Problem, u: Floats, spread: Floats, unknown: Floats, vague: Floats, wide: float
    ) -> None:
        self._parameters, self._u, self._spread, self._wide = problem.parameters, u, spread, wide
        self._unknown, self._vague = unknown, vague
        self._involved = np.flatnonzero((np.abs(unknown) > _INVOLVED).any(axis=0))

    def values(self, rise: Callable[[int, float], float]) -> list[Estimate]:
        """Of each unknown."""
        deviations = np.sqrt((self._spread**2).sum(axis=0) + (self._vague**2).sum(axis=0))
        found = []
        for i, (p, u) in enumerate(zip(self._parameters, self._u, strict=True)):
            value, by = p.value(u), self._wide * float(deviations[i])
            if i in self._involved:
                low, high = (0.0, math.inf) if p.logarithmic else (-math.inf, math.inf)
                if p.logarithmic and self._is_alone(i):
                    high = self._at_most(p, u, partial(rise, i))
                found.append(Estimate(p.name, p.unit, value, low, high, False, p.start))
            else:
                ends = (
                    (math.exp(u - by), math.exp(u + by))
                    if p.logarithmic
                    else (value - by * p.scale, value + by * p.scale)
                )
                found.append(Estimate(p.name, p.unit, value, *ends, True, p.start))
        return found

    def _is_alone(self, i: int) -> bool:
        """Whether an unknown is not known by itself, whatever the others are."""
        share = self._unknown[:, i]
        return bool((share**2).sum() > 0.98)

    def _at_most(self, p: Parameter, u: float, rise: Callable[[float], float]) -> float:
        """The value from which on the data would tell."""
        low, high = 0.0, 0.5
        while rise(high) < self._wide**2:
            low, high = high, 2.0 * high
            if high > 10.0:
                return math.inf
        for _ in range(6):
            middle = 0.5 * (low + high)
            low, high = (low, middle) if rise(middle) >= self._wide**2 else (middle, high)
        return p.value(u + high)

    def sentences(self) -> list[str]:
        """What the data cannot tell."""
        said, left = [], []
        for i in self._involved.tolist():
            if self._is_alone(i):
                said.append(f"The data hardly tell {self._parameters[i].name}.")
            else:
                left.append(i)
        rest = self._unknown[:, left]
        rest = rest[np.sqrt((rest**2).sum(axis=1)) > 0.5] if left else rest[:0]
        return said + (self._apart(rest, left) if rest.shape[0] else [])

    def _apart(self, unknown: Floats, which: list[int]) -> list[str]:
        """For unknowns of which only combinations are known."""
        names = _listed([self._parameters[i].name for i in which])
        sentence = f"The data cannot tell {names} apart"
        logarithmic = all(self._parameters[i].logarithmic for i in which)
        masses = [c for c, i in enumerate(which) if self._parameters[i].unit == "kg"]
        reduced, pivots = _reduced(unknown, masses)
        others = [c for c in range(len(which)) if c not in pivots]
        if not logarithmic or not others:
            return [f"{sentence}."]
        known = []
        for c in others:
            weights = np.zeros(self._u.size)
            weights[which[c]] = 1.0
            for row, pivot in enumerate(pivots):
                weights[which[pivot]] -= _rounded(float(reduced[row, c]))
            known.append(self._combination(weights))
        return [f"{sentence}: of them only {_listed(known)} {'are' if len(known) > 1 else 'is'} known."]

    def _combination(self, weights: Floats) -> str:
        """A product of powers, as in "k / m = 812 ± 9"."""
        value = float(weights @ self._u)
        by = self._wide * float(np.sqrt(((self._spread @ weights) ** 2).sum()))
        terms = {sign: [
            self._parameters[i].name + (f"^{abs(w):.3g}" if abs(abs(w) - 1.0) > 1e-9 else "")
            for i, w in enumerate(weights) if sign * w > 0.0
        ] for sign in (1, -1)}  # fmt: skip
        text = " ".join(terms[1]) + "".join(f" / {name}" for name in terms[-1])
        return f"{text} = {plus_minus(*(math.exp(each) for each in (value, value - by, value + by)))}"


def _reduced(rows: Floats, wanted: Collection[int]) -> tuple[Floats, list[int]]:
    """The reduced echelon form of some rows, and its pivots: those wanted, or as far to the right as they can
    be."""
    rows, pivots = rows.copy(), []
    for row in range(rows.shape[0]):
        size = np.abs(rows[row:]).max(axis=0)
        pivot = max(
            (c for c in range(rows.shape[1]) if c not in pivots and size[c] > 0.3 * size.max()),
            key=lambda c: (c in wanted, c),
        )
        best = row + int(np.argmax(np.abs(rows[row:, pivot])))
        rows[[row, best]] = rows[[best, row]]
        rows[row] /= rows[row, pivot]
        for other in range(rows.shape[0]):
            if other != row:
                rows[other] -= rows[other, pivot] * rows[row]
        pivots.append(pivot)
    return rows, pivots


def _rounded(power: float) -> float:
    """A power, as a half of a whole number where it is nearly one."""
    half = round(2.0 * power) / 2.0
    return half if abs(power - half) < 0.1 else power


def _hanging_together(series: Sequence[Series]) -> list[str]:
    found = []
    for each in series:
        count = int((~np.isnan(each.measured)).sum())
        if each.effective < 0.5 * count:
            found.append(
                f"What is left of {each.column} ({each.file}) is no mere noise: its {count} numbers count as "
                f"{max(1, round(each.effective))}, and the intervals are as much wider. The scene may lack "
                "something."
            )
    return found


def _listed(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def plus_minus(value: float, low: float, high: float) -> str:
    """A number with its interval, as in "812 ± 9", to two digits of the latter; with both ends where they are
    not alike."""
    by = 0.5 * (high - low)
    if not (math.isfinite(by) and by > 0.0):
        return f"{value:.4g}"
    if abs(high - value - by) > 0.1 * by:
        return f"{value:.3g} ({low:.3g} to {high:.3g})"
    digits = 1 - math.floor(math.log10(by))
    if abs(value) < 1e6 and digits <= 6:
        return f"{value:.{max(digits, 0)}f} ± {by:.{max(digits, 0)}f}"
    return f"{value:.6g} ± {by:.2g}"


def _wrapped(degrees: Floats) -> Floats:
    return (degrees + 180.0) % 360.0 - 180.0
