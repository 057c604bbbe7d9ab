"""The Play tab: the scene, the sliders that make most of it, and all other numbers of the body."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, ClassVar

import viser

from sim.settings import CHOICES, Setting

from ...session import commands
from ...session.session import Session
from ...ui.board import Board, dials_of, main_settings
from ...ui.commands import Row
from ...ui.feature import Feature
from ...ui.page import Page
from ...words import say
from .panel import LAST, PlayPanel

if TYPE_CHECKING:
    from ...ui.panel import Panel

ELSEWHERE = ("dt", "tolerance")
"""Settings whose sliders stand in the Solver tab."""

BODY_CHOICES = ("air_law", "restitution", "grip")
"""Choices whose lists stand below the sliders of the body."""


def _follow(session: Session, _: Feature) -> None:
    session.post(commands.Follow(not session.follow))


class PlayFeature(Feature):
    """The Play tab of a page, if it has any of its controls."""

    commands: ClassVar = {
        "follow": Row(_follow, ("F",)),
        "ownBody": Row(commands.RestoreSceneValues("body")),
    }
    controls: ClassVar = {
        "about": "what the scene shows, in words",
        "follow": "the switch that has the ringed mass follow the pointer",
        "angle": "the table of the joint's angle, in the Measure tab if there is one",
        "keys": "the arrow pad over the canvas of a touch screen",
        "body": "the sliders of all other numbers of the body",
    }

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._tab: viser.GuiTabHandle | None = None
        self._panel: PlayPanel | None = None
        self._board = Board(page)

    def attach(self, panel: Panel) -> None:
        """See `Feature`."""
        self._tab, self._panel, self._board = None, None, Board(self.page)
        if self.page.controls.in_play_tab:
            self._tab = panel.tab("Play")
            with self._tab:
                self._panel = PlayPanel(self.page)

    def build(self) -> None:
        """See `Feature`."""
        if self._tab is None or self._panel is None:
            return
        scene = self.session.scene
        self._panel.build(scene)
        dials = dials_of(scene)
        choices = [key for key in BODY_CHOICES if CHOICES[key].applies(scene)]
        if not self._board.is_new((dials, choices)):
            return
        named = self.page.controls.named_settings(dials)
        first = main_settings(dials) if named is None else named
        self._board.add_sliders(self._tab, first)
        if "body" in self.page.controls:
            others = [dial for dial in dials if dial not in first and dial.key not in ELSEWHERE]
            self._add_numbers(self._tab, others, choices, moves=bool(dials))

    def _add_numbers(
        self, tab: viser.GuiTabHandle, others: list[Setting], choices: list[str], moves: bool
    ) -> None:
        """Add the other sliders of the body, and its lists, in a folder.

        Args:
            tab: where that stands.
            others: what the sliders set.
            choices: keys of the choices that the scene has.
            moves: whether the body has any slider.
        """
        gui = self.page.client.gui
        with tab:
            if not moves:
                nothing = say("play-held.edit") if "edit" in self.page.controls else say("play-held")
                self._board.add_handles(
                    gui.add_html(f'<div class="softrod-text">{html.escape(nothing)}</div>', order=LAST + 3)
                )
                return
            folder = gui.add_folder(say("play-more"), order=LAST + 3, expand_by_default=False)
        self._board.add_sliders(folder, others)
        self._board.add_choices(folder, choices, LAST - len(BODY_CHOICES))
        with folder:
            own_values = self.page.button(
                say("play-own"),
                viser.Icon.RESTORE,
                lambda: self.session.post(commands.RestoreSceneValues("body")),
                order=LAST,
            )
        self._board.add_handles(own_values, folder)

    @property
    def unsettled(self) -> bool:
        """See `Feature`."""
        return not self._board.settled

    def refresh(self) -> None:
        """See `Feature`."""
        if self._panel is not None:
            self._panel.refresh_controls()
            self._board.show(self.session.scene)
            self._panel.refresh_readouts()
