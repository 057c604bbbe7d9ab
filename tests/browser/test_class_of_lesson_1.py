"""A class of lesson 1 from the command to the zip: a teacher, a wall, two phones and a laptop; by night."""

from __future__ import annotations

import csv
import io
import os
import re
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.amount import NIGHT
from tests.browser.classrooms import HEIGHTS, LETTERS
from tests.browser.driver import LIMIT, rough_context, until

pytestmark = pytest.mark.skipif(not NIGHT, reason="takes a minute: by day its parts are tested")
expect.set_options(timeout=LIMIT * 1e3)

PHONE, LYING, LAPTOP, DESK, WALL = (390, 844), (844, 390), (1280, 720), (1280, 720), (1920, 1080)


@dataclass
class Lesson:
    """A running class, and its pages.

    Attributes:
        base: the server's address; code: of the class.
        desk, wall: the teacher's page, and the projector's.
        pupils: two phones and a laptop.
        errors: of all scripts.
    """

    base: str
    code: str
    desk: Page
    wall: Page
    pupils: list[Page]
    errors: list[str] = field(default_factory=list)

    def next(self, expected: str) -> None:
        """Press Next, which is to lead there."""
        button = self.desk.locator("[data-focus=next]")
        expect(button).to_have_text(f"Next: {expected}")
        button.click()
        expect(self.desk.locator(".softrod-desk-about b")).to_have_text(expected)


@pytest.fixture
def lesson(browser: Browser, tmp_path: Path) -> Iterator[Lesson]:
    words = [sys.executable, "-u", "-m", "app", "class", "--host", "127.0.0.1", "--port", "0", "--no-open"]
    errors: list[str] = []
    with ExitStack() as stack:
        server = stack.enter_context(
            subprocess.Popen(
                words, stdout=subprocess.PIPE, text=True, env={**os.environ, "XDG_DATA_HOME": str(tmp_path)}
            )
        )
        stack.callback(server.terminate)
        assert server.stdout is not None
        said = ""
        while "your phone" not in said:
            line = server.stdout.readline()
            assert line, said
            said += line
        found = re.search(r"(http://[^/]+/)\?room=([A-Z]{4})&as=desk#teacher=\S+", said)
        assert found is not None
        base, code = found[1], found[2]

        def opened(address: str, size: tuple[int, int], touch: bool = False) -> Page:
            context = rough_context(
                browser,
                viewport={"width": size[0], "height": size[1]},
                has_touch=touch,
                reduced_motion="reduce",
            )
            stack.callback(context.close)
            page = context.new_page()
            page.set_default_timeout(LIMIT * 1e3)
            page.on("pageerror", lambda error: errors.append(str(error)))
            page.goto(address)
            return page

        seat = f"{base}?room={code}"
        desk = opened(found[0], DESK)
        pupils = [opened(seat, PHONE, True), opened(seat, LYING, True), opened(seat, LAPTOP)]
        yield Lesson(base, code, desk, opened(f"{seat}&as=wall", WALL), pupils, errors)
        assert not errors


def test_a_class_of_lesson_1(lesson: Lesson) -> None:
    desk, wall, pupils = lesson.desk, lesson.wall, lesson.pupils
    expect(wall.locator(".softrod-wall-count")).to_have_text("3 are here")
    assert desk.locator("[data-focus=lesson]").input_value() == "lesson-hooke"
    lesson.next("Look at me")
    lesson.next("Ask")
    # Each predicts by the steps below the body, 5 px a press; and votes.
    for pupil, presses, choice in zip(pupils, (10, 20, 40), (0, 1, 2), strict=True):
        for _ in range(presses):
            pupil.locator("[data-focus='step down']").click()
        pupil.locator("[data-focus=predict]").click()
        pupil.get_by_role("button", name=("71 px", "100 px", "200 px")[choice], exact=True).click()
    expect(wall.locator(".softrod-wall-count")).to_have_text("3 of 3 have answered")
    assert wall.locator(".softrod-predictions path").count() == 0
    lesson.next("Show answers")
    expect(wall.locator(".softrod-predictions path")).to_have_count(3)
    lesson.next("Run it")
    expect(desk.locator(".softrod-desk-guide")).to_contain_text("stops at 4 s")
    until(desk, lambda: "Again, slowly" in desk.locator(".softrod-desk").inner_text(), "the run stands")
    lesson.next("Reveal")
    expect(wall.locator(".softrod-wall-number")).to_have_text("100 px")
    expect(wall.locator(".softrod-reveal-far")).to_have_text("100 px lower")
    expect(wall.locator(".softrod-reveal circle")).to_have_count(3)
    # They were put 50, 100 and 200 px lower.
    one, two, three = sorted(wall.locator(".softrod-reveal circle").evaluate_all(HEIGHTS))
    assert three - two == pytest.approx(2.0 * (two - one), rel=0.02)
    expect(wall.locator(".softrod-reveal-right")).to_have_count(1)
    for pupil in pupils:
        expect(pupil.locator(".softrod-verdict")).to_contain_text("The right answer: 100 px")
    lesson.next("Explain in a line")
    for pupil in pupils:
        pupil.get_by_label("Because").fill("twice the pull")
        pupil.keyboard.press("Enter")
    expect(wall.locator(".softrod-wall-count")).to_have_text("3 of 3 have written a line")
    lesson.next("Let them try")
    lesson.next("Collect")
    # Each finds the stretch at another gravity; it is in proportion, x = m g / k with k = 20 kg/s^2.
    for pupil, presses in zip(pupils, (0, 40, 120), strict=True):
        slider = pupil.get_by_label("Gravity")
        slider.focus()
        for _ in range(presses):
            pupil.keyboard.press("ArrowRight")
    desk.wait_for_timeout(8000)
    for pupil in pupils:
        pupil.locator("[data-focus=handin]").click()
        expect(pupil.locator(".softrod-handed")).to_contain_text("Handed in")
        expect(pupil.locator(".softrod-plot-own")).to_have_count(1)
    expect(wall.locator(".softrod-class-plot circle")).to_have_count(3)
    assert wall.locator(".softrod-class-plot").evaluate(LETTERS) >= 1 / 36
    desk.get_by_role("button", name="Show the law").click()
    expect(wall.locator(".softrod-wall-side")).to_contain_text("stretch of spring 0 = 0.05 × Gravity")
    desk.get_by_label("More", exact=True).click()
    with desk.expect_download() as download:
        desk.get_by_role("button", name="Save all as a zip").click()
    with zipfile.ZipFile(download.value.path()) as file:
        answers = list(csv.reader(io.StringIO(file.read("answers.csv").decode("utf-8-sig"))))
    assert sum("vote" in row for row in answers) == 3
    assert sum("handed in" in row for row in answers) == 3
    desk.once("dialog", lambda dialog: dialog.accept())
    desk.get_by_role("button", name="End", exact=True).click()
    for pupil in pupils:
        expect(pupil.locator(".softrod-seat h1")).to_have_text("The class is over.")
