"""All uses of viser's internals that have no public counterpart; review this module when viser is upgraded.

It was written for the version below, which is pinned; `tests/app/test_viser_inside.py` fails if viser
differs. What the page's script uses of viser's page is in `app/ui/viser`, and the messages that viser's page
may send are in `app/gate/messages.py`."""

from __future__ import annotations

import asyncio
import contextlib
import functools
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import viser
import viser._messages
import viser.infra._async_message_buffer
import websockets.asyncio.server
import zstandard
from numpy.typing import NDArray

VERSION = "1.1.1"
"""The version of viser that this module was written for."""


# ------------------------------------------------------------------------- messages
@dataclass(init=False)
class SoftrodMessage(viser._messages.Message, include_in_scene_serialization=False):
    """Carries a JSON message of `app.wire` in either direction, and numbers to the page.

    viser dispatches every subclass of its `Message` to registered handlers. viser's page never sees this one:
    the script takes it out of the queue.
    """

    text: str
    numbers: NDArray[np.float32] | None

    def __init__(self, text: str, numbers: NDArray[np.float32] | None = None, key: str = "") -> None:
        self.text, self.numbers, self._key = text, numbers, key

    def redundancy_key(self) -> str:
        """Of waiting messages with the same key, viser sends only the last one."""
        return self._key


class _LoopEvent(asyncio.Event):
    """An event that only the thread of its event loop sets.

    viser 1.1.1 sets a queue's event from any thread that adds a message, and then again on the loop. If the
    first comes just as the loop begins to wait, the event is marked as set but wakes nobody; the second then
    finds it set already, and nothing is ever sent to the page again.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        super().__init__()
        self._of = loop

    def set(self) -> None:
        with contextlib.suppress(RuntimeError):  # this thread has no loop
            if asyncio.get_running_loop() is self._of:
                super().set()


def _set_events_on_their_loops(queue: type[viser.infra._async_message_buffer.AsyncMessageBuffer]) -> None:
    """Have all queues that are made from now on woken by their event loops only."""
    made = queue.__init__

    @functools.wraps(made)
    def make(self: Any, *args: Any, **options: Any) -> None:
        made(self, *args, **options)
        self.message_event = _LoopEvent(self.event_loop)

    queue.__init__ = make


_set_events_on_their_loops(viser.infra._async_message_buffer.AsyncMessageBuffer)


def send(client: viser.ClientHandle, message: SoftrodMessage) -> None:
    """Send a message to a page; any thread may."""
    client._websock_connection.queue_message(message)


def listen(client: viser.ClientHandle, heard: Callable[[str], None]) -> None:
    """Call `heard` with the text of every message of a page's script, on viser's event loop."""
    client._websock_connection.register_handler(SoftrodMessage, lambda _, message: heard(message.text))


def no_messages() -> bytes:
    """A batch of no messages, as viser's page reads it (`viser.infra._infra._message_producer`)."""
    fields = {"messages": (), "timestampSec": time.perf_counter(), "binaryBufferLengths": ()}
    inner = msgspec.msgpack.encode(fields)
    packed = zstandard.compress(inner, 1)
    data = len(inner).to_bytes(8, "little") + len(packed).to_bytes(8, "little") + packed
    # It ends at a multiple of eight bytes.
    return data.ljust(-(-len(data) // 8) * 8, b"\0")


# ------------------------------------------------------------------------- the panel
def element_id(
    handle: viser.GuiInputHandle[Any] | viser.GuiUplotHandle | viser.GuiHtmlHandle | viser.GuiTabHandle,
) -> str:
    """The id of a panel's element in the page."""
    return handle._id if isinstance(handle, viser.GuiTabHandle) else handle._impl.uuid


def input_handle(owner: viser.ViserServer | viser.ClientHandle, uuid: str) -> Any:
    """The element of a panel with an id, which a page may set; None if there is none."""
    return owner.gui._gui_input_handle_from_uuid.get(uuid)


# ------------------------------------------------------------------------- connections
def connections(server: viser.ViserServer) -> dict[int, Any]:
    """The open connections, by the ids of their clients."""
    return server._websock_server._live_connections


_replacing = threading.Lock()


@contextlib.contextmanager
def served_by(
    options_of: Callable[[Any], dict[str, Any]], handler_of: Callable[[Any], Any]
) -> Iterator[list[Any]]:
    """Add options to viser's call of `websockets.serve`; yields the list of such calls.

    websockets' own module is patched meanwhile.

    Args:
        options_of: makes the options, given the function by which viser answers requests.
        handler_of: makes the handler of connections, given viser's.
    """
    module: Any = websockets.asyncio.server
    calls: list[Any] = []

    def serve(handler: Any, *address: Any, process_request: Any = None, **options: Any) -> Any:
        if getattr(handler, "__module__", None) != "viser.infra._infra":
            # Another server, started by chance at this moment.
            return real_serve(handler, *address, process_request=process_request, **options)
        calls.append(address)
        return real_serve(handler_of(handler), **(options | options_of(process_request)))

    with _replacing:
        real_serve = module.serve
        module.serve = serve
        try:
            yield calls
        finally:
            module.serve = real_serve


# ------------------------------------------------------------------------- the page
PLACE = '<div id="root"></div>'
"""The element in which viser's page is built."""


def page_script() -> str:
    """The element of the one script that is viser's page.

    The script reads data from its own element; it is changed to find them also as a module.

    Raises:
        OSError: it cannot be read.
        ValueError: it is not the expected page.
    """
    path = Path(viser.__file__).parent / "client" / "build" / "index.html"
    text = path.read_text(encoding="utf-8")
    begin, itself = "<script data-p=", "document.currentScript"
    if any(text.count(part) != 1 for part in (begin, itself, PLACE)):
        raise ValueError("viser's page is not the one that softrod knows.")
    at = text.index(begin)
    script = text[at : text.index("</script>", at)] + "</script>"
    return script.replace(itself, 'document.querySelector("script[data-p]")')
