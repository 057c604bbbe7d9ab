"""The part of the Share tab from which a user takes something home: a picture, a film, a replay, models,
keyframes, and the body as data and programs.

Handlers only hand work to the workshop. The picture is made by the page itself, which has all that is drawn.
"""

from __future__ import annotations

import io
import threading
import zipfile
from collections.abc import Callable
from functools import partial
from typing import Any

import viser

import sim
from sim.errors import InputError

from ...export.clip import Clip, Shot
from ...export.workshop import Breath, workshop
from ...session.notices import Notice
from ...ui.page import Page
from ...ui.viser.handlers import add_command, on_press

SECONDS = (1, 20)
"""Of motion that a page can have in a file."""

ABOUT = (
    '<div class="softrod-text"><b>Take it home.</b> A picture of the page, a film of the last seconds for '
    "slides and messages, a replay that any browser shows without a network, a live file in which the body "
    "can be dragged and tuned there, too, or a model of it for Blender and the like, still or animated. "
    "Keyframes are a table of where its masses were, 60 times a second.</div>"
)

PROGRAMS = (
    '<div class="softrod-text"><b>For programs.</b> The body as it is now: its numbers as JSON or as CSV '
    "tables, or a program that moves it by the tutorial's step; the one in JavaScript is for games.</div>"
)

Make = Callable[[Callable[[float], None]], tuple[str, bytes]]
"""Makes a file, telling how far it is, 0..1, and returns its ending and its content."""


_JSON, _CSV, _PYTHON, _C, _JAVASCRIPT = "JSON", "CSV", "Python", "C", "JavaScript"
_PROGRAMS = {
    _JSON: "Numbers of the body (JSON)",
    _CSV: "Numbers of the body (tables in CSV)",
    _PYTHON: "Program in Python",
    _C: "Program in C",
    _JAVASCRIPT: "Program in JavaScript, for games",
}
"""Buttons, and the commands that do the same."""


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
        gui.add_html(ABOUT)
        self._seconds = gui.add_slider(
            "Seconds",
            *SECONDS,
            step=1,
            initial_value=5,
            hint="simulated seconds of what moves in a file",
        )
        page.button("Picture", viser.Icon.PHOTO, lambda: page.perform("picture"), hint="key I")
        for label, icon, command, make in (
            ("GIF", viser.Icon.GIF, "Film of the last seconds (GIF)", self._gif),
            ("Replay file", viser.Icon.MOVIE, "Replay file of the last seconds (HTML)", self._replay),
            ("Live file", viser.Icon.WORLD, "Live file of the body as it is now (HTML)", self._live),
            ("3D model", viser.Icon.CUBE, "3D model (GLB)", self._model),
            (
                "Animated model",
                viser.Icon.CUBE_SEND,
                "Animated 3D model of the last seconds (GLB)",
                self._animation,
            ),
            ("Keyframes", viser.Icon.TABLE, "Keyframes of the last seconds (CSV)", self._motion),
        ):
            page.button(label, icon, partial(self._start, make))
            add_command(gui, command, partial(self._start, make))
        gui.add_html(PROGRAMS)
        programs = gui.add_button_group("Body as", tuple(_PROGRAMS))
        for kind, command in _PROGRAMS.items():
            add_command(gui, command, partial(self._start, partial(self._body, kind)))
        page.commas.add(gui)
        self._progress = gui.add_progress_bar(0.0, visible=False)
        on_press(programs, lambda: self._start(partial(self._body, programs.value)))

    def _start(self, make: Make) -> None:
        """Have a file made, unless one is being made for this page."""
        if not self._busy.acquire(blocking=False):
            self._tell("warning", "One at a time", "Another file of this page is still being made.")
            return
        self._progress.value = 0.0
        self._progress.visible = True
        workshop.submit(lambda: self._work(make))

    def _work(self, make: Make) -> None:
        breath, shown = Breath(), 0

        def tell(part: float) -> None:
            nonlocal shown
            if round(20.0 * part) != shown:
                shown = round(20.0 * part)
                self._progress.value = 100.0 * part
            breath.take()

        try:
            name = self._session.scene.name
            ending, data = make(tell)
            self._client.send_file_download(f"{name}.{ending}", data, save_immediately=True)
        except InputError as error:
            self._tell("error", "That did not work", _sentence(str(error)))
        except Exception:
            self._tell("error", "That did not work", "There was an error on the server.")
            raise
        finally:
            self._progress.visible = False
            self._busy.release()

    def _clip(self) -> Clip:
        seconds = min(max(float(self._seconds.value), SECONDS[0]), SECONDS[1])
        moments = self._session.recent(seconds)
        return Clip((Shot.of(moment, ghost) for moment, ghost in moments), seconds)

    def _gif(self, tell: Callable[[float], None]) -> tuple[str, bytes]:
        from ...export import film  # as the others: what a page can do without does not delay its start

        return "gif", film.gif(self._clip(), dark=self._page.looks.dark, progress=tell)

    def _replay(self, tell: Callable[[float], None]) -> tuple[str, bytes]:
        from ...export import replay

        clip = self._clip()
        tell(0.3)
        return "html", replay.replay_html(clip)

    def _live(self, tell: Callable[[float], None]) -> tuple[str, bytes]:
        from ...export.live.live import live_html

        data, notes = live_html(self._moment())
        tell(0.3)
        if notes:
            self._tell("info", "About the file", _sentence("; ".join(notes)))
        return "live.html", data

    def _body(self, kind: str, tell: Callable[[float], None]) -> tuple[str, bytes]:
        from ...export.body.body import Body
        from ...export.body.data import body_csv, body_json
        from ...export.body.program import c_program, python_program
        from ...export.live.program import javascript_program

        moment = self._moment()
        body = Body.of(moment)
        tell(0.3)
        if kind == _JSON:
            return "json", body_json(body)
        if kind == _CSV:
            return "zip", body_csv(body, self._page.commas.on)

        def in_c() -> tuple[str, tuple[bytes, list[str]]]:
            name = body.scene.name
            source, header, notes = c_program(body, name)
            both = io.BytesIO()
            with zipfile.ZipFile(both, "w", zipfile.ZIP_DEFLATED) as file:
                file.writestr(f"{name}.c", source)
                file.writestr(f"{name}.h", header)
            return "c.zip", (both.getvalue(), notes)

        ending, (data, notes) = {
            _PYTHON: lambda: ("py", python_program(body)),
            _C: in_c,
            _JAVASCRIPT: lambda: ("js", javascript_program(moment)),
        }[kind]()
        if notes:
            self._tell("info", "About the program", _sentence("; ".join(notes)))
        return ending, data

    def _model(self, tell: Callable[[float], None]) -> tuple[str, bytes]:
        from ...export.model import glb

        shot = Shot.of(self._moment())
        tell(0.3)
        return "glb", glb(shot.scene, shot.picture)

    def _animation(self, tell: Callable[[float], None]) -> tuple[str, bytes]:
        from ...export.animation import animated_glb
        from ...export.keyframes import FPS

        clip = self._clip()
        tell(0.3)
        return "motion.glb", animated_glb(clip, FPS)

    def _motion(self, tell: Callable[[float], None]) -> tuple[str, bytes]:
        from ...export.keyframes import FPS, motion_csv

        clip = self._clip()
        tell(0.3)
        return "motion.csv", motion_csv(clip, FPS, self._page.commas.on)

    def _moment(self) -> sim.Moment:
        """The one that the page shows."""
        moments = self._session.recent(0.0)
        if not moments:
            raise InputError("there is no body yet")
        return moments[-1][0]

    def _tell(self, kind: Any, title: str, text: str) -> None:
        self._page.notify(Notice(kind, title, text))


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:] + "."
