"""A dropdown list for a property of the scene, see `sim.settings.CHOICES`."""

from __future__ import annotations

from sim.scene.types import Scene
from sim.settings import CHOICES

from ...session import commands
from ...words.settings import label_of_choice, options_of
from ..page import Page
from .handlers import on_change


class ChoiceBox:
    """The list of one property.

    Args:
        page: its page.
        key: of the property.
        order: its place in the tab.

    Attributes:
        handle: viser's handle of it.
    """

    def __init__(self, page: Page, key: str, order: float) -> None:
        self._choice = CHOICES[key]
        self._options = options = options_of(key)
        self.handle = page.client.gui.add_dropdown(label_of_choice(key), tuple(options.values()), order=order)

        def choose() -> None:
            for name, label in options.items():
                if label == self.handle.value:
                    page.session.post(commands.SetChoice(key, name))

        on_change(self.handle, choose)

    def show(self, scene: Scene) -> None:
        """Show the value of a scene."""
        self.handle.visible = self._choice.shown(scene)
        self.handle.value = self._options[self._choice.read(scene)]
