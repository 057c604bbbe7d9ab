"""Lessons: each is followed to its end; questions come first, and the body waits for the answer."""

from __future__ import annotations

import msgspec
import pytest

import sim
from app.session import commands
from sim.lesson_settings import scene_of_step
from sim.scene.files import built_in_folder
from sim.scene.lesson import Lesson, Step
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk

NAMES = sorted(path.stem for path in (built_in_folder() / "lessons").glob("*.json"))
CARD = ".softrod-lesson"


def steps(name: str) -> tuple[Step, ...]:
    lesson = sim.load_scene(name).lesson
    assert lesson is not None
    return lesson.steps


def words(desk: Desk) -> str:
    return desk.page.locator(CARD).inner_text()


def press(desk: Desk, text: str) -> None:
    desk.page.locator(f"{CARD} button").filter(has_text=text).first.click()


def begins(desk: Desk, step: Step) -> None:
    """Wait until a step is shown and its scene is there, at its start if there is a question."""
    desk.until(lambda: step.title in words(desk), f"the card shows {step.title!r}")
    if step.question is None:
        desk.until(lambda: desk.session.playing, "the body moves")
    else:
        desk.until(lambda: not desk.session.playing and desk.simulation.time == 0.0, "the body waits")
        assert step.do not in words(desk)


@pytest.mark.parametrize("name", NAMES)
def test_a_lesson_is_followed_to_its_end(open_page: OpenPage, name: str) -> None:
    desk = open_page()
    assert not desk.page.locator(CARD).is_visible()
    desk.tell(commands.Open(sim.load_scene(name)))
    for i, step in enumerate(steps(name)):
        begins(desk, step)
        assert f"{i + 1} / {len(steps(name))}" in words(desk)
        if step.question is not None:
            assert desk.page.locator(".softrod-lesson-next").is_disabled()
            press(desk, step.question.choices[step.question.answer])
            desk.until(lambda: "That is right." in words(desk), "the answer is right")
            desk.until(lambda: desk.session.playing, "the body moves")
        assert step.do in words(desk)
        assert step.watch in words(desk)
        desk.until(lambda: desk.simulation.time > 0.1, "time goes on")
        press(desk, "Next" if i + 1 < len(steps(name)) else "From the beginning")
    begins(desk, steps(name)[0])
    assert not desk.notices()


def test_a_wrong_answer_is_told_and_the_lesson_outlives_a_reload(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Open(sim.load_scene("lesson-hooke")))
    first, second = steps("lesson-hooke")[:2]
    begins(desk, first)
    press(desk, "71 px")
    desk.until(lambda: "The answer is: 100 px." in words(desk), "the right answer is told")
    press(desk, "Next")
    begins(desk, second)
    desk.tell(commands.SetValue("gravity", 1234.0))
    desk.until(lambda: "1234" in (desk.page.evaluate("sessionStorage.softrod") or ""), "the page keeps it")
    desk.page.reload()
    desk.until(lambda: second.title in words(desk), "the same step is shown")
    press(desk, "Back")
    desk.until(lambda: "The answer is: 100 px." in words(desk), "what was answered is still known")


def test_a_lesson_that_is_opened_again_goes_on_at_its_step_with_what_that_sets(open_page: OpenPage) -> None:
    desk = open_page()
    hooke, modes = sim.load_scene("lesson-hooke"), sim.load_scene("lesson-modes")
    desk.tell(commands.Open(modes))
    first, second = steps("lesson-modes")[:2]
    begins(desk, first)
    for step in (first, second):
        assert step.question is not None
        desk.until(lambda step=step: step.title in words(desk), "the step is shown")
        press(desk, step.question.choices[0])
        if step is first:
            press(desk, "Next")
    desk.until(lambda: "Tune it" in words(desk) and desk.session.playing, "the second step runs")
    desk.tell(commands.Open(sim.load_scene("ring")))
    desk.until(lambda: not desk.page.locator(CARD).is_visible(), "the card goes with its scene")
    desk.tell(commands.Open(modes))
    desk.until(lambda: second.title in words(desk), "the second step is shown again")
    there = scene_of_step(modes, 1)
    desk.until(lambda: desk.session.scene.linear_springs == there.linear_springs, "with what it sets")
    desk.until(lambda: desk.session.playing, "and it does not wait for what is answered")
    # The step has its plots, in the tab that is shown.
    desk.until(lambda: desk.page.locator(".softrod-plot-title").count() == 3, "there are its three plots")
    desk.tell(commands.Open(hooke))
    begins(desk, steps("lesson-hooke")[0])
    desk.until(
        lambda: desk.page.locator(".softrod-plot-title").all_inner_texts() == ["mass1.y"], "another's plot"
    )


def test_a_step_has_its_arrows(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Open(sim.load_scene("lesson-laws")))
    question = steps("lesson-laws")[0].question
    assert question is not None
    press(desk, question.choices[question.answer])
    desk.page.locator(".softrod-arrow-words.softrod-torques:visible").wait_for()
    assert desk.control("Torques").is_checked()


def test_by_keys_alone_folded_and_gone_with_the_scene(open_page: OpenPage) -> None:
    desk = open_page(size=(1280, 760))
    desk.tell(commands.Open(sim.load_scene("lesson-hooke")))
    begins(desk, steps("lesson-hooke")[0])
    desk.page.locator(f"{CARD} .softrod-choice").nth(1).focus()
    desk.page.keyboard.press("Enter")
    desk.until(lambda: "That is right." in words(desk), "Enter answers")
    # Screen readers read on from what was answered.
    assert desk.page.evaluate("document.activeElement.className") == "softrod-verdict"
    card = desk.page.locator(CARD).bounding_box()
    assert card is not None
    left = desk.at(desk.simulation.positions)[:, 0].min()
    assert left > card["x"] + card["width"], "the card is beside the body"
    press(desk, "Hide")
    desk.until(lambda: steps("lesson-hooke")[0].do not in words(desk), "only the title is left")
    desk.tell(commands.Open(sim.load_scene("ring")))
    desk.until(lambda: not desk.page.locator(CARD).is_visible(), "the card goes with its scene")


def test_its_text_is_only_text(open_page: OpenPage) -> None:
    desk = open_page()
    evil = "<img src=x onerror='window.evil = 1'>\"&</div>"
    lesson = Lesson(steps=(Step(title=evil, do=evil, watch=evil),))
    desk.tell(commands.Open(msgspec.structs.replace(sim.load_scene("ring"), name="evil", lesson=lesson)))
    desk.until(lambda: words(desk).count(evil) == 3, "it is shown as it is")
    assert desk.page.evaluate("window.evil") is None


def test_on_a_phone_the_card_leaves_room_for_the_body_above_the_panel(open_page: OpenPage) -> None:
    desk = open_page(size=(390, 844), phone=True)
    desk.tell(commands.Open(sim.load_scene("lesson-hooke")))
    begins(desk, steps("lesson-hooke")[0])
    if not desk.page.get_by_role("tab", name="Play", exact=True).is_visible():
        desk.page.get_by_text("softrod", exact=True).last.tap()
    desk.page.get_by_role("tab", name="Play", exact=True).wait_for()

    def is_free() -> bool:
        box, dock = desk.page.locator(CARD).bounding_box(), desk.page.locator(".softrod-dock").bounding_box()
        assert box is not None
        assert dock is not None
        return dock["y"] < 500.0 and box["y"] > 0.35 * dock["y"] and box["y"] + box["height"] < dock["y"]

    desk.until(is_free, "the body can be seen above the card, the bar and the panel")
