"""A list from which a property of the scene is chosen, see `sim.settings.CHOICES`."""

from __future__ import annotations

from typing import Any

import viser

from sim.scene.types import Scene
from sim.settings import CHOICES

from ...session import commands
from ...session.session import Session


class ChoiceBox:
    """The list of one choice.

    Args:
        client: the page.
        session: what is told of the choice.
        key: of the choice.
        order: where it stands.

    Attributes:
        handle: viser's handle of it.
    """

    def __init__(self, client: viser.ClientHandle, session: Session, key: str, order: float) -> None:
        self._choice = CHOICES[key]
        options = self._choice.options
        self.handle = client.gui.add_dropdown(self._choice.label, tuple(options.values()), order=order)

        @self.handle.on_update
        async def _(event: viser.GuiEvent[Any]) -> None:
            chosen = [name for name, label in options.items() if label == self.handle.value]
            if event.client_id is not None and chosen:
                session.post(commands.SetChoice(key, chosen[0]))

    def show(self, scene: Scene) -> None:
        """Show what the scene has."""
        self.handle.value = self._choice.options[self._choice.read(scene)]
