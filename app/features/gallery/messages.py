"""Messages about the scenes of the gallery."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta, Struct

from ...wire.messages import Ask, Event, SceneName


class ListScenes(Ask, frozen=True):
    """All scenes, and pictures of the user's own."""

    dark: bool


class OpenScene(Ask, frozen=True):
    """Open a scene by its name."""

    name: SceneName


class UseInClass(Ask, frozen=True):
    """Begin a class with a scene, by its name."""

    name: SceneName


class ChangeScene(Ask, frozen=True):
    """Do something with one of the page's own scenes; `name` is that of a deleted one for "restore".

    Others may be duplicated, too.
    """

    how: Literal["rename", "duplicate", "delete", "restore"]
    name: SceneName
    to: Annotated[str, Meta(max_length=200)] = ""


class OfferGallery(Event, frozen=True, kw_only=True):
    """Show the gallery, and why."""

    why: str


class ShelfChanged(Event, frozen=True, kw_only=True):
    """Scenes were saved, renamed or deleted."""


class Entry(Struct, frozen=True, kw_only=True):
    """A scene as the gallery shows it.

    Attributes:
        name: by which it is opened.
        title: what it is called: presets by their titles, saved scenes by the names they were saved under.
        line: in one sentence, what it shows.
        text: all of that, which is searched, too.
        group: the heading under which it stands.
        own: whether it is one of the page's own, which it may change.
        saved: whether it is no preset.
    """

    name: str
    title: str
    line: str
    text: str
    group: str
    own: bool
    saved: bool


class Scenes(Event, frozen=True, kw_only=True):
    """All scenes, and the name of the present one.

    Attributes:
        teaches: whether the page may use them in a class.
    """

    scenes: tuple[Entry, ...]
    present: str
    teaches: bool


class ScenePictures(Event, frozen=True, kw_only=True):
    """Pictures of scenes by their names, as addresses that an image can have."""

    pictures: dict[str, str]


class SceneChanged(Event, frozen=True, kw_only=True):
    """What was done with a scene of the page's own.

    Attributes:
        undo: by which name it can be brought back, if it can.
    """

    text: str
    undo: str


class UsedInClass(Event, frozen=True, kw_only=True):
    """How a scene is used in a class.

    Attributes:
        address: of the teacher's page of a class that has begun, from the present page's; empty where others
            cannot reach this server.
        command: by which a server begins one that they can.
    """

    address: str
    command: str
