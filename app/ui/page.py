"""What the panels of one page have in common."""

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
from ..session.plots import Wish
from ..session.session import Changed, Session
from ..stage import sketch
from ..wire.carrier import Mail
from .commands import Row
from .controls import ALL, Controls
from .kept.keeping import DEFAULT_LOOKS, Looks
from .queues import BoundedQueue
from .shelf import Shelf
from .viser.comma_switch import CommaSwitch
from .viser.handlers import on_press

_F = TypeVar("_F")


class Plots(Protocol):
    """A list of plots, as others see it."""

    looked_at: bool

    @property
    def wishes(self) -> tuple[Wish, ...]:
        """What is plotted."""
        ...

    @property
    def wants_energy(self) -> bool:
        """Whether one of them is of the energy balance."""
        ...


@dataclass
class Page:
    """A page, as its panels see it.

    Attributes:
        client: viser's handle of it.
        session: its simulation.
        mail: to its script.
        notify: tells its user something.
        perform: does a command of the table.
        shelf: its scenes.
        commands: the whole table of them.
        controls: which it has; what there is not is not made.
        looks: how it looks.
        mapping: from the scene to the page's world and back.
        commas: whether its tables have decimal commas.
        plots: its lists of plots.
        features: what it can do; see `find`.
        soon: has the ticker do something before the next frame; any thread may ask.
        is_in_class: whether it is a page of a class.
        makes_lesson: whether the scene's lesson is being made; it is not shown meanwhile.
        is_closed: whether a lesson is not to be seen here, since a class goes through it.
        begin_class: begins a class with a scene, and returns the address of the teacher's page, from this
            page's; None where others cannot reach the server. The ticker's; raises `Refused`.
        for_others: the address by which others reach the page, from that by which it was reached itself.
        take_tables: offers to fit the scene to a table of what was measured; None where there is no place for
            that. The ticker's.
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
    commas: CommaSwitch = field(init=False)
    _asked: BoundedQueue[Callable[[], object]] = field(init=False)

    def __post_init__(self) -> None:
        self.mapping = sketch.Mapping.of(self.session.scene)
        self.commas = CommaSwitch(self._set_commas)
        self._asked = BoundedQueue(self.notify)

    @property
    def has_lesson(self) -> bool:
        """Whether a lesson is shown."""
        lesson = self.session.scene.lesson
        return lesson is not None and not self.makes_lesson and not self.is_closed(lesson)

    def find(self, kind: type[_F]) -> _F | None:
        """One of its features, by its class; None if it is not there."""
        return next((feature for feature in self.features if isinstance(feature, kind)), None)

    def later(self, act: Callable[[], object]) -> None:
        """Have the ticker do something that a control asks for, before the next frame; any thread may ask.

        It is forgotten with the control, see `clear`; `soon` is for what is not a control's.
        """
        self._asked.add(act)

    @property
    def is_asked(self) -> bool:
        """Whether there is something for the ticker to do."""
        return len(self._asked) > 0

    def serve(self) -> None:
        """Do what was asked for; the ticker's."""
        while self._asked:
            self._asked.take()()

    def clear(self) -> None:
        """All controls are gone: forget them, and what was asked by them."""
        self._asked.clear()
        self.plots.clear()
        self.take_tables = None
        self.commas.clear()

    def _set_commas(self, on: bool) -> None:
        self.soon(lambda: self.set_look("commas", on))

    def set_look(self, look: str, on: bool) -> None:
        """Turn one of the looks on or off; the ticker's. The page shows it with the next frame."""
        self.looks = msgspec.structs.replace(self.looks, **{look: on})
        self.commas.show(self.looks.commas)
        self.session.note(Changed.SETTINGS)

    # --------------------------------------------------------------------- controls
    def button(
        self,
        label: str,
        icon: viser.IconName,
        press: Callable[[], None],
        blocks: bool = False,
        **options: Any,
    ) -> viser.GuiButtonHandle:
        """A button that is not the first thing to press; see `on_press`."""
        made = self.client.gui.add_button(label, icon=icon, color="gray", **options)
        on_press(made, press, blocks)
        return made
