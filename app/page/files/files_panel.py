"""The Share tab: saving, downloading and uploading scenes, and logs; the gallery has those that are saved.

Handlers run in viser's thread pool, since they touch the disk; the running simulation is never touched
unless a scene was read and found valid.
"""

from __future__ import annotations

import html
from collections.abc import Callable
from typing import Any

import viser

import sim
from sim.edit.texts import UNNAMED, renamed
from sim.errors import InputError, SceneError
from sim.store import files
from sim.store.places import as_utf8

from ...session import commands, log
from ...session.session import Notice, Session
from ..scenes.shelf import Shelf

ABOUT_LOGS = (
    '<div class="softrod-text">A log is all that was done since the start or the last reset; opened as a '
    "file, it does the same again.</div>"
)


class FilesPanel:
    """The controls of one page's Share tab.

    Args:
        client: the page.
        session: its simulation.
        notify: tells the user something.
        share: has the page offer a link to the scene.
        shelf: the page's scenes.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        session: Session,
        notify: Callable[[Notice], None],
        share: Callable[[], None],
        shelf: Shelf,
    ) -> None:
        self._shelf = shelf
        self._client = client
        self._session = session
        self._notify = notify
        gui = client.gui
        self._offered = ""
        self._name = gui.add_text("Name", initial_value="")
        self.build()
        self._with_pose = gui.add_checkbox(
            "With pose", initial_value=False, hint="save where every mass is now, too"
        )
        save = gui.add_button("Save", icon=viser.Icon.DEVICE_FLOPPY)
        gui.add_divider()
        link = gui.add_button("Share by a link", icon=viser.Icon.LINK, color="gray")
        download = gui.add_button("Download as a file", icon=viser.Icon.DOWNLOAD, color="gray")
        save_log = gui.add_button("Save a log", icon=viser.Icon.HISTORY, color="gray")
        upload = gui.add_upload_button(
            "Open a file", icon=viser.Icon.UPLOAD, color="gray", mime_type="application/json,.json,.jsonl"
        )
        gui.add_html(ABOUT_LOGS)
        for button, action in (
            (save, self._save),
            (link, share),
            (download, self._download),
            (save_log, self._save_log),
        ):

            @button.on_click
            def _(_: object, action: Callable[[], None] = action) -> None:
                self._try(action)

        @upload.on_upload
        def _(event: viser.GuiEvent[Any]) -> None:
            file = upload.value
            self._try(lambda: self._open_bytes(file.content, file.name))

    def build(self) -> None:
        """Offer the scene's name; what its user typed stays, until the scene has another one."""
        name = self._session.scene.name
        offered = UNNAMED if files.is_built_in(name) else name
        if offered != self._offered:
            self._offered = self._name.value = offered

    # --------------------------------------------------------------------- inside
    def _try(self, action: Callable[[], None]) -> None:
        try:
            action()
        except (SceneError, InputError) as error:
            self._notify(Notice("error", "That did not work", str(error)))

    def _save(self) -> None:
        name = files.safe_name(self._name.value)
        scene = self._session.snapshot(name, self._with_pose.value)
        if files.user_path(name, self._shelf.folder).exists():
            self._confirm(f"Replace the saved scene {name!r}?", "Replace", lambda: self._write(scene, name))
        else:
            self._write(scene, name)

    def _write(self, scene: sim.Scene, name: str) -> None:
        name = self._shelf.save(scene, name)
        if self._session.replay is None:  # which an edit would end
            self._session.post(commands.Change(lambda moment, _: renamed(moment.scene, name)))
        self._notify(Notice("info", "Saved", f"The scene is saved as {name!r}."))

    def _download(self) -> None:
        scene = self._session.snapshot(self._session.scene.name, self._with_pose.value)
        data = files.encode_scene(scene)
        self._client.send_file_download(f"{scene.name}.json", data, save_immediately=True)

    def _save_log(self) -> None:
        name, data = self._session.scene.name, self._session.log_file()
        self._client.send_file_download(f"{name}-log.jsonl", data, save_immediately=True)

    def _open_bytes(self, data: bytes, name: str) -> None:
        try:
            data = as_utf8(data)
        except UnicodeError as error:
            raise InputError(f"{name}: {error}") from None
        if log.is_recorded(data):
            self._session.post(commands.Replay(log.decode_log(data, name)))
        else:
            self._session.post(commands.Open(files.decode_scene(data, name)))

    def _confirm(self, question: str, verb: str, action: Callable[[], None]) -> None:
        with self._client.gui.add_modal("Are you sure?") as modal:
            self._client.gui.add_html(f'<div class="softrod-text">{html.escape(question)}</div>')
            yes = self._client.gui.add_button(verb, color="red")
            no = self._client.gui.add_button("Cancel", color="gray")

        @yes.on_click
        def _(_: object) -> None:
            modal.close()
            self._try(action)

        @no.on_click
        def _(_: object) -> None:
            modal.close()
