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
from app.words import PSEUDO, speaking
from tests.app.clips import swing
from tests.app.html_pages import WICKED, Page, plain_texts

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


@pytest.mark.parametrize(
    ("kind", "name"),
    [("replay", "rope"), ("live", "tutorial-3.3"), ("live", "hopper"), ("live", "lesson-hooke")],
)
def test_a_file_is_in_the_language_that_is_spoken(kind: str, name: str) -> None:
    scene = ROPE if kind == "replay" else sim.load_scene(name)
    with speaking(PSEUDO):
        text = MAKERS[kind](scene).decode()
    assert f'<html lang="{PSEUDO}">' in text
    assert plain_texts(text) <= {scene.title or scene.name, scene.description}


def test_a_file_has_the_texts_only_of_what_its_body_has() -> None:
    texts = {
        name: MAKERS["live"](sim.load_scene(name)).decode() for name in ("rope", "buggy", "lesson-hooke")
    }
    for words, owner in (("live-keys-motors", "buggy"), ("live-left-line", "lesson-hooke")):
        assert [name for name, text in texts.items() if f"{words} =" in text] == [owner]
