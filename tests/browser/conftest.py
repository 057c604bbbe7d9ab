"""The browser, servers in the test's own process, and pages on them."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Callable, Generator, Iterator
from contextlib import ExitStack
from functools import partial
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Playwright, sync_playwright

import sim
from app.page.tab import Submit, Tab
from app.server.serve import serving
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
)
DESKTOP = (880, 580)
"""Size of the pages of most tests: large enough for all controls, and quick to draw in software."""

Serve = Callable[[str], Served]
OpenPage = Callable[..., Desk]


def browser_path(playwright: Playwright) -> str:
    """A Chromium or Chrome on this machine."""
    asked = os.environ.get("SOFTROD_BROWSER")
    if asked is not None:
        path = shutil.which(asked)
        if path is None:
            pytest.fail(f"SOFTROD_BROWSER is {asked!r}, which is no program that can be run.", pytrace=False)
        return path
    found = next(filter(None, map(shutil.which, NAMES)), None) or playwright.chromium.executable_path
    if not Path(found).exists():
        pytest.fail(
            "These tests need Chromium or Chrome: install one, or name one in SOFTROD_BROWSER.", pytrace=False
        )
    return found


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """One browser for all tests; each has pages of its own."""
    with sync_playwright() as playwright:
        path = browser_path(playwright)
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

    def alone(tab: Tab, budget: float, beside: Submit) -> None:
        with FRAME_LOCK:
            frame(tab, budget, beside)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Tab, "frame", alone)
        yield


@pytest.fixture(scope="module")
def serve() -> Iterator[Serve]:
    """Starts a server that shows a preset first; those of one module are shared by its tests."""
    running: dict[str, Served] = {}
    with ExitStack() as stack:

        def start(scene: str) -> Served:
            if scene not in running:
                server, ticker, compiler = stack.enter_context(serving(sim.load_scene(scene), "127.0.0.1", 0))
                compiler.start()
                compiler.wait()
                running[scene] = Served(f"http://127.0.0.1:{server.get_port()}", ticker)
            return running[scene]

        yield start


@pytest.fixture(scope="session")
def idle() -> list[Desk]:
    """Empty pages of the usual kind, which tests have left: they have viser's scripts compiled, so that the
    next test's page is there in half the time."""
    return []


@pytest.fixture
def open_page(
    browser: Browser, serve: Serve, idle: list[Desk], request: pytest.FixtureRequest
) -> Iterator[OpenPage]:
    """Opens pages, each in a browser profile of its own or in one that the test before has left empty, and
    looks after the test whether they had errors."""
    desks: list[Desk] = []
    usual: list[Desk] = []

    def open_one(
        scene: str = "tutorial-3.3",
        size: tuple[int, int] = DESKTOP,
        phone: bool = False,
        smooth: bool = False,
        path: str = "/",
    ) -> Desk:
        served = serve(scene)
        is_usual = not phone and not smooth
        if is_usual and idle:
            desk = idle.pop()
            desk.served = served
            desk.page.set_viewport_size({"width": size[0], "height": size[1]})
        else:
            new = browser.new_context if smooth else partial(rough_context, browser)
            context = new(
                viewport={"width": size[0], "height": size[1]},
                has_touch=phone,
                device_scale_factor=2 if phone else 1,
                accept_downloads=True,
            )
            context.set_default_timeout(LIMIT * 1e3)
            desk = Desk(served, context)
        desks.append(desk)
        if is_usual:
            usual.append(desk)
        desk.open(path)
        return desk

    yield open_one
    failed = getattr(request.node, "has_failed", False)
    if failed:
        ARTIFACTS.mkdir(exist_ok=True)
        name = re.sub(r"\W+", "-", request.node.name)
        for i, desk in enumerate(desks):
            if not desk.page.is_closed():
                desk.page.screenshot(path=ARTIFACTS / f"failed-{name}-{i}.png")
    errors: list[str] = []
    for desk in desks:
        keep = desk in usual and len(idle) < 2 and not (failed or desk.changed or desk.page.is_closed())
        if keep:
            desk.leave()
        errors += desk.errors
        if keep and not desk.errors:
            idle.append(desk)
        else:
            desk.context.close()
    assert not errors, errors


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """A test that fails is run once more, since a browser on a loaded machine is late now and then. The
    summary names it all the same: it is to wait for what it looks at."""
    for item in items:
        if item.path.is_relative_to(Path(__file__).parent):
            item.add_marker(pytest.mark.flaky(reruns=1))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Tell the fixtures whether their test failed, for a screenshot of it."""
    report = yield
    if report.when == "call":
        item.has_failed = report.failed  # type: ignore[attr-defined]
    return report
