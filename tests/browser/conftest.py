"""The browser, servers in the test's own process, and pages on them."""

from __future__ import annotations

import os
import re
import shutil
from collections import Counter, defaultdict
from collections.abc import Callable, Generator, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest
import viser
from msgspec.structs import replace
from playwright.sync_api import Browser, BrowserContext, BrowserType, Page, ViewportSize, sync_playwright

import sim
from app.pages.sandbox.tab import Tab
from app.server import serve as server_of_pages
from app.server.serve import serving
from app.ui.ticked import RunInThread
from sim.compiling.compiler import ENTRY_POINTS
from tests.amount import has_its_turn
from tests.browser.between_frames import FRAME_LOCK
from tests.browser.driver import ARTIFACTS, LIMIT, Desk, Served, rough_context

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
FLAGS = (
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    # WebGL without a graphics card.
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
    # The picture is put together without WebGL, whose every pixel costs when the processor draws it.
    "--disable-gpu-compositing",
    # No page lives long enough to earn back what optimised code costs.
    "--js-flags=--no-opt --no-maglev",
    # Playwright's own list, which this replaces, and the address bar's pages, of which each window has one.
    "--disable-features=AvoidUnnecessaryBeforeUnloadCheckSync,DestroyProfileOnBrowserClose,HttpsUpgrades,"
    "LensOverlay,MediaRouter,OptimizationHints,PaintHolding,ThirdPartyStoragePartitioning,AimEnabled,"
    "WebUIOmniboxPopup,WebUIOmniboxAimPopup,WebUIOmniboxFullPopup",
)
FEW = 100
"""Tests of browsers that all run by day if no more are asked for."""
DESKTOP = (880, 580)
"""Size of the pages of most tests: large enough for all controls, and quick to draw in software."""

Serve = Callable[[str], Served]
OpenPage = Callable[..., Desk]
Kind = tuple[bool, bool, bool]
"""Of a page: whether it is touched, whether its canvas is drawn, and whether smoothly."""


def browser_path(chromium: BrowserType) -> str:
    """A Chromium or Chrome on this machine."""
    asked = os.environ.get("SOFTROD_BROWSER")
    if asked is not None:
        path = shutil.which(asked)
        if path is None:
            pytest.fail(f"SOFTROD_BROWSER is {asked!r}, which is no program that can be run.", pytrace=False)
        return path
    found = next(filter(None, map(shutil.which, NAMES)), None) or chromium.executable_path
    if not Path(found).exists():
        pytest.fail(
            "These tests need Chromium or Chrome: install one, or name one in SOFTROD_BROWSER.", pytrace=False
        )
    return found


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """One browser for all tests; each has pages of its own."""
    with sync_playwright() as playwright:
        path = browser_path(playwright.chromium)
        browser = playwright.chromium.launch(executable_path=path, args=list(FLAGS), headless=True)
        yield browser
        browser.close()


@pytest.fixture(scope="session", autouse=True)
def data_folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Where scenes are saved: never the user's own folder."""
    folder = tmp_path_factory.mktemp("data")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_DATA_HOME", str(folder))
        yield folder


@pytest.fixture(scope="session", autouse=True)
def frames_are_whole() -> Iterator[None]:
    """The solver is the ticker's alone: a test, which is another thread, sees it only between two frames."""
    frame = Tab.frame

    def alone(tab: Tab, budget: float, beside: RunInThread) -> None:
        with FRAME_LOCK:
            frame(tab, budget, beside)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Tab, "frame", alone)
        yield


@pytest.fixture(scope="session")
def serve() -> Iterator[Serve]:
    """The one server of all tests that need none of their own, told which scene a page shows first.

    A browser compiles the scripts of one address once, whatever the page shows.
    """
    own = first = replace(sim.load_scene("tutorial-3.3"))

    def show_first(scene: sim.Scene) -> None:
        nonlocal first
        first = scene

    def make(client: viser.ClientHandle, scene: sim.Scene, *rest: Any) -> Tab:
        return Tab(client, first if scene is own else scene, *rest)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(server_of_pages, "Tab", make)
        with serving(own, "127.0.0.1", 0) as (server, ticker, compiler):
            compiler.want(ENTRY_POINTS)
            compiler.start()
            compiler.wait()
            url = f"http://127.0.0.1:{server.get_port()}"
            yield lambda name: Served(url, ticker, sim.load_scene(name), show_first)


class Visits:
    """Opens files and pages, each in a browser profile of its own.

    Attributes:
        asked: the addresses of all that was requested.
        errors: of all pages.
    """

    def __init__(self, browser: Browser) -> None:
        self._browser = browser
        self._contexts: list[BrowserContext] = []
        self.asked: list[str] = []
        self.errors: list[str] = []

    def __call__(self, address: str, size: tuple[int, int] = DESKTOP, script: str = "", **how: Any) -> Page:
        """Open an address; what is on the disk without a network. A script may run before the page's own."""
        viewport: ViewportSize = {"width": size[0], "height": size[1]}
        context = self._browser.new_context(viewport=viewport, offline=address.startswith("file:"), **how)
        self._contexts.append(context)
        if script:
            context.add_init_script(script)
        page = context.new_page()
        page.on("request", lambda request: self.asked.append(request.url))
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.on("console", lambda message: self.errors.append(message.text))
        page.goto(address)
        return page

    def close(self) -> None:
        """Close all of them."""
        for context in self._contexts:
            context.close()


@pytest.fixture
def visit(browser: Browser) -> Iterator[Visits]:
    """Opens files and pages, and looks after the test whether they had errors."""
    visits = Visits(browser)
    yield visits
    visits.close()
    assert not visits.errors


@pytest.fixture(scope="session")
def idle() -> defaultdict[Kind, list[Desk]]:
    """Empty pages of each kind, which tests have left: they have viser's scripts compiled, so that the next
    test's page is there in half the time."""
    return defaultdict(list)


@pytest.fixture
def open_page(
    browser: Browser, serve: Serve, idle: defaultdict[Kind, list[Desk]], request: pytest.FixtureRequest
) -> Iterator[OpenPage]:
    """Opens pages, each in a browser profile of its own or in one that the test before has left empty, and
    looks after the test whether they had errors.

    The canvas of a page is drawn roughly with `pixels`, as for a user with `smooth`, and else not at all.
    """
    desks: list[tuple[Kind, Desk]] = []

    def open_one(
        scene: str = "tutorial-3.3",
        size: tuple[int, int] = DESKTOP,
        phone: bool = False,
        pixels: bool = False,
        smooth: bool = False,
        path: str = "/",
    ) -> Desk:
        served, kind = serve(scene), (phone, pixels, smooth)
        if idle[kind]:
            desk = idle[kind].pop()
            desk.served = served
            desk.page.set_viewport_size({"width": size[0], "height": size[1]})
        else:
            new = browser.new_context if smooth else partial(rough_context, browser, pixels)
            context = new(
                viewport={"width": size[0], "height": size[1]},
                has_touch=phone,
                device_scale_factor=2 if phone else 1,
                accept_downloads=True,
            )
            context.set_default_timeout(LIMIT * 1e3)
            desk = Desk(served, context, pixels or smooth)
        desks.append((kind, desk))
        desk.open(path)
        return desk

    yield open_one
    failed = getattr(request.node, "has_failed", False)
    if failed:
        ARTIFACTS.mkdir(exist_ok=True)
        name = re.sub(r"\W+", "-", request.node.name)
        for i, (_, desk) in enumerate(desks):
            if not desk.page.is_closed():
                desk.page.screenshot(path=ARTIFACTS / f"failed-{name}-{i}.png")
    errors: list[str] = []
    for kind, desk in desks:
        keep = len(idle[kind]) < 2 and not (failed or desk.changed or desk.page.is_closed())
        if keep:
            desk.leave()
        errors += desk.errors
        if keep and not desk.errors:
            idle[kind].append(desk)
        else:
            desk.context.close()
    assert not errors, errors


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """A test that fails is run once more, since a browser on a loaded machine is late now and then. The
    summary names it all the same: it is to wait for what it looks at.

    By day, a fifth of the tests of each file run, the next days the others, unless few are asked for. So a
    whole run stays within minutes; what breaks is found within five days, and by night at once.
    """
    here = [item for item in items if item.path.is_relative_to(Path(__file__).parent)]
    counts: Counter[Path] = Counter()
    for item in here:
        item.add_marker(pytest.mark.flaky(reruns=1))
        if len(here) > FEW and not has_its_turn(counts[item.path]):
            item.add_marker(pytest.mark.skip(reason="its turn is another day"))
        counts[item.path] += 1


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Tell the fixtures whether their test failed, for a screenshot of it."""
    report = yield
    if report.when == "call":
        item.has_failed = report.failed  # type: ignore[attr-defined]
    return report
