"""A Firefox as it is installed, driven by the standard that it speaks itself, WebDriver BiDi.

Playwright drives only a Firefox of its own. https://www.w3.org/TR/webdriver-bidi/ has the commands.
"""

from __future__ import annotations

import json
import os
import queue
import re
import shutil
import subprocess
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from websockets.sync.client import connect
from websockets.sync.connection import Connection

from tests.browser.driver import LIMIT

NAMES = ("firefox-esr", "firefox")

KEYS = {"Escape": "\ue00c", "Enter": "\ue007", "Down": "\ue015", "Right": "\ue014"}

_PREFERENCES = {
    # White paper, whatever the machine has.
    "layout.css.prefers-color-scheme.content-override": 1,
    # It is to ask nobody for anything by itself.
    "app.update.disabledForTesting": True,
    "browser.safebrowsing.update.enabled": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "extensions.getAddons.cache.enabled": False,
    "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False,
    "services.settings.server": "data:,",
    "toolkit.telemetry.enabled": False,
}


def firefox_path() -> str | None:
    """A Firefox on this machine, if there is one."""
    asked = os.environ.get("SOFTROD_FIREFOX")
    return next(filter(None, map(shutil.which, [asked] if asked else NAMES)), None)


class Firefox:
    """One tab.

    Args:
        socket: to the browser.

    Attributes:
        asked: addresses that the tab has asked for.
        errors: what its console has had.
    """

    def __init__(self, socket: Connection) -> None:
        self._socket, self._number = socket, 0
        self.asked: list[str] = []
        self.errors: list[str] = []
        self._call("session.new", capabilities={})
        self._call("session.subscribe", events=["log.entryAdded", "network.beforeRequestSent"])
        self._tab = self._call("browsingContext.getTree")["contexts"][0]["context"]

    def _call(self, method: str, **params: object) -> Any:
        self._number += 1
        self._socket.send(json.dumps({"id": self._number, "method": method, "params": params}))
        while True:
            told = json.loads(self._socket.recv(timeout=LIMIT))
            if told.get("method") == "network.beforeRequestSent":
                self.asked.append(told["params"]["request"]["url"])
            elif told.get("method") == "log.entryAdded":
                self.errors.append(told["params"]["text"])
            elif told.get("id") == self._number:
                assert told["type"] == "success", (method, told)
                return told["result"]

    def size(self, width: int, height: int) -> None:
        """Give the tab a size, pixels."""
        self._call(
            "browsingContext.setViewport", context=self._tab, viewport={"width": width, "height": height}
        )

    def open(self, address: str) -> None:
        """Go to an address, and wait until all of it is there."""
        self._call("browsingContext.navigate", context=self._tab, url=address, wait="complete")

    def run(self, script: str) -> Any:
        """The value of an expression of JavaScript, which must be one that JSON has."""
        target = {"context": self._tab}
        told = self._call(
            "script.evaluate", expression=f"JSON.stringify({script})", target=target, awaitPromise=False
        )
        assert told["type"] == "success", (script, told)
        value = told["result"].get("value")
        return None if value is None else json.loads(value)

    def until(self, script: str, what: str) -> None:
        """Wait until an expression holds, on whatever page there is then."""
        end = time.monotonic() + LIMIT
        while True:
            try:
                if self.run(script):
                    return
            except AssertionError:  # between two pages
                pass
            assert time.monotonic() < end, f"{what}: {script}"
            time.sleep(0.05)

    def type(self, *keys: str) -> None:
        """Press keys, one after the other: letters, or names of `KEYS`."""
        presses = [
            {"type": kind, "value": KEYS.get(key, key)} for key in keys for kind in ("keyDown", "keyUp")
        ]
        self._act({"type": "key", "id": "keys", "actions": presses})

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Press at one place and move to another, and stay there."""
        self._point(
            {"type": "pointerMove", "x": round(start[0]), "y": round(start[1])},
            {"type": "pointerDown", "button": 0},
            {"type": "pointerMove", "x": round(end[0]), "y": round(end[1]), "duration": 100},
        )

    def release(self) -> None:
        """Let go what was dragged."""
        self._point({"type": "pointerUp", "button": 0})

    def click(self, selector: str) -> None:
        """Press the middle of an element."""
        x, y, width, height = self.run(
            f"(({{x, y, width, height}}) => [x, y, width, height])"
            f"(document.querySelector({json.dumps(selector)}).getBoundingClientRect())"
        )
        middle = (x + width / 2.0, y + height / 2.0)
        self.drag(middle, middle)
        self.release()

    def _point(self, *actions: dict[str, object]) -> None:
        self._act({"type": "pointer", "id": "mouse", "actions": list(actions)})

    def _act(self, source: dict[str, object]) -> None:
        self._call("input.performActions", context=self._tab, actions=[source])


@contextmanager
def firefox() -> Iterator[Firefox]:
    """A Firefox with a profile of its own, without a window."""
    path = firefox_path()
    if path is None:
        pytest.fail("This test needs Firefox: install it, or name it in SOFTROD_FIREFOX.", pytrace=False)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        lines = [
            f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in _PREFERENCES.items()
        ]
        (Path(profile) / "user.js").write_text("\n".join(lines))
        process = subprocess.Popen(
            [path, "--headless", "--no-remote", "--profile", profile, "--remote-debugging-port", "0"],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        try:
            with connect(f"{_address(process)}/session", max_size=None) as socket:
                yield Firefox(socket)
        finally:
            process.terminate()
            process.wait(LIMIT)


def _address(process: subprocess.Popen[str]) -> str:
    """Where a Firefox that starts listens; its other lines are read, so that it never waits for that."""
    found: queue.Queue[str] = queue.Queue()
    assert process.stderr is not None

    def read(lines: Iterator[str]) -> None:
        for line in lines:
            if match := re.search(r"WebDriver BiDi listening on (ws://\S+)", line):
                found.put(match[1])

    threading.Thread(target=read, args=(iter(process.stderr),), daemon=True).start()
    try:
        return found.get(timeout=LIMIT)
    except queue.Empty:
        pytest.fail(f"Firefox did not start within {LIMIT:g} s.")
