"""All that uses viser's inside, for want of a public way: an upgrade of viser is a review of this module.

It was written for the version below, which is pinned; `tests/app/test_viser_inside.py` fails where viser has
become another one. What the page's script uses of viser's page is in `app/ui/viser`, and the messages that
viser's page may send are in `app/gate/messages.py`.
"""

from __future__ import annotations

import asyncio
import contextlib
import functools
import threading
import time
from collections.abc import Callable, Iterator, Sequence
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
    """Carries a message of `app.wire`, JSON, either way, and numbers to the page.

    viser leads every subclass of its `Message` to whoever registered for it. viser's page never sees this
    one: the script takes it out of the queue.
    """

    text: str
    numbers: NDArray[np.float32] | None

    def __init__(self, text: str, numbers: NDArray[np.float32] | None = None, key: str = "") -> None:
        self.text, self.numbers, self._key = text, numbers, key

    def redundancy_key(self) -> str:
        """Of messages with the same key that wait to be sent, viser keeps the last one."""
        return self._key


class _LoopEvent(asyncio.Event):
    """An event that only the thread of its event loop sets.

    Whoever puts a message into a queue of viser 1.1.1 sets the queue's event from any thread, and then has
    the loop set it, too. Where the first comes just as the loop begins to wait, it marks the event as set and
    wakes nobody; the loop then finds it set, and the page is never sent anything again.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        super().__init__()
        self._of = loop

    def set(self) -> None:
        with contextlib.suppress(RuntimeError):  # this thread has no loop
            if asyncio.get_running_loop() is self._of:
                super().set()


def _set_events_on_their_loops(queue: type[viser.infra._async_message_buffer.AsyncMessageBuffer]) -> None:
    """Have all queues that are made from now on woken by their event loops alone."""
    made = queue.__init__

    @functools.wraps(made)
    def make(self: Any, *args: Any, **options: Any) -> None:
        made(self, *args, **options)
        self.message_event = _LoopEvent(self.event_loop)

    queue.__init__ = make


_set_events_on_their_loops(viser.infra._async_message_buffer.AsyncMessageBuffer)


def send(client: viser.ClientHandle, message: SoftrodMessage) -> None:
    """Send a page a message; any thread may."""
    client._websock_connection.queue_message(message)


def listen(client: viser.ClientHandle, heard: Callable[[str], None]) -> None:
    """Have the text of every message from a page's script heard, on viser's event loop."""
    client._websock_connection.register_handler(SoftrodMessage, lambda _, message: heard(message.text))


def batch(*messages: SoftrodMessage) -> bytes:
    """A batch of messages, as viser's page reads it (`viser.infra._infra._message_producer`)."""
    arrays: list[memoryview] = []
    fields = tuple(message.as_serializable_dict(arrays) for message in messages)
    lengths = tuple(array.nbytes for array in arrays)
    inner = msgspec.msgpack.encode(
        {"messages": fields, "timestampSec": time.perf_counter(), "binaryBufferLengths": lengths}
    )
    packed = zstandard.compress(inner, 1)
    parts = (len(inner).to_bytes(8, "little") + len(packed).to_bytes(8, "little") + packed, *arrays)
    # Each begins at a multiple of eight bytes.
    return b"".join(bytes(part).ljust(-(-len(bytes(part)) // 8) * 8, b"\0") for part in parts)


def send_at_once(clients: Sequence[viser.ClientHandle], data: bytes) -> None:
    """Send a batch to several pages of one server, beside viser's queues; any thread may.

    A page that has not taken yet what it was sent before is left out, as one that is gone.
    """
    if not clients:
        return
    server = clients[0]._viser_server
    live = connections(server)

    def send() -> None:
        found = [live.get(client.client_id) for client in clients]
        ready = [one for one in found if one is not None and not one.transport.get_write_buffer_size()]
        websockets.asyncio.server.broadcast(ready, data)

    with contextlib.suppress(RuntimeError):  # the server ends
        server.get_event_loop().call_soon_threadsafe(send)


# ------------------------------------------------------------------------- the panel
def element_id(handle: viser.GuiInputHandle[Any] | viser.GuiTabHandle) -> str:
    """The id that an element of the panel has in the page."""
    return handle._id if isinstance(handle, viser.GuiTabHandle) else handle._impl.uuid


def input_handle(owner: viser.ViserServer | viser.ClientHandle, uuid: str) -> Any:
    """The element of a panel that a page may set, by its id; None if there is none."""
    return owner.gui._gui_input_handle_from_uuid.get(uuid)


# ------------------------------------------------------------------------- connections
def connections(server: viser.ViserServer) -> dict[int, Any]:
    """The connections of the pages that are there, by the ids of their clients."""
    return server._websock_server._live_connections


_replacing = threading.Lock()


@contextlib.contextmanager
def served_by(options_of: Callable[[Any], dict[str, Any]]) -> Iterator[list[Any]]:
    """Give viser's call of `websockets.serve` other options; yields the list of such calls.

    websockets' own module is changed meanwhile.

    Args:
        options_of: the options, from what viser answers to requests by.
    """
    module: Any = websockets.asyncio.server
    calls: list[Any] = []

    def serve(handler: Any, *address: Any, process_request: Any = None, **options: Any) -> Any:
        if getattr(handler, "__module__", None) != "viser.infra._infra":
            # Someone else's server, started by chance at this moment.
            return real_serve(handler, *address, process_request=process_request, **options)
        calls.append(address)
        return real_serve(handler, **(options | options_of(process_request)))

    with _replacing:
        real_serve = module.serve
        module.serve = serve
        try:
            yield calls
        finally:
            module.serve = real_serve


# ------------------------------------------------------------------------- the page
PLACE = '<div id="root"></div>'
"""Where viser's page is built."""


def page_script() -> str:
    """The one script of viser's page, which holds all of it, with its element.

    It is made to find its data, which stand in that element, also where another one runs it.

    Raises:
        OSError: it cannot be read.
        ValueError: it is not as it is known here.
    """
    path = Path(viser.__file__).parent / "client" / "build" / "index.html"
    text = path.read_text(encoding="utf-8")
    begin, itself = "<script data-p=", "document.currentScript"
    if any(text.count(part) != 1 for part in (begin, itself, PLACE)):
        raise ValueError("viser's page is not the one that softrod knows.")
    at = text.index(begin)
    script = text[at : text.index("</script>", at)] + "</script>"
    return script.replace(itself, 'document.querySelector("script[data-p]")')
