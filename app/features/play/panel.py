"""The Play tab except for its sliders: scene, switch to follow the pointer, a joint's angle."""

from __future__ import annotations

from functools import partial

import viser

from sim.scene.types import Scene

from ...session import commands
from ...ui import readouts
from ...ui.page import Page
from ...ui.viser.handlers import on_change
from ...ui.viser.look import describe_control
from ...words import say
from ...words.english import name_of
from ..gallery.thumbnails import MADE

LAST = 1e6
"""Order of what stands below the sliders, which come and go."""


class PlayPanel:
    """The controls of one page's Play tab; made inside the tab.

    Args:
        page: whose body it is about.
    """

    def __init__(self, page: Page) -> None:
        self._mail, self._session = page.mail, page.session
        session = page.session
        controls, gui = page.controls, page.client.gui
        self._edits_texts = "edit" in controls
        self._chooser = self._about = self._follow = self._readout = None
        if "chooser" in controls:
            hint = say("play-scene.hint")
            icon, press = viser.Icon.LAYOUT_GRID, partial(page.perform, "gallery")
            self._chooser = page.button(say("play-scene"), icon, press, hint=hint, order=1)
            press = partial(page.perform, "anew")
            again = page.button(
                say("play-anew"), viser.Icon.REFRESH, press, hint=say("play-anew.hint"), order=1.5
            )
            describe_control(page.mail, again, place="beside")
        if "about" in controls:
            self._about = gui.add_html("", order=2)
            describe_control(page.mail, self._about, place="below")
        # Between them are the sliders that make most of the scene.
        if "follow" in controls:
            follow = gui.add_checkbox(
                say("play-follow"), initial_value=False, hint=say("play-follow.hint"), order=LAST
            )
            on_change(follow, lambda: session.post(commands.Follow(follow.value)))
            self._follow = follow
        if "angle" in controls and "measure" not in controls:  # it stands in the Measure tab
            self._readout = gui.add_html("", order=LAST + 1)

    def build(self, scene: Scene) -> None:
        """Show what the scene has."""
        if self._chooser is not None:
            self._chooser.label = name_of(scene)
            picture = scene.name if scene.name in MADE else ""
            note = say("play-scene.note")
            describe_control(self._mail, self._chooser, place="card", note=note, picture=picture)
        if self._about is not None:
            self._about.content = readouts.description(scene, self._edits_texts)
        if self._follow is not None:
            self._follow.visible = self._session.driven is not None

    def refresh_controls(self) -> None:
        """Update the switch after keys or commands."""
        if self._follow is not None:
            self._follow.value = self._session.follow

    def refresh_readouts(self) -> None:
        """Show the present angle."""
        if self._readout is not None:
            self._readout.content = readouts.joint_table(self._session)
