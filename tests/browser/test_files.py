"""The Share tab: scenes are saved, downloaded and uploaded; a bad file changes nothing."""

from __future__ import annotations

import codecs
import json
from pathlib import Path
from typing import Any

import numpy as np

import sim
from app.session import commands
from sim.store import files
from sim.store.own_scenes import trash_user_scene
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk
from tests.browser.looks import assert_shown


def save(desk: Desk, name: str) -> None:
    """Save under a name, and wait until the page says so."""
    desk.control("Name").fill(name)
    desk.button("Save").click()
    desk.notice(f"The scene is saved as {name!r}.")


def upload(desk: Desk, path: Path) -> None:
    """Choose a file to open."""
    desk.page.locator("input[type=file][name=file]").set_input_files(path)


def test_a_scene_is_saved_and_opened(open_page: OpenPage, data_folder: Path) -> None:
    desk = open_page()
    desk.tell(commands.SetValue("angular_stiffness", 4321.0))
    desk.show("Share")
    save(desk, "my rope")
    assert (data_folder / "softrod" / "scenes" / "my rope.json").is_file()
    # The page calls it as it is saved, and the preset's title is gone.
    desk.until(lambda: desk.session.scene.name == "my rope", "the scene has its new name")
    assert desk.session.scene.title == ""
    desk.control("With pose").check()
    desk.tell(commands.SetValue("rest_angle", 12.0), commands.DoSteps(150))
    pose = desk.simulation.positions
    save(desk, "bent rope")

    # The page is loaded afresh: it goes on with what it had, and the saved ones are there.
    desk.open()
    desk.until(lambda: desk.session.scene.name == "bent rope", "it is called as it was saved last")
    desk.open_scene("my rope")
    assert desk.session.scene.angular_springs[0].stiffness == 4321.0
    assert desk.session.scene.pose is None
    # With a pose it goes on from where it was.
    desk.tell(commands.Play(False))
    desk.open_scene("bent rope")
    assert np.allclose(desk.simulation.positions, pose, atol=1e-6)
    assert desk.simulation.rest_angles[0] == 12.0
    assert_shown(desk)


def test_a_built_in_name_is_refused_and_a_taken_one_asked_about(
    open_page: OpenPage, data_folder: Path
) -> None:
    desk = open_page()
    desk.show("Share")
    desk.control("Name").fill("Ring")
    desk.button("Save").click()
    assert "built-in" in desk.notice("That did not work")
    assert not (data_folder / "softrod" / "scenes" / "Ring.json").exists()

    save(desk, "taken")
    path = data_folder / "softrod" / "scenes" / "taken.json"
    first = path.read_bytes()
    desk.tell(commands.SetValue("gravity", 77.0))
    desk.button("Save").click()
    dialog = desk.page.get_by_role("dialog")
    dialog.get_by_role("button", name="Cancel").click()
    desk.until(lambda: dialog.count() == 0, "the question goes away")
    assert path.read_bytes() == first
    desk.button("Save").click()
    dialog.get_by_role("button", name="Replace").click()
    desk.notice("saved as 'taken'")
    assert files.read_scene(path).gravity == (0.0, 77.0)


def test_a_download_is_the_scene_and_can_be_opened_again(open_page: OpenPage, tmp_path: Path) -> None:
    desk = open_page()
    desk.tell(commands.SetValue("linear_damping", 33.0), commands.SetValue("rest_angle", -20.0))
    scene = desk.session.scene
    desk.show("Share")
    with desk.page.expect_download() as started:
        desk.button("Download as a file").click()
    assert started.value.suggested_filename == "tutorial-3.3.json"
    path = tmp_path / "again.json"
    started.value.save_as(path)
    assert files.read_scene(path) == scene

    desk.tell(commands.Open(sim.load_scene("ring")))
    upload(desk, path)
    desk.until(lambda: desk.session.scene == scene, "the file is opened")
    desk.tell(commands.Play(False))
    assert_shown(desk)
    assert not desk.notices()


def test_a_scene_saved_in_one_page_is_there_in_another(open_page: OpenPage) -> None:
    one, other = open_page(size=(720, 460)), open_page(size=(720, 460))
    other.gallery()
    assert other.card("for both").count() == 0
    one.show("Share")
    save(one, "for both")
    # The other's gallery, which is open, shows it.
    other.card("for both").locator(".softrod-open").click()
    other.until(lambda: other.session.scene.name == "for both", "it is opened")
    one.gallery()
    one.card("for both").wait_for()
    trash_user_scene("for both")
    one.until(lambda: one.card("for both").count() == 0, "a scene deleted by another program is gone")


def test_a_log_is_saved_and_played(open_page: OpenPage, tmp_path: Path) -> None:
    desk = open_page()
    desk.tell(commands.SetValue("rest_angle", 15.0), commands.DoSteps(200))
    pose = desk.simulation.positions
    desk.show("Share")
    desk.page.get_by_text("A log is all that was done").wait_for()
    with desk.page.expect_download() as started:
        desk.button("Save a log").click()
    assert started.value.suggested_filename == "tutorial-3.3-log.jsonl"
    path = tmp_path / "again.jsonl"
    started.value.save_as(path)
    path.write_bytes(codecs.BOM_UTF8 + path.read_bytes())  # as some editors do
    desk.tell(commands.Open(sim.load_scene("ring")))
    upload(desk, path)
    assert "It agrees with the log" in desk.notice("The replay has ended")
    assert desk.session.scene.name == "tutorial-3.3"
    assert (desk.simulation.positions == pose).all()
    # A log in which something is wrong changes nothing.
    bad = tmp_path / "bad.jsonl"
    bad.write_bytes(path.read_bytes() + b'{"do": "move", "mass": "x", "to": [0, 0]}\n')
    upload(desk, bad)
    assert "a whole number is expected, not a text" in desk.notice("That did not work")
    assert (desk.simulation.positions == pose).all()


def test_a_bad_file_gets_one_notice_and_changes_nothing(open_page: OpenPage, tmp_path: Path) -> None:
    desk = open_page()
    desk.show("Share")
    simulation, scene = desk.session.simulation, desk.session.scene
    good: dict[str, Any] = json.loads(files.encode_scene(sim.load_scene("ring")))
    masses = [{**good["masses"][0], "mass": -3.0}, *good["masses"][1:]]
    for name, content, said in (
        ("broken.json", b'{"format": 1, "name": ', "broken.json: this is not a JSON file"),
        ("newer.json", json.dumps({**good, "format": 99}).encode(), "newer"),
        ("range.json", json.dumps({**good, "masses": masses}).encode(), "masses[0].mass"),
        # Within what can be sent, over what a scene may have.
        ("large.json", b" " * 5_100_000, "5000000"),
    ):
        path = tmp_path / name
        path.write_bytes(content)
        upload(desk, path)
        assert name in desk.notice(said)
        assert desk.session.simulation is simulation
        assert desk.session.scene is scene
        steps = simulation.step_count
        desk.until(lambda steps=steps: simulation.step_count > steps, "it runs on")
    path = tmp_path / "huge.json"
    path.write_bytes(b" " * 8_100_000)
    upload(desk, path)
    desk.notice("That cannot be opened")
    # The button leads to the field, and a good file still opens.
    with desk.page.expect_file_chooser():
        desk.button("Open a file").click()
    path = tmp_path / "good.json"
    path.write_text(json.dumps({**good, "name": "a good one"}), encoding="utf-16")  # as some editors do
    upload(desk, path)
    desk.until(lambda: desk.session.scene.name == "a good one", "a good file is opened")
    assert not desk.notices()
