"""Counts what is wrong with the layout of a page: targets that are too small, things that lie over one
another, and words that are cut.

`uv run python -m tests.browser.layout URL` looks at five sizes, two of them touched, and in each at the first
view, every tab, the View menu, the gallery, the help, the tools that edit, and a lesson; `--dark` at the dark
page, and `--all` prints every finding instead of the first five of a kind. A target is 24 px, and 48 under a
finger.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections import defaultdict
from collections.abc import Callable, Iterator
from typing import NamedTuple

from playwright.sync_api import Page, sync_playwright

from tests.browser import seen

TOUCHED = {(1280, 720): False, (1920, 1080): False, (390, 844): True, (844, 390): True, (640, 360): False}
"""The sizes, CSS px, and whether a finger presses there."""

LEAST, LEAST_TOUCHED = 24, 48
"""Size of a target, CSS px."""

LESSON = "?scene=lesson-hooke"
KINDS = ("small", "covered", "cut", "zooms")


class Fault(NamedTuple):
    """Something that is wrong in one state of a page; `more` says how."""

    fault: str
    kind: str
    words: str
    more: str


def faults(page: Page, touched: bool) -> list[Fault]:
    """What is wrong with a page as it is now."""
    found = {
        "small": seen.ask(page, "small", LEAST_TOUCHED if touched else LEAST),
        "covered": seen.ask(page, "covered"),
        "cut": seen.ask(page, "cut"),
        "zooms": seen.ask(page, "zooms") if touched else [],
    }
    return [Fault(name, one["kind"], one["words"], one["more"]) for name in KINDS for one in found[name]]


def _press_word(page: Page, pattern: str, role: str = "") -> bool:
    """Press the first thing whose words begin with a pattern; whether there is one."""
    for one in seen.pressables(page):
        says = (one["seen"], one["name"], one["tip"])
        if (not role or one["kind"] == role) and any(re.match(pattern, text) for text in says):
            return seen.press(page, one["index"])
    return False


def _opened_by_key(key: str) -> Callable[[Page], bool]:
    def open_it(page: Page) -> bool:
        before = len(seen.pressables(page))
        page.keyboard.press(key)
        page.wait_for_timeout(3e3 * seen.REST)
        return len(seen.pressables(page)) != before

    return open_it


LAYERS: dict[str, Callable[[Page], bool]] = {
    "View menu": lambda page: _press_word(page, r"View\b"),
    "gallery": _opened_by_key("o"),
    "help": lambda page: _press_word(page, r"View\b") and _press_word(page, "Help$"),
    "editing": lambda page: _press_word(page, "Edit$"),
}
"""What opens over the page, and what opens it."""


def states(page: Page) -> Iterator[str]:
    """Bring a page into one state after another; their names. One that the page does not have is said."""
    yield "first view"
    tabs = [one["words"] for one in seen.pressables(page) if one["kind"] == "tab"]
    for tab in tabs:
        if _press_word(page, re.escape(tab) + "$", "tab"):
            yield f"tab {tab}"
    for name, open_it in LAYERS.items():
        seen.ask(page, "remember")
        if open_it(page):
            yield name
        else:
            print(f"not found: {name}", file=sys.stderr)
        page.keyboard.press("Escape")
        page.wait_for_timeout(1e3 * seen.REST)


def report(found: dict[str, dict[str, list[Fault]]], whole: bool) -> str:
    """Tables of counts by size, and the findings.

    Args:
        found: by size and by state.
        whole: whether all are listed, or the first five of each kind at each size.
    """
    rows = []
    lines: list[str] = []
    for size, by_state in found.items():
        # What is there in every state is one fault, not eight.
        distinct: dict[Fault, list[str]] = defaultdict(list)
        for state, some in by_state.items():
            for fault in dict.fromkeys(some):
                distinct[fault].append(state)
        for name in KINDS:
            ours = {fault: where for fault, where in distinct.items() if fault.fault == name}
            lines.append(f"\n{size}, {name}: {len(ours)}")
            for fault, where in list(ours.items())[: None if whole else 5]:
                more = f" and {len(where) - 1} more" if len(where) > 1 else ""
                lines.append(f"  {fault.kind} {fault.words!r}: {fault.more} ({where[0]}{more})")
        counts = [sum(fault.fault == name for fault in distinct) for name in KINDS]
        rows.append([size, "all, each once", *counts])
        rows += [
            ["", state, *(sum(fault.fault == name for fault in some) for name in KINDS)]
            for state, some in by_state.items()
        ]
    return seen.table(("size", "state", *KINDS), rows) + "\n" + "\n".join(lines)


def main() -> int:
    """Look and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("url", help="address of the page")
    parser.add_argument("--dark", action="store_true", help="the dark page")
    parser.add_argument("--all", action="store_true", help="print every finding")
    given = parser.parse_args()
    found: dict[str, dict[str, list[Fault]]] = {}
    with sync_playwright() as playwright:
        browser = seen.open_browser(playwright)
        for (width, height), touched in TOUCHED.items():
            size = f"{width} x {height}{', touched' if touched else ''}"
            found[size] = {}
            with seen.opened(browser, given.url, (width, height), touched, given.dark) as page:
                for state in states(page):
                    found[size][state] = faults(page, touched)
            address = given.url.rstrip("/") + "/" + LESSON
            with seen.opened(browser, address, (width, height), touched, given.dark) as page:
                found[size]["lesson"] = faults(page, touched)
        browser.close()
    print(report(found, given.all))
    return 0


if __name__ == "__main__":
    sys.exit(main())
