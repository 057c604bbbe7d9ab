"""One page's control panel: viser's handles, which belong to that page alone.

The page's script draws them, see `app/ui/gui`.

Handlers only post commands. Values from a page are checked and clamped where they are applied, since the
limits of a slider exist in the browser only. Values that the server sets fire the same handlers; those events
have no client and are ignored, which prevents loops."""

from __future__ import annotations

from functools import partial

import viser

from ..stage.colors import palette
from ..words import find, say
from .commands import keys_text, text_of
from .page import Page
from .viser.handlers import add_command


def set_theme(gui: viser.GuiApi, dark: bool) -> None:
    """Set viser's colours, without its logo and its own share button."""
    red, green, blue = (int(part) for part in palette("softrod", dark).brand)
    gui.configure_theme(
        dark_mode=dark, show_logo=False, show_share_button=False, brand_color=(red, green, blue)
    )


class Panel:
    """The panel of one page, into which features put their controls.

    Args:
        page: the page.
    """

    def __init__(self, page: Page) -> None:
        self._page, self._gui = page, page.client.gui
        self._group: viser.GuiTabGroupHandle | None = None
        self._tabs: dict[str, viser.GuiTabHandle] = {}

    def tab(self, name: str) -> viser.GuiTabHandle:
        """The tab of a name, in English, created at the first call; tabs are in the order of these calls. Its
        message is `ui-tab-NAME`."""
        if name not in self._tabs:
            self._group = self._group or self._gui.add_tab_group()
            self._tabs[name] = self._group.add_tab(find(f"ui-tab-{name.lower()}", name))
        return self._tabs[name]

    def find(self, name: str) -> viser.GuiTabHandle | None:
        """The tab of a name; None if there is none."""
        return self._tabs.get(name)

    def finish(self) -> None:
        """Tell the page which commands can be found; their keys are handled by the page's script."""
        for name, row in self._page.commands.items():
            if not row.listed or (row.needs and row.needs not in self._page.controls):
                continue
            about = None
            if row.keys:
                keys = keys_text(row.keys)
                about = say("key-of.held", keys=keys) if row.held else say("key-of", keys=keys)
            add_command(self._gui, text_of(name), partial(self._page.perform, name), about)
