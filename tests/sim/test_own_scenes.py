"""The user's own scenes are renamed, copied, deleted and brought back; none is overwritten or lost."""

from __future__ import annotations

from pathlib import Path

import pytest

import sim
from sim.errors import SceneError
from sim.store import own_scenes
from sim.store.files import load_scene, save_user_scene
from sim.store.own_scenes import (
    duplicate_user_scene,
    rename_user_scene,
    restore_user_scene,
    trash_folder,
    trash_user_scene,
)
from tests.sim.checks import refusal


def save(name: str, masses: int = 3) -> None:
    save_user_scene(sim.rope(masses=masses), name)


def names(folder: Path) -> list[str]:
    return sorted(path.stem for path in folder.glob("*.json"))


def test_a_scene_gets_another_name(home: Path) -> None:
    save("mine")
    assert rename_user_scene("mine", "yours/..") == "yours"
    assert names(home) == ["yours"]
    assert load_scene("yours").name == "yours"
    assert rename_user_scene("yours", "yours") == "yours"


@pytest.mark.parametrize("wanted", ["taken", "", "..", "ring", "x" * 60 + "/", "study-w1"])
def test_no_scene_is_renamed_over_another(home: Path, wanted: str) -> None:
    save("mine", masses=4)
    save("taken", masses=5)
    if wanted.startswith("x"):
        save(wanted)
    before = {path.name: path.read_bytes() for path in home.glob("*.json")}
    with pytest.raises(SceneError):
        rename_user_scene("mine", wanted)
    assert {path.name: path.read_bytes() for path in home.glob("*.json")} == before


def test_copies_are_numbered(home: Path) -> None:
    save("mine")
    assert [duplicate_user_scene("mine") for _ in range(3)] == ["mine 2", "mine 3", "mine 4"]
    assert duplicate_user_scene("mine 3") == "mine 5"
    assert load_scene("mine 5").masses == load_scene("mine").masses
    save("y" * 60)
    copy = duplicate_user_scene("y" * 60)
    assert len(copy) <= 60
    assert copy.endswith(" 2")


def test_a_deleted_scene_comes_back(home: Path) -> None:
    save("mine", masses=4)
    save("mine 2", masses=6)
    first = trash_user_scene("mine")
    assert names(home) == ["mine 2"]
    with pytest.raises(SceneError):
        load_scene("mine")
    # Its name is taken meanwhile: neither is lost.
    save("mine", masses=5)
    assert restore_user_scene(first) == "mine 3"
    assert len(load_scene("mine").masses) == 5
    assert len(load_scene("mine 3").masses) == 4
    second = trash_user_scene("mine")
    assert restore_user_scene(second) == "mine"
    assert names(trash_folder()) == []
    with pytest.raises(SceneError, match="no longer in the trash"):
        restore_user_scene(second)


@pytest.mark.parametrize(
    "trashed",
    ["", "mine.json", "../mine.json", f"{0:020d}-../../mine.json", "/etc/passwd", f"{0:020d}-x.json"],
)
def test_nothing_else_is_brought_back(home: Path, trashed: str) -> None:
    save("mine")
    with pytest.raises(SceneError, match="no longer in the trash"):
        restore_user_scene(trashed)
    assert names(home) == ["mine"]


def test_the_trash_is_bounded(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(own_scenes, "MAX_IN_TRASH", 3)
    for i in range(5):
        save(f"s{i}")
        trash_user_scene(f"s{i}")
    assert [name[21:] for name in names(trash_folder())] == ["s2", "s3", "s4"]
    monkeypatch.setattr(own_scenes, "MAX_TRASH_BYTES", 1)
    save("last")
    last = trash_user_scene("last")  # the newest always stays
    assert [name[21:] for name in names(trash_folder())] == ["last"]
    assert restore_user_scene(last) == "last"


def test_what_does_not_exist_is_said(home: Path) -> None:
    for act in (duplicate_user_scene, trash_user_scene, lambda name: rename_user_scene(name, "x")):
        assert "nothing here" in refusal(SceneError, act, "nothing here")
