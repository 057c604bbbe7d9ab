"""Replays and live files: they load nothing, run only their own scripts, and what users wrote is text."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from msgspec.structs import replace

import sim
from app.export.clip import Clip
from app.export.live.live import live_html
from app.export.replay import replay_html
from tests.app.clips import swing
from tests.app.html_pages import WICKED, Page

ROPE = sim.rope(masses=5, length=200.0)
Make = Callable[[sim.Scene], bytes]
MAKERS: dict[str, Make] = {
    "replay": lambda scene: replay_html(Clip(swing(scene))),
    "live": lambda scene: live_html(sim.Simulation(scene).capture())[0],
}
kinds = pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
LOADS = re.compile(
    r"""(src|href|action)\s*=(?!"data:)|@import|url\(|fetch\(|XMLHttp|WebSocket|import\(|\sstyle="|\son\w+=\""""
)


@kinds
def test_a_file_loads_nothing_and_runs_nothing_but_its_scripts(make: Make) -> None:
    text = make(ROPE).decode()
    Page(text).check_policy()
    assert not LOADS.search(text)
    assert not re.search(r"https?://(?!www\.w3\.org)", text)


@kinds
def test_what_comes_from_a_scene_is_text(make: Make) -> None:
    plain = Page(make(ROPE).decode())
    for title in (WICKED[:60], WICKED[2:62]):
        scene = replace(ROPE, title=title, description=WICKED, view=replace(ROPE.view, unit="<b>"))
        text = make(scene).decode()
        page = Page(text)
        assert page.tags == plain.tags
        assert page.parts["title"] == page.parts["h1"] == [title]
        assert text.count("</script") == plain.tags.count("script")
        assert "&lt;/script&gt;&lt;script&gt;" in text
