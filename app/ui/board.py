"""Sliders and dropdown lists for the settings that apply to a scene."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any

import viser

from sim.scene.types import Scene
from sim.settings import TEMPLATES, Setting, settings_of
from sim.solve.registry import METHODS

from ..session import commands
from ..words import say
from .page import Page
from .viser.choice_box import ChoiceBox
from .viser.handlers import on_change
from .viser.slider_box import SliderBox, mixed_words

MAIN_SETTINGS = (
    "tempo", "wind_speed", "gas_pressure", "pressure", "liquid_stiffness", "bulk_modulus", "load", "strength",
    "yield_force", "rest_angle", "template", "bend", "angular_stiffness", "linear_stiffness", "gravity",
)  # fmt: skip
"""The most important settings, in order; the first two that apply are at the top."""

Place = viser.GuiTabHandle | viser.GuiFolderHandle


def main_settings(applicable: list[Setting]) -> list[Setting]:
    """The two most important settings that apply to a scene."""
    known = (setting for setting in applicable if setting.key in MAIN_SETTINGS)
    return sorted(known, key=lambda setting: MAIN_SETTINGS.index(setting.key))[:2]


def dials_of(scene: Scene) -> list[Setting]:
    """The settings of a scene that have sliders; others are set by other controls."""
    return [setting for setting in settings_of(scene) if _has_dial(setting, scene)]


def _has_dial(setting: Setting, scene: Scene) -> bool:
    if setting.key == "rest_angle":
        return scene.template is None
    return setting.key != "dt" or not METHODS[scene.integrator.method].adaptive


class Board:
    """Sliders and lists of one page.

    Args:
        page: the page.
    """

    def __init__(self, page: Page) -> None:
        self._page = page
        self._sliders: list[SliderBox] = []
        self._choices: list[ChoiceBox] = []
        self._templates: list[viser.GuiDropdownHandle[str]] = []
        self._notes: list[MixedValuesNote] = []
        self._handles: list[Any] = []
        self._shown: Any = None

    def is_new(self, shown: object) -> bool:
        """Return True and remove all controls if it has to show something else.

        Otherwise they stay, since the user may be moving one.
        """
        if shown == self._shown:
            return False
        self._shown = shown
        for slider_box in self._sliders:
            slider_box.retire()
        for part in (*self._notes, *self._handles):  # a folder after its contents
            part.remove()
        for parts in (self._sliders, self._choices, self._templates, self._notes, self._handles):
            parts.clear()
        return True

    def add_handles(self, *handles: Any) -> None:
        """Remove other controls together with the sliders; pass a folder after its contents."""
        self._handles += handles

    def add_sliders(self, place: Place, settings: Sequence[Setting]) -> None:
        """Add sliders, from order 10 on, and below them a note on those whose parts have different values."""
        before = len(self._sliders)
        with place:
            for order, setting in enumerate(settings, start=10):
                if setting.key == "template":
                    self._add_templates(order)
                else:
                    self._add_slider(setting, order)
        gui, own = self._page.client.gui, self._sliders[before:]
        self._notes.append(MixedValuesNote(gui, place, own, 10.0 + len(settings)))

    def add_choices(self, place: Place, keys: Collection[str], order: float) -> None:
        """Add dropdown lists."""
        with place:
            for at, key in enumerate(keys):
                choice = ChoiceBox(self._page, key, order + at)
                self._choices.append(choice)
                self._handles.append(choice.handle)

    def _add_slider(self, setting: Setting, order: float) -> None:
        session = self._page.session

        def post(value: float) -> None:
            session.post(commands.SetValue(setting.key, round(value) if setting.integer else value))

        value = setting.read(session.scene)
        opened = session.opened
        own = setting.read(opened) if setting in settings_of(opened) else None
        slider_box = SliderBox(self._page.client, self._page.mail, setting, value, post, order, own)
        self._sliders.append(slider_box)
        self._handles.append(slider_box.slider)

    def _add_templates(self, order: float) -> None:
        names = tuple(f"{angle}°" for angle in TEMPLATES)
        choice = self._page.client.gui.add_dropdown(say("ui-templates"), names, order=order)
        self._templates.append(choice)
        self._handles.append(choice)

        def choose() -> None:
            if choice.value in names:
                self._page.session.post(commands.SetValue("template", float(choice.value.rstrip("°"))))

        on_change(choice, choose)

    @property
    def settled(self) -> bool:
        """True if all controls show the values of the solver."""
        return all(slider_box.settled for slider_box in self._sliders)

    def show(self, scene: Scene) -> None:
        """Show the values of a scene."""
        for slider_box in self._sliders:
            slider_box.show(scene)
        for note in self._notes:
            note.show()
        for choice in self._choices:
            choice.show(scene)
        for templates in self._templates:
            if scene.template is not None:
                templates.value = f"{scene.template}°"


class MixedValuesNote:
    """A note below sliders on those whose parts have different values; created when it is first needed.

    Args:
        gui: of the page.
        place: the tab or folder of the sliders.
        sliders: the sliders.
        order: its place there.
    """

    def __init__(self, gui: viser.GuiApi, place: Place, sliders: list[SliderBox], order: float) -> None:
        self._gui, self._place, self._sliders, self._order = gui, place, sliders, order
        self._note: viser.GuiHtmlHandle | None = None

    def show(self) -> None:
        """Update the text."""
        mixed = dict.fromkeys(mixed_words(box.setting) for box in self._sliders if box.mixed)
        words = " ".join(say("ui-mixed.note", what=each) for each in mixed)
        if self._note is None and words:
            with self._place:
                self._note = self._gui.add_html("", order=self._order)
        if self._note is not None:
            self._note.content = f'<div class="softrod-text">{words}</div>' if words else ""

    def remove(self) -> None:
        """Remove it from the page."""
        if self._note is not None:
            self._note.remove()
