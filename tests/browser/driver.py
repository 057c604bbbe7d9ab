"""A page of softrod in a real browser, seen from both sides: what it shows, and what the solver has.

Whatever takes time is waited for by a condition. A fixed pause stands only where nothing may happen.
"""

from __future__ import annotations

import io
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

import imageio.v3 as iio  # viser brings it along
import numpy as np
from numpy.typing import NDArray
from playwright.sync_api import Browser, BrowserContext, ConsoleMessage, FloatRect, Locator, Page

import sim
from app.pages.sandbox.tab import Tab
from app.server.ticker import Ticker
from app.session.commands import Command
from app.session.session import Session
from app.wire.to_page import PageState
from tests.app.inside import sandboxes
from tests.browser.between_frames import FRAME_LOCK, BetweenFrames
from tests.browser.scripts import BLANK, FORGET, FRAMES, HARDWARE, ROUGH

T = TypeVar("T")
Point = tuple[float, float]

ARTIFACTS = Path(__file__).resolve().parents[2] / "artifacts"
"""Where screenshots are left for a look; git ignores it."""

LIMIT = 60.0
"""Seconds after which a condition is given up: generous, since a busy machine draws few frames a second."""

BEAT_BYTES = 100
"""Size of a sign of life at most; whatever else the server sends is larger."""

OPEN_FOLDERS = """() => {
  for (const folder of document.querySelectorAll(".softrod-panel details")) folder.open = true;
}"""

VISERS_ERRORS = (
    # At every press on a node that can be dragged.
    "inside passive event listener",
    # An update of an element that is taken away in the same batch is applied after that.
    "Tried to update non-existent component",
)
"""Errors of viser 1.1.1 that change nothing."""


@dataclass
class Served:
    """A server that runs in the test's own process.

    Attributes:
        url: its address.
        ticker: what runs its pages.
        scene: what a page shows first, where the server can be told; None where it has a scene of its own.
        show_first: tells it.
    """

    url: str
    ticker: Ticker
    scene: sim.Scene | None = None
    show_first: Callable[[sim.Scene], None] = lambda _: None


@dataclass(frozen=True)
class Camera:
    """Where the page looks from; in the page's world, seen by its camera."""

    matrix: NDArray[np.float64]
    target: NDArray[np.float64]
    azimuth: float
    polar: float
    distance: float

    def turned(self, other: Camera) -> bool:
        """Whether one is turned against the other."""
        angles = (self.azimuth - other.azimuth, self.polar - other.polar)
        return bool(np.abs(angles).max() > 1e-6)

    def same(self, other: Camera) -> bool:
        """Whether nothing at all is different."""
        return np.allclose(self.matrix, other.matrix, rtol=0.0, atol=1e-9)


def until(page: Page, condition: Callable[[], T], what: str, limit: float = LIMIT) -> T:
    """Wait until a condition holds, letting the browser's events in, and return what it returned."""
    end, wait = time.monotonic() + limit, 5.0
    while True:
        result = condition()
        if result:
            return result
        if time.monotonic() > end:
            raise AssertionError(f"in {limit:g} s it did not come to this: {what}")
        page.wait_for_timeout(wait)
        wait = min(2.0 * wait, 50.0)


def box_of(element: Locator) -> FloatRect:
    """The place of an element on the screen, CSS px; it has to be visible."""
    box = element.bounding_box()
    assert box is not None, "the element has no box"
    return box


def middle_of(element: Locator) -> Point:
    """The middle of an element on the screen, CSS px."""
    box = box_of(element)
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def rough_context(browser: Browser, pixels: bool = False, **options: Any) -> BrowserContext:
    """A browser profile of its own, made with Playwright's options, that draws no more than tests need.

    Args:
        browser: the browser.
        pixels: whether the canvas is drawn; its rough pixels are asked for by few tests.
        options: those of Playwright's `new_context`.
    """
    context = browser.new_context(**options)
    context.add_init_script(ROUGH if pixels else f"{{{ROUGH}}} {{{BLANK}}}")
    context.set_default_timeout(LIMIT * 1e3)
    return context


class Desk:
    """One open page.

    Attributes:
        page: Playwright's handle.
        errors: what went wrong in the page: uncaught errors, and errors on the console.
        complaints: what WebGL found wrong.
        frames: messages that the server sent, counted in WebSocket frames.
        beats: those among them that are signs of life and say nothing, counted apart.
        client: the number of its connection; -1 while it is empty.
        changed: whether a script of a test runs before the page's own, so that no other test may have it.
        pixels: whether the canvas is drawn.
    """

    def __init__(self, served: Served, context: BrowserContext, pixels: bool = False) -> None:
        self.served = served
        self.context = context
        self.pixels = pixels
        self.page = context.new_page()
        self.errors: list[str] = []
        self.complaints: list[str] = []
        self.frames = self.beats = 0
        self.changed = False
        self.client = -1
        # Without it viser's page draws coarser when it is slow, and pixels would depend on the machine. The
        # gate turns a query away, so the page only believes that it has one.
        self.page.add_init_script(
            "if (location.host) history.replaceState(null, '', '?fixedDpr=' + devicePixelRatio"
            " + location.search.replace('?', '&') + location.hash)"
        )
        self.page.add_init_script(HARDWARE)
        self.page.on("console", self._hear)
        self.page.on("pageerror", lambda error: self.errors.append(f"uncaught: {error}"))
        self.page.on("websocket", lambda socket: socket.on("framereceived", self._count))

    def _hear(self, message: ConsoleMessage) -> None:
        if "GL_INVALID" in message.text or "WebGL: INVALID" in message.text:
            self.complaints.append(message.text)
        elif message.type == "error" and not any(text in message.text for text in VISERS_ERRORS):
            self.errors.append(message.text)

    def _count(self, payload: bytes | str) -> None:
        if len(payload) > BEAT_BYTES:
            self.frames += 1
        else:
            self.beats += 1

    # --------------------------------------------------------------------- opening
    def run_first(self, script: str) -> None:
        """Have a script run before the page's own whenever it is loaded."""
        self.page.add_init_script(script)
        self.changed = True

    def open(self, path: str = "/") -> None:
        """Go to the page (or load it again), and wait until the body is drawn and can be used."""
        known = max([*self.served.ticker.tabs, self.client])
        if self.served.scene is not None:
            self.served.show_first(self.served.scene)
        self.page.goto(self.served.url + path)
        new = self.until(lambda: [c for c in list(self.served.ticker.tabs) if c > known], "the page connects")
        self.client = new[0]
        self.until(lambda: self.tab.session is not None, "the tab has its session")
        self.page.wait_for_function("window.__softrod?.fitted() > 0", timeout=LIMIT * 1e3)
        self.settle()
        self.wait_drawn()

    def leave(self) -> None:
        """Leave the page empty, as a new one but for what the browser has compiled, for another test."""
        self.page.evaluate(FORGET)
        self.page.emulate_media(media="null", reduced_motion="null")
        self.page.goto("about:blank")
        self.context.clear_cookies()
        size = self.page.viewport_size
        assert size is not None
        # Where no control is, and no mass.
        self.page.mouse.move(size["width"] - 1.0, 1.0)
        self.complaints.clear()
        self.frames = 0
        self.client = -1

    def wait_drawn(self) -> None:
        """Wait until every mass in the page is where the server drew it last, and a frame shows it."""
        self.until(self._is_drawn, "the page shows what the server drew")
        self.rest(2)

    def _is_drawn(self) -> bool:
        seen = self.tab.probe()
        if seen.drawn is None:
            return False
        n = len(seen.drawn)
        shown = self.instances("/body/masses")
        if len(shown) != 3 * n:
            return False
        # While a body moves the page is some frames behind; 8 px is far less than any mistake in the drawing.
        return float(np.abs(shown[:n, :2] - seen.drawn).max()) < 8.0 * seen.mapping.scale

    # --------------------------------------------------------------------- the server's side
    @property
    def tab(self) -> Tab:
        """The server's tab of this page."""
        return sandboxes(self.served.ticker)[self.client]

    @property
    def session(self) -> Session:
        """The session of this page; a frame that is being made is waited for."""
        with FRAME_LOCK:
            session = self.tab.session
        assert session is not None
        return session

    @property
    def state(self) -> PageState:
        """What the page was told last."""
        state = self.tab.probe().state
        assert state is not None
        return state

    def is_kept(self) -> bool:
        """Whether the browser has stored the session as it is."""
        probe = self.tab.probe()
        if probe.kept is None or probe.kept.revision != self.session.revision:
            return False
        return self.page.evaluate("sessionStorage.getItem('softrod')") == probe.saved

    @property
    def simulation(self) -> BetweenFrames:
        """The solver of this page; the ticker goes on stepping it, so what is read is a snapshot."""
        return BetweenFrames(self.session.simulation)

    def tell(self, *commands: Command) -> None:
        """Hand commands to the session, past the page, and wait until they are applied."""
        for command in commands:
            self.session.post(command)
        self.until(lambda: not self.session.waiting, "the session takes its commands")
        with FRAME_LOCK:
            pass  # the frame in which it took them is over
        self.rest(1)

    # --------------------------------------------------------------------- waiting
    def until(self, condition: Callable[[], T], what: str, limit: float = LIMIT) -> T:
        """As the function `until`."""
        return until(self.page, condition, what, limit)

    def rest(self, frames: int) -> None:
        """Let the page draw some frames."""
        self.page.evaluate(FRAMES, frames)

    def pause(self, seconds: float) -> None:
        """Let time go by in which something is not to happen."""
        self.page.wait_for_timeout(seconds * 1e3)

    def made_room(self) -> None:
        """Wait until the page has looked twice, each tenth of a second, whether the view needs other room."""
        # The page's own clock: its looks come first, however late it is.
        self.page.evaluate("() => new Promise((done) => setTimeout(done, 220))")

    def settle(self) -> None:
        """Wait until the view shows where the body moves, and stands still."""
        self.page.wait_for_function("window.__softrod.isSettled()", timeout=LIMIT * 1e3)

    def settled(self) -> None:
        """Wait until the body is at rest, as the page says."""
        self.until(lambda: "at rest" in self.hud(), "the body comes to rest", limit=60.0)

    # --------------------------------------------------------------------- what the page shows
    def instances(self, name: str) -> NDArray[np.float64]:
        """(n, 3) places of a node's instances, in the page's world; (0, 3) if there is no such node."""
        return self._matrices(name)[:, 12:15]

    def lengths(self, name: str) -> NDArray[np.float64]:
        """(n,) lengths of a node's instances, in the page's world."""
        return np.hypot(*self._matrices(name)[:, :2].T)

    def _matrices(self, name: str) -> NDArray[np.float64]:
        return np.array(
            self.page.evaluate("name => window.__softrod.instances(name)", name) or [], float
        ).reshape(-1, 16)

    def masses(self) -> NDArray[np.float64]:
        """(n, 2) places of the masses in the page, in px of the scene."""
        places = self.instances("/body/masses")
        mapping = self.tab.probe().mapping
        return np.array([mapping.to_scene(x, y) for x, y, _ in places[: len(places) // 3]])

    def camera(self) -> Camera:
        """Where the page looks from now."""
        seen: dict[str, Any] = self.page.evaluate("window.__softrod.camera()")
        return Camera(
            np.array(seen["matrix"]),
            np.array(seen["target"]),
            seen["azimuth"],
            seen["polar"],
            seen["distance"],
        )

    def at(self, points: Any) -> NDArray[np.float64]:
        """(n, 2) places on the screen, in CSS px, of (n, 2) places in px of the scene."""
        world = self.tab.probe().mapping.to_world(np.asarray(points, float).reshape(-1, 2))
        return np.array(
            self.page.evaluate("places => window.__softrod.project(places)", world.tolist()), float
        )

    def place(self, mass: int) -> Point:
        """Where on the screen a mass is, as the solver has it."""
        x, y = self.at(self.simulation.positions[[mass]])[0]
        return float(x), float(y)

    def scene_at(self, point: Point) -> NDArray[np.float64]:
        """(2,) px of the scene that a place on the screen shows."""
        corners = np.array([(0.0, 0.0), (100.0, 0.0), (0.0, 100.0)])
        origin, right, down = self.at(corners)
        basis = np.column_stack((right - origin, down - origin)) / 100.0
        return np.linalg.solve(basis, np.array(point) - origin)

    def picture(self, save: str | None = None, marks: bool = True) -> NDArray[np.float64]:
        """(h, w, 3) sRGB colours 0..255 of the page, with or without the marks over the body.

        It is also saved in the artifacts, if given a name.
        """
        assert self.pixels, "the canvas is drawn by open_page(pixels=True) alone"
        hidden = ":is(.softrod-overlay, .softrod-marks) { visibility: hidden }"
        data = self.page.screenshot(style=None if marks else hidden)
        if save is not None:
            ARTIFACTS.mkdir(exist_ok=True)
            (ARTIFACTS / save).write_bytes(data)
        return np.asarray(iio.imread(io.BytesIO(data), extension=".png"), float)[:, :, :3]

    def uncovered(self, point: Point) -> bool:
        """Whether the canvas, and nothing over it, is at a place on the screen."""
        question = "([x, y]) => document.elementFromPoint(x, y) === window.__softrod.canvas()"
        return bool(self.page.evaluate(question, list(point)))

    def hud(self) -> str:
        """The head-up display's text."""
        return self.page.locator(".softrod-hud").inner_text()

    def clock(self) -> str:
        """The simulated time that the page shows."""
        return self.page.locator(".softrod-clock").inner_text()

    def clock_is_right(self) -> bool:
        """Whether that is the solver's time, to the last figure shown."""
        return abs(float(self.clock().split()[0]) - self.simulation.time) < 0.0051

    def readout(self, name: str) -> str:
        """A value of the table of the joint that is read out; the Play tab has to be shown."""
        return self.page.locator(f'//td[text()="{name}"]/following-sibling::td').first.inner_text()

    def notices(self) -> list[tuple[str, str]]:
        """(title, text) of the notices that can be seen."""
        script = """notices => notices.map(notice => ["title", "body"].map(
            part => notice.querySelector(`.softrod-notice-${part}`)?.innerText ?? ""))"""
        found = self.page.locator(".softrod-notice").locator("visible=true")
        return [(title, text) for title, text in found.evaluate_all(script)]

    def notice(self, text: str) -> str:
        """Wait until exactly one notice is up, check that it has the text, put it away, and return it."""
        self.until(lambda: text in "".join(map(" ".join, self.notices())), f"a notice with {text!r}")
        notices = self.notices()
        assert len(notices) == 1, notices
        self.dismiss(notices[0][0])
        return " ".join(notices[0])

    def dismiss(self, title: str) -> None:
        """Put away the notices with that title, if there are any."""
        notice = self.page.locator(".softrod-notice").filter(has_text=title)
        for _ in range(notice.count()):
            notice.first.locator("button").click()
        self.until(lambda: notice.count() == 0, f"the notice {title!r} goes away")

    # --------------------------------------------------------------------- the panel
    def show(self, tab: str) -> None:
        """Turn to one of the panel's tabs."""
        self.page.get_by_role("tab", name=tab, exact=True).click()

    def view(self, entry: str) -> None:
        """Press an entry of the View menu."""
        self.button("View").click()
        self.page.locator(".softrod-menu-list button").filter(has_text=entry).click()

    def viewed(self, entry: str) -> bool:
        """Whether a switch of the View menu is on."""
        self.button("View").click()
        item = self.page.locator(".softrod-menu-list button").filter(has_text=entry)
        on = item.get_attribute("aria-checked") == "true"
        self.page.keyboard.press("Escape")
        return on

    def row(self, name: str) -> Locator:
        """The row of a control with that label, in the tab that is shown; its folder is opened."""
        self.page.evaluate(OPEN_FOLDERS)
        label = self.page.locator(".softrod-label").get_by_text(name, exact=True)
        return self.page.locator(".softrod-field").filter(has=label).locator("visible=true").first

    def control(self, name: str) -> Locator:
        """The control with that label; of a slider with a box, the slider."""
        return (
            self.row(name).locator("input[type=range], input[type=checkbox], select, textarea, input").first
        )

    def thumb(self, name: str) -> Locator:
        """The part of a slider that is moved."""
        return self.row(name).get_by_role("slider")

    def slider_value(self, name: str) -> float:
        """Where a slider stands."""
        return float(self.thumb(name).input_value())

    def click_track(self, name: str, part: float) -> None:
        """Click on a slider's track, `part` of the way from its low to its high end."""
        track = self.thumb(name)
        track.scroll_into_view_if_needed()
        box = box_of(track)
        thumb = 16.0  # it does not go beyond the ends
        x = box["x"] + thumb / 2 + part * (box["width"] - thumb)
        self.page.mouse.click(x, box["y"] + box["height"] / 2)

    def box(self, name: str) -> Locator:
        """The number box of a setting."""
        return self.row(name).locator(".softrod-number")

    def type_in(self, name: str, text: str) -> None:
        """Type a number into a setting's box."""
        box = self.box(name)
        box.fill(text)
        box.press("Enter")

    def choose(self, name: str, option: str) -> None:
        """Choose from a dropdown."""
        self.control(name).select_option(option)

    def gallery(self) -> Locator:
        """Open the gallery, and wait until its cards are there."""
        self.page.keyboard.press("o")
        dialog = self.page.get_by_role("dialog", name="Scenes")
        dialog.locator(".softrod-card:visible").first.wait_for()
        return dialog

    def card(self, name: str) -> Locator:
        """The card of a scene in the gallery, which is open."""
        return self.page.locator(f'.softrod-card[data-name="{name}"]')

    def open_scene(self, name: str) -> None:
        """Open a scene from the gallery, and wait until it is there."""
        self.gallery()
        self.card(name).locator(".softrod-open").click()
        self.until(lambda: self.session.scene.name == name, f"{name} is opened")

    def button(self, name: str) -> Locator:
        """A button that can be seen."""
        button = self.page.get_by_role("button", name=name, exact=True)
        return button.and_(self.page.locator(":visible"))

    def chooser(self, title: str) -> Locator:
        """The panel's button that names the scene and leads to others."""
        return self.button(f"{title} Choose another scene")

    # --------------------------------------------------------------------- the mouse
    def take(self, start: Point) -> None:
        """Point somewhere and press the left button."""
        self.page.mouse.move(*start)
        # viser finds out what is under the pointer when it moves, at its own pace.
        self.rest(3)
        self.page.mouse.move(start[0] + 1.0, start[1])
        self.rest(3)
        self.page.mouse.move(*start)
        self.rest(3)
        self.page.mouse.down()
        self.rest(2)

    def lead(self, start: Point, end: Point, steps: int = 8) -> None:
        """Move the pointer in a straight line, a step per frame that the page draws."""
        for i in range(1, steps + 1):
            part = i / steps
            self.page.mouse.move(*(a + (b - a) * part for a, b in zip(start, end, strict=True)))
            self.rest(1)

    def let_go(self) -> None:
        """Release the left button."""
        self.page.mouse.up()
        self.rest(2)

    def drag(self, start: Point, end: Point, steps: int = 8) -> None:
        """Take hold, lead, and let go."""
        self.take(start)
        self.lead(start, end, steps)
        self.let_go()
