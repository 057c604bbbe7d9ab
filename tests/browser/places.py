"""Every page of softrod by its name, each opened once for all that is measured on it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, BrowserContext, Page, ViewportSize

import sim
from app.classroom.answers import Phase
from app.classroom.live import Class
from app.export.live.live import live_html
from app.export.replay import replay_html
from app.features.classroom.roles import desk_address, seat_address, wall_address
from app.session.session import Session
from app.site import pages
from app.site.entries import shown
from app.site.folder import Folder
from tests.app.classrooms import Teacher
from tests.app.test_html_files import Clip, swing
from tests.browser.between_frames import FRAME_LOCK
from tests.browser.classrooms import serving_class
from tests.browser.driver import LIMIT, rough_context
from tests.browser.scripts import HARDWARE

Size = tuple[int, int]
Go = Callable[[Page], object]

DESK, PHONE = (1280, 800), (360, 740)


@dataclass(frozen=True)
class Place:
    """A page.

    Attributes:
        address: of the page, after that of the server or of the folder of files.
        size: of its window as usual, CSS px.
        touch: whether it is touched.
        ready: what is true once it can be used.
        states: what leads from one of its states to the next, by their names.
    """

    address: str
    size: Size = DESK
    touch: bool = False
    ready: str = "true"
    states: dict[str, Go] = field(default_factory=dict)


def _press(selector: str, number: int = 0) -> Go:
    return lambda page: page.locator(selector).nth(number).click()


def _key(key: str) -> Go:
    return lambda page: page.keyboard.press(key)


def _close(page: Page) -> None:
    page.keyboard.press("Escape")


DRAWN = "window.__softrod?.fitted?.() > 0"
MOVES = "window.__softrod?.now().body.time >= 0"
TABS: dict[str, Go] = {
    name: _press("[role=tab]", number) for number, name in enumerate(("play", "measure", "solver", "share"))
}
LAYERS: dict[str, Go] = {
    "view menu": _press(".softrod-menu-lid"),
    "no view menu": _close,
    "access": lambda page: page.evaluate("window.__softrodTest?.('access')"),
}
"""What opens over a sandbox."""


def _opened(entry: int) -> Go:
    """Open an entry of the View menu, counted from its end."""

    def go(page: Page) -> None:
        page.locator(".softrod-menu-lid").click()
        page.locator(".softrod-menu-list button").nth(entry).click()
        page.locator("dialog[open]").wait_for()

    return go


SANDBOX: dict[str, Go] = {
    **TABS,
    "menu": _press(".softrod-menu-lid"),
    "no menu": _close,
    "access": _opened(-2),
    "no access": _close,
    "help": _opened(-1),
    "no help": _close,
    "gallery": _key("o"),
    "no gallery": _close,
    "instruments": _press(".softrod-box-lid"),
    "edit": _key("e"),
}

PHASES = ("ask", "results", "run", "reveal", "explain", "try", "collect")

PLACES: dict[str, Place] = {
    "sandbox": Place("/", ready=DRAWN, states=SANDBOX),
    "phone": Place("/", PHONE, True, DRAWN, SANDBOX),
    "lesson": Place("/?scene=lesson-hooke", ready=DRAWN),
    "lesson on a phone": Place("/?scene=lesson-hooke", PHONE, True, DRAWN),
    "live": Place("file:rope.html", ready=MOVES, states={"view": _press("#view"), "no view": _close}),
    "live on a phone": Place("file:rope.html", PHONE, True, MOVES),
    "live lesson": Place("file:lesson.html", ready=MOVES),
    "live lesson on a phone": Place("file:lesson.html", PHONE, True, MOVES),
    "replay": Place("file:replay.html", ready="window.__softrod?.shown() !== undefined"),
    "gallery": Place("file:site/index.html"),
    "gallery on a phone": Place("file:site/index.html", PHONE, True),
    "shown": Place("file:site/rope.html", ready=MOVES, states={"view": _press("#view"), "no view": _close}),
    "check": Place("/check", PHONE, True),
    "video": Place("/video"),
    "door": Place("/?as=seat&room=QQQQ", PHONE, True),
    "seat": Place("seat", PHONE, True),
    "seat on a laptop": Place("seat"),
    "wall": Place("wall"),
    "desk": Place("desk", ready="document.querySelector('.softrod-desk > header') !== null"),
}


@dataclass
class Places:
    """A server, files, and what a browser shows of them."""

    browser: Browser
    port: int
    folder: Path
    classroom: Class
    teacher: Teacher
    page: Page | None = None
    name: str = ""
    errors: list[str] = field(default_factory=list)
    _contexts: list[BrowserContext] = field(default_factory=list)

    def address(self, place: Place) -> str:
        base, code = f"http://127.0.0.1:{self.port}/", self.classroom.room.code
        if place.address in ("seat", "wall", "desk"):
            return {
                "seat": seat_address(base, code),
                "wall": wall_address(base, code),
                "desk": desk_address(base, self.classroom),
            }[place.address]
        if place.address.startswith("file:"):
            return (self.folder / place.address.removeprefix("file:")).as_uri()
        return base + place.address.removeprefix("/")

    def open(self, name: str, **how: Any) -> Page:
        """A page, which may be open already."""
        if self.page is not None and self.name == name and not how:
            return self.page
        self.close()
        place = PLACES[name]
        viewport: ViewportSize = {"width": place.size[0], "height": place.size[1]}
        context = rough_context(self.browser, viewport=viewport, has_touch=place.touch, **how)
        context.add_init_script(HARDWARE)
        page = context.new_page()
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.goto(self.address(place))
        page.wait_for_function(place.ready, timeout=LIMIT * 1e3)
        page.wait_for_timeout(400)
        self._contexts.append(context)
        self.page, self.name = page, "" if how else name
        return page

    def close(self) -> None:
        """Close what is open."""
        for context in self._contexts:
            context.close()
        self._contexts.clear()
        self.page = None

    def go(self, phase: Phase) -> None:
        """Bring the class to a phase of its step."""
        with FRAME_LOCK:
            self.classroom.room.go(0, phase)
            self.teacher.frame()
            self.teacher.frame()

    def states(self, name: str) -> Iterator[str]:
        """Bring the page from one state to the next."""
        assert self.page is not None
        yield ""
        for state, go in PLACES[name].states.items():
            go(self.page)
            self.page.wait_for_timeout(300)
            if not state.startswith("no "):
                yield state
        if PLACES[name].address in ("seat", "wall", "desk"):
            for phase in PHASES:
                self.go(Phase(phase))
                self.page.wait_for_timeout(400)
                yield phase
            self.go(Phase.LOBBY)


def make_files(folder: Path) -> None:
    """Live files with and without a lesson, a replay, and a gallery as a site."""
    for name, scene in (("rope", "rope"), ("lesson", "lesson-hooke")):
        (folder / f"{name}.html").write_bytes(live_html(sim.Simulation(sim.load_scene(scene)).capture())[0])
    (folder / "replay.html").write_bytes(replay_html(Clip(swing(sim.load_scene("rope")))))
    made = pages.files(shown(["rope", "tree", "ring", "rod", "lesson-hooke"], own=False), "Springs")
    Folder(folder / "site", made).write(made.items())


@contextmanager
def places(browser: Browser, folder: Path, lesson: sim.Scene) -> Iterator[Places]:
    """Serve a class with a lesson, and make the files."""
    make_files(folder)
    with serving_class(lesson, folder / "classes") as (port, classroom):
        with FRAME_LOCK:
            teacher = Teacher(classroom, Session(lesson))
        made = Places(browser, port, folder, classroom, teacher)
        yield made
        made.close()
