"""Links that hold a scene: made in one page, opened in another; a bad one changes nothing."""

from __future__ import annotations

import msgspec
import numpy as np

import sim
from app.session import commands
from sim.scene.link import pack_scene
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk

SMALL = (720, 460)


def shared(desk: Desk, pose: bool = False) -> str:
    """The link that the page offers."""
    desk.show("Share")
    desk.button("Share by a link").click()
    field = desk.page.get_by_label("Link to this scene")
    desk.until(lambda: "/s#1." in field.input_value(), "there is a link")
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
    other.until(lambda: other.tab._kept and other.tab._kept[0] == other.session.revision, "it is kept")
    other.rest(3)
    other.open()
    other.until(lambda: other.session.scene.gravity == (0.0, 123.0), "the reload goes on")
    # Another link in the address of the page that is there: that of the pose.
    other.tell(commands.Play(False))
    other.page.evaluate("hash => (location.hash = hash)", with_pose.partition("#")[2])
    other.until(lambda: other.session.scene.pose is not None, "the other link is opened")
    assert np.array_equal(other.simulation.positions, pose)
    assert other.page.evaluate("location.hash") == ""


def test_a_bad_link_is_one_sentence_and_changes_nothing(open_page: OpenPage) -> None:
    desk = open_page("ring", size=SMALL)
    desk.tell(commands.SetValue("gravity", 77.0))
    desk.until(lambda: desk.tab._kept and desk.tab._kept[0] == desk.session.revision, "it is kept")
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
    desk.until(lambda: desk.tab._panel._told.get("title") == evil, "the page knows its title")
    desk.rest(3)
    assert desk.page.evaluate("window.pwned") is None
    assert desk.page.locator("#root img[src=x]").count() == 0
