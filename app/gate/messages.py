"""The messages a page may send, each with the exact shape the page gives it.

One strict msgspec structure per message: an unknown type, an unknown or missing field, a wrong kind of
value, a NaN or an infinite number all fail to decode. What passes is encoded afresh for viser, so viser
reads exactly what was checked, however oddly the original bytes were put together.

The names and fields are those of viser 1.1.1; a test compares them with viser's own. Left out on purpose:
share requests (they open a public tunnel), form messages (viser stores and repeats them to every tab),
clicks and drags of the scene, buttons that are held and uploads (the script has its own), render and local
storage answers (never asked for), and everything only a server sends.
"""

import sys
from functools import reduce
from numbers import Real
from operator import or_
from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta, Struct

MAX_MESSAGE_BYTES = 64 * 1024
"""Limit for any message. A pose or a slider needs under 400 bytes; the rest is room for a part of a long
text, and for one that is pasted into a text field."""

MAX_FRAME_BYTES = 2 * MAX_MESSAGE_BYTES
"""Limit for whatever arrives; beyond it the connection is cut."""

Reason = Literal[
    # Why a request was answered by the gate instead of viser.
    "host",
    "origin",
    "upgrade",
    "path",
    "tabs",
    "rate",
    "starting",
    # Why a message did not reach viser.
    "text",
    "size",
    "type",
    "content",
    "handle",
    # Why a connection was cut.
    "knocking",
    "frames",
]


class Refused(Exception):
    """A message that viser must not see."""

    def __init__(self, reason: Reason) -> None:
        super().__init__(reason)
        self.reason: Reason = reason


# Bounds are the cheapest way to refuse NaN and infinity: no comparison with NaN holds.
_Number = Annotated[float, Meta(ge=-sys.float_info.max, le=sys.float_info.max)]
_Vector3 = tuple[_Number, _Number, _Number]
_Quaternion = tuple[_Number, _Number, _Number, _Number]
_Count = Annotated[int, Meta(ge=0)]
_Name = Annotated[str, Meta(max_length=255)]

Value = bool | int | _Number | str
"""What an element of the panel may be set to; none of softrod's is a vector or a colour."""


class PageMessage(Struct, forbid_unknown_fields=True, tag_field="type", tag=True):
    """A message a page may send; the class name is its type."""


class ViewerCameraMessage(PageMessage):
    wxyz: _Quaternion
    position: _Vector3
    fov: _Number
    near: _Number
    far: _Number
    image_height: _Count
    image_width: _Count
    look_at: _Vector3
    up_direction: _Vector3


class ValueUpdate(Struct, forbid_unknown_fields=True):
    """The one attribute of a GUI element that is its user's to set."""

    value: Value


class GuiUpdateMessage(PageMessage):
    uuid: _Name
    updates: ValueUpdate


class CommandTriggerMessage(PageMessage):
    uuid: _Name


class TransformControlsUpdateMessage(PageMessage):
    name: _Name
    wxyz: _Quaternion
    position: _Vector3
    owner: _Name


class TransformControlsDragStartMessage(PageMessage):
    name: _Name
    owner: _Name


class TransformControlsDragEndMessage(PageMessage):
    name: _Name
    owner: _Name


class SoftrodMessage(PageMessage):
    """What the page's own script says: JSON, which `app.wire` reads and checks."""

    text: str


class BeatMessage(PageMessage):
    """The page has heard nothing for a while, and wants a sign of life. The gate gives it, not viser."""


PAGE_MESSAGES: tuple[type[PageMessage], ...] = tuple(PageMessage.__subclasses__())
"""Every message a page may send."""

_TYPES = frozenset(message.__name__ for message in PAGE_MESSAGES)


class _Head(Struct):
    type: str


_any_message: msgspec.msgpack.Decoder[PageMessage] = msgspec.msgpack.Decoder(reduce(or_, PAGE_MESSAGES))
_head = msgspec.msgpack.Decoder(_Head)
_encode = msgspec.msgpack.Encoder().encode

# Everything msgspec raises for bytes it cannot make sense of.
_UNREADABLE = (msgspec.MsgspecError, UnicodeDecodeError, RecursionError)


def read(data: bytes) -> PageMessage:
    """Decode a message, or raise Refused saying why viser must not see it."""
    if len(data) > MAX_MESSAGE_BYTES:
        raise Refused("size")
    try:
        return _any_message.decode(data)
    except _UNREADABLE:
        raise Refused(_why_unreadable(data)) from None


def write(message: PageMessage) -> bytes:
    """Encode a message for viser."""
    return _encode(message)


BEAT = write(BeatMessage())


def is_alike(current: Any, new: Any) -> bool:
    """Whether a GUI element that holds `current` may be set to `new`.

    viser converts instead: it would make a NaN of the text "nan" for a number, and raise on "x".
    """
    match current:
        case bool():
            return isinstance(new, bool)
        case Real():
            return isinstance(new, (int, float)) and not isinstance(new, bool)
        case str():
            return isinstance(new, str)
    return False


def _why_unreadable(data: bytes) -> Reason:
    try:
        known = _head.decode(data).type in _TYPES
    except _UNREADABLE:
        return "content"
    return "content" if known else "type"
