"""The list of scenes that all pages share."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import sim
from app.page import shelf
from sim.scene import files


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    folder = files.user_folder()
    folder.mkdir(parents=True)
    return folder


def own() -> list[str]:
    return [info.name for info in shelf.scenes() if not info.built_in]


def test_what_is_saved_and_deleted_is_seen_at_once(home: Path) -> None:
    before = shelf.stamp()
    for name in ("one", "two"):
        files.save_user_scene(sim.rope(), name)
        assert name in own()
    assert shelf.stamp() != before
    files.delete_user_scene("one")
    assert own() == ["two"]


def test_the_folder_is_read_once_for_all_pages(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    files.save_user_scene(sim.rope(), "one")
    os.utime(home, (1e9, 1e9))  # long ago
    assert own() == ["one"]
    monkeypatch.setattr(sim, "list_scenes", lambda: pytest.fail("read again"))
    assert own() == ["one"]


def test_presets_go_by_their_titles_and_saved_scenes_by_their_names(home: Path) -> None:
    files.save_user_scene(sim.load_scene("ring"), "my ring")
    labels = shelf.labels("elsewhere")
    assert labels["Rope (3.3)"] == "tutorial-3.3"
    assert labels["my ring"] == "my ring"
    assert labels["elsewhere"] == "elsewhere"
    # Every scene that is offered can be told from the others, and opened.
    offered = [info.name for info in shelf.scenes() if info.group != "study"]
    assert sorted(labels.values()) == sorted([*offered, "elsewhere"])
    assert sim.load_scene("my ring").title == ""


def test_a_saved_scene_may_be_called_as_a_preset_is_titled(home: Path) -> None:
    assert shelf.labels("ring")["Flag and pole"] == "flag-pole"
    files.save_user_scene(sim.rope(), "Flag and pole")
    labels = shelf.labels("ring")
    assert labels["Flag and pole"] == "Flag and pole"
    assert labels["flag-pole"] == "flag-pole"
