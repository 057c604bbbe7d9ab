"""The gallery: scenes on cards, by pointer and by keys; own ones are renamed, copied, deleted and back."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

import sim
from app.features.gallery.messages import OfferGallery, ShelfChanged
from app.gate.gate import Gate
from app.ui import owner
from app.wire.carrier import Mail, by_viser
from sim.store import files, own_scenes
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk

SMALL = (820, 520)


def focused(desk: Desk) -> str | None:
    """The scene whose card has the focus."""
    return desk.page.evaluate("document.activeElement.closest('.softrod-card')?.dataset.name ?? null")


def titles(desk: Desk) -> list[str]:
    """What stands on the cards that are shown."""
    return desk.page.locator(".softrod-card:visible b").all_inner_texts()


def said(desk: Desk) -> str:
    """What the gallery says was done."""
    return desk.page.locator(".softrod-gallery [role=status]").inner_text()


def test_a_scene_is_found_and_opened_by_keys_alone(open_page: OpenPage) -> None:
    desk = open_page(size=SMALL)
    chooser = desk.chooser("Rope (3.3)")
    chooser.focus()
    desk.page.keyboard.press("Enter")
    dialog = desk.page.get_by_role("dialog", name="Scenes")
    dialog.locator(".softrod-card").first.wait_for()
    assert dialog.get_by_role("grid", name="Tutorial").get_by_role("row").count() == 3
    desk.until(lambda: dialog.get_by_label("Find a scene").is_visible(), "there is a search box")
    # Down to the present scene, and on by arrows.
    desk.page.keyboard.press("ArrowDown")
    assert focused(desk) == "tutorial-3.3"
    desk.page.keyboard.press("ArrowLeft")
    assert focused(desk) == "tutorial-3.2"
    desk.page.keyboard.press("ArrowDown")
    below = focused(desk)
    assert below not in (None, "tutorial-3.2")
    desk.page.keyboard.press("ArrowUp")
    assert focused(desk) == "tutorial-3.2"
    # Every picture is there.
    loaded = "[...document.querySelectorAll('.softrod-card img')].slice(0, 6).every(i => i.naturalWidth > 0)"
    desk.until(lambda: desk.page.evaluate(loaded), "the pictures are loaded")
    # Letters search, whatever card has the focus; each word counts.
    desk.page.keyboard.type("wind flag")
    desk.until(lambda: titles(desk) == ["Flag and pole"], "one scene is found")
    desk.page.keyboard.type(" xyz")
    desk.page.get_by_text("No scene has all of these words").wait_for()
    for _ in range(4):
        desk.page.keyboard.press("Backspace")
    # Esc leaves, and what had the focus has it again; the keys of the body did nothing.
    desk.page.get_by_label("Find a scene").fill("")
    desk.page.keyboard.press("Escape")
    dialog.wait_for(state="hidden")
    assert chooser.evaluate("element => element === document.activeElement")
    assert desk.session.playing
    assert desk.session.scene.name == "tutorial-3.3"
    desk.page.keyboard.press("Enter")
    dialog.wait_for()
    desk.page.keyboard.type("flag")
    desk.until(lambda: titles(desk) == ["Flag and pole"], "it is found again")
    desk.page.keyboard.press("Enter")
    desk.until(lambda: desk.session.scene.name == "flag-pole", "it is opened")
    dialog.wait_for(state="hidden")
    desk.chooser("Flag and pole").wait_for()
    # The keys are the body's now.
    desk.page.keyboard.press("Space")
    desk.until(lambda: not desk.session.playing, "Space pauses")


def test_own_scenes_are_renamed_copied_deleted_and_brought_back(
    open_page: OpenPage, data_folder: Path
) -> None:
    ring = sim.set_value(sim.load_scene("ring"), "gravity", 77.0)
    folder = data_folder / "softrod" / "scenes"
    for left in folder.glob("mine*.json"):  # of a try that failed
        left.unlink()
    files.save_user_scene(ring, "mine")
    desk = open_page(size=SMALL)
    desk.gallery()
    card = desk.card("mine")
    card.wait_for()
    picture = card.locator("img")
    desk.until(lambda: str(picture.get_attribute("src")).startswith("data:image/webp"), "it is painted")
    card.locator(".softrod-open").click()
    desk.until(lambda: desk.session.scene.name == "mine", "it is opened")
    desk.gallery()
    # The one that is open is renamed with its file.
    card.get_by_role("button", name="Rename mine").click()
    field = desk.page.get_by_label("New name of mine")
    field.fill("mine still")
    field.press("Enter")
    desk.until(lambda: desk.session.scene.name == "mine still", "the open scene has its new name")
    desk.card("mine still").get_by_role("button", name="Rename mine still").click()
    desk.page.get_by_label("New name of mine still").fill("mine")
    desk.page.keyboard.press("Enter")
    card.get_by_role("button", name="Copy mine").click()
    desk.card("mine 2").wait_for()
    assert files.read_scene(folder / "mine 2.json").gravity == ring.gravity
    # A taken name is refused in words, and nothing is lost.
    desk.card("mine 2").get_by_role("button", name="Rename mine 2").click()
    field = desk.page.get_by_label("New name of mine 2")
    field.fill("mine")
    field.press("Enter")
    desk.until(lambda: "already" in said(desk), "it says why not")
    desk.card("mine 2").get_by_role("button", name="Rename mine 2").click()
    field.fill("other ring")
    field.press("Enter")
    desk.card("other ring").wait_for()
    assert desk.card("mine 2").count() == 0
    desk.card("other ring").get_by_role("button", name="Delete other ring").click()
    desk.until(lambda: desk.card("other ring").count() == 0, "it is gone")
    assert not (folder / "other ring.json").exists()
    desk.page.get_by_role("dialog").get_by_role("button", name="Undo").click()
    desk.card("other ring").wait_for()
    assert files.read_scene(folder / "other ring.json").gravity == ring.gravity
    # What another page or program does to the saved scenes is seen at once.
    files.save_user_scene(ring, "mine of another page")
    desk.card("mine of another page").wait_for()
    own_scenes.trash_user_scene("mine of another page")
    desk.until(lambda: desk.card("mine of another page").count() == 0, "it is gone again")
    # Presets have no such buttons.
    assert desk.card("ring").get_by_role("button").count() == 1


def test_one_group_is_chosen_by_keys_and_searched(open_page: OpenPage) -> None:
    desk = open_page(size=SMALL)
    dialog = desk.gallery()
    every = len(titles(desk))
    chosen = dialog.get_by_role("radio", name="All", exact=True)
    chosen.focus()
    desk.page.keyboard.press("ArrowRight")
    desk.page.keyboard.press("ArrowRight")
    assert dialog.get_by_role("radio", name="Lessons").is_checked()
    lessons = titles(desk)
    assert all(title.startswith("Lesson ") for title in lessons)
    assert 5 < len(lessons) < every
    dialog.get_by_label("Find a scene").fill("swing rope")
    assert set(titles(desk)) < set(lessons)
    dialog.get_by_role("radio", name="Your own").check()
    assert titles(desk) == []
    dialog.get_by_label("Find a scene").fill("")
    dialog.get_by_role("radio", name="Lessons").check()
    dialog.get_by_role("button", name="New, from nothing").click()
    desk.until(lambda: desk.session.scene.name == "empty", "one begins with nothing")
    # The next time it is where it was left: in its group, and at the same place among all of them.
    assert len((desk.gallery(), titles(desk))[1]) == len(lessons)
    dialog.get_by_role("radio", name="All", exact=True).check()
    body = dialog.locator(".softrod-dialog-body")
    body.evaluate("element => element.scrollTo(0, 700)")
    desk.until(lambda: body.evaluate("element => element.scrollTop") == 700, "it is further down")
    desk.page.evaluate("() => new Promise(requestAnimationFrame)")
    desk.page.keyboard.press("Escape")
    dialog.wait_for(state="hidden")
    assert len((desk.gallery(), titles(desk))[1]) == every
    assert body.evaluate("element => element.scrollTop") == 700


def test_over_a_phone_s_canvas_are_the_scene_s_name_and_what_finds_anything(open_page: OpenPage) -> None:
    desk = open_page(size=(390, 844), phone=True)
    page = desk.page
    name = page.get_by_role("button", name="Rope (3.3): choose another scene")
    name.tap()
    desk.card("rod").locator(".softrod-open").tap()
    page.get_by_role("button", name="Rod: choose another scene").wait_for()
    page.get_by_role("button", name="Find anything").locator("visible=true").tap()
    page.keyboard.type("bending st")
    found = page.locator(".softrod-found-row")
    desk.until(lambda: found.first.locator("mark").count() == 2, "the number is found before scenes")
    assert found.first.locator("mark").all_inner_texts() == ["Bending", "st"]
    stiffness = desk.session.scene.angular_springs[0].stiffness
    told = found.first.inner_text().replace("\u2009", "").replace("\u202f", "").replace("\u00a0", " ")
    assert f"{stiffness:g} kg/s² · Play" in told
    # A scene is found, too, and opened.
    page.keyboard.press("Control+a")
    page.keyboard.type("water ball")
    desk.until(lambda: "Scene" in found.first.inner_text(), "a scene is found")
    found.first.tap()
    desk.until(lambda: desk.session.scene.name == "water-balloon", "it is opened")


def test_on_a_phone_a_tap_opens(open_page: OpenPage) -> None:
    desk = open_page(size=(390, 700), phone=True)
    desk.button("Rope (3.3): choose another scene").tap()
    card = desk.card("rod")
    card.wait_for()
    # Its keyboard does not come up over the cards.
    assert desk.page.evaluate("document.activeElement.tagName") == "DIALOG"
    wide = desk.page.evaluate("document.querySelector('.softrod-gallery').scrollWidth")
    assert wide <= 390
    card.locator(".softrod-open").tap()
    desk.until(lambda: desk.session.scene.name == "rod", "it is opened")


def test_a_scene_that_is_saved_as_the_gallery_opens_does_not_keep_it_shut(open_page: OpenPage) -> None:
    desk = open_page(size=SMALL)
    mail = Mail(by_viser(desk.tab.client))
    with desk.tab.client.atomic():
        mail.send(OfferGallery(why=""))
        mail.send(ShelfChanged())
    desk.page.get_by_role("dialog", name="Scenes").locator(".softrod-card").first.wait_for()


def test_a_visitor_copies_the_owner_s_scenes_and_the_owner_s_key_makes_them_one_s_own(
    open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    visit = Gate.visit
    monkeypatch.setattr(Gate, "visit", lambda gate, number: replace(visit(gate, number), is_local=False))
    files.save_user_scene(sim.load_scene("ring"), "theirs")
    desk = open_page()
    desk.gallery()
    card = desk.card("shared/theirs")
    card.wait_for()
    assert card.locator(".softrod-actions button").all_inner_texts() == ["Copy"]
    desk.until(lambda: card.locator("img").get_attribute("src"), "it has a picture")
    desk.page.get_by_role("heading", name="Saved on this computer").wait_for()
    card.locator(".softrod-open").focus()
    desk.page.keyboard.press("Delete")
    card.get_by_role("button", name="Copy theirs").click()
    desk.page.get_by_text("The copy is called 'theirs'.").wait_for()
    copy = desk.card("theirs")
    copy.get_by_role("button", name="Delete theirs").click()
    desk.page.get_by_text("'theirs' is deleted.").wait_for()
    desk.until(lambda: copy.count() == 0, "the copy is gone")
    card.locator(".softrod-open").click()
    desk.until(lambda: desk.session.scene.name == "theirs", "it is opened")
    # The address that the terminal prints; the key does not stay in it.
    desk.open(f"/#owner={owner.key()}")
    assert "owner" not in desk.page.url
    desk.until(lambda: desk.tab.probe().owned, "the page is the owner's")
    for _ in range(2):
        desk.gallery()
        assert desk.card("theirs").locator(".softrod-actions button").all_inner_texts() == [
            "Rename", "Copy", "Delete", "Use in class",
        ]  # fmt: skip
        # On a server for this computer alone.
        desk.page.get_by_role("button", name="Use in class theirs").click()
        assert desk.page.get_by_label("Command", exact=True).input_value() == "softrod class theirs"
        desk.open()  # the browser remembers it
        desk.until(lambda: desk.tab.probe().owned, "the page is still the owner's")
    own_scenes.trash_user_scene("theirs")
