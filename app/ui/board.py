"""Sliders of settings and lists of choices, one below the other, as the scene has a use for them."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any

import viser

from sim.methods.registry import METHODS
from sim.scene.types import Scene
from sim.settings import TEMPLATES, Setting, settings_of

from ..session import commands
from .page import Page
from .viser.choice_box import ChoiceBox
from .viser.handlers import on_change
from .viser.slider_box import SliderBox, mixed_words

FOREMOST = (
    "tempo", "wind_speed", "gas_pressure", "pressure", "liquid_stiffness", "bulk_modulus", "load", "strength",
    "yield_force", "rest_angle", "template", "bend", "angular_stiffness", "linear_stiffness", "gravity",
)  # fmt: skip
"""Settings that make most of a scene, in order; the first two that there is a use for stand at the top."""

Place = viser.GuiTabHandle | viser.GuiFolderHandle


def foremost(applicable: list[Setting]) -> list[Setting]:
    """Of the settings that a scene has, the two that make most of it."""
    known = (setting for setting in applicable if setting.key in FOREMOST)
    return sorted(known, key=lambda setting: FOREMOST.index(setting.key))[:2]


def dials_of(scene: Scene) -> list[Setting]:
    """The settings of a scene that have sliders; some are set by others."""
    return [setting for setting in settings_of(scene) if _has_dial(setting, scene)]


def _has_dial(setting: Setting, scene: Scene) -> bool:
    if setting.key == "rest_angle":
        return scene.template is None
    return setting.key != "dt" or not METHODS[scene.integrator.method].adaptive


class Board:
    """Sliders and lists of one page.

    Args:
        page: whose scene they set.
    """

    def __init__(self, page: Page) -> None:
        self._page = page
        self._sliders: list[SliderBox] = []
        self._choices: list[ChoiceBox] = []
        self._templates: list[viser.GuiDropdownHandle[str]] = []
        self._notes: list[_MixedNote] = []
        self._handles: list[Any] = []
        self._shown: Any = None

    def is_new(self, shown: object) -> bool:
        """Whether it has to show something else than before; then it is empty from here on.

        What stays is kept: its user may be in the middle of moving it.
        """
        if shown == self._shown:
            return False
        self._shown = shown
        for slider_box in self._sliders:
            slider_box.retire()
        for part in (*self._notes, *self._handles):  # a folder comes after what is in it
            part.remove()
        for parts in (self._sliders, self._choices, self._templates, self._notes, self._handles):
            parts.clear()
        return True

    def keep(self, *handles: Any) -> None:
        """Take other controls away with the sliders; those of a folder are before the folder."""
        self._handles += handles

    def add_sliders(self, place: Place, settings: Sequence[Setting]) -> None:
        """Sliders, from order 10 on, and below them a note on those whose parts have different numbers."""
        before = len(self._sliders)
        with place:
            for order, setting in enumerate(settings, start=10):
                if setting.key == "template":
                    self._add_templates(order)
                else:
                    self._add_slider(setting, order)
        gui, own = self._page.client.gui, self._sliders[before:]
        self._notes.append(_MixedNote(gui, place, own, 10.0 + len(settings)))

    def add_choices(self, place: Place, keys: Collection[str], order: float) -> None:
        """Lists of choices."""
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
        slider_box = SliderBox(self._page.client, setting, value, post, self._page.notify, order)
        self._sliders.append(slider_box)
        self._handles += [slider_box.slider, slider_box.box]

    def _add_templates(self, order: float) -> None:
        names = tuple(f"{angle}°" for angle in TEMPLATES)
        choice = self._page.client.gui.add_dropdown("Angle template", names, order=order)
        self._templates.append(choice)
        self._handles.append(choice)

        def choose() -> None:
            if choice.value in names:
                self._page.session.post(commands.SetValue("template", float(choice.value.rstrip("°"))))

        on_change(choice, choose)

    @property
    def settled(self) -> bool:
        """Whether all of it shows what is set."""
        return all(slider_box.settled for slider_box in self._sliders)

    def show(self, scene: Scene) -> None:
        """Show what keys, commands or other controls have changed."""
        for slider_box in self._sliders:
            slider_box.show(scene)
        for note in self._notes:
            note.show()
        for choice in self._choices:
            choice.show(scene)
        for templates in self._templates:
            if scene.template is not None:
                templates.value = f"{scene.template}°"


class _MixedNote:
    """Says below some sliders what those do whose parts have different numbers; it is made when one does.

    Args:
        gui: of the page.
        place: where the sliders stand.
        sliders: those that it is about.
        order: where it stands.
    """

    def __init__(self, gui: viser.GuiApi, place: Place, sliders: list[SliderBox], order: float) -> None:
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
