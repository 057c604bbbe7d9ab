"""Scenes that are kept under a short code: found again, told apart, few, and never half written."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

import sim
from sim.errors import SceneError
from sim.store import shared
from sim.store.shared import LETTERS, share_scene, shared_folder, shared_scene
from tests.sim.checks import refusal


def test_a_scene_is_found_by_its_code(home: Path) -> None:
    scene = sim.rope(masses=7)
    code = share_scene(scene)
    assert len(code) == 4
    assert set(code) <= set(LETTERS)
    assert shared_scene(code) == shared_scene(code.lower()) == scene
    assert share_scene(scene) == code
    assert share_scene(sim.rope(masses=8)) != code
    assert {path.suffix for path in shared_folder().iterdir()} == {".json"}


def test_two_scenes_that_would_share_a_code_do_not(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shared, "letters_of", lambda digest: "BCDF" + f"{digest[0] % 8 + 2}" * 8)
    scenes = [sim.rope(masses=n) for n in range(3, 8)]
    codes = [share_scene(scene) for scene in scenes]
    assert len(set(codes)) == len(codes)
    assert codes[0] == "BCDF"
    assert [shared_scene(code) for code in codes] == scenes
    assert [share_scene(scene) for scene in scenes] == codes


def test_what_nobody_opened_for_long_makes_room(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shared, "MAX_KEPT", 3)
    codes = [share_scene(sim.rope(masses=n)) for n in (3, 4, 5)]
    for age, code in enumerate(codes):
        os.utime(shared_folder() / f"{code}.json", (1e9 + age, 1e9 + age))
    shared_scene(codes[0])
    share_scene(sim.rope(masses=6))
    shared_scene(codes[0])
    shared_scene(codes[2])
    with pytest.raises(SceneError, match="no scene is kept under"):
        shared_scene(codes[1])


def test_all_that_is_kept_has_a_size(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    codes = [share_scene(sim.rope(masses=3))]
    (path,) = shared_folder().iterdir()
    os.utime(path, (1e9, 1e9))
    monkeypatch.setattr(shared, "MAX_KEPT_BYTES", int(1.5 * path.stat().st_size))
    codes.append(share_scene(sim.rope(masses=4)))
    assert {path.stem for path in shared_folder().iterdir()} == {codes[1]}


def test_what_cannot_be_kept_is_one_sentence(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shared, "MAX_BYTES", 300)
    said = refusal(SceneError, share_scene, sim.rope())
    assert re.search(r"takes \d+ bytes, more than the 300 that are kept", said)


@pytest.mark.parametrize("code", ["", "AB", "../x", "ZZZZ", "0000", "x" * 500, "BCDF\n", "BC.F", "B\0DF"])
def test_what_is_no_code_is_one_sentence(home: Path, code: str) -> None:
    assert "no scene is kept under" in refusal(SceneError, shared_scene, code)


def test_a_folder_that_cannot_be_written_is_one_sentence(home: Path) -> None:
    shared_folder().parent.mkdir(parents=True)
    shared_folder().write_text("a file where the folder should be")
    assert "the scene cannot be kept there" in refusal(SceneError, share_scene, sim.rope())
