"""The Play tab but for its sliders: the scene, the switch to follow the pointer, a joint, the arrow pad."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser

from sim.scene.types import Scene, shown_name

from ..session import commands
from ..session.session import Session
from .controls import Controls
from .looks import readouts

LAST = 1e6
"""Order of what stands below the sliders, which come and go."""


class PlayPanel:
    """The controls of one page's Play tab; made inside the tab.

    Args:
        client: the page.
        session: its simulation.
        perform: does a command of the table.
        controls: which there are.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        session: Session,
        perform: Callable[[str], None],
        controls: Controls,
    ) -> None:
        self._session = session
        self._perform = perform
        self._edits_texts = "edit" in controls
        self._chooser = self._about = self._follow = self._readout = self._pad = None
        gui = client.gui
        if "chooser" in controls:
            hint = "choose another scene (key O)"
            icon = viser.Icon.LAYOUT_GRID
            self._chooser = gui.add_button("Scene", icon=icon, color="gray", hint=hint, order=1)
            hint = "open this scene anew"  # it stands beside the chooser, see widgets.js
            icon = viser.Icon.REFRESH
            anew = gui.add_button("Open anew", icon=icon, color="gray", hint=hint, order=1.5)
            self._listen_to(self._chooser, "gallery")
            self._listen_to(anew, "anew")
        if "about" in controls:
            self._about = gui.add_html("", order=2)
        # Between them are the sliders that make most of the scene.
        if "follow" in controls:
            self._follow = gui.add_checkbox("Follow pointer", initial_value=False, hint="key F", order=LAST)
            self._listen_to_switch(self._follow)
        if "angle" in controls:
            self._readout = gui.add_html("", order=LAST + 1)
        if "keys" in controls:
            self._pad = gui.add_html(readouts.PAD, visible=False, order=LAST + 2)

    def _listen_to(self, button: viser.GuiButtonHandle, command: str) -> None:
        @button.on_click
        async def _(_: object) -> None:
            self._perform(command)

    def _listen_to_switch(self, follow: viser.GuiCheckboxHandle) -> None:
        @follow.on_update
        async def _(event: viser.GuiEvent[Any]) -> None:
            if event.client_id is not None:
                self._session.post(commands.Follow(bool(follow.value)))

    def build(self, scene: Scene) -> None:
        """Show what the scene has."""
        if self._chooser is not None:
            self._chooser.label = shown_name(scene)
        if self._about is not None:
            self._about.content = readouts.description(scene, self._edits_texts)
        if self._pad is not None:
            self._pad.visible = scene.arrow_keys is not None
        if self._follow is not None:
            self._follow.visible = self._session.driven is not None

    def refresh_controls(self) -> None:
        """Show in the switch what keys or commands changed."""
        if self._follow is not None and self._follow.value != self._session.follow:
            self._follow.value = self._session.follow

    def refresh_readouts(self) -> None:
        """Show the angle as it is now."""
        if self._readout is not None:
            content = readouts.joint_table(self._session)
            if self._readout.content != content:
                self._readout.content = content
