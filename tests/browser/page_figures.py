"""What pages cost a browser, side by side: bytes of the first load, the processor's time, and how long the
step of a slider takes.

`uv run python -m tests.browser.page_figures URL [URL ...]` loads each page with an empty cache and lets it
move, by turns, so that whatever else the machine does meets all of them, and prints the medians and their
ratios to the first. Bytes that come by the socket are counted as the page gets them, unpacked. The
processor's time is that of the page's main thread, and of the process with all its threads.
"""

from __future__ import annotations

import argparse
import statistics
import sys
from typing import Any, NamedTuple

from playwright.sync_api import Browser, CDPSession, Playwright, sync_playwright

from tests.browser import seen
from tests.browser.conftest import FLAGS, browser_path
from tests.browser.driver import LIMIT
from tests.browser.live_figures import busy
from tests.browser.scripts import BLANK, HARDWARE

MOVES = 5.0
"""Seconds for which a page is looked at while it moves."""

STEPS = 25
"""Steps of the first slider by keys, of which the median counts."""

STEP = """async (steps) => {
  const inPanel = (one) => one.getBoundingClientRect().left > 0.6 * innerWidth;
  const slider = [...document.querySelectorAll("[role=slider], input[type=range]")].find(
    (one) => one.checkVisibility() && inPanel(one));
  slider.focus();
  window.stepTimes = [];
  addEventListener("keydown", ({ timeStamp }) => requestAnimationFrame(() => {
    const { port1, port2 } = new MessageChannel();  // comes once the frame is painted
    port1.onmessage = () => window.stepTimes.push(performance.now() - timeStamp);
    port2.postMessage(null);
  }), true);
}"""
"""Has each step of a slider measured until it is painted."""


class Figures(NamedTuple):
    """What one visit cost.

    Attributes:
        files: number of files.
        loaded: bytes of files as they come, packed, with headers.
        unpacked: bytes of them without headers.
        socket: bytes by the socket until the page is ready.
        ready: ms until the page shows its body.
        load_thread, load_process: ms of the processor until then.
        second_thread, second_process: ms of the processor per second of motion.
        step: ms from the step of a slider until it is painted.
    """

    files: float
    loaded: float
    unpacked: float
    socket: float
    ready: float
    load_thread: float
    load_process: float
    second_thread: float
    second_process: float
    step: float


TITLES = (
    "files",
    "kB by HTTP",
    "kB unpacked",
    "kB by socket",
    "ready after, ms",
    "thread until then, ms",
    "process until then, ms",
    "thread, ms per s",
    "process, ms per s",
    "slider's step, ms",
)
UNITS = (1.0, 1e3, 1e3, 1e3, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0)


class Heard:
    """Counts what a page receives."""

    def __init__(self, tools: CDPSession) -> None:
        self.files = self.loaded = self.unpacked = self.socket = 0
        tools.on("Network.loadingFinished", self._finish)
        tools.on("Network.dataReceived", self._receive)
        tools.send("Network.enable")

    def _finish(self, event: dict[str, Any]) -> None:
        self.files += 1
        self.loaded += int(event["encodedDataLength"])

    def _receive(self, event: dict[str, Any]) -> None:
        self.unpacked += int(event["dataLength"])

    def hear(self, data: bytes | str) -> None:
        """Count what came by the socket."""
        self.socket += len(data.encode() if isinstance(data, str) else data)


def process_time(whole: CDPSession) -> float:
    """Processor time of all pages of a browser, s."""
    found = whole.send("SystemInfo.getProcessInfo")["processInfo"]
    return sum(one["cpuTime"] for one in found if one["type"] == "renderer")


def slider_step(browser: Browser, url: str) -> float:
    """ms from the step of the first slider until it is painted, the median of some.

    The canvas is not drawn there: without a graphics card its pixels would take all of the time.
    """
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    page.add_init_script(f"{{{HARDWARE}}} {{{BLANK}}}")
    page.goto(url)
    page.wait_for_function(seen.READY, timeout=LIMIT * 1e3)
    page.wait_for_timeout(1e3)
    page.evaluate(STEP)
    for _ in range(STEPS):
        page.keyboard.press("ArrowRight")
        page.wait_for_timeout(60)
    return statistics.median(page.evaluate("window.stepTimes"))


def visit(playwright: Playwright, url: str) -> Figures:
    """Load a page in a browser of its own, which has nothing compiled, and let it move."""
    # Scripts are compiled as for a user; tests do without.
    flags = [flag for flag in FLAGS if not flag.startswith("--js-flags")]
    browser = playwright.chromium.launch(executable_path=browser_path(playwright.chromium), args=flags)
    context = browser.new_context(viewport={"width": 1280, "height": 720})
    context.set_default_timeout(LIMIT * 1e3)
    context.add_init_script(HARDWARE)
    page = context.new_page()
    tools, whole = context.new_cdp_session(page), browser.new_browser_cdp_session()
    tools.send("Performance.enable", {"timeDomain": "threadTicks"})
    heard = Heard(tools)
    page.on("websocket", lambda socket: socket.on("framereceived", heard.hear))
    before = (busy(tools), process_time(whole))
    page.goto(url)
    page.wait_for_function(seen.READY)
    ready = page.evaluate("performance.now()")
    loaded = (busy(tools), process_time(whole))
    received = (heard.files, heard.loaded, heard.unpacked, heard.socket)
    page.wait_for_timeout(1500)
    began, started = page.evaluate("performance.now()"), (busy(tools), process_time(whole))
    page.wait_for_timeout(1e3 * MOVES)
    ended, stopped = page.evaluate("performance.now()"), (busy(tools), process_time(whole))
    context.close()
    step = slider_step(browser, url)
    browser.close()
    load_thread, load_process = (1e3 * (b - a) for a, b in zip(before, loaded, strict=True))
    span = ended - began
    second_thread, second_process = (1e6 * (b - a) / span for a, b in zip(started, stopped, strict=True))
    return Figures(*received, ready, load_thread, load_process, second_thread, second_process, step)


def report(found: dict[str, list[Figures]]) -> str:
    """The medians of each page, and how many times those of the first page."""
    rows: list[list[object]] = []
    medians = {
        url: [statistics.median(column) for column in zip(*all_, strict=True)] for url, all_ in found.items()
    }
    first = next(iter(medians.values()))
    for i, (title, unit) in enumerate(zip(TITLES, UNITS, strict=True)):
        row: list[object] = [title]
        for j, values in enumerate(medians.values()):
            row.append(f"{values[i] / unit:.0f}")
            if j:
                row.append(f"{values[i] / first[i]:.2f}" if first[i] else "")
        rows.append(row)
    titles = ["", *(title for j, url in enumerate(medians) for title in ([url, "ratio"] if j else [url]))]
    return seen.table(titles, rows)


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("urls", nargs="+", help="addresses of pages")
    parser.add_argument("--times", type=int, default=3, help="visits of each")
    given = parser.parse_args()
    found: dict[str, list[Figures]] = {url: [] for url in given.urls}
    with sync_playwright() as playwright:
        for _ in range(given.times):
            for url in found:
                found[url].append(visit(playwright, url))
    print(report(found))
    return 0


if __name__ == "__main__":
    sys.exit(main())
