"""The Measure tab: what is plotted is chosen there, and the plots stand below."""

from __future__ import annotations

import numpy as np
import viser

from sim.motion.quantities import COUNTED
from sim.scene.columns import ends
from sim.scene.types import Scene

from ...session.notices import Notice
from ...session.plots import OFFERED, Wish
from ...ui import readouts
from ...ui.page import Page
from ...ui.viser.handlers import on_change, on_press
from .messages import ShowMeasures
from .plot_list import SPANS, PlotList

MAX_PARTS = 24
"""Joints and springs of the chosen mass that are offered, at most."""

TIME = "time"

ABOUT = (
    '<div class="softrod-text">Click a mass to choose what is measured: the mass, its joint and its '
    "springs.</div>"
)
OF_PLOTS = (
    '<div class="softrod-text">The pointer over a plot reads values; drag across it to look closer, '
    "double-click to see all.</div>"
)


def none_yet(chosen: str) -> str:
    """What to do where no plot is open."""
    return f'<div class="softrod-text">No plot is open. <b>New plot</b> shows {chosen} while it moves.</div>'


class MeasurePanel:
    """The controls of one page's Measure tab, and its plots.

    Args:
        page: whose body is measured.
        tab: where they stand.

    Attributes:
        plots: those that are open.
    """

    def __init__(self, page: Page, tab: viser.GuiTabHandle) -> None:
        self._page, self._session = page, page.session
        self._mass: int | None = None
        self._joint = -1
        gui = page.client.gui
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
            self._comma_switch = page.commas.add(gui, order=7)
            self._comma_switch.visible = False
            self._hint = gui.add_html("", order=8)
        self.plots = PlotList(page, tab, lambda: self._chosen, self._changed)
        on_change(self._part, lambda: page.later(self._offer))
        on_change(self._what, lambda: page.later(self._offer))
        on_change(self._span, lambda: page.later(self._respan))
        on_press(self.new, lambda: page.later(self._add_chosen))

    # --------------------------------------------------------------------- the ticker's
    def choose(self, mass: int) -> None:
        """Offer a mass and what is at it; it was clicked."""
        self._mass = mass
        self._joint = -1  # what is offered is to be looked at again

    def build(self) -> None:
        """Another scene, or other looks, see `PlotList.build`."""
        self._joint = -1
        if self._mass is not None and self._mass >= len(self._session.scene.masses):
            self._mass = None
        self.plots.build()

    def tick(self) -> None:
        """Offer what can be plotted now, and show the plots."""
        if self._joint != self._session.joint:
            self._joint = self._session.joint
            self._offer()
        self.plots.tick()

    # --------------------------------------------------------------------- what is offered
    def _offer(self) -> None:
        """Show in the lists what can be chosen now."""
        part = _set_options(self._part, self.parts)
        offered = OFFERED[part.rstrip("0123456789")]
        chosen = f"{part}.{_set_options(self._what, offered)}"
        beside = (f"{part}.{what}" for what in offered)
        self._hint.content = OF_PLOTS if len(self.plots) else none_yet(self._chosen)
        others = [name for name in dict.fromkeys((*beside, *self.plots.names)) if name != chosen]
        _set_options(self._over, (TIME, *others))

    @property
    def parts(self) -> tuple[str, ...]:
        """The parts that are offered: what was clicked, and what there is only one of."""
        session = self._session
        scene, joint = session.scene, session.joint
        mass = self._mass
        if mass is None:
            mass = readouts.mass_of_joint(scene, joint) if scene.angular_springs else _first_free(scene)
        a, b = ends(scene.linear_springs)
        at = (a == mass) | (b == mass)
        springs: list[int] = np.flatnonzero(at).tolist()
        a, b = ends(scene.angular_springs)
        joints: list[int] = np.flatnonzero(at[a] & at[b]).tolist()
        if scene.angular_springs:
            joints = list(dict.fromkeys((joint, *joints)))
        counted = (
            *(f"joint{j}" for j in joints[:MAX_PARTS]),
            f"mass{mass}",
            *(f"spring{s}" for s in springs[:MAX_PARTS]),
        )
        return (*counted, *(part for part in OFFERED if part not in COUNTED))

    @property
    def _chosen(self) -> str:
        return f"{self._part.value}.{self._what.value}"

    # --------------------------------------------------------------------- plots
    def _add_chosen(self) -> None:
        over = self._over.value
        self._page.mail.send(ShowMeasures())
        self.plots.add(Wish((self._chosen,), "" if over == TIME else over))

    def plot_angle(self) -> None:
        """Plot the angle of the joint that is read out, and show the tab."""
        session = self._session
        if not session.scene.angular_springs:
            self._page.notify(Notice("warning", "Nothing to plot", "This scene has no joints."))
            return
        self._page.mail.send(ShowMeasures())
        wish = Wish((f"joint{session.joint}.angle",))
        if wish not in self.plots.wishes:
            self.plots.add(wish)

    def _changed(self) -> None:
        self._span.visible = self._comma_switch.visible = len(self.plots) > 0
        self._offer()

    def _respan(self) -> None:
        self.plots.seconds = SPANS.get(self._span.value, 10.0)
        self.plots.redraw()


def _first_free(scene: Scene) -> int:
    """The first mass that is not held; 0 if all are."""
    held = {anchor.mass for anchor in scene.anchors}
    return next((i for i in range(len(scene.masses)) if i not in held), 0)


def _set_options(handle: viser.GuiDropdownHandle[str], options: tuple[str, ...]) -> str:
    """Offer some options; what is chosen stays, if it is among them: a page can send anything, at any time.

    Returns:
        What is chosen now.
    """
    value = handle.value
    if handle.options != options:
        handle.options = options
    handle.value = value if value in options else options[0]
    return handle.value
