"""Residuals of measurements against runs of a scene, as a function of the unknowns of a fit."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import msgspec
import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, SceneError, SettingError, of_field
from ..motion.quantities import Quantity
from ..motion.simulation import Simulation
from ..scene.types import Scene
from ..scene.validate import validate
from ..settings import SETTINGS
from ..solve.registry import METHODS
from ..text import Text, number, with_unit
from .circles import all_are_angles, other_radius, rods_to_anchors
from .estimates import Estimate, plus_minus
from .matching import Match, matched
from .measurements import Measurement
from .parameters import Parameter, parameter, size_of, start_of, with_start
from .units import within_half_a_turn

Floats = NDArray[np.float64]

MAX_VARIED = 6
"""Largest number of names in `vary`."""
MAX_UNKNOWNS = 40
"""Largest number of unknowns; start and origin count as several each."""
MAX_STEPS = 200_000
"""Largest number of steps of a run."""
OF_MEASUREMENT = {
    "start": "where the measured masses are at the first row, and how fast",
    "origin": "where the scene's zero is in what was measured",
    "length_scale": "how many of the scene's lengths are one of those that were measured",
}
"""Names that `vary` accepts besides the scene's own numbers."""

# Unless noted, doubling or halving one of these numbers fails no test.
_FINE = 1e-8
"""Tolerance of runs as a fraction of the body's size, small so that differences between runs are smooth."""
_FEWEST = 8
"""Smallest number of rows in a fit of the first rows alone."""
_LATEST = 1e6
"""Latest time of a first row, s, that can be reached by a run from the scene's start. Doubled,
`test_a_clock_that_is_far_from_the_start_needs_the_start` fails."""
_HARDLY = 1e-3
"""Movement as a fraction of the body's size below which the scale of a measurement is doubted. At 0,
`test_places_that_hardly_move_and_one_number_for_springs_that_differ_are_doubted` fails."""
_FAILED = 1e3
"""Residual, in units of noise, of a run that ends early."""


class _Table:
    """A measurement and the columns of it that are compared with a run."""

    def __init__(self, measurement: Measurement, matches: tuple[Match, ...], from_first: bool) -> None:
        self.measurement, self.matches = measurement, matches
        self.time = measurement.time - (measurement.time[0] if from_first else 0.0)
        if not from_first and (measurement.is_absolute or self.time[0] > _LATEST):
            raise InputError(
                Text(
                    "{measurement}: its clock begins at {begins:.12g} s, and the scene's start is "
                    "0 s; vary start, and the first row is it",
                    measurement=measurement.name,
                    begins=measurement.time[0],
                )
            )
        if self.time[0] < 0.0:
            raise InputError(
                Text(
                    "{measurement}: the time begins at {begins:g} s, before the scene's start at 0 "
                    "s; vary start, and the first row is it",
                    measurement=measurement.name,
                    begins=self.time[0],
                )
            )
        self.measured = np.array([each.column.values for each in matches])  # (columns, rows)
        self.is_angle = np.array([each.quantity.kind.unit == "°" for each in matches])
        self.quantities = [each.quantity for each in matches]

    def rows(self, part: float) -> int:
        """Return the number of rows in that fraction of the table, at least `_FEWEST` if it has as many."""
        return min(self.time.size, max(_FEWEST, math.ceil(part * self.time.size)))


@dataclass(frozen=True)
class _Unknown:
    """An unknown: a parameter of the scene, or a number of a measurement.

    Attributes:
        parameter: its name, scale and range.
        table: index of the measurement it belongs to; -1 for all of them.
        axis: 0 for x, 1 for y, if it is a coordinate of a measurement's origin or of a mass's start.
        mass: index of the mass whose start it is; -1 for an origin.
        of: 0 for that mass's position, 1 for its velocity.
    """

    parameter: Parameter
    table: int = -1
    axis: int = -1
    mass: int = -1
    of: int = -1


class Problem:
    """Residuals as a function of the unknowns.

    Args:
        scene: a valid scene.
        tables: the measurements.
        vary, match, scale: as in `fit`.

    Raises:
        InputError: a column or a name is invalid, or there are too few values.
    """

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
                Text(
                    "{where}: {count} numbers are too many, {most} is the most; start and origin "
                    "are several each",
                    where="vary",
                    count=len(self.unknowns),
                    most=MAX_UNKNOWNS,
                )
            )
        count = sum(int((~np.isnan(table.measured)).sum()) for table in self.tables)
        if count <= len(self.unknowns):
            name, sought = self.tables[0].measurement.name, len(self.unknowns)
            raise InputError(
                Text(
                    "{name}: {count} numbers are too few to tell {sought} unknown ones",
                    name=name,
                    count=count,
                    sought=sought,
                )
            )
        self.parameters = [each.parameter for each in self.unknowns]

    def _refuse_length(self, scale: float | None, varied: bool) -> None:
        if scale is not None and not (math.isfinite(scale) and scale > 0.0):
            raise InputError(Text("{where}: {scale:g} is not a positive number", where="scale", scale=scale))
        for table in self.tables:
            for each in table.matches:
                if each.scale is None and scale is None and not varied:
                    length = self.scene.view.unit
                    raise InputError(
                        Text(
                            "{file}, column {column!r}: it is in {unit}, but the scene in {length}; say how "
                            "many {length} one {measured} is (scale), or vary length_scale",
                            file=table.measurement.name,
                            column=each.column.name,
                            unit=each.column.unit,
                            length=length,
                            measured=each.unit.length,
                        )
                    )

    def _unknowns(self, scale: float | None) -> list[_Unknown]:
        own = [name for name in self.vary if name not in OF_MEASUREMENT]
        found = [_Unknown(parameter(name, self.scene, self.duration)) for name in own]
        several = len(self.tables) > 1
        if "length_scale" in self.vary:
            lengths = [m for table in self.tables for m in table.matches if m.scale is None or m.unit.power]
            if not lengths:
                raise InputError(Text("{where}: no length was measured", where="vary: length_scale"))
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
        """Estimate the length scale from how far masses move in the scene and in the measurements."""
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
            raise InputError(
                Text(
                    "{where}: {measurement} has no places of masses",
                    where="vary: origin",
                    measurement=table.measurement.name,
                )
            )
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
            raise InputError(
                Text(
                    "{where}: {measurement} has no places of free masses",
                    where="vary: start",
                    measurement=table.measurement.name,
                )
            )
        return found

    # --------------------------------------------------------------------- the scene and its runs
    def scene_at(self, u: Floats, t: int = 0) -> Scene:
        """Return the scene for some unknowns at the start of measurement t.

        Raises:
            SceneError, SettingError: the unknowns give no valid scene.
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
        """Return the number of the scene's length units per measured length unit."""
        for each, value in zip(self.unknowns, u, strict=True):
            if each.parameter.name == "length_scale":
                return each.parameter.value(value)
        return self.scale

    def fitted(self, u: Floats, part: float = 1.0) -> list[Floats | None]:
        """Return a run's values for each measurement, (columns, rows); None where the run ends early."""
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

    # --------------------------------------------------------------------- lengths
    def doubts(self, u: Floats) -> list[str]:
        """Return warnings of likely mistakes: masses that hardly move, one number for parts that differ."""
        found, unit, length = [], self.scene.view.unit, self.length_scale(u)
        for table in self.tables:
            for row, match in zip(table.measured, table.matches, strict=True):
                moved = float(np.nanmax(row) - np.nanmin(row)) * self._size_of(match, length)
                if match.quantity.kind.unit == "{unit}" and 0.0 < moved < _HARDLY * self.size:
                    found.append(
                        Text(
                            "{file}: {column} moves by {moved:.2g} {unit}, in a body of {size:.3g} {unit}; "
                            "is the scale right?",
                            file=table.measurement.name,
                            column=match.column.name,
                            moved=moved,
                            size=self.size,
                            unit=unit,
                        )
                    )
        for name in self.vary:
            if name in SETTINGS and SETTINGS[name].differs(self.scene):
                found.append(
                    Text(
                        "{name} is that of parts which differ: it is the largest, and the others keep their "
                        "ratio to it; a part alone is named as in spring0.stiffness.",
                        name=name,
                    )
                )
        return found

    def lengths_told(self, u: Floats) -> list[str]:
        """Report where measured lengths differ from the scene's, and what the fitted numbers then mean."""
        found = []
        sought = "gravity" in self.vary
        if any(name.endswith("rest_length") or name == "length_scale" for name in self.vary):
            return []
        if sought and all(all_are_angles([q.kind.unit for q in table.quantities]) for table in self.tables):
            lengths: str = ""
            for _, s in rods_to_anchors(self.scene):
                length = Text(
                    "{spring} of {length:.4g} {unit}",
                    spring=f"spring{s}",
                    length=self.scene.linear_springs[s].rest_length,
                    unit=self.scene.view.unit,
                )
                lengths = Text("{one}, {other}", one=lengths, other=length) if lengths else length
            found.append(
                Text(
                    "Angles tell gravity over length, and no length: this gravity belongs to {lengths}.",
                    lengths=lengths,
                )
                if lengths
                else Text(
                    "Angles tell gravity over length, and no length: this gravity belongs to the scene's own "
                    "lengths."
                )
            )
        for t, (table, run) in enumerate(zip(self.tables, self.fitted(u), strict=True)):
            if run is None:
                continue
            for mass, spring in rods_to_anchors(self.scene):
                places = self._places(u, t, mass, table.measured), self._places(u, t, mass, run)
                if places[0] is None or places[1] is None:
                    continue
                radii = other_radius(places[0], places[1])
                if radii is not None:
                    found.append(self._other_length(table, mass, spring, *radii))
        return found

    def _places(self, u: Floats, t: int, mass: int, values: Floats) -> Floats | None:
        """Return a mass's positions (k, 2) from a table, in the scene's unit; None without both x and y."""
        table, length = self.tables[t], self.length_scale(u)
        found = []
        for what in ("x", "y"):
            name = f"mass{mass}.{what}"
            column = next((c for c, each in enumerate(table.matches) if each.quantity.name == name), None)
            if column is None:
                return None
            found.append(values[column] * self._size_of(table.matches[column], length))
        return np.column_stack(found)

    def _other_length(self, table: _Table, mass: int, spring: int, measured: float, run: float) -> str:
        unit = self.scene.view.unit
        each = next(m for m in table.matches if m.quantity.name in (f"mass{mass}.x", f"mass{mass}.y"))
        radius = with_unit(number(measured, ".4g"), unit)
        own = (
            radius
            if each.scale is not None
            else Text(
                "{radius} ({measured:.3g} {unit})",
                radius=radius,
                measured=measured / self.scale / each.unit.factor,
                unit=each.column.unit,
            )
        )
        other = Text(
            "{file}: mass {mass} was measured on a circle with a radius of {measured}, and the scene's is "
            "{run:.4g} {unit}.",
            file=table.measurement.name,
            mass=mass,
            measured=own,
            run=run,
            unit=unit,
        )
        if "gravity" in self.vary:
            stands = Text(
                "The gravity that is found stands for gravity over length: at {radius} it would be "
                "{times:.3g} times as large.",
                radius=radius,
                times=measured / run,
            )
            other = Text("{first} {then}", first=other, then=stands)
        vary = Text(
            "Vary {name}, too, or give it {radius} in the scene.",
            name=f"spring{spring}.rest_length",
            radius=radius,
        )
        return Text("{first} {then}", first=other, then=vary)

    def in_units_of_tables(self, values: Sequence[Estimate], u: Floats) -> list[Estimate]:
        """Add to estimates their values in the measurements' unit of length, where that differs."""
        length = next((m.unit.length for table in self.tables for m in table.matches if m.scale is None), "")
        own, scale = self.scene.view.unit, self.length_scale(u)
        if not length or scale == 1.0:
            return list(values)
        found = []
        for each in values:
            power = _power_of(each.unit, own)
            if power == 0 or not each.known:
                found.append(each)
                continue
            factor = scale**-power
            also = plus_minus(each.value * factor, each.low * factor, each.high * factor)
            unit = re.sub(rf"(?<!\w){re.escape(own)}(?!\w)", length, each.unit)
            found.append(replace(each, also=with_unit(also, unit)))
        return found

    def _size_of(self, match: Match, length: float) -> float:
        """Return the factor from a column's unit to the scene's."""
        known = match.scale if match.scale is not None else length
        varied = "length_scale" in self.vary and match.unit.power
        return match.unit.factor * (length if varied else known) ** match.unit.power

    def residuals(self, u: Floats, noise: Sequence[Floats], part: float = 1.0) -> Floats:
        """Return measured minus fitted values over each column's noise, concatenated without gaps."""
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
        """Wrap residuals of angles, each in its own unit, to within half a turn."""
        factors = np.array(
            [m.unit.factor for m, yes in zip(table.matches, table.is_angle, strict=True) if yes]
        )
        return within_half_a_turn(degrees * factors[:, None]) / factors[:, None]

    # --------------------------------------------------------------------- starting values
    def first(self) -> Floats:
        """Return the starting values of the unknowns, from the scene and the first rows."""
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
        """Set positions and velocities at the start from a parabola through the first rows."""
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


def _power_of(unit: str, length: str) -> int:
    """Return the power of a length in a unit: 1 in "px/s²", 2 in "kg px²/s²" and -1 in "kg/px"."""
    above, _, below = unit.partition("/")
    for part, sign in ((above, 1), (below, -1)):
        for word in re.split(r"[\s·]+", part):
            if word == length:
                return sign
            if word == f"{length}²":
                return 2 * sign
    return 0


def _refuse_names(vary: list[str]) -> None:
    if not 1 <= len(vary) <= MAX_VARIED:
        raise InputError(
            Text(
                "{where}: name from 1 to {most} numbers that are sought, not {count}",
                where="vary",
                most=MAX_VARIED,
                count=len(vary),
            )
        )
    for name in vary:
        if vary.count(name) > 1:
            raise InputError(Text("{where}: {name} is named twice", where="vary", name=name))


class _Runner:
    """Runs scenes accurately enough that differences between runs are smooth.

    Args:
        scene: gives the method of all runs.
        size: the body's size, px.
    """

    def __init__(self, scene: Scene, size: float) -> None:
        self._size = size
        self._adaptive = METHODS[scene.integrator.method].adaptive

    def run(self, scene: Scene, time: Floats, quantities: list[Quantity]) -> Floats | None:
        """Return the quantities at (k,) times, (quantities, k); None if the body diverges before the last, or
        a formula has no value."""
        integrator = scene.integrator
        step = integrator.dt
        if self._adaptive:
            tolerance = max(1e-12, min(integrator.tolerance, _FINE * self._size))
            step = _common_step(time) or min(step, float(np.diff(time).min(initial=step)))
            integrator = msgspec.structs.replace(integrator, tolerance=tolerance, dt=step)
        steps = math.ceil(time[-1] / step - 1e-9)
        if steps > MAX_STEPS:
            late = time[0] > float(np.ptp(time))
            why = Text(
                "{seconds:g} s in steps of {step:g} s are {steps} steps, more than {most}",
                seconds=time[-1],
                step=step,
                steps=steps,
                most=MAX_STEPS,
            )
            if late:
                why = Text(
                    "{error}; the first row is at {begins:g} s: vary start, and it is the start",
                    error=why,
                    begins=time[0],
                )
            raise InputError(of_field("fit", why))
        from scipy.interpolate import CubicSpline

        simulation = Simulation(msgspec.structs.replace(scene, integrator=integrator))
        found = np.empty((len(quantities), steps + 1))
        for k in range(steps + 1):
            if k and simulation.step() < 1:
                return None
            found[:, k] = [each.read(simulation) for each in quantities]
        if not np.isfinite(found).all():
            return None
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
    """Return the step, at most 1 s, of a uniform grid from 0 that has all times; None if there is none."""
    apart = np.diff(time)
    if not apart.size:
        return None
    step = float(np.ptp(time)) / apart.size
    step /= math.ceil(step)
    at = time / step
    return step if step >= 1e-6 and np.abs(at - np.rint(at)).max() < 1e-6 else None
