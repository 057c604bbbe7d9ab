"""Switches of what is measured on the canvas: arrows, traces, coordinates. They are in the Measure tab."""

from __future__ import annotations

from collections.abc import Set
from functools import partial

import viser

from ...ui.page import Page
from ...ui.viser.handlers import on_change
from .arrows import KINDS, Arrows
from .messages import Tools

MAX_TRACES = 8
"""Masses whose path is drawn at the same time; the one that was chosen first gives way."""

LENGTHS = {"1 s": 1, "2 s": 2, "5 s": 5, "10 s": 10, "30 s": 30}
"""Simulated seconds of a trace."""

LAST = 1e6
"""Order of the first control: they stand below the plots, which come and go."""

LABELS = {"forces": "Forces", "velocities": "Velocities", "torques": "Torques"}
HINTS = {
    "forces": "the net force on each mass; on a held one, dashed, what its support bears",
    "velocities": "of each mass",
    "torques": "with which each angular spring turns its first spring",
}


class ToolsPanel:
    """The switches of one page; made inside the tab.

    Args:
        page: whose body is measured.
    """

    def __init__(self, page: Page) -> None:
        self._session, self._mail = page.session, page.mail
        self._arrows = Arrows(page.mail)
        self._chosen: int | None = None
        self._traced: tuple[int, ...] = ()
        gui = page.client.gui
        self._switches = {
            kind: gui.add_checkbox(LABELS[kind], initial_value=False, hint=HINTS[kind], order=LAST + i / 10.0)
            for i, kind in enumerate(KINDS)
        }
        self._coordinates = gui.add_checkbox(
            "Coordinates",
            initial_value=False,
            hint="of the mass under the pointer, or clicked last",
            order=LAST + 1,
        )
        self._trace = gui.add_checkbox(
            "Trace the chosen mass",
            initial_value=False,
            hint="click a mass to choose it; several can have one",
            order=LAST + 2,
        )
        self._length = gui.add_dropdown(
            "Length of a trace", tuple(LENGTHS), initial_value="5 s", order=LAST + 3
        )
        page.button(
            "Clear the traces", viser.Icon.ERASER, lambda: page.later(self.clear_traces), order=LAST + 4
        )
        on_change(self._trace, lambda: page.later(partial(self.trace, self._trace.value)))
        for control in (self._coordinates, self._length):
            on_change(control, lambda: page.later(self._show))

    # --------------------------------------------------------------------- the ticker's
    @property
    def kinds(self) -> frozenset[str]:
        """The kinds of arrows that are on."""
        return frozenset(kind for kind, switch in self._switches.items() if switch.value)

    def build(self) -> None:
        """For another body: no mass of the one before is traced."""
        self._chosen, self._traced = None, ()
        self._switches["torques"].visible = bool(self._session.scene.angular_springs)
        self._show()

    def choose(self, mass: int) -> None:
        """A mass was clicked."""
        if mass < len(self._session.scene.masses):
            self._chosen = mass
            self._show()

    def show_arrows(self, kinds: Set[str]) -> None:
        """Have arrows of these kinds, and no others."""
        for kind, switch in self._switches.items():
            switch.value = kind in kinds

    def leave(self) -> frozenset[str]:
        """The panel is taken out of the page: take away the arrows, too, and return their kinds."""
        self._arrows.clear()
        return self.kinds

    def trace(self, on: bool) -> None:
        """Trace the chosen mass, or no longer."""
        if self._chosen is not None:
            others = tuple(mass for mass in self._traced if mass != self._chosen)
            self._traced = (*others, self._chosen)[-MAX_TRACES:] if on else others
        self._show()

    def clear_traces(self) -> None:
        """Trace nothing any more."""
        self._traced = ()
        self._show()

    def draw(self, plan: int, now: float, exactly: bool) -> None:
        """Send what the arrows need, see `Arrows.draw`."""
        session = self._session
        kinds = self.kinds if session.scene.angular_springs else self.kinds - {"torques"}
        self._arrows.draw(session, kinds, plan, now, exactly)

    def _show(self) -> None:
        """Show what the controls have come to, in them and to the page's script (tools.js)."""
        self._trace.value = self._chosen in self._traced
        tools = Tools(
            traced=self._traced,
            seconds=LENGTHS.get(str(self._length.value), 5),
            chosen=-1 if self._chosen is None else self._chosen,
            coordinates=bool(self._coordinates.value),
        )
        self._mail.send(tools)
