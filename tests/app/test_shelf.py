"""The list of scenes that all pages share."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import sim
from app.features.gallery.entries import FIRST, GROUPS
from app.features.gallery.entries import entries as entries_of
from app.ui import shelf
from app.words import say
from sim.store import files
from sim.store.files import SceneInfo
from sim.store.own_scenes import trash_user_scene


def own() -> list[str]:
    return [info.name for info in shelf.scenes() if not info.built_in]


def test_what_is_saved_and_deleted_is_seen_at_once(home: Path) -> None:
    before = shelf.stamp()
    for name in ("one", "two"):
        files.save_user_scene(sim.rope(), name)
        assert name in own()
    assert shelf.stamp() != before
    trash_user_scene("one")
    assert own() == ["two"]


def test_the_folder_is_read_once_for_all_pages(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    files.save_user_scene(sim.rope(), "one")
    os.utime(home, (1e9, 1e9))  # long ago
    assert own() == ["one"]
    monkeypatch.setattr(sim, "list_scenes", lambda: pytest.fail("read again"))
    assert own() == ["one"]


def test_presets_go_by_their_titles_and_saved_scenes_by_their_names(home: Path) -> None:
    files.save_user_scene(sim.load_scene("ring"), "my ring")
    entries = {entry.name: entry for entry in entries_of(shelf.scenes())}
    assert entries["tutorial-3.3"].title == "Rope (3.3)"
    assert entries["my ring"].title == "my ring"
    assert entries["study-w1"].title == "study-w1"
    # Every scene that is offered can be opened.
    assert [entry.name for entry in entries_of(shelf.scenes())] == list(entries)
    for name in entries:
        sim.load_scene(name)
    assert sim.load_scene("my ring").title == ""


def test_scenes_are_grouped_by_what_they_are(home: Path) -> None:
    files.save_user_scene(sim.load_scene("pile"), "mine")
    groups: dict[str, list[str]] = {}
    for entry in entries_of(shelf.scenes()):
        groups.setdefault(entry.group, []).append(entry.name)
    assert list(groups) == [say(group) for group in GROUPS if group != "gallery-shared"]
    assert groups["Start here"] == list(FIRST)
    assert groups["Tutorial"] == ["tutorial-3.1", "tutorial-3.2", "tutorial-3.3"]
    assert {"ring", "cloth", "bridge", "flag-pole"} <= set(groups["Bodies"])
    assert groups["Your own"] == ["mine"]
    assert all(name.startswith("study-") for name in groups["Studies"])


def test_numbers_in_names_and_titles_go_by_their_values(home: Path) -> None:
    for name in ("Lesson 10", "lesson 2", "Lesson 2b", "Lesson 1.12", "Lesson 1.5", "3 ropes", "Zip"):
        files.save_user_scene(sim.rope(), name)
    names = [entry.name for entry in entries_of(shelf.scenes()) if entry.own]
    assert names == ["3 ropes", "Lesson 1.5", "Lesson 1.12", "lesson 2", "Lesson 2b", "Lesson 10", "Zip"]
    titled = [
        SceneInfo(name, "", home / name, built_in=True, group="lessons", title=title)
        for name, title in (("a", "Lesson 10: modes"), ("b", "Lesson 2: rope"))
    ]
    assert [entry.name for entry in entries_of(titled)] == ["b", "a"]


def test_a_card_has_one_line() -> None:
    entries = {entry.name: entry for entry in entries_of(shelf.scenes())}
    assert entries["cloth"].line == "A cloth with slack, hung up by two corners."
    assert entries["box"].line.startswith("A box without diagonals")
    assert all(entry.line and "\n" not in entry.line for entry in entries.values() if not entry.own)
