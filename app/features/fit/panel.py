"""Fitting the scene to a table of what was measured: the top of the Measure tab, once a table is opened."""

from __future__ import annotations

import html
import math
import threading
from functools import partial

import numpy as np
import viser

import sim
from sim.compiling.compiler import is_ready, needed_by
from sim.design.estimates import Estimate
from sim.design.fit import Fit
from sim.design.matching import Match, guesses, matched
from sim.design.measurements import Measurement
from sim.design.residuals import MAX_VARIED
from sim.edit.edit import Edit
from sim.errors import InputError, SceneError, SettingError
from sim.motion.formulas import MAX_LENGTH
from sim.settings import settings_of

from ...background import BackgroundWorker, YieldGil
from ...session import commands
from ...ui import readouts
from ...ui.page import Page
from ...ui.viser.handlers import on_change, on_press
from ...words import decimal, say
from ...words.english import of
from ...words.keys import Key
from ...words.settings import label_of
from ..measure.messages import ShowMeasures
from .messages import Fan, Measured
from .places import places_of

LINK = '<a href="video" target="_blank" rel="noopener">{}</a>'
"""The address is relative: a proxy may serve the page under a prefix."""
FIRST = -10.0
"""Order of the first control: before all others of the tab, which was opened for it."""

LAST = 5e5
"""Order of the line about tables: below the plots and what they are chosen with."""

MAX_COLUMNS = 8
"""Columns that a page can match; the command `softrod fit` takes more."""

MAX_MASSES = 60
"""Masses of a body that a page fits: a fit shares the interpreter with the pages."""

MAX_NUMBERS = 4000
"""Numbers of a table that a page fits, for the same reason."""

MAX_POINTS = 2000
"""Places that are drawn."""

DRAWS = 8
"""Bodies of a fan."""

FAN_RATE = 30.0
"""Frames per second of a fan."""

MAX_FAN_NUMBERS = 60_000
"""Numbers of all frames of a fan."""

_NOT_SOUGHT = ("dt", "tolerance", "template")

NONE = np.zeros(0, np.float32)

_worker = BackgroundWorker()


class _Stopped(Exception):
    """The fit is no longer wanted."""


class FitPanel:
    """The controls; before a table is opened there is only a line about tables.

    Args:
        page: whose body is fitted.
        tab: where they stand.
    """

    def __init__(self, page: Page, tab: viser.GuiTabHandle) -> None:
        self._page, self._session, self._tab = page, page.session, tab
        self._table: Measurement | None = None
        self._found: Fit | None = None
        self._which: viser.GuiDropdownHandle[str] | None = None
        self._columns: dict[str, viser.GuiTextHandle] = {}
        self._switches: dict[str, viser.GuiCheckboxHandle] = {}
        self._busy = threading.Lock()
        self._scene: sim.Scene | None = None
        with tab:
            link = LINK.format(say("fit-about.link"))
            page.client.gui.add_html(_text(say("fit-about", link=link)), order=LAST)

    # --------------------------------------------------------------------- the ticker's
    def take(self, tables: tuple[Measurement, ...], chosen: int = 0) -> None:
        """Offer to fit the scene to a run of a table, instead of the one before."""
        self.forget()
        table = tables[chosen]
        self._table, self._scene = table, self._session.scene
        self._page.mail.send(ShowMeasures())
        gui = self._page.client.gui
        with self._tab:
            if len(tables) > 1:
                self._which = self._choice(tables, chosen)
            about = say("fit-table", name=html.escape(table.name), count=table.time.size)
            about += "".join(f"<p>{html.escape(of(remark))}</p>" for remark in table.remarks)
            self._about = gui.add_html(_text(about), order=FIRST)
            texts = guesses(table, self._scene)
            for i, column in enumerate(table.columns[:MAX_COLUMNS]):
                self._columns[column.name] = gui.add_text(
                    _short(column.label),
                    initial_value=texts[column.name],
                    hint=say("fit-column"),
                    order=FIRST + 1 + 0.1 * i,
                )
            self._scale = gui.add_text(
                say("fit-scale", unit=self._scene.view.unit),
                initial_value="",
                hint=say("fit-scale.hint"),
                order=FIRST + 2,
            )
            usual = _OF_JOINTS if self._scene.angular_springs else _OF_SPRINGS
            self._sought = gui.add_html(_text(say("fit-sought")), order=FIRST + 3)
            for i, (name, label) in enumerate(self._offered().items()):
                self._switches[name] = gui.add_checkbox(
                    label, initial_value=name in usual, order=FIRST + 4 + 0.01 * i
                )
            self._fit = gui.add_button(say("fit-fit"), icon=viser.Icon.CHART_DOTS, order=FIRST + 5)
            self._forget = self._page.button(
                say("fit-forget"), viser.Icon.X, lambda: self._page.later(self.forget), order=FIRST + 6
            )
            self._result = gui.add_html("", order=FIRST + 7)
        for control in (*self._columns.values(), self._scale, self._switches["start"]):
            on_change(control, lambda: self._page.later(self._show_points))
        on_press(self._fit, lambda: self._page.later(self._begin))
        self._show_points()

    def _choice(self, tables: tuple[Measurement, ...], chosen: int) -> viser.GuiDropdownHandle[str]:
        """Which run of several in one file is fitted."""
        names = tuple(table.name.rpartition(", ")[2] for table in tables)
        run = self._page.client.gui.add_dropdown(
            say("fit-run"), names, initial_value=names[chosen], order=FIRST - 1
        )
        on_change(run, lambda: self._page.later(lambda: self.take(tables, names.index(run.value))))
        return run

    def forget(self) -> None:
        """Take the table and all that belongs to it out of the page."""
        if self._table is None:
            return
        self._table = self._found = self._scene = None
        for control in (
            *([] if self._which is None else [self._which]),
            self._about,
            *self._columns.values(),
            self._scale,
            self._sought,
            *self._switches.values(),
            self._fit,
            self._forget,
            self._result,
        ):
            control.remove()
        self._which = None
        self._columns.clear()
        self._switches.clear()
        self._page.mail.send(Measured(numbers=NONE))
        self._page.mail.send(Fan(numbers=NONE))

    def build(self) -> None:
        """Forget the table if the scene has another body."""
        scene = self._scene
        if scene is not None and len(scene.masses) != len(self._session.scene.masses):
            self.forget()

    # --------------------------------------------------------------------- what is offered
    def _offered(self) -> dict[str, str]:
        """Return what can be fitted, with labels: settings but integers, and properties of the table."""
        settings = {
            setting.key: label_of(setting)
            for setting in settings_of(self._session.scene)
            if not setting.integer and setting.key not in _NOT_SOUGHT
        }
        return {**settings, **{name: say(key) for name, key in _OF_TABLE.items()}}

    def _match(self) -> tuple[Match, ...]:
        """Return the quantities of the columns as the controls have them.

        Raises:
            InputError: one of them is wrong.
        """
        table, scene = self._table, self._session.scene
        if table is None:
            raise InputError(say("fit-no-table"))
        return matched(table, scene, {name: box.value[:MAX_LENGTH] for name, box in self._columns.items()})

    def _given_scale(self) -> float | None:
        """Return the scale that was typed; None if it is none."""
        try:
            scale = float(self._scale.value[:100].replace(",", "."))
        except ValueError:
            return None
        return scale if 1e-6 <= scale <= 1e9 else None

    def _needs_scale(self, matches: tuple[Match, ...]) -> bool:
        return any(each.scale is None for each in matches) and not self._switches["length_scale"].value

    def _show_points(self) -> None:
        """Draw the places of masses as they are matched now; after a fit with its scale and origin."""
        table = self._table
        if table is None:
            return
        try:
            matches = self._match()
        except InputError:
            matches = ()
        self._scale.visible = any(each.scale is None for each in matches)
        numbers = NONE
        if matches:
            values = self._found.values if self._found is not None else {}
            scale = _value(values.get("length_scale"), self._given_scale() or math.nan)
            origin = tuple(_value(values.get(f"origin_{axis}"), 0.0) for axis in "xy")
            rows, places = places_of(matches, self._session.scene, scale, (origin[0], origin[1]))
            some = np.linspace(0, rows.size - 1, min(rows.size, MAX_POINTS)).astype(int)
            begin = table.time[0] if self._switches["start"].value or table.is_absolute else 0.0
            both = np.column_stack((table.time[rows[some]] - begin, places[some]))
            both = both[(np.abs(both) < 1e7).all(axis=1)]  # and no NaN, where there is no scale yet
            numbers = both.astype(np.float32).ravel()
        self._page.mail.send(Measured(numbers=numbers))

    # --------------------------------------------------------------------- the fit
    def _begin(self) -> None:
        """Fit the scene in the thread, unless it is busy for this page."""
        table = self._table
        vary = [name for name, switch in self._switches.items() if switch.value]
        if table is None or not self._busy.acquire(blocking=False):
            return
        try:
            matches = self._match()
            self._refuse(matches, vary)
        except InputError as error:
            self._busy.release()
            self._say(error)
            return
        texts = {each.column.name: each.text for each in matches}
        scale = self._given_scale() if self._needs_scale(matches) else None
        self._fit.disabled = True
        self._result.content = _text(say("fit-begins"))
        self._page.mail.send(Fan(numbers=NONE))
        scene = self._session.simulation.capture().scene
        _worker.submit(partial(self._run, table, scene, vary, texts, scale))

    def _refuse(self, matches: tuple[Match, ...], vary: list[str]) -> None:
        scene, numbers = self._session.scene, sum(each.column.values.size for each in matches)
        if len(scene.masses) > MAX_MASSES:
            raise InputError(say("fit-many-masses", count=MAX_MASSES))
        if numbers > MAX_NUMBERS:
            raise InputError(say("fit-many-numbers", count=str(MAX_NUMBERS)))
        if self._needs_scale(matches) and self._given_scale() is None:
            raise InputError(say("fit-no-scale", unit=scene.view.unit))
        if not 1 <= len(vary) <= MAX_VARIED:
            raise InputError(say("fit-choose", most=MAX_VARIED, count=len(vary)))
        if not is_ready(needed_by(scene.integrator.method, self._session.simulation.tables[0].body)):
            raise InputError(say("fit-compiling"))

    def _run(
        self,
        table: Measurement,
        scene: sim.Scene,
        vary: list[str],
        match: dict[str, str],
        scale: float | None,
    ) -> None:
        yield_gil = YieldGil()

        def progress(what: str) -> None:
            if self._table is not table:
                raise _Stopped
            self._page.later(partial(self._tell, table, say("fit-goes-on", what=what)))
            yield_gil.pause()

        try:
            found = sim.fit(scene, table, vary, match, scale, progress)
            begin = float(table.time[0]) if "start" in vary else 0.0
            seen = fan(found, float(table.time[-1]) - begin, yield_gil)
            self._page.later(partial(self._take_found, table, scene, found, seen))
        except (InputError, SceneError, SettingError) as error:
            self._page.later(partial(self._say, error))
        except _Stopped:
            pass
        except Exception:
            self._page.later(partial(self._tell, table, say("fit-error")))
            raise
        finally:
            self._busy.release()
            self._page.later(self._ready)

    def _ready(self) -> None:
        if self._table is not None:
            self._fit.disabled = False

    def _tell(self, table: Measurement, text: str) -> None:
        if self._table is table:
            self._result.content = _text(html.escape(text))

    def _say(self, error: Exception) -> None:
        text = of(str(error)).removeprefix("fit: ")
        if self._table is not None:
            self._result.content = _text(say("fit-cannot", why=html.escape(text)))

    def _take_found(self, table: Measurement, scene: sim.Scene, found: Fit, seen: Fan) -> None:
        """Show the result, and apply it to the scene as one step of undo."""
        if self._table is not table:
            return
        if self._session.simulation.capture().scene is not scene:
            self._say(InputError(say("fit-changed")))
            return
        self._found = found
        self._result.content = _found_html(found)
        self._session.post(commands.Change(lambda moment, _: Edit("fitted", found.scene)))
        self._session.post(commands.Reset())
        self._page.mail.send(seen)
        self._show_points()


_OF_TABLE: dict[str, Key] = {"start": "fit-start", "origin": "fit-origin", "length_scale": "fit-length-scale"}
_OF_SPRINGS = ("linear_stiffness", "linear_damping")
_OF_JOINTS = ("angular_stiffness", "angular_damping")
"""What is fitted by default; of a body with joints, their bending is what one sees."""


def fan(found: Fit, seconds: float, yield_gil: YieldGil) -> Fan:
    """Simulate bodies whose numbers vary as far as the data leave them open.

    Args:
        found: the fit.
        seconds: for how long; shorter for many masses, see `MAX_FAN_NUMBERS`.
        yield_gil: pauses after each body.
    """
    masses = len(found.scene.masses)
    dt = found.scene.integrator.dt
    every = max(round(1.0 / (FAN_RATE * dt)), 1)
    frames = min(int(seconds / (every * dt)) + 2, MAX_FAN_NUMBERS // (2 * DRAWS * masses))
    places = np.zeros((frames, DRAWS, masses, 2))
    for i, scene in enumerate(found.draws(DRAWS)):
        body = sim.Simulation(scene)
        for k in range(frames):
            places[k, i] = body.positions
            body.step(every)
        yield_gil.pause()
    numbers = np.clip(np.nan_to_num(places), -1e7, 1e7).astype(np.float32).ravel()  # one may run away
    return Fan(numbers=numbers, draws=DRAWS, masses=masses, rate=1.0 / (every * dt))


def _value(estimate: Estimate | None, otherwise: float) -> float:
    return otherwise if estimate is None else estimate.value


def _short(label: str) -> str:
    return label if len(label) <= 24 else f"{label[:23]}…"


def _text(content: str) -> str:
    return f'<div class="softrod-text">{content}</div>'


def _found_html(found: Fit) -> str:
    """Return the numbers with their intervals, the residuals, and what the data cannot determine, as HTML."""
    rows = {html.escape(each.name): html.escape(of(each.text)) for each in found.values.values()}
    left = [
        say("fit-left", column=each.column, noise=decimal(f"{each.noise:.3g} {each.unit}".rstrip()))
        for each in found.series
    ]
    said = "".join(f"<p>{html.escape(of(line))}</p>" for line in (*left, *found.sentences))
    return readouts.table(rows) + _text(said)
