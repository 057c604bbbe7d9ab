"""The Share tab: scenes are saved, downloaded and uploaded; a bad file changes nothing."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import sim
from app.session import commands
from sim.store import files
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk


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


def test_a_built_in_name_is_refused_and_a_taken_one_asked_about(
    open_page: OpenPage, data_folder: Path
) -> None:
    desk = open_page()
    desk.show("Share")
    desk.control("Name").fill("Ring")
    desk.button("Save").click()
    assert "built-in" in desk.notice("That did not work")
    assert not (data_folder / "softrod" / "scenes" / "Ring.json").exists()

    # One that no file can have is made safe, and told.
    desk.control("Name").fill("../a:b?")
    desk.button("Save").click()
    desk.notice("The scene is saved as 'a-b': the name of a file cannot be '../a:b?'.")

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


def test_a_download_is_the_scene_and_opens_again_but_no_bad_file(open_page: OpenPage, tmp_path: Path) -> None:
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

    desk.tell(commands.Play(False), commands.Open(sim.load_scene("ring")))
    bad = tmp_path / "broken.json"
    bad.write_bytes(b'{"format": 1, "name": ')
    upload(desk, bad)
    desk.notice("broken.json: this is not a JSON file")
    bad.write_bytes(b" " * 8_100_000)
    upload(desk, bad)
    desk.notice("That cannot be opened")
    assert desk.session.scene.name == "ring"
    # The button leads to the field, and a good file still opens.
    with desk.page.expect_file_chooser():
        desk.button("Open a file").click()
    path.write_text(path.read_text(), encoding="utf-16")  # as some editors do
    upload(desk, path)
    desk.until(lambda: desk.session.scene == scene, "the file is opened")
    assert not desk.notices()
