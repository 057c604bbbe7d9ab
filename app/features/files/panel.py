"""The Share tab: saving, downloading and uploading scenes, and logs; the gallery has those that are saved.

Handlers run in viser's thread pool, since they touch the disk; the running simulation is never touched
unless a scene was read and found valid.
"""

from __future__ import annotations

import html
import urllib.parse
from collections.abc import Callable
from functools import partial

import viser

import sim
from sim.design.measurements import Measurement, parse_measurements
from sim.edit.lesson import OWN_LESSON
from sim.edit.texts import UNNAMED, renamed
from sim.errors import InputError, SceneError
from sim.store import files
from sim.store.places import as_utf8
from sim.text import Text

from ...session import commands, log
from ...session.session import Notice
from ...ui.commands import text_of
from ...ui.kept import keeping
from ...ui.page import Page
from ...ui.viser.handlers import on_press
from ...words import quoted, say
from ...words.english import of

TEXT = '<div class="softrod-text">{}</div>'


class FilesPanel:
    """The controls of one page's Share tab.

    Args:
        page: whose scene it is.
    """

    def __init__(self, page: Page) -> None:
        self._shelf, self._client = page.shelf, page.client
        self._session, self._notify = page.session, page.notify
        gui = page.client.gui
        self._offered = ""
        self._name = gui.add_text(say("files-name"), initial_value="")
        self.build()
        self._with_pose = gui.add_checkbox(
            say("files-pose"), initial_value=False, hint=say("files-pose.hint")
        )
        save = gui.add_button(say("files-save"), icon=viser.Icon.DEVICE_FLOPPY)
        on_press(save, lambda: self._try(self._save), blocks=True)
        gui.add_divider()
        for name, row in page.commands.items():
            if row.share is not None and row.needs in page.controls:
                page.button(text_of(name, "share"), row.share, partial(page.perform, name))
        for label, icon, action in (
            (say("files-download"), viser.Icon.DOWNLOAD, self._download),
            (say("files-save-log"), viser.Icon.HISTORY, self._save_log),
        ):
            page.button(label, icon, partial(self._try, action), blocks=True)
        gui.add_button(say("files-open"), icon=viser.Icon.UPLOAD, color="gray")  # the script acts on it
        gui.add_html(TEXT.format(say("files-about-logs")))

    def build(self) -> None:
        """Offer the scene's name; what its user typed stays, until the scene has another one."""
        name = self._session.scene.name
        given = UNNAMED if files.is_built_in(name) else name
        offered = of(given) if given in (UNNAMED, OWN_LESSON) else given
        if offered != self._offered:
            self._offered = self._name.value = offered

    # --------------------------------------------------------------------- inside
    def _try(self, action: Callable[[], None]) -> None:
        try:
            action()
        except (SceneError, InputError) as error:
            self._notify(Notice("error", say("files-failed"), str(error)))

    def _save(self) -> None:
        typed = self._name.value.strip()
        name = files.safe_name(typed)
        scene = self._session.snapshot(name, self._with_pose.value)
        if files.user_path(name, self._shelf.folder).exists():
            self._confirm(say("files-replace", name=quoted(name)), lambda: self._write(scene, name, typed))
        else:
            self._write(scene, name, typed)

    def _write(self, scene: sim.Scene, name: str, typed: str) -> None:
        name = self._shelf.save(scene, name)
        if self._session.replay is None:  # which an edit would end
            self._session.post(commands.Change(lambda moment, _: renamed(moment.scene, name)))
        said = say("files-saved.text", name=quoted(name))
        if name != typed.removesuffix(".json"):
            said = say("files-saved.other", name=quoted(name), typed=quoted(typed))
        self._notify(Notice("info", say("files-saved"), said))

    def _download(self) -> None:
        scene = self._session.snapshot(self._session.scene.name, self._with_pose.value)
        data = files.encode_scene(scene)
        self._client.send_file_download(f"{scene.name}.json", data, save_immediately=True)

    def _save_log(self) -> None:
        name, data = self._session.scene.name, self._session.log_file()
        self._client.send_file_download(f"{name}-log.jsonl", data, save_immediately=True)

    def _confirm(self, question: str, action: Callable[[], None]) -> None:
        with self._client.gui.add_modal(say("files-sure")) as modal:
            self._client.gui.add_html(TEXT.format(html.escape(question)))
            yes = self._client.gui.add_button(say("files-replace.yes"), color="red")
            no = self._client.gui.add_button(say("files-replace.no"), color="gray")

        def confirmed() -> None:
            modal.close()
            self._try(action)

        on_press(yes, confirmed, blocks=True)
        on_press(no, modal.close)


_TABLES = (".csv", ".tsv", ".txt", ".dat")
"""How the names of files end that are tables of what was measured."""


def open_file(page: Page, letters: str) -> None:
    """Open a scene, a log or a table of what was measured that a page sends, or say why not.

    Args:
        page: which.
        letters: the file's name as in an address, a colon, and the file as `keeping.unpacked` takes it.
    """
    quoted, _, packed = letters.partition(":")
    name = urllib.parse.unquote(quoted)[:255]
    session, notify = page.session, page.notify
    try:
        data = keeping.unpacked(packed)
        if name.lower().endswith(_TABLES):
            _open_tables(page, parse_measurements(data, name))
            return
        data = as_utf8(data)
        if log.is_recorded(data):
            session.post(commands.Replay(log.decode_log(data, name)))
        else:
            session.post(commands.Open(files.decode_scene(data, name)))
    except (SceneError, InputError) as error:
        notify(Notice("error", say("files-failed"), str(error)))
    except ValueError as error:
        notify(Notice("error", say("files-failed"), Text("{name}: {error}", name=name, error=str(error))))


def _open_tables(page: Page, tables: tuple[Measurement, ...]) -> None:
    """Have the runs of a table offered in the Measure tab.

    Raises:
        InputError: there is no such tab.
    """

    def take() -> None:
        if page.take_tables is not None:
            page.take_tables(tables)

    if page.take_tables is None:
        raise InputError(say("files-no-measure", table=tables[0].name))
    page.later(take)
