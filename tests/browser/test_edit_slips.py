"""What goes wrong while one edits by hand: a lost press, a body that changes under the pointer, keys meant
for something else, and a focus that has nowhere to go."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

import sim
from app.session import commands
from sim.edit.edit import Edit, Selection
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk
from tests.browser.test_edit import becomes, beside, counts, drag, paused, tool

KEY = """([key, code, more]) => document.body.dispatchEvent(
  new KeyboardEvent("keydown", { key, code, ...more, bubbles: true, cancelable: true }))"""


def mark(desk: Desk, kind: str) -> str:
    """The outline of one kind of the marks of an edit."""
    return desk.page.locator(f".softrod-edit-{kind}").get_attribute("d") or ""


def pick(desk: Desk, **parts: set[int]) -> None:
    chosen = Selection(**{kind: frozenset(some) for kind, some in parts.items()})
    desk.tell(commands.Select(lambda *_: chosen))
    shown = sum(len(some) for some in parts.values())
    desk.until(
        lambda: desk.page.locator(".softrod-edit-count").inner_text().startswith(str(shown)), "it is selected"
    )


def test_a_press_that_is_lost_leaves_nothing_behind(open_page: OpenPage) -> None:
    desk = paused(open_page)
    page = desk.page
    tool(desk, "Build")
    for lost in ("blur", "capture", "released elsewhere"):
        page.mouse.move(*desk.place(11))
        page.mouse.down()
        desk.lead(desk.place(11), beside(desk, 11, 60.0, 20.0))
        desk.until(lambda: mark(desk, "rubber"), "a line is drawn")
        if lost == "blur":
            page.evaluate("window.dispatchEvent(new Event('blur'))")
        elif lost == "capture":
            page.evaluate("window.__softrod.canvas().releasePointerCapture(1)")
            page.mouse.move(*beside(desk, 11, 62.0, 20.0))  # it is told before the next event
        else:
            # What a browser tells of a button that was let go in another window.
            page.evaluate(
                """([clientX, clientY]) => {
                  const more = { pointerId: 1, pointerType: "mouse", isPrimary: true, bubbles: true };
                  const event = new PointerEvent("pointermove", { clientX, clientY, ...more });
                  window.__softrod.canvas().dispatchEvent(event);
                }""",
                list(beside(desk, 11, 70.0, 20.0)),
            )
        desk.until(lambda: not mark(desk, "rubber"), f"the line is gone: {lost}")
        page.mouse.up()
        desk.rest(3)
        assert counts(desk) == (12, 11, 10), lost
    # The next one works.
    drag(desk, desk.place(11), beside(desk, 11, 60.0, 0.0))
    becomes(desk, 13, 12, 10)


def test_the_second_button_does_nothing_during_a_press(open_page: OpenPage) -> None:
    desk = paused(open_page)
    page = desk.page
    tool(desk, "Select")
    page.mouse.click(*desk.place(2))
    desk.until(lambda: desk.session.selection.masses == {2}, "it is selected")
    page.mouse.move(*desk.place(2))
    page.mouse.down()
    desk.lead(desk.place(2), desk.place(9))
    page.mouse.click(*desk.place(9), button="right")
    desk.rest(3)
    assert desk.session.selection.masses == {2}
    page.mouse.up()
    # Where the menu is asked for at the release, a view that was moved selects nothing.
    x, y = desk.place(9)
    page.mouse.move(x + 60.0, y)
    page.mouse.down(button="right")
    desk.lead((x + 60.0, y), (x + 90.0, y))
    page.mouse.up(button="right")
    page.evaluate(
        """([clientX, clientY]) => {
          const more = { pointerType: "mouse", bubbles: true, cancelable: true };
          const event = new PointerEvent("contextmenu", { clientX, clientY, ...more });
          window.__softrod.canvas().dispatchEvent(event);
        }""",
        list(desk.place(9)),
    )
    desk.pause(0.3)
    assert desk.session.selection.masses == {2}


def test_what_is_under_way_ends_when_parts_are_gone(open_page: OpenPage) -> None:
    """Their numbers would be those of others: the chain would lead on from another mass."""
    desk = paused(open_page)
    page = desk.page
    tool(desk, "Build")
    page.mouse.click(*desk.place(9))
    page.mouse.move(*beside(desk, 9, 60.0, 0.0))
    desk.until(lambda: mark(desk, "rubber"), "a chain begins")
    page.mouse.move(*desk.place(0))
    page.keyboard.press("Delete")
    becomes(desk, 11, 10, 9)
    page.mouse.click(*beside(desk, 5, 60.0, 0.0))
    becomes(desk, 12, 10, 9)  # a mass by itself
    # And with a tool that moves: nothing is complained about.
    page.keyboard.press("s")
    page.mouse.move(*desk.place(3))
    page.mouse.down()
    desk.lead(desk.place(3), beside(desk, 3, 50.0, 0.0))
    page.keyboard.press("Delete")
    becomes(desk, 11, 8, 6)
    page.mouse.up()
    desk.rest(3)
    assert not desk.notices()
    assert page.get_by_role("dialog").count() == 0


def test_a_corner_that_shows_goes_with_an_undo(open_page: OpenPage) -> None:
    desk = paused(open_page)
    tool(desk, "Joint")
    desk.tell(commands.Change(lambda moment, _: _shorter(moment)))
    becomes(desk, 11, 10, 9)
    desk.page.mouse.move(*desk.place(4))
    desk.page.mouse.click(*desk.place(4))
    desk.until(lambda: mark(desk, "corner") or mark(desk, "corner-hover"), "its corners show")
    desk.page.keyboard.press("Control+z")
    becomes(desk, 12, 11, 10)
    desk.until(lambda: not mark(desk, "corner") and not mark(desk, "corner-hover"), "they are gone")


def _shorter(moment: object) -> Edit:
    from sim.edit.build import remove

    return remove(moment.scene, Selection(masses=frozenset({0})))  # type: ignore[attr-defined]


def test_a_click_on_one_of_several_leaves_it_alone_selected(open_page: OpenPage) -> None:
    desk = paused(open_page)
    tool(desk, "Select")
    pick(desk, masses={2, 3, 4})
    desk.page.mouse.click(*desk.place(3))
    desk.until(lambda: desk.session.selection.masses == {3}, "it is alone")
    # A screen reader hears which.
    desk.until(
        lambda: desk.page.locator(".softrod-tell").filter(has_text="mass 3").count() == 1, "it is told"
    )
    desk.page.mouse.click(*desk.place(6))
    desk.until(lambda: desk.page.locator(".softrod-tell").filter(has_text="mass 6").count() == 1, "and again")


def test_marks_go_with_the_pointer(open_page: OpenPage) -> None:
    desk = paused(open_page)
    tool(desk, "Build")
    desk.page.mouse.move(*beside(desk, 5, 40.0, 0.0))
    desk.until(lambda: mark(desk, "under"), "the place is marked")
    desk.page.evaluate(
        "window.__softrod.canvas().dispatchEvent(new PointerEvent('pointerout', {bubbles: true}))"
    )
    desk.until(lambda: not mark(desk, "under"), "the mark is gone")


def test_keys_are_as_they_are_written(open_page: OpenPage) -> None:
    """On a German keyboard, Z is where others have Y."""
    desk = paused(open_page)
    tool(desk, "Build")
    desk.page.mouse.click(*beside(desk, 5, 60.0, 0.0))
    becomes(desk, 13, 11, 10)
    desk.page.evaluate(KEY, ["z", "KeyY", {"ctrlKey": True}])
    becomes(desk, 12, 11, 10)
    desk.page.evaluate(KEY, ["y", "KeyZ", {"ctrlKey": True}])
    becomes(desk, 13, 11, 10)
    # Where the letters are no Latin ones, their places count.
    desk.page.evaluate(KEY, ["я", "KeyZ", {"ctrlKey": True}])
    becomes(desk, 12, 11, 10)


def test_keys_that_are_meant_for_something_else(open_page: OpenPage) -> None:
    desk = paused(open_page)
    page = desk.page
    tool(desk, "Select")
    pick(desk, masses={2})
    # Keys of the browser with Ctrl and Shift are let through.
    for key, code in (("D", "KeyD"), ("A", "KeyA"), ("C", "KeyC")):
        let = page.evaluate(KEY, [key, code, {"ctrlKey": True, "shiftKey": True}])
        assert let, key
    # A key that is held deletes once.
    page.mouse.move(*desk.place(7))
    page.keyboard.down("Delete")
    page.keyboard.down("Delete")
    page.keyboard.up("Delete")
    desk.until(lambda: counts(desk)[0] < 12, "it is deleted")
    desk.rest(3)
    assert counts(desk)[0] == 11
    # Marked text is what Ctrl C copies.
    pick(desk, masses={3})
    page.evaluate("localStorage.removeItem('softrod-clipboard')")
    page.evaluate("getSelection().selectAllChildren(document.querySelector('.softrod-clock'))")
    page.keyboard.press("Control+c")
    desk.pause(0.4)
    assert page.evaluate("localStorage.getItem('softrod-clipboard')") is None
    page.evaluate("getSelection().removeAllRanges()")
    # An instrument with the focus is what Delete takes away.
    page.locator(".softrod-box-lid").click()
    page.locator(".softrod-box-tools").get_by_role("button", name="Ruler").click()
    grip = page.locator(".softrod-grip").first
    grip.focus()
    page.keyboard.press("Delete")
    desk.until(lambda: page.locator(".softrod-grip").count() == 0, "the ruler is put away")
    assert counts(desk)[0] == 11


def test_the_focus_has_somewhere_to_go(open_page: OpenPage) -> None:
    desk = paused(open_page)
    page = desk.page
    focused = "document.activeElement?.ariaLabel ?? ''"
    tool(desk, "Build")
    page.locator(".softrod-edit-bar").get_by_role("button", name="Done").press("Enter")
    desk.until(lambda: page.evaluate(focused) == "Edit", "the pencil has it, since the bar is gone")
    page.keyboard.press("e")
    pick(desk, masses={2})
    page.locator(".softrod-edit-bar").get_by_role("button", name="Delete").press("Enter")
    becomes(desk, 11, 9, 7)
    desk.until(lambda: page.evaluate(focused) == "Edit", "and since the button is gone")
    # A dialog gives it back to the body, at the mass that was chosen.
    page.locator(".softrod-body").focus()
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    live = page.locator(".softrod-live")
    desk.until(lambda: "mass 3 of" in live.inner_text(), "a mass is chosen")
    before = desk.simulation.positions
    page.keyboard.press("Alt+ArrowRight")
    page.get_by_role("button", name="Keep the rest lengths").press("Enter")
    desk.until(lambda: not np.array_equal(desk.simulation.positions, before), "it is moved")
    desk.until(lambda: "mass 3 of" in live.inner_text(), "it is still chosen")
    before = desk.simulation.positions
    page.keyboard.press("Alt+ArrowRight")
    desk.until(lambda: not np.array_equal(desk.simulation.positions, before), "it is moved again")
    assert np.flatnonzero((desk.simulation.positions != before).any(1)).tolist() == [3]
    # The last mass goes, and the one before it is chosen.
    for _ in range(4):
        page.keyboard.press("ArrowLeft")
    desk.until(lambda: "mass 10 of" in live.inner_text(), "the last one is chosen")
    page.keyboard.press("Delete")
    becomes(desk, 10, 8, 6)
    desk.until(lambda: "mass 9 of 0 to 9" in live.inner_text(), "another one is chosen")
    page.keyboard.press("Delete")
    becomes(desk, 9, 7, 5)
    assert not desk.notices()


def test_a_phone_has_room_for_the_body_beside_the_tools(open_page: OpenPage, tmp_path: Path) -> None:
    desk = open_page("box", size=(390, 844), phone=True)
    desk.tell(commands.Play(False), commands.Reset())
    tool(desk, "Select")
    seen = lambda: all(desk.uncovered((x, y)) for x, y in desk.at(desk.simulation.positions))  # noqa: E731
    desk.until(seen, "nothing lies over the masses")
    desk.page.keyboard.press("Control+a")
    # Nor over the scale bar, whether or not the page says that it is paused.
    scale, strip = desk.page.locator(".softrod-scale"), desk.page.locator(".softrod-edit")
    low = "e => e.getBoundingClientRect().bottom"
    for on in (True, False):
        desk.tell(commands.Play(on))
        desk.until(
            lambda: strip.evaluate("e => e.getBoundingClientRect().top") > scale.evaluate(low),
            "the strip is below the scale bar",
        )
    count = desk.page.locator(".softrod-edit-count")
    desk.until(lambda: count.inner_text() == "24 parts", "the bar has a short word for all of it")
    assert seen()
    # What is to be done with a picture comes into view.
    Image.new("RGB", (40, 20)).save(tmp_path / "bridge.png")
    desk.page.locator(".softrod-edit-bar input[type=file]").set_input_files(tmp_path / "bridge.png")
    size = desk.page.get_by_text("Size", exact=True)
    desk.until(lambda: 0.0 < (size.bounding_box() or {}).get("x", 0.0) < 150.0, "its controls are there")


def test_a_question_about_a_body_that_is_gone_goes_too(open_page: OpenPage) -> None:
    desk = paused(open_page)
    tool(desk, "Select")
    pick(desk, masses={2})
    desk.page.keyboard.press("Alt+ArrowRight")
    dialog = desk.page.get_by_role("dialog", name="Moved masses")
    dialog.wait_for()
    desk.tell(commands.Open(sim.load_scene("ring")))
    desk.until(lambda: dialog.count() == 0, "the question is gone")
    desk.until(lambda: len(desk.masses()) == len(desk.session.scene.masses), "the page shows the ring")
    assert not desk.session.versions.redoable
    assert not desk.notices()


def test_moving_a_picture_takes_no_keys_of_others(open_page: OpenPage, tmp_path: Path) -> None:
    desk = paused(open_page, size=(1100, 760))
    page = desk.page
    Image.new("RGB", (40, 20)).save(tmp_path / "bridge.png")
    page.keyboard.press("e")
    page.locator(".softrod-edit-bar input[type=file]").set_input_files(tmp_path / "bridge.png")
    button = page.get_by_role("button", name="Move it")
    button.click()
    image = page.locator(".softrod-underlay image")
    x = image.get_attribute("x")
    desk.gallery()
    page.keyboard.press("ArrowDown")
    page.keyboard.press("ArrowRight")
    desk.rest(3)
    assert image.get_attribute("x") == x
    page.keyboard.press("Escape")
    desk.until(lambda: page.get_by_role("dialog").count() == 0, "the gallery is closed")
    assert button.get_attribute("aria-pressed") == "true"
    # It is stored when it rests, and not at every move.
    page.evaluate(
        """() => {
          const real = Storage.prototype.setItem;
          window.stored = 0;
          Storage.prototype.setItem = function (name, text) {
            if (name === "softrod-picture") window.stored += 1;
            real.call(this, name, text);
          };
        }"""
    )
    drag(desk, desk.place(5), beside(desk, 5, 40.0, 30.0))
    desk.until(lambda: page.evaluate("window.stored") > 0, "it is stored")
    assert page.evaluate("window.stored") < 4
    playing = desk.session.playing
    page.keyboard.press("Escape")
    desk.until(lambda: button.get_attribute("aria-pressed") == "false", "Esc ends it")
    assert desk.session.playing == playing


def test_the_tools_stay_where_they_are_when_the_clock_runs(open_page: OpenPage) -> None:
    desk = open_page(size=(1100, 760))
    desk.tell(commands.Play(False))
    tool(desk, "Build")
    desk.until(lambda: "paused" in desk.hud(), "the page says that it is paused")
    cut = desk.page.locator(".softrod-edit").get_by_role("button", name="Cut")
    desk.rest(3)
    before = cut.bounding_box()
    desk.tell(commands.Play(True))
    desk.until(lambda: "paused" not in desk.hud(), "it runs")
    desk.rest(10)
    assert cut.bounding_box() == before


def test_a_screen_reader_hears_what_was_undone(open_page: OpenPage) -> None:
    desk = paused(open_page)
    live = desk.page.locator(".softrod-tell")
    heard = lambda text: live.get_by_text(text, exact=True).count() == 1  # noqa: E731
    tool(desk, "Build")
    desk.page.mouse.click(*beside(desk, 5, 60.0, 0.0))
    desk.until(lambda: heard("mass added"), "it hears what was done")
    desk.page.keyboard.press("p")
    desk.until(lambda: heard("1 mass pinned"), "and what was done next")
    desk.page.keyboard.press("Control+z")
    desk.until(lambda: heard("Undone: 1 mass pinned"), "and that this was undone")
    desk.page.keyboard.press("Control+y")
    desk.until(lambda: heard("1 mass pinned"), "and that it is done again")
