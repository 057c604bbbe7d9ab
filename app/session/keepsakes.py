"""What a browser keeps of a page, to go on there after the server was started anew."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

import msgspec
from msgspec import Meta

import sim
from sim.errors import SceneError
from sim.methods.registry import METHODS
from sim.scene.numbers import MAX_SPRINGS
from sim.settings import CHOICES
from sim.store.files import MAX_FILE_BYTES, decode_scene
from sim.store.places import sentence_of_json

from ..stage.looks import SPEEDS
from . import log
from .ghost import FINER, REFERENCE

FORMAT, VERSION = "softrod-keepsake", 1

MAX_BYTES = 1_000_000
"""A keepsake that would be larger leaves out the scene as it was opened, and then the motion, too: the scene
begins anew."""


class Second(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The second body, see `Ghost`."""

    method: Annotated[str, Meta(max_length=60)]
    law: Annotated[str, Meta(max_length=60)] = ""
    finer: int = 1


class Choices(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What the user of a page had chosen beside the scene.

    Attributes:
        playing: whether the clock ran.
        speed: simulated seconds per second.
        follow: whether the driven mass followed the pointer.
        joint: the angular spring that was read out.
        ghost: the second body, if there was one.
        foretell: whether it was told how fast errors grow.
        touched: whether anything had been done to the body by hand.
    """

    playing: bool = True
    speed: Annotated[float, Meta(ge=SPEEDS[0], le=SPEEDS[-1])] = 1.0
    follow: bool = False
    joint: Annotated[int, Meta(ge=0, lt=MAX_SPRINGS)] = 0
    ghost: Second | None = None
    foretell: bool = False
    touched: bool = False


_NOTHING = msgspec.Raw()


class _Keepsake(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, omit_defaults=True):
    format: Literal["softrod-keepsake"]
    version: Annotated[int, Meta(ge=1)]
    scene: msgspec.Raw
    moment: log.Restore | None
    wishes: Choices
    opened: msgspec.Raw = _NOTHING


@dataclass(frozen=True)
class Kept:
    """What is in a keepsake.

    Attributes:
        moment: where the body was.
        wishes: what its user had chosen.
        opened: the scene as it was opened, or as it was last where that was left out.
    """

    moment: sim.Moment
    wishes: Choices
    opened: sim.Scene


def encode(moment: sim.Moment, wishes: Choices, opened: sim.Scene) -> bytes:
    """A keepsake; see `Kept`."""
    scene = log.raw_scene(moment.scene)
    there = log.restore_entry(moment, with_scene=False)
    keepsake = _Keepsake(format=FORMAT, version=VERSION, scene=scene, moment=there, wishes=wishes)
    if opened is not moment.scene:
        keepsake = msgspec.structs.replace(keepsake, opened=log.raw_scene(opened))
    data = msgspec.json.encode(keepsake)
    for left_out in ({"opened": _NOTHING}, {"moment": None}):
        if len(data) > MAX_BYTES:
            keepsake = msgspec.structs.replace(keepsake, **left_out)
            data = msgspec.json.encode(keepsake)
    return data


def decode(data: bytes) -> Kept:
    """What is in a keepsake; nothing in it is trusted.

    Raises:
        SceneError: one sentence that says what is wrong.
    """
    if len(data) > MAX_BYTES + MAX_FILE_BYTES:
        raise SceneError(f"{len(data)} bytes are more than a keepsake may have")
    try:
        keepsake = msgspec.json.decode(data, type=_Keepsake)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        raise SceneError(sentence_of_json(error, data, _Keepsake)) from None
    if keepsake.version > VERSION:
        raise SceneError(f"version {keepsake.version} is newer than {VERSION}; a newer softrod can read it")
    scene = decode_scene(bytes(keepsake.scene), "scene", places=False)
    wishes, ghost = keepsake.wishes, keepsake.wishes.ghost
    if ghost is not None:
        laws = {"", *CHOICES["force_law"].options}
        if ghost.method not in {REFERENCE, *METHODS} or ghost.law not in laws or ghost.finer not in FINER:
            raise SceneError(f"ghost: there is no {ghost.method!r} with law {ghost.law!r} / {ghost.finer}")
    opened = decode_scene(bytes(keepsake.opened), "scene", places=False) if bytes(keepsake.opened) else scene
    if keepsake.moment is None:
        return Kept(sim.Simulation(scene, wait=False).capture(), wishes, opened)
    return Kept(log.moment_of(keepsake.moment, scene), wishes, opened)
