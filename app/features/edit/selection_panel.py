"""The numbers of the selection, in a folder above the tabs that is shown while anything is selected."""

from __future__ import annotations

import math
import re
import time
from collections.abc import Callable, Collection
from dataclasses import dataclass
from typing import Any

import viser

from sim import Moment, Scene
from sim.edit.build import pin, remove
from sim.edit.edit import Edit, Selection
from sim.edit.values import (
    NUMBERS,
    STARTS,
    WAYS,
    Kind,
    Number,
    acting,
    middle_of_starts,
    number,
    scale_number,
    set_number,
    set_start,
    set_way,
    take_as_rest,
    values_of,
    ways_of,
)

from ...session import commands
from ...ui.page import Page
from ...ui.viser.handlers import on_change
from ...ui.viser.look import describe_control
from ...ui.viser.slider_box import TOUCHED, alike, allows, range_of, rounded
from ...words import find, joined, say
from ...words.keys import Key

EVERY = 0.1
"""Seconds between two updates of the numbers; held arrow keys change some of them continually."""

ORDER = -100.0
"""Order of the folder in the panel: above the tabs."""

MIXED: Key = "number-mixed"
"""What is said where selected parts have different values, or act in several ways."""

MIDDLE: Key = "number-middle"
"""What is said of a start position that is the middle of several."""


@dataclass(frozen=True)
class Shown:
    """A number of the selection.

    Attributes:
        of: what it is.
        value: the common value, or the one with the largest magnitude; of positions, their middle.
        note: `MIXED` if the values differ, `MIDDLE` of positions; None elsewhere.
    """

    of: Number
    value: float
    note: Key | None = None


def numbers_of(scene: Scene, selection: Selection) -> list[Shown]:
    """Return the numbers that any selected part has."""
    masses = selection.masses
    found = [
        Shown(of, middle_of_starts(scene, of, masses), MIDDLE if len(masses) > 1 else None)
        for of in (STARTS if masses else ())
    ]
    for of in NUMBERS:
        parts = parts_of(selection, of.kind)
        values = values_of(scene, of, parts)
        known = [value for value in values if value is not None]
        if not known or (of.field == "hardening" and values_of(scene, _YIELD_FORCE, parts) <= {None}):
            continue  # hardening has no meaning without a yield force
        found.append(Shown(of, max(known, key=abs), MIXED if len(values) > 1 else None))
    return found


_YIELD_FORCE = number("linear_springs", "yield_force")
_ALL = (*STARTS, *NUMBERS)
_OF_MUSCLES = tuple(of for of in NUMBERS if "." in of.field)
"""Of muscles and motors; their boxes are created when one is selected for the first time."""


_COUNTED: tuple[Key, ...] = "edit-masses", "edit-springs", "edit-joints"
_PREFIXES: dict[Kind, str] = {"masses": "", "linear_springs": "spring-", "angular_springs": "joint-"}


def parts_of(selection: Selection, kind: Kind) -> Collection[int]:
    """Return the selected parts of a kind."""
    return selection[("masses", "linear_springs", "angular_springs").index(kind)]


def describe(selection: Selection) -> str:
    """Describe a selection, as in "2 masses, 3 springs"."""
    kinds = zip(selection, _COUNTED, strict=True)
    return joined(say(key, count=len(parts)) for parts, key in kinds if parts)


def label_of(of: Number) -> str:
    """Return what a number is called."""
    axis = "" if of.axis is None else f"-{'xy'[of.axis]}"
    field = re.sub("[._]", "-", of.field)
    return find(f"number-{_PREFIXES[of.kind]}{field}{axis}")


def label_of_way(key: str) -> str:
    """Return what one of `WAYS` is called."""
    return find(f"way-{_dashed(key)}")


def options_of(key: str) -> dict[str, str]:
    """Return what the choices of one of `WAYS` are called."""
    return {name: find(f"way-{_dashed(key)}.{_dashed(name) or 'usual'}") for name in WAYS[key].words}


def _dashed(name: str) -> str:
    return name.replace(" ", "-")


def make_change(of: Number, value: float, in_proportion: bool) -> commands.MakeEdit:
    """Return an edit that sets a number of all selected parts, or scales it so that the largest has it."""

    def make(moment: Moment, selection: Selection) -> Edit:
        parts = parts_of(selection, of.kind)
        if of in STARTS:
            return set_start(moment.scene, of, parts, value) if parts else Edit("", moment.scene)
        scales = in_proportion and len(values_of(moment.scene, of, parts)) > 1
        if not parts or (scales and value == 0.0):  # typing 0.5 begins with 0, which has no proportions
            return Edit("", moment.scene)
        change = scale_number if scales else set_number
        return change(moment.scene, of, parts, value, moment.rest_angle_shift)

    return make


class SelectionPanel:
    """The folder of one page; it is created when anything is selected for the first time.

    Args:
        page: the page.
    """

    def __init__(self, page: Page) -> None:
        self._page, self._client, self._session = page, page.client, page.session
        self._selection = None if any(self._session.selection) else self._session.selection
        self._scene: Scene | None = None
        self._due = -math.inf
        self._folder: viser.GuiFolderHandle | None = None
        self._rows: list[_Row] = []

    # --------------------------------------------------------------------- the ticker's
    def tick(self) -> None:
        """Show the selection if it has changed, and its present numbers."""
        selection, now = self._session.selection, self._session.now()
        is_new = selection is not self._selection
        if not is_new and (now < self._due or not any(selection)):
            return
        self._due, self._selection = now + EVERY, selection
        if self._folder is None and not any(selection):
            return
        with self._client.atomic():
            folder = self._folder = self._folder or self._make_folder()
            if any(selection):
                self._show(folder, selection, is_new)
            else:
                folder.visible = False

    def _show(self, folder: viser.GuiFolderHandle, selection: Selection, is_new: bool) -> None:
        scene = self._session.scene
        if is_new or scene is not self._scene:
            self._scene = scene
            shown = {each.of: each for each in numbers_of(scene, selection)}
            known = {row.of for row in self._rows}
            if known.isdisjoint(_OF_MUSCLES) and not shown.keys().isdisjoint(_OF_MUSCLES):
                with folder:
                    self._rows += map(self._row, _OF_MUSCLES)
                    self._ways += [_Way(self._page, way) for way in WAYS if way in _OF_MUSCLE_WAYS]
            for row in self._rows:
                row.take(shown.get(row.of), is_new)
            for way in self._ways:
                way.take(scene, selection)
            self._proportions.visible = any(each.note == MIXED for each in shown.values())
            self._holding.visible = bool(selection.masses)
            folder.label = describe(selection)
            folder.visible = True
        for row in self._rows:
            row.show()

    # --------------------------------------------------------------------- created once
    def _make_folder(self) -> viser.GuiFolderHandle:
        gui, post = self._client.gui, self._session.post
        folder = gui.add_folder("", order=ORDER)
        with folder:
            self._rows = [self._row(of) for of in _ALL if of not in _OF_MUSCLES]
            self._ways = [_Way(self._page, way) for way in WAYS if way not in _OF_MUSCLE_WAYS]
            self._proportions = gui.add_checkbox(
                say("number-proportions"), initial_value=False, hint=say("number-proportions.hint")
            )
            held = say("number-holding.pin")
            self._holding = gui.add_button_group(say("number-holding"), (held, say("number-holding.release")))
            rest = commands.Change(take_as_rest)
            hint = say("number-rest.hint")
            self._page.button(say("number-rest"), viser.Icon.RULER_2, lambda: post(rest), hint=hint)
            delete = commands.Change(lambda moment, selected: remove(moment.scene, selected))
            self._page.button(say("number-delete"), viser.Icon.TRASH, lambda: post(delete))

        @self._holding.on_click
        async def _(event: viser.GuiEvent[Any]) -> None:
            on = event.target.value == held
            post(commands.Change(lambda moment, selected: pin(moment.scene, selected.masses, on)))

        return folder

    def _row(self, of: Number) -> _Row:
        return _Row(self._page, of, self._set, ORDER + _ALL.index(of))

    def _set(self, of: Number, value: float) -> None:
        """Set a number; consecutive values of one number of the same parts are one step of undo."""
        change = make_change(of, value, bool(self._proportions.value))
        key = f"{of.kind}.{of.field}.{of.axis} {hash(self._session.selection)}"
        self._session.post(commands.Change(change, key))


_OF_MUSCLE_WAYS = "muscles", "joint muscles"


class _Way:
    """A choice of how the selected masses, springs or joints act.

    Args:
        page: the page.
        key: of one of `WAYS`.
    """

    def __init__(self, page: Page, key: str) -> None:
        self._way = way = WAYS[key]
        self._words = options_of(key)
        self._box = page.client.gui.add_dropdown(
            label_of_way(key), tuple(self._words.values()), visible=False, order=ORDER + len(_ALL),
            hint=find(f"way-{_dashed(key)}.hint"),
        )  # fmt: skip

        def choose() -> None:
            name = next((name for name, words in self._words.items() if words == self._box.value), None)
            if name is not None:
                page.session.post(
                    commands.Change(
                        lambda moment, selection: set_way(
                            moment.scene, way, parts_of(selection, way.kind), name
                        )
                    )
                )

        on_change(self._box, choose)

    def take(self, scene: Scene, selection: Selection) -> None:
        """Show how the selected parts act."""
        parts = acting(scene, self._way, parts_of(selection, self._way.kind))
        self._box.visible = bool(parts)
        if parts:
            ways, words = ways_of(scene, self._way, parts), tuple(self._words.values())
            mixed = say(MIXED)
            shown = mixed if len(ways) > 1 else self._words[max(ways)]
            options = (mixed, *words) if len(ways) > 1 else words
            if self._box.options != options:
                self._box.options = options
            self._box.value = shown


class _Row:
    """A box for one number."""

    def __init__(
        self,
        page: Page,
        of: Number,
        post: Callable[[Number, float], None],
        order: float,
    ) -> None:
        self.of = of
        self._shown: Shown | None = None
        self._touched = -math.inf
        self._box = page.client.gui.add_number(
            label_of(of), initial_value=0.0, step=0.1, hint=range_of(of), visible=False, order=order
        )
        describe_control(page.mail, self._box, unit=of.unit, low=of.low, high=of.high)

        def enter() -> None:
            value = self._box.value
            if allows(of, value):
                self._touched = time.monotonic()
                post(self.of, value)
            elif self._shown is not None:
                self._box.value = rounded(self._shown.value)

        on_change(self._box, enter)

    def take(self, shown: Shown | None, is_new: bool) -> None:
        """Set the number to show, or none; that of a new selection replaces what is being typed."""
        self._shown = shown
        self._box.visible = shown is not None
        if shown is None:
            return
        label = label_of(self.of)
        self._box.label = say("number-note", number=label, note=say(shown.note)) if shown.note else label
        if is_new:
            self._touched = -math.inf
            size = abs(shown.value)
            self._box.step = 10.0 ** (math.floor(math.log10(size)) - 1) if size > 1e-6 else 0.1

    def show(self) -> None:
        """Show the present value, unless the user is typing."""
        if self._shown is None:
            return
        value, now = rounded(self._shown.value), self._box.value
        if self._shown.note == MIXED:
            # viser drops a typed number that the box has already, and here other parts have other ones.
            value = math.nextafter(value, math.inf)
            differs = now != value
        else:
            differs = not alike(now, value)
        if differs and time.monotonic() - self._touched >= TOUCHED:
            self._box.value = value
