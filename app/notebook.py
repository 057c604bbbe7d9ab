"""The live page in a notebook's cell; see `app.show`."""

from __future__ import annotations

import atexit
import contextlib
import html
import sys

import sim
from sim.model.system import build_system

from .gate.address import OF_THIS_MACHINE, page_addresses
from .pages.sandbox.tab import Tab
from .server.serve import serving

HOST = "127.0.0.1"

_all: list[Shown] = []
"""All that is shown, to be closed at exit."""


class Shown:
    """A scene in the live page, served in the background of this process.

    Args:
        scene, width, height: see `app.show`.

    Attributes:
        url: the page's address; every tab and frame that opens it has its own body.

    Raises:
        SceneError: the scene is not valid.
    """

    def __init__(self, scene: sim.Scene, width: int | str = "100%", height: int = 620) -> None:
        self._scene = sim.validate(scene)
        self._width, self._height = width, height
        self._closing = contextlib.ExitStack()
        server, self._ticker, compiler = self._closing.enter_context(
            serving(self._scene, HOST, 0, OF_THIS_MACHINE)
        )
        (self.url,) = page_addresses(HOST, server.get_port())
        compiler.want_for(scene.integrator.method, build_system(self._scene).body)
        compiler.start()
        self._open = True
        _all.append(self)
        if not _in_notebook():
            print(f"softrod is at {self.url}")

    def scene(self) -> sim.Scene:
        """The scene as it is now, with its pose, in the page that was opened last.

        Before a page is open it is the given scene; after a page is closed, the scene as it was last.

        Raises:
            InputError: the page did not answer.
        """
        tabs = [tab for _, tab in sorted(self._ticker.tabs.items()) if isinstance(tab, Tab)]
        if self._open and tabs:
            self._scene = tabs[-1].snapshot()
        return self._scene

    def close(self) -> None:
        """Stop the server, and with it the page."""
        if self._open:
            self._open = False
            _all.remove(self)
            self._closing.close()

    def __repr__(self) -> str:
        return f"<softrod at {self.url}{'' if self._open else ', closed'}>"

    def _repr_html_(self) -> str:
        """The page in a frame."""
        if not self._open:
            return html.escape(repr(self))
        url = html.escape(self.url)
        return (
            f'<iframe src="{url}" width="{html.escape(str(self._width))}" height="{int(self._height)}" '
            f'style="border:0" title="softrod"></iframe><div><a href="{url}" target="_blank">'
            "in a tab of its own</a></div>"
        )


def _in_notebook() -> bool:
    """Whether this runs in a notebook, which displays the last line of a cell."""
    shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
    return shell is not None and hasattr(shell, "kernel")


@atexit.register
def _close_all() -> None:
    for shown in list(_all):
        shown.close()
