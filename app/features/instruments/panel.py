"""Switches in the Measure tab for what is drawn on the canvas: arrows, traces, coordinates, images."""

from __future__ import annotations

from collections.abc import Set
from functools import partial

import viser

from ...ui.page import Page
from ...ui.viser.handlers import on_change
from ...words import decimal, say
from ...words.keys import Key
from .arrows import KINDS, Arrows
from .messages import Tools

MAX_TRACES = 8
"""Masses whose paths are drawn at the same time; the oldest trace gives way to a new one."""

TRACE_SECONDS = {"1 s": 1, "2 s": 2, "5 s": 5, "10 s": 10, "30 s": 30}
"""Lengths of a trace, simulated s, by their labels."""

STROBE_INTERVALS = (0.05, 0.1, 0.2, 0.5, 1.0)
"""Intervals of the stroboscope, simulated s."""

ORDER = 1e6
"""Order of the first control in the panel: below the plots, which come and go."""

SWITCHES: dict[str, tuple[Key, Key]] = {
    "forces": ("instruments-forces", "instruments-forces.hint"),
    "velocities": ("instruments-velocities", "instruments-velocities.hint"),
    "torques": ("instruments-torques", "instruments-torques.hint"),
}
"""Names of the switches of arrows, and what these show."""


class ToolsPanel:
    """The switches of one page, created in the tab that is open.

    Args:
        page: the page.
    """

    def __init__(self, page: Page) -> None:
        self._session, self._mail = page.session, page.mail
        self._arrows = Arrows(page.mail)
        self._chosen: int | None = None
        self._traced: tuple[int, ...] = ()
        gui = page.client.gui

        def switch(label: Key, hint: Key, order: float) -> viser.GuiCheckboxHandle:
            return gui.add_checkbox(say(label), initial_value=False, hint=say(hint), order=ORDER + order)

        self._intervals = {
            say("instruments-strobe.off"): 0.0,
            **{
                say("instruments-strobe.every", seconds=decimal(f"{each:g}")): each
                for each in STROBE_INTERVALS
            },
        }
        self._switches = {kind: switch(*SWITCHES[kind], i / 10.0) for i, kind in enumerate(KINDS)}
        self._coordinates = switch("instruments-coordinates", "instruments-coordinates.hint", 1)
        self._trace = switch("instruments-trace", "instruments-trace.hint", 2)
        self._length = gui.add_dropdown(
            say("instruments-trace.length"), tuple(TRACE_SECONDS), initial_value="5 s", order=ORDER + 3
        )
        page.button(
            say("instruments-trace.clear"),
            viser.Icon.ERASER,
            lambda: page.later(self.clear_traces),
            order=ORDER + 4,
        )
        self._strobe = gui.add_dropdown(
            say("instruments-strobe"),
            tuple(self._intervals),
            hint=say("instruments-strobe.hint"),
            order=ORDER + 5,
        )
        on_change(self._trace, lambda: page.later(partial(self.trace, self._trace.value)))
        for control in (self._coordinates, self._length, self._strobe):
            on_change(control, lambda: page.later(self._show))

    # --------------------------------------------------------------------- the ticker's
    @property
    def kinds(self) -> frozenset[str]:
        """The kinds of arrows that are on."""
        return frozenset(kind for kind, switch in self._switches.items() if switch.value)

    def clear(self) -> None:
        """Turn off arrows and stroboscope."""
        self.show_arrows(frozenset())
        self._strobe.value = next(iter(self._intervals))

    def build(self) -> None:
        """Adapt to another body: trace no mass."""
        self._chosen, self._traced = None, ()
        self._switches["torques"].visible = bool(self._session.scene.angular_springs)
        self._show()

    def choose(self, mass: int) -> None:
        """Choose the mass that was clicked."""
        if mass < len(self._session.scene.masses):
            self._chosen = mass
            self._show()

    def show_arrows(self, kinds: Set[str]) -> None:
        """Turn on the arrows of these kinds, and the others off."""
        for kind, switch in self._switches.items():
            switch.value = kind in kinds

    def leave(self) -> frozenset[str]:
        """Remove the arrows before the panel is removed from the page, and return their kinds."""
        self._arrows.clear()
        return self.kinds

    def trace(self, on: bool) -> None:
        """Trace the chosen mass, or stop."""
        if self._chosen is not None:
            others = tuple(mass for mass in self._traced if mass != self._chosen)
            self._traced = (*others, self._chosen)[-MAX_TRACES:] if on else others
        self._show()

    def clear_traces(self) -> None:
        """Stop tracing."""
        self._traced = ()
        self._show()

    def draw(self, plan: int, now: float, exactly: bool) -> None:
        """Send the numbers of the arrows, see `Arrows.draw`."""
        session = self._session
        kinds = self.kinds if session.scene.angular_springs else self.kinds - {"torques"}
        self._arrows.draw(session, kinds, plan, now, exactly)

    def _show(self) -> None:
        """Show the present state, in the controls and to the page's script (tools.js)."""
        self._trace.value = self._chosen in self._traced
        tools = Tools(
            traced=self._traced,
            seconds=TRACE_SECONDS.get(str(self._length.value), 5),
            chosen=-1 if self._chosen is None else self._chosen,
            coordinates=bool(self._coordinates.value),
            strobe=self._intervals.get(str(self._strobe.value), 0.0),
        )
        self._mail.send(tools)
