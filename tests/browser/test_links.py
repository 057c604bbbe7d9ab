"""Links that hold a scene: made in one page, opened in another; a bad one changes nothing."""

from __future__ import annotations

import re

import msgspec
import numpy as np
from playwright.sync_api import Locator

import sim
from app.session import commands
from sim.store.link import pack_scene
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk

SMALL = (720, 460)
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


def test_a_link_made_in_one_page_opens_in_another(open_page: OpenPage) -> None:
    one = open_page("tutorial-3.3", size=SMALL)
    one.tell(commands.SetValue("angular_stiffness", 4321.0), commands.DoSteps(200))
    scene, pose = one.session.scene, one.simulation.positions
    plain = shared(one)
    assert one.page.locator(".softrod-qr").is_visible()
    one.page.keyboard.press("Escape")
    with_pose = shared(one, pose=True)
    assert plain.startswith(one.served.url + "/s#1.")

    other = open_page("ring", size=SMALL, path=plain.removeprefix(one.served.url))
    other.until(lambda: other.session.scene == scene, "the scene of the link is there")
    assert other.page.url.partition("?")[0] == other.served.url + "/"
    # It is there again after a reload, with what was done meanwhile.
    other.tell(commands.SetValue("gravity", 123.0))
    other.until(other.is_kept, "it is kept")
    other.rest(3)
    other.open()
    other.until(lambda: other.session.scene.gravity == (0.0, 123.0), "the reload goes on")
    # Another link in the address of the page that is there: that of the pose.
    other.tell(commands.Play(False))
    other.page.evaluate("hash => (location.hash = hash)", with_pose.partition("#")[2])
    other.until(lambda: other.session.scene.pose is not None, "the other link is opened")
    assert np.array_equal(other.simulation.positions, pose)
    assert other.page.evaluate("location.hash") == ""


def test_a_link_goes_before_what_the_tab_had_kept(open_page: OpenPage) -> None:
    desk = open_page("ring", size=SMALL)
    for scene in (sim.load_scene("rod"), sim.load_scene("tutorial-3.1")):
        desk.until(lambda: desk.tab.probe().kept, "something is kept")
        desk.until(lambda: desk.page.evaluate(KEPT), "by the page")
        desk.open("/s#" + pack_scene(scene))
        desk.until(lambda: desk.session.scene == scene, "the link's scene is there")  # noqa: B023
        desk.pause(0.3)
        assert desk.session.scene == scene


def test_a_bad_link_is_one_sentence_and_changes_nothing(open_page: OpenPage) -> None:
    desk = open_page("ring", size=SMALL)
    desk.tell(commands.SetValue("gravity", 77.0))
    desk.until(desk.is_kept, "it is kept")
    desk.rest(3)
    scene, data = desk.session.scene, pack_scene(sim.rope())
    desk.open("/s#" + data[:-9])
    desk.until(lambda: desk.session.scene == scene, "what was kept is there")
    assert "the link is broken" in desk.notice("That link cannot be opened")
    for bad, said in ((f"2.{data[2:]}", "newer than 1"), ("1.<img src=x onerror=alert(1)>", "broken")):
        desk.page.evaluate("hash => (location.hash = hash)", bad)
        assert said in desk.notice("That link cannot be opened")
    assert desk.session.scene == scene


def test_a_hostile_scene_is_shown_as_text(open_page: OpenPage) -> None:
    evil = "<img src=x onerror=window.pwned=1>"
    scene = msgspec.structs.replace(
        sim.rope(), name=evil, title=evil[:60], description=evil + "<script>window.pwned=1</script>"
    )
    desk = open_page("ring", size=SMALL, path="/s#" + pack_scene(scene))
    desk.until(lambda: desk.session.scene.name == evil, "it is opened")
    desk.page.locator(".softrod-about", has_text="onerror").wait_for()
    desk.until(lambda: desk.state.title == evil, "the page knows its title")
    desk.rest(3)
    assert desk.page.evaluate("window.pwned") is None
    assert desk.page.locator("#root img[src=x]").count() == 0


def test_a_short_address_opens_the_scene_for_others_and_again_after_a_reload(open_page: OpenPage) -> None:
    one = open_page("tutorial-3.3", size=SMALL)
    one.tell(commands.SetValue("angular_stiffness", 4321.0))
    field = dialog(one)
    short = field.input_value()
    assert re.fullmatch(re.escape(one.served.url) + r"/\?s=\w{4}", short)
    assert one.page.locator(".softrod-qr").is_visible()
    assert one.page.get_by_text("of this machine alone").is_visible()
    one.page.get_by_label("Controls for whoever opens it").select_option("sliders")
    one.until(lambda: "&controls=play," in field.input_value(), "with fewer controls")
    phone = field.input_value()
    scene = one.session.scene
    one.page.keyboard.press("Escape")

    other = open_page("ring", size=SMALL, path=phone.removeprefix(one.served.url))
    assert other.session.scene == scene
    assert other.tab.probe().controls == ("play", "rest_angle", "angular_stiffness")
    # What was done meanwhile is there again after a reload, and another address opens another scene.
    other.tell(commands.SetValue("gravity", 123.0))
    other.until(other.is_kept, "it is kept")
    other.until(lambda: "123" in (other.page.evaluate(KEPT) or ""), "by the page")
    other.open(phone.removeprefix(one.served.url))
    other.until(lambda: other.session.scene.gravity == (0.0, 123.0), "the reload goes on")
    other.open("/?scene=lesson-hooke")
    assert other.session.scene.name == "lesson-hooke"
    other.pause(0.5)
    assert other.session.scene.name == "lesson-hooke"
    assert not other.notices()


def test_an_address_without_a_scene_says_so_and_opens_the_gallery(open_page: OpenPage) -> None:
    desk = open_page("ring", size=SMALL, path="/?scene=lesson-hook")
    gallery = desk.page.get_by_role("dialog", name="Scenes")
    gallery.locator(".softrod-card").first.wait_for()
    gallery.get_by_text("There is no preset called 'lesson-hook'; choose one in the gallery.").wait_for()
    assert desk.session.scene.name == "ring"
