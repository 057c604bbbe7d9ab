"""What the ticker needs of a page, of whichever kind."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from typing import Any, Protocol

from ..words.keys import Key

STOPPED: tuple[Key, Key] = ("ui-stopped", "ui-stopped.text")
"""What the user of a page reads that is closed after an error."""

CALM_FRAME = 1.0
"""Seconds between two frames of a page on which nothing happens."""

RunInThread = Callable[..., Future[Any]]
"""Calls a function with arguments in another thread, as `ThreadPoolExecutor.submit`."""


class Ticked(Protocol):
    """A page, as the ticker uses it; all but `stir` belongs to the ticker's thread.

    Attributes:
        language: that its user is spoken to in, while the ticker handles it.
    """

    language: str

    @property
    def is_calm(self) -> bool:
        """True if an occasional frame is enough: nothing moves, and nobody does anything."""
        ...

    @property
    def looks_on(self) -> bool:
        """True if it moves no body of its own, and so needs no computing time."""
        ...

    def frame(self, budget: float, beside: RunInThread) -> bool:
        """Compute and send one frame; return True if anything may have been sent.

        Args:
            budget: seconds of computing time.
            beside: runs the work of a heavy body.
        """
        ...

    def flush(self) -> None:
        """Hand what was sent to the network."""
        ...

    def stir(self) -> None:
        """Note that a message arrived, of any kind; any thread may call."""
        ...

    def leave(self) -> None:
        """Release what the page holds; it is gone."""
        ...

    def stop(self) -> None:
        """Tell the page's user that it has stopped after an error."""
        ...
