"""A scene as the end of a link: after the `#`, the number of the packing format, a dot, and the packed scene.

It is packed as compact JSON, compressed with zlib, in URL-safe base64. zlib's checksum detects lost or
changed characters.
"""

from __future__ import annotations

import base64
import binascii
import re
import zlib
from typing import Any

import msgspec

from ..errors import SceneError
from ..scene.numbers import of_python
from ..scene.types import BODY_FIELDS, FORMAT_VERSION, Scene
from ..scene.validate import validate
from ..text import Text

PACKING = 1
"""Number of the packing format of this release; later ones are refused."""

MAX_LINK = 2_000_000
"""Maximum length of a link's data, characters; browsers accept about two million."""

PATH = "/s"
"""Path at which a page accepts such links."""

_LINK = re.compile(r"<?(https?://[^\s#%]+(?:%(?!23)[^\s#%]*)*)(?:(?:#|%23)(.*))?", re.DOTALL)
_DATA = re.compile(r"(\d{1,6})\.([A-Za-z0-9_-]+)")
_BY_MAIL = re.compile(r"=\r?\n|[\s\u200b\ufeff]+|[.,;:!?)\]>\"']+$")
"""Matches what mail programs and sentences add to a link: line breaks, with = in quoted-printable text, and
brackets and full stops after it."""
_BROKEN = Text("the link is broken: a part of it is missing or was changed")


def link_data(text: str) -> str | None:
    """Return the part of a link after the `#`; None if a text is not a link.

    Raises:
        SceneError: the link has no `#`: a shell may have taken it for a comment.
    """
    match = _LINK.fullmatch(text.strip())
    if match is not None and match[2] is None:
        raise SceneError(
            Text(
                "the link {link} has no # with a scene after it; on a command line, put it in quotes",
                link=match[1][:200],
            )
        )
    return match[2] if match else None


def pack_scene(scene: Scene) -> str:
    """Return the data of a link to a scene.

    Raises:
        SceneError: the scene is not valid, or too large for a link.
    """
    validate(scene)
    fields = {**_without_defaults(scene), "format": FORMAT_VERSION}
    if scene.bodies:
        for field in BODY_FIELDS:
            fields.pop(field, None)
    packed = zlib.compress(msgspec.json.encode(fields, enc_hook=of_python), 9)
    data = f"{PACKING}.{base64.urlsafe_b64encode(packed).decode().rstrip('=')}"
    if len(data) > MAX_LINK:
        raise SceneError(
            Text(
                "a link to {scene!r} would have {count} characters, more than the {most} "
                "allowed; send the scene as a file",
                scene=scene.name,
                count=len(data),
                most=MAX_LINK,
            )
        )
    return data


def unpack(data: str, most: int) -> bytes:
    """Return the scene in a link's data, as JSON; the data is not trusted.

    Args:
        data: the part after the `#`.
        most: maximum size of the scene, bytes.

    Raises:
        SceneError: one sentence that says what is wrong.
    """
    if len(data) > MAX_LINK:
        raise SceneError(
            Text(
                "the link has {count} characters, more than the {most} allowed",
                count=len(data),
                most=MAX_LINK,
            )
        )
    match = _DATA.fullmatch(_BY_MAIL.sub("", data))
    if match is None:
        raise SceneError(
            Text(
                "the link is broken: a part of it is missing or was changed; a link to a scene ends with "
                "#{newest}. and letters, digits, - and _",
                newest=PACKING,
            )
        )
    packing = int(match[1])
    if packing > PACKING:
        raise SceneError(
            Text(
                "the link is of format {packing}, newer than {newest}, the newest that this "
                "softrod reads; a newer softrod can open it",
                packing=packing,
                newest=PACKING,
            )
        )
    if packing < 1:
        raise SceneError(
            Text(
                "the link is broken: a part of it is missing or was changed; there is no format {packing}",
                packing=packing,
            )
        )
    letters = match[2]
    try:
        packed = base64.b64decode(letters + "=" * (-len(letters) % 4), b"-_", validate=True)
        unpacking = zlib.decompressobj()
        # A few bytes may expand to gigabytes.
        found = unpacking.decompress(packed, most + 1)
    except (binascii.Error, zlib.error):
        raise SceneError(_BROKEN) from None
    if len(found) > most:
        raise SceneError(
            Text(
                "{where}: unpacked it has more than the {most} bytes that a scene may have",
                where=Text("the link"),
                most=most,
            )
        )
    if not unpacking.eof or unpacking.unused_data:
        raise SceneError(_BROKEN)
    return found


def _without_defaults(value: Any) -> Any:
    """Convert to dicts, lists, numbers and strings, leaving out default values."""
    if isinstance(value, msgspec.Struct):
        config = value.__struct_config__
        tag = {} if config.tag_field is None else {config.tag_field: config.tag}
        return tag | {
            field.encode_name: _without_defaults(item)
            for field in msgspec.structs.fields(value)
            for item in (getattr(value, field.name),)
            if field.required or item != field.default
        }
    return [_without_defaults(item) for item in value] if isinstance(value, tuple) else value
