"""What the address of a page asks for: the scene that is shown first, and the controls."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from sim.errors import InputError, SceneError
from sim.scene.types import Scene

from ...session.notices import Notice
from ...ui import controls
from ...ui.controls import Controls
from ...ui.opening import asked_scene
from ...words import say
from ...words.english import refusal
from .features import CONTROLS


class PageAddress:
    """The query of a page's address.

    Args:
        query: the query.
        notify: shows a notice to the page's user.

    Attributes:
        problem: why the scene cannot be shown, a sentence; empty if it can, or if none is asked for.
    """

    def __init__(self, query: str, notify: Callable[[Notice], None]) -> None:
        self.problem = ""
        self._query, self._notify = query, notify
        self._controls = self._checked(partial(controls.of_query, parts=CONTROLS), query)
        self._controls_of_scene = controls.ALL
        self._names: tuple[str, ...] | None = None

    def scene(self) -> Scene | None:
        """The scene that is asked for; None if none is, or if there is a `problem`."""
        try:
            return asked_scene(self._query)
        except SceneError as error:
            self.problem = refusal(error)
            return None

    def controls(self, scene: Scene) -> Controls:
        """The controls that the address names, or else those that a scene names."""
        if self._controls is None and scene.view.controls != self._names:
            self._names = scene.view.controls
            of_scene = self._checked(partial(controls.of_scene, parts=CONTROLS), scene)
            self._controls_of_scene = of_scene or controls.ALL
        return self._controls or self._controls_of_scene

    def _checked(self, find: Callable[[Any], Controls | None], source: Any) -> Controls | None:
        """The named controls; None, with a notice, if one of the names is unknown."""
        try:
            return find(source)
        except InputError as error:
            self._notify(Notice("error", say("ui-all-controls"), str(error)))
            return None
