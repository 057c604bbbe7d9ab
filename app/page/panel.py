"""One page's control panel: viser's handles, which belong to that page alone.

Handlers only hand commands on. A value that a page sends is checked and clamped where it is applied, since
the limits of a slider live in the browser only. A value that the server sets fires the same handlers; those
events have no client, and are ignored, so that nothing loops.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import viser

from sim.methods.registry import METHODS
from sim.scene.types import Scene
from sim.settings import CHOICES, TEMPLATES, Setting, settings_of

from ..drawing.colors import palette
from ..features.solver.solver_panel import SolverPanel
from ..session import commands
from ..ui.commands import key_lines
from ..wire.to_page import Hud
from .looks import readouts
from .page import Page
from .play_panel import LAST, PlayPanel
from .scenes.lesson_panel import LessonPanel
from .viser.choice_box import ChoiceBox
from .viser.handlers import add_command, on_change, on_press
from .viser.slider_box import SliderBox, mixed_words

PANEL_WIDTH = 348
FOREMOST = (
    "tempo", "wind_speed", "gas_pressure", "pressure", "liquid_stiffness", "bulk_modulus", "load", "strength",
    "yield_force", "rest_angle", "template", "bend", "angular_stiffness", "linear_stiffness", "gravity",
)  # fmt: skip
"""Settings that make most of a scene, in order; the first two that there is a use for stand at the top."""

SOLVER_DIALS = ("dt", "tolerance")
"""Settings whose sliders stand in the Solver tab."""

TOUCH_CHOICES = ("restitution", "grip")
"""Choices whose lists stand below the sliders of the body."""


def foremost(applicable: list[Setting]) -> list[Setting]:
    """Of the settings that a scene has, the two that make most of it."""
    known = (setting for setting in applicable if setting.key in FOREMOST)
    return sorted(known, key=lambda setting: FOREMOST.index(setting.key))[:2]


def _has_dial(setting: Setting, scene: Scene) -> bool:
    """Whether a setting that a scene has a use for is shown: some are set by others."""
    if setting.key == "rest_angle":
        return scene.template is None
    return setting.key != "dt" or not METHODS[scene.integrator.method].adaptive


def set_theme(gui: viser.GuiApi, dark: bool) -> None:
    """viser's own colours, without its logo and without the button that would share the page."""
    red, green, blue = (int(part) for part in palette("softrod", dark).brand)
    gui.configure_theme(
        dark_mode=dark, show_logo=False, show_share_button=False, brand_color=(red, green, blue)
    )


_Place = viser.GuiTabHandle | viser.GuiFolderHandle


class _MixedNote:
    """Says below some sliders what those do whose parts have different numbers; it is made when one does.

    Args:
        gui: of the page.
        place: where the sliders stand.
        sliders: those that it is about.
        order: where it stands.
    """

    def __init__(self, gui: viser.GuiApi, place: _Place, sliders: list[SliderBox], order: float) -> None:
        self._gui, self._place, self._sliders, self._order = gui, place, sliders, order
        self._note: viser.GuiHtmlHandle | None = None

    def show(self) -> None:
        """Say what is so now."""
        mixed = dict.fromkeys(mixed_words(box.setting) for box in self._sliders if box.mixed)
        words = " ".join(f"<b>mixed</b>: {each}." for each in mixed)
        if self._note is None and words:
            with self._place:
                self._note = self._gui.add_html("", order=self._order)
        if self._note is not None:
            self._note.content = f'<div class="softrod-text">{words}</div>' if words else ""

    def remove(self) -> None:
        """Take it out of the page."""
        if self._note is not None:
            self._note.remove()


class Panel:
    """The controls of one page, for the scene that it shows.

    Args:
        page: whose panel it is.

    Attributes:
        lesson: the Lesson tab, if a lesson is shown.
        play_tab, measure_tab, files_tab: those tabs, if they are there.
    """

    def __init__(self, page: Page) -> None:
        self._page, self._client, self._session = page, page.client, page.session
        self._controls = controls = page.controls
        self._sliders: list[SliderBox] = []
        self._body: list[Any] = []
        self._shown: tuple[list[Setting], list[str], tuple[str, ...]] | None = None
        self._notes: list[_MixedNote] = []
        self._templates: list[viser.GuiDropdownHandle[str]] = []
        self._choices: list[ChoiceBox] = []
        self._shown_revision = -1
        gui = page.client.gui
        gui.set_panel_label("softrod")
        gui.main_panel.dock_right()
        gui.main_panel.set_width(PANEL_WIDTH)
        has_lesson = page.has_lesson
        if not (controls.in_panel or has_lesson):
            gui.main_panel.minimize()
        self.lesson: LessonPanel | None = None
        self.play_tab: viser.GuiTabHandle | None = None
        self._solver_tab: viser.GuiTabHandle | None = None
        self._play = self._solver = None
        self.measure_tab: viser.GuiTabHandle | None = None
        self.files_tab: viser.GuiTabHandle | None = None
        if controls.in_panel or has_lesson:
            tabs = gui.add_tab_group()
            if has_lesson:
                tab = tabs.add_tab("Lesson")
                self.lesson = LessonPanel(page, tab)
            self._build_tabs(tabs)
        self._add_palette_commands()

    def _build_tabs(self, tabs: viser.GuiTabGroupHandle) -> None:
        """The tabs that there are, with what stays in them."""
        controls = self._controls
        if controls.in_play_tab:
            self.play_tab = tabs.add_tab("Play")
            with self.play_tab:
                self._play = PlayPanel(self._page)
        if "measure" in controls or "tools" in controls:
            self.measure_tab = tabs.add_tab("Measure")
        if "solver" in controls:
            self._solver_tab = tabs.add_tab("Solver")
            with self._solver_tab:
                self._solver = SolverPanel(self._page)
        if "files" in controls:
            self.files_tab = tabs.add_tab("Share")

    # --------------------------------------------------------------------- what stays
    def _add_palette_commands(self) -> None:
        """The table of commands, for the command palette; the page's script acts on the keys themselves."""
        for name, row in self._page.commands.items():
            if not row.listed or (row.needs and row.needs not in self._controls):
                continue
            keys = " or ".join(row.keys)
            held = ", held" if row.held else ""
            about = f"key {keys}{held}" if keys else None
            add_command(self._client.gui, row.label, partial(self._page.perform, name), about)

    # --------------------------------------------------------------------- what a scene needs
    def build(self) -> None:
        """Put up the controls that the session's scene has a use for.

        Those that stay are kept: their user may be in the middle of moving one.
        """
        scene = self._session.scene
        if self._play is not None:
            self._play.build(scene)
        self._shown_revision = -1
        if self._solver is not None:
            self._solver.build()
        applicable = [setting for setting in settings_of(scene) if _has_dial(setting, scene)]
        touching = [key for key in TOUCH_CHOICES if CHOICES[key].applies(scene)]
        of_lesson = self.lesson.controls if self.lesson is not None else ()
        if self._shown == (applicable, touching, of_lesson):
            return
        self._shown = applicable, touching, of_lesson
        for slider_box in self._sliders:
            slider_box.retire()
        for part in (*self._notes, *self._body):  # a folder goes after what is in it
            part.remove()
        self._notes.clear()
        self._body.clear()
        self._sliders.clear()
        self._templates.clear()
        self._choices.clear()
        if self.lesson is not None:
            known = {setting.key: setting for setting in applicable}
            self._add_controls(self.lesson.tab, [known[key] for key in of_lesson if key in known])
            with self.lesson.tab:
                self._add_choices([key for key in of_lesson if key in CHOICES], 30)
        foremost = self._foremost(applicable)
        self._add_controls(self.play_tab, foremost)
        if "body" in self._controls and self.play_tab is not None:
            others = [s for s in applicable if s not in foremost and s.key not in SOLVER_DIALS]
            self._add_numbers(self.play_tab, others, touching, moves=bool(applicable))
        self._add_controls(self._solver_tab, [s for s in applicable if s.key in SOLVER_DIALS])

    def _add_numbers(
        self, tab: viser.GuiTabHandle, others: list[Setting], touching: list[str], moves: bool
    ) -> None:
        """The other sliders of the body, and lists, in a folder of the Play tab.

        Args:
            tab: the Play tab.
            others: what the sliders set.
            touching: keys of the choices that there are, of what the body touches.
            moves: whether it has any slider.
        """
        gui = self._client.gui
        with tab:
            if not moves:
                nothing = "Every mass of this scene is held."
                if "edit" in self._controls:
                    nothing += " Press Edit (E) to build more, or select a mass and let it go."
                self._body.append(gui.add_html(f'<div class="softrod-text">{nothing}</div>', order=LAST + 3))
                return
            folder = gui.add_folder("All numbers", order=LAST + 3)
        with folder:
            self._add_sliders(folder, others)
            self._add_choices(touching, LAST - 2)
            own_values = self._page.button(
                "Scene's own values",
                viser.Icon.RESTORE,
                lambda: self._session.post(commands.OwnValues("body")),
                order=LAST,
            )
        # What is in the folder goes first.
        self._body += [own_values, folder]

    def _foremost(self, applicable: list[Setting]) -> list[Setting]:
        """The settings of the Play tab: those that are named, or those that make most of the scene."""
        named = self._controls.foremost(applicable)
        return foremost(applicable) if named is None else named

    def _add_controls(self, tab: viser.GuiTabHandle | None, settings: list[Setting]) -> None:
        """Sliders in a tab, if there is that tab; what stays in it stands before or after them."""
        if tab is not None:
            with tab:
                self._add_sliders(tab, settings)

    def _add_sliders(self, place: _Place, settings: list[Setting]) -> None:
        """Controls of settings, one below the other, and below them the note on those that are mixed."""
        before = len(self._sliders)
        for order, setting in enumerate(settings, start=10):
            self._add_control(setting, order)
        order = 10.0 + len(settings)
        self._notes.append(_MixedNote(self._client.gui, place, self._sliders[before:], order))

    def _add_control(self, setting: Setting, order: float) -> None:
        if setting.key == "template":
            self._add_templates(order)
        else:
            self._add_slider(setting, order)

    def _add_slider(self, setting: Setting, order: float) -> None:
        def post(value: float) -> None:
            self._session.post(commands.SetValue(setting.key, round(value) if setting.integer else value))

        value = setting.read(self._session.scene)
        slider_box = SliderBox(self._client, setting, value, post, self._page.notify, order)
        self._sliders.append(slider_box)
        self._body += [slider_box.slider, slider_box.box]

    def _add_choices(self, keys: list[str], order: float) -> None:
        """Lists of choices, one below the other."""
        for place, key in enumerate(keys):
            choice = ChoiceBox(self._page, key, order + place)
            self._choices.append(choice)
            self._body.append(choice.handle)

    def _add_templates(self, order: float) -> None:
        names = tuple(f"{angle}°" for angle in TEMPLATES)
        choice = self._client.gui.add_dropdown("Angle template", names, order=order)
        self._templates.append(choice)
        self._body.append(choice)

        def choose() -> None:
            if choice.value in names:
                self._session.post(commands.SetValue("template", float(choice.value.rstrip("°"))))

        on_change(choice, choose)

    # --------------------------------------------------------------------- what changes
    @property
    def unsettled(self) -> bool:
        """Whether a control shows what is not set, or there will be more to show."""
        waits = self._solver is not None and self._solver.waits
        return waits or not all(slider_box.settled for slider_box in self._sliders)

    def show_help(self) -> None:
        """Open the help."""
        with self._client.gui.add_modal("How to use softrod") as modal:
            self._client.gui.add_html(readouts.help_html(key_lines(self._page.commands)))
            on_press(self._client.gui.add_button("Close"), modal.close)

    def refresh_controls(self) -> None:
        """Show in the controls what keys, commands or other controls changed."""
        session = self._session
        scene = session.scene
        if self._shown_revision != session.revision:
            self._shown_revision = session.revision
            if self._solver is not None:
                self._solver.refresh_controls()
        if self._play is not None:
            self._play.refresh_controls()
        for slider_box in self._sliders:
            slider_box.show(scene)
        for note in self._notes:
            note.show()
        for choice in self._choices:
            choice.show(scene)
        template = f"{scene.template}°"
        for templates in self._templates:
            if scene.template is not None:
                templates.value = template

    def refresh_readouts(self, at_rest: bool) -> None:
        """Show the clock, the angle and the rates as they are now."""
        session, looks = self._session, self._page.looks
        colors = palette(session.scene.view.colors, looks.dark)
        self._page.mail.tell(Hud(html=readouts.hud(session, colors, at_rest, looks.meter)))
        if self._play is not None:
            self._play.refresh_readouts()
        if self._solver is not None:
            self._solver.refresh_readouts()
