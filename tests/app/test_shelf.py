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
