"""Controls and pages without a browser, for tests."""

from __future__ import annotations

import asyncio
import inspect
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from functools import partial
from types import SimpleNamespace
from typing import Any
from unittest.mock import MagicMock

import msgspec
import viser

from app.session.notices import Notice
from app.session.session import Session
from app.ui.page import Page
from app.ui.shelf import Shelf
from app.viser_inside import SoftrodMessage
from app.wire.carrier import Letter
from app.wire.messages import FromPage
from tests.app.letters import Letters


class Handle:
    """A control, or a place for controls, that is in no page."""

    gui: Gui
    place: Handle | None

    def __init__(self, **fields: Any) -> None:
        vars(self).update(fields)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(name)

    def __enter__(self) -> None:
        self.gui.inside.append(self)

    def __exit__(self, *_: object) -> None:
        self.gui.inside.pop()

    def listen(self, handler: Callable[[Any], Any]) -> Callable[[Any], Any]:
        self.handler = handler
        return handler

    on_update = on_click = on_trigger = listen

    def enter(self, value: object = None) -> None:
        """Set or press it, as its user does."""
        self.value = value
        waits = self.handler(SimpleNamespace(client_id=1, target=self))
        if inspect.isawaitable(waits):
            asyncio.run(_done(waits))

    def add_tab(self, label: str) -> Handle:
        """A tab of this group."""
        return self.gui.add("tab", self, label)

    @property
    def is_shown(self) -> bool:
        """Whether it is in the page, and can be seen once its tab is turned to."""
        return self in self.gui.there and self.visible and (self.place is None or self.place.is_shown)

    def remove(self) -> None:
        """Take it out of the page, with all that is in it."""
        self.gui.there = [one for one in self.gui.there if one is not self and not one.is_in(self)]

    def is_in(self, place: Handle) -> bool:
        """Whether it stands in a tab or a folder."""
        return self.place is place or (self.place is not None and self.place.is_in(place))


async def _done(waits: Any) -> None:
    await waits


class Gui:
    """A panel in no page.

    Attributes:
        there: the controls that have been added and not removed, in that order.
        inside: the tabs and folders that controls are being added to, the innermost last.
    """

    def __init__(self) -> None:
        self.there: list[Handle] = []
        self.inside: list[Handle] = []
        self.main_panel = MagicMock()
        self.configure_theme = self.set_panel_label = MagicMock()

    def __getattr__(self, name: str) -> Callable[..., Handle]:
        if not name.startswith("add_"):
            raise AttributeError(name)
        return partial(self.add, name.removeprefix("add_"), None)

    def add(self, kind: str, place: Handle | None, label: str = "", *more: Any, **rest: Any) -> Handle:
        """Add a control; its label is what viser's first argument is, as the content of a text."""
        options = tuple(more[0]) if kind in ("dropdown", "button_group") else ()
        value = rest.pop("initial_value", options[0] if options else None)
        words = {"name": label, "label": label, "content": label}
        fields = {
            **words,
            "value": value,
            "options": options,
            "handler": lambda _: None,
            "visible": kind != "command",
            **rest,
        }
        place = place or (self.inside[-1] if self.inside else None)
        self.there.append(
            Handle(
                gui=self,
                kind=kind,
                place=place,
                _impl=SimpleNamespace(uuid=f"{len(self.there)}-{kind}"),
                **fields,
            )
        )
        return self.there[-1]

    def reset(self) -> None:
        """Remove all controls."""
        self.there.clear()

    # --------------------------------------------------------------------- for tests
    def __getitem__(self, label: str) -> Handle:
        """The control with that label, now or at first: one that can be seen, if there is one."""
        found = [one for one in self.there if label in (one.label, one.name)]
        return next((one for one in found if one.is_shown), found[-1])

    def __contains__(self, label: str) -> bool:
        """Whether a control with that label can be seen."""
        return any(one.label == label and one.is_shown for one in self.there)

    def labels(self, *kinds: str, tab: str = "") -> list[str]:
        """Of the controls of some kinds that can be seen, in the order in which they were added."""
        seen = [one for one in self.there if one.kind in kinds and one.is_shown]
        return [one.label for one in seen if not tab or one.is_in(self[tab])]

    def text(self, tab: str = "") -> str:
        """The texts that can be seen."""
        seen = [one for one in self.there if one.kind in ("html", "markdown") and one.is_shown]
        return "\n".join(one.content for one in seen if not tab or one.is_in(self[tab]))


class Client:
    """viser's handle of a page that is none.

    Attributes:
        gui: its panel.
        notices: the notifications that are up.
        mail: what its script was told.
    """

    client_id = 1

    def __init__(self) -> None:
        self.gui, self.scene, self.mail = Gui(), MagicMock(), Letters()
        self.notices: list[SimpleNamespace] = []
        self.send_file_download = MagicMock()
        self.heard: Callable[[Any, Any], None] = print
        self._websock_connection = SimpleNamespace(
            queue_message=self._take,
            register_handler=lambda _, heard: setattr(self, "heard", heard),
        )

    def _take(self, message: SoftrodMessage) -> None:
        self.mail.send_letter(Letter(message.text, message.numbers, message.redundancy_key()))

    def atomic(self) -> AbstractContextManager[None]:
        """All at once."""
        return nullcontext()

    def add_notification(self, title: str, text: str, **more: Any) -> SimpleNamespace:
        """Put up a notification."""
        notice = SimpleNamespace(title=title, text=text, **more)
        notice.remove = lambda: self.notices.remove(notice)
        self.notices.append(notice)
        return notice

    def say(self, said: FromPage) -> None:
        """Say something, as the page's script does."""
        self.heard(1, SoftrodMessage(msgspec.json.encode(said).decode()))


class Noted:
    """A page's side of viser, of a server's own panel, that notes its controls as they are made.

    Attributes:
        made: the last control with each label.
        charts: all of them.
    """

    def __init__(self, server: viser.ViserServer) -> None:
        self.made: dict[str, Any] = {}
        self.charts: list[viser.GuiUplotHandle] = []
        self._server = server
        self.atomic, self.gui = server.atomic, self

    def __getattr__(self, name: str) -> Any:
        add = getattr(self._server.gui, name)

        def note(*arguments: Any, **options: Any) -> Any:
            handle = add(*arguments, **options)
            if isinstance(handle, viser.GuiUplotHandle):
                self.charts.append(handle)
            elif arguments and name != "add_html":
                self.made[arguments[0]] = handle
            return handle

        return note


def page_of(
    session: Session,
    client: Any = None,
    letters: Letters | None = None,
    notify: Callable[[Notice], None] = print,
    owned: bool = True,
) -> Page:
    """What the panels of a page of that session have in common; `client` may be anything that has a `gui`."""
    return Page(
        client or MagicMock(),
        session,
        letters or Letters(),
        notify,
        print,
        Shelf(owned),
    )
