"""How large live files are, and how fast in a browser on a machine that is four times slower than this one.

`uv run python -m tests.browser.live_figures` writes two tables: the sizes of all presets' files, and of some
bodies the time until they move, the frames a second after that, and the processor's time for a frame. Leave
the machine alone meanwhile: only the last one does not mind.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from pathlib import Path

from playwright.sync_api import CDPSession, sync_playwright

import sim
from app.export.live.live import live_html
from sim.store.files import list_scenes
from tests.browser.conftest import FLAGS, NAMES
from tests.browser.driver import until

SLOWER = 4
"""Times."""

BODIES = ("rope", "tutorial-3.3", "flag-pole", "jelly", "hair-tuft", "cloth", "tree", "pile", "lesson-hooke")

LOOK = """(span) => new Promise((done) => {
  const { body, clock } = __softrod.now(), began = performance.now(), time = body.time;
  let frames = 0;
  const next = () => {
    const passed = performance.now() - began;
    if (passed < span) return frames++, requestAnimationFrame(next);
    const { body } = __softrod.now();
    done([1e3 * frames / passed, 1e3 * (body.time - time) / passed]);
  };
  requestAnimationFrame(next);
})"""


def busy(tools: CDPSession) -> float:
    """Processor time of the page until now, s."""
    found = tools.send("Performance.getMetrics")["metrics"]
    return next(one["value"] for one in found if one["name"] == "TaskDuration")


def main() -> int:
    """Measure and print."""
    browser_path = os.environ.get("SOFTROD_BROWSER") or next(filter(None, map(shutil.which, NAMES)), None)
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        files: dict[str, Path] = {}
        for info in list_scenes():
            if not info.built_in:
                continue
            moment = sim.Simulation(sim.load_scene(info.name)).capture()
            files[info.name] = Path(folder) / f"{info.name}.html"
            files[info.name].write_bytes(live_html(moment)[0])
        sizes = sorted((path.stat().st_size, name) for name, path in files.items())
        print("| file | kB |\n|---|---|")
        for size, name in sizes:
            print(f"| {name} | {size / 1e3:.0f} |")
        titles = (
            "body",
            "masses",
            "moves after, ms",
            "frames a second",
            "of real time",
            "processor, ms a frame",
        )
        print(f"\n| {' | '.join(titles)} |\n|{'---|' * len(titles)}")
        browser = playwright.chromium.launch(executable_path=browser_path, args=list(FLAGS))
        for name in BODIES:
            page = browser.new_context(offline=True, viewport={"width": 1280, "height": 720}).new_page()
            asked: list[str] = []
            page.on("request", lambda request, asked=asked: asked.append(request.url))
            tools = page.context.new_cdp_session(page)
            tools.send("Performance.enable", {"timeDomain": "threadTicks"})
            tools.send("Emulation.setCPUThrottlingRate", {"rate": SLOWER})
            page.add_init_script(
                "const look = () => window.__softrod?.now().body.time > 0 "
                "? (window.moved = performance.now()) : requestAnimationFrame(look); look();"
            )
            page.goto(files[name].as_uri())
            if name.startswith("lesson"):
                page.locator(".softrod-choice").first.click()
            moved = until(page, lambda page=page: page.evaluate("window.moved"), f"{name} moves")
            page.wait_for_timeout(1500)
            frames, rate = page.evaluate(LOOK, 4000)
            assert len(asked) == 1, asked
            masses = page.evaluate("__softrod.now().body.masses")
            # The processor's time counts what the page had of it, whatever else the machine does.
            tools.send("Emulation.setCPUThrottlingRate", {"rate": 1})
            before = busy(tools)
            freely, _ = page.evaluate(LOOK, 3000)
            spent = busy(tools) - before
            row = (
                name,
                masses,
                round(moved),
                round(frames),
                f"{rate:.2f}",
                f"{1e3 * spent / (3.0 * freely):.1f}",
            )
            print(f"| {' | '.join(map(str, row))} |")
            page.context.close()
        browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
