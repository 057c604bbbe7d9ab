"""What the features of one page share."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeVar

import msgspec
import viser

from sim.design.measurements import Measurement
from sim.scene.lesson import Lesson
from sim.scene.types import Scene

from ..session.notices import Notice
from ..session.plots import PlotSpec
from ..session.session import Refresh, Session
from ..stage import sketch
from ..wire.carrier import Mail
from .commands import Row
from .controls import ALL, Controls
from .kept.keeping import DEFAULT_LOOKS, Looks
from .queues import BoundedQueue
from .shelf import Shelf
from .viser.decimal_commas import DecimalCommas
from .viser.handlers import on_press

_F = TypeVar("_F")


class Plots(Protocol):
    """A list of plots, as other parts of the page use it."""

    looked_at: bool
    played_at: float

    @property
    def played(self) -> int:
        """The one that was played last as sound, at `played_at`; -1 for none."""
        ...

    @property
    def specs(self) -> tuple[PlotSpec, ...]:
        """The open plots."""
        ...

    @property
    def wants_energy(self) -> bool:
        """True if one of them shows the energy balance."""
        ...

    def __len__(self) -> int: ...

    def play(self, index: int) -> None:
        """Play one of them as sound."""

    def turn_live(self, index: int) -> None:
        """Hear one of them while the body moves, or no longer."""

    def fall_silent(self) -> None:
        """Hear none of them while the body moves."""


@dataclass
class Page:
    """A page, as its features use it.

    Attributes:
        client: viser's handle of it.
        session: its simulation.
        mail: sends messages to its script.
        notify: shows a notice to its user.
        perform: executes a command of the table.
        shelf: its scenes.
        commands: the table of commands.
        controls: its controls; others are not created.
        looks: how it looks.
        mapping: converts between the scene and the page's world.
        commas: whether its tables have decimal commas.
        plots: its lists of plots.
        features: its features; see `find`.
        soon: has the ticker call a function before the next frame; any thread may ask.
        is_in_class: it belongs to a class.
        makes_lesson: the scene's lesson is being edited, and not shown meanwhile.
        is_closed: returns True if a lesson must not be shown, since a class goes through it.
        begin_class: begins a class with a scene, and returns the address of the teacher's page; None if
            others cannot reach the server. Called by the ticker; raises `Refused`.
        for_others: converts the address of the page into one by which others reach it.
        take_tables: offers to fit the scene to tables of measurements; None if the page cannot. Called by the
            ticker.
    """

    client: viser.ClientHandle
    session: Session
    mail: Mail
    notify: Callable[[Notice], None]
    perform: Callable[[str], None]
    shelf: Shelf
    commands: Mapping[str, Row] = field(default_factory=dict)
    controls: Controls = ALL
    looks: Looks = DEFAULT_LOOKS
    plots: list[Plots] = field(default_factory=list)
    features: tuple[object, ...] = ()
    soon: Callable[[Callable[[], object]], object] = lambda act: act()
    makes_lesson: bool = False
    is_in_class: bool = False
    is_closed: Callable[[Lesson], bool] = lambda _: False
    begin_class: Callable[[Scene], str] | None = None
    for_others: Callable[[str], str] = str
    take_tables: Callable[[tuple[Measurement, ...]], None] | None = None
    mapping: sketch.Mapping = field(init=False)
    commas: DecimalCommas = field(init=False)
    _requests: BoundedQueue[Callable[[], object]] = field(init=False)

    def __post_init__(self) -> None:
        self.mapping = sketch.Mapping.of(self.session.scene)
        self.commas = DecimalCommas(self._set_commas)
        self._requests = BoundedQueue(self.notify)

    @property
    def has_lesson(self) -> bool:
        """True if a lesson is shown."""
        lesson = self.session.scene.lesson
        return lesson is not None and not self.makes_lesson and not self.is_closed(lesson)

    def find(self, kind: type[_F]) -> _F | None:
        """Find one of its features by its class; None without one."""
        return next((feature for feature in self.features if isinstance(feature, kind)), None)

    def later(self, act: Callable[[], object]) -> None:
        """Have the ticker call a function for a control before the next frame; any thread may ask.

        It is dropped if the control is removed, see `clear`; `soon` is for other callers.
        """
        self._requests.add(act)

    @property
    def has_requests(self) -> bool:
        """True if a control has asked for something."""
        return len(self._requests) > 0

    def serve(self) -> None:
        """Call the functions that controls have asked for; called by the ticker."""
        while self._requests:
            self._requests.take()()

    def clear(self) -> None:
        """Forget all controls, which have been removed, and what they have asked for."""
        self._requests.clear()
        self.plots.clear()
        self.take_tables = None
        self.commas.clear()

    def _set_commas(self, on: bool) -> None:
        self.soon(lambda: self.set_look("commas", on))

    def set_look(self, look: str, on: bool) -> None:
        """Turn one of the looks on or off from the next frame on; called by the ticker."""
        self.looks = msgspec.structs.replace(self.looks, **{look: on})
        self.commas.show(self.looks.commas)
        self.session.refresh(Refresh.SETTINGS)

    # --------------------------------------------------------------------- controls
    def button(
        self,
        label: str,
        icon: viser.IconName,
        press: Callable[[], None],
        blocks: bool = False,
        **options: Any,
    ) -> viser.GuiButtonHandle:
        """Add a secondary button; see `on_press`."""
        made = self.client.gui.add_button(label, icon=icon, color="gray", **options)
        on_press(made, press, blocks)
        return made
