"""Switches of what is measured on the canvas: arrows, traces, coordinates. They are in the Measure tab."""

from __future__ import annotations

from collections import deque
from collections.abc import Set
from typing import Any

import viser

from ...session.session import Session
from ...wire.carrier import Mail
from ...wire.to_page import Tools
from .arrows import KINDS, Arrows

MOST_TRACES = 8
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
        client: the page.
        session: its simulation.
        mail: to the page's script.
    """

    def __init__(self, client: viser.ClientHandle, session: Session, mail: Mail) -> None:
        self._session, self._mail = session, mail
        self._asked: deque[tuple[str, Any]] = deque(maxlen=100)
        self._arrows = Arrows(mail)
        self._kinds: frozenset[str] = frozenset()
        self._chosen: int | None = None
        self._traced: tuple[int, ...] = ()
        gui = client.gui
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
        clear = gui.add_button("Clear the traces", icon=viser.Icon.ERASER, color="gray", order=LAST + 4)

        for kind, switch in self._switches.items():
            self._listen(switch, kind)
        self._listen(self._trace, "trace")
        for control in (self._coordinates, self._length):
            self._listen(control, "tell")

        @clear.on_click
        async def _(_: object) -> None:
            self._asked.append(("clear", None))

    def _listen(self, control: Any, what: str) -> None:
        @control.on_update
        async def _(event: viser.GuiEvent[Any]) -> None:
            if event.client_id is not None:
                self._asked.append((what, control.value))

    # --------------------------------------------------------------------- the ticker's
    @property
    def kinds(self) -> frozenset[str]:
        """The kinds of arrows that are on."""
        return self._kinds

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
        self._kinds = frozenset(kinds)
        for kind, switch in self._switches.items():
            if switch.value != (kind in kinds):
                switch.value = kind in kinds

    def leave(self) -> frozenset[str]:
        """The panel is taken out of the page: take away the arrows, too, and return their kinds."""
        self._arrows.clear()
        return self._kinds

    def tick(self) -> None:
        """Do what was asked for; before another scene may take the place of the present one."""
        while self._asked:
            self.serve(*self._asked.popleft())

    def serve(self, what: str, value: Any) -> None:
        """Do what a control asks for: a kind of arrows, a trace of the chosen mass, none, or tell."""
        if what in KINDS:
            self._kinds = self._kinds | {what} if value else self._kinds - {what}
        elif what == "trace" and self._chosen is not None:
            others = tuple(mass for mass in self._traced if mass != self._chosen)
            self._traced = (*others, self._chosen)[-MOST_TRACES:] if value else others
        elif what == "clear":
            self._traced = ()
        self._show()

    def draw(self, plan: int, now: float, exactly: bool) -> None:
        """Send what the arrows need, see `Arrows.draw`."""
        session = self._session
        kinds = self._kinds if session.scene.angular_springs else self._kinds - {"torques"}
        self._arrows.draw(session, kinds, plan, now, exactly)

    def _show(self) -> None:
        """Show what the controls have come to, in them and to the page's script (tools.js)."""
        traced = self._chosen in self._traced
        if self._trace.value != traced:
            self._trace.value = traced
        tools = Tools(
            traced=self._traced,
            seconds=LENGTHS.get(str(self._length.value), 5),
            chosen=-1 if self._chosen is None else self._chosen,
            coordinates=bool(self._coordinates.value),
        )
        self._mail.tell(tools)
