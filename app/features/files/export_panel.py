"""The part of the Share tab from which a user takes something home, see `app.export.formats`.

Handlers only queue work in the background. The page itself makes the picture, since it has all that is drawn.
"""

from __future__ import annotations

import threading
from functools import partial
from typing import Any, cast

import viser

from sim.errors import InputError

from ...background import YieldGil, file_worker
from ...export.clip import ClipFrame
from ...export.formats import FORMATS, Format, Options, Source
from ...session.notices import Notice
from ...ui.page import Page
from ...ui.viser.handlers import add_command, on_press
from ...words import joined, say
from ...words.english import refusal, sentence

SECONDS = (1, 20)
"""Of motion that a page can have in a file."""

QUIET = 2.0
"""Seconds after which a file that is not there yet is said to be prepared: others may be made first."""

TEXT = '<div class="softrod-text">{}</div>'


class ExportPanel:
    """The controls.

    Args:
        page: whose body it is.
    """

    def __init__(self, page: Page) -> None:
        self._page, self._client, self._session = page, page.client, page.session
        self._busy = threading.Lock()
        gui = page.client.gui
        gui.add_divider()
        gui.add_html(TEXT.format(say("files-home")))
        self._seconds = gui.add_slider(
            say("files-seconds"),
            *SECONDS,
            step=1,
            initial_value=5,
            hint=say("files-seconds.hint"),
        )
        page.button(
            say("files-picture"),
            viser.Icon.PHOTO,
            lambda: page.perform("picture"),
            hint=say("files-picture.hint"),
        )
        offered = [(each.button, each) for each in FORMATS if each.button is not None]
        for button, wanted in offered:
            if button.icon:
                page.button(
                    say(button.label), cast(viser.IconName, button.icon), partial(self._start, wanted)
                )
        gui.add_html(TEXT.format(say("files-programs")))
        programs = {say(button.label): wanted for button, wanted in offered if not button.icon}
        choice = gui.add_button_group(say("files-body-as"), tuple(programs))
        on_press(choice, lambda: self._start(programs[choice.value]))
        for button, wanted in offered:
            add_command(gui, say(button.command), partial(self._start, wanted))
        page.commas.add(gui)
        self._progress = gui.add_progress_bar(0.0, visible=False)

    def _start(self, wanted: Format) -> None:
        """Have a file made, unless one is being made for this page."""
        if not self._busy.acquire(blocking=False):
            self._tell("warning", say("files-one"), say("files-one.text"))
            return
        self._progress.value = 0.0
        self._progress.visible = True
        # In the language of the page.
        slow = partial(self._tell, "info", say("files-slow"), say("files-slow.text"))
        waiting = threading.Timer(QUIET, slow)
        waiting.daemon = True
        waiting.start()
        file_worker.submit(lambda: self._work(wanted, waiting))

    def _work(self, wanted: Format, waiting: threading.Timer) -> None:
        yield_gil, shown = YieldGil(), 0

        def report(part: float) -> None:
            nonlocal shown
            if round(20.0 * part) > shown:
                shown = round(20.0 * part)
                self._progress.value = 100.0 * part
            yield_gil.pause()

        page, name, button = self._page, self._session.scene.name, wanted.button
        assert button is not None
        try:
            source = self._source(wanted)
            report(0.3)
            options = Options(name, dark=page.looks.dark, decimal_comma=page.commas.on, report=report)
            made = wanted.make(source, options)
            if made.notes:
                about = say("files-about-file" if button.icon else "files-about-program")
                self._tell("info", about, sentence(joined(made.notes, "language-semicolon")))
            data = made.as_one(name)
            self._client.send_file_download(f"{name}.{button.saved_as}", data, save_immediately=True)
        except InputError as error:
            self._tell("error", say("files-failed"), refusal(error))
        except Exception:
            self._tell("error", say("files-failed"), say("files-failed.error"))
            raise
        finally:
            waiting.cancel()
            self._progress.visible = False
            self._busy.release()

    def _source(self, wanted: Format) -> Source:
        """What the page shows, and the seconds before that where they are wanted."""
        seconds = min(max(float(self._seconds.value), SECONDS[0]), SECONDS[1])
        moments = self._session.recent(seconds if wanted.of == "motion" else 0.0)
        if not moments:
            raise InputError(say("files-no-body"))
        # A model is of the body alone, without a ghost.
        frames = [ClipFrame.of(moment, ghost if wanted.of == "motion" else None) for moment, ghost in moments]
        return Source(moments[-1][0], frames, seconds)

    def _tell(self, kind: Any, title: str, text: str) -> None:
        self._page.notify(Notice(kind, title, text))
