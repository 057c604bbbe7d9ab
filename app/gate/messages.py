"""The messages that a page may send, with their exact shapes.

There is one strict msgspec structure for each. An unknown type, an unknown or missing field, a value of
another kind, a NaN or an infinity is an error. What passes is encoded again for viser, so that viser reads
exactly what was checked, however oddly the original bytes were composed.

Names and fields are those of viser 1.1.1; a test compares them. Left out on purpose are share requests (they
open a public tunnel), form messages (viser stores and repeats them to every tab), clicks and drags of the
scene, buttons that are held, uploads (the page's script has its own), render and local storage answers (never
requested), and everything that only a server sends.
"""

import sys
from functools import reduce
from numbers import Real
from operator import or_
from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta, Struct

MAX_MESSAGE_BYTES = 64 * 1024
"""Bytes of a message, at most. A pose or a slider needs less than 400; the rest is for a part of a long text,
or for one pasted into a text field."""

MAX_FRAME_BYTES = 2 * MAX_MESSAGE_BYTES
"""Bytes of a WebSocket frame; beyond, the connection is cut."""

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


# Bounds are the cheapest way to refuse NaN and infinity: every comparison with NaN is false.
_Number = Annotated[float, Meta(ge=-sys.float_info.max, le=sys.float_info.max)]
_Vector3 = tuple[_Number, _Number, _Number]
_Quaternion = tuple[_Number, _Number, _Number, _Number]
_Count = Annotated[int, Meta(ge=0)]
_Name = Annotated[str, Meta(max_length=255)]

Value = bool | int | _Number | str
"""Values of the panel's elements; none of softrod's is a vector or a colour."""


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
    """A message of the page's own script: JSON, which `app.wire` decodes and checks."""

    text: str


class BeatMessage(PageMessage):
    """The page has received nothing for a while, and asks for a sign of life; the gate answers, not viser."""


PAGE_MESSAGES: tuple[type[PageMessage], ...] = tuple(PageMessage.__subclasses__())
"""Every message a page may send."""

_TYPES = frozenset(message.__name__ for message in PAGE_MESSAGES)


class _Head(Struct):
    type: str


_any_message: msgspec.msgpack.Decoder[PageMessage] = msgspec.msgpack.Decoder(reduce(or_, PAGE_MESSAGES))
_head = msgspec.msgpack.Decoder(_Head)
_encode = msgspec.msgpack.Encoder().encode

# Everything that msgspec raises for malformed bytes.
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
