"""The page in a frame of another site, where that is allowed and where it is not."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

import sim
from app.server.serve import serving
from tests.browser.driver import LIMIT, until
from tests.browser.sites import served


@pytest.fixture
def site(tmp_path: Path) -> Iterator[tuple[str, Path]]:
    """Another site: its origin, and the folder of its pages."""
    with served(tmp_path) as port:
        yield f"http://localhost:{port}", tmp_path


@pytest.mark.parametrize("allowed", [True, False])
def test_another_site_frames_the_page_only_where_it_is_named(
    browser: Browser, site: tuple[str, Path], allowed: bool
) -> None:
    origin, folder = site
    embed = [origin if allowed else "https://school.example"]
    with serving(sim.load_scene("tutorial-3.1"), "127.0.0.1", 0, embed) as (server, ticker, _):
        address = f"http://127.0.0.1:{server.get_port()}/"
        (folder / "lesson.html").write_text(f"<iframe src='{address}' width=700 height=500></iframe>")
        page = browser.new_page()
        refusals: list[str] = []
        page.on("console", lambda message: refusals.append(message.text))
        page.goto(f"{origin}/lesson.html")
        if allowed:
            frame = page.frames[1]
            frame.wait_for_function("window.__softrod?.fitted() > 0", timeout=LIMIT * 1e3)
            assert frame.locator(".softrod-transport").is_visible()
            assert len(ticker.tabs) == 1
        else:
            until(page, lambda: any("frame-ancestors" in text for text in refusals), "it is refused")
            assert not ticker.tabs
        page.close()
