"""Lessons: a question first, then the body is tried, and then the answer is told; each one to its end."""

from __future__ import annotations

import numpy as np

import sim
from app.lessons import quantity_text
from app.session import commands
from app.session.notices import Notice
from app.session.plots import PlotSpec, parse_plot
from sim.scene.lesson import Step
from sim.settings import CHOICES, setting_of
from sim.store.files import built_in_folder
from tests.amount import part_of
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk

NAMES = sorted(path.stem for path in (built_in_folder() / "lessons").glob("*.json"))
CARD = ".softrod-lesson"


def steps(name: str) -> tuple[Step, ...]:
    lesson = sim.load_scene(name).lesson
    assert lesson is not None
    return lesson.steps


def words(desk: Desk) -> str:
    """What the card says; numbers and their units are joined by a space that does not break."""
    return desk.page.locator(CARD).inner_text().replace("\xa0", " ")


def press(desk: Desk, text: str) -> None:
    desk.page.locator(".softrod-panel :is(.softrod-lesson, .softrod-lesson-foot) button").filter(
        has_text=text
    ).first.click()


def label_of(desk: Desk, key: str) -> str:
    """What the page calls a setting or a choice."""
    return CHOICES[key].label if key in CHOICES else setting_of(desk.session.scene, key).label


LABELS = """page => {
  const first = page.querySelector(".softrod-plot-title");
  const isBelow = (one) => Boolean(first?.compareDocumentPosition(one) & Node.DOCUMENT_POSITION_FOLLOWING);
  const shown = [...page.querySelectorAll("label")].filter((label) => label.checkVisibility());
  const texts = (below) => shown.filter((one) => isBelow(one) === below).map((one) => one.innerText);
  return [texts(false), texts(true)];
}"""


def labels(desk: Desk) -> list[list[str]]:
    """The labels of a step's sliders and lists, and those at its plots, which stand below."""
    return desk.page.locator(".softrod-lesson-page:visible").evaluate(LABELS)


def plots(desk: Desk) -> list[str]:
    """The plots in the tab that is shown."""
    return desk.page.locator(".softrod-plot-title:visible").all_inner_texts()


def begins(desk: Desk, step: Step) -> None:
    """Wait until a step is shown and its scene is there, at its start if there is a question."""
    desk.until(lambda: step.title in words(desk), f"the card shows {step.title!r}")
    if step.question is None:
        desk.until(lambda: desk.session.playing, "the body moves")
    else:
        desk.until(lambda: not desk.session.playing and desk.simulation.time == 0.0, "the body waits")
        assert step.do not in words(desk)


def test_each_lesson_is_followed_to_its_end(open_page: OpenPage) -> None:
    desk = open_page()
    assert not desk.page.locator(CARD).is_visible()
    for name in part_of(NAMES, 6):
        follow(desk, name)


TITLES = {
    "lesson-chaos": 3 * [["distance"]],
    "lesson-explosion": [*2 * [["time step, as a part of its limit"]], ["distance"]],
    "lesson-hooke": [["stretch of spring 0"], ["y of mass 1"], *2 * [["angle of joint 0"]]],
    "lesson-laws": [*2 * [["torque of joint 0 over angle of joint 0"]], ["angle of joint 0"]],
    "lesson-momentum": [
        ["velocity vx of mass 1 velocity vx of mass 9"],
        ["velocity vx of mass 3 velocity vx of mass 7 velocity vx of mass 9"],
        ["momentum in x of mass 11 momentum in x of mass 12 body[11,12].momentum_x"],
        ["velocity vx of mass 12"],
    ],
    "lesson-stick-slip": 4 * [["force of spring 0", "velocity vx of mass 1"]],
}
"""What stands over the plots of some lessons' steps: of one quantity or several, over another, of a second
body, of the solver, of masses together, and two plots at once."""


def title_of(spec: PlotSpec) -> str:
    """What stands over a plot of another lesson."""
    over = f" over {quantity_text(spec.over)}" if spec.over else ""
    return " ".join(map(quantity_text, spec.names)) + over


def follow(desk: Desk, name: str) -> None:
    """Open a lesson, and go through its steps until it starts over."""
    desk.tell(commands.Open(sim.load_scene(name)))
    for i, step in enumerate(steps(name)):
        begins(desk, step)
        assert f"{i + 1} of {len(steps(name))}" in words(desk)
        if step.question is not None:
            assert desk.page.locator(".softrod-lesson-next").is_disabled()
            press(desk, step.question.choices[step.question.answer])
            desk.until(lambda: desk.session.playing, "the body moves")
            assert step.question.because not in words(desk), "it is tried first"
            assert step.do in words(desk)
            assert step.watch in words(desk)
            press(desk, "Check my answer")
            desk.until(lambda: "That is right." in words(desk), "the answer is right")
        else:
            assert step.do in words(desk)
            assert step.watch in words(desk)
        titles = (
            TITLES[name][i] if name in TITLES else [title_of(parse_plot(text)) for text in step.plots or ()]
        )
        wanted = [
            [label_of(desk, key) for key in step.controls],
            ["Hear while it moves", "Analysis"] * len(titles),
        ]
        desk.until(lambda wanted=wanted: labels(desk) == wanted, f"its labels are {wanted}")
        desk.until(lambda titles=titles: plots(desk) == titles, f"its plots are {titles}")
        desk.until(lambda: desk.simulation.time > 0.1 or desk.session.offer_back, "it moves, or has exploded")
        press(desk, "Next step" if i + 1 < len(steps(name)) else "Back to step 1")
    begins(desk, steps(name)[0])
    assert not desk.notices()


def test_what_was_answered_is_told_and_known_after_a_reload_and_another_scene(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Open(sim.load_scene("lesson-hooke")))
    first, second = steps("lesson-hooke")[:2]
    begins(desk, first)
    press(desk, "200 px")
    desk.until(lambda: desk.session.playing, "with the answer, the clock runs")
    desk.tell(commands.Play(False))
    press(desk, "71 px")  # until it is told, one may think again
    pressed = desk.page.locator(f"{CARD} .softrod-choice[aria-pressed=true]")
    desk.until(lambda: pressed.all_inner_texts() == ["71\xa0px"], "it is the choice")
    desk.rest(2)
    assert not desk.session.playing
    press(desk, "Check my answer")
    desk.until(lambda: "The answer is: 100 px." in words(desk), "the right answer is told")
    # Again is anew: the question can be answered again.
    press(desk, "Start again")
    begins(desk, first)
    assert "The answer is" not in words(desk)
    press(desk, "71 px")
    press(desk, "Check my answer")
    press(desk, "Next step")
    begins(desk, second)
    desk.tell(commands.SetValue("gravity", 1234.0))
    desk.until(lambda: "1234" in (desk.page.evaluate("sessionStorage.softrod") or ""), "the page keeps it")
    desk.open()
    desk.until(lambda: second.title in words(desk), "the same step is shown")
    press(desk, "Back")
    desk.until(lambda: "The answer is: 100 px." in words(desk), "what was answered is still known")
    desk.until(lambda: desk.session.scene.gravity != (0.0, 1234.0), "its step has begun")
    # Opened again it goes on there, and does not wait for what is answered.
    desk.tell(commands.Open(sim.load_scene("ring")))
    desk.until(lambda: not desk.page.locator(CARD).is_visible(), "the card goes with its scene")
    desk.tell(commands.Open(sim.load_scene("lesson-hooke")))
    desk.until(lambda: "The answer is: 100 px." in words(desk), "it is at its step")
    desk.until(lambda: desk.session.playing, "and runs")


def test_an_answer_has_the_case_run_that_was_asked_about(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Open(sim.load_scene("lesson-hooke")))
    begins(desk, steps("lesson-hooke")[0])
    assert desk.session.scene.gravity == (0.0, 1000.0)
    press(desk, "71 px")
    desk.until(lambda: desk.session.scene.gravity == (0.0, 2000.0), "gravity is doubled")
    desk.until(lambda: desk.simulation.positions[1, 1] > 300.0, "it falls 80 px and more")
    desk.until(lambda: desk.box("Gravity").input_value() == "2000", "its slider says so")
    press(desk, "Start again")
    desk.until(lambda: desk.session.scene.gravity == (0.0, 1000.0), "as it was")


def test_by_keys_alone(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Open(sim.load_scene("lesson-hooke")))
    begins(desk, steps("lesson-hooke")[0])
    desk.page.locator(f"{CARD} .softrod-choice").nth(1).focus()
    desk.page.keyboard.press("Enter")
    desk.until(lambda: steps("lesson-hooke")[0].do in words(desk), "Enter answers")
    # Screen readers read on from there.
    assert desk.page.evaluate("document.activeElement.className") == "softrod-lesson-do"
    desk.page.locator(".softrod-lesson-reveal").focus()
    desk.page.keyboard.press("Enter")
    desk.until(lambda: "That is right." in words(desk), "Enter tells")
    assert desk.page.evaluate("document.activeElement.className") == "softrod-verdict"


def test_question_and_choices_are_in_sight_and_so_is_the_body(open_page: OpenPage) -> None:
    sizes = part_of(((390, 844), (844, 390), (640, 360)), 2)
    desk = open_page(size=sizes[0], phone=True)
    desk.tell(commands.Open(sim.load_scene("lesson-hooke")))
    begins(desk, steps("lesson-hooke")[0])
    for size in sizes:
        desk.page.set_viewport_size({"width": size[0], "height": size[1]})
        desk.rest(3)
        question_is_in_sight(desk, size)


def question_is_in_sight(desk: Desk, size: tuple[int, int]) -> None:
    """Look for each choice, and for the body, on a screen of a size."""
    choices = desk.page.locator(f"{CARD} .softrod-choice")
    for i in range(choices.count()):
        box = choices.nth(i).bounding_box()
        assert box is not None
        assert 0.0 <= box["y"] < box["y"] + box["height"] <= size[1], "each choice is in sight"
        x, y = box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"]
        hit = f"document.elementFromPoint({x}, {y}).className"
        assert desk.page.evaluate(hit) == "softrod-button softrod-choice", "and not covered"

    def is_free() -> bool:
        places, dock = desk.at(desk.simulation.positions), desk.page.locator(".softrod-dock").bounding_box()
        card = desk.page.locator(CARD).bounding_box()
        assert dock is not None
        assert card is not None
        beside = card["x"] if card["x"] > 100.0 else size[0]
        inside = (places > 0.0).all() and (places[:, 0] < beside).all()
        return bool(inside and (places[:, 1] < dock["y"]).all() and np.ptp(places[:, 0]) > 120.0)

    desk.until(is_free, "the body is large enough above the bar and beside the lesson")


def test_short_choices_stand_side_by_side_and_a_notice_beside_the_plots(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Open(sim.load_scene("lesson-hooke")))
    begins(desk, steps("lesson-hooke")[0])
    tops = "choices => choices.map(choice => choice.getBoundingClientRect().top)"

    def side_by_side() -> bool:
        heights = desk.page.locator(".softrod-choice").evaluate_all(tops)
        return len(heights) > 1 and len(set(heights)) == 1

    desk.until(side_by_side, "they stand side by side")
    # Long ones are cut nowhere.
    desk.tell(commands.Open(sim.load_scene("lesson-explosion")))
    begins(desk, steps("lesson-explosion")[0])
    for choice in desk.page.locator(".softrod-choice").all():
        assert choice.evaluate("it => it.scrollWidth <= it.clientWidth && it.scrollHeight <= it.clientHeight")
    desk.tab.notify(Notice("error", "Said", "Something went wrong."))
    notice = desk.page.locator(".softrod-notice")
    notice.wait_for()
    edge = float(desk.page.evaluate("document.querySelector('.softrod-lesson').getBoundingClientRect().left"))
    desk.until(
        lambda: (box := notice.bounding_box()) is not None and box["x"] + box["width"] < edge,
        "the notice is over the canvas",
    )
    desk.dismiss("Said")


def test_on_a_phone_the_scale_bar_stands_beside_the_words_and_not_over_the_body(open_page: OpenPage) -> None:
    desk = open_page("lesson-resonance", size=(390, 844), phone=True)
    begins(desk, steps("lesson-resonance")[0])
    desk.page.locator(".softrod-hud b").wait_for()
    bar, hud = desk.page.locator(".softrod-scale"), desk.page.locator(".softrod-hud")

    def beside() -> bool:
        one, other = bar.bounding_box(), hud.bounding_box()
        assert one is not None
        assert other is not None
        return one["x"] > other["x"] + other["width"] and one["y"] < other["y"] + other["height"]

    desk.until(beside, "it is beside the words")
    # And the body is below them, since there is room.
    lowest = hud.bounding_box()
    assert lowest is not None
    assert desk.at(desk.simulation.positions)[:, 1].min() > lowest["y"] + lowest["height"]
