"""The gallery: all scenes on cards, to open one; the page's own are renamed, copied and deleted there.

What it does takes a while: call it in a thread.
"""

from __future__ import annotations

import base64
import functools
import shlex
from pathlib import Path

from app.classroom.answers import Refused
from sim.edit.texts import renamed
from sim.errors import SceneError
from sim.scene.types import Scene
from sim.store import own_scenes
from sim.store.files import read_scene

from ...session import commands
from ...session.notices import Notice
from ...ui.page import Page
from ...words import quoted, say
from ...words.english import of
from . import thumbnails
from .entries import entries
from .messages import (
    ChangeScene,
    ListScenes,
    OfferGallery,
    OpenScene,
    SceneChanged,
    ScenePictures,
    Scenes,
    ShelfChanged,
    UsedInClass,
    UseInClass,
)

MAX_PAINTED = 200
"""Saved scenes that get a picture; the others have their names."""

PAINTED_AT_ONCE = 8
"""Pictures after which those that are ready are sent."""


class Gallery:
    """One page's gallery.

    Args:
        page: whose scenes they are.
    """

    def __init__(self, page: Page) -> None:
        self._shelf, self._session = page.shelf, page.session
        self._mail, self._notify = page.mail, page.notify
        self._page = page

    def offer(self, why: str = "") -> None:
        """Have the page show it, with a sentence that says why, if there is one."""
        self._mail.send(OfferGallery(why=why))

    def changed(self) -> None:
        """Have the page ask for the scenes again, if it shows them."""
        self._mail.send(ShelfChanged())

    def open(self, ask: OpenScene) -> None:
        """Open a scene; if it cannot be read, nothing changes."""
        if scene := self._read(ask.name, say("gallery-not-opened")):
            self._session.post(commands.Open(scene))

    def _read(self, name: str, failure: str) -> Scene | None:
        """A listed scene, since a name could be the path of any file; if it cannot be read, say so."""
        try:
            if (info := self._shelf.find(name)) is None:
                raise SceneError(say("gallery-gone", name=quoted(name)))
            return read_scene(info.path)
        except SceneError as error:
            self._notify(Notice("error", failure, str(error)))
            return None

    def list(self, ask: ListScenes) -> None:
        """Send the page all scenes, then the pictures of those that are saved as they get ready."""
        scenes = self._shelf.scenes()
        self._mail.send(
            Scenes(
                scenes=tuple(entries(scenes)),
                present=self._session.scene.name,
                teaches=self._shelf.owned,
            )
        )
        pictures: dict[str, str] = {}
        saved = [info for info in scenes if not info.built_in][:MAX_PAINTED]
        for count, info in enumerate(saved, start=1):
            if picture := _picture(info.path, ask.dark):
                pictures[info.name] = picture
            if count % PAINTED_AT_ONCE == 0 or count == len(saved):
                self._mail.send(ScenePictures(pictures=pictures))
                pictures = {}

    def use_in_class(self, ask: UseInClass) -> None:
        """Begin a class with a scene, for the owner alone; or say by which command one is begun, where others
        cannot reach this server."""
        begin = self._page.begin_class
        command = f"softrod class {shlex.quote(ask.name)}"
        if not self._shelf.owned:
            return
        if begin is None:
            self._mail.send(UsedInClass(address="", command=command))
            return
        scene = self._read(ask.name, say("gallery-not-used"))
        if scene is None:
            return

        def do() -> None:
            try:
                self._mail.send(UsedInClass(address=begin(scene), command=command))
            except Refused as error:
                self._notify(Notice("error", say("gallery-no-class"), str(error)))

        self._page.later(do)

    def change(self, ask: ChangeScene) -> None:
        """Rename, copy, delete or bring back one of the page's own scenes, and say what was done."""
        trashed = ""
        try:
            folder = self._shelf.folder
            match ask.how:
                case "rename":
                    used = own_scenes.rename_user_scene(ask.name, ask.to, folder)
                    if self._session.scene.name == ask.name:
                        self._session.post(commands.Change(lambda moment, _: renamed(moment.scene, used)))
                    said = say("gallery-renamed", name=quoted(used))
                case "duplicate":
                    said = say("gallery-copied", name=quoted(self._shelf.duplicate(ask.name)))
                case "delete":
                    trashed = own_scenes.trash_user_scene(ask.name, folder)
                    said = say("gallery-deleted", name=quoted(ask.name))
                case "restore":
                    restored = own_scenes.restore_user_scene(ask.name, folder)
                    said = say("gallery-restored", name=quoted(restored))
        except SceneError as error:
            said = of(str(error))
        self._mail.send(SceneChanged(text=said, undo=trashed))


def _picture(path: Path, dark: bool) -> str:
    """A saved scene's picture, as an address that an image can have; empty if it cannot be read."""
    try:
        return painted(path, path.stat().st_mtime_ns, dark)
    except (OSError, SceneError, ValueError):
        return ""


@functools.lru_cache(maxsize=2 * MAX_PAINTED)
def painted(path: Path, _: int, dark: bool) -> str:
    """The picture of the scene that a file had at a time; the last ones are cached."""
    data = thumbnails.picture(read_scene(path), dark)
    return f"data:image/webp;base64,{base64.b64encode(data).decode()}"
