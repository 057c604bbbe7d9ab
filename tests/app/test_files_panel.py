"""The Share tab without a browser: the name that it offers, and files that take long."""

from __future__ import annotations

import threading

import pytest

import sim
from app.background import file_worker
from app.features.files import export_panel
from app.features.files.export_panel import ExportPanel
from app.features.files.panel import FilesPanel
from app.session.notices import Notice
from app.session.session import Session
from app.words import say, speaking
from sim.edit.lesson import add_step
from sim.edit.texts import UNNAMED
from sim.store.files import safe_name
from tests.app.panels import Client, page_of


def offered(scene: sim.Scene, tag: str) -> str:
    """The name under which a scene can be saved, on a page in a language."""
    with speaking(tag):
        client = Client()
        FilesPanel(page_of(Session(scene), client))
        return str(client.gui.there[0].value)


@pytest.mark.parametrize(
    ("tag", "name"), [("en", UNNAMED), ("de", "Meine Szene"), ("es", "mi escena"), ("ar", "مشهدي")]
)
def test_a_scene_without_a_name_of_its_own_is_offered_one_in_the_page_s_language(tag: str, name: str) -> None:
    for scene in (sim.load_scene("jelly"), sim.rope(name=UNNAMED)):
        assert offered(scene, tag) == name == safe_name(name)


def test_a_lesson_made_of_a_preset_is_offered_a_name_in_the_page_s_language() -> None:
    scene = add_step(sim.load_scene("jelly"), 0).scene
    assert [offered(scene, tag) for tag in ("en", "de")] == ["my lesson", "Meine Lektion"]


def test_a_file_that_waits_for_others_is_said_to_be_prepared(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(export_panel, "QUIET", 0.01)
    told: list[Notice] = []
    client, others, said = Client(), threading.Event(), threading.Event()

    def notify(notice: Notice) -> None:
        told.append(notice)
        said.set()

    ExportPanel(page_of(Session(sim.load_scene("rope")), client, notify=notify))

    def wait() -> None:
        others.wait(10.0)

    file_worker.submit(wait)
    try:
        client.gui[say("files-body-as")].enter(say("files-json"))
        assert said.wait(5.0)
    finally:
        others.set()
    assert told[0].title == "The file is being prepared"
