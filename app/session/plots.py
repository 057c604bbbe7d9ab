"""Plots of a page: their quantities, and their values of up to some hours.

A plot follows the history of its session. Values after the moment that is shown stay until others replace
them.
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Sequence
from typing import Annotated, NamedTuple

import msgspec
import numpy as np
from msgspec import Meta
from numpy.typing import NDArray

import sim
from sim.errors import InputError
from sim.motion.formulas import MAX_LENGTH
from sim.motion.quantities import PARTS, Kind
from sim.motion.recording import table_text

from ..words import joined, say
from .samples import Samples
from .session import Session

Floats = NDArray[np.float64]

MAX_PLOTS = 4
"""Plots of a page, at most: their curves are sent ten times a second."""

MAX_SERIES = 5
"""Quantities of a plot, at most: as many colours can be told apart."""

MAX_UNITS = 2
"""Units of the quantities of a plot, at most: there is an axis on either side."""

AHEAD = 0.5
"""Part of a plot's time, at most, that is after the moment shown."""

FINE = 4
"""Factor by which a plot over another quantity has more pieces, since its curve goes to and fro."""

STEPS = 2.0**14
"""Different heights on a plot: many times its pixels, and good for four digits. Numbers rounded to these are
compressed to fewer bytes."""

MIN_PART = 1e-6
"""Range of an axis, at least, as a part of the largest value on it: the rounding noise of a body at rest is
less. A plot of noise alone would have more marks than a page can draw, all with the same digits."""

MIN_LENGTH = 1.0 / 60_000.0
"""The same for lengths, as a part of the scene's frame: a hundredth of a pixel if that is 600 px high."""

Span = float | tuple[float, float]
"""Time that is shown: so many seconds up to the moment that is shown, or from one time to another, s."""

Name = Annotated[str, Meta(max_length=MAX_LENGTH)]


class PlotSpec(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The quantities of a plot; its fields are stored by browsers.

    Attributes:
        names: of its quantities, see `find`.
        over: name of the quantity on the horizontal axis; empty for the time.
    """

    names: Annotated[tuple[Name, ...], Meta(min_length=1, max_length=MAX_SERIES)]
    over: Name = ""


def parse_plot(text: str) -> PlotSpec:
    """Read the name of a plot: "joint0.angle", "mass1.x, mass3.x", "joint0.rate over joint0.angle".

    A comma in brackets separates values or masses of one quantity.
    """
    names, _, over = text.partition(" over ")
    found, depth = [""], 0
    for sign in names:
        depth += (sign in "([") - (sign in ")]")
        if sign == "," and depth == 0:
            found.append("")
        else:
            found[-1] += sign
    return PlotSpec(tuple(name.strip() for name in found), over.strip())


def plot_text(spec: PlotSpec) -> str:
    """The name of a plot, as `parse_plot` reads it."""
    return ", ".join(spec.names) + (f" over {spec.over}" if spec.over else "")


_GHOST = Kind(
    "ghost",
    "distance",
    "{unit}",
    "largest distance of a mass of the ghost from the body's",
    lambda simulation, _: np.full(1, np.nan),  # a simulation knows of no ghost
)

OFFERED: dict[str, tuple[str, ...]] = {**PARTS, "ghost": ("distance",)}
"""What can be plotted of each kind of part."""


def find(name: str, scene: sim.Scene) -> sim.Quantity:
    """The quantity of a name: one of `sim.quantity`, or "ghost.distance".

    Raises:
        InputError: there is no such quantity, or the scene has no such part.
    """
    if name == "ghost.distance":
        return sim.Quantity(name, scene.view.unit, _GHOST)
    return sim.quantity(name, scene)


class Plot:
    """A plot: its quantities, and their values, a row for each frame in which time passed; see `Samples`.

    Args:
        spec: names its quantities.
        scene: has them.
        in_words: whether its quantities are called by words, as in lessons, instead of by their names.

    Attributes:
        spec, in_words: as above.
        quantities: those of the spec, then the one on the horizontal axis, if that is not the time.
        shown: the time that the page shows, s.
        version: counts changes of what is drawn.
        run: of the history that it follows, see `History.runs`.

    Raises:
        InputError: there is no such quantity or part, or there are too many quantities or units.
    """

    def __init__(self, spec: PlotSpec, scene: sim.Scene, in_words: bool = False) -> None:
        self.in_words = in_words
        names = tuple(dict.fromkeys(spec.names))
        if len(names) > MAX_SERIES:
            raise InputError(say("session-plot-many", count=MAX_SERIES))
        self.quantities = tuple(find(name, scene) for name in (*names, *((spec.over,) if spec.over else ())))
        self.spec = PlotSpec(tuple(q.name for q in self.quantities[: len(names)]), spec.over)
        if len(self.units) > MAX_UNITS:
            raise InputError(say("session-plot-units", units=joined(self.units)))
        self._y_down = scene.view.y_down
        left, top, right, bottom = scene.view.frame
        self._least_length = scene.view.unit, MIN_LENGTH * max(right - left, bottom - top)
        self._samples = Samples(len(self.quantities))
        self.run = 0
        self.shown = 0.0
        self.version = 0

    @property
    def units(self) -> tuple[str, ...]:
        """The units on the vertical axes, each once."""
        return tuple(dict.fromkeys(q.unit for q in self.quantities[: len(self.spec.names)]))

    @property
    def turned(self) -> tuple[bool, ...]:
        """For each of `units`, whether the values on its axis grow downwards.

        They do for y coordinates and components in a scene whose y grows downwards, so that a curve goes down
        as its mass does.
        """
        quantities = self.quantities[: len(self.spec.names)]
        vertical = {q.unit for q in quantities if q.kind.vertical} if self._y_down else set[str]()
        return tuple(unit in vertical for unit in self.units)

    @property
    def rows(self) -> Floats:
        """(k, 1 + quantities) times, s, and values; NaN for those that did not exist."""
        return self._samples.rows

    @property
    def complete_since(self) -> float:
        """Time, s, from which on there is a row for each frame."""
        return self._samples.complete_since

    @property
    def wants_energy(self) -> bool:
        """Whether any quantity is an entry of the energy balance."""
        return any(q.is_of("energy") for q in self.quantities)

    def sample(self, session: Session) -> None:
        """Add the present values, if they are of a later time than all before; drop an abandoned future."""
        history, time, samples = session.history, session.simulation.time, self._samples
        before = samples.last
        newest = before[0] if before is not None else None
        if history.runs != self.run:
            self.run = history.runs
            samples.clear()
        samples.drop_after(history.end)
        last = samples.last
        if last is None or time > last[0]:
            known = last[1:] if last is not None else np.full(len(self.quantities), np.nan)
            each = zip(self.quantities, known.tolist(), strict=True)
            self.append((time, *(_value(session, q, value) for q, value in each)))
        elif time == last[0]:
            self._update_stability(session, last[1:])
        if time != newest or time != self.shown:
            self.version += 1
        self.shown = time

    def _update_stability(self, session: Session, last: Floats) -> None:
        """Update the stability limit, which may be found while the clock is stopped."""
        for i, quantity in enumerate(self.quantities):
            if quantity.is_of("stability") and (value := _value(session, quantity)) != last[i]:
                last[i] = value
                self.version += 1

    def take_over(self, other: Plot) -> None:
        """Copy another plot's values of the same quantities."""
        self._samples = other._samples.with_columns(
            [other.quantities.index(q) if q in other.quantities else None for q in self.quantities]
        )
        self.run = other.run

    def append(self, row: Sequence[float]) -> None:
        """Add a row, of a later time than all before."""
        self._samples.append(row)

    def window(self, span: Span) -> Floats:
        """(k, 1 + quantities) rows of a span of time, up to the moment shown."""
        rows, past = self._between(*span) if isinstance(span, tuple) else self._until(span, self.shown)
        return rows[:past]

    def view(self, span: Span) -> tuple[Floats, int]:
        """(k, 1 + quantities) rows of a span of time, and how many of them are not after the moment shown.

        The last seconds end with the newest row, but at most `AHEAD` of them after the moment shown.
        """
        if isinstance(span, tuple):
            return self._between(*span)
        newest = self.newest
        return self._until(span, max(min(newest, self.shown + AHEAD * span), self.shown))

    @property
    def newest(self) -> float:
        """Time of the newest row, s; the moment shown if there is none."""
        last = self._samples.last
        return float(last[0]) if last is not None else self.shown

    def _until(self, seconds: float, end: float) -> tuple[Floats, int]:
        """The rows of the seconds before a time, see `view`."""
        rows = self.rows
        first, now, last = np.searchsorted(
            rows[:, 0], (end - seconds, self.shown, end), side="right"
        ).tolist()
        return rows[first:last], now - first

    def _between(self, start: float, end: float) -> tuple[Floats, int]:
        """The rows from one time to another, see `view`."""
        rows = self.rows
        first = int(np.searchsorted(rows[:, 0], start))
        now, last = np.searchsorted(rows[:, 0], (self.shown, end), side="right").tolist()
        return rows[first:last], min(max(now - first, 0), max(last - first, 0))

    def level(self, values: Floats) -> Floats:
        """(1 + quantities, k) values to draw, times first: those on one axis that hardly differ become equal.

        See `MIN_PART` and `MIN_LENGTH`.
        """
        values, count = values.copy(), len(self.spec.names)
        units = [q.unit for q in self.quantities[:count]]
        axes = [[i for i, unit in enumerate(units, start=1) if unit == one] for one in dict.fromkeys(units)]
        for rows in (*axes, *([[1 + count]] if self.spec.over else [])):
            shown = values[rows]
            finite = np.isfinite(shown)
            some = shown[finite]
            if not some.size:
                continue
            unit, least = self._least_length
            least = least if self.quantities[rows[0] - 1].unit == unit else 0.0
            if float(np.ptp(some)) < max(MIN_PART * float(np.abs(some).max()), least):
                shown[finite] = some[-1]
                values[rows] = shown
        return values

    def table(self, decimal_comma: bool = False) -> str:
        """All rows as CSV, see `sim.Recording.to_csv`; with a column `frames` if some are thinned.

        It says for how many frames a row stands. Rows that stand for several have the extremes of these.
        """
        samples = self._samples
        frames: list[int] = samples.frames.tolist() if samples.is_thinned else []
        return table_text(self.quantities, samples.rows, decimal_comma, frames)


class PlotWindow(NamedTuple):
    """The curves that a page is sent.

    Attributes:
        values: (1 + quantities, k) times, s, and values.
        past: number of the k that are not after the moment shown.
    """

    values: Floats
    past: int


def curve(plot: Plot, span: Span, width: int) -> PlotWindow:
    """The curves of a plot, thinned and rounded to what can be seen.

    Args:
        plot: the plot.
        span: of its time.
        width: pieces of the span; of half of it, a quarter and so on, if there are no values in the rest. Of
            each piece, the moments of each quantity's highest and lowest values remain; over another
            quantity than the time, the first moment of each of `FINE` times as many.
    """
    rows, past = plot.view(span)
    pieces = FINE * width if plot.spec.over else width
    if len(rows) > (pieces if plot.spec.over else 2 * pieces):
        seconds = span[1] - span[0] if isinstance(span, tuple) else span
        extent = float(rows[-1, 0] - rows[0, 0])
        while 2.0 * extent <= seconds:
            seconds *= 0.5
        # The pieces have fixed times; otherwise the curve would flicker as it moves on.
        piece = np.floor(rows[:, 0] * (pieces / seconds)).astype(np.int64)
        starts = np.flatnonzero(np.diff(piece, prepend=piece[0] - 1))
        keep = {0, max(past - 1, 0), len(rows) - 1}
        if plot.spec.over:
            keep.update(starts.tolist())
        for column in () if plot.spec.over else rows.T[1:]:
            for sign in (1.0, -1.0):
                height = np.where(np.isnan(column), -np.inf, sign * column)
                most = np.maximum.reduceat(height, starts)
                where = np.flatnonzero(height == np.repeat(most, np.diff(starts, append=len(rows))))
                keep.update(where[np.unique(piece[where], return_index=True)[1]].tolist())
        kept = sorted(keep)
        rows, past = rows[kept], bisect_left(kept, past)
    values = np.array([_rounded(column) for column in rows.T]).reshape(rows.shape[::-1])
    return PlotWindow(plot.level(values), past)


def _rounded(values: Floats) -> Floats:
    """Values rounded to a multiple of a power of two, `STEPS` of which cover their range."""
    finite = values[np.isfinite(values)]
    reach = float(np.ptp(finite)) if finite.size else 0.0
    if not reach > 0.0:
        return values
    step = 2.0 ** math.floor(math.log2(reach / STEPS))
    return np.rint(values / step) * step


def _value(session: Session, quantity: sim.Quantity, before: float = math.nan) -> float:
    """The present value of a quantity; NaN if there is none. An angle continues from the one before."""
    value = quantity.value([_measured(session, each) for each in quantity.measured], before)
    return value if math.isfinite(value) else math.nan


def _measured(session: Session, quantity: sim.Quantity) -> float:
    """The present value of a quantity that is no formula."""
    simulation, of = session.simulation, quantity.kind.of
    if of == "ghost":
        ghost = session.ghost
        return math.nan if ghost is None or ghost.is_compiling else ghost.distance
    if of == "stability":
        return simulation.dt / session.stability.limit  # as last estimated
    if of == "energy" and not simulation.track_energy(True):
        return math.nan  # its kernels are being compiled
    return quantity.read(simulation)
