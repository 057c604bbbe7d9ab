"""A page as a visitor sees it: what can be pressed, by words, roles and places alone (`visible.js`).

It knows no class and no id, so that pages with different panels are measured by the same means.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Page, Playwright, ViewportSize
from playwright.sync_api import TimeoutError as TooLate

from tests.browser.conftest import FLAGS, browser_path
from tests.browser.driver import LIMIT
from tests.browser.scripts import HARDWARE

SCRIPT = (Path(__file__).parent / "visible.js").read_text(encoding="utf-8")

REST = 0.4
"""Seconds after which whatever a press opens has opened; nothing moves for longer."""

READY = "() => window.__softrod?.fitted?.() > 0"


def open_browser(playwright: Playwright) -> Browser:
    """A browser of its own, as the tests have one."""
    return playwright.chromium.launch(executable_path=browser_path(playwright.chromium), args=list(FLAGS))


@contextmanager
def opened(
    browser: Browser,
    url: str,
    size: tuple[int, int],
    touch: bool = False,
    dark: bool = False,
    first: str = "",
) -> Iterator[Page]:
    """A page in a profile of its own, once its body is drawn; the script `first` runs before its own."""
    viewport: ViewportSize = {"width": size[0], "height": size[1]}
    context = browser.new_context(
        viewport=viewport, has_touch=touch, color_scheme="dark" if dark else "light", accept_downloads=True
    )
    context.set_default_timeout(LIMIT * 1e3)
    context.add_init_script(f"{{{HARDWARE}}} {{{first}}}")
    page = context.new_page()
    try:
        page.goto(url)
        page.wait_for_function(READY)
        page.wait_for_timeout(3e3 * REST)
        yield page
    finally:
        context.close()


def ask(page: Page, question: str, *values: Any) -> Any:
    """What one of the functions of `visible.js` answers."""
    if not page.evaluate("() => 'visibleThings' in window"):
        page.evaluate(SCRIPT)
    return page.evaluate(f"values => visibleThings.{question}(...values)", list(values))


def pressables(page: Page) -> list[dict[str, Any]]:
    """What can be pressed, in the order of the page; the index is that of `press`."""
    return ask(page, "pressables")


def press(page: Page, index: int, touch: bool = False) -> bool:
    """Press one of the last `pressables`; whether it could be pressed."""
    element = page.evaluate_handle("index => visibleThings.elements[index]", index).as_element()
    assert element is not None
    try:
        element.scroll_into_view_if_needed(timeout=1000)
        if touch:
            element.tap(timeout=1500)
        else:
            element.click(timeout=1500)
    except TooLate:
        return False
    page.wait_for_timeout(1e3 * REST)
    return True


def table(titles: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """A table in Markdown, padded so that it reads well as it is."""
    cells = [list(map(str, row)) for row in (titles, *rows)]
    widths = [max(len(row[i]) for row in cells) for i in range(len(titles))]
    lines = [
        f"| {' | '.join(text.ljust(width) for text, width in zip(row, widths, strict=True))} |"
        for row in cells
    ]
    return "\n".join((lines[0], f"|{'|'.join('-' * (width + 2) for width in widths)}|", *lines[1:]))
