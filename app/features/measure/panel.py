"""The Measure tab: lists to choose what to plot, with the plots below."""

from __future__ import annotations

import html

import numpy as np
import viser

from sim.errors import InputError
from sim.motion.formulas import MAX_LENGTH
from sim.motion.quantities import COUNTED
from sim.scene.columns import ends
from sim.scene.types import Scene

from ...session.notices import Notice
from ...session.plots import OFFERED, PlotSpec, find
from ...ui import readouts
from ...ui.page import Page
from ...ui.viser.handlers import on_change, on_press
from ...words import say
from ...words.english import refusal
from ...words.quantities import part_called, quantity_of
from .messages import ShowMeasures
from .plot_list import PlotList

BELOW, LAST = 1e5, 1e6
"""Orders of what stands below the plots."""

MAX_PARTS = 24
"""Joints, and springs, of the chosen mass in the list, at most."""

FIRST_PART = "mass0"

TEXT = '<div class="softrod-text">{}</div>'
REFUSED = TEXT.format('<span class="softrod-refused">{}</span>')


class MeasurePanel:
    """The controls of one page's Measure tab, and its plots.

    Args:
        page: whose body is measured.
        tab: where they stand.

    Attributes:
        plots: the open plots.
    """

    def __init__(self, page: Page, tab: viser.GuiTabHandle) -> None:
        self._page, self._session = page, page.session
        self._mass: int | None = None
        self._joint = -1
        self._parts: dict[str, str] = {part_called(FIRST_PART): FIRST_PART}
        self._whats: dict[str, str] = {quantity_of("mass", what): what for what in OFFERED["mass"]}
        gui = page.client.gui
        with tab:
            gui.add_divider(order=BELOW + 1)
            gui.add_html(TEXT.format(say("measure-about")), order=BELOW + 2)
            self._part = gui.add_dropdown(say("measure-part"), tuple(self._parts), order=BELOW + 3)
            self._what = gui.add_dropdown(say("measure-quantity"), tuple(self._whats), order=BELOW + 4)
            self._formula = gui.add_text(
                say("measure-formula"),
                initial_value="",
                hint=say("measure-formula.hint"),
                order=BELOW + 4.2,
            )
            self._refusal = gui.add_html("", order=BELOW + 4.4)
            self._refusal.visible = False
            self._time: tuple[str, ...] = (say("measure-over.time"),)
            self._over = gui.add_dropdown(say("measure-over"), self._time, order=BELOW + 5)
            self.new = gui.add_button(say("measure-new"), icon=viser.Icon.CHART_LINE, order=BELOW + 6)
            self._hint = gui.add_html("", order=BELOW + 7)
            self._comma_switch = page.commas.add(gui, order=BELOW + 8)
            self._comma_switch.visible = False
            self._joint_table = gui.add_html("", order=LAST) if "angle" in page.controls else None
        self.plots = PlotList(page, tab, lambda: self._chosen, self._changed)
        on_change(self._formula, lambda: page.later(self._offer))
        for chosen in (self._part, self._what):
            on_change(chosen, lambda: page.later(self._take_quantity))
        on_press(self.new, lambda: page.later(self._add_chosen))

    # --------------------------------------------------------------------- the ticker's
    def choose(self, mass: int) -> None:
        """Choose a mass that was clicked, and offer its joints and springs."""
        self._mass = mass
        self._formula.value = ""
        self._offer()
        self._part.value = part_called(f"mass{mass}")
        self._offer()

    def build(self) -> None:
        """Adapt to another scene or other looks, see `PlotList.build`."""
        self._joint = -1
        if self._mass is not None and self._mass >= len(self._session.scene.masses):
            self._mass = None
        self.plots.build()

    def refresh(self) -> None:
        """Show the present angle."""
        if self._joint_table is not None:
            self._joint_table.content = readouts.joint_table(self._session)

    def tick(self) -> None:
        """Update the lists and the plots."""
        if self._joint != self._session.joint:
            self._joint = self._session.joint
            self._offer()
        self.plots.tick()

    # --------------------------------------------------------------------- what is offered
    def _take_quantity(self) -> None:
        """Take what was chosen in a list, and no longer a formula."""
        self._formula.value = ""
        self._offer()

    def _offer(self) -> None:
        """Update the options of the lists."""
        self._parts = {part_called(part): part for part in self.parts}
        part = self._parts[_set_options(self._part, tuple(self._parts))]
        of = part.rstrip("0123456789")
        offered = OFFERED[of]
        self._whats = {quantity_of(of, what): what for what in offered}
        _set_options(self._what, tuple(self._whats))
        same_part, chosen = (f"{part}.{what}" for what in offered), self._chosen
        refused = self._refused()
        self._refusal.content, self._refusal.visible = refused, bool(refused)
        about = say("measure-about.plots")
        if not len(self.plots):
            about = "" if refused else say("measure-no-plot", quantity=html.escape(chosen))
        self._hint.content = about and TEXT.format(about)
        others = [name for name in dict.fromkeys((*same_part, *self.plots.names)) if name != chosen]
        _set_options(self._over, (*self._time, *others))

    @property
    def parts(self) -> tuple[str, ...]:
        """The parts in the list: the clicked mass with its joints and springs, and all that exists once."""
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
        """The formula, or without one the chosen quantity."""
        formula = self._formula.value[: MAX_LENGTH + 1].strip()
        part, what = self._part.value, self._what.value
        return formula or f"{self._parts.get(part, part)}.{self._whats.get(what, what)}"

    def _refused(self) -> str:
        """Why the formula is none, as HTML; empty if it is one, or there is none."""
        if not self._formula.value.strip():
            return ""
        try:
            find(self._chosen, self._session.scene)
        except InputError as error:
            return REFUSED.format(html.escape(refusal(error)))
        return ""

    # --------------------------------------------------------------------- plots
    def _add_chosen(self) -> None:
        over = self._over.value
        self._page.mail.send(ShowMeasures())
        self.plots.add(PlotSpec((self._chosen,), "" if over in self._time else over))

    def begin(self) -> None:
        """Open the first plot, of what is offered first, if there is none."""
        if not self.plots.specs:
            self._offer()
            self.plots.add(PlotSpec((self._chosen,)))

    def plot_angle(self) -> None:
        """Plot the angle of the joint whose readout is shown, and show the tab."""
        session = self._session
        if not session.scene.angular_springs:
            self._page.notify(Notice("warning", say("measure-nothing"), say("measure-nothing.text")))
            return
        self._page.mail.send(ShowMeasures())
        spec = PlotSpec((f"joint{session.joint}.angle",))
        if spec not in self.plots.specs:
            self.plots.add(spec)

    def _changed(self) -> None:
        self._comma_switch.visible = len(self.plots) > 0
        self._offer()


def _first_free(scene: Scene) -> int:
    """Return the first mass that is not held; 0 if all are."""
    held = {anchor.mass for anchor in scene.anchors}
    return next((i for i in range(len(scene.masses)) if i not in held), 0)


def _set_options(handle: viser.GuiDropdownHandle[str], options: tuple[str, ...]) -> str:
    """Set the options of a list, and return the chosen one.

    A value that is not among them, since a page can send any, is replaced by the first option.
    """
    value = handle.value
    if handle.options != options:
        handle.options = options
    handle.value = value if value in options else options[0]
    return handle.value
