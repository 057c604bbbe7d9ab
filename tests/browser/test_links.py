"""Links that hold a scene or name it: made by a page, and opened."""

from __future__ import annotations

import re

import msgspec
import numpy as np
from playwright.sync_api import Locator

import sim
from app.session import commands
from sim.scene.lesson import Lesson, Step
from sim.store import files
from sim.store.link import pack_scene
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk

SMALL = (740, 490)
KEPT = "sessionStorage.getItem('softrod')"


def dialog(desk: Desk) -> Locator:
    """The dialog with what the page offers, and in it the field with the link."""
    desk.show("Share")
    desk.button("Share by a link").click()
    field = desk.page.get_by_label("Link to this scene")
    desk.until(lambda: field.input_value(), "there is a link")
    return field


def shared(desk: Desk, pose: bool = False) -> str:
    """The link that holds the scene."""
    field = dialog(desk)
    desk.page.get_by_label("A link that holds the scene").check()
    desk.until(lambda: "/s#1." in field.input_value(), "there is the long link")
    if pose:
        before = field.input_value()
        desk.page.get_by_label("With the present pose").check()
        desk.until(lambda: field.input_value() != before, "there is another one")
    return field.input_value()


def test_a_link_opens_its_scene_before_what_the_page_had_kept(open_page: OpenPage) -> None:
    desk = open_page(size=SMALL)
    desk.tell(commands.SetValue("angular_stiffness", 4321.0), commands.DoSteps(200))
    scene, pose = desk.session.scene, desk.simulation.positions
    plain = shared(desk)
    assert desk.page.locator(".softrod-qr").is_visible()
    desk.page.keyboard.press("Escape")
    with_pose = shared(desk, pose=True)
    desk.page.keyboard.press("Escape")
    assert plain.startswith(desk.served.url + "/s#1.")
    desk.tell(commands.Open(sim.load_scene("ring")))
    desk.until(desk.is_kept, "another scene is kept")
    desk.until(lambda: '"ring"' in desk.page.evaluate(KEPT), "by the page")

    desk.open(plain.removeprefix(desk.served.url))
    desk.until(lambda: desk.session.scene == scene, "the scene of the link is there")
    assert desk.page.url.partition("?")[0] == desk.served.url + "/"
    desk.pause(0.3)
    assert desk.session.scene == scene
    # Another link in the address of the page that is there: that of the pose; and one that is none.
    desk.tell(commands.Play(False))
    desk.page.evaluate("hash => (location.hash = hash)", with_pose.partition("#")[2])
    desk.until(lambda: desk.session.scene.pose is not None, "the other link is opened")
    assert np.array_equal(desk.simulation.positions, pose)
    assert desk.page.evaluate("location.hash") == ""
    desk.page.evaluate("hash => (location.hash = hash)", "1.<img src=x onerror=alert(1)>")
    assert "broken" in desk.notice("That link cannot be opened")
    assert desk.session.scene.pose is not None


def test_the_address_names_no_scene_but_the_open_one(open_page: OpenPage) -> None:
    desk = open_page(size=SMALL)
    desk.open("/?scene=ring&lang=de")
    desk.until(lambda: desk.session.scene.name == "ring" and desk.is_kept(), "the ring is open, and kept")
    asked = "location.search"
    desk.open("/?scene=ring&lang=de")
    assert "scene=ring" in desk.page.evaluate(asked)
    desk.tell(commands.Open(sim.load_scene("tree")))
    desk.until(lambda: "scene=" not in desk.page.evaluate(asked), "the ring's address goes")
    assert "lang=de" in desk.page.evaluate(asked)
    desk.until(desk.is_kept, "the page has the tree")
    desk.open("/?lang=de")
    desk.until(lambda: desk.session.scene.name == "tree", "a reload shows what was open")


def test_a_hostile_scene_is_shown_as_text(open_page: OpenPage) -> None:
    """In the panel, in a lesson, and on a card of the gallery."""
    evil = "<img src=x onerror=window.pwned=1>"
    lesson = Lesson(steps=(Step(title=evil, do=evil, watch=evil),))
    scene = msgspec.structs.replace(
        sim.rope(), name=evil, title=evil, description=evil + "<script>window.pwned=1</script>", lesson=lesson
    )
    files.save_user_scene(msgspec.structs.replace(scene, name="evil", title=""), "evil")
    desk = open_page("ring", size=SMALL, path="/s#" + pack_scene(scene))
    card = desk.page.locator(".softrod-lesson")
    desk.until(lambda: card.inner_text().count(evil) == 3, "the lesson is shown as it is")
    desk.show("Play")
    desk.page.locator(".softrod-about", has_text="onerror").wait_for()
    desk.until(lambda: desk.state.title == evil, "the page knows its title")
    desk.gallery()
    desk.card("evil").get_by_text("onerror").wait_for()
    desk.rest(3)
    assert desk.page.evaluate("window.pwned") is None
    assert desk.page.locator("#root img[src=x]").count() == 0


def test_a_short_address_opens_what_it_names_and_a_reload_goes_on_with_that(open_page: OpenPage) -> None:
    desk = open_page(size=SMALL)
    desk.tell(commands.SetValue("angular_stiffness", 4321.0))
    field = dialog(desk)
    assert re.fullmatch(re.escape(desk.served.url) + r"/\?s=\w{4}", field.input_value())
    assert desk.page.get_by_text("of this machine alone").is_visible()
    desk.page.get_by_label("Controls for whoever opens it").select_option("sliders")
    desk.until(lambda: "&controls=play," in field.input_value(), "with fewer controls")
    phone = field.input_value().removeprefix(desk.served.url)
    scene = desk.session.scene

    desk.open(phone)
    assert desk.session.scene == scene
    assert desk.tab.probe().controls == ("play", "rest_angle", "angular_stiffness")
    # What was done meanwhile is there again after a reload, and another address opens another scene.
    desk.tell(commands.SetValue("gravity", 123.0))
    desk.until(desk.is_kept, "it is kept")
    desk.until(lambda: "123" in (desk.page.evaluate(KEPT) or ""), "by the page")
    desk.open(phone)
    desk.until(lambda: desk.session.scene.gravity == (0.0, 123.0), "the reload goes on")
    desk.open("/?scene=lesson-hooke")
    assert desk.session.scene.name == "lesson-hooke"
    desk.pause(0.5)
    assert desk.session.scene.name == "lesson-hooke"
    assert not desk.notices()
    # One without a scene opens the gallery, and says why.
    desk.open("/?scene=lesson-hook")
    gallery = desk.page.get_by_role("dialog", name="Scenes")
    gallery.get_by_text("There is no preset called 'lesson-hook'; choose one in the gallery.").wait_for()
