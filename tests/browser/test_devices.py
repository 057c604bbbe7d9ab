"""What happens to pages on real devices: each page comes back by itself, or says in one sentence what to do.

There are twelve such things, and a test for each: of the sandbox, a pupil's page and a live file, where they
differ.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

import sim
from app.classroom.answers import Phase
from app.classroom.live import Class
from app.export.live.live import live_html
from app.features.classroom.roles import seat_address, wall_address
from app.session import commands
from app.session.session import Session
from tests.app.classrooms import Teacher
from tests.app.inside import sandboxes
from tests.browser.between_frames import FRAME_LOCK
from tests.browser.classrooms import serving_class
from tests.browser.conftest import DESKTOP, FLAGS, OpenPage, Serve, Visits, browser_path
from tests.browser.driver import Desk, Served, rough_context, until
from tests.browser.sites import served as plain_server
from tests.browser.test_class import a_lesson
from tests.browser.wires import wire

WITHIN = 15.0
"""Seconds within which a page is to be back."""

PHONE = (390, 844)
YESTERDAY = 26 * 3600.0
"""Age of a page that was left open, s."""

LOSE = """async (canvas) => {
  canvas.getContext("webgl2").getExtension("WEBGL_lose_context").loseContext();
}"""

REFUSED = """
  const refuse = () => {
    throw new DOMException("The operation is insecure.", "SecurityError");
  };
  const both = { get: refuse, set: refuse };
  Object.defineProperties(window, { localStorage: both, sessionStorage: both });
  Object.defineProperty(Document.prototype, "cookie", both);
"""
"""A browser that is told to store nothing: each access throws."""

TRANSLATED = """() => {
  const untouched = "script, style, noscript, textarea, svg, font, [translate=no]";
  const font = () => Object.assign(document.createElement("font"), { style: "vertical-align: inherit" });
  const translate = (node) => {
    if (node.nodeType !== Node.TEXT_NODE) return void [...node.childNodes].forEach(translate);
    if (!node.data.trim() || !node.parentElement || node.parentElement.closest(untouched)) return;
    const [outer, inner] = [font(), font()];
    inner.append(`«${node.data.trim()}»`);
    outer.append(inner);
    node.replaceWith(outer);
  };
  translate(document.body);
  new MutationObserver((changes) => {
    for (const { addedNodes, target, type } of changes) {
      if (type === "characterData") translate(target);
      for (const node of addedNodes) if (node.isConnected) translate(node);
    }
  }).observe(document.body, { childList: true, subtree: true, characterData: true });
}"""
"""Translates a page as Chrome does: each text is replaced by one in two elements, whenever it changes; a
translation is in angle quotes."""


@dataclass
class School:
    """A server with a class, which stays in the phase in which somebody put it.

    Attributes:
        browser: for its pages.
        port: of the server.
        classroom: the class.
        teacher: somebody who leads it.
        errors: of all pages.
    """

    browser: Browser
    port: int
    classroom: Class
    teacher: Teacher
    contexts: list[BrowserContext] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)

    def go(self, phase: Phase) -> None:
        """Lead the class to a phase."""
        with FRAME_LOCK:
            self.classroom.room.go(0, phase)
            self.teacher.frame()
            self.teacher.frame()

    def open(self, address: str, script: str = "", port: int = 0, **options: Any) -> Page:
        """A page on a phone, at an address of `seat_address` or `wall_address`."""
        context = rough_context(
            self.browser, viewport={"width": PHONE[0], "height": PHONE[1]}, has_touch=True, **options
        )
        self.contexts.append(context)
        if script:
            context.add_init_script(script)
        page = context.new_page()
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.goto(address.replace("PORT", str(port or self.port)))
        return page

    def seat(self, script: str = "", port: int = 0, **options: Any) -> Page:
        """A pupil's page, which is in."""
        page = self.open(seat_address(BASE, self.classroom.room.code), script, port, **options)
        page.locator(".softrod-seat-name").wait_for()
        return page

    def wall(self, script: str = "") -> Page:
        """The wall."""
        page = self.open(wall_address(BASE, self.classroom.room.code), script)
        page.locator(".softrod-wall-side").wait_for(state="attached")
        return page


BASE = "http://127.0.0.1:PORT/"


@pytest.fixture(scope="module")
def building(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[School]:
    """The school of all tests."""
    with serving_class(a_lesson(), tmp_path_factory.mktemp("classes")) as (port, classroom):
        with FRAME_LOCK:
            teacher = Teacher(classroom, Session(a_lesson()))
        yield School(browser, port, classroom, teacher)


@pytest.fixture
def school(building: School) -> Iterator[School]:
    """A class in which each has a body of their own."""
    building.go(Phase.TRY)
    yield building
    for context in building.contexts:
        context.close()
    building.contexts.clear()
    errors, building.errors = building.errors, []
    assert not errors


@pytest.fixture
def live(visit: Visits, tmp_path: Path) -> Callable[..., Page]:
    """Opens a live file."""

    def open_one(name: str = "rope", **how: Any) -> Page:
        path = tmp_path / f"{name}.html"
        path.write_bytes(live_html(sim.Simulation(sim.load_scene(name)).capture())[0])
        return visit(path.as_uri(), **how)

    return open_one


def time_of(page: Page) -> float:
    """The simulated time that a page shows, s."""
    return float(page.evaluate(TIME))


def moves(page: Page) -> None:
    """Wait until a page has its connection, and its body moves."""
    page.wait_for_function(f"window.__softrod && {TIME} !== undefined", timeout=WITHIN * 1e3)
    until(page, lambda: not page.locator("html[data-softrod-away]").count(), "it is connected", WITHIN)
    before = time_of(page)
    until(page, lambda: abs(time_of(page) - before) > 0.05, "the body moves", WITHIN)


TIME = "(__softrod.now ? __softrod.now().body : __softrod.shown().frame)?.time"


def test_graphics_are_lost(open_page: OpenPage, school: School, live: Callable[..., Page]) -> None:
    desk = open_page("ring", pixels=True)
    desk.page.locator("#root canvas").first.evaluate(LOSE)
    alert = desk.page.get_by_role("alert").filter(has_text="The browser no longer draws this page")
    expect(alert).to_be_visible(timeout=2_000)
    alert.get_by_role("button", name="Reload").click()
    expect(alert).to_have_count(0)
    moves(desk.page)
    # A canvas without WebGL comes back by itself, but empty, and a body at rest is not drawn otherwise.
    pupil = school.seat()
    moves(pupil)
    pupil.locator("[data-focus=play]").click()
    pupil.wait_for_timeout(300)
    for page in (pupil,):
        page.locator("#canvas").evaluate(EMPTIED)
        until(page, lambda page=page: page.locator("#canvas").evaluate(INK), "it is drawn again", WITHIN)


EMPTIED = """(canvas) => {
  canvas.getContext("2d").clearRect(0, 0, canvas.width, canvas.height);
  canvas.dispatchEvent(new Event("contextrestored"));
}"""
INK = """(canvas) => {
  const { width, height } = canvas;
  return canvas.getContext("2d").getImageData(0, 0, width, height).data.some((value) => value > 0);
}"""


def test_a_tab_is_duplicated(open_page: OpenPage, school: School) -> None:
    desk = open_page("ring")
    desk.tell(commands.SetValue("gravity", 900.0))
    desk.until(desk.is_kept, "it is kept")
    desk.until(lambda: "900" in desk.page.evaluate("sessionStorage.getItem('softrod')"), "by the page")
    known = desk.client
    with desk.context.expect_page() as opened:
        desk.page.evaluate("void window.open(location.href)")
    twin = opened.value
    moves(twin)
    client = desk.until(
        lambda: [c for c in list(desk.served.ticker.tabs) if c > known], "the twin is connected"
    )[-1]
    session = sandboxes(desk.served.ticker)[client].session
    assert session is not None
    desk.until(lambda: session.scene.gravity == (0.0, 900.0), "it has the same body")
    twin.keyboard.press("Control+z")
    desk.until(lambda: session.scene.gravity != (0.0, 900.0), "and what was done can be undone")
    twin.wait_for_timeout(200)
    assert desk.session.scene.gravity == (0.0, 900.0), "there alone"
    moves(desk.page)
    twin.close()
    # A class has one seat for a browser: the page that was there first says so, and takes it back.
    pupil = school.seat()
    with pupil.context.expect_page() as opened:
        pupil.evaluate("void window.open(location.href)")
    moves(opened.value)
    expect(pupil.locator(".softrod-task")).to_have_text("Another page of this browser has your seat now.")
    pupil.get_by_role("button", name="Come back here").click()
    moves(pupil)


def test_a_page_of_yesterday(open_page: OpenPage, live: Callable[..., Page]) -> None:
    desk = open_page("ring")
    with FRAME_LOCK:
        simulation = desk.session.simulation
        simulation.restore(replace(simulation.capture(), time=YESTERDAY + 0.0123))
    desk.until(lambda: time_of(desk.page) > YESTERDAY, "the page shows a body that has moved for a day")
    moves(desk.page)
    desk.tell(commands.Play(False))
    # In single precision, times would be 8 ms apart.
    desk.until(
        lambda: abs(time_of(desk.page) - desk.simulation.time) < 1e-4, "it shows the time of the solver"
    )
    page = live()
    moves(page)
    page.evaluate(f"__softrod.now().body.time = {YESTERDAY}")
    page.evaluate(AGED)
    moves(page)


AGED = f"""() => {{
  const now = performance.now.bind(performance), ask = requestAnimationFrame.bind(window);
  performance.now = () => now() + {1e3 * YESTERDAY};
  window.requestAnimationFrame = (call) => ask((at) => call(at + {1e3 * YESTERDAY}));
}}"""


def test_a_phone_was_locked(
    browser: Browser, serve: Serve, school: School, live: Callable[..., Page]
) -> None:
    """Pages are frozen, and meanwhile the network forgets their connections without a word."""
    served = serve("ring")
    assert served.scene is not None
    served.show_first(served.scene)
    with ExitStack() as stack:
        wires = [
            stack.enter_context(wire(port)) for port in (int(served.url.rpartition(":")[2]), school.port)
        ]
        context = rough_context(browser, viewport={"width": DESKTOP[0], "height": DESKTOP[1]})
        stack.callback(context.close)
        context.add_init_script(HURRIED)
        desk = Desk(Served(f"http://127.0.0.1:{wires[0].port}", served.ticker), context)
        desk.open()
        pages = [desk.page, school.seat(HURRIED, wires[1].port), live()]
        for page in pages:
            moves(page)
        locks = [page.context.new_cdp_session(page) for page in pages]
        for lock in locks:
            lock.send("Page.setWebLifecycleState", {"state": "frozen"})
        for between in wires:
            between.mute = True
        time.sleep(3.0)
        for between in wires:
            between.mute = False
        for lock in locks:
            lock.send("Page.setWebLifecycleState", {"state": "active"})
        for page, between in zip(pages, [*wires, None], strict=True):
            moves(page)
            assert between is None or between.open, "by a connection of its own"
        assert not desk.errors


HURRIED = "window.__softrodHurry = 4"
"""Has a page lose its patience sooner; `tests/page` tests the times."""


def test_back_and_forward(browser: Browser, serve: Serve, school: School, tmp_path: Path) -> None:
    """In a browser that keeps pages which one leaves, as far as it does."""
    served = serve("ring")
    assert served.scene is not None
    served.show_first(served.scene)
    (tmp_path / "rope.html").write_bytes(live_html(sim.Simulation(sim.load_scene("rope")).capture())[0])
    (tmp_path / "other.html").write_text("<!doctype html><title>Another page</title>")
    with ExitStack() as stack:
        port = stack.enter_context(plain_server(tmp_path))
        kind = browser.browser_type
        keeper = kind.launch(
            executable_path=browser_path(kind),
            args=list(FLAGS),
            ignore_default_args=["--disable-back-forward-cache"],
        )
        stack.callback(keeper.close)
        context = rough_context(keeper, viewport={"width": DESKTOP[0], "height": DESKTOP[1]})
        context.add_init_script(
            "addEventListener('pageshow', ({ persisted }) => (window.wasKept = persisted))"
        )
        for address in (
            f"http://127.0.0.1:{port}/rope.html",
            served.url,
            seat_address(BASE, school.classroom.room.code).replace("PORT", str(school.port)),
        ):
            page = context.new_page()
            page.goto(address)
            moves(page)
            page.goto(f"http://127.0.0.1:{port}/other.html")
            page.go_back(wait_until="commit")
            moves(page)
            assert page.evaluate("window.wasKept") is True
            page.go_forward(wait_until="commit")
            expect(page).to_have_title("Another page")
            page.go_back(wait_until="commit")
            moves(page)
            page.close()


def test_a_window_without_focus(open_page: OpenPage, school: School, live: Callable[..., Page]) -> None:
    desk = open_page("ring")
    pages = [desk.page, school.seat(), live("buggy")]
    for page in pages:
        page.keyboard.down("ArrowRight")
    desk.until(lambda: bool(desk.simulation.keys), "the key is held")
    until(pages[2], lambda: pages[2].evaluate("__softrod.now().body.steered[0]") > 0, "it drives")
    for page in pages:
        page.evaluate("window.dispatchEvent(new Event('blur'))")
    desk.until(lambda: not desk.simulation.keys, "and no more")
    until(pages[2], lambda: pages[2].evaluate("__softrod.now().body.steered[0]") == 0.0, "and no more")
    for page in pages:
        moves(page)


def revision(desk: Desk) -> int:
    """Of the session as the server has sent it to be kept; -1 for none."""
    sent = desk.tab.probe().kept
    return -1 if sent is None else sent.revision


def test_storage_is_refused(
    browser: Browser, serve: Serve, school: School, live: Callable[..., Page]
) -> None:
    served = serve("ring")
    assert served.scene is not None
    served.show_first(served.scene)
    context = rough_context(browser, viewport={"width": DESKTOP[0], "height": DESKTOP[1]})
    context.add_init_script(REFUSED + HURRIED)
    with wire(int(served.url.rpartition(":")[2])) as between:
        desk = Desk(Served(f"http://127.0.0.1:{between.port}", served.ticker), context)
        desk.open()
        moves(desk.page)
        # The page has the body for as long as it is open: through an outage, too.
        desk.tell(commands.SetValue("gravity", 900.0))
        desk.until(lambda: revision(desk) == desk.session.revision, "it is kept")
        desk.pause(0.3)
        known = desk.client
        between.mute = True
        desk.page.get_by_text("Not connected").wait_for()
        between.mute = False
        client = desk.until(
            lambda: [c for c in list(served.ticker.tabs) if c > known], "the page connects anew"
        )[-1]
        desk.client = client
        desk.until(lambda: desk.tab.session is not None, "it has a session")
        desk.until(lambda: desk.session.scene.gravity == (0.0, 900.0), "with the same body")
        moves(desk.page)
        assert not desk.errors
        context.close()
    pupil = school.seat(REFUSED)
    moves(pupil)
    school.go(Phase.ASK)
    pupil.locator("[data-focus=choice0]").click()
    until(pupil, lambda: school.classroom.room.bars(0, 0)[0] >= 1, "the answer counts")


def test_sound_is_interrupted(open_page: OpenPage) -> None:
    desk = open_page("bridge")
    page = desk.page
    page.evaluate(CALLS)
    page.keyboard.press("v")
    sound = page.locator(".softrod-modes-sound")
    expect(sound).to_be_enabled()
    sound.click()
    page.wait_for_function("window.heard?.state === 'running'")
    # While there is a call the sound cannot go on; after it, it does.
    page.evaluate("window.calls = true; heard.suspend()")
    page.wait_for_timeout(1_200)
    assert page.evaluate("heard.state") == "suspended"
    page.evaluate("window.calls = false")
    page.wait_for_function("heard.state === 'running'", timeout=WITHIN * 1e3)
    assert sound.get_attribute("aria-pressed") == "true"


CALLS = """() => {
  const Real = AudioContext;
  window.AudioContext = class extends Real {
    constructor() {
      super();
      window.heard = this;
    }
    resume() {
      return window.calls ? Promise.reject(new DOMException("a call", "InvalidStateError")) : super.resume();
    }
  };
}"""
"""As on a phone: while there is a call, no page may go on with its sound."""


def test_a_page_is_translated(open_page: OpenPage, school: School, live: Callable[..., Page]) -> None:
    desk = open_page("ring")
    pupil, wall, file = school.seat(), school.wall(), live("buggy")
    for page in (desk.page, pupil, wall, file):
        page.evaluate(TRANSLATED)
    page = desk.page
    expect(page.get_by_role("tab", name="«Play»")).to_be_visible()
    # Acts work, and what changes says what is true now.
    moves(page)
    page.keyboard.press("Space")
    desk.until(lambda: not desk.session.playing, "it pauses")
    expect(page.locator(".softrod-hud")).to_contain_text("«")
    page.keyboard.press("r")
    page.get_by_role("tab", name="«Measure»").click()
    charts = page.locator(".softrod-panel .softrod-chart")
    had = charts.count()
    page.get_by_role("button", name="«New plot»").first.click()
    desk.until(lambda: charts.count() > had, "it is there")
    page.get_by_role("tab", name="«Play»").click()
    stiffness = page.locator(".softrod-panel input[type=range]").locator("visible=true").first
    before = desk.session.scene
    stiffness.focus()
    page.keyboard.press("ArrowRight")
    desk.until(lambda: desk.session.scene != before, "a slider is moved")
    page.keyboard.press("Control+z")
    desk.until(lambda: desk.session.scene == before, "and moved back")
    page.get_by_role("button", name="«Ring»").first.click()
    page.locator('.softrod-card[data-name="rope"] .softrod-open').click()
    expect(page.get_by_role("button", name="«Rope»").first).to_be_visible()
    assert not page.locator(":is(kbd, .softrod-unit, .softrod-clock, [translate=no]) font").count()
    # A pupil answers, and reads what is to be done next.
    school.go(Phase.ASK)
    expect(pupil.locator(".softrod-task")).to_contain_text("«Move the pale body")
    pupil.locator("[data-focus=choice1]").click()
    until(pupil, lambda: school.classroom.room.bars(0, 0)[1] >= 1, "the answer counts")
    pupil.locator("[data-focus='step down']").click()
    pupil.locator("[data-focus=predict]").click()
    expect(pupil.locator(".softrod-task")).to_have_text(
        "«You can still change it. Nobody else can see it yet.»"
    )
    school.go(Phase.TRY)
    pupil.locator("[data-focus=play]").click()
    expect(pupil.locator("[data-focus=play]")).to_have_text("«Play»")
    school.go(Phase.LOBBY)
    expect(wall.locator(".softrod-wall-code")).to_have_text(school.classroom.room.code)
    expect(pupil.locator(".softrod-seat-name")).to_have_text(re.compile("^[A-Z][a-z]+ [A-Z][a-z]+$"))
    # And a file is steered.
    file.get_by_role("button", name="Pause").click()
    expect(file.get_by_role("button", name="Play")).to_be_visible()
    file.get_by_role("button", name="Play").click()
    moves(file)
    file.get_by_role("slider").first.focus()
    file.keyboard.press("End")
    assert not file.locator("[translate=no] font").count()


def test_the_screen_stays_on_while_the_class_waits_for_an_answer(school: School) -> None:
    pupil, wall = school.seat(AWAKE), school.wall(AWAKE)
    dark = school.seat("delete Navigator.prototype.wakeLock")  # as on a page without TLS
    held = "window.held.size"
    until(wall, lambda: wall.evaluate(held) == 1, "the wall stays on")
    moves(pupil)
    assert pupil.evaluate(held) == 0, "a body alone is no reason"
    school.go(Phase.ASK)
    until(pupil, lambda: pupil.evaluate(held) == 1, "there is a question")
    # The browser takes it back from a page that is hidden, and the page asks again once it is shown.
    for page in (pupil, wall):
        page.evaluate("window.hide(true)")
        assert page.evaluate(held) == 0
        page.evaluate("window.hide(false)")
        until(page, lambda page=page: page.evaluate(held) == 1, "the page is shown again")
    school.go(Phase.RESULTS)
    until(pupil, lambda: pupil.evaluate(held) == 0, "the question is closed")
    # What is refused is asked for again when the page is shown the next time.
    pupil.evaluate("window.refuses = true")
    school.go(Phase.EXPLAIN)
    expect(pupil.get_by_label("Because")).to_be_visible()
    expect(dark.get_by_label("Because")).to_be_visible()
    pupil.evaluate("window.hide(true); window.refuses = false; window.hide(false)")
    until(pupil, lambda: pupil.evaluate(held) == 1, "it is asked for again")
    assert wall.evaluate("window.asked") == 2, "and no more often than needed"


AWAKE = """
  Object.assign(window, { held: new Set(), asked: 0, refuses: false });
  let hidden = false;
  Object.defineProperty(document, "visibilityState", { get: () => (hidden ? "hidden" : "visible") });
  const request = async () => {
    window.asked += 1;
    if (window.refuses || hidden) throw new DOMException("not now", "NotAllowedError");
    const lock = { released: false, release() { lock.released = true; window.held.delete(lock); } };
    window.held.add(lock);
    return lock;
  };
  Object.defineProperty(Navigator.prototype, "wakeLock", { value: { request }, configurable: true });
  window.hide = (to) => {
    hidden = to;
    if (to) for (const lock of window.held) lock.release();
    document.dispatchEvent(new Event("visibilitychange"));
  };
"""
"""A screen as on a phone, which can be kept on."""


def test_without_webgl(browser: Browser, serve: Serve, school: School, live: Callable[..., Page]) -> None:
    context = browser.new_context()
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.add_init_script(NO_WEBGL)
    served = serve("ring")
    tabs = len(served.ticker.tabs)
    page.goto(served.url)
    expect(page.get_by_role("alert")).to_contain_text(
        "softrod draws with WebGL 2, which this browser does not"
    )
    page.wait_for_timeout(300)
    assert page.locator("#root *").count() == 0
    assert page.get_by_text("Loading…").is_hidden()
    assert len(served.ticker.tabs) == tabs
    assert not errors
    context.close()
    # A class and a file need none.
    for other in (school.seat(NO_WEBGL), live(script=NO_WEBGL)):
        moves(other)


def test_without_javascript(
    browser: Browser, serve: Serve, school: School, live: Callable[..., Page]
) -> None:
    file = live(java_script_enabled=False)
    assert file.title() == file.locator("h1").inner_text() == "Rope"
    picture = file.get_by_role("img", name="Rope")
    assert picture.evaluate("async (image) => (await image.decode(), image.naturalWidth)") == 480
    assert "Open the file in a web browser, and it moves." in file.locator("header").inner_text()
    assert file.locator("button, input, select, canvas").locator("visible=true").count() == 0
    seat = seat_address(BASE, school.classroom.room.code)
    pupil = school.open(seat, java_script_enabled=False)
    assert (
        pupil.locator("body").inner_text().strip() == "A class needs JavaScript, which is switched off here."
    )
    page = school.open(serve("ring").url, java_script_enabled=False)
    said = page.locator(".softrod-loading").inner_text()
    assert "JavaScript" in said
    assert "Loading" not in said


def test_a_finger_pulls_down(open_page: OpenPage, school: School, live: Callable[..., Page]) -> None:
    """No browser here reloads a page that is pulled; others do where the page lets them."""
    school.go(Phase.ASK)
    desk = open_page("ring", size=PHONE, phone=True)
    pages = [desk.page, school.seat(), live(size=PHONE, has_touch=True)]
    for page in pages:
        until(page, lambda page=page: page.evaluate("Boolean(window.__softrod)"), "it is there")
        assert page.evaluate(PULLED) == "none"
        page.evaluate("window.canceled = 0; addEventListener('pointercancel', () => (canceled += 1), true)")
        box = page.locator("canvas").first.bounding_box()
        assert box is not None
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 3
        finger = page.context.new_cdp_session(page)
        for kind, down in [("touchStart", 0), *(("touchMove", 25 * i) for i in range(1, 9)), ("touchEnd", 0)]:
            points = [] if kind == "touchEnd" else [{"x": x, "y": y + down}]
            finger.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        page.wait_for_timeout(100)
        assert page.evaluate("window.canceled") == 0, "the drag was a scroll"


PULLED = "getComputedStyle(document.documentElement).overscrollBehaviorY"
NO_WEBGL = """
  const real = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return kind.startsWith("webgl") ? null : real.call(this, kind, options);
  };
"""
