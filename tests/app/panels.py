"""A page of panels without a browser, for tests."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any
from unittest.mock import MagicMock

import viser

from app.page.page import Page
from app.page.scenes.shelf import Shelf
from app.page.viser.comma_switch import CommaSwitch
from app.session.notices import Notice
from app.session.session import Session
from tests.app.letters import Letters


class Handle(SimpleNamespace):
    """A control that is in no page."""

    def __enter__(self) -> None:
        pass

    def __exit__(self, *_: object) -> None:
        pass

    def listen(self, handler: Callable[[Any], Any]) -> Callable[[Any], Any]:
        self.handler = handler
        return handler

    on_update = on_click = on_trigger = listen

    def enter(self, value: object) -> None:
        """As its user does."""
        self.value = value
        asyncio.run(self.handler(SimpleNamespace(client_id=1, target=self)))


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
            elif name != "add_html":
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
        CommaSwitch(print),
    )
