"""The Measure tab: plots of quantities that run with the body, with period and damping, and their tables.

Handlers only say what is wanted; the ticker does it. Where no plot is open there is nothing to do.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import viser

from sim.errors import InputError
from sim.motion.quantities import COUNTED
from sim.scene.columns import ends

from ..drawing.colors import palette
from ..session.notices import Notice
from ..session.plots import MOST_PLOTS, OFFERED, Plot, Wish, curve
from ..session.session import Session
from . import plots, readouts
from .comma_switch import CommaSwitch

EVERY = 0.1
"""Seconds between two updates of a plot, at least."""

READ_EVERY = 0.5
"""Seconds between two readings of period and damping."""

WIDTH, HEIGHT = 150, 220
"""Pieces of a curve from left to right, each with its highest and lowest value; pixels of a plot's height."""

SPANS = {"5 s": 5.0, "10 s": 10.0, "20 s": 20.0, "60 s": 60.0}
"""How much time a plot shows."""

MOST_PARTS = 24
"""Joints and springs of the chosen mass that are offered, at most."""

TIME = "time"
_HERE, _TABLE, _REMOVE = "Add to it", "CSV", "Remove"

ABOUT = (
    '<div class="softrod-text">Click a mass to choose what is measured: the mass, its joint and its springs. '
    "The pointer over a plot reads values; drag across it to look closer, double-click to see all.</div>"
)


@dataclass
class _Shown:
    """A plot in the page. Its chart keeps its number of lines: after a change viser may draw nothing."""

    plot: Plot
    title: viser.GuiHtmlHandle
    reading: viser.GuiHtmlHandle
    buttons: viser.GuiButtonGroupHandle
    order: float  # of the chart
    chart: viser.GuiUplotHandle | viser.GuiHtmlHandle | None = None
    sent: int = -1  # the version of the plot that the page has
    looks: tuple[object, ...] = ()  # what its lines and axes are for

    def remove(self) -> None:
        """Take it out of the page."""
        for handle in (self.title, self.reading, self.buttons):
            handle.remove()
        self.remove_chart()

    def remove_chart(self) -> None:
        """Take its chart out of the page; the next time that it is shown it gets another one."""
        if self.chart is not None:
            self.chart.remove()
        self.chart = None


class MeasurePanel:
    """The controls and plots of one page's Measure tab.

    Args:
        client: the page.
        tab: where they stand.
        session: what is measured.
        notify: tells the user something.
        commas: whether tables have decimal commas.

    Attributes:
        called: counts how often the tab was to be shown.
        looked_at: whether anybody sees the plots; otherwise they run on, but are not sent.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        tab: viser.GuiTabHandle,
        session: Session,
        notify: Callable[[Notice], None],
        commas: CommaSwitch,
    ) -> None:
        self._client, self._tab, self._session, self._notify = client, tab, session, notify
        self._commas = commas
        self._asked: deque[Callable[[], None]] = deque(maxlen=100)
        self._plots: list[_Shown] = []
        self._kept: tuple[Wish, ...] | None = None  # None for those that are open
        self._mass: int | None = None
        self._joint = -1
        self._dark = False
        self._due = self._read_due = 0.0
        self._numbers = 0
        self.called = 0
        self.looked_at = True
        gui = client.gui
        with tab:
            gui.add_html(ABOUT, order=1)
            lists: list[viser.GuiDropdownHandle[str]] = [
                gui.add_dropdown(label, options, order=order)
                for order, (label, options) in enumerate(
                    (("Part", ["mass0"]), ("Quantity", [*OFFERED["mass"]]), ("Over", [TIME])), start=2
                )
            ]
            self._part, self._what, self._over = lists
            self.new = gui.add_button("New plot", icon=viser.Icon.CHART_LINE, order=5)
            self._span = gui.add_dropdown("Plots show", tuple(SPANS), initial_value="10 s", order=6)
            self._span.visible = False
            self._comma_switch = commas.add(gui, order=7)
            self._comma_switch.visible = False
        for handle, action in (
            (self._part, self._offer),
            (self._what, self._offer),
            (self._span, self._redraw),
        ):

            @handle.on_update
            async def _(event: viser.GuiEvent[Any], action: Callable[[], None] = action) -> None:
                if event.client_id is not None:
                    self._asked.append(action)

        @self.new.on_click
        async def _(_: object) -> None:
            self._asked.append(self._add_chosen)

    # --------------------------------------------------------------------- any thread
    def plot_angle(self) -> None:
        """Have the angle of the joint that is read out plotted, and the tab shown."""
        self._asked.append(self._add_angle)

    # --------------------------------------------------------------------- the ticker's
    @property
    def wishes(self) -> tuple[Wish, ...]:
        """The plots that are open."""
        return tuple(shown.plot.wish for shown in self._plots) if self._kept is None else self._kept

    def remember(self, wishes: tuple[Wish, ...], show: bool = False) -> None:
        """Have these plots, and no others, as soon as the scene is there that they are of.

        Args:
            wishes: the plots.
            show: whether the tab is to be shown.
        """
        self._kept = wishes[:MOST_PLOTS]
        self.called += show

    def choose(self, mass: int) -> None:
        """Offer a mass and what is at it; it was clicked."""
        self._mass = mass
        self._joint = -1  # what is offered is to be looked at again

    def build(self, dark: bool) -> None:
        """Another scene, or other looks: plots of what is not there any more go, the others begin anew if
        their time does."""
        scene = self._session.scene
        self._dark = dark
        self._joint = -1
        if self._mass is not None and self._mass >= len(scene.masses):
            self._mass = None
        wishes, self._kept = self._kept, None
        if wishes is not None:
            for shown in list(self._plots):
                self._remove(shown)
            for wish in wishes:
                self._try_add(wish)
        for shown in list(self._plots):
            try:
                plot = Plot(shown.plot.wish, scene)
            except InputError:
                self._remove(shown)
                continue
            if [q.unit for q in plot.quantities] != [q.unit for q in shown.plot.quantities]:
                plot.version = shown.sent + 1
                shown.plot = plot
        self._redraw()

    def tick(self) -> None:
        """Do what was asked for; note the present values, and show them when it is time."""
        while self._asked:
            self._asked.popleft()()
        session, now = self._session, self._session.now()
        if self._joint != session.joint:
            self._joint = session.joint
            self._offer()
        if not self._plots:
            return
        for shown in self._plots:
            shown.plot.sample(session)
        if now >= self._due and self.looked_at:
            self._due = now + EVERY
            reads = now >= self._read_due
            if reads:
                self._read_due = now + READ_EVERY
            for shown in self._plots:
                if shown.sent != shown.plot.version:
                    self._show(shown, reads)
                    if reads:
                        shown.sent = shown.plot.version

    # --------------------------------------------------------------------- what is offered
    def _offer(self) -> None:
        """Show in the lists what can be chosen now."""
        part = _set_options(self._part, self._parts())
        offered = OFFERED[part.rstrip("0123456789")]
        chosen = f"{part}.{_set_options(self._what, offered)}"
        plotted = (name for shown in self._plots for name in shown.plot.wish.names)
        beside = (f"{part}.{what}" for what in offered)
        others = [name for name in dict.fromkeys((*beside, *plotted)) if name != chosen]
        _set_options(self._over, (TIME, *others))

    def _parts(self) -> tuple[str, ...]:
        """The parts that are offered: what was clicked, and what there is only one of."""
        session = self._session
        scene, joint = session.scene, session.joint
        mass = self._mass
        if mass is None:
            mass = readouts.mass_of_joint(scene, joint) if scene.angular_springs else 0
        a, b = ends(scene.linear_springs)
        at = (a == mass) | (b == mass)
        springs: list[int] = np.flatnonzero(at).tolist()
        a, b = ends(scene.angular_springs)
        joints: list[int] = np.flatnonzero(at[a] & at[b]).tolist()
        if scene.angular_springs:
            joints = list(dict.fromkeys((joint, *joints)))
        counted = (
            *(f"joint{j}" for j in joints[:MOST_PARTS]),
            f"mass{mass}",
            *(f"spring{s}" for s in springs[:MOST_PARTS]),
        )
        return (*counted, *(part for part in OFFERED if part not in COUNTED))

    @property
    def _chosen(self) -> str:
        return f"{self._part.value}.{self._what.value}"

    # --------------------------------------------------------------------- plots
    def _add_chosen(self) -> None:
        over = self._over.value
        self.called += 1
        self._try_add(Wish((self._chosen,), "" if over == TIME else over))

    def _add_angle(self) -> None:
        session = self._session
        if not session.scene.angular_springs:
            self._notify(Notice("warning", "Nothing to plot", "This scene has no joints."))
            return
        self.called += 1
        wish = Wish((f"joint{session.joint}.angle",))
        if wish not in self.wishes:
            self._try_add(wish)

    def _try_add(self, wish: Wish) -> None:
        """Open a plot, or say why not."""
        try:
            if len(self._plots) == MOST_PLOTS:
                raise InputError(f"a page has room for {MOST_PLOTS} plots; remove one first")
            plot = Plot(wish, self._session.scene)
        except InputError as error:
            self._notify(Notice("error", "That cannot be plotted", f"{error}."))
            return
        self._numbers += 1
        order, gui = 10.0 * self._numbers + 10.0, self._client.gui
        with self._tab:
            title = gui.add_html("", order=order)
            reading = gui.add_html("", order=order + 2)
            buttons = gui.add_button_group("", (_HERE, _TABLE, _REMOVE), order=order + 3)
        shown = _Shown(plot, title, reading, buttons, order + 1)
        self._plots.append(shown)

        @buttons.on_click
        async def _(event: viser.GuiEvent[Any]) -> None:
            actions = {_HERE: self._extend, _TABLE: self._download, _REMOVE: self._remove}
            action = actions.get(event.target.value)
            if event.client_id is not None and action is not None:
                self._asked.append(partial(action, shown))

        plot.sample(self._session)
        self._span.visible = self._comma_switch.visible = True
        self._offer()
        self._show(shown, reads=True)

    def _remove(self, shown: _Shown) -> None:
        if shown not in self._plots:
            return
        self._plots.remove(shown)
        shown.remove()
        self._span.visible = self._comma_switch.visible = bool(self._plots)
        if not (self._session.books or any(one.plot.wants_energy for one in self._plots)):
            self._session.simulation.keep_books(False)
        self._offer()

    def _extend(self, shown: _Shown) -> None:
        """Plot what is chosen beside what a plot has."""
        wish, name = shown.plot.wish, self._chosen
        if shown not in self._plots or name in wish.names:
            return
        try:
            plot = Plot(Wish((*wish.names, name), wish.over), self._session.scene)
        except InputError as error:
            self._notify(Notice("error", "That cannot be added", f"{error}."))
            return
        plot.take_over(shown.plot)
        shown.remove_chart()
        shown.plot, shown.sent = plot, -1
        plot.sample(self._session)
        self._show(shown, reads=True)

    def _download(self, shown: _Shown) -> None:
        name = f"{self._session.scene.name}-{shown.plot.wish.names[0]}.csv"
        self._client.send_file_download(
            name, shown.plot.table(self._commas.on).encode(), save_immediately=True
        )

    def _redraw(self) -> None:
        for shown in self._plots:
            self._show(shown, reads=True)

    # --------------------------------------------------------------------- drawing
    def _show(self, shown: _Shown, reads: bool) -> None:
        """Send a plot."""
        plot, seconds = shown.plot, SPANS.get(self._span.value, 10.0)
        drawn = curve(plot, seconds, WIDTH)
        colors = palette(self._session.scene.view.colors, self._dark)
        series = plots.colors_of(plot, colors)
        gui, chart = self._client.gui, shown.chart
        with self._client.atomic(), self._tab:
            if plot.wish.over:
                content = plots.draw_over_another(plot, drawn, series)
                if isinstance(chart, viser.GuiHtmlHandle):
                    chart.content = content
                else:
                    shown.chart = gui.add_html(content, order=shown.order)
            else:
                before = chart if isinstance(chart, viser.GuiUplotHandle) else None
                add = partial(gui.add_uplot, height=HEIGHT, padding=(8, 4, 0, 0), order=shown.order)
                shown.chart, shown.looks = plots.draw_over_time(
                    before, add, plot, drawn, series, colors, shown.looks
                )
            if reads:
                _set(shown.title, plots.title(plot, series))
                _set(shown.reading, plots.reading(plot, seconds))


def _set(handle: viser.GuiHtmlHandle, content: str) -> None:
    if handle.content != content:
        handle.content = content


def _set_options(handle: viser.GuiDropdownHandle[str], options: tuple[str, ...]) -> str:
    """Offer some options; what is chosen stays, if it is among them: a page can send anything, at any time.

    Returns:
        What is chosen now.
    """
    value = handle.value
    if handle.options != options:
        handle.options = options
    wanted = value if value in options else options[0]
    if handle.value != wanted:
        handle.value = wanted
    return wanted
